using System;

namespace Caterpillar.Geometry;

public sealed partial class Region
{
    /// <summary>
    /// All places within a distance of the region, or, for a negative distance, all places of the region that are farther than it from the boundary. Corners that
    /// turn away from the offset get a join; the others are exact. Raw offset curve, then union by positive winding numbers
    /// (Chen and McMains, "Polygon offsetting by computing winding numbers", 2005).
    /// </summary>
    /// <param name="distance">mm; positive grows, negative shrinks.</param>
    /// <param name="join">The join at corners.</param>
    /// <param name="miterLimit">Longest miter, in distances; at least 1. Longer ones are cut square.</param>
    /// <param name="arcTolerance">How far, in mm, the chords of round joins may stay inside the arc; positive.</param>
    /// <exception cref="ArgumentException">A parameter is not a number or out of its range, or the result would leave the grid.</exception>
    public Region Offset(double distance, JoinStyle join = JoinStyle.Miter, double miterLimit = 2, double arcTolerance = 0.005)
        => Offset(distance, join, miterLimit, arcTolerance, new RegionEngine());

    /// <summary>Shrunk and grown again with round joins: without what is narrower than two radii (mm).</summary>
    /// <exception cref="ArgumentException">The radius is negative, not a number or too large.</exception>
    public Region Opened(double radius, double arcTolerance = 0.005) => ThereAndBack(radius, -1, arcTolerance);

    /// <summary>Grown and shrunk again with round joins: without gaps narrower than two radii (mm).</summary>
    /// <exception cref="ArgumentException">The radius is negative, not a number or too large.</exception>
    public Region Closed(double radius, double arcTolerance = 0.005) => ThereAndBack(radius, 1, arcTolerance);

    internal Region Offset(double distance, JoinStyle join, double miterLimit, double arcTolerance, RegionEngine engine)
    {
        if (double.IsNaN(distance) || double.IsInfinity(distance)) throw new ArgumentException("The distance must be a number.", nameof(distance));
        if (!(miterLimit >= 1) || double.IsInfinity(miterLimit)) throw new ArgumentException("The miter limit must be at least 1.", nameof(miterLimit));
        if (!(arcTolerance > 0)) throw new ArgumentException("The arc tolerance must be positive.", nameof(arcTolerance));
        if (join is not (JoinStyle.Miter or JoinStyle.Round or JoinStyle.Square)) throw new ArgumentOutOfRangeException(nameof(join), join, "Unknown join.");
        var d = distance * Grid.PerMm;
        if (IsEmpty || Math.Abs(d) < 0.5) return this;
        var curve = new OffsetCurve(d, join, miterLimit, arcTolerance * Grid.PerMm);
        engine.Clear();
        foreach (var path in _paths)
        {
            var box = GridBox.Of(path);
            var narrow = Math.Min((double)box.MaxX - box.MinX, (double)box.MaxY - box.MinY) <= 2 * Math.Abs(d);
            // An outline narrower than two distances vanishes with all that is in it; so does a hole that is filled up.
            if (narrow && Grid.DoubleArea(path, 0, path.Length) > 0 == d < 0) continue;
            if (Reach(box) + curve.Reach > Grid.Limit) throw new ArgumentException("The offset would leave ±5368.709 mm.", nameof(distance));
            curve.Build(path);
            engine.Arrangement.Add(curve.Points, 0, curve.Count, 0);
        }
        return Own(engine.Run(InsideRule.Positive));
    }

    private Region ThereAndBack(double radius, int sign, double arcTolerance)
    {
        if (!(radius >= 0)) throw new ArgumentException("The radius must not be negative.", nameof(radius));
        var engine = new RegionEngine();
        return Offset(sign * radius, JoinStyle.Round, 2, arcTolerance, engine).Offset(-sign * radius, JoinStyle.Round, 2, arcTolerance, engine);
    }

    private static double Reach(in GridBox box)
        => Math.Max(Math.Max(-(double)box.MinX, box.MaxX), Math.Max(-(double)box.MinY, box.MaxY));
}
