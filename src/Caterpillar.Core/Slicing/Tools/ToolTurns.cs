namespace Caterpillar.Slicing;

/// <summary>What one tool prints of the layers at one height.</summary>
/// <param name="Tool">Number of the tool.</param>
/// <param name="Changes">True if another tool comes before it.</param>
/// <param name="Layers">The layers in their order, each with the paths of this tool only.</param>
internal sealed record ToolTurn(int Tool, bool Changes, List<SlicedLayer> Layers)
{
    /// <summary>What is to be purged before anything else is printed, mm³.</summary>
    public double Purge { get; set; }
}

/// <summary>
/// Divides the layers of each height among the tools, with few changes: the last tool of one height begins the next, and one that the next height needs, too,
/// comes last.
/// </summary>
internal static class ToolTurns
{
    /// <summary>True if layers may need several tools.</summary>
    public static bool AreNeeded(LayerWork[] works)
        => works.SelectMany(w => w.Modifiers.Select(m => m.Rules).Prepend(w.Rules)).SelectMany(r => r.Settings.Tools).Distinct().Skip(1).Any();

    /// <summary>The turns of each height. The print begins with tool 0.</summary>
    public static List<ToolTurn[]> Of(IReadOnlyList<SlicedLayer[]> levels)
    {
        var turns = new List<ToolTurn[]>(levels.Count);
        var tools = levels.Select(level => new SortedSet<int>(level.SelectMany(l => l.Steps).Select(s => s.Path.Tool))).ToArray();
        var last = 0;
        for (var i = 0; i < levels.Count; i++)
        {
            var order = Order(tools[i], last, i + 1 < tools.Length ? tools[i + 1] : []);
            var level = new ToolTurn[order.Length];
            for (var k = 0; k < level.Length; k++)
            {
                level[k] = new ToolTurn(order[k], order[k] != last, Share(levels[i], order[k]));
                last = order[k];
            }
            turns.Add(level);
        }
        return turns;
    }

    /// <summary>The layers of turns in their order, so that sorting keeps it.</summary>
    public static SlicedLayer[] Layers(ToolTurn[] turns, ref int number)
    {
        var layers = new List<SlicedLayer>();
        foreach (var layer in turns.SelectMany(t => t.Layers))
        {
            var at = number++;
            layers.Add(layer with { Steps = [.. layer.Steps.Select(s => s with { Group = s.Group!.Value with { Layer = at } })] });
        }
        return layers.ToArray();
    }

    private static int[] Order(SortedSet<int> tools, int last, SortedSet<int> next)
    {
        var others = tools.Where(t => t != last).ToList();
        if (others.Exists(next.Contains))
        {
            var end = others.Find(next.Contains);
            others.Remove(end);
            others.Add(end);
        }
        return tools.Contains(last) ? [last, .. others] : [.. others];
    }

    private static List<SlicedLayer> Share(SlicedLayer[] level, int tool)
        => level.Select(l => l with { Steps = l.Steps.Where(s => s.Path.Tool == tool).ToArray() }).Where(l => l.Steps.Count > 0).ToList();
}
