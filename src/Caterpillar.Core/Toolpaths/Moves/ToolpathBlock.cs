namespace Caterpillar.Toolpaths;

/// <summary>
/// Up to <see cref="Capacity"/> moves as columns. Blocks are immutable and shared: an edit copies only the changed columns of the changed blocks.
/// </summary>
public sealed class ToolpathBlock
{
    /// <summary>Maximum number of moves in one block.</summary>
    public const int Capacity = 65536;

    /// <summary>Maximum number of moves in one block if other threads wait for each block.</summary>
    internal const int FollowedSize = 4096;

    /// <summary>Memory of a move in bytes, with its share of arcs and lists.</summary>
    public const int BytesPerMove = 72;

    private const long BytesInMemory = 192L << 20;
    private readonly ToolpathColumns? _columns;
    private readonly Page<ToolpathColumns>? _page;
    private readonly ToolpathBlock? _source;
    private readonly Func<ToolpathColumns, ToolpathColumns?>? _edit;
    private BlockSummary? _summary;

    /// <param name="columns">The columns. The block owns them.</param>
    /// <param name="file">Keeps them; null = in memory.</param>
    internal ToolpathBlock(ToolpathColumns columns, PageFile<ToolpathColumns>? file = null)
    {
        (Count, File) = (columns.Count, file);
        HasTurns = columns.Turns is not null;
        if (file is null) _columns = columns;
        else _page = file.Add(columns);
    }

    // Nothing but the edit is kept; it is repeated when its source was read again.
    private ToolpathBlock(ToolpathBlock source, ToolpathColumns? columns, Func<ToolpathColumns, ToolpathColumns?> edit)
        => (Count, File, HasTurns, _source, _columns, _edit) = (source.Count, source.File, source.HasTurns, source, columns, edit);

    /// <summary>Number of moves.</summary>
    public int Count { get; }

    /// <summary>Keeps the columns; null = in memory. Edits keep the edited block there, too.</summary>
    internal PageFile<ToolpathColumns>? File { get; }

    internal bool HasTurns { get; }

    internal ToolpathColumns Columns => _columns ?? _page?.Value ?? _source!.Columns.ImageFor(this, _edit!);

    /// <summary>Its lines and layers.</summary>
    internal BlockSummary Summary => _source?.Summary ?? (_summary ??= new BlockSummary(Columns));

    /// <summary>A block with the same lines, layers and kinds, and other columns. Null where the edit gives none.</summary>
    internal ToolpathBlock? Edited(Func<ToolpathColumns, ToolpathColumns?> edit)
    {
        var source = Columns;
        if (edit(source) is not { } columns) return null;
        var block = new ToolpathBlock(this, File is null ? columns : null, edit);
        if (File is not null) source.ImageFor(block, _ => columns);
        return block;
    }

    /// <summary>A file for blocks. The latest are in memory, up to a quarter of a limit.</summary>
    internal static PageFile<ToolpathColumns> FileFor(MemoryLimit limit)
        => new(Math.Min(BytesInMemory, limit.Bytes / 4), columns => (long)columns.Capacity * BytesPerMove, ColumnBytes.Write, ColumnBytes.Read);
}

/// <summary>The columns of a block. Index i is the i-th move of the block. The creator of the block fills them. They never change afterwards.</summary>
internal sealed class ToolpathColumns(int capacity)
{
    public int Count;

    // End point, mm.
    public double[] X = Buffers.Unfilled<double>(capacity);
    public double[] Y = Buffers.Unfilled<double>(capacity);
    public double[] Z = Buffers.Unfilled<double>(capacity);

    // Commanded change of E and the part of it that is deposited, both in the unit of the tool.
    public double[] E = Buffers.Unfilled<double>(capacity);
    public double[] Deposited = Buffers.Unfilled<double>(capacity);

    // mm/s
    public double[] Speed = Buffers.Unfilled<double>(capacity);
    public MoveKind[] Kind = Buffers.Unfilled<MoveKind>(capacity);
    public Role[] Role = Buffers.Unfilled<Role>(capacity);
    public short[] Tool = Buffers.Unfilled<short>(capacity);

    // Index into Toolpath.Layers, or -1.
    public int[] Layer = Buffers.Unfilled<int>(capacity);

    // Line of the G-code file (from 1) or number of the step (from 0); -1 if there is none.
    public int[] Source = Buffers.Unfilled<int>(capacity);

    // Line of the script, from 1; 0 if unknown. Null if no move of the block has one.
    public int[]? Line;

    // Rotary axes A, B and C in degrees at the end of the move, if some move of the block has them.
    public Vec3[]? Turns;

    // Moves of the block that are arcs, ascending, and their geometry.
    public int[] ArcMoves = [];
    public Arc[] Arcs = [];

    // Blocks that are edits of this one, while both are used.
    private ConditionalWeakTable<ToolpathBlock, ToolpathColumns>? _images;

    public int Capacity => X.Length;

    /// <summary>The columns of an edited block, which are made once and kept as long as these.</summary>
    public ToolpathColumns ImageFor(ToolpathBlock block, Func<ToolpathColumns, ToolpathColumns?> edit)
        => LazyInitializer.EnsureInitialized(ref _images)!.GetValue(block, _ => edit(this)!);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool TryGetArc(int move, out Arc arc)
    {
        if (ArcMoves.Length > 0) return FindArc(move, out arc);
        arc = default;
        return false;
    }

    private bool FindArc(int move, out Arc arc)
    {
        var at = Array.BinarySearch(ArcMoves, move);
        arc = at >= 0 ? Arcs[at] : default;
        return at >= 0;
    }

    /// <summary>A copy that shares the columns. Those to be changed before it becomes a block are replaced.</summary>
    public ToolpathColumns Share()
    {
        var copy = (ToolpathColumns)MemberwiseClone();
        copy._images = null;
        return copy;
    }

    /// <summary>A copy with its own columns, to be changed before it becomes a block. With too little capacity for all, of the first moves.</summary>
    public ToolpathColumns Copy(int capacity)
    {
        var count = Math.Min(Count, capacity);
        var arcs = Array.BinarySearch(ArcMoves, count);
        if (arcs < 0) arcs = ~arcs;
        var copy = new ToolpathColumns(capacity) { ArcMoves = ArcMoves, Arcs = Arcs };
        if (arcs < ArcMoves.Length) (copy.ArcMoves, copy.Arcs) = (ArcMoves.Take(arcs).ToArray(), Arcs.Take(arcs).ToArray());
        copy.Append(this, 0, count);
        return copy;
    }

    /// <summary>Adds a run of moves of other columns, without their arcs, where there is room.</summary>
    public void Append(ToolpathColumns other, int from, int count)
    {
        Array.Copy(other.X, from, X, Count, count);
        Array.Copy(other.Y, from, Y, Count, count);
        Array.Copy(other.Z, from, Z, Count, count);
        Array.Copy(other.E, from, E, Count, count);
        Array.Copy(other.Deposited, from, Deposited, Count, count);
        Array.Copy(other.Speed, from, Speed, Count, count);
        Array.Copy(other.Kind, from, Kind, Count, count);
        Array.Copy(other.Role, from, Role, Count, count);
        Array.Copy(other.Tool, from, Tool, Count, count);
        Array.Copy(other.Layer, from, Layer, Count, count);
        Array.Copy(other.Source, from, Source, Count, count);
        Line = Appended(Line, other.Line, from, count);
        Turns = Appended(Turns, other.Turns, from, count);
        Count += count;
    }

    /// <summary>Columns with new end points and, if asked for, new heights and amounts to fill in. The rest is shared. For blocks of straight moves.</summary>
    public ToolpathColumns WithGeometry(bool newHeights, bool newAmounts)
    {
        var copy = Share();
        (copy.X, copy.Y) = (Buffers.Unfilled<double>(Count), Buffers.Unfilled<double>(Count));
        if (newHeights) copy.Z = Buffers.Unfilled<double>(Count);
        if (newAmounts) (copy.E, copy.Deposited) = (Buffers.Unfilled<double>(Count), Buffers.Unfilled<double>(Count));
        return copy;
    }

    private T[]? Appended<T>(T[]? column, T[]? other, int from, int count)
    {
        if (other is null) return column;
        column ??= new T[Capacity];
        Array.Copy(other, from, column, Count, count);
        return column;
    }
}
