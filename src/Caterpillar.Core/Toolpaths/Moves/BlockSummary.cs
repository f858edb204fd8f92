namespace Caterpillar.Toolpaths;

/// <summary>The layers and lines of a block, which answer questions about the whole toolpath without reading all moves again.</summary>
internal sealed class BlockSummary
{
    public BlockSummary(ToolpathColumns c)
    {
        var last = (Layer: -1, IsPrinted: false);
        for (var i = 0; i < c.Count; i++)
        {
            var (layer, line) = ((Layer: c.Layer[i], IsPrinted: c.Kind[i] == MoveKind.Print), c.Source[i]);
            if (layer.Layer >= 0 && layer != last) Layers.Add(last = layer);
            if (line < 0) continue;
            Ascends &= line >= Last;
            First = Math.Min(First, line);
            Last = line;
        }
    }

    /// <summary>The layers of its extrusions, and of its other moves.</summary>
    public HashSet<(int Layer, bool IsPrinted)> Layers { get; } = [];

    /// <summary>The first and the last line of its moves. The largest and the least number = none.</summary>
    public int First { get; } = int.MaxValue;

    public int Last { get; } = int.MinValue;

    public bool Ascends { get; } = true;
}
