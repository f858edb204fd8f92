namespace Caterpillar.Slicing;

/// <summary>Where the settings of modifiers apply in a layer. Zones whose walls are alike are walled together, so that only their filling differs.</summary>
/// <param name="Rules">The settings of the walls.</param>
/// <param name="Region">What the walls go around.</param>
/// <param name="Zones">Which settings fill which part of it; a single one may fill all.</param>
internal sealed record LayerZones(SliceRules Rules, Region Region, IReadOnlyList<(SliceRules Rules, Region Area)> Zones)
{
    /// <summary>The zones of a layer; of modifiers that overlap, the last one applies.</summary>
    public static IReadOnlyList<LayerZones> Of(LayerWork layer, RegionEngine engine)
    {
        if (layer.Modifiers.Count == 0) return [new LayerZones(layer.Rules, layer.Region, [(layer.Rules, layer.Region)])];
        var rest = layer.Region;
        var zones = new List<(SliceRules Rules, Region Area)>();
        for (var i = layer.Modifiers.Count - 1; i >= 0 && !rest.IsEmpty; i--)
        {
            var (rules, body) = layer.Modifiers[i];
            var area = rest.Intersect(body, engine);
            if (area.IsEmpty) continue;
            zones.Add((rules, area));
            rest = rest.Subtract(body, engine);
        }
        if (!rest.IsEmpty) zones.Insert(0, (layer.Rules, rest));
        var groups = new List<LayerZones>();
        while (zones.Count > 0)
        {
            var rules = zones[0].Rules;
            var alike = zones.FindAll(z => z.Rules.HasSameWalls(rules));
            zones.RemoveAll(z => z.Rules.HasSameWalls(rules));
            // Where all walls are alike nothing was divided.
            var region = zones.Count == 0
                && groups.Count == 0 ? layer.Region : alike.Count == 1 ? alike[0].Area : Geometry.Region.Union(alike.ConvertAll(z => z.Area));
            groups.Add(new LayerZones(rules, region, alike));
        }
        return groups;
    }

    /// <summary>What the walls of an island leave, divided among the zones.</summary>
    public IReadOnlyList<InsideWork> Divide(Region inside, RegionEngine engine)
        => Zones.Count == 1 ? [new InsideWork(Zones[0].Rules, inside)]
            : Zones.Select(z => new InsideWork(z.Rules, inside.Intersect(z.Area, engine))).Where(w => !w.Region.IsEmpty).ToList();
}
