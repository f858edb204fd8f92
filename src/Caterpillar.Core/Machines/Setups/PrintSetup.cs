using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Machines;

/// <summary>Everything that planning, writing and checking need: printer, material and settings. Immutable.</summary>
public sealed record PrintSetup
{
    /// <summary>The generic printer with PLA and standard settings, without start and end code.</summary>
    public PrintSetup()
        : this(new Printer(), new Material(), new PrintSettings())
    {
    }

    /// <summary>Printer, material and settings of a print.</summary>
    public PrintSetup(Printer printer, Material material, PrintSettings settings)
    {
        Printer = printer ?? throw new ArgumentNullException(nameof(printer));
        Material = material ?? throw new ArgumentNullException(nameof(material));
        Settings = settings ?? throw new ArgumentNullException(nameof(settings));
    }

    /// <summary>The machine.</summary>
    public Printer Printer { get; init; }

    /// <summary>What is printed.</summary>
    public Material Material { get; init; }

    /// <summary>How it is printed.</summary>
    public PrintSettings Settings { get; init; }

    /// <summary>
    /// An object that already lies on the bed and is printed on, at its place, mm: travels stay above it, extrusions may lie on it, and the checks find where
    /// the head goes through it. Null for none.
    /// </summary>
    public TriMesh? PrintedOn { get; init; }

    /// <summary>Makes checks of your own, one of each for every file that is checked or written.</summary>
    public ValueList<Func<IOwnCheck>> OwnChecks { get; init; } = ValueList<Func<IOwnCheck>>.Empty;

    /// <summary>Converts extrusions to amounts of E.</summary>
    public ExtrusionModel Extrusion => new(Printer.ExtrusionUnit, Material.FilamentDiameter, Material.FlowRatio);

    /// <summary>Maximum flow of machine and material, mm³/s; infinite if both are unknown.</summary>
    public double MaxFlow
    {
        get
        {
            var machine = Printer.MaxFlow > 0 ? Printer.MaxFlow : double.PositiveInfinity;
            var material = Material.MaxFlow > 0 ? Material.MaxFlow : double.PositiveInfinity;
            return Math.Min(machine, material);
        }
    }

    /// <summary>
    /// The setup with other values, each as <c>key=value</c> with any key of the three profiles: <c>layer_height_mm=0.3</c>,
    /// <c>build_volume_mm=300,300,400</c>. Unknown keys and bad values are errors that name the key; then there is no setup.
    /// </summary>
    public Result<PrintSetup> With(params string[] values) => With((IEnumerable<string>)values);

    /// <inheritdoc cref="With(string[])"/>
    public Result<PrintSetup> With(IEnumerable<string> values) => SetupValues.Apply(this, values ?? throw new ArgumentNullException(nameof(values)));

    /// <summary>Finds values of this setup that conflict. Errors make it unusable.</summary>
    public IReadOnlyList<Diagnostic> Check()
    {
        var diagnostics = new DiagnosticList();
        if (Settings.BeadShape == BeadShape.Stadium && Settings.LineWidth < Math.Max(Settings.LayerHeight, Settings.FirstLayerHeight))
            diagnostics.Add(Severity.Error, "setup.narrow_bead",
                "line_width_mm is less than the layer height, which bead_shape stadium does not allow; use rectangle or circle.",
                new SourceLocation(Key: "line_width_mm"));
        if (Printer.ExtrusionUnit != ExtrusionUnit.None && Math.Max(Settings.LayerHeight, Settings.FirstLayerHeight) > Printer.NozzleDiameter)
            diagnostics.Add(Severity.Warning, "setup.layer_height", "The layer height exceeds the nozzle diameter: extrusions will hardly bond to each other.",
                new SourceLocation(Key: "layer_height_mm"));
        if (Settings.AdaptiveLayers && Settings.AdaptiveMinHeight > Settings.AdaptiveMaxHeight)
            diagnostics.Add(Severity.Error, "setup.adaptive_heights", "adaptive_min_height_mm is greater than adaptive_max_height_mm.",
                new SourceLocation(Key: "adaptive_min_height_mm"));
        if (Printer.FirmwareRetraction && !Printer.Flavor.FirmwareRetraction)
            diagnostics.Add(Severity.Error, "setup.no_firmware_retraction", $"{Printer.Flavor.Title} has no firmware retraction.",
                new SourceLocation(Key: "firmware_retraction"));
        return diagnostics.ToList();
    }
}
