namespace Caterpillar.GCode;

/// <summary>Converts targets to moves: finds the kind of each move, counts it, and collects moves and events.</summary>
internal sealed partial class MoveRecorder(Machine machine, ExtrusionRule rule)
{
    // Beyond these a number is no length in mm: such a move is left out and reported.
    public const double LargestLength = 1e10;
    public const double LargestE = 1e9;
    private const int FirstSize = 64;
    private const double NoChange = InterpreterState.NoChange;
    private const double LargestSquare = LargestLength * LargestLength;

    private readonly InterpreterState _state = machine.State;
    private readonly Extruders _extruders = machine.Extruders;
    private readonly LineDiagnostics _diagnostics = machine.Diagnostics;
    private readonly DecodeCounters _counters = machine.Counters;
    private BlockCollector _moves = new(ToolpathBlock.Capacity, FirstSize);
    private Action<DecodedBlock>? _take;
    private ToolpathSums? _sums;
    private readonly List<MoveEvent> _events = [];
    private readonly bool _balance = rule == ExtrusionRule.Balance;
    private readonly bool _switched = machine.Axis == ExtrusionAxis.Switched;
    private double _lastPrintZ = double.NaN;
    private double _lastFlatZ = double.NaN;
    private bool _afterPrint;
    private Vec3? _start;
    private int _taken;

    public LayerCollector Layers { get; } = new();

    /// <summary>Role of the following extrusions.</summary>
    public Role Role { get; set; }

    /// <summary>True if G1 to G3 print without E.</summary>
    public bool PrintsWithoutE { get; } = machine.Axis == ExtrusionAxis.Switched || (machine.Axis == ExtrusionAxis.None && machine.Rules.PrintsWithoutE);

    public int Count => _moves.Count;

    /// <summary>The moves since the last <see cref="Clear"/>, or of the current block.</summary>
    public ToolpathColumns Columns => _moves.Columns;

    public IReadOnlyList<MoveEvent> Events => _events;

    /// <summary>The arc of the last move, if any.</summary>
    public Arc? LastArc => _moves.LastArc;

    public static bool IsTooFar(double x, double y, double z)
        => !(Math.Abs(x) < LargestLength && Math.Abs(y) < LargestLength && Math.Abs(z) < LargestLength);

    public void AddEvent(PrinterEvent what) => _events.Add(new MoveEvent(_moves.Count, what) { Source = _diagnostics.Line });

    public void Clear()
    {
        _moves.Clear();
        _events.Clear();
    }

    /// <summary>Sets what collects the moves, who takes each full block, and who adds the moves up.</summary>
    public void Begin(Func<int, BlockCollector> moves, Action<DecodedBlock>? take, ToolpathSums? sums)
        => (_moves, _take, _sums) = (moves(FirstSize), take, sums);

    /// <summary>The finished toolpath.</summary>
    public Toolpath ToToolpath(ToolpathTool[] tools)
    {
        if (_take is not null && !_moves.Keeps && Columns.Count > 0) _take(Taken(_moves.End()));
        if (Layers.MergeEmpty() is { } places) _moves.RenumberLayers(layer => layer >= 0 ? places[layer] : -1);
        return new(_moves.ToBlocks(), Layers.ToLayers(), _events, tools, _start, MoveSource.Lines);
    }

    /// <summary>A straight move to a position as written, with a change of E, by G0 or G1.</summary>
    public void Line(double x, double y, double z, double e, int code)
    {
        ref var head = ref _state.Head;
        var dx = x - head.X;
        var dy = y - head.Y;
        var dz = z - head.Z;
        var square = dx * dx + dy * dy;
        var length2 = square + dz * dz;
        if (code == 0) _counters.Rapids++;
        else _counters.Feeds++;
        if (!(length2 < LargestSquare) || !(e < LargestE && e > -LargestE) || (length2 > 1e6 && IsTooFar(x, y, z)))
        {
            OutOfRange();
            return;
        }
        if (e < NoChange && e > -NoChange) e = 0;
        if (length2 <= NoChange * NoChange)
        {
            InPlace(x, y, z, e);
            return;
        }
        Move(x, y, z, e, code, Math.Sqrt(length2), Math.Sqrt(square), dz == 0);
    }

    /// <summary>An arc by G2 or G3, in coordinates as written.</summary>
    public void Arc(Vec3 start, Vec3 end, double e, Arc arc, int code)
    {
        var length = arc.Length(start, end);
        _counters.Feeds++;
        if (!(length * length < LargestSquare) || IsTooFar(end.X, end.Y, end.Z) || IsTooFar(arc.Center.X, arc.Center.Y, arc.Center.Z)
            || !(Math.Abs(e) < LargestE))
        {
            OutOfRange();
            return;
        }
        if (Math.Abs(e) < NoChange) e = 0;
        if (length <= NoChange)
        {
            InPlace(end.X, end.Y, end.Z, e);
            return;
        }
        var rise = end.Z - start.Z;
        var xy = Math.Sqrt(Math.Max(length * length - rise * rise, 0));
        var count = _counters.Prints;
        Move(end.X, end.Y, end.Z, e, code, length, xy, arc.Plane == ArcPlane.XY && rise == 0);
        _moves.AddArc(Columns.Count - 1, arc with { Center = arc.Center + _state.Head.Shift });
        var printed = _counters.Prints > count;
        if (printed) _counters.PrintArcs++;
        else _counters.TravelArcs++;
        (printed ? _counters.PrintEnds : _counters.TravelEnds).Include(arc, start, end);
    }

    /// <summary>A travel move of a command. None before the first move of the file, because the position of the head is unknown.</summary>
    public void Travel(Vec3 to)
    {
        ref var head = ref _state.Head;
        if (head.HasMoved && to != head.Written) Emit(to.X, to.Y, to.Z, 0, 0, MoveKind.Travel);
        (head.X, head.Y, head.Z) = (to.X, to.Y, to.Z);
    }

    /// <summary>A move in place: a dwell, a firmware retraction, a turn of rotary axes.</summary>
    public void Stay(MoveKind kind)
    {
        ref var head = ref _state.Head;
        Emit(head.X, head.Y, head.Z, 0, 0, kind);
    }

    /// <summary>Moves the head in Z without a change of its coordinates, as fast as it can.</summary>
    public void Raise(double height)
    {
        if (height == 0) return;
        _state.Head.ShiftZ += height;
        var speed = _state.Feed.Speed;
        _state.Feed.Speed = 0;
        BreakExtrusion();
        if (_state.Head.HasMoved) Stay(MoveKind.Travel);
        _state.Feed.Speed = speed;
    }

    /// <summary>Turns the rotary axes with the last move.</summary>
    public void Turn(Vec3 turns) => _moves.Turn(turns);

    /// <summary>Ends the current extrusion.</summary>
    public void BreakExtrusion() => _afterPrint = false;

    /// <summary>Called at the first comment that begins a layer: the moves before it have no layer.</summary>
    public void ForgetLayers() => _moves.RenumberLayers(_ => -1);

    public void BeginLayer(int? number, double z, double thickness)
    {
        Layers.Mark(number, z, thickness);
        _lastFlatZ = double.NaN;
    }

    public void OutOfRange() => _diagnostics.Warn("gcode.number_range", "A move beyond 10¹⁰ mm (or a coordinate that is not a number) is left out.");

    private void Move(double x, double y, double z, double e, int code, double length, double lengthXY, bool flat)
    {
        var counters = _counters;
        MoveKind kind;
        var deposited = 0.0;
        if (e > 0)
        {
            deposited = _extruders.Push(e);
            kind = _balance && deposited == 0 ? MoveKind.MovingDeretract : MoveKind.Print;
        }
        else if (e < 0)
        {
            _extruders.Pull(-e);
            kind = MoveKind.Wipe;
        }
        else
        {
            kind = PrintsWithoutE && (_state.Extrusion.IsSwitchedOn || !_switched) && code > 0 ? MoveKind.Print : MoveKind.Travel;
        }
        if (kind == MoveKind.Print)
        {
            if (!_balance) deposited = e;
            counters.Prints++;
            if (code == 0) counters.PrintsG0++;
            counters.PrintLength += length;
            counters.PrintLengthXY += lengthXY;
            counters.EPrint += deposited;
            if (!_afterPrint) counters.PrintStarts.Include(_state.Head.X, _state.Head.Y, _state.Head.Z);
            counters.PrintEnds.Include(x, y, z);
            CountHeight(z, flat);
            _afterPrint = true;
        }
        else
        {
            counters.Travels++;
            if (e < 0) counters.TravelsWithRetraction++;
            if (code == 1) counters.TravelsG1++;
            counters.TravelLength += length;
            counters.TravelEnds.Include(x, y, z);
            _afterPrint = false;
        }
        Emit(x, y, z, e, deposited, kind);
    }

    private void CountHeight(double z, bool flat)
    {
        if (z != _lastPrintZ)
        {
            _lastPrintZ = z;
            _counters.HeightChanged(z);
        }
        if (flat && z != _lastFlatZ)
        {
            _lastFlatZ = z;
            _counters.FlatAt(z);
            if (!Layers.Marked && !Layers.AreAlike) Layers.FlatAt(z + _state.Head.ShiftZ);
        }
        if (Layers.NeedsZ) Layers.Printed(z + _state.Head.ShiftZ, flat);
    }

    private void InPlace(double x, double y, double z, double e)
    {
        if (e > 0)
        {
            _counters.Deretractions++;
            var wasRetracted = _extruders.IsRetracted;
            var deposited = _extruders.Push(e);
            Emit(x, y, z, e, _balance ? deposited : 0, wasRetracted || !_balance ? MoveKind.Deretract : MoveKind.Prime);
        }
        else if (e < 0)
        {
            _counters.Retractions++;
            _extruders.Pull(-e);
            Emit(x, y, z, e, 0, MoveKind.Retract);
        }
        else
        {
            _counters.NoOps++;
            ref var head = ref _state.Head;
            (head.X, head.Y, head.Z) = (x, y, z);
        }
    }

    private void Emit(double x, double y, double z, double e, double deposited, MoveKind kind)
    {
        ref var head = ref _state.Head;
        if (!head.HasMoved) NoteStart();
        head.X = x;
        head.Y = y;
        head.Z = z;
        if (_moves.IsFull && _moves.Grow(_take is not null) is { } full) _take?.Invoke(Taken(full));
        _moves.Add(head.Machine, e, deposited, _state.Feed.Speed, kind, kind is MoveKind.Print or MoveKind.Prime ? Role : Role.Unspecified, Layers.Current,
            (short)_state.Tool, _diagnostics.Line);
    }

    private DecodedBlock Taken(ToolpathColumns full)
    {
        var first = _taken;
        while (_taken < _events.Count && _events[_taken].Move < _moves.Count) _taken++;
        return new DecodedBlock(
            full, _moves.Count - full.Count, _events.GetRange(first, _taken - first).ToArray(), _start, Layers.Thicknesses());
    }

    // Where the first move begins; from there on the axes are known.
    private void NoteStart()
    {
        ref var head = ref _state.Head;
        head.HasMoved = true;
        _start = head.IsKnown ? head.Machine : null;
        if (_sums is not null) _sums.Position = _start ?? Vec3.Zero;
        head.KnownX = head.KnownY = head.KnownZ = true;
    }
}
