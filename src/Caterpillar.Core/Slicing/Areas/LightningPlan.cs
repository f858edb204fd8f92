namespace Caterpillar.Slicing;

/// <summary>The trees of a body that support its top surfaces from below. They grow downwards, so they need the outlines of all its layers.</summary>
internal static class LightningPlan
{
    /// <summary>The trees of each layer. Grown when they are first asked for, by when all layers have their outlines.</summary>
    public static IReadOnlyList<Polyline>[] TreesOf(Body body)
    {
        lock (body.Gate) return body.Trees ??= Grow(body);
    }

    private static IReadOnlyList<Polyline>[] Grow(Body body)
    {
        var engine = new RegionEngine();
        var areas = new Region[body.Layers.Length];
        var heights = new double[areas.Length];
        var spacing = 0.0;
        for (var i = 0; i < areas.Length; i++)
        {
            body.Cancel.ThrowIfCancellationRequested();
            var layer = body.Layers[i];
            heights[i] = layer.Plan.Top;
            var rules = RulesOf(layer);
            if (rules.InfillSpacing > 0) spacing = Math.Max(spacing, rules.InfillSpacing);
            areas[i] = AreaFiller.CenterLines(ThickInfill.SparseOf(layer, engine, InfillPattern.Lightning), rules, rules.InfillWidth, rules.Overlap, engine);
        }
        var tops = new Region[areas.Length];
        for (var i = 0; i < tops.Length; i++) tops[i] = i + 1 < tops.Length ? areas[i].Subtract(areas[i + 1], engine) : areas[i];
        return spacing > 0 ? Lightning.Grow(areas, tops, spacing, heights, body.Cancel) : new IReadOnlyList<Polyline>[areas.Length];
    }

    // Those of a modifier where only its infill is trees.
    private static SliceRules RulesOf(LayerWork layer)
    {
        if (layer.Rules.Settings.InfillPattern == InfillPattern.Lightning) return layer.Rules;
        var at = layer.Modifiers.FindIndex(m => m.Rules.Settings.InfillPattern == InfillPattern.Lightning);
        return at < 0 ? layer.Rules : layer.Modifiers[at].Rules;
    }
}
