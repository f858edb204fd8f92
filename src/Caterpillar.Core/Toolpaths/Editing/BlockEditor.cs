namespace Caterpillar.Toolpaths;

/// <summary>Collects the moves of an edited block, for the file that keeps it. Rotary axes keep their position until a move turns them.</summary>
internal sealed class BlockEditor(int size, PageFile<ToolpathColumns>? file)
{
    private readonly ToolpathBuilder _builder = new(MoveSource.Lines, null) { Moves = new(ToolpathBlock.Capacity, size, file) };
    private Vec3? _turns;

    /// <summary>An editor for moves of a toolpath from this one on, with room for so many at first.</summary>
    public static BlockEditor At(Toolpath toolpath, int move, int size = ToolpathBuilder.FirstSize)
    {
        var editor = new BlockEditor(size, toolpath.Blocks[toolpath.BlockOf(move)].File);
        if (move > 0) editor._turns = toolpath.TurnsOf(move - 1);
        return editor;
    }

    public void Add(Vec3 end, double e, double deposited, double speed, MoveKind kind, Role role, int layer, int tool, int source, Arc? arc)
    {
        _builder.Add(end, e, deposited, speed, kind, role, layer, tool, source, arc);
        Turn();
    }

    /// <summary>Adds moves as they are.</summary>
    public void Add(ToolpathColumns columns, int from, int to)
    {
        if (from >= to) return;
        var turns = _turns is not null && columns.Turns is null;
        for (var i = from; turns && i < to; i++)
        {
            _builder.Add(columns, i, i + 1);
            Turn();
        }
        if (!turns) _builder.Add(columns, from, to);
        if (columns.Turns is not null) Take(columns, to - 1);
    }

    /// <summary>The moves added from now on come from the script line of this move.</summary>
    public void From(ToolpathColumns columns, int i) => _builder.Line = columns.Line?[i] ?? 0;

    /// <summary>Sets the rotary axes of the last move from a move of these columns.</summary>
    public void Turn(ToolpathColumns columns, int i)
    {
        if (columns.Turns is null || _builder.Count == 0) return;
        Take(columns, i);
        Turn();
    }

    public IReadOnlyList<ToolpathBlock> ToBlocks() => _builder.Build([]).Blocks;

    private void Take(ToolpathColumns columns, int i) => _turns = columns.TurnsAt(i, Vec3.Zero);

    private void Turn()
    {
        if (_turns is { } turns) _builder.SetRotary(turns);
    }
}
