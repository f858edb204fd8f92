using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Turtles;

/// <summary>
/// A turtle that prints: a pose (position and forward, left, up) and what the printer deposits as it moves. Lengths are mm, angles degrees unless
/// <see cref="AngleUnit"/> says radians. Positive yaw turns left, positive pitch raises the nose, positive roll lifts the left side. Moves with the pen down
/// deposit an extrusion, whatever their direction; pen up and down carry no hidden extrusion. A mutable builder that ends in <see cref="ToSteps"/>; not
/// thread-safe. Methods throw <see cref="ArgumentOutOfRangeException"/> for values that are not finite. Sources: ExtruderTurtle (Pezzuti Dyer and Buechley
/// 2022) and turtle.py (Kanada 2015); docs/turtle.md lists their names.
/// </summary>
public sealed partial class Turtle
{
    private readonly TurtleOptions _options;
    private readonly StepRecorder _recorder = new();
    private readonly Stack<TurtleState> _stack = new();
    private readonly List<Frame>? _poses;
    private TurtleState _state;

    /// <summary>Where the options say (at the origin, looking along +X), with the pen down.</summary>
    public Turtle(TurtleOptions? options = null)
    {
        _options = options ?? new TurtleOptions();
        if (!(_options.ArcTolerance > 0)
            || !_options.Start.Origin.IsFinite)
        {
            throw new ArgumentException("A turtle needs an arc tolerance above 0 and a finite start.", nameof(options));
        }
        _state = new TurtleState { Pose = _options.Start, PenDown = true, Tags = new PathTags(Role.Unspecified, null, 0, "", null) };
        AngleUnit = _options.AngleUnit;
        if (_options.KeepPoses) _poses = [_options.Start];
        SetDensity(_options.Density);
        SetRate(_options.Rate);
        if (_options.Bead is { } bead) SetBead(bead);
    }

    /// <summary>Unit of all angles.</summary>
    public AngleUnit AngleUnit { get; set; }

    /// <summary>Position and axes: X is forward, Y left, Z up.</summary>
    public Frame Pose => _state.Pose;

    /// <summary>Where the turtle stands, mm.</summary>
    public Vec3 Position => _state.Pose.Origin;

    /// <summary>X of the position, mm.</summary>
    public double X => Position.X;

    /// <summary>Y of the position, mm.</summary>
    public double Y => Position.Y;

    /// <summary>Z of the position, mm.</summary>
    public double Z => Position.Z;

    /// <summary>Angle of the heading in the XY plane from +X, −180° to 180°; straight up or down it includes the roll.</summary>
    public double Yaw => FromDegrees(Heading.Of(Pose).Yaw);

    /// <summary>Angle of the nose above the XY plane, −90° to 90°.</summary>
    public double Pitch => FromDegrees(Heading.Of(Pose).Pitch);

    /// <summary>Angle by which the left side is raised, −180° to 180°; 0 straight up or down.</summary>
    public double Roll => FromDegrees(Heading.Of(Pose).Roll);

    /// <summary>Number of moves so far.</summary>
    public long MoveCount => _recorder.Moves;

    /// <summary>Number of pushed states.</summary>
    public int StackDepth => _stack.Count;

    /// <summary>The pose at the start and after every move and turn, if the options ask for it; else empty.</summary>
    public IReadOnlyList<Frame> Poses => _poses is null ? [] : _poses.ToArray();

    /// <summary>Turns about up; positive to the left.</summary>
    public Turtle TurnYaw(double angle) => Turn(Pose.Yaw(Degrees(angle)));

    /// <summary>Turns about left; positive raises the nose.</summary>
    public Turtle TurnPitch(double angle) => Turn(Pose.Pitch(Degrees(angle)));

    /// <summary>Turns about forward; positive lifts the left side.</summary>
    public Turtle TurnRoll(double angle) => Turn(Pose.Roll(Degrees(angle)));

    /// <summary>Yaws to the left, degrees.</summary>
    public Turtle Left(double angle) => TurnYaw(angle);

    /// <summary>Yaws to the right, degrees.</summary>
    public Turtle Right(double angle) => TurnYaw(-angle);

    /// <summary>Raises the nose, degrees.</summary>
    public Turtle PitchUp(double angle) => TurnPitch(angle);

    /// <summary>Lowers the nose, degrees.</summary>
    public Turtle PitchDown(double angle) => TurnPitch(-angle);

    /// <summary>Lowers the left side.</summary>
    public Turtle RollLeft(double angle) => TurnRoll(-angle);

    /// <summary>Lifts the left side.</summary>
    public Turtle RollRight(double angle) => TurnRoll(angle);

    /// <summary>Turns around: exactly half a turn about up.</summary>
    public Turtle TurnAround() => Turn(Pose.Yaw(180));

    /// <summary>Sets the heading: from the world axes, yaw, pitch and roll in this order.</summary>
    public Turtle SetHeading(double yaw, double pitch = 0, double roll = 0)
        => Turn(new Heading(Degrees(yaw), Degrees(pitch), Degrees(roll)).ToFrame(Position));

    /// <summary>Adds to the angles of the heading.</summary>
    public Turtle ChangeHeading(double yaw = 0, double pitch = 0, double roll = 0)
    {
        var now = Heading.Of(Pose);
        return Turn(new Heading(now.Yaw + Degrees(yaw), now.Pitch + Degrees(pitch), now.Roll + Degrees(roll)).ToFrame(Position));
    }

    /// <summary>Looks at a point with the wings level.</summary>
    /// <exception cref="ArgumentException">The point is where the turtle stands, or not finite.</exception>
    public Turtle Face(Vec3 point) => Turn(Heading.Towards(point - Position, Heading.Of(Pose).Yaw).ToFrame(Position));

    /// <summary>Turns the wings level without changing the direction of the nose, unless that is straight up or down.</summary>
    public Turtle Level()
    {
        var now = Heading.Of(Pose);
        return Turn((now with { Roll = 0 }).ToFrame(Position));
    }

    /// <summary>Moves along forward; negative moves backward without turning.</summary>
    public Turtle Forward(double distance) => MoveTo(Position + Pose.X * distance, deposit: true);

    /// <summary>
    /// Moves by <paramref name="distance"/> along the heading's projection on the XY plane and by <paramref name="rise"/> along world Z in one straight move
    /// (Kanada's cylindrical turtle).
    /// </summary>
    public Turtle Forward(double distance, double rise)
    {
        var ahead = Pose.X;
        if (ahead.Z == 0)
        {
            ahead = ahead.Unit();
        }
        else
        {
            var (sin, cos) = Angle.SinCos(Heading.Of(Pose).Yaw);
            ahead = new Vec3(cos, sin);
        }
        return MoveTo(Position + ahead * distance + Vec3.UnitZ * rise, deposit: true);
    }

    /// <summary>Goes backward, mm; with the pen down it draws.</summary>
    public Turtle Backward(double distance) => Forward(-distance);

    /// <summary>Moves along forward; deposits nothing, even with the pen down.</summary>
    public Turtle Move(double distance) => MoveTo(Position + Pose.X * distance, deposit: false);

    /// <summary>One straight move by a distance along forward and one along up.</summary>
    public Turtle ForwardLift(double distance, double height) => MoveTo(Position + Pose.X * distance + Pose.Z * height, deposit: true);

    /// <summary>Moves along the turtle's up; deposits nothing, even with the pen down.</summary>
    public Turtle Lift(double height) => MoveTo(Position + Pose.Z * height, deposit: false);

    /// <summary>Moves along world Z; deposits nothing, even with the pen down.</summary>
    public Turtle LiftWorld(double height) => MoveTo(Position + Vec3.UnitZ * height, deposit: false);

    /// <summary>
    /// Moves straight to a point, printing with the pen down; null keeps a coordinate. The heading stays, or with <paramref name="faceTravel"/> looks along the
    /// move.
    /// </summary>
    public Turtle GoTo(double? x, double? y, double? z = null, bool faceTravel = false) => Go(Target(x, y, z), true, faceTravel);

    /// <inheritdoc cref="GoTo(double?, double?, double?, bool)"/>
    public Turtle GoTo(Vec3 point, bool faceTravel = false) => Go(point, true, faceTravel);

    /// <summary>
    /// Moves straight to a point without printing; null keeps a coordinate. The heading stays, or with <paramref name="faceTravel"/> looks along the move.
    /// </summary>
    public Turtle Jump(double? x, double? y, double? z = null, bool faceTravel = false) => Go(Target(x, y, z), false, faceTravel);

    /// <inheritdoc cref="Jump(double?, double?, double?, bool)"/>
    public Turtle Jump(Vec3 point, bool faceTravel = false) => Go(point, false, faceTravel);

    /// <summary>Moves to a point without printing and is level there, heading along an azimuth (Kanada's setTurtle).</summary>
    public Turtle JumpTo(double x, double y, double z, double azimuth)
    {
        MoveTo(new Vec3(x, y, z), deposit: false);
        return SetHeading(azimuth);
    }

    /// <summary>Starts at a point; nothing is moved.</summary>
    /// <exception cref="InvalidOperationException">The turtle has moved already.</exception>
    public Turtle StartAt(double x, double y, double z = 0)
    {
        if (_recorder.HasStarted) throw new InvalidOperationException("The start must come before all moves.");
        var at = new Vec3(x, y, z);
        if (!at.IsFinite) throw NotFinite();
        _state.Pose = Pose.WithOrigin(at);
        if (_poses is not null) _poses[_poses.Count - 1] = Pose;
        return this;
    }

    /// <summary>Remembers the whole state: pose, pen, bead, speed and tags.</summary>
    public Turtle Push()
    {
        _stack.Push(_state);
        return this;
    }

    /// <summary>
    /// Returns to the last pushed state. The return deposits nothing and only states its intent (<see cref="TravelIntent.Return"/>): planning finds a safe
    /// path.
    /// </summary>
    /// <exception cref="InvalidOperationException">Nothing was pushed.</exception>
    public Turtle Pop()
    {
        if (_stack.Count == 0) throw new InvalidOperationException("There is no state to pop.");
        var state = _stack.Pop();
        _recorder.Return(Position, state.Pose.Origin);
        _state = state;
        _poses?.Add(Pose);
        return this;
    }

    /// <summary>Does the same several times: <c>turtle.Repeat(5, t => t.Forward(40).Left(144))</c>.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The count is negative.</exception>
    public Turtle Repeat(int count, Action<Turtle> body)
    {
        if (body is null) throw new ArgumentNullException(nameof(body));
        return Repeat(count, (turtle, _) => body(turtle));
    }

    /// <summary>Does something several times with its number, from 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The count is negative.</exception>
    public Turtle Repeat(int count, Action<Turtle, int> body)
    {
        if (body is null) throw new ArgumentNullException(nameof(body));
        if (count < 0) throw new ArgumentOutOfRangeException(nameof(count), count, "A count is 0 or more.");
        for (var i = 0; i < count; i++) body(this, i);
        return this;
    }

    /// <summary>A copy of this turtle in the same state, without its steps.</summary>
    public Turtle Copy() => new(_options) { _state = _state, AngleUnit = AngleUnit };

    /// <summary>Takes the state of another turtle without recording a move; the next move starts there.</summary>
    public Turtle SetState(Turtle other)
    {
        _state = (other ?? throw new ArgumentNullException(nameof(other)))._state;
        return this;
    }

    /// <summary>
    /// Everything done so far, in order: moves with the pen down as paths with a bead for each segment, others as travels exactly as drawn, and events. Moves
    /// of length 0 are dropped.
    /// </summary>
    public IReadOnlyList<Step> ToSteps() => _recorder.ToSteps();

    /// <summary>What follows comes from a line of a script, from 1; 0 for none.</summary>
    internal void At(string? file, int line)
    {
        _recorder.File = file;
        _recorder.Line = line;
    }

    /// <summary>
    /// The turtle as a triangle of three points that points forward: <paramref name="size"/> mm to the left, as much to the right, and 2.5 times as much
    /// ahead.
    /// </summary>
    public IReadOnlyList<Vec3> Triangle(double size = 2) => TriangleOf(Pose, size);

    /// <inheritdoc cref="Triangle"/>
    public static IReadOnlyList<Vec3> TriangleOf(Frame pose, double size = 2)
        => [pose.Origin + pose.Y * size, pose.Origin - pose.Y * size, pose.Origin + pose.X * (2.5 * size)];

    private Turtle Turn(Frame pose)
    {
        if (!pose.X.IsFinite) throw NotFinite();
        _state.Pose = pose;
        _poses?.Add(pose);
        return this;
    }

    private Turtle Go(Vec3 to, bool deposit, bool faceTravel)
    {
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

    private Vec3 Target(double? x, double? y, double? z) => new(x ?? X, y ?? Y, z ?? Z);

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
