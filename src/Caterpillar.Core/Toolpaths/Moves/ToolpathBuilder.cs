namespace Caterpillar.Toolpaths;

/// <summary>Builds a <see cref="Toolpath"/> from moves and events in order. Not thread-safe.</summary>
public sealed class ToolpathBuilder
{
    internal const int FirstSize = 1024;

    private readonly List<Layer> _layers = [];
    private readonly List<MoveEvent> _events = [];
    private readonly MoveSource _source;
    private readonly BlockCollector _moves = new(ToolpathBlock.Capacity, FirstSize);

    /// <summary>A builder that starts at a position in mm. Null if unknown.</summary>
    public ToolpathBuilder(MoveSource source, Vec3? start)
    {
        _source = source;
        Start = start;
        Position = start ?? Vec3.Zero;
    }

    /// <summary>Start of the first move, mm. Null if unknown.</summary>
    public Vec3? Start { get; }

    /// <summary>A builder for an edited toolpath from a move on, with room for so many at first. Rotary axes stay until a move turns them.</summary>
    internal static ToolpathBuilder At(Toolpath toolpath, int move, int size = FirstSize) => new(MoveSource.Lines, null)
    {
        Moves = new(ToolpathBlock.Capacity, size, toolpath.Blocks[toolpath.BlockOf(move)].File) { Turns = move > 0 ? toolpath.TurnsOf(move - 1) : null },
    };

    /// <summary>Position of the head after the moves so far, mm.</summary>
    public Vec3 Position { get; private set; }

    /// <summary>Memory limit for the moves.</summary>
    public MemoryLimit Memory { get; init; } = MemoryLimit.Default;

    /// <summary>Blocks of another size, or kept in a file.</summary>
    internal BlockCollector Moves
    {
        init => _moves = value;
    }

    /// <summary>Called for each full block, before the next move is added.</summary>
    internal Action? Filled { get; init; }

    /// <summary>Number of moves so far.</summary>
    public int Count => _moves.Count;

    /// <summary>Line of the script for the next moves, from 1. 0 = unknown.</summary>
    internal int Line { get; set; }

    /// <summary>Adds a layer and returns its index for moves.</summary>
    public int AddLayer(Layer layer)
    {
        _layers.Add(layer ?? throw new ArgumentNullException(nameof(layer)));
        return _layers.Count - 1;
    }

    /// <summary>Adds an event before the next move.</summary>
    public void AddEvent(PrinterEvent what, int source = -1)
        => _events.Add(new MoveEvent(Count, what ?? throw new ArgumentNullException(nameof(what))) { Source = source });

    /// <summary>Adds a move. For the parameters, see <see cref="Move"/>.</summary>
    /// <exception cref="DiagnosticException">The moves take more than <see cref="Memory"/>.</exception>
    public void Add(Vec3 end, double e, double deposited, double speed, MoveKind kind, Role role, int layer, int tool, int source, Arc? arc = null)
    {
        if (_moves.IsFull) Grow();
        var i = _moves.Add(end, e, deposited, speed, kind, role, layer, checked((short)tool), source);
        var c = _moves.Columns;
        if (Line > 0) (c.Line ??= new int[c.Capacity])[i] = Line;
        if (arc is { } geometry) _moves.AddArc(i, geometry);
        Position = end;
    }

    internal void Add(in Move move)
        => Add(move.End, move.E, move.Deposited, move.Speed, move.Kind, move.Role, move.Layer, move.Tool, move.Source, move.Arc);

    /// <summary>Adds a run of moves of some columns, with their rotary axes.</summary>
    internal void Add(ToolpathColumns columns, int from, int to)
    {
        if (from >= to) return;
        while (from < to)
        {
            if (_moves.IsFull) Grow();
            var c = _moves.Columns;
            var count = Math.Min(to - from, c.Capacity - c.Count);
            for (var i = from; i < from + count && columns.ArcMoves.Length > 0; i++)
            {
                if (columns.TryGetArc(i, out var arc)) _moves.AddArc(c.Count + i - from, arc);
            }
            c.Append(columns, from, count);
            if (columns.Turns is null) _moves.HoldTurns(c.Count - count, c.Count);
            from += count;
        }
        Turn(columns, to - 1);
        Position = new Vec3(columns.X[to - 1], columns.Y[to - 1], columns.Z[to - 1]);
    }

    /// <summary>Sets the rotary axes A, B and C of the last move added, in degrees.</summary>
    public void SetRotary(Vec3 turns)
    {
        var columns = _moves.Columns;
        (columns.Turns ??= new Vec3[columns.Capacity])[columns.Count - 1] = turns;
    }

    /// <summary>Sets the rotary axes of the last move, and of those after it, from a move of some columns.</summary>
    internal void Turn(ToolpathColumns columns, int move)
    {
        if (columns.Turns is { } turns && Count > 0) _moves.Turn(turns[move]);
    }

    internal IReadOnlyList<ToolpathBlock> ToBlocks() => _moves.ToBlocks();

    /// <summary>Returns the toolpath. Do not use the builder afterwards.</summary>
    public Toolpath Build(IEnumerable<ToolpathTool> tools) => Build(tools, null);

    /// <summary>The same, with the places of the steps in the design.</summary>
    internal Toolpath Build(IEnumerable<ToolpathTool> tools, IReadOnlyList<SourceLocation?>? places)
        => new(_moves.ToBlocks(), _layers, _events, tools, Start, _source, places);

    /// <summary>The toolpath of all full blocks. Later toolpaths begin with the same moves, layers and events.</summary>
    internal Toolpath SoFar(IEnumerable<ToolpathTool> tools) => new(_moves.Blocks, _layers, _events, tools, Start, _source);

    private void Grow()
    {
        if (_moves.Grow() is not { } full) return;
        if (_moves.IsInMemory)
            Memory.Check((double)(Count + full.Count) * ToolpathBlock.BytesPerMove, $"A toolpath of more than {NumberFormatter.Format(Count)} moves");
        Filled?.Invoke();
    }
}
