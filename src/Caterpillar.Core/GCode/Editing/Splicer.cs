namespace Caterpillar.GCode;

/// <summary>
/// Writes a decoded file with changes. One machine reads the original file, another one the written lines. A line is kept if it makes the right move from the
/// state after the written lines. Otherwise its words change, or a line with the missing mode comes before it. Unchanged chunks are copied whole.
/// </summary>
internal sealed class Splicer : IDisposable
{
    // Below this no other thread is worth its start.
    private const int FewChunks = 3;

    private readonly SpliceContext _context;
    private readonly SplicePlan _plan;
    private readonly SpliceTasks _tasks;
    private readonly CodeReplacement _code;
    private readonly CommentBuffer _comments;
    private readonly CommentScale _scale;
    private readonly PartFigures _figures;
    private readonly OutlineFigures _outlines;
    private readonly FlavorComments _flavor;
    private readonly MoveWriter _moves;
    private readonly PlainMoves _plain;
    private readonly OtherLines _others;
    private readonly int _threads;
    private bool _synced = true;
    private int _next;

    /// <summary>Prepares to write a decoded file with the moves of an edited toolpath, or for a target.</summary>
    public Splicer(DecodedGCode decoding, Toolpath edited, SplicePlan plan, Stream stream, ConvertTarget? target = null, EditOptions? options = null)
    {
        options ??= new EditOptions();
        _threads = decoding.Checkpoints.Length is > 0 and < FewChunks ? 1 : options.Threads > 0 ? options.Threads : Environment.ProcessorCount;
        var style = LineStyle.Of(decoding.Document!).With(target?.Options.DecimalsXyz, target?.Options.DecimalsE, target?.Options.DecimalsF);
        _context = new SpliceContext(decoding, target, style, new SplicedText(stream, style, _threads > 1));
        _plan = plan;
        _tasks = new SpliceTasks(_context, plan, new MoveCursor(edited));
        _comments = new CommentBuffer(_context);
        _flavor = new FlavorComments(decoding, target);
        _scale = new CommentScale(decoding.Toolpath, edited);
        _figures = new PartFigures(decoding.Toolpath, edited, options.Cuts.Count > 0);
        _code = new CodeReplacement(_context, options, plan, _figures);
        _outlines = new OutlineFigures(decoding, edited);
        if (_outlines.IsActive) plan.Touch(1, decoding.PrintLines.First);
        if (_scale.ChangesLayers || _figures.IsActive) plan.Touch(1, int.MaxValue);
        var conversion = new MoveConversion(_context);
        _moves = new MoveWriter(_context, conversion);
        _plain = new PlainMoves(_context, _tasks, _comments, _moves, options.GeneralPath);
        _others = new OtherLines(_context, conversion, options.Start is not null);
    }

    public DiagnosticList Diagnostics => _context.Diagnostics;

    public void Run(IProgress<double>? progress, CancellationToken cancel)
    {
        var chunks = _context.Decoding.Document!.Chunks;
        void Next(Lazy<ChunkParser> parsed, long done)
        {
            Write(chunks[_next], _context.Decoding.Checkpoints[_next], parsed, Changes(_next));
            progress?.Report((double)_next / chunks.Count);
        }
        ChunkPipeline.Run(chunks, _context.Decoding.Axis.Letter, _threads, Changes, Next, cancel);
        Finish();
    }

    /// <summary>Writes what becomes of the next chunk. A conversion needs only the state before the first, an edit its moves and what became of them.</summary>
    public void Write(ChunkParser parsed, Checkpoint before, Toolpath? moves, Toolpath? edited)
    {
        if (moves is not null && edited is not null)
        {
            _tasks.Continue(edited);
            _scale.Continue(moves, edited);
        }
        Write(parsed.Chunk!, before, new Lazy<ChunkParser>(() => parsed), true);
    }

    /// <summary>Writes what comes after the last chunk.</summary>
    public void Finish()
    {
        _comments.Keep();
        _tasks.TakeRest();
        if (_tasks.Tasks.Count > 0) _context.Text.CloseLine();
        Insert(0, _tasks.Tasks.Count);
        _code.WriteEnd();
        _others.Report();
        _context.Text.Finish();
    }

    public void Dispose() => _context.Text.Dispose();

    private bool Changes(int chunk)
    {
        var checkpoints = _context.Decoding.Checkpoints;
        var last = chunk + 1 < checkpoints.Length ? checkpoints[chunk + 1].Line : int.MaxValue;
        return _context.Target is not null || _plan.Changes(checkpoints[chunk].Line + 1, last);
    }

    private void Write(GCodeChunk chunk, Checkpoint before, Lazy<ChunkParser> parsed, bool changes)
    {
        var i = _next++;
        var edits = _context.Target is null;
        _context.Text.Begin(chunk.Text, chunk.Start);
        if (_synced && !changes && _context.Text.IsPlain)
        {
            _comments.Keep();
            _context.Text.Copy(chunk.Text, chunk.Start, chunk.End);
            return;
        }
        if (edits) _tasks.SkipTo(before.Line + 1);
        if (_synced)
        {
            _context.Read.Restore(before.State);
            if (edits || i == 0) _context.Written.Restore(before.State);
        }
        if (i == 0) Begin(chunk, TextEncoding.MarkLength(chunk));
        WriteLines(parsed.Value, before.Line);
        _synced = edits && IsInStep(before.Line + parsed.Value.Count);
    }

    private void Begin(GCodeChunk chunk, int mark)
    {
        _context.Text.Copy(chunk.Text, chunk.Start, chunk.Start + mark);
        if (_flavor.Statement is { } statement) _context.Text.AddOwn(TextEncoding.Encode(statement), statement.Length);
    }

    // From this line on, what is written is read as the file is.
    private bool IsInStep(int line)
    {
        var read = _context.Read.State;
        var written = _context.Written.State;
        var positionOfEMatters = !(read.Modes.RelativeE && written.Modes.RelativeE && line > _context.Decoding.LastModeLine);
        return read.ReadsLike(written, positionOfEMatters);
    }

    private void WriteLines(ChunkParser parsed, int before)
    {
        var (text, end) = (parsed.Chunk!.Text, parsed.Chunk.End);
        var (records, places) = (parsed.Records, parsed.Places);
        _plain.Refresh();
        for (var i = 0; i < parsed.Count; i++)
        {
            ref var record = ref records[i];
            var next = i + 1 < parsed.Count ? records[i + 1].Start : end;
            _context.Number = before + i + 1;
            if (places[i].Count > 0 && _plain.IsReady && (!_code.Changes || _code.IsOutside(before + i + 1))
                && _plain.Write(record, places[i], text, next, before + i + 1)) continue;
            WriteLine(new FileLine(text, record.Start, record.Op <= 1 ? LineEnds.Find(text, record.Start, next) : record.Aux, next));
            _plain.Refresh();
        }
    }

    private void WriteLine(FileLine line)
    {
        var number = _context.Number;
        if (_code.Changes) _code.WriteBefore(number);
        _context.Line.Scan(line.Text, line.Start, line.End);
        var moves = _context.Read.ReadLine(_context.Line, line.Text, line.End, out var commands);
        if (_code.CutOf(number) is { } cut) Skip(cut, line);
        else if (moves > 0 || commands > 0) WriteMotion(line, moves, commands);
        else if (_context.Line.Shape == LineShape.Empty) _comments.Add(Image(line));
        else WriteOther(line);
    }

    private void Skip(LineCut cut, FileLine line)
    {
        _tasks.SkipTo(_context.Number + 1);
        if (!cut.KeepsComments || _context.Line.Shape != LineShape.Empty) return;
        _comments.Add(Image(line));
        _comments.Cut();
    }

    private FileLine Image(FileLine line) => _flavor.Image(_figures.Image(_scale.Image(line, _context.Number), _context.Number));

    private void WriteOther(FileLine line)
    {
        _comments.Keep();
        InsertBeforeEvents();
        _others.Write(line, _outlines.Image(_figures.Image(line, _context.Number)));
    }

    private void WriteMotion(FileLine line, int moves, int commands)
    {
        _tasks.Take(moves);
        var own = _tasks.OwnMoves;
        if (moves > 0 && own == 0 && !_context.LineHomes)
        {
            _comments.Cut();
            Remove();
            return;
        }
        _comments.WriteCut();
        _comments.Keep();
        if (own == 0) InsertBeforeEvents();
        var tasks = _tasks.Tasks;
        var single = own == 1 && commands > 0 && _context.Line.Shape == LineShape.Code;
        var first = single || own == moves ? tasks.Count - own : tasks.Count;
        Insert(0, first);
        // A command that moves the head and does nothing else, as G61, may become moves.
        bool Travels() => !_context.LineHomes && tasks.Skip(first).All(t => t.Event is null && t.Move.Kind == MoveKind.Travel);
        if (own > 0 && !single && (commands > 0 || Travels()))
        {
            if (own == moves && _moves.Keeps(line, tasks, first)) return;
            _context.Text.Drop(_context.Line);
            Insert(first, tasks.Count);
        }
        else if (commands == 0) _others.Write(line, line);
        else if (single) _moves.WriteMove(line, tasks[tasks.Count - 1].Move);
        else _moves.WriteWithoutMove(line);
    }

    // Modes in a line whose move is cut out stay.
    private void Remove()
    {
        _context.Text.Drop(_context.Line);
        if (_context.Line.Shape == LineShape.Code) _context.WriteModes();
    }

    private void InsertBeforeEvents()
    {
        if (_context.Read.LastEvents.Count == 0) return;
        _tasks.TakeBeforeEvents();
        Insert(0, _tasks.Tasks.Count);
        _tasks.Clear();
    }

    // Tasks as lines of their own.
    private void Insert(int first, int end)
    {
        for (var i = first; i < end; i++)
        {
            var task = _tasks.Tasks[i];
            if (task.Event is { } what) _context.Event(what);
            else _moves.InsertMove(task.Move);
        }
    }
}
