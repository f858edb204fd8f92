namespace Caterpillar.Slicing;

/// <summary>Infill of several layers that is printed at once, with the uppermost of them.</summary>
/// <param name="Area">What the infill of all these layers has in common.</param>
/// <param name="Thickness">Total thickness of the combined layers if this is the uppermost, otherwise 0.</param>
internal readonly record struct ThickInfill(Region Area, double Thickness)
{
    public static ThickInfill None => new(Region.Empty, 0);

    /// <summary>First and last layer of the group of a layer.</summary>
    public static (int First, int Last) Group(LayerWork layer)
    {
        var every = layer.Rules.Settings.CombineInfillLayers;
        var first = layer.Index / every * every;
        return (first, Math.Min(layer.Body.Layers.Length, first + every) - 1);
    }

    /// <summary>What a layer has to do with its group.</summary>
    public static ThickInfill Of(LayerWork layer, RegionEngine engine)
    {
        if (layer.Rules.Settings.CombineInfillLayers == 1) return None;
        var (first, last) = Group(layer);
        var thickness = 0.0;
        Region? common = null;
        for (var i = first; i <= last; i++)
        {
            var member = layer.Body.Layers[i];
            thickness += member.Plan.Thickness;
            var sparse = SparseOf(member, engine);
            common = common is null ? sparse : common.Intersect(sparse, engine);
        }
        // Slivers that no extrusion fits into stay with their layers.
        var half = layer.Rules.InfillWidth;
        common = common!.Offset(-half, JoinStyle.Miter, 2, 0.005, engine).Offset(half, JoinStyle.Miter, 2, 0.005, engine);
        return common.IsEmpty || first == last ? None : new ThickInfill(common, layer.Index == last ? thickness : 0);
    }

    /// <summary>The sparse infill of all islands of a layer, or only of one pattern.</summary>
    public static Region SparseOf(LayerWork layer, RegionEngine engine, InfillPattern? pattern = null)
    {
        var paths = new List<GridPoint[]>();
        foreach (var island in layer.Islands)
        {
            foreach (var inside in island.Insides)
            {
                if (pattern is null || inside.Rules.Settings.InfillPattern == pattern)
                    paths.AddRange(TopBottomFinder.AreasOf(layer, inside, engine).Sparse.Paths);
            }
        }
        return Region.Own(paths.ToArray());
    }
}
