using System;
using System.Collections.Generic;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Slicing;

/// <summary>
/// Second stage of a layer, for which the regions of its neighbors are known: skins, infill, and the steps that print the layer. What it reads of other
/// layers is what the first stage wrote.
/// </summary>
internal static class FillStage
{
    /// <summary>The last layer of the body that the stage reads for a layer.</summary>
    public static int LastNeeded(LayerWork layer)
    {
        // Trees grow from the top down.
        if (layer.Rules.Settings.InfillPattern == InfillPattern.Lightning) return layer.Body.Layers.Length - 1;
        var last = layer.Index + SkinFinder.Reach(layer);
        if (layer.Rules.Settings.InfillEvery > 1)
        {
            var top = layer.Body.Layers[ThickInfill.Group(layer).Last];
            last = Math.Max(last, top.Index + SkinFinder.Reach(top));
        }
        return Math.Min(last, layer.Body.Layers.Length - 1);
    }

    public static SlicedLayer Run(LayerWork layer, LayerTools tools)
    {
        var steps = new List<PathStep>();
        var chains = new List<WallChain>();
        if (layer.VaseLoop is not null) return new SlicedLayer(layer.Layer, layer.Region, steps);
        var skins = new SkinFinder(layer, tools.Engine);
        var thick = ThickInfill.Of(layer, tools.Engine);
        for (var i = 0; i < layer.Islands.Length; i++)
        {
            var island = layer.Islands[i];
            WallSteps.Add(layer, island, i, tools.Engine, steps, chains);
            new AreaFiller(layer, island, i, tools, steps).Fill(skins.Find(island.Inside), thick);
        }
        if (layer.OpenLines.Count > 0) WallSteps.AddOpen(layer, steps);
        return new SlicedLayer(layer.Layer, layer.Region, steps) { Chains = chains };
    }
}
