namespace Caterpillar.Simulation;

/// <summary>Goes through a toolpath as the firmware does: moves become straight moves, those between two stops a run, and a run is planned ahead.</summary>
internal sealed class MotionPlanner
{
    // Shorter moves are none, in mm.
    private const double NoMove = 1e-9;

    private Toolpath _toolpath;
    private int _block;
    private readonly Printer _printer;
    private readonly MachineLimits _limits;
    private readonly CornerRules _rules;
    private readonly Kinematics? _kinematics;
    private Vec3 _turns;
    private readonly LookAhead _lookAhead;
    private readonly FirmwareRetraction _retraction;
    private readonly HeatModel _heat;
    private readonly MotionColumns _out;
    private readonly double[] _filamentPerE;

    private MotionSegment[] _run = new MotionSegment[1024];
    private int _count;

    // The last move that was added to the run.
    private StraightMove _before;
    private int _nextEvent;
    private int _tool;
    private WaitTimes _waits;

    // Of the blocks whose trapezoids are not all final: the number of trapezoids before the next block. And the first of them.
    private readonly Action<int, MotionColumns>? _finished;
    private readonly Queue<int> _ends = new();
    private int _firstOpen;

    /// <param name="toolpath">The toolpath, or its beginning.</param>
    /// <param name="setup">The printer and the filament.</param>
    /// <param name="timesOnly">Only times are kept, no speeds.</param>
    /// <param name="finished">Called with each block whose motion is final. The motion is forgotten afterwards.</param>
    public MotionPlanner(Toolpath toolpath, PrintSetup setup, bool timesOnly = false, Action<int, MotionColumns>? finished = null)
    {
        (_toolpath, _finished) = (toolpath, finished);
        _printer = setup.Printer;
        _kinematics = _printer.Kinematics;
        _limits = new MachineLimits(_printer);
        _rules = _printer.Cornering switch
        {
            Cornering.Jerk => new JerkRules(_limits),
            Cornering.JunctionDeviation => new DeviationRules(_limits),
            _ => new SquareCornerRules(_limits, _printer.InstantaneousCornerVelocity),
        };
        _lookAhead = _printer.Cornering == Cornering.SquareCornerVelocity ? new CruiseLookAhead() : new QueueLookAhead(_printer.LookaheadMoves);
        _retraction = new FirmwareRetraction(_printer);
        _heat = new HeatModel(_printer);
        _out = new MotionColumns(finished is null ? toolpath.Count : 0, timesOnly);
        _filamentPerE = FilamentPerE(toolpath.Tools, setup);
    }

    public static PlannedMotion Plan(Toolpath toolpath, PrintSetup setup, IProgress<double>? progress, CancellationToken cancel)
    {
        var planner = new MotionPlanner(toolpath, setup);
        planner.Take(toolpath, progress, cancel);
        return planner.End();
    }

    /// <summary>The toolpath as far as it is known: the same as before, and more.</summary>
    public void Take(Toolpath soFar, IProgress<double>? progress, CancellationToken cancel)
    {
        _toolpath = soFar;
        for (; _block < soFar.Blocks.Count; _block++)
        {
            Block(_block, cancel);
            _ends.Enqueue(_out.Count + _count);
            if (_finished is not null) Finish();
            progress?.Report((_block + 1.0) / soFar.Blocks.Count);
        }
    }

    /// <summary>The toolpath is over.</summary>
    public PlannedMotion End()
    {
        var afterLast = _out.Count + _count;
        Events(_toolpath.Count);
        Stop();
        _out.Begin(_toolpath.Count, afterLast);
        if (_finished is not null) Finish();
        _heat.Settle(_out);
        return new PlannedMotion(_out, _heat, _waits);
    }

    private void Block(int block, CancellationToken cancel)
    {
        cancel.ThrowIfCancellationRequested();
        var columns = _toolpath.Blocks[block].Columns;
        var first = _toolpath.FirstOf(block);
        var at = _toolpath.StartOf(block);
        for (var i = 0; i < columns.Count; i++)
        {
            // Whatever waits in the run comes before this move.
            _out.Begin(first + i, _out.Count + _count);
            var homes = false;
            if (_nextEvent < _toolpath.Events.Count && first + i >= _toolpath.Events[_nextEvent].Move)
            {
                Events(first + i);
                homes = _toolpath.HomeOf(_toolpath[first + i]) is not null;
            }
            var end = new Vec3(columns.X[i], columns.Y[i], columns.Z[i]);
            var e = columns.E[i] * _filamentPerE[Math.Min(Math.Max((int)columns.Tool[i], 0), _filamentPerE.Length - 1)];
            var speed = columns.Speed[i];
            var kind = columns.Kind[i];
            if (e == 0 && kind is MoveKind.Retract or MoveKind.Deretract) (e, speed) = _retraction.Move(kind);
            // The travel of a homing takes no time of its own.
            if (!homes)
            {
                if (columns.TryGetArc(i, out var arc)) Arc(arc, at, end, e, speed, cancel);
                else if (_kinematics is not null && columns.TurnsAt(i, _turns) is var turns && (turns != _turns || turns != Vec3.Zero))
                    Turn(at, end, turns, e, speed);
                else Line(at, end, e, speed);
            }
            _turns = columns.TurnsAt(i, _turns);
            at = end;
        }
    }

    private void Finish()
    {
        for (; _ends.Count > 0 && _ends.Peek() <= _out.Count; _firstOpen++)
        {
            var next = _toolpath.FirstOf(_firstOpen) + _toolpath.Blocks[_firstOpen].Count;
            _out.Begin(next, _ends.Dequeue());
            _finished!(_firstOpen, _out);
            _heat.Settle(_out);
            _out.Forget(next);
        }
    }

    private void Events(int move)
    {
        for (; _nextEvent < _toolpath.Events.Count && _toolpath.Events[_nextEvent].Move <= move; _nextEvent++) Event(_toolpath.Events[_nextEvent].Event);
    }

    private void Event(PrinterEvent what)
    {
        switch (what)
        {
            case DwellEvent dwell:
                _waits = _waits with { Dwells = _waits.Dwells + Wait(dwell.Seconds) };
                break;
            case FinishMovesEvent or PauseEvent:
                Stop();
                break;
            case HomeEvent:
                _waits = _waits with { Homing = _waits.Homing + Wait(_printer.HomingTime) };
                break;
            case ToolEvent tool when tool.Tool != _tool:
                _tool = tool.Tool;
                _waits = _waits with { ToolChanges = _waits.ToolChanges + Wait(_printer.ToolChangeTime) };
                break;
            case RetractionEvent retraction:
                _retraction.Set(retraction);
                break;
            case NozzleTemperatureEvent nozzle:
                Heat(_heat.Nozzle(nozzle.Tool ?? _tool), nozzle.Celsius, nozzle.Wait);
                break;
            case BedTemperatureEvent bed:
                Heat(_heat.Bed, bed.Celsius, bed.Wait);
                break;
            default:
                _limits.Apply(what);
                break;
        }
    }

    private void Heat(HeaterCurve heater, double celsius, bool wait)
    {
        wait &= heater.Rate > 0;
        if (wait) Stop();
        _heat.Set(heater, _out.Count + _count, celsius);
        if (!wait) return;
        _heat.Settle(_out);
        _waits = _waits with { Heating = _waits.Heating + Wait(heater.TimeTo(celsius)) };
    }

    // All moves end, then nothing happens for a time.
    private double Wait(double seconds)
    {
        Stop();
        if (seconds > 0) _out.Add(new Trapezoid(0, 0, 0, 0, seconds));
        return seconds;
    }

    private void Arc(Arc arc, Vec3 start, Vec3 end, double e, double speed, CancellationToken cancel)
    {
        // Larger than any printer: longer chords turn as little.
        var segment = Math.Max(_printer.ArcSegment, arc.Radius(start) / 2000);
        var chords = (int)Math.Min(Math.Max(Math.Floor(arc.Length(start, end) / segment), 1), 1e6);
        var at = start;
        for (var i = 1; i <= chords; i++)
        {
            if ((i & 0xFFF) == 1) cancel.ThrowIfCancellationRequested();
            var to = arc.PointAt(start, end, (double)i / chords);
            Line(at, to, e / chords, speed);
            at = to;
        }
    }

    private void Line(Vec3 start, Vec3 end, double e, double speed)
    {
        double dx = end.X - start.X, dy = end.Y - start.Y, dz = end.Z - start.Z;
        var length = Math.Sqrt(dx * dx + dy * dy + dz * dz);
        var move = new StraightMove { Speed = speed > 0 ? speed : MachineLimits.FirstSpeed };
        if (length > NoMove)
        {
            (move.X, move.Y, move.Z, move.E) = (dx / length, dy / length, dz / length, e / length);
        }
        else
        {
            length = Math.Abs(e);
            move.E = Math.Sign(e);
            move.InPlace = true;
        }
        Run(ref move, length);
    }

    // With rotary axes: what each axis does along a mm of the path of the tip, or along a degree where the tip stands.
    private void Turn(Vec3 start, Vec3 end, Vec3 turns, double e, double speed)
    {
        double length = start.DistanceTo(end), degrees = _turns.DistanceTo(turns);
        var along = length > NoMove ? length : degrees;
        if (along == 0)
        {
            Line(start, end, e, speed);
            return;
        }
        var slides = (_kinematics!.Machine(end, turns) - _kinematics.Machine(start, _turns)) / along;
        var move = new StraightMove { Speed = speed > 0 ? speed : MachineLimits.FirstSpeed, X = slides.X, Y = slides.Y, Z = slides.Z, E = e / along };
        move.MostSpeed = move.MostAcceleration = double.PositiveInfinity;
        foreach (var axis in _kinematics.Axes)
        {
            var part = Math.Abs(axis.Of(turns) - axis.Of(_turns)) / along;
            if (!(part > 0)) continue;
            move.MostSpeed = Math.Min(move.MostSpeed, axis.MaxSpeed / part);
            move.MostAcceleration = Math.Min(move.MostAcceleration, axis.MaxAcceleration / part);
        }
        Run(ref move, along);
    }

    private void Run(ref StraightMove move, double length)
    {
        // A move without displacement takes no time.
        if (length == 0) return;
        move.Length = length;
        if (move.MostSpeed > 0) move.Speed = Math.Min(move.Speed, move.MostSpeed);
        _rules.Limit(ref move);
        if (move.MostAcceleration > 0) move.Acceleration = Math.Min(move.Acceleration, move.MostAcceleration);
        if (_count == _run.Length) Array.Resize(ref _run, 2 * _count);
        ref var s = ref _run[_count];
        (s.Length, s.Acceleration, s.Speed2, s.Rest2) = (length, move.Acceleration, move.Speed * move.Speed, move.Rest * move.Rest);
        s.SlowGain = _rules.SlowGain(move);
        s.Entry2 = _before.Length > 0 ? _rules.Corner2(_before, move) : s.Rest2;
        _before = move;
        _count++;
        Plan(ends: false);
    }

    private void Stop()
    {
        if (_count > 0) Plan(ends: true);
        _before = default;
    }

    private void Plan(bool ends)
    {
        var done = _lookAhead.Plan(_run, _count, ends);
        if (done == 0) return;
        for (var i = 0; i < done; i++)
        {
            ref var s = ref _run[i];
            _out.Add(Trapezoid.Over(s.Length, s.Start2, s.Peak2, s.End2, s.Acceleration));
        }
        _count -= done;
        Array.Copy(_run, done, _run, 0, _count);
    }

    /// <summary>mm of filament for a unit of E of each tool, of one at least.</summary>
    public static double[] FilamentPerE(IReadOnlyList<ToolpathTool> tools, PrintSetup setup)
        => tools.DefaultIfEmpty(new ToolpathTool(null)).Select((tool, number) => FilamentPerE(number, tool.VolumePerE, setup)).ToArray();

    /// <summary>mm of filament for a unit of E of a tool: a tool whose E is a volume has a factor of 1 mm³.</summary>
    public static double FilamentPerE(int tool, double? volumePerE, PrintSetup setup)
    {
        var radius = setup.OfTool(tool).Material.FilamentDiameter / 2;
        return volumePerE == 1 ? 1 / (Math.PI * radius * radius) : 1;
    }
}
