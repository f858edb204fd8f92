namespace Caterpillar.Turtles;

/// <summary>
/// A turtle that prints. It has a pose (position and forward, left and up axes) and the bead that it prints. Lengths are in mm. Angles are in degrees, or in
/// radians if <see cref="AngleUnit"/> is set. Positive yaw turns left, positive pitch raises the nose, positive roll raises the left side. Moves with the pen
/// down print in any direction. Raising or lowering the pen extrudes nothing. The turtle is a mutable builder and not thread-safe. <see cref="ToSteps"/>
/// returns its result. Methods throw <see cref="ArgumentOutOfRangeException"/> for values that are not finite. Sources: ExtruderTurtle (Pezzuti Dyer and
/// Buechley 2022) and turtle.py (Kanada 2015). docs/turtle.md lists their names.
/// </summary>
public sealed partial class Turtle
{
    private readonly TurtleOptions _options;
    private readonly StepRecorder _recorder = new();
    private readonly Stack<TurtleState> _stack = new();
    private readonly List<Frame>? _poses;
    private TurtleState _state;

    /// <summary>A turtle with the pen down at the start of the options. The default is the origin, facing +X.</summary>
    public Turtle(TurtleOptions? options = null)
    {
        _options = options ?? new TurtleOptions();
        if (!_options.Start.Origin.IsFinite) throw new ArgumentException("The start must be finite.", nameof(options));
        _state = new TurtleState { Pose = _options.Start, PenDown = true, Tags = new PathTags(Role.Unspecified, null, 0, "", null) };
        if (_options.KeepPoses) _poses = [_options.Start];
        SetDensity(ExtrusionModel.DefaultFactor);
        SetRate(1000);
        if (_options.Bead is { } bead) SetBead(bead);
    }

    /// <summary>Unit of all angles.</summary>
    public AngleUnit AngleUnit { get; set; }

    /// <summary>Position and axes: X is forward, Y left, Z up.</summary>
    public Frame Pose => _state.Pose;

    /// <summary>Position of the turtle, mm.</summary>
    public Vec3 Position => _state.Pose.Origin;

    /// <summary>X of the position, mm.</summary>
    public double X => Position.X;

    /// <summary>Y of the position, mm.</summary>
    public double Y => Position.Y;

    /// <summary>Z of the position, mm.</summary>
    public double Z => Position.Z;

    /// <summary>Angle of the heading in the XY plane from +X, −180° to 180°. If the turtle faces straight up or down, it includes the roll.</summary>
    public double Yaw => FromDegrees(Heading.Of(Pose).Yaw);

    /// <summary>Angle of the nose above the XY plane, −90° to 90°.</summary>
    public double Pitch => FromDegrees(Heading.Of(Pose).Pitch);

    /// <summary>Angle of the left side above level, −180° to 180°. It is 0 if the turtle faces straight up or down.</summary>
    public double Roll => FromDegrees(Heading.Of(Pose).Roll);

    /// <summary>Number of moves so far.</summary>
    public long MoveCount => _recorder.Moves;

    /// <summary>Number of pushed states.</summary>
    public int StackDepth => _stack.Count;

    /// <summary>The poses at the start and after every move and turn. Empty unless <see cref="TurtleOptions.KeepPoses"/> is set.</summary>
    public IReadOnlyList<Frame> Poses => _poses is null ? [] : _poses.ToArray();

    /// <summary>Turns left, about the up axis.</summary>
    public Turtle Left(double angle) => Turn(Pose.Yaw(Degrees(angle)));

    /// <summary>Turns right.</summary>
    public Turtle Right(double angle) => Left(-angle);

    /// <summary>Raises the nose: turns about the left axis.</summary>
    public Turtle PitchUp(double angle) => Turn(Pose.Pitch(Degrees(angle)));

    /// <summary>Lowers the nose.</summary>
    public Turtle PitchDown(double angle) => PitchUp(-angle);

    /// <summary>Raises the left side: turns about the forward axis.</summary>
    public Turtle RollRight(double angle) => Turn(Pose.Roll(Degrees(angle)));

    /// <summary>Lowers the left side.</summary>
    public Turtle RollLeft(double angle) => RollRight(-angle);

    /// <summary>Turns around: exactly half a turn about the up axis.</summary>
    public Turtle TurnAround() => Turn(Pose.Yaw(180));

    /// <summary>Sets the heading: yaw, pitch and roll from the world axes, in this order.</summary>
    public Turtle SetHeading(double yaw, double pitch = 0, double roll = 0)
        => Turn(new Heading(Degrees(yaw), Degrees(pitch), Degrees(roll)).ToFrame(Position));

    /// <summary>Adds to the yaw, pitch and roll of the heading.</summary>
    public Turtle ChangeHeading(double yaw = 0, double pitch = 0, double roll = 0)
    {
        var now = Heading.Of(Pose);
        return Turn(new Heading(now.Yaw + Degrees(yaw), now.Pitch + Degrees(pitch), now.Roll + Degrees(roll)).ToFrame(Position));
    }

    /// <summary>Faces a point with the wings level.</summary>
    /// <exception cref="ArgumentException">The point is the turtle's own position or not finite.</exception>
    public Turtle Face(Vec3 point) => Turn(Heading.Towards(point - Position, Heading.Of(Pose).Yaw).ToFrame(Position));

    /// <summary>Levels the wings and keeps the forward direction. Has no effect if the turtle faces straight up or down.</summary>
    public Turtle Level() => Turn((Heading.Of(Pose) with { Roll = 0 }).ToFrame(Position));

    /// <summary>Moves forward. A negative distance moves backward without turning.</summary>
    public Turtle Forward(double distance) => MoveTo(Position + Pose.X * distance, deposit: true);

    /// <summary>
    /// Moves in one straight move by <paramref name="distance"/> along the heading projected to the XY plane, and by <paramref name="rise"/> along world Z
    /// (Kanada's cylindrical turtle).
    /// </summary>
    public Turtle Forward(double distance, double rise)
    {
        var (sin, cos) = Angle.SinCos(Heading.Of(Pose).Yaw);
        var ahead = Pose.X.Z == 0 ? Pose.X.Unit() : new Vec3(cos, sin);
        return MoveTo(Position + ahead * distance + Vec3.UnitZ * rise, deposit: true);
    }

    /// <summary>Moves backward without turning, mm. Prints if the pen is down.</summary>
    public Turtle Backward(double distance) => Forward(-distance);

    /// <summary>Moves forward without printing, even if the pen is down.</summary>
    public Turtle Move(double distance) => MoveTo(Position + Pose.X * distance, deposit: false);

    /// <summary>Moves forward by a distance and up by a height in one straight move.</summary>
    public Turtle ForwardLift(double distance, double height) => MoveTo(Position + Pose.X * distance + Pose.Z * height, deposit: true);

    /// <summary>Moves along the turtle's up axis without printing, even if the pen is down.</summary>
    public Turtle Lift(double height) => MoveTo(Position + Pose.Z * height, deposit: false);

    /// <summary>Moves along world Z without printing, even if the pen is down.</summary>
    public Turtle LiftWorld(double height) => MoveTo(Position + Vec3.UnitZ * height, deposit: false);

    /// <summary>
    /// Moves straight to a point and prints if the pen is down. Null keeps a coordinate. The heading stays the same, or turns along the move if
    /// <paramref name="faceTravel"/> is true.
    /// </summary>
    public Turtle GoTo(double? x, double? y, double? z = null, bool faceTravel = false) => Go(x, y, z, true, faceTravel);

    /// <summary>
    /// Moves straight to a point without printing. Null keeps a coordinate. The heading stays the same, or turns along the move if
    /// <paramref name="faceTravel"/> is true.
    /// </summary>
    public Turtle Jump(double? x, double? y, double? z = null, bool faceTravel = false) => Go(x, y, z, false, faceTravel);

    /// <summary>Sets the starting point. This is not a move.</summary>
    /// <exception cref="InvalidOperationException">The turtle has already moved.</exception>
    public Turtle StartAt(double x, double y, double z = 0)
    {
        if (_recorder.HasStarted) throw new InvalidOperationException("The start must come before the first move.");
        var at = new Vec3(x, y, z);
        if (!at.IsFinite) throw NotFinite();
        _state.Pose = Pose.WithOrigin(at);
        if (_poses is not null) _poses[_poses.Count - 1] = Pose;
        return this;
    }

    /// <summary>Saves the whole state: pose, pen, bead, speed and tags.</summary>
    public Turtle Push()
    {
        _stack.Push(_state);
        return this;
    }

    /// <summary>
    /// Returns to the last pushed state without printing. The move only states its intent (<see cref="TravelIntent.Return"/>). Planning finds a safe path.
    /// </summary>
    /// <exception cref="InvalidOperationException">Nothing was pushed.</exception>
    public Turtle Pop()
    {
        if (_stack.Count == 0) throw new InvalidOperationException("No pushed state to pop.");
        var state = _stack.Pop();
        _recorder.Return(Position, state.Pose.Origin);
        _state = state;
        _poses?.Add(Pose);
        return this;
    }

    /// <summary>Repeats an action: <c>turtle.Repeat(5, t => t.Forward(40).Left(144))</c>.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The count is negative.</exception>
    public Turtle Repeat(int count, Action<Turtle> body)
        => Repeat(count, body is null ? throw new ArgumentNullException(nameof(body)) : (turtle, _) => body(turtle));

    /// <summary>Repeats an action. Its second argument is the number of the repetition, from 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The count is negative.</exception>
    public Turtle Repeat(int count, Action<Turtle, int> body)
    {
        if (body is null) throw new ArgumentNullException(nameof(body));
        if (count < 0) throw new ArgumentOutOfRangeException(nameof(count), count, "The count must be 0 or more.");
        for (var i = 0; i < count; i++) body(this, i);
        return this;
    }

    /// <summary>
    /// All steps so far, in order. Printing moves are paths with a bead for each segment. Other moves are travels exactly as drawn. Events stay in place. Moves
    /// of length 0 are dropped.
    /// </summary>
    public IReadOnlyList<Step> ToSteps() => _recorder.ToSteps();

    /// <summary>A turtle as a triangle that points forward: <paramref name="size"/> mm to the left and to the right, and 2.5 times as much forward.</summary>
    public static IReadOnlyList<Vec3> TriangleOf(Frame pose, double size = 2)
        => [pose.Origin + pose.Y * size, pose.Origin - pose.Y * size, pose.Origin + pose.X * (2.5 * size)];

    private Turtle Turn(Frame pose)
    {
        if (!pose.X.IsFinite) throw NotFinite();
        _state.Pose = pose;
        _poses?.Add(pose);
        return this;
    }

    private Turtle Go(double? x, double? y, double? z, bool deposit, bool faceTravel)
    {
        var to = new Vec3(x ?? X, y ?? Y, z ?? Z);
        if (faceTravel && to != Position) Face(to);
        return MoveTo(to, deposit);
    }

    private Turtle MoveTo(Vec3 to, bool deposit)
    {
        if (!to.IsFinite) throw NotFinite();
        if (deposit && _state.PenDown) _recorder.Print(Position, to, _state.Bead, _state.Tags);
        else _recorder.Travel(Position, to, to.X == Position.X && to.Y == Position.Y ? Math.Min(TravelSpeed, _options.MaxLiftSpeed) : TravelSpeed);
        _state.Pose = _state.Pose.WithOrigin(to);
        _poses?.Add(_state.Pose);
        return this;
    }

    private double Degrees(double angle) => AngleUnit == AngleUnit.Radians ? Angle.ToDegrees(angle) : angle;

    private double FromDegrees(double angle) => AngleUnit == AngleUnit.Radians ? Angle.ToRadians(angle) : angle;

    private static ArgumentOutOfRangeException NotFinite() => new("value", "The value is not finite.");

    private struct TurtleState
    {
        public Frame Pose;
        public bool PenDown;
        public Bead Bead;
        public double TravelSpeed;
        public PathTags Tags;
    }
}
