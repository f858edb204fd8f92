namespace Caterpillar.Machines;

/// <summary>
/// A printer: its build volume, its limits and its style of G-code. Lengths in mm, speeds in mm/s, accelerations in mm/s². The keys of profiles are in
/// <see cref="ProfileKeys"/>. A value outside its key's range throws an <see cref="ArgumentOutOfRangeException"/>. Immutable.
/// </summary>
public sealed partial record Printer
{
    private static ProfileKind<Printer> Keys => ProfileKinds.Printer;

    /// <summary>Name of the profile.</summary>
    public string Name { get; init; } = "generic";

    /// <summary>Display name.</summary>
    public string Title { get; init => field = Keys.Check(value); } = "Generic printer";

    /// <summary>Firmware flavor of the G-code.</summary>
    public FlavorRules Flavor { get; init => field = value ?? throw new ArgumentNullException(nameof(value)); } = FlavorTable.Marlin2;

    /// <summary>Size of the space that the nozzle can reach.</summary> <value>mm.</value>
    public Vec3 BuildVolume { get; init => field = Keys.Check(value); } = new(220, 220, 250);

    /// <summary>Position of X 0, Y 0 on the bed.</summary>
    public BedOrigin Origin { get; init; } = BedOrigin.Corner;

    /// <summary>Outline of the bed.</summary>
    public BedShape BedShape { get; init; } = BedShape.Rectangle;

    /// <summary>Diameter of the nozzle, or width of the pen.</summary> <value>mm.</value>
    public double NozzleDiameter { get; init => field = Keys.Check(value); } = 0.4;

    /// <summary>Material to use if none is given.</summary>
    public string DefaultMaterial { get; init => field = Keys.Check(value); } = "pla";

    /// <summary>Print settings to use if none are given.</summary>
    public string DefaultSettings { get; init => field = Keys.Check(value); } = "standard";

    /// <summary>Relative (M83) or absolute (M82) E.</summary>
    public ExtrusionMode ExtrusionMode { get; init; } = ExtrusionMode.Relative;

    /// <summary>Unit of E: mm of filament or plunger travel, mm³, or none for pens.</summary>
    public ExtrusionUnit ExtrusionUnit { get; init; } = ExtrusionUnit.Mm;

    /// <summary>Write X, Y and Z as relative moves (G91). E is then relative as well.</summary>
    public bool RelativeXyz { get; init; }

    /// <summary>Decimals of X, Y and Z.</summary>
    public int DecimalsXyz { get; init => field = Keys.Check(value); } = 3;

    /// <summary>Decimals of E.</summary>
    public int DecimalsE { get; init => field = Keys.Check(value); } = 5;

    /// <summary>Decimals of F, which is in mm/min.</summary>
    public int DecimalsF { get; init => field = Keys.Check(value); }

    /// <summary>Number of tools.</summary>
    public int ToolCount => ToolOffsets.Count;

    /// <summary>The box that the nozzle can reach, in the machine's coordinates.</summary>
    public Bounds BuildBounds
    {
        get
        {
            var min = Origin == BedOrigin.Corner ? Vec3.Zero : new Vec3(-BuildVolume.X / 2, -BuildVolume.Y / 2, 0);
            return new Bounds(min, min + BuildVolume);
        }
    }

    /// <summary>True if the nozzle can reach the point, within <paramref name="tolerance"/> mm.</summary>
    public bool CanReach(Vec3 point, double tolerance = 0)
    {
        var bounds = BuildBounds;
        if (!bounds.Contains(point, tolerance)) return false;
        if (BedShape == BedShape.Rectangle) return true;
        var center = bounds.Center;
        var x = (point.X - center.X) / (BuildVolume.X / 2 + tolerance);
        var y = (point.Y - center.Y) / (BuildVolume.Y / 2 + tolerance);
        return x * x + y * y <= 1;
    }

    public override string ToString() => Title;
}
