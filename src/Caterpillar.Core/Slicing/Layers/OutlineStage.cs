using System.Collections.Generic;
using Caterpillar.Geometry;
using Caterpillar.Machines;

namespace Caterpillar.Slicing;

/// <summary>First stage of a layer, which needs no neighbors: its section becomes a region, islands, and their walls.</summary>
internal static class OutlineStage
{
    public static void Run(LayerWork layer, LayerTools tools)
    {
        if (layer.Section is not { } section) return;
        layer.Section = null;
        var (settings, engine) = (layer.Rules.Settings, tools.Engine);
        if (settings.OpenMeshes == OpenMeshes.Walls) layer.OpenLines = section.OpenLines;
        var region = Region.From(section.Loops, FillRule.NonZero, false, engine).Simplified(settings.SimplifyTolerance, engine);
        layer.Region = Compensated(region, layer, engine);
        if (settings.Vase && layer.Index >= settings.BottomLayers)
        {
            layer.VaseLoop = VaseSpiral.Loop(layer, engine);
            if (layer.VaseLoop is not null) return;
        }
        var islands = layer.Region.Islands;
        var builder = new WallBuilder(layer.Rules.Walls, engine);
        layer.Islands = new IslandWork[islands.Count];
        for (var i = 0; i < islands.Count; i++)
        {
            var walls = builder.Build(islands[i]);
            layer.TooThin.AddRange(walls.TooThin);
            layer.Islands[i] = new IslandWork(islands[i]) { Walls = walls.Paths, Inside = walls.Inside };
        }
    }

    // Outlines and holes moved by the compensations of the settings.
    private static Region Compensated(Region region, LayerWork layer, RegionEngine engine)
    {
        var settings = layer.Rules.Settings;
        var outline = settings.XyCompensation + (layer.Index == 0 ? settings.FirstLayerCompensation : 0);
        var inHoles = outline - settings.HoleCompensation;
        if (outline == 0 && inHoles == 0) return region;
        if (outline == inHoles) return region.Offset(outline, JoinStyle.Miter, 2, 0.005, engine);
        // Holes are regions of their own, turned over; an island within a hole is an outline again.
        var result = Region.Empty;
        foreach (var island in region.Islands)
        {
            var outer = Region.Own([island.Paths[0]]).Offset(outline, JoinStyle.Miter, 2, 0.005, engine);
            var holes = new List<GridPoint[]>();
            for (var i = 1; i < island.Paths.Length; i++)
            {
                var hole = (GridPoint[])island.Paths[i].Clone();
                System.Array.Reverse(hole);
                holes.Add(hole);
            }
            if (holes.Count > 0) outer = outer.Subtract(Region.Own(holes.ToArray()).Offset(-inHoles, JoinStyle.Miter, 2, 0.005, engine), engine);
            result = result.Union(outer, engine);
        }
        return result;
    }
}
