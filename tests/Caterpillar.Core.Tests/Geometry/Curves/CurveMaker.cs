using System;
using System.Collections.Generic;
using Caterpillar.Basics;
using Caterpillar.Geometry;

namespace Caterpillar.Tests.Geometry.Curves;

/// <summary>Random curves from a seed, and slow independent evaluations of them.</summary>
internal static class CurveMaker
{
    public static double Next(Random random, double low, double high) => low + (high - low) * random.NextDouble();

    public static Vec3 Point(Random random, double size = 20) => new(Next(random, 0, size), Next(random, 0, size), Next(random, 0, size / 2));

    public static NurbsCurve Nurbs(Random random)
    {
        var degree = random.Next(1, 6);
        var count = degree + 1 + random.Next(0, 6);
        var points = new Vec3[count];
        for (var i = 0; i < count; i++) points[i] = Point(random);
        double[]? weights = null;
        if (random.Next(2) == 0)
        {
            weights = new double[count];
            for (var i = 0; i < count; i++) weights[i] = Next(random, 0.3, 3);
        }
        if (random.Next(4) == 0) return NurbsCurve.Periodic(degree, points.Length >= 3 ? points : [.. points, Point(random), Point(random)], null);
        var knots = new double[count + degree + 1];
        for (var i = 0; i <= degree; i++) knots[count + i] = 1;
        for (var i = degree + 1; i < count; i++) knots[i] = random.Next(5) == 0
            && knots[i - degree] < knots[i - 1] ? knots[i - 1] : knots[i - 1] + Next(random, 0.02, 1);
        for (var i = 0; i <= degree; i++) knots[count + i] = knots[count - 1] + 0.4;
        return new NurbsCurve(degree, points, knots, weights);
    }

    /// <summary>A line, an arc, a line, a NURBS curve and a line, joined without kinks but one.</summary>
    public static PolyCurve LineArcLineNurbsLine()
    {
        var quarter = new ArcCurve(Frame.FromAxes(new Vec3(10, 5), -Vec3.UnitY, Vec3.UnitX), 5, 90);
        var nurbs = NurbsCurve.Clamped(3, [new(15, 15), new(15, 19), new(20, 24, 2), new(26, 20, 4), new(30, 20, 4)]);
        return new PolyCurve(
            [new PolylineCurve([new Vec3(0, 0), new Vec3(10, 0)]), quarter, new PolylineCurve([new Vec3(15, 5), new Vec3(15, 15)]), nurbs,
                new PolylineCurve([new Vec3(30, 20, 4), new Vec3(30, 0, 4)])]);
    }

    /// <summary>The definition by Cox and de Boor, with nothing reused.</summary>
    public static Vec3 ByDefinition(NurbsCurve curve, double t)
    {
        var knots = new List<double>(curve.Knots);
        var sum = Vec3.Zero;
        var weight = 0.0;
        for (var i = 0; i < curve.ControlPoints.Count; i++)
        {
            var b = Basis(knots, i, curve.Degree, t, curve.DomainEnd) * curve.Weights[i];
            sum += curve.ControlPoints[i] * b;
            weight += b;
        }
        return sum / weight;
    }

    /// <summary>Length of a part of a span by Simpson's rule on chords of many points, extrapolated.</summary>
    public static double LengthByChords(CurveSpan span, double from, double to, int parts)
    {
        double Chords(int n)
        {
            var sum = 0.0;
            var last = span.Point(from);
            for (var i = 1; i <= n; i++)
            {
                var next = span.Point(from + (to - from) * i / n);
                sum += last.DistanceTo(next);
                last = next;
            }
            return sum;
        }
        var fine = Chords(2 * parts);
        return fine + (fine - Chords(parts)) / 3;
    }

    /// <summary>The point at half the length.</summary>
    public static Vec3 Middle(Curve curve)
    {
        var length = new ArcLength(curve.Spans());
        var (leaf, u) = length.Locate(length.Total / 2);
        return length.Spans[length.LeafAt(leaf).Span].Point(u);
    }

    /// <summary>Points where the direction jumps by more than an angle in degrees.</summary>
    public static IReadOnlyList<Vec3> Kinks(Curve curve, double degrees = 0.5)
    {
        var spans = curve.Spans();
        var kinks = new List<Vec3>();
        for (var i = curve.IsClosed ? 0 : 1; i < spans.Count; i++)
        {
            var before = spans[i == 0 ? spans.Count - 1 : i - 1];
            if (CurveSpan.TurnDegrees(before.EndTangent, spans[i].StartTangent) > degrees) kinks.Add(spans[i].Start);
        }
        return kinks;
    }

    private static double Basis(List<double> knots, int i, int p, double t, double end)
    {
        if (p == 0) return (knots[i] <= t && t < knots[i + 1]) || (t == end && knots[i] < t && knots[i + 1] == t) ? 1 : 0;
        var left = knots[i + p] - knots[i];
        var right = knots[i + p + 1] - knots[i + 1];
        return (left > 0 ? (t - knots[i]) / left * Basis(knots, i, p - 1, t, end) : 0)
            + (right > 0 ? (knots[i + p + 1] - t) / right * Basis(knots, i + 1, p - 1, t, end) : 0);
    }
}
