namespace Caterpillar.Toolpaths;

/// <summary>Collects moves into the columns of blocks, without a call for each value.</summary>
/// <param name="blockSize">Number of moves in a block.</param>
/// <param name="firstSize">Number of moves that there is room for at first.</param>
/// <param name="file">Keeps the blocks; null = in memory.</param>
/// <param name="keeps">False to forget each full block.</param>
/// <param name="sums">Adds up the blocks; null = nobody.</param>
internal sealed class BlockCollector(
    int blockSize, int firstSize, PageFile<ToolpathColumns>? file = null, bool keeps = true, ToolpathSums? sums = null)
{
    private readonly List<ToolpathBlock> _blocks = [];
    private readonly List<int> _arcMoves = [];
    private readonly List<Arc> _arcs = [];
    private int _sealed;

    public ToolpathColumns Columns { get; private set; } = new(Math.Min(firstSize, blockSize));

    /// <summary>Rotary axes of the moves that are added, in degrees. Null = none.</summary>
    public Vec3? Turns { private get; set; }

    /// <summary>The full blocks.</summary>
    public IReadOnlyList<ToolpathBlock> Blocks => _blocks;

    public bool IsInMemory => file is null;

    public bool Keeps => keeps;

    /// <summary>Number of moves so far.</summary>
    public int Count => _sealed + Columns.Count;

    public bool IsFull => Columns.Count == Columns.Capacity;

    /// <summary>Makes space for more moves: a smaller block grows, one of full size ends and is returned.</summary>
    public ToolpathColumns? Grow(bool isTaken = true)
    {
        if (Columns.Capacity == blockSize) return End(isTaken);
        Columns = Columns.Copy(Math.Min(Math.Max(Columns.Capacity * 4, firstSize), blockSize));
        return null;
    }

    /// <summary>Ends the current block and returns it. Its columns are used again if they are neither kept nor taken by somebody.</summary>
    public ToolpathColumns End(bool isTaken = true)
    {
        var full = Columns;
        Seal();
        Columns = keeps || isTaken ? new ToolpathColumns(blockSize) : full;
        Columns.Count = 0;
        return full;
    }

    /// <summary>Adds a move, if there is room, and returns its number in the block.</summary>
    public int Add(Vec3 end, double e, double deposited, double speed, MoveKind kind, Role role, int layer, short tool, int source)
    {
        var c = Columns;
        var i = c.Count++;
        (c.X[i], c.Y[i], c.Z[i]) = (end.X, end.Y, end.Z);
        c.E[i] = e;
        c.Deposited[i] = deposited;
        c.Speed[i] = speed;
        c.Kind[i] = kind;
        c.Role[i] = role;
        c.Tool[i] = tool;
        c.Layer[i] = layer;
        c.Source[i] = source;
        HoldTurns(i, i + 1);
        return i;
    }

    /// <summary>A move of the current block, by its number in it, is an arc.</summary>
    public void AddArc(int move, Arc arc)
    {
        _arcMoves.Add(move);
        _arcs.Add(arc);
    }

    /// <summary>Sets the rotary axes of the last move, in degrees, and of those after it.</summary>
    public void Turn(Vec3 turns)
    {
        Turns = turns;
        HoldTurns(Columns.Count - 1, Columns.Count);
    }

    /// <summary>Keeps the rotary axes where they are in some moves of the current block.</summary>
    public void HoldTurns(int from, int to)
    {
        if (Turns is { } turns) Buffers.Fill(Columns.Turns ??= new Vec3[Columns.Capacity], from, to, turns);
    }

    /// <summary>Other numbers for the layers of all moves so far.</summary>
    public void RenumberLayers(Func<int, int> numberOf)
    {
        for (var i = 0; i < _blocks.Count; i++) Replace(i, WithLayers(_blocks[i].Columns, numberOf));
        Columns = WithLayers(Columns, numberOf);
    }

    /// <summary>The arc of the last move, if any.</summary>
    public Arc? LastArc => _arcMoves.Count > 0 && _arcMoves[_arcMoves.Count - 1] == Columns.Count - 1 ? _arcs[_arcs.Count - 1] : null;

    /// <summary>Removes the moves so far, only while they fit into one block.</summary>
    public void Clear()
    {
        Columns.Count = 0;
        _arcMoves.Clear();
        _arcs.Clear();
        Columns.Turns = null;
        Turns = null;
    }

    public IReadOnlyList<ToolpathBlock> ToBlocks()
    {
        if (Columns.Count > 0)
        {
            if (Columns.Count < Columns.Capacity / 2) Columns = Columns.Copy(Columns.Count);
            Seal();
        }
        return _blocks;
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
        if (keeps) _blocks.Add(new ToolpathBlock(Columns, file));
        sums?.Add(Columns);
        _sealed += Columns.Count;
        Columns = new ToolpathColumns(0);
    }
}
