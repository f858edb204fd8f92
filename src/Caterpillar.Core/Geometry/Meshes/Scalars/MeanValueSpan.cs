using System;
using System.Collections.Generic;

namespace Caterpillar.Geometry;

/// <summary>
/// The height of a surface that spans closed curves which lie over each other nowhere, by mean value coordinates in plan (Hormann and Floater, 2006): smooth,
/// it meets the curves, and spans the curves of a plane by that plane.
/// </summary>
internal sealed class MeanValueSpan
{
    private readonly double[] _x;
    private readonly double[] _y;
    private readonly double[] _z;
    private readonly int[] _next;

    /// <summary>A span of curves, of which the holes run the other way round than the outlines.</summary>
    public MeanValueSpan(IReadOnlyList<Vec3[]> curves)
    {
        var count = 0;
        foreach (var curve in curves) count += curve.Length;
        (_x, _y, _z, _next) = (new double[count], new double[count], new double[count], new int[count]);
        var at = 0;
        foreach (var curve in curves)
        {
            var first = at;
            foreach (var p in curve)
            {
                (_x[at], _y[at], _z[at], _next[at]) = (p.X, p.Y, p.Z, at + 1);
                at++;
            }
            _next[at - 1] = first;
        }
    }

    /// <summary>The height over a place, also outside of the curves; NaN if there is none.</summary>
    public double Height(double x, double y)
    {
        double sum = 0, weights = 0;
        for (var i = 0; i < _x.Length; i++)
        {
            var k = _next[i];
            double ax = _x[i] - x, ay = _y[i] - y, bx = _x[k] - x, by = _y[k] - y;
            double a = Math.Sqrt(ax * ax + ay * ay), b = Math.Sqrt(bx * bx + by * by);
            if (a < 1e-9) return _z[i];
            if (b < 1e-9) return _z[k];
            // The tangent of half the angle under which the edge is seen.
            double cross = ax * by - ay * bx, base1 = a * b + ax * bx + ay * by;
            if (base1 <= 1e-12 * a * b) return (_z[i] * b + _z[k] * a) / (a + b);
            var tangent = cross / base1;
            double u = tangent / a, v = tangent / b;
            sum += u * _z[i] + v * _z[k];
            weights += u + v;
        }
        return sum / weights;
    }

    /// <summary>How many turns the curves make about a place: 0 outside.</summary>
    public int Winding(double x, double y)
    {
        var turns = 0;
        for (var i = 0; i < _x.Length; i++)
        {
            var k = _next[i];
            if (_y[i] <= y == _y[k] <= y) continue;
            var side = (_x[k] - _x[i]) * (y - _y[i]) - (_y[k] - _y[i]) * (x - _x[i]);
            if (_y[i] <= y && side > 0) turns++;
            else if (_y[i] > y && side < 0) turns--;
        }
        return turns;
    }

    /// <summary>Square of the distance in plan to the nearest vertex, mm².</summary>
    public double SquareTo(double x, double y)
    {
        var least = double.PositiveInfinity;
        for (var i = 0; i < _x.Length; i++)
        {
            double dx = _x[i] - x, dy = _y[i] - y;
            least = Math.Min(least, dx * dx + dy * dy);
        }
        return least;
    }
}
