using System;
using System.Collections.Generic;
using Caterpillar.Basics;

namespace Caterpillar.Geometry;

/// <summary>A point of a contour with its inward normal and the disc that touches there.</summary>
/// <param name="Point">mm.</param>
/// <param name="Normal">Unit vector to the inside.</param>
/// <param name="Edge">The edge it lies on; for a vertex, the one that begins there or, before the corner, the one that ends there.</param>
/// <param name="Along">How far along the edge, 0 to 1.</param>
/// <param name="Disc">The disc.</param>
internal readonly record struct BoundarySample(Vec3 Point, Vec3 Normal, int Edge, double Along, InnerDisc Disc)
{
    public Vec3 Center => Point + Normal * Disc.Radius;
}

/// <summary>
/// Points along contours, so close that the thickness between them is nearly straight; corners that point inward have a fan of normals.
/// </summary>
internal static class BoundarySamples
{
    private const double FanDegrees = 15;

    // mm: the longest stretch that may be even, how far from an even one its middle may be, and how near samples come to the ends of an edge.
    private const double Longest = 1;
    private const double Straightness = 0.004;
    private const double Ends = 0.005;

    // Cosine of the angle between contacts on sides that open by less than 15°.
    private const double Parallel = -0.966;

    // Below this turn (cosine) a vertex is a point of a smooth curve.
    private const double SmoothDot = 0.996;

    /// <summary>Samples a contour once around.</summary>
    /// <param name="grid">The edges.</param>
    /// <param name="contour">Number of the contour.</param>
    /// <param name="step">Distance of neighbors where the thickness is not even, mm.</param>
    /// <param name="limit">Discs of this radius and above are infinite, mm.</param>
    /// <param name="wanted">Edges that need discs; the ends of the others have infinite ones. Null for all.</param>
    /// <param name="samples">Filled with the samples.</param>
    public static void Take(SegmentGrid grid, int contour, double step, double limit, bool[]? wanted, List<BoundarySample> samples)
    {
        samples.Clear();
        var probe = new ThicknessProbe(grid);
        for (var edge = grid.ContourStart[contour]; edge < grid.ContourStart[contour + 1]; edge++)
        {
            var probed = wanted is null || wanted[edge];
            Vec3 a = grid.Points[edge], d = grid.Points[grid.Next[edge]] - a, n = grid.Normal[edge];
            var before = grid.Previous[edge];
            Corner(grid, probe, before, edge, limit, probed || wanted![before], samples);
            if (!probed) continue;
            if (grid.Length[edge] <= 0.25 * step) continue;
            // Where the thickness is straight from third to third of a stretch, the stretch has no more samples.
            var stretches = Math.Max(1, (int)Math.Ceiling(grid.Length[edge] / Longest));
            // A smooth vertex has its sample already; one on the edge as near would turn over when it is moved.
            var from = Sample(grid, probe, edge, Ends / grid.Length[edge], limit);
            if (!Smooth(grid, before, edge)) samples.Add(from);
            for (var k = 0; k < stretches; k++)
            {
                var to = Sample(grid, probe, edge, Math.Min((k + 1.0) / stretches, 1 - Ends / grid.Length[edge]), limit);
                Between(grid, probe, from, to, step, limit, samples);
                if (k + 1 < stretches || !Smooth(grid, edge, grid.Next[edge])) samples.Add(to);
                from = to;
            }
        }
    }

    private static bool Smooth(SegmentGrid grid, int before, int edge) => Vec3.Dot(grid.Normal[before], grid.Normal[edge]) > SmoothDot;

    private static BoundarySample Sample(SegmentGrid grid, ThicknessProbe probe, int edge, double along, double limit)
    {
        var p = grid.Points[edge] + (grid.Points[grid.Next[edge]] - grid.Points[edge]) * along;
        return new BoundarySample(p, grid.Normal[edge], edge, along, probe.At(p, grid.Normal[edge], edge, edge, limit));
    }

    private static void Between(
        SegmentGrid grid, ThicknessProbe probe, in BoundarySample from, in BoundarySample to, double step, double limit, List<BoundarySample> samples)
    {
        if ((to.Along - from.Along) * grid.Length[from.Edge] <= step) return;
        var middle = Sample(grid, probe, from.Edge, (from.Along + to.Along) / 2, limit);
        var straight = Even(from.Disc, middle.Disc, to.Disc);
        if (!straight) Between(grid, probe, from, middle, step, limit, samples);
        samples.Add(middle);
        if (!straight) Between(grid, probe, middle, to, step, limit, samples);
    }

    private static bool Even(in InnerDisc a, in InnerDisc b, in InnerDisc c)
    {
        if (double.IsInfinity(a.Radius) || double.IsInfinity(b.Radius) || double.IsInfinity(c.Radius))
            return double.IsInfinity(a.Radius) && double.IsInfinity(b.Radius) && double.IsInfinity(c.Radius);
        return Math.Max(a.Opposite, Math.Max(b.Opposite, c.Opposite)) < Parallel && Math.Abs(a.Radius + c.Radius - 2 * b.Radius) < Straightness;
    }

    private static void Corner(SegmentGrid grid, ThicknessProbe probe, int before, int edge, double limit, bool probed, List<BoundarySample> samples)
    {
        Vec3 v = grid.Points[edge], m = grid.Normal[before], n = grid.Normal[edge];
        var dot = m.X * n.X + m.Y * n.Y;
        var cross = m.X * n.Y - m.Y * n.X;
        var wide = new InnerDisc(double.PositiveInfinity, v, edge, 0, 1);
        if (dot > SmoothDot)
        {
            var middle = m + n;
            middle /= middle.LengthXY;
            samples.Add(new BoundarySample(v, middle, edge, 0, probed ? probe.At(v, middle, edge, before, limit) : wide));
        }
        else if (cross > 0)
        {
            // A corner of the outline: no disc fits into it.
            var none = probed ? new InnerDisc(0, v, edge, 0, 1) : wide;
            samples.Add(new BoundarySample(v, m, before, 1, none));
            samples.Add(new BoundarySample(v, n, edge, 0, none));
        }
        else
        {
            var turn = Angle.Atan2(cross, dot);
            var parts = probed ? Math.Max(1, (int)Math.Ceiling(-turn / FanDegrees)) : 1;
            for (var k = 0; k <= parts; k++)
            {
                var (sin, cos) = Angle.SinCos(turn * k / parts);
                var normal = new Vec3(m.X * cos - m.Y * sin, m.X * sin + m.Y * cos);
                var (at, along) = k == 0 ? (before, 1.0) : (edge, 0.0);
                samples.Add(new BoundarySample(v, normal, at, along, probed ? probe.At(v, normal, edge, before, limit) : wide));
            }
        }
    }
}
