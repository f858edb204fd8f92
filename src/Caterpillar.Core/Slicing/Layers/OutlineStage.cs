using Caterpillar.Geometry;

namespace Caterpillar.Slicing;

/// <summary>First stage of a layer, which needs no neighbors: its section becomes a region, islands, and their walls.</summary>
internal static class OutlineStage
{
    public static void Run(LayerWork layer, LayerTools tools)
    {
        if (layer.Section is not { } section) return;
        layer.Section = null;
        var engine = tools.Engine;
        layer.Region = Region.From(section.Loops, FillRule.NonZero, false, engine).Simplified(layer.Rules.Settings.SimplifyTolerance, engine);
        var islands = layer.Region.Islands;
        var builder = new WallBuilder(layer.Rules.Walls, engine);
        layer.Islands = new IslandWork[islands.Count];
        for (var i = 0; i < islands.Count; i++)
        {
            var walls = builder.Build(islands[i]);
            layer.Islands[i] = new IslandWork(islands[i]) { Walls = walls.Paths, Inside = walls.Inside };
        }
    }
}
