namespace Caterpillar.GCode;

/// <summary>Reads the moves of a toolpath and skips given blocks.</summary>
internal sealed class MoveCursor
{
    private readonly Toolpath _toolpath;
    private readonly HashSet<ToolpathBlock>? _skip;
    private int _block = -1;

    public MoveCursor(Toolpath toolpath, HashSet<ToolpathBlock>? skip = null)
    {
        _toolpath = toolpath;
        _skip = skip;
        NextBlock();
    }

    public MoveCursor Clone() => (MoveCursor)MemberwiseClone();

    public ToolpathColumns Columns { get; private set; } = null!;

    public int Index { get; private set; }

    public bool Valid => _block < _toolpath.Blocks.Count;

    public int Source => Columns.Source[Index];

    /// <summary>Number of the move in its toolpath.</summary>
    public int Number => Valid ? _toolpath.FirstOf(_block) + Index : _toolpath.Count;

    public void Next()
    {
        if (++Index >= Columns.Count) NextBlock();
    }

    /// <summary>Skips to the first move whose line is not before this one.</summary>
    public void SkipTo(int line)
    {
        while (Valid)
        {
            var last = Columns.Source[Columns.Count - 1];
            if (last >= 0 && last < line) NextBlock();
            else if (Source < line && LeadsTo() < line) Next();
            else return;
        }
    }

    /// <summary>The line of the next move that has one, or the largest number.</summary>
    public int LeadsTo()
    {
        if (!Valid || Source >= 0) return Valid ? Source : int.MaxValue;
        var ahead = Clone();
        while (ahead.Valid && ahead.Source < 0) ahead.Next();
        return ahead.Valid ? ahead.Source : int.MaxValue;
    }

    public TargetMove Move() => new(Columns, Index);

    public static bool Same(MoveCursor a, MoveCursor b) => Same(a.Columns, a.Index, b.Columns, b.Index);

    public static bool Same(ToolpathColumns c, int i, ToolpathColumns d, int j)
        => c.X[i] == d.X[j] && c.Y[i] == d.Y[j] && c.Z[i] == d.Z[j] && c.E[i] == d.E[j] && c.Speed[i] == d.Speed[j] && c.Kind[i] == d.Kind[j]
            && c.Tool[i] == d.Tool[j]
            && ((c.Turns is null && d.Turns is null && c.Arcs.Length == 0 && d.Arcs.Length == 0) || new TargetMove(c, i) == new TargetMove(d, j));

    private void NextBlock()
    {
        Index = 0;
        do _block++;
        while (_block < _toolpath.Blocks.Count && _skip is not null && _skip.Contains(_toolpath.Blocks[_block]));
        if (Valid) Columns = _toolpath.Blocks[_block].Columns;
    }
}
