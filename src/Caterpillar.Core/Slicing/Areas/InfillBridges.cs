namespace Caterpillar.Slicing;

/// <summary>
/// What of a closed layer lies on sparse infill, or on nothing where there is none: its extrusions go across the lines below and hang between them.
/// </summary>
internal static class InfillBridges
{
    private const double ArcTolerance = 0.005;

    /// <summary>The bridges of an area. None if it is narrow, or the infill below is almost solid.</summary>
    public static IReadOnlyList<BridgeArea> Find(LayerWork layer, SliceRules rules, Region solid, RegionEngine engine)
    {
        // A gap between the lines of this many widths or less needs no bridge.
        const double Close = 2;
        if (!rules.Settings.InfillBridges || solid.IsEmpty || layer.Index == 0) return [];
        // Narrower areas are filled along their outline.
        var half = Math.Max(rules.Settings.NarrowSolidInfill / 2, rules.Width);
        if (solid.Offset(-half, JoinStyle.Miter, 2, ArcTolerance, engine).IsEmpty) return [];
        var below = layer.Body.Layers[layer.Index - 1];
        var bridges = new List<BridgeArea>();
        foreach (var (lower, sparse) in Sparse(below, solid, engine))
        {
            var hollow = lower.InfillSpacing <= 0;
            if (!hollow && lower.InfillSpacing <= Close * lower.InfillWidth) continue;
            var over = solid.Intersect(sparse, engine).Offset(-half, JoinStyle.Miter, 2, ArcTolerance, engine);
            if (over.IsEmpty) continue;
            var area = over.Offset(half + rules.Settings.BridgeAnchor, JoinStyle.Miter, 2, ArcTolerance, engine).Intersect(solid, engine);
            var held = hollow ? below.Region.Subtract(sparse, engine) : Region.Empty;
            foreach (var piece in area.Islands)
            {
                // Extrusions are held by the walls around the area, just beyond its edge.
                var angle = hollow ? BridgeFinder.Find(piece.Offset(rules.Width / 2, JoinStyle.Miter, 2, ArcTolerance, engine), held, rules.Width)
                    : Across(lower, below.Index);
                if (angle is { } direction) bridges.Add(new BridgeArea(piece, direction));
            }
            solid = solid.Subtract(area, engine);
        }
        return bridges;
    }

    // The infill of a layer by its settings, in their order.
    private static List<(SliceRules Rules, Region Area)> Sparse(LayerWork layer, Region near, RegionEngine engine)
    {
        var found = new List<(SliceRules Rules, List<GridPoint[]> Paths)>();
        foreach (var island in layer.Islands)
        {
            if (!GridBox.Overlap(island.Region.Box, near.Box)) continue;
            foreach (var inside in island.Insides)
            {
                var sparse = TopBottomFinder.AreasOf(layer, inside, engine).Sparse;
                if (sparse.IsEmpty) continue;
                var at = found.FindIndex(f => ReferenceEquals(f.Rules, inside.Rules));
                if (at < 0) found.Add((inside.Rules, [.. sparse.Paths]));
                else found[at].Paths.AddRange(sparse.Paths);
            }
        }
        return found.ConvertAll(f => (f.Rules, Region.Own(f.Paths.ToArray()).Near(near.Box)));
    }

    // The direction with the shortest spans between the lines of a layer.
    private static double Across(SliceRules rules, int layer)
    {
        var angle = rules.InfillAngle(layer);
        return rules.Settings.InfillPattern switch
        {
            // Two families at a right angle, or waves along both: between them.
            InfillPattern.Grid or InfillPattern.Gyroid or InfillPattern.Hilbert => angle + 45,
            _ => angle + 90,
        };
    }
}
