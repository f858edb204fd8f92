using System;
using System.Collections.Generic;

namespace Caterpillar.Geometry;

public sealed partial class Region
{
    /// <summary>The area in this region or the other.</summary>
    public Region Union(Region other) => Combine(other, InsideRule.Positive, 0, new RegionEngine());

    /// <summary>The area in both.</summary>
    public Region Intersect(Region other) => Combine(other, InsideRule.Intersection, 1, new RegionEngine());

    /// <summary>The area in this region and not in the other.</summary>
    public Region Subtract(Region other) => Combine(other, InsideRule.Difference, 1, new RegionEngine());

    /// <summary>The area in exactly one of the two.</summary>
    public Region Xor(Region other) => Combine(other, InsideRule.SymmetricDifference, 1, new RegionEngine());

    /// <summary>The area in any of the regions, in one pass.</summary>
    public static Region Union(IEnumerable<Region> regions) => Union(regions, null);

    internal static Region Union(IEnumerable<Region> regions, RegionEngine? engine)
    {
        if (regions is null) throw new ArgumentNullException(nameof(regions));
        var parts = new List<Region>();
        foreach (var region in regions)
        {
            if (!(region ?? throw new ArgumentException("A region is missing.", nameof(regions))).IsEmpty) parts.Add(region);
        }
        if (parts.Count < 2) return parts.Count == 0 ? Empty : parts[0];
        engine ??= new RegionEngine();
        engine.Clear();
        foreach (var part in parts) engine.Add(part._paths);
        return Own(engine.Run(InsideRule.Positive));
    }

    /// <summary>The area in all of the regions; empty for none.</summary>
    public static Region Intersect(IEnumerable<Region> regions)
    {
        if (regions is null) throw new ArgumentNullException(nameof(regions));
        Region? result = null;
        var engine = new RegionEngine();
        foreach (var region in regions)
        {
            if (region is null) throw new ArgumentException("A region is missing.", nameof(regions));
            result = result is null ? region : result.Combine(region, InsideRule.Intersection, 1, engine);
        }
        return result ?? Empty;
    }

    /// <summary>The area in any of some regions and in none of others, in one pass.</summary>
    internal static Region Difference(IReadOnlyList<Region> areas, IReadOnlyList<Region> without, RegionEngine engine)
        => Combine(areas, without, InsideRule.Difference, engine);

    /// <summary>The area of this region that is in any of some others, in one pass.</summary>
    internal Region Intersect(IReadOnlyList<Region> others, RegionEngine engine) => Combine([this], others, InsideRule.Intersection, engine);

    internal Region Union(Region other, RegionEngine engine) => Combine(other, InsideRule.Positive, 0, engine);

    internal Region Intersect(Region other, RegionEngine engine) => Combine(other, InsideRule.Intersection, 1, engine);

    internal Region Subtract(Region other, RegionEngine engine) => Combine(other, InsideRule.Difference, 1, engine);

    private static Region Combine(IReadOnlyList<Region> first, IReadOnlyList<Region> second, InsideRule rule, RegionEngine engine)
    {
        engine.Clear();
        foreach (var region in first) engine.Add(region._paths);
        if (engine.Arrangement.Contours == 0) return Empty;
        foreach (var region in second) engine.Add(region._paths, 1);
        return Own(engine.Run(rule));
    }

    private Region Combine(Region other, InsideRule rule, byte operand, RegionEngine engine)
    {
        if (other is null) throw new ArgumentNullException(nameof(other));
        if (IsEmpty || other.IsEmpty)
        {
            if (rule == InsideRule.Intersection) return Empty;
            return other.IsEmpty ? this : rule == InsideRule.Difference ? Empty : other;
        }
        engine.Clear();
        engine.Add(_paths);
        engine.Add(other._paths, operand);
        return Own(engine.Run(rule));
    }
}
