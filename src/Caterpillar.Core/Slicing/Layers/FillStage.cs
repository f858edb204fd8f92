using System.Collections.Generic;
using Caterpillar.Toolpaths;

namespace Caterpillar.Slicing;

/// <summary>Second stage of a layer, for which the regions of its neighbors are known: skins, infill, and the steps that print the layer.</summary>
internal static class FillStage
{
    public static SlicedLayer Run(LayerWork layer, LayerTools tools)
    {
        var steps = new List<PathStep>();
        var skins = new SkinFinder(layer, tools.Engine);
        for (var i = 0; i < layer.Islands.Length; i++)
        {
            var island = layer.Islands[i];
            WallSteps.Add(layer, island, i, steps);
            new AreaFiller(layer, island, i, tools, steps).Fill(skins.Find(island.Inside));
        }
        return new SlicedLayer(layer.Layer, layer.Region, steps);
    }
}
