namespace Caterpillar.Simulation;

/// <summary>
/// Simulation of a toolpath in time: the duration of each move with the limits and cornering of a printer, and the state of the machine at any time, found
/// without visiting all moves and without allocation. Immutable.
/// </summary>
public sealed class Timeline
{
    private readonly HeatModel _heat;
    private readonly PathIndex _path;
    private readonly bool _volumesKnown;
    private readonly Kinematics? _kinematics;

    private Timeline(Toolpath toolpath, PrintSetup setup, PlannedMotion plan, PathIndex path)
    {
        Toolpath = toolpath;
        Setup = setup;
        Motion = plan.Motion;
        _heat = plan.Heat;
        Waits = plan.Waits;
        _kinematics = setup.Printer.Kinematics ?? Kinematics.Guess(toolpath);
        _path = path;
        _volumesKnown = Enumerable.Range(0, toolpath.Tools.Count).All(tool => toolpath.VolumePerE(tool) is not null);
    }

    /// <summary>The simulated toolpath.</summary>
    public Toolpath Toolpath { get; }

    /// <summary>The printer, material and settings of the simulation.</summary>
    public PrintSetup Setup { get; }

    /// <summary>Total time, s.</summary>
    public double Duration => Motion.TotalTime;

    /// <summary>Seconds of waiting, by cause.</summary>
    public WaitTimes Waits { get; }

    /// <summary>Total path length of the head, mm.</summary>
    public double Length => _path.Total.Length;

    /// <summary>Simulates a toolpath on the printer of a setup. If a decoded file sets limits, they apply from there on.</summary>
    public static Timeline Of(Toolpath toolpath, PrintSetup setup, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        toolpath = setup.Printer.Turned(toolpath, cancel);
        var plan = MotionPlanner.Plan(toolpath, setup, progress, cancel);
        return new Timeline(toolpath, setup, plan, new PathIndex(toolpath));
    }

    /// <summary>
    /// The planned trapezoids in order: one for a straight move, several for an arc, none for a move without displacement; waits are among them.
    /// </summary>
    internal MotionColumns Motion { get; }

    /// <summary>Seconds until the end of the previous move, before the waits of this one. For the number of moves: until the end.</summary>
    public double StartOf(int move)
    {
        if (move < 0 || move > Toolpath.Count) throw new ArgumentOutOfRangeException(nameof(move));
        return Motion.StartOf(move);
    }

    /// <summary>Seconds until the end of a move.</summary>
    public double EndOf(int move) => move >= 0 ? StartOf(move + 1) : throw new ArgumentOutOfRangeException(nameof(move));

    /// <summary>Seconds of waiting before a move: dwells, heating, tool changes, homing.</summary>
    public double WaitBefore(int move)
    {
        if (move < 0 || move > Toolpath.Count) throw new ArgumentOutOfRangeException(nameof(move));
        return move < Toolpath.Count ? Motion.WaitBefore(move) : Duration - StartOf(move);
    }

    /// <summary>Maximum speed of a move, mm/s; of the filament for moves in place; 0 if nothing moves.</summary>
    public double PeakOf(int move) => Motion.PeakOf(move);

    /// <summary>The state at a time in seconds, clamped to the start and the end.</summary>
    public MachineState At(double time)
    {
        time = time > 0 ? Math.Min(time, Duration) : 0;
        var trapezoid = FirstAfter(time);
        return State(MoveOf(trapezoid), trapezoid, time);
    }

    /// <summary>The state at a fraction of the time, 0 to 1.</summary>
    public MachineState AtFraction(double fraction) => At(fraction * Duration);

    /// <summary>The state at the start of a move, before its waits. For the number of moves: at the end.</summary>
    public MachineState AtMove(int move) => State(move, Motion.First[move], StartOf(move));

    /// <summary>The state at the first move of a line (or step), or of the next one with moves; null after the last.</summary>
    public MachineState? AtSource(int source) => MoveAtSource(source) is >= 0 and var move && move < Toolpath.Count ? AtMove(move) : null;

    /// <summary>The state at the start of a layer; null if the layer has no moves or does not exist.</summary>
    /// <param name="layer">Index into the layers of the toolpath.</param>
    public MachineState? AtLayer(int layer)
    {
        if (layer < 0 || layer >= Toolpath.Layers.Count) return null;
        var move = _path.StartOfLayer(layer);
        return move < Toolpath.Count ? AtMove(move) : null;
    }

    /// <summary>The state at the start of the first layer with this number that has moves; null if there is none.</summary>
    public MachineState? AtLayerNumber(int number)
        => Toolpath.Layers.Select((layer, i) => layer.Index == number ? AtLayer(i) : null).FirstOrDefault(state => state is not null);

    /// <summary>The state when an extrusion first reaches a height (mm) or begins above it; null if none does.</summary>
    public MachineState? AtHeight(double z)
    {
        var number = _path.FirstAbove(z);
        if (number >= Toolpath.Count) return null;
        var move = Toolpath[number];
        return move.Start.Z < z ? WithDone(number, (z - move.Start.Z) / (move.End.Z - move.Start.Z)) : AtMove(number);
    }

    /// <summary>The state at a fraction of the path length of the head, 0 to 1.</summary>
    public MachineState AtLength(double fraction)
    {
        var length = Math.Max(fraction, 0) * Length;
        var (move, before) = _path.AtLength(length);
        if (move >= Toolpath.Count) return At(Duration);
        return WithDone(move, (length - before.Length) / Toolpath[move].Length);
    }

    // The first trapezoid that ends after a time; their number where none does.
    private int FirstAfter(double time) => Search.First(0, Motion.Count, (Motion.EndTime, time), static (s, i) => s.EndTime[i] > s.time);

    // The last move that begins with this trapezoid or before.
    private int MoveOf(int trapezoid)
        => Search.First(1, Toolpath.Count + 1, (Motion.First, trapezoid), static (s, i) => s.First[i] > s.trapezoid) - 1;

    private int MoveAtSource(int source)
    {
        if (!_path.SourcesAscend)
        {
            for (var i = 0; i < Toolpath.Count; i++)
            {
                if (Toolpath[i].Source >= source) return i;
            }
            return Toolpath.Count;
        }
        var move = Search.First(0, _path.SourcedMoves, (Toolpath, source), static (s, i) =>
        {
            // A move without a source goes with the next that has one.
            while (s.Toolpath[i].Source < 0) i++;
            return s.Toolpath[i].Source >= s.source;
        });
        return move < _path.SourcedMoves ? move : Toolpath.Count;
    }

    // The moment at which a part of a move is done.
    private MachineState WithDone(int move, double done)
    {
        int first = Motion.FirstMoving(move), end = Motion.First[move + 1];
        if (first == end) return AtMove(move);
        // The pieces of an arc are equally long.
        var at = done * (end - first);
        var piece = (int)at;
        var trapezoid = Motion[first + piece];
        var time = Motion.StartTime(first + piece) + trapezoid.TimeAt((at - piece) * trapezoid.Length);
        return State(move, first + piece, time);
    }

    private MachineState State(int number, int trapezoid, double time)
    {
        var over = number >= Toolpath.Count;
        var move = over ? Last() : Toolpath[number];
        double done = 0, speed = 0;
        var end = over ? Motion.Count : Motion.First[number + 1];
        var waits = trapezoid < end && Motion.IsWait(trapezoid);
        if (!waits && trapezoid < end)
        {
            var first = Motion.FirstMoving(number);
            var now = Motion[trapezoid];
            var since = time - Motion.StartTime(trapezoid);
            done = Math.Min((trapezoid - first + now.DistanceAt(since) / now.Length) / (end - first), 1);
            speed = now.SpeedAt(since);
        }
        var sums = _path.Before(number);
        var length = move.Length;
        var flow = Toolpath.VolumePerE(move.Tool) is { } factor ? FlowOf(move, length, speed) * factor : (double?)null;
        var position = over ? move.End : move.PointAt(done);
        var nozzle = _heat.NozzleOrNull(move.Tool);
        return new MachineState
        {
            Time = time,
            TimeLeft = Math.Max(Duration - time, 0),
            Move = number,
            Done = done,
            Waits = waits,
            Position = position,
            Head = HeadAt(position, number, done),
            Direction = over || waits ? Vec3.Zero : DirectionAt(move, done),
            Speed = speed,
            Flow = flow,
            Kind = waits ? MoveKind.Dwell : move.Kind,
            Role = move.Role,
            Layer = move.Layer,
            Tool = move.Tool,
            Source = move.Source,
            Length = sums.Length + done * length,
            Filament = sums.Filament + done * move.Deposited,
            Volume = _volumesKnown ? sums.Volume + done * (Toolpath.VolumePerE(move.Tool) ?? 0) * move.Deposited : null,
            NozzleTemperature = nozzle?.At(time) ?? HeatModel.Ambient,
            NozzleTarget = nozzle?.TargetAt(time) ?? 0,
            BedTemperature = _heat.Bed.At(time),
            BedTarget = _heat.Bed.TargetAt(time),
            Fan = _path.FanAt(number),
        };
    }

    private Move Last()
        => Toolpath.Count > 0 ? Toolpath[Toolpath.Count - 1] : default(Move) with { End = Toolpath.Start ?? Vec3.Zero, Layer = -1, Source = -1 };

    private Frame HeadAt(Vec3 tip, int number, double done)
    {
        if (_kinematics is null) return Frame.At(tip);
        var words = Vec3.Lerp(Toolpath.WordsAt(number - 1), Toolpath.WordsAt(Math.Min(number, Toolpath.Count - 1)), done);
        var pose = _kinematics.Pose(tip, words);
        return Frame.FromAxes(tip, pose.XAxis, pose.YAxis);
    }

    // E per second: along the path, or of the extruder alone.
    private static double FlowOf(in Move move, double length, double speed)
        => length > 0 ? move.Deposited / length * speed : move.Deposited > 0 ? move.Deposited / move.E * speed : 0;

    private static Vec3 DirectionAt(in Move move, double done)
    {
        var change = move.End - move.Start;
        if (move.Arc is { } arc)
        {
            const double Near = 1e-4;
            change = arc.PointAt(move.Start, move.End, done + Near) - arc.PointAt(move.Start, move.End, done - Near);
        }
        var length = change.Length;
        return length > 0 ? change / length : Vec3.Zero;
    }
}
