using System;
using Caterpillar.Basics;

namespace Caterpillar.Geometry;

/// <summary>
/// The raw offset curve of closed paths: every edge moved sideways and joined with the next one. Where neighbours overlap and are long enough they are cut at
/// their crossing at once, else the curve goes back through the vertex; the area then has winding numbers ≤ 0 exactly where it is to vanish.
/// </summary>
internal sealed class OffsetCurve
{
    // An edge that is trimmed to less than this (grid units) might be turned round by rounding.
    private const double ShortestTrimmed = 4;

    private readonly double _d;
    private readonly JoinStyle _join;
    private readonly double _miterDot;
    private readonly double _arcDot;
    private readonly double _stepSin;
    private readonly double _stepCos;
    private readonly int _arcSteps;
    private double[] _nx = new double[64];
    private double[] _ny = new double[64];
    private double[] _length = new double[64];
    private double[] _trim = new double[64];

    /// <summary>For a distance, a longest miter (in distances) and an arc tolerance in grid units.</summary>
    public OffsetCurve(double distance, JoinStyle join, double miterLimit, double arcTolerance)
    {
        _d = distance;
        _join = join;
        var size = Math.Abs(distance);
        // The miter's length is d / cos(turn / 2), and the dot product of the normals is cos(turn).
        _miterDot = 2 / (miterLimit * miterLimit) - 1;
        var overshoot = 1 + arcTolerance / size;
        _arcDot = 2 / (overshoot * overshoot) - 1;
        // At least a square of chords, at most 720.
        var degrees = 2 * Angle.ToDegrees(Math.Acos(Math.Max(0.0, 1 - arcTolerance / size)));
        degrees = Math.Min(Math.Max(degrees, 0.5), 90);
        (_stepSin, _stepCos) = Angle.SinCos(degrees);
        _arcSteps = (int)(180 / degrees) + 1;
        Reach = size * (join == JoinStyle.Miter ? Math.Max(miterLimit, 1.4143) : 1.4143) + 2;
    }

    /// <summary>How far, in grid units, the curve may be from the path.</summary>
    public double Reach { get; }

    public GridPoint[] Points { get; private set; } = new GridPoint[256];

    public int Count { get; private set; }

    /// <summary>Builds the curve of a path without equal consecutive points, into <see cref="Points"/>.</summary>
    public void Build(GridPoint[] path)
    {
        var n = path.Length;
        Count = 0;
        if (_nx.Length < n)
        {
            _nx = new double[n];
            _ny = new double[n];
            _length = new double[n];
            _trim = new double[n];
        }
        Normals(path);
        Trims(n);
        for (int i = 0, before = n - 1; i < n; before = i++) Corner(path[i], before, i);
    }

    private void Normals(GridPoint[] path)
    {
        var n = path.Length;
        for (var i = 0; i < n; i++)
        {
            var a = path[i];
            var b = path[i + 1 == n ? 0 : i + 1];
            double dx = (double)b.X - a.X, dy = (double)b.Y - a.Y;
            var length = Math.Sqrt(dx * dx + dy * dy);
            _length[i] = length;
            var inverse = length > 0 ? 1 / length : 0;
            _nx[i] = dy * inverse;
            _ny[i] = -dx * inverse;
        }
    }

    // How much a corner that turns towards the offset takes from both its edges; 0 at others, NaN where it does not fit.
    private void Trims(int n)
    {
        for (int i = 0, before = n - 1; i < n; before = i++)
        {
            var cross = _nx[before] * _ny[i] - _ny[before] * _nx[i];
            var dot = _nx[before] * _nx[i] + _ny[before] * _ny[i];
            if (cross * _d >= 0) _trim[i] = 0;
            else _trim[i] = dot > -0.99 ? Math.Abs(_d * cross) / (1 + dot) : double.NaN;
        }
        for (var i = 0; i < n; i++)
        {
            var next = i + 1 == n ? 0 : i + 1;
            var taken = (double.IsNaN(_trim[i]) ? 0 : _trim[i]) + (double.IsNaN(_trim[next]) ? 0 : _trim[next]);
            if (taken <= 0 || taken + ShortestTrimmed <= _length[i]) continue;
            if (_trim[i] > 0) _trim[i] = double.NaN;
            if (_trim[next] > 0) _trim[next] = double.NaN;
        }
    }

    private void Corner(GridPoint v, int before, int i)
    {
        if (Points.Length < Count + _arcSteps + 4)
        {
            var points = Points;
            Array.Resize(ref points, Math.Max(2 * Count, Count + _arcSteps + 4));
            Points = points;
        }
        double mx = _nx[before], my = _ny[before], nx = _nx[i], ny = _ny[i];
        var dot = mx * nx + my * ny;
        if (double.IsNaN(_trim[i]))
        {
            Put(v, mx * _d, my * _d);
            Points[Count++] = v;
            Put(v, nx * _d, ny * _d);
        }
        else if (_trim[i] > 0 || dot > 0.9999 || dot >= (_join == JoinStyle.Miter ? _miterDot : _join == JoinStyle.Round ? _arcDot : 2))
        {
            var scale = _d / (1 + dot);
            Put(v, (mx + nx) * scale, (my + ny) * scale);
        }
        else if (_join == JoinStyle.Round)
        {
            Arc(v, mx, my, nx, ny);
        }
        else
        {
            // Both edges are prolonged by d tan(turn / 4) up to the line at distance d across the bisector.
            var cosHalf = Math.Sqrt(Math.Max(0.0, (1 + dot) / 2));
            var sinHalf = Math.Sqrt(Math.Max(0.0, (1 - dot) / 2));
            var t = Math.Abs(_d) * (1 - cosHalf) / sinHalf;
            Put(v, mx * _d - my * t, my * _d + mx * t);
            Put(v, nx * _d + ny * t, ny * _d - nx * t);
        }
    }

    private void Arc(GridPoint v, double mx, double my, double nx, double ny)
    {
        var sin = _d > 0 ? _stepSin : -_stepSin;
        Put(v, mx * _d, my * _d);
        for (var k = 1; k < _arcSteps && mx * nx + my * ny < _stepCos; k++)
        {
            (mx, my) = (mx * _stepCos - my * sin, my * _stepCos + mx * sin);
            Put(v, mx * _d, my * _d);
        }
        Put(v, nx * _d, ny * _d);
    }

    private void Put(GridPoint v, double dx, double dy) => Points[Count++] = new GridPoint(Grid.Round(v.X + dx), Grid.Round(v.Y + dy));
}
