namespace Caterpillar.Toolpaths;

/// <summary>
/// Maps moves of a toolpath, run by run. Unaffected blocks are shared. The material of extrusions follows their length. A travel move to a mapped extrusion
/// ends at its new start. Moves in place happen at the new position of the head.
/// </summary>
/// <param name="toolpath">The toolpath.</param>
/// <param name="mapped">The moves whose ends are mapped.</param>
/// <param name="map">The map.</param>
/// <param name="tolerance">Tolerance of arcs that become chords, mm.</param>
internal sealed class ToolpathMapper(Toolpath toolpath, MoveSet mapped, RunMap map, double tolerance)
{
    private const int LongestLocalRun = 2048;
    private readonly List<ToolpathBlock> _blocks = [];
    private readonly List<MoveEvent> _events = [];
    private ToolpathBuilder? _editor;
    private MoveRun? _run;
    private int _piece;
    private Vec3 _position;
    private int _made;
    private int _nextEvent;

    /// <summary>The mapped toolpath, which begins at <paramref name="start"/>.</summary>
    public Toolpath Run(Vec3 start, CancellationToken cancel = default)
    {
        _position = start;
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            cancel.ThrowIfCancellationRequested();
            var first = toolpath.FirstOf(block);
            var count = toolpath.Blocks[block].Count;
            if (AddWhole(block, first, count)) continue;
            _editor = ToolpathBuilder.At(toolpath, first);
            for (var i = first; i < first + count; i++)
            {
                _editor.Line = toolpath.Blocks[block].Columns.Line?[i - first] ?? 0;
                Step(toolpath[i]);
                _editor.Turn(toolpath.Blocks[block].Columns, i - first);
            }
            _blocks.AddRange(_editor.ToBlocks());
        }
        Events(int.MaxValue);
        return toolpath.With(_blocks, _events);
    }

    // A block of which no move changes, or none stays, at once.
    private bool AddWhole(int block, int first, int count)
    {
        var source = toolpath.Blocks[block];
        var (start, position, image) = (toolpath.StartOf(block), _position, map);
        var whole = _run is null && position == start && !IsTouched(first, count) ? source
            : map.IsLocal && mapped.Find(false, first, first + count) == first + count ? source.Edited(c => image.MapBlock(c, start, position)) : null;
        if (whole is null) return false;
        Events(first + count, first);
        _blocks.Add(whole);
        _made += count;
        _position = new Vec3(whole.Columns.X[count - 1], whole.Columns.Y[count - 1], whole.Columns.Z[count - 1]);
        _run = null;
        return true;
    }

    // The last move of a block may lead to an extrusion of the next.
    private bool IsTouched(int first, int count) => mapped.Find(true, first, first + count) < first + count || LeadsToRun(toolpath[first + count - 1]);

    private bool LeadsToRun(Move move)
        => !mapped[move.Index] && move.Index + 1 < toolpath.Count && mapped[move.Index + 1] && move.Kind != MoveKind.Print && !move.IsInPlace;

    private void Step(Move move)
    {
        Events(move.Index);
        if (toolpath.HomeOf(move) is { } home)
        {
            Add(move, home.Home(_position), 0, 0, move.Speed, null);
            return;
        }
        if (mapped[move.Index])
        {
            _run ??= RunFrom(move.Index);
            for (; _piece < _run.Moves.Count && _run.Moves[_piece] == move.Index; _piece++) Piece(move, _run, _piece);
            if (_piece == _run.Moves.Count) _run = null;
            return;
        }
        var end = move.End;
        if (LeadsToRun(move))
        {
            _run = RunFrom(move.Index + 1);
            end = _run.Points[0];
        }
        Unmapped(move, end);
    }

    private MoveRun RunFrom(int first)
    {
        var run = new MoveRun(toolpath, toolpath[first].Start);
        var last = map.IsLocal ? Math.Min(first + LongestLocalRun, toolpath.Count) : toolpath.Count;
        for (var i = first; i < last && mapped[i]; i++) map.Divide(toolpath[i], run);
        map.Map(run);
        _piece = 0;
        return run;
    }

    private void Piece(Move move, MoveRun run, int piece)
    {
        var arc = run.Arcs[piece];
        var to = run.Points[piece + 1];
        var share = run.Shares[piece];
        var deposited = move.Deposited * share;
        // The extrusion before is not mapped: the travel starts at its end.
        if (arc is not null && _position != run.Points[piece]) arc = null;
        if (move.Kind == MoveKind.Print && move.Length > 0)
            deposited = move.Deposited / move.Length * run.Flows[piece] * (arc?.Length(_position, to) ?? _position.DistanceTo(to));
        Add(move, to, deposited + Rest(move, share, piece == 0 || run.Moves[piece - 1] != move.Index), deposited, run.Speeds[piece], arc);
    }

    // Its start or end may have moved with an extrusion. Vertical moves stay vertical.
    private void Unmapped(Move move, Vec3 end)
    {
        if (end == move.End && _position != move.Start && move.Kind != MoveKind.Print && move.Start.X == end.X && move.Start.Y == end.Y)
            end = _position.WithZ(end.Z);
        if (_position == move.Start && end == move.End)
        {
            Add(move, end, move.E, move.Deposited, move.Speed, move.Arc);
            return;
        }
        var chords = move.Arc is { } arc ? arc.ChordCount(move.Start, move.End, tolerance) : 1;
        for (var k = 1; k <= chords; k++)
        {
            var to = k == chords ? end : move.PointAt((double)k / chords);
            var deposited = move.Deposited / chords;
            if (move.Kind == MoveKind.Print && move.Length > 0) deposited = move.Deposited / move.Length * _position.DistanceTo(to);
            Add(move, to, deposited + Rest(move, 1.0 / chords, k == 1), deposited, move.Speed, null);
        }
    }

    // The part of E that is not deposited: an extrusion that restores does so first; other moves spread it over their length.
    private static double Rest(Move move, double share, bool isFirst)
    {
        var rest = move.E - move.Deposited;
        return move.Deposited == 0 ? rest * share : isFirst ? rest : 0;
    }

    private void Add(Move move, Vec3 end, double e, double deposited, double speed, Arc? arc)
    {
        _editor!.Add(end, e, deposited, speed, move.Kind, move.Role, move.Layer, move.Tool, move.Source, arc);
        _position = end;
        _made++;
    }

    // Events up to a move; those of a shared block stay at their moves.
    private void Events(int before, int first = int.MaxValue)
    {
        for (; _nextEvent < toolpath.Events.Count && toolpath.Events[_nextEvent].Move <= before; _nextEvent++)
            _events.Add(toolpath.Events[_nextEvent] with { Move = _made + Math.Max(toolpath.Events[_nextEvent].Move - first, 0) });
    }
}
