namespace Caterpillar.Toolpaths;

/// <summary>Applies a filter to the moves of a toolpath, with a few look-ups for each.</summary>
internal sealed class MoveChoice(MoveFilter filter, Toolpath toolpath)
{
    private readonly bool[] _kinds = [.. Enum.GetValues(typeof(MoveKind)).Cast<MoveKind>().Select(k => filter.Kinds is null || filter.Kinds.Contains(k))];
    private readonly bool[] _roles = [.. Enum.GetValues(typeof(Role)).Cast<Role>().Select(r => filter.Roles is null || filter.Roles.Contains(r))];

    // First of moves without a layer, then by layer.
    private readonly bool[] _layers = [filter.MatchesNumber(null), .. toolpath.Layers.Select(filter.MatchesNumber)];

    /// <summary>The selected moves of a toolpath.</summary>
    public static MoveSet Of(MoveFilter filter, Toolpath toolpath)
    {
        var choice = new MoveChoice(filter, toolpath);
        var chosen = new MoveSet(toolpath.Count);
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            var (c, first) = (toolpath.Blocks[block].Columns, toolpath.FirstOf(block));
            for (var i = 0; i < c.Count; i++) chosen[first + i] = choice.Has(c, i);
        }
        return chosen;
    }

    /// <summary>True if a move of a block is selected.</summary>
    public bool Has(ToolpathColumns c, int i)
        => _kinds[(int)c.Kind[i]] && _roles[(int)c.Role[i]] && _layers[c.Layer[i] + 1] && (filter.Tool is null || c.Tool[i] == filter.Tool)
            && (filter.Box is null || filter.Box.Value.Contains(new Vec3(c.X[i], c.Y[i], c.Z[i])));
}
