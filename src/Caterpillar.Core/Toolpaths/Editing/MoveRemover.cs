namespace Caterpillar.Toolpaths;

/// <summary>
/// Removes moves from a toolpath and repairs the cuts. It adds travel moves to the next extrusion, and retractions of each tool by E or firmware (G10, G11).
/// Events and homing moves stay. A dwell is removed with its event. Blocks without cuts are shared.
/// </summary>
/// <param name="toolpath">The toolpath.</param>
/// <param name="removed">The moves to remove.</param>
internal sealed class MoveRemover(Toolpath toolpath, MoveSet removed)
{
    private const double NoChange = 1e-9;
    private const int RoomForRepairs = 64;
    private readonly List<ToolpathBlock> _blocks = [];
    private readonly List<MoveEvent> _events = [];
    private readonly SortedDictionary<int, Balance> _tools = [];
    private (int Tool, Balance? Balance) _last = (-1, null);
    private ToolpathBuilder? _editor;
    private Vec3 _position = toolpath.Start ?? Vec3.Zero;
    private double _travelSpeed;
    private double _retractSpeed;
    private double _top = double.NegativeInfinity;
    private int _made;
    private int _nextEvent;

    public Toolpath Run(CancellationToken cancel = default)
    {
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            cancel.ThrowIfCancellationRequested();
            var first = toolpath.FirstOf(block);
            var columns = toolpath.Blocks[block].Columns;
            if (toolpath.StartOf(block) == _position && IsBalanced() && removed.Find(true, first, first + columns.Count) == first + columns.Count)
            {
                for (var i = 0; i < columns.Count; i++)
                {
                    if (!IsPlain(columns, i)) Kept(toolpath[first + i]);
                    else _top = Math.Max(_top, columns.Z[i]);
                }
                _position = toolpath[first + columns.Count - 1].End;
                // The event of a dwell that begins the next block is removed with it.
                Events(first + columns.Count - 1, first);
                _blocks.Add(toolpath.Blocks[block]);
                _made += columns.Count;
                continue;
            }
            var size = RoomForRepairs;
            for (var i = 0; i < columns.Count; i++) size += removed[first + i] ? 0 : 1;
            _editor = ToolpathBuilder.At(toolpath, first, size);
            for (var i = 0; i < columns.Count; i++)
            {
                // Events before such a move come with the next one.
                if (!removed[first + i] || !IsPlain(columns, i)) Step(toolpath[first + i], block, i);
                if (!removed[first + i] && columns.Kind[i] == MoveKind.Print) i = Follow(columns, first, i);
            }
            _blocks.AddRange(_editor.ToBlocks());
        }
        Events(int.MaxValue);
        return toolpath.With(_blocks, _events);
    }

    // A printing move after which everything is as before, but for the position.
    private bool IsPlain(ToolpathColumns columns, int i) => columns.Kind[i] == MoveKind.Print && columns.E[i] >= 0 && !Of(columns.Tool[i]).IsRetracted;

    // Adds the extrusions after a kept one that need no repair, at once. Returns the last.
    private int Follow(ToolpathColumns columns, int first, int last)
    {
        var end = last + 1;
        var next = _nextEvent < toolpath.Events.Count ? toolpath.Events[_nextEvent].Move - first : int.MaxValue;
        while (end < Math.Min(columns.Count, next) && !removed[first + end] && columns.Tool[end] == columns.Tool[last] && IsPlain(columns, end)) end++;
        if (end == last + 1) return last;
        _editor!.Add(columns, last + 1, end);
        for (var i = last + 1; i < end; i++) _top = Math.Max(_top, columns.Z[i]);
        _made += end - last - 1;
        _position = new Vec3(columns.X[end - 1], columns.Y[end - 1], columns.Z[end - 1]);
        return end - 1;
    }

    private void Step(Move move, int block, int i)
    {
        _editor!.Line = toolpath.Blocks[block].Columns.Line?[i] ?? 0;
        if (toolpath.HomeOf(move) is { } home)
        {
            Events(move.Index);
            var there = home.Home(_position);
            if (there != _position) Add(there, 0, 0, move.Speed, MoveKind.Travel, move.Role, move, move.Source, null);
            _position = there;
            return;
        }
        if (removed[move.Index])
        {
            Of(move.Tool).Before(move);
            Speeds(move);
            if (move.Kind == MoveKind.Dwell) TakeDwell(move.Index);
            else Events(move.Index);
            return;
        }
        var dwell = move.Kind == MoveKind.Dwell ? TakeDwell(move.Index) : null;
        Events(move.Index);
        Repair(move);
        if (dwell is { } waits) _events.Add(waits with { Move = _made });
        _editor.Add(toolpath.Blocks[block].Columns, i, i + 1);
        _made++;
        Kept(move);
    }

    private void Kept(Move move)
    {
        Speeds(move);
        var tool = Of(move.Tool);
        tool.Before(move);
        tool.Now(move);
        _position = move.End;
        if (move.Kind == MoveKind.Print) _top = Math.Max(_top, move.End.Z);
    }

    private void Speeds(Move move)
    {
        if (move.Kind == MoveKind.Travel && move.Speed > 0) _travelSpeed = move.Speed;
        if (move.Kind == MoveKind.Retract && move.E < 0 && move.Speed > 0) _retractSpeed = move.Speed;
    }

    // Retracted before the travel, deretracted at its end: a travel carries over what is still retracted.
    private void Repair(Move move)
    {
        var tool = Of(move.Tool);
        var isTravel = move.Kind == MoveKind.Travel;
        if (tool.Missing > NoChange) Pull(move, tool, tool.Missing);
        if (tool.MissesFirmware) Firmware(move, tool, MoveKind.Retract);
        // A travel may start anywhere; everything else at its old start.
        if (!isTravel || move.Arc is not null) Travel(move);
        if (isTravel) return;
        if (tool.Missing < -NoChange) Pull(move, tool, tool.Missing);
        if (tool.HasFirmwareLeft) Firmware(move, tool, MoveKind.Deretract);
    }

    private void Travel(Move move)
    {
        var to = move.Start;
        if (to.DistanceTo(_position) <= NoChange) return;
        var speed = _travelSpeed > 0 ? _travelSpeed : move.Speed;
        // Up before across, above all that is printed, and across before down.
        var isAcross = Math.Abs(to.X - _position.X) + Math.Abs(to.Y - _position.Y) > NoChange;
        var height = Math.Max(Math.Max(to.Z, _position.Z), isAcross ? _top : double.NegativeInfinity);
        foreach (var stop in new[] { _position.WithZ(height), to.WithZ(height), to })
        {
            if (stop == _position) continue;
            Add(stop, 0, 0, speed, MoveKind.Travel, Role.Unspecified, move, -1, null);
            _position = stop;
        }
    }

    private void Pull(Move move, Balance tool, double amount)
    {
        var speed = _retractSpeed > 0 ? _retractSpeed : 30;
        Add(_position, -amount, 0, speed, amount > 0 ? MoveKind.Retract : MoveKind.Deretract, Role.Unspecified, move, -1, null);
        tool.Level();
    }

    private void Firmware(Move move, Balance tool, MoveKind kind)
    {
        Add(_position, 0, 0, _retractSpeed, kind, Role.Unspecified, move, -1, null);
        tool.LevelFirmware();
    }

    private void Add(Vec3 end, double e, double deposited, double speed, MoveKind kind, Role role, Move like, int source, Arc? arc)
    {
        _editor!.Add(end, e, deposited, speed, kind, role, like.Layer, like.Tool, source, arc);
        _made++;
    }

    // Events up to a move; those of an unchanged block stay at their moves.
    private void Events(int before, int first = int.MaxValue)
    {
        for (; _nextEvent < toolpath.Events.Count && toolpath.Events[_nextEvent].Move <= before; _nextEvent++)
        {
            var what = toolpath.Events[_nextEvent];
            _events.Add(what with { Move = _made + Math.Max(what.Move - first, 0) });
        }
    }

    // The event of a dwell moves with the dwell.
    private MoveEvent? TakeDwell(int move)
    {
        MoveEvent? dwell = null;
        Events(move - 1);
        for (; _nextEvent < toolpath.Events.Count && toolpath.Events[_nextEvent].Move == move; _nextEvent++)
        {
            if (dwell is null && toolpath.Events[_nextEvent].Event is DwellEvent) dwell = toolpath.Events[_nextEvent];
            else _events.Add(toolpath.Events[_nextEvent] with { Move = _made });
        }
        return dwell;
    }

    private Balance Of(int tool)
    {
        if (_last.Balance is { } known && _last.Tool == tool) return known;
        if (!_tools.TryGetValue(tool, out var balance)) _tools.Add(tool, balance = new Balance());
        _last = (tool, balance);
        return balance;
    }

    private bool IsBalanced() => _tools.Values.All(t => Math.Abs(t.Missing) <= NoChange && !t.MissesFirmware && !t.HasFirmwareLeft);

    /// <summary>The retraction of a tool, for all moves and for the kept moves.</summary>
    private sealed class Balance
    {
        private double _before;
        private double _now;
        private bool _firmwareBefore;
        private bool _firmwareNow;

        public bool IsRetracted => _before > 0 || _now > 0;

        public double Missing => _before - _now;

        public bool MissesFirmware => _firmwareBefore && !_firmwareNow;

        public bool HasFirmwareLeft => !_firmwareBefore && _firmwareNow;

        public void Before(Move move) => Take(move, ref _before, ref _firmwareBefore);

        public void Now(Move move) => Take(move, ref _now, ref _firmwareNow);

        public void Level() => _now = _before;

        public void LevelFirmware() => _firmwareNow = _firmwareBefore;

        private static void Take(Move move, ref double retracted, ref bool firmware)
        {
            if (move.E < 0) retracted -= move.E;
            else if (move.E > 0) retracted = Math.Max(retracted - move.E, 0);
            else if (move.Kind == MoveKind.Retract) firmware = true;
            else if (move.Kind == MoveKind.Deretract) firmware = false;
        }
    }
}
