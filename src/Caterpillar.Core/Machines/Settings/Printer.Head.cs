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

    /// <summary>Boxes around bed clips and other obstacles on the bed, in machine coordinates.</summary> <value>mm.</value>
    public ValueList<Bounds> Clips { get; init => field = Keys.Check(value); } = ValueList<Bounds>.Empty;

    /// <summary>Rectangles of the bed to keep free.</summary> <value>mm.</value> <remarks>In the machine's coordinates.</remarks>
    public ValueList<Bounds> ExcludedAreas { get; init => field = Keys.Check(value); } = ValueList<Bounds>.Empty;

    /// <summary>Coordinates that another word replaces, scaled: X=A*2.86 turns a platform by 2.86 degrees per mm of X, X=A*2.86@110 holds X at 110.</summary>
    /// <remarks>Planning, checks and times use the unrolled surface.</remarks>
    public ValueList<AxisMapping> AxisMappings { get; init => field = Keys.Check(value); } = ValueList<AxisMapping>.Empty;

    /// <summary>Severities of checks that differ from the default. Errors refuse the file.</summary>
    /// <remarks>Defaults are in <see cref="CheckCodes.All"/>.</remarks>
    public ValueList<CheckSeverity> CheckSeverities { get; init => field = Keys.Check(value); } = ValueList<CheckSeverity>.Empty;
}
