namespace Caterpillar.Toolpaths;

/// <summary>A filter prepared for the layers of one toolpath, so that each move needs only a few look-ups.</summary>
internal sealed class MoveChoice(MoveFilter filter, Toolpath toolpath)
{
    private readonly bool[] _kinds = Enum.GetValues(typeof(MoveKind)).Cast<MoveKind>().Select(k => filter.Kinds is null || filter.Kinds.Contains(k)).ToArray();
    private readonly bool[] _roles = Enum.GetValues(typeof(Role)).Cast<Role>().Select(r => filter.Roles is null || filter.Roles.Contains(r)).ToArray();

    // By layer; at last, of moves without one.
    private readonly bool[] _layers = toolpath.Layers.Select(filter.MatchesNumber).Concat([filter.MatchesNumber(null)]).ToArray();
    private readonly int? _tool = filter.Tool;
    private readonly Bounds? _box = filter.Box;

    /// <summary>Whether each move of a toolpath is selected.</summary>
    public static bool[] Of(MoveFilter filter, Toolpath toolpath)
    {
        var choice = new MoveChoice(filter, toolpath);
        var chosen = new bool[toolpath.Count];
        var move = 0;
        foreach (var block in toolpath.Blocks)
        {
            for (var i = 0; i < block.Count; i++) chosen[move++] = choice.Has(block.Columns, i);
        }
        return chosen;
    }

    /// <summary>True if a move in the columns of a block is selected.</summary>
    public bool Has(ToolpathColumns columns, int i)
    {
        var layer = columns.Layer[i];
        return _kinds[(int)columns.Kind[i]] && _roles[(int)columns.Role[i]] && _layers[layer < 0 ? _layers.Length - 1 : layer]
            && (_tool is null || columns.Tool[i] == _tool)
            && (_box is null || _box.Value.Contains(new Vec3(columns.X[i], columns.Y[i], columns.Z[i])));
    }
}
