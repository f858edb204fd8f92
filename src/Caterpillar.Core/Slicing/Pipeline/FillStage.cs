namespace Caterpillar.Slicing;

/// <summary>
/// Second stage of a layer, when the regions of its neighbors are known: top and bottom surfaces, infill, and the steps that print the layer. From other
/// layers it reads only the results of the first stage.
/// </summary>
internal static class FillStage
{
    /// <summary>The last layer of the body that the stage reads for a layer.</summary>
    public static int LastNeeded(LayerWork layer)
    {
        // Trees grow from the top down.
        if (HasTrees(layer)) return layer.Body.Layers.Length - 1;
        var last = layer.Index + Reach(layer);
        if (layer.Rules.Settings.CombineInfillLayers > 1)
        {
            var top = layer.Body.Layers[ThickInfill.Group(layer).Last];
            last = Math.Max(last, top.Index + Reach(top));
        }
        return Math.Min(last, layer.Body.Layers.Length - 1);
    }

    private static bool HasTrees(LayerWork layer)
        => layer.Rules.Settings.InfillPattern == InfillPattern.Lightning
            || layer.Modifiers.Exists(m => m.Rules.Settings.InfillPattern == InfillPattern.Lightning);

    private static int Reach(LayerWork layer) => layer.Modifiers.Select(m => m.Rules).Prepend(layer.Rules).Max(rules => TopBottomFinder.Reach(layer, rules));

    public static SlicedLayer Run(LayerWork layer, LayerTools tools)
    {
        var steps = new List<PathStep>();
        var chains = new List<WallChain>();
        if (layer.VaseLoop is not null) return new SlicedLayer(layer.Layer, layer.Region, steps);
        var thick = ThickInfill.Of(layer, tools.Engine);
        for (var i = 0; i < layer.Islands.Length; i++)
        {
            var island = layer.Islands[i];
            WallSteps.Add(layer, island, i, tools.Engine, steps, chains);
            foreach (var inside in island.Insides)
                new AreaFiller(layer, island, inside.Rules, i, tools, steps).Fill(TopBottomFinder.AreasOf(layer, inside, tools.Engine), thick);
        }
        if (layer.OpenLines.Count > 0) WallSteps.AddOpen(layer, steps);
        layer.Chains = chains;
        return new SlicedLayer(layer.Layer, layer.Region, steps);
    }
}
