using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;

namespace Caterpillar.Tests;

/// <summary>Operations on regions, and measures of them, that only tests need.</summary>
internal static class RegionTools
{
    /// <summary>The area in exactly one of the two.</summary>
    public static Region Xor(this Region a, Region b) => a.Subtract(b).Union(b.Subtract(a));

    public static int VertexCount(this Region region) => region.Contours.Sum(c => c.Count);

    public static Region Simplified(this Region region, double tolerance) => region.Simplified(tolerance, new RegionEngine());

    /// <summary>Without parts narrower than two radii (mm).</summary>
    public static Region Opened(this Region region, double radius) => region.Offset(-radius, JoinStyle.Round).Offset(radius, JoinStyle.Round);

    /// <summary>Without gaps narrower than two radii (mm).</summary>
    public static Region Closed(this Region region, double radius) => region.Offset(radius, JoinStyle.Round).Offset(-radius, JoinStyle.Round);

    /// <summary>The parts narrower than a width (mm), with small remnants in sharp corners.</summary>
    public static Region NarrowerThan(this Region region, double width) => region.Subtract(region.Offset(-width / 2).Offset(width / 2 + 5e-5));

    /// <summary>The area covered by strokes along lines, of twice a distance (mm).</summary>
    public static Region Around(IEnumerable<Polyline> lines, double distance, JoinStyle join = JoinStyle.Round, double arcTolerance = 0.005)
    {
        var engine = new RegionEngine();
        engine.Curve.Set(distance * Grid.PerMm, join, 2, arcTolerance * Grid.PerMm);
        foreach (var line in lines)
        {
            var points = new List<GridPoint>();
            foreach (var p in Region.ToGrid(line.Points.ToArray(), nameof(lines)))
            {
                if (points.Count == 0 || p != points[points.Count - 1]) points.Add(p);
            }
            if (points.Count == 1) points.Add(new GridPoint(points[0].X + 1, points[0].Y));
            if (line.IsClosed) points.Add(points[0]);
            // There and back.
            points.AddRange(Enumerable.Reverse(points).Skip(1).Take(points.Count - 2).ToArray());
            engine.Curve.Build(points.ToArray());
            engine.Arrangement.Add(engine.Curve.Points, 0, engine.Curve.Count, 0);
        }
        return Region.Own(engine.Run(InsideRule.Positive));
    }

    public static Polyline Reversed(this Polyline line) => new(line.Points.Reverse(), line.IsClosed);
}
