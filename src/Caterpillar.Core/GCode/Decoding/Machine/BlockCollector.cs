namespace Caterpillar.GCode;

/// <summary>Collects moves into the columns of blocks, without a call for each value.</summary>
/// <param name="blockSize">Number of moves in a block.</param>
/// <param name="keeps">False to forget each full block.</param>
/// <param name="file">Keeps the blocks; null = in memory.</param>
internal sealed class BlockCollector(int blockSize = ToolpathBlock.Capacity, bool keeps = true, PageFile<ToolpathColumns>? file = null)
{
    private readonly List<ToolpathBlock> _blocks = [];
    private readonly List<int> _arcMoves = [];
    private readonly List<Arc> _arcs = [];
    private readonly List<int> _turnMoves = [];
    private readonly List<Turns> _turns = [];
    private int _sealed;

    public ToolpathColumns Columns { get; private set; } = new(64);

    /// <summary>Number of moves so far.</summary>
    public int Count => _sealed + Columns.Count;

    public bool IsFull => Columns.Count == Columns.X.Length;

    /// <summary>Makes space for more moves. Returns the full block, if any.</summary>
    public ToolpathColumns? Grow()
    {
        if (Columns.Capacity < blockSize)
        {
            Columns = Columns.Copy(Math.Min(Columns.Capacity * 4, blockSize));
            return null;
        }
        var full = Columns;
        Seal();
        if (!keeps) _blocks.Clear();
        Columns = new ToolpathColumns(blockSize);
        return full;
    }

    /// <summary>The last move is an arc.</summary>
    public void AddArc(Arc arc)
    {
        _arcMoves.Add(Columns.Count - 1);
        _arcs.Add(arc);
    }

    /// <summary>Sets the rotary axes of the last move. Other moves do not turn them.</summary>
    public void Turn(Turns turns)
    {
        _turnMoves.Add(Count - 1);
        _turns.Add(turns);
    }

    /// <summary>Removes the layer of all moves so far, for files whose layer comments begin late.</summary>
    public void ForgetLayers()
    {
        for (var i = 0; i < _blocks.Count; i++) Replace(i, WithLayers(_blocks[i].Columns, _ => -1));
        Columns = WithLayers(Columns, _ => -1);
    }

    /// <summary>Other numbers for the layers of all moves.</summary>
    public void RenumberLayers(int[] places)
    {
        int Place(int layer) => layer >= 0 ? places[layer] : -1;
        for (var i = 0; i < _blocks.Count; i++) Replace(i, WithLayers(_blocks[i].Columns, Place));
        Columns = WithLayers(Columns, Place);
    }

    /// <summary>The arc of the last move, if any.</summary>
    public Arc? LastArc => _arcMoves.Count > 0 && _arcMoves[_arcMoves.Count - 1] == Columns.Count - 1 ? _arcs[_arcs.Count - 1] : null;

    /// <summary>Removes the moves so far, only while they fit into one block.</summary>
    public void Clear()
    {
        Columns.Count = 0;
        _arcMoves.Clear();
        _arcs.Clear();
        if (_turns.Count == 0) return;
        _turnMoves.Clear();
        _turns.Clear();
    }

    public IReadOnlyList<ToolpathBlock> ToBlocks()
    {
        if (Columns.Count > 0)
        {
            if (Columns.Count < Columns.Capacity / 2) Columns = Columns.Copy(Columns.Count);
            Seal();
        }
        if (_turns.Count > 0 && keeps) FillTurns();
        return keeps ? _blocks : [];
    }

    // Columns from the block of the first turn on.
    private void FillTurns()
    {
        int next = 0, first = 0;
        var now = default(Turns);
        for (var block = 0; block < _blocks.Count; first += _blocks[block++].Count)
        {
            if (_turnMoves[0] >= first + _blocks[block].Count) continue;
            var columns = _blocks[block].Columns.Share();
            columns.A = new double[columns.Capacity];
            columns.B = new double[columns.Capacity];
            columns.C = new double[columns.Capacity];
            for (var i = 0; i < columns.Count; i++)
            {
                while (next < _turnMoves.Count && _turnMoves[next] <= first + i) now = _turns[next++];
                columns.A[i] = now.A;
                columns.B[i] = now.B;
                columns.C[i] = now.C;
            }
            Replace(block, columns);
        }
    }

    // In a new column: whoever follows may still read the old one.
    private static ToolpathColumns WithLayers(ToolpathColumns columns, Func<int, int> layerOf)
    {
        columns = columns.Share();
        var (before, layers) = (columns.Layer, new int[columns.Layer.Length]);
        for (var i = 0; i < columns.Count; i++) layers[i] = layerOf(before[i]);
        columns.Layer = layers;
        return columns;
    }

    private void Replace(int block, ToolpathColumns columns) => _blocks[block] = new ToolpathBlock(columns, file);

    private void Seal()
    {
        Columns.ArcMoves = _arcMoves.ToArray();
        Columns.Arcs = _arcs.ToArray();
        _arcMoves.Clear();
        _arcs.Clear();
        _blocks.Add(new ToolpathBlock(Columns, file));
        _sealed += Columns.Count;
        Columns = new ToolpathColumns(0);
    }
}
