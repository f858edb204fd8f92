using System.Collections.Generic;
using Caterpillar.Geometry;
using Caterpillar.Machines;

namespace Caterpillar.Slicing;

/// <summary>First stage of a layer, which needs no neighbors: its section becomes a region, islands, and their walls.</summary>
internal static class OutlineStage
{
    /// <summary>Only the region, where others need that of all layers first.</summary>
    public static void FindRegion(LayerWork layer, LayerTools tools)
    {
        if (layer.Section is not { } section) return;
        layer.Section = null;
        var (settings, engine) = (layer.Rules.Settings, tools.Engine);
        if (settings.OpenMeshes == OpenMeshes.Walls) layer.OpenLines = section.OpenLines;
        var region = Region.From(section.Loops, FillRule.NonZero, false, engine);
        // What simplifying cuts off stays open where there is nothing but walls.
        var tolerance = IsAllWalls(region, layer.Rules.Walls) ? settings.SimplifyTolerance / 2 : settings.SimplifyTolerance;
        layer.Region = Compensated(region.Simplified(tolerance, engine), layer, engine);
    }

    public static void Run(LayerWork layer, LayerTools tools)
    {
        FindRegion(layer, tools);
        if (layer.Region.IsEmpty) return;
        var (settings, engine) = (layer.Rules.Settings, tools.Engine);
        if (settings.Vase && layer.Index >= settings.BottomLayers)
        {
            layer.VaseLoop = VaseSpiral.Loop(layer, engine);
            if (layer.VaseLoop is not null) return;
        }
        var islands = new List<IslandWork>();
        foreach (var zone in LayerZones.Of(layer, engine))
        {
            var builder = new WallBuilder(zone.Rules.Walls, engine);
            foreach (var island in zone.Region.Islands)
            {
                var walls = builder.Build(island);
                layer.TooThin.AddRange(walls.TooThin);
                islands.Add(new IslandWork(island, zone.Rules) { Walls = walls.Paths, Insides = zone.Divide(walls.Inside, engine) });
            }
        }
        layer.Islands = islands.ToArray();
    }

    // On average the walls of both sides fill the layer.
    private static bool IsAllWalls(Region region, WallRules walls)
        => walls.Count > 0 && region.Area < region.Perimeter * (walls.Edge + walls.OuterSpacing + (walls.Count - 1) * walls.InnerSpacing);

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
