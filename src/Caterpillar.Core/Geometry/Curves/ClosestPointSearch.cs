using System;
using System.Collections.Generic;
using Caterpillar.Basics;

namespace Caterpillar.Geometry;

/// <summary>
/// Nearest point of a curve: closed forms for straight parts and arcs; for Bézier pieces branch and bound on the boxes of their control points, with Newton's
/// method for the candidates.
/// </summary>
internal static class ClosestPointSearch
{
    // Below this share of a span Newton's method alone decides: boxes around a minimum would be halved forever.
    private const double SmallestPiece = 1.0 / 1024;

    public static CurvePoint Find(Curve curve, Vec3 point)
    {
        var best = new CurvePoint(curve.DomainStart, curve.Start, curve.Start.DistanceTo(point));
        foreach (var span in curve.Spans())
        {
            if (span.Bezier is not null) best = SearchBezier(span, point, best);
            else best = Better(best, span, span.Arc is { } arc ? OnArc(arc, point) : OnLine(span, point), point);
        }
        return best;
    }

    private static CurvePoint Better(CurvePoint best, CurveSpan span, double u, Vec3 point)
    {
        var at = span.Point(u);
        var distance = at.DistanceTo(point);
        return distance < best.Distance ? new CurvePoint(span.ParameterOf(u), at, distance) : best;
    }

    private static double OnLine(CurveSpan span, Vec3 point)
    {
        var d = span.End - span.Start;
        return Unit(Vec3.Dot(point - span.Start, d) / d.LengthSquared);
    }

    private static double OnArc(ArcCurve arc, Vec3 point)
    {
        var local = arc.Frame.ToLocal(point);
        var angle = Angle.Atan2(local.Y, local.X);
        // The angle in the direction of the sweep, 0 to 360 degrees.
        var turn = arc.Sweep > 0 ? angle : -angle;
        if (turn < 0) turn += 360;
        var size = Math.Abs(arc.Sweep);
        if (turn <= size) return turn / size;
        return turn - size < 360 - turn ? 1 : 0;
    }

    private static CurvePoint SearchBezier(CurveSpan whole, Vec3 point, CurvePoint best)
    {
        best = Better(Better(best, whole, 0, point), whole, 1, point);
        var open = new Stack<(BezierSpan Piece, double From, double To)>();
        open.Push((whole.Bezier!, 0, 1));
        while (open.Count > 0)
        {
            var (piece, from, to) = open.Pop();
            var hull = piece.Hull;
            if (Distance(hull, point) >= best.Distance - 1e-10) continue;
            best = Better(best, whole, Newton(whole, point, from, to), point);
            if (to - from < SmallestPiece || hull.Size.Length < 1e-9) continue;
            var (left, right) = piece.Split(0.5);
            var middle = 0.5 * (from + to);
            open.Push((right, middle, to));
            open.Push((left, from, middle));
        }
        return best;
    }

    // Zero of (C − p)·C′ near the middle of an interval, kept inside it.
    private static double Newton(CurveSpan span, Vec3 point, double from, double to)
    {
        var u = 0.5 * (from + to);
        for (var i = 0; i < 8; i++)
        {
            var offset = span.Point(u) - point;
            var (first, second) = span.Derivatives(u);
            var slope = first.LengthSquared + Vec3.Dot(offset, second);
            if (!(slope > 0)) break;
            var next = Math.Min(Math.Max(u - Vec3.Dot(offset, first) / slope, from), to);
            if (Math.Abs(next - u) < 1e-15) break;
            u = next;
        }
        return u;
    }

    private static double Distance(Bounds box, Vec3 p)
    {
        var x = Math.Max(0, Math.Max(box.Min.X - p.X, p.X - box.Max.X));
        var y = Math.Max(0, Math.Max(box.Min.Y - p.Y, p.Y - box.Max.Y));
        var z = Math.Max(0, Math.Max(box.Min.Z - p.Z, p.Z - box.Max.Z));
        return Math.Sqrt(x * x + y * y + z * z);
    }

    private static double Unit(double t) => !(t > 0) ? 0 : t > 1 ? 1 : t;
}
