namespace Caterpillar.Machines;

// Tools, head, and what it must not hit.
public sealed partial record Printer
{
    /// <summary>Offset of each tool from the first one.</summary> <value>mm.</value>
    public ValueList<Vec3> ToolOffsets { get; init => field = Keys.Check(value); } = new(Vec3.Zero);

    /// <summary>The tools feed one nozzle: a tool change swaps the filament. Otherwise each tool has a nozzle of its own, which it heats.</summary>
    public bool SharedNozzle { get; init; }

    /// <summary>Profile of nozzle and head: radius at each height above the tip.</summary> <value>mm.</value> <remarks>Radius and height ascend.</remarks>
    public ValueList<HeadPoint> HeadOutline { get; init => field = Keys.Check(value); }
        = new(new HeadPoint(0.5, 0), new(4, 6), new(20, 12));

    /// <summary>Boxes around parts of the head that are not round, relative to the nozzle tip.</summary> <value>mm.</value>
    public ValueList<Bounds> HeadBoxes { get; init => field = Keys.Check(value); } = ValueList<Bounds>.Empty;

    /// <summary>Beams along X across the whole bed that hold the head, relative to the nozzle tip.</summary>
    /// <value>mm.</value> <remarks>X is ignored.</remarks>
    public ValueList<Bounds> Gantry { get; init => field = Keys.Check(value); } = ValueList<Bounds>.Empty;

    /// <summary>The beams of the gantry as boxes that reach so far to both sides, mm.</summary>
    internal IEnumerable<Bounds> Beams(double reach) => Gantry.Select(b => new Bounds(b.Min with { X = -reach }, b.Max with { X = reach }));

    /// <summary>Boxes around bed clips and other obstacles on the bed, in machine coordinates.</summary> <value>mm.</value>
    public ValueList<Bounds> Clips { get; init => field = Keys.Check(value); } = ValueList<Bounds>.Empty;

    /// <summary>Rectangles of the bed to keep free.</summary> <value>mm.</value> <remarks>In the machine's coordinates.</remarks>
    public ValueList<Bounds> ExcludedAreas { get; init => field = Keys.Check(value); } = ValueList<Bounds>.Empty;

    /// <summary>Coordinates that another word replaces, scaled: X=A*2.86 turns a platform by 2.86 degrees per mm of X, X=A*2.86@110 holds X at 110.</summary>
    /// <remarks>Planning, checks and times use the unrolled surface.</remarks>
    public ValueList<AxisMapping> AxisMappings { get; init => field = Keys.Check(value); } = ValueList<AxisMapping>.Empty;

    /// <summary>
    /// Axes that turn the head or the work, outer ones first: word, what it turns, direction at rest (-y counts the other way), then what is known of the rest:
    /// a point of the axis, limits in degrees, speed in degrees/s, acceleration in degrees/s²: B head y at 0 0 42 from -110 to 110 speed 60 acceleration 500.
    /// </summary>
    /// <remarks>Points of the head are relative to the nozzle tip. No limits = endless.</remarks>
    public ValueList<RotaryAxis> RotaryAxes { get; init => field = Keys.Check(value); } = ValueList<RotaryAxis>.Empty;

    /// <summary>What X, Y and Z say with rotary axes.</summary>
    public RotaryPositions RotaryPositions { get; init; }

    /// <summary>Range of the slides of a printer with rotary axes; empty = any.</summary> <value>mm.</value>
    public ValueList<Bounds> SlideRange { get; init => field = Keys.Check(value); } = ValueList<Bounds>.Empty;

    /// <summary>What the words of the rotary axes mean; null without such axes.</summary>
    public Kinematics? Kinematics => RotaryAxes.Count == 0 ? null : new Kinematics(RotaryAxes, RotaryPositions == RotaryPositions.Polar);

    /// <summary>Severities of checks that differ from the default. Errors refuse the file.</summary>
    /// <remarks>Defaults are in <see cref="CheckCodes.All"/>.</remarks>
    public ValueList<CheckSeverity> CheckSeverities { get; init => field = Keys.Check(value); } = ValueList<CheckSeverity>.Empty;
}
