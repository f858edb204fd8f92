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

/// <summary>Points along contours, close enough that the thickness between them is nearly straight; corners that point inwards have a fan of normals.</summary>
internal static class BoundarySamples
{
    private const double FanDegrees = 15;

    // Below this turn (cosine) a vertex is a point of a smooth curve.
    private const double SmoothDot = 0.996;

    /// <summary>Samples a contour once around.</summary>
    /// <param name="grid">The edges.</param>
    /// <param name="contour">Number of the contour.</param>
    /// <param name="step">Longest distance of neighbors, mm.</param>
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
            var parts = Math.Max(2, (int)Math.Ceiling(grid.Length[edge] / step));
            // An edge shorter than a quarter of a step has enough with its ends.
            for (var k = 1; k < parts && grid.Length[edge] > 0.25 * step; k++)
            {
                var along = (double)k / parts;
                var p = a + d * along;
                samples.Add(new BoundarySample(p, n, edge, along, probe.At(p, n, edge, edge, limit)));
            }
        }
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
