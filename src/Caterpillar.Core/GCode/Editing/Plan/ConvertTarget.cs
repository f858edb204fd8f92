namespace Caterpillar.GCode;

/// <summary>The resolved target of a conversion.</summary>
internal sealed record ConvertTarget
{
    public FlavorRules Flavor { get; private init; } = FlavorTable.Slicer;

    /// <summary>The words that extrude in the target.</summary>
    public ExtrusionAxis Axis { get; private init; } = ExtrusionAxis.None;

    public ConvertOptions Options { get; private init; } = new();

    public bool Millimeters { get; private init; }

    public bool LimitsDecimals => Options.DecimalsXyz is not null || Options.DecimalsE is not null || Options.DecimalsF is not null;

    /// <summary>True if E changes from mm to mm³, or back.</summary>
    public bool ChangesUnit { get; private init; }

    public bool IsVolumetric { get; private init; }

    /// <summary>Diameter for M200, mm. Null = none.</summary>
    public double? StatedDiameter { get; private init; }

    private double[] Factors { get; init; } = [1];

    /// <summary>Units of the target for one unit of E in the file.</summary>
    public double Factor(int tool) => Factors[Math.Min(Math.Max(tool, 0), Factors.Length - 1)];

    /// <summary>The target, or null if the conversion is not possible.</summary>
    public static ConvertTarget? Of(DecodedGCode decoding, ConvertOptions options, DiagnosticList problems)
    {
        var flavor = options.Flavor ?? decoding.Flavor;
        if (AxisOf(decoding, flavor, problems) is not { } axis) return null;
        var target = new ConvertTarget
        {
            Flavor = flavor,
            Axis = axis,
            Options = options,
            Millimeters = options.Millimeters || !flavor.Inches,
        };
        return axis.HasAmounts ? Volumes(target, decoding, problems) : target;
    }

    // The words of extrusion in the target: those of the file in its own flavor, the usual ones in another.
    private static ExtrusionAxis? AxisOf(DecodedGCode decoding, FlavorRules flavor, DiagnosticList problems)
    {
        var axis = decoding.Axis;
        if (flavor.Name == decoding.Flavor.Name || axis == ExtrusionAxis.None) return axis;
        if (axis == ExtrusionAxis.Switched)
        {
            if (flavor.SwitchedExtruder) return axis;
            problems.Add(Severity.Error, "gcode.no_e_values", "The file switches its extruder with M101 and M103 and has no E values, but " + flavor.Title
                + " needs them. Choose a G-code flavor with M101 and M103.");
            return null;
        }
        var letters = flavor.ExtruderLetters;
        if (letters.Length > 0)
        {
            // Words that turn rotary axes here would extrude there.
            var turns = letters[0] != 'E' && decoding.Toolpath.HasTurns && letters.IndexOf("E", StringComparison.Ordinal) >= 0;
            return ExtrusionAxis.Of(turns ? 'E' : letters[0]);
        }
        if (flavor.SwitchedExtruder)
        {
            problems.Add(Severity.Warning, "gcode.e_values_lost", flavor.Title
                + " only switches its extruder on and off (M101, M103). E values and retractions are lost.");
            return ExtrusionAxis.Switched;
        }
        problems.Add(
            Severity.Warning, "gcode.no_extruder",
            flavor.Title + " has no command for extrusion. E, retractions and primes are lost. Printing moves become G1 to G3, travel moves G0.");
        return ExtrusionAxis.None;
    }

    private static ConvertTarget? Volumes(ConvertTarget target, DecodedGCode decoding, DiagnosticList problems)
    {
        var (flavor, options) = (target.Flavor, target.Options);
        var tools = decoding.Toolpath.Tools;
        var stated = decoding.Report.Features.Any(f => f.Key == "m200");
        var isVolumetric = tools[0].VolumePerE == 1;
        // Where nothing is asked for, it depends on what the firmware assumes and on what can be stated to it.
        var volumetric = options.Volumetric
            ?? (flavor.Name == decoding.Flavor.Name ? isVolumetric
                : flavor.StartsVolumetric || (isVolumetric && !decoding.Flavor.StartsVolumetric && !(stated && !flavor.Volumetric)));
        if (volumetric == isVolumetric) return target;
        if (!volumetric && flavor.StartsVolumetric)
        {
            problems.Add(Severity.Error, "gcode.volumetric_only", flavor.Title + " reads E as a volume and would misread lengths. Convert to volumetric E.");
            return null;
        }
        if (volumetric && !flavor.Volumetric && !flavor.StartsVolumetric)
            problems.Add(Severity.Warning, "gcode.volumetric_setup", flavor.Title
                + " has no command for volumetric E (M200). Set up the printer for volumetric E.");
        var areas = FilamentFactors.Areas(decoding.Settings, null);
        var factors = new double[tools.Count];
        for (var i = 0; i < factors.Length; i++)
        {
            var area = options.FilamentDiameter is { } given ? ExtrusionModel.FilamentAreaOf(given)
                : tools[i].VolumePerE is { } known && known != 1 ? known
                : areas.Length == 0 ? null : areas[Math.Min(i, areas.Length - 1)];
            if (!(area > 0))
            {
                problems.Add(Severity.Error, "gcode.diameter_unknown", "E in " + (volumetric ? flavor.Title + " is a volume" : "the file is a volume")
                    + ". The file does not state the filament diameter, which the conversion needs. Enter it.");
                return null;
            }
            factors[i] = volumetric ? area.Value : 1 / area.Value;
        }
        return target with
        {
            ChangesUnit = true,
            IsVolumetric = volumetric,
            Factors = factors,
            StatedDiameter = volumetric && flavor.Volumetric && !flavor.StartsVolumetric ? 2 * Math.Sqrt(factors[0] / Math.PI) : null,
        };
    }
}
