namespace Caterpillar.Machines;

/// <summary>
/// A printer: its build volume, its limits and its style of G-code. Lengths in mm, speeds in mm/s, accelerations in mm/s². The keys of profiles are in
/// <see cref="ProfileKeys"/>. A value outside its key's range throws an <see cref="ArgumentOutOfRangeException"/>. Immutable.
/// </summary>
public sealed partial record Printer
{
    /// <summary>Name of the profile.</summary>
    public string Name { get; init; } = "generic";

    /// <summary>Display name.</summary>
    public string Title { get; init => field = PrinterKeys.Title.Check(value); } = "Generic printer";

    /// <summary>Firmware flavor of the G-code.</summary>
    public FlavorRules Flavor { get; init => field = value ?? throw new ArgumentNullException(nameof(value)); } = FlavorTable.Marlin2;

    /// <summary>Size of the space that the nozzle can reach.</summary> <value>mm.</value>
    public Vec3 BuildVolume { get; init => field = PrinterKeys.BuildVolume.Check(value); } = new(220, 220, 250);

    /// <summary>Position of X 0, Y 0 on the bed.</summary>
    public BedOrigin Origin { get; init; } = BedOrigin.Corner;

    /// <summary>Outline of the bed.</summary>
    public BedShape BedShape { get; init; } = BedShape.Rectangle;

    /// <summary>Diameter of the nozzle, or width of the pen.</summary> <value>mm.</value>
    public double NozzleDiameter { get; init => field = PrinterKeys.NozzleDiameter.Check(value); } = 0.4;

    /// <summary>Material to use if none is given.</summary>
    public string DefaultMaterial { get; init => field = PrinterKeys.DefaultMaterial.Check(value); } = "pla";

    /// <summary>Print settings to use if none are given.</summary>
    public string DefaultSettings { get; init => field = PrinterKeys.DefaultSettings.Check(value); } = "standard";

    /// <summary>Relative (M83) or absolute (M82) E.</summary>
    public ExtrusionMode ExtrusionMode { get; init; } = ExtrusionMode.Relative;

    /// <summary>Unit of E: mm of filament or plunger travel, mm³, or none for pens.</summary>
    public ExtrusionUnit ExtrusionUnit { get; init; } = ExtrusionUnit.Mm;

    /// <summary>Write X, Y and Z as relative moves (G91). E is then relative as well.</summary>
    public bool RelativeXyz { get; init; }

    /// <summary>Decimals of X, Y and Z.</summary>
    public int DecimalsXyz { get; init => field = PrinterKeys.DecimalsXyz.Check(value); } = 3;

    /// <summary>Decimals of E.</summary>
    public int DecimalsE { get; init => field = PrinterKeys.DecimalsE.Check(value); } = 5;

    /// <summary>Decimals of F, which is in mm/min.</summary>
    public int DecimalsF { get; init => field = PrinterKeys.DecimalsF.Check(value); }

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

/// <summary>Keys of printers: build volume and G-code format.</summary>
internal static class PrinterKeys
{
    public static readonly KeyTable<Printer> All = new();

    public static readonly ProfileKey<Printer, string> Title = All.Text("title", p => p.Title, (p, v) => p with { Title = v });
    public static readonly ProfileKey<Printer, FlavorRules> Flavor
        = All.Of("gcode_flavor", new ChoiceFormat<FlavorRules>([.. FlavorTable.All.Select(d => (d.Name, d))]), p => p.Flavor, (p, v) => p with { Flavor = v });
    public static readonly ProfileKey<Printer, Vec3> BuildVolume
        = All.Vector("build_volume_mm", 1, 100_000, p => p.BuildVolume, (p, v) => p with { BuildVolume = v });
    public static readonly ProfileKey<Printer, BedOrigin> Origin = All.Choice("origin", p => p.Origin, (p, v) => p with { Origin = v });
    public static readonly ProfileKey<Printer, BedShape> BedShape = All.Choice("bed_shape", p => p.BedShape, (p, v) => p with { BedShape = v });
    public static readonly PrinterNumberKey NozzleDiameter
        = All.Number("nozzle_diameter_mm", 0.01, 200, p => p.NozzleDiameter, (p, v) => p with { NozzleDiameter = v });
    public static readonly ProfileKey<Printer, string> DefaultMaterial
        = All.Text("default_material", p => p.DefaultMaterial, (p, v) => p with { DefaultMaterial = v });
    public static readonly ProfileKey<Printer, string> DefaultSettings
        = All.Text("default_settings", p => p.DefaultSettings, (p, v) => p with { DefaultSettings = v });
    public static readonly ProfileKey<Printer, ExtrusionMode> ExtrusionMode
        = All.Choice("e_mode", p => p.ExtrusionMode, (p, v) => p with { ExtrusionMode = v });
    public static readonly ProfileKey<Printer, ExtrusionUnit> ExtrusionUnit
        = All.Choice("e_unit", p => p.ExtrusionUnit, (p, v) => p with { ExtrusionUnit = v });
    public static readonly PrinterFlagKey RelativeXyz = All.Boolean("relative_xyz", p => p.RelativeXyz, (p, v) => p with { RelativeXyz = v });
    public static readonly PrinterIntegerKey DecimalsXyz = All.Integer("decimals_xyz", 0, 8, p => p.DecimalsXyz, (p, v) => p with { DecimalsXyz = v });
    public static readonly PrinterIntegerKey DecimalsE = All.Integer("decimals_e", 0, 8, p => p.DecimalsE, (p, v) => p with { DecimalsE = v });
    public static readonly PrinterIntegerKey DecimalsF = All.Integer("decimals_f", 0, 8, p => p.DecimalsF, (p, v) => p with { DecimalsF = v });
}
