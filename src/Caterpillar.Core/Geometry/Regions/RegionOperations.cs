namespace Caterpillar.Geometry;

/// <summary>Operations on regions with an engine that is kept from one to the next, so that its memory is used again.</summary>
internal static class RegionOperations
{
    public static Region Union(this Region region, Region other, RegionEngine engine) => Combine(region, other, InsideRule.Positive, 0, engine);

    public static Region Intersect(this Region region, Region other, RegionEngine engine) => Combine(region, other, InsideRule.Intersection, 1, engine);

    public static Region Subtract(this Region region, Region other, RegionEngine engine) => Combine(region, other, InsideRule.Difference, 1, engine);

    /// <summary>The area of a region that is in any of some others, in one pass.</summary>
    public static Region Intersect(this Region region, IReadOnlyList<Region> others, RegionEngine engine)
        => Combine([region], others, InsideRule.Intersection, engine);

    /// <summary>Combines the regions of two operands by the rule, in one pass.</summary>
    public static Region Combine(IReadOnlyList<Region> first, IReadOnlyList<Region> second, InsideRule rule, RegionEngine engine)
    {
        engine.Clear();
        foreach (var region in first) engine.Add(region.Paths);
        if (engine.Arrangement.Contours == 0) return Region.Empty;
        foreach (var region in second) engine.Add(region.Paths, 1);
        return Region.Own(engine.Run(rule));
    }

    /// <inheritdoc cref="Region.Offset(double, JoinStyle, double, double)"/>
    public static Region Offset(this Region region, double distance, JoinStyle join, double miterLimit, double arcTolerance, RegionEngine engine)
    {
        var curve = Curve(engine, distance, join, miterLimit, arcTolerance);
        var d = distance * Grid.PerMm;
        if (region.IsEmpty || Math.Abs(d) < 0.5) return region;
        engine.Clear();
        foreach (var path in region.Paths)
        {
            var box = GridBox.Of(path);
            var narrow = Math.Min((double)box.MaxX - box.MinX, (double)box.MaxY - box.MinY) <= 2 * Math.Abs(d);
            // An outline narrower than two distances vanishes with its content; so does a hole that is filled.
            if (narrow && Grid.DoubleArea(path, 0, path.Length) > 0 == d < 0) continue;
            if (Reach(box) + curve.Reach > Grid.Limit) throw new ArgumentException("The offset region would exceed ±5368.709 mm.", nameof(distance));
            curve.Build(path);
            engine.Arrangement.Add(curve.Points, 0, curve.Count, 0);
        }
        return Region.Own(engine.Run(InsideRule.Positive));
    }

    /// <summary>
    /// Fewer vertices: contours are replaced by chords that stay within a tolerance (mm) of the dropped vertices, found in one pass by sleeve fitting (Zhao
    /// and Saalfeld 1997). Resulting crossings are resolved; parts smaller than the tolerance vanish.
    /// </summary>
    /// <exception cref="ArgumentException">The tolerance is negative or not a number.</exception>
    public static Region Simplified(this Region region, double tolerance, RegionEngine engine)
    {
        if (!(tolerance >= 0)) throw new ArgumentException("The tolerance must not be negative.", nameof(tolerance));
        if (region.IsEmpty || tolerance == 0) return region;
        var simplifier = engine.Simplifier;
        engine.Clear();
        foreach (var path in region.Paths)
        {
            simplifier.Simplify(path, tolerance * Grid.PerMm);
            engine.Arrangement.Add(simplifier.Points, 0, simplifier.Count, 0);
        }
        return Region.Own(engine.Run(InsideRule.Positive));
    }

    private static Region Combine(Region region, Region other, InsideRule rule, byte operand, RegionEngine engine)
    {
        if (region.IsEmpty || other.IsEmpty)
        {
            if (rule == InsideRule.Intersection) return Region.Empty;
            return other.IsEmpty ? region : rule == InsideRule.Difference ? Region.Empty : other;
        }
        engine.Clear();
        engine.Add(region.Paths);
        engine.Add(other.Paths, operand);
        return Region.Own(engine.Run(rule));
    }

    private static OffsetCurve Curve(RegionEngine engine, double distance, JoinStyle join, double miterLimit, double arcTolerance)
    {
        if (double.IsNaN(distance) || double.IsInfinity(distance)) throw new ArgumentException("The distance must be a number.", nameof(distance));
        if (!(miterLimit >= 1) || double.IsInfinity(miterLimit)) throw new ArgumentException("The miter limit must be at least 1.", nameof(miterLimit));
        if (!(arcTolerance > 0)) throw new ArgumentException("The arc tolerance must be positive.", nameof(arcTolerance));
        if (join is not (JoinStyle.Miter or JoinStyle.Round or JoinStyle.Square)) throw new ArgumentOutOfRangeException(nameof(join), join, "Unknown join.");
        engine.Curve.Set(distance * Grid.PerMm, join, miterLimit, arcTolerance * Grid.PerMm);
        return engine.Curve;
    }

    private static double Reach(in GridBox box)
        => Math.Max(Math.Max(-(double)box.MinX, box.MaxX), Math.Max(-(double)box.MinY, box.MaxY));
}
