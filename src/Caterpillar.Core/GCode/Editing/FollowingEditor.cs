namespace Caterpillar.GCode;

/// <summary>
/// Edits a file while it is decoded: the moves up to the latest extrusion of a layer, since travel moves lead to the extrusion after them, then the chunks
/// whose moves are all edited.
/// </summary>
/// <param name="edit">Edits the next moves. The last of those before them, if any, ends at a position.</param>
/// <param name="before">The file as it was decoded before, without moves, if the edit changes heights. Null = not decoded before.</param>
/// <param name="after">Its toolpath after the edit, without moves.</param>
internal sealed class FollowingEditor(Func<Toolpath, Vec3?, Toolpath> edit, DecodedGCode? before = null, Toolpath? after = null)
{
    private readonly IEnumerable<Layer> _layers = before?.Toolpath.Layers ?? [new(0, 0, 0, "")];
    private readonly Queue<(ChunkParser Parsed, Checkpoint Before)> _chunks = new();
    private readonly List<ToolpathBlock> _moves = [];
    private readonly List<MoveEvent> _events = [];
    private readonly List<ToolpathBlock> _read = [];
    private readonly List<ToolpathBlock> _edited = [];
    private Vec3? _begin, _start, _position;
    private int _first;

    /// <summary>The sums of the edited moves.</summary>
    public ToolpathSums Sums { get; } = new();

    /// <summary>What was changed.</summary>
    public ToolpathDifference Difference { get; private set; } = new(0, 0, 0, 0, 0);

    /// <summary>The file as it was decoded before, and its toolpath after the edit.</summary>
    public (DecodedGCode? Before, Toolpath? After) Whole => (before, after);

    /// <summary>Writes a chunk, given moves, among them its own, and what became of them.</summary>
    public Action<ChunkParser, Checkpoint, Toolpath, Toolpath>? Writer { private get; set; }

    /// <summary>Takes the next chunk.</summary>
    public void Take(ChunkParser parsed, Checkpoint before) => _chunks.Enqueue((parsed, before));

    /// <summary>Takes the next moves.</summary>
    public void Take(DecodedBlock block)
    {
        if (_first == 0) _begin = _start = block.Start;
        _events.AddRange(block.Events);
        var (c, count) = (block.Columns, block.Columns.Count);
        while (count > 0 && !(c.Kind[count - 1] == MoveKind.Print && c.Layer[count - 1] >= 0)) count--;
        if (count > 0)
        {
            _moves.Add(new ToolpathBlock(count < c.Count ? c.Copy(count) : c));
            Edit();
        }
        var rest = new ToolpathBuilder(MoveSource.Lines, null);
        rest.Add(c, count, c.Count);
        _moves.AddRange(rest.ToBlocks());
    }

    /// <summary>Edits and writes the rest.</summary>
    public void Finish()
    {
        if (_moves.Count > 0) Edit();
        while (_chunks.Count > 0) Write();
    }

    private void Edit()
    {
        var toolpath = new Toolpath(_moves, _layers, _events.Select(e => e with { Move = e.Move - _first }), [], _start, MoveSource.Lines);
        if (_first == 0) Sums.Position = _start ?? Vec3.Zero;
        var edited = edit(toolpath, _position);
        foreach (var block in edited.Blocks) Sums.Add(block.Columns);
        Difference += ToolpathDifference.Of(toolpath, edited);
        var last = toolpath[toolpath.Count - 1];
        (_start, _position) = (last.End, Sums.Position);
        _first += toolpath.Count;
        _events.RemoveAll(e => e.Move < _first);
        _read.AddRange(toolpath.Blocks);
        _edited.AddRange(edited.Blocks);
        _moves.Clear();
        while (_chunks.Peek() is var (parsed, start) && start.Line + parsed.Count < last.Source) Write();
    }

    private void Write()
    {
        var (parsed, start) = _chunks.Dequeue();
        Writer!(parsed, start, Latest(_read), Latest(_edited));
        Forget(_read, start.Line + parsed.Count);
        Forget(_edited, start.Line + parsed.Count);
    }

    private Toolpath Latest(List<ToolpathBlock> blocks) => new(blocks, [], [], [], _begin, MoveSource.Lines);

    // Up to a line; the last of them stays, for the next one begins where it ends.
    private static void Forget(List<ToolpathBlock> blocks, int line)
        => blocks.RemoveRange(0, Math.Max(blocks.FindLastIndex(b => b.Columns.Source[b.Count - 1] <= line), 0));
}
