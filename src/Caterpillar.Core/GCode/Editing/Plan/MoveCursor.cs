namespace Caterpillar.GCode;

/// <summary>Reads the moves of a toolpath.</summary>
internal sealed class MoveCursor
{
    private int _block = -1;

    public MoveCursor(Toolpath toolpath)
    {
        Toolpath = toolpath;
        NextBlock();
    }

    public Toolpath Toolpath { get; }

    public ToolpathColumns Columns { get; private set; } = null!;

    public int Index { get; private set; }

    public bool Valid => _block < Toolpath.Blocks.Count;

    public int Source => Columns.Source[Index];

    /// <summary>Number of the move in its toolpath.</summary>
    public int Number => Valid ? Toolpath.FirstOf(_block) + Index : Toolpath.Count;

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
        var ahead = (MoveCursor)MemberwiseClone();
        while (ahead.Valid && ahead.Source < 0) ahead.Next();
        return ahead.Valid ? ahead.Source : int.MaxValue;
    }

    public TargetMove Move() => new(Columns, Index);

    private void NextBlock()
    {
        Index = 0;
        _block++;
        if (Valid) Columns = Toolpath.Blocks[_block].Columns;
    }
}
