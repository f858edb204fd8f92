namespace Caterpillar.Slicing;

/// <summary>First stage of a layer, which needs no results of its neighbors: its section becomes a region, islands, and their walls.</summary>
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
            var builder = new IslandWalls(layer, zone.Rules, engine);
            foreach (var island in zone.Region.Islands)
            {
                var walls = builder.Build(island);
                var (extra, inside) = builder.OverAir(walls.Inside);
                layer.TooThin.AddRange(walls.TooThin);
                islands.Add(new IslandWork(island, zone.Rules) { Walls = walls.Paths, OverAir = extra, Insides = zone.Divide(inside, engine) });
            }
        }
        layer.Islands = islands.ToArray();
    }
}
