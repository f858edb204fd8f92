namespace Caterpillar.Toolpaths;

/// <summary>The source of the moves of a toolpath.</summary>
public enum MoveSource : byte
{
    /// <summary>Steps of the design, from 0.</summary>
    Steps,

    /// <summary>Lines of a G-code file, from 1.</summary>
    Lines,
}

/// <summary>A tool of a toolpath.</summary>
/// <param name="VolumePerE">mm³ per unit of E (π D²/4 for E in mm of filament, 1 for E in mm³). Null if a decoded file does not state it.</param>
public sealed record ToolpathTool(double? VolumePerE);

/// <summary>An event and the number of the move after it. After the last move, this is the number of moves.</summary>
public readonly record struct MoveEvent(int Move, PrinterEvent Event)
{
    /// <summary>Line of the file (from 1) or number of the step (from 0), see <see cref="Toolpath.Source"/>. −1 = none.</summary>
    public int Source { get; init; } = -1;

    // What happens, and when; not where it is stated.
    public bool Equals(MoveEvent other) => Move == other.Move && Equals(Event, other.Event);

    public override int GetHashCode() => Move;
}

/// <summary>
/// The moves and events of a machine in order, planned from steps or decoded from a file. Moves are stored as columns in shared blocks, so that millions of
/// moves fit into memory and an edit copies only the changed blocks. Immutable.
/// </summary>
public sealed class Toolpath
{
    private readonly ToolpathBlock[] _blocks;
    private readonly int[] _firsts;
    private readonly MoveEvent[] _events;
    private readonly Layer[] _layers;
    private readonly ToolpathTool[] _tools;
    private readonly Lazy<ToolpathTotals> _totals;

    internal Toolpath(
        IEnumerable<ToolpathBlock> blocks, IEnumerable<Layer> layers, IEnumerable<MoveEvent> events, IEnumerable<ToolpathTool> tools, Vec3? start,
            MoveSource source, IReadOnlyList<SourceLocation?>? places = null)
    {
        _blocks = blocks.Where(b => b.Count > 0).ToArray();
        _firsts = new int[_blocks.Length];
        for (var i = 0; i < _blocks.Length; i++)
        {
            _firsts[i] = Count;
            Count += _blocks[i].Count;
        }
        _layers = layers.ToArray();
        _events = events.ToArray();
        _tools = tools.ToArray();
        Start = start;
        Source = source;
        Places = places ?? [];
        _totals = new(() => ToolpathSums.Of(this).ToTotals(_tools));
    }

    /// <summary>Number of moves.</summary>
    public int Count { get; }

    /// <summary>The moves in shared blocks, in order.</summary>
    public IReadOnlyList<ToolpathBlock> Blocks => _blocks;

    /// <summary>The layers of the moves, in order of first appearance.</summary>
    public IReadOnlyList<Layer> Layers => _layers;

    /// <summary>The events, ascending by move.</summary>
    public IReadOnlyList<MoveEvent> Events => _events;

    /// <summary>The tools by number.</summary>
    public IReadOnlyList<ToolpathTool> Tools => _tools;

    /// <summary>Position of the head before the first move, mm. Null if a decoded file does not state it (the moves then start at the origin).</summary>
    public Vec3? Start { get; }

    /// <summary>The meaning of <see cref="Move.Source"/>.</summary>
    public MoveSource Source { get; }

    /// <summary>Place of each step in the design. Empty if unknown, or null for an unknown step.</summary>
    internal IReadOnlyList<SourceLocation?> Places { get; }

    /// <summary>The sums over its moves, which are added up when they are first used.</summary>
    internal ToolpathTotals Totals => _totals.Value;

    /// <summary>A move by its number.</summary>
    public Move this[int index]
    {
        get
        {
            if (index < 0 || index >= Count) throw new ArgumentOutOfRangeException(nameof(index));
            var block = BlockOf(index);
            return Gather(block, index - _firsts[block]);
        }
    }

    /// <summary>True if moves have rotary words (A, B, C).</summary>
    public bool HasTurns => Array.Exists(_blocks, b => b.HasTurns);

    /// <summary>Rotary words A, B and C at the end of a move, degrees. Null if neither the move nor the moves around it have any.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The toolpath has no move with this number.</exception>
    public Vec3? TurnsOf(int move)
    {
        if (move < 0 || move >= Count) throw new ArgumentOutOfRangeException(nameof(move));
        var block = BlockOf(move);
        var (c, i) = (_blocks[block].Columns, move - _firsts[block]);
        return c.Turns?[i];
    }

    /// <summary>The same; zero where there are none, and before the first move.</summary>
    internal Vec3 WordsAt(int move) => move >= 0 && TurnsOf(move) is { } words ? words : Vec3.Zero;

    /// <summary>All moves in order. The columns of the blocks are faster.</summary>
    public IEnumerable<Move> Moves()
    {
        for (var block = 0; block < _blocks.Length; block++)
        {
            for (var i = 0; i < _blocks[block].Count; i++) yield return Gather(block, i);
        }
    }

    /// <summary>
    /// Place of a move of a planned toolpath in the design: script and line, or curve file and entry, otherwise object and layer. Null if unknown.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The toolpath has no move with this number.</exception>
    public SourceLocation? PlaceOf(int move)
    {
        if (move < 0 || move >= Count) throw new ArgumentOutOfRangeException(nameof(move));
        var block = BlockOf(move);
        var columns = _blocks[block].Columns;
        var i = move - _firsts[block];
        if (PlaceOfStep(columns.Source[i]) is not { } place) return Source == MoveSource.Steps ? PlaceOfLayer(columns.Layer[i]) : null;
        return columns.Line is { } lines && lines[i] > 0 ? place with { Line = lines[i] } : place;
    }

    /// <summary>Place of a step in the design. Null if unknown.</summary>
    internal SourceLocation? PlaceOfStep(int step) => Source == MoveSource.Steps && step >= 0 && step < Places.Count ? Places[step] : null;

    /// <summary>The object and the number of a layer. Null = no layer.</summary>
    internal SourceLocation? PlaceOfLayer(int layer)
        => layer < 0 || layer >= Layers.Count ? null
            : new SourceLocation(Layers[layer].Object is { Length: > 0 } name ? name : null, Layer: Layers[layer].Index);

    /// <summary>Deposited volume of a move, mm³. Null if the volume per E of its tool is unknown.</summary>
    public double? VolumeOf(Move move) => VolumePerE(move.Tool) * move.Deposited;

    /// <summary>
    /// The bead of a printing move: its area in mm² from the deposited material, its height from the thickness of its layer. Null if the move does not print
    /// or the volume per E of its tool is unknown. Slicers assume a <see cref="BeadShape.Stadium"/>, Cura a <see cref="BeadShape.Rectangle"/>.
    /// </summary>
    public Bead? BeadOf(Move move)
    {
        if (move.Kind != MoveKind.Print || !(move.Length > 0) || VolumeOf(move) is not { } volume) return null;
        var area = volume / move.Length;
        var speed = move.Speed >= 0 && !double.IsInfinity(move.Speed) ? move.Speed : 0;
        return area >= 0 && !double.IsInfinity(area) ? new Bead(area, ThicknessOf(move.Layer), speed) : null;
    }

    /// <summary>Thickness of a layer, mm. 0 = unknown or no layer.</summary>
    internal double ThicknessOf(int layer) => layer >= 0 ? _layers[layer].Thickness : 0;

    /// <summary>mm³ per unit of E of a tool. Null if unknown.</summary>
    public double? VolumePerE(int tool) => tool >= 0 && tool < _tools.Length ? _tools[tool].VolumePerE : null;

    /// <summary>The same toolpath with other parts, for edits.</summary>
    internal Toolpath With(
        IEnumerable<ToolpathBlock>? blocks = null, IEnumerable<MoveEvent>? events = null, IEnumerable<Layer>? layers = null,
        IEnumerable<ToolpathTool>? tools = null)
        => new(blocks ?? _blocks, layers ?? _layers, events ?? _events, tools ?? _tools, Start, Source, Places);

    /// <summary>The same moves from another start, in layers of other heights.</summary>
    internal Toolpath With(Vec3? start, IEnumerable<Layer> layers) => new(_blocks, layers, _events, Tools, start, Source, Places);

    /// <summary>Number of the first event at or after a move.</summary>
    internal int FirstEventOf(int move) => Search.First(0, _events.Length, (_events, move), static (s, i) => s._events[i].Move >= s.move);

    /// <summary>Number of the first move of a block.</summary>
    internal int FirstOf(int block) => _firsts[block];

    /// <summary>Position of the head before a block.</summary>
    internal Vec3 StartOf(int block)
    {
        if (block == 0) return Start ?? Vec3.Zero;
        var columns = _blocks[block - 1].Columns;
        var last = columns.Count - 1;
        return new Vec3(columns.X[last], columns.Y[last], columns.Z[last]);
    }

    /// <summary>The block of a move.</summary>
    internal int BlockOf(int index)
    {
        var at = Array.BinarySearch(_firsts, index);
        return at >= 0 ? at : ~at - 1;
    }

    private Move Gather(int block, int i)
    {
        var c = _blocks[block].Columns;
        var start = i > 0 ? new Vec3(c.X[i - 1], c.Y[i - 1], c.Z[i - 1]) : StartOf(block);
        var end = new Vec3(c.X[i], c.Y[i], c.Z[i]);
        Arc? arc = c.TryGetArc(i, out var geometry) ? geometry : null;
        return new Move(_firsts[block] + i, start, end, c.E[i], c.Deposited[i], c.Speed[i], c.Kind[i], c.Role[i], c.Layer[i], c.Tool[i], c.Source[i], arc);
    }
}
