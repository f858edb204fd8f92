namespace Caterpillar.Slicing;

/// <summary>First stage of a layer, which needs no neighbors: its section becomes a region, islands, and their walls.</summary>
internal static class OutlineStage
{
    public static void Run(LayerWork layer, RegionEngine engine)
    {
        LayerRegion.Find(layer, engine);
        if (layer.Region.IsEmpty) return;
        var settings = layer.Rules.Settings;
        if (settings.SpiralVase && layer.Index >= settings.BottomLayers)
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
}
