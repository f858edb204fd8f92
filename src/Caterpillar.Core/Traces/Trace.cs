namespace Caterpillar.Traces;

/// <summary>
/// A part made of strings in printing order (Kanada 2016, section 3, <c>draw3dp.Trace</c>). Build it with moves, draws and shapes made of strings, then call
/// <see cref="ToPaths"/>. Lengths are in mm, areas in mm², speeds in mm/s, angles in degrees.
/// </summary>
public sealed class Trace
{
    /// <summary>Default number of strings per turn.</summary>
    public const int DefaultStringsPerTurn = 72;

    // mm/s, which the Z axes of common printers hold.
    private const double RiseSpeed = 5;

    private readonly List<TraceString> _strings = [];

    /// <summary>Stops long shapes with <see cref="OperationCanceledException"/>.</summary>
    public CancellationToken Cancel { get; init; }

    /// <summary>An empty part at a point.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The area is negative or not finite.</exception>
    public Trace(double area, Vec3 start = default)
    {
        Area = CheckNotNegative(area, nameof(area));
        Position = start;
    }

    /// <summary>Cross-section of the following strings, mm².</summary>
    public double Area { get; private set; }

    /// <summary>Speed of the following strings, mm/s; 0 = printing speed of the settings.</summary>
    public double Speed { get; private set; }

    /// <summary>Current position.</summary>
    public Vec3 Position { get; private set; }

    /// <summary>The strings so far, in printing order.</summary>
    public IReadOnlyList<TraceString> Strings => _strings;

    /// <summary>Sets the cross-section of the following strings (Kanada: <c>setCrossSection</c>, <c>thickness</c>).</summary>
    public Trace SetArea(double area)
    {
        Area = CheckNotNegative(area, nameof(area));
        return this;
    }

    /// <summary>Sets the speed of the following strings (Kanada: <c>setVelocity</c>, <c>speed</c>).</summary>
    public Trace SetSpeed(double speed)
    {
        Speed = CheckNotNegative(speed, nameof(speed));
        return this;
    }

    /// <summary>Moves to a point without a string.</summary>
    public Trace Move(Vec3 to)
    {
        Position = CheckFinite(to, nameof(to));
        return this;
    }

    /// <summary>Adds a string to a point.</summary>
    public Trace Draw(Vec3 to) => Draw(to, Area);

    /// <summary>Adds an exactly closed polygon of equal strings on a horizontal circle, counterclockwise from <paramref name="from"/> degrees.</summary>
    public Trace Circle(Vec3 center, double radius, int strings = DefaultStringsPerTurn, double from = 0)
    {
        CheckPositive(radius, nameof(radius));
        if (strings < 3) throw new ArgumentOutOfRangeException(nameof(strings), "A circle needs at least three strings.");
        var first = OnCircle(center, radius, from);
        Move(first);
        for (var i = 1; i < strings; i++) Draw(OnCircle(center, radius, from + 360.0 * i / strings));
        return Draw(first);
    }

    /// <summary>Adds a flat counterclockwise spiral from the center to the radius, or inward, with <paramref name="pitch"/> mm between turns.</summary>
    public Trace Spiral(Vec3 center, double radius, double pitch, int stringsPerTurn = DefaultStringsPerTurn, bool inwards = false)
    {
        CheckPositive(radius, nameof(radius));
        CheckPositive(pitch, nameof(pitch));
        // Inward it starts where an outward spiral ends, so that spirals can be stacked.
        var turns = radius / pitch;
        return Turns(turns, stringsPerTurn, t => inwards ? OnCircle(center, (turns - t) * pitch, 360 * (turns + t)) : OnCircle(center, t * pitch, 360 * t));
    }

    /// <summary>
    /// Adds a hollow cylinder without layers or seams. With n strings per turn, vertex i is at the angle 360°·i/n and the height pitch·i/n. The last vertex is
    /// at the given height. The ramp changes the flow at both ends.
    /// </summary>
    public Trace Helix(Vec3 center, double radius, double height, double pitch, int stringsPerTurn = DefaultStringsPerTurn, FlowRamp? ramp = null)
        => Cone(center, radius, radius, height, pitch, stringsPerTurn, ramp);

    /// <summary>Adds a hollow cone or frustum: a helix whose radius changes linearly with the height.</summary>
    public Trace Cone(
        Vec3 center, double bottomRadius, double topRadius, double height, double pitch, int stringsPerTurn = DefaultStringsPerTurn, FlowRamp? ramp = null)
    {
        CheckNotNegative(bottomRadius, nameof(bottomRadius));
        CheckNotNegative(topRadius, nameof(topRadius));
        CheckPositive(height, nameof(height));
        CheckPositive(pitch, nameof(pitch));
        return Turns(
            height / pitch,
            stringsPerTurn,
            t => OnCircle(center + new Vec3(0, 0, t * pitch), bottomRadius + (topRadius - bottomRadius) * (t * pitch / height), 360 * t),
            ramp);
    }

    /// <summary>
    /// Adds a filled cylinder of stacked flat spirals, alternately outward and inward. The first is at the height of the center. The number of spirals is the
    /// height divided by the vertical pitch, rounded.
    /// </summary>
    public Trace Cylinder(Vec3 center, double radius, double height, double verticalPitch, double horizontalPitch, int stringsPerTurn = DefaultStringsPerTurn)
    {
        CheckPositive(height, nameof(height));
        CheckPositive(verticalPitch, nameof(verticalPitch));
        var layers = Math.Max(1, (int)Math.Min(Math.Floor(height / verticalPitch + 0.5), 1_000_000));
        for (var layer = 0; layer < layers; layer++)
        {
            var at = center + new Vec3(0, 0, layer * verticalPitch);
            // The next spiral starts above the end of the last: the move up is short and prints.
            if (layer > 0) Rise(at.Z);
            Spiral(at, radius, horizontalPitch, stringsPerTurn, inwards: layer % 2 == 1);
        }
        return this;
    }

    /// <summary>Adds rings around a point, from the outside in, to prime the nozzle before the part starts.</summary>
    public Trace Skirt(Vec3 center, double radius, int loops = 1, double pitch = 0.5, int strings = DefaultStringsPerTurn)
    {
        if (loops < 1) throw new ArgumentOutOfRangeException(nameof(loops), "A skirt needs at least one loop.");
        for (var loop = loops - 1; loop >= 0; loop--) Circle(center, radius + loop * pitch, strings);
        return this;
    }

    /// <summary>
    /// The strings as paths. Connected strings become one path, of which <see cref="PathMerging.JoinShort"/> joins those that are too short. A move begins
    /// another path.
    /// </summary>
    public IReadOnlyList<PrintPath> ToPaths()
    {
        var paths = new List<PrintPath>();
        for (var first = 0; first < _strings.Count;)
        {
            var end = first + 1;
            while (end < _strings.Count && _strings[end].Start == _strings[end - 1].End) end++;
            var points = new Vec3[end - first + 1];
            var beads = new Bead[end - first];
            points[0] = _strings[first].Start;
            for (var i = first; i < end; i++)
            {
                points[i - first + 1] = _strings[i].End;
                beads[i - first] = new Bead(_strings[i].Area, 0, _strings[i].Speed);
            }
            paths.Add(new PrintPath(points, beads));
            first = end;
        }
        return paths;
    }

    private static Vec3 OnCircle(Vec3 center, double radius, double degrees)
    {
        var (sin, cos) = Angle.SinCos(degrees);
        return new Vec3(center.X + radius * cos, center.Y + radius * sin, center.Z);
    }

    private static double CheckPositive(double value, string name)
        => value > 0 && !double.IsInfinity(value) ? value : throw new ArgumentOutOfRangeException(name, "The value must be positive and finite.");

    private static double CheckNotNegative(double value, string name)
        => value >= 0 && !double.IsInfinity(value) ? value : throw new ArgumentOutOfRangeException(name, "The value must be 0 or more and finite.");

    private static Vec3 CheckFinite(Vec3 point, string name)
        => point.IsFinite ? point : throw new ArgumentOutOfRangeException(name, "The point is not finite.");

    private Trace Draw(Vec3 to, double area)
    {
        if (CheckFinite(to, nameof(to)) == Position) return this;
        if ((_strings.Count & 0xFFF) == 0) Cancel.ThrowIfCancellationRequested();
        _strings.Add(new TraceString(Position, to, area, Speed));
        Position = to;
        return this;
    }

    // Straight up, no faster than Z axes go.
    private void Rise(double z)
    {
        var speed = Speed;
        SetSpeed(speed > 0 ? Math.Min(speed, RiseSpeed) : RiseSpeed).Draw(Position.WithZ(z)).SetSpeed(speed);
    }

    private Trace Turns(double turns, int stringsPerTurn, Func<double, Vec3> at, FlowRamp? ramp = null)
    {
        if (stringsPerTurn < 3) throw new ArgumentOutOfRangeException(nameof(stringsPerTurn), "A turn needs at least three strings.");
        if (turns * stringsPerTurn > 100_000_000)
            throw new ArgumentOutOfRangeException(nameof(turns), "The part has more than 100 million strings. Increase the pitch.");
        Move(at(0));
        // A last string as short as rounding errors is dropped.
        var strings = (int)Math.Ceiling(turns * stringsPerTurn - 1e-9);
        for (var i = 1; i <= strings; i++)
        {
            var from = (i - 1.0) / stringsPerTurn;
            var to = i == strings ? turns : (double)i / stringsPerTurn;
            var middle = (from + to) / 2;
            Draw(at(to), Area * (ramp?.At(middle, turns - middle) ?? 1));
        }
        return this;
    }
}
