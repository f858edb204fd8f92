namespace Caterpillar.Machines;

/// <summary>Printer, material and settings: the input for planning, writing and checking. Immutable.</summary>
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

    /// <summary>The printer.</summary>
    public Printer Printer
    {
        get;
        init
        {
            field = value;
            if (Settings is { } settings) Settings = settings;
        }
    }

    /// <summary>The material, or with several tools that of tool 0.</summary>
    public Material Material { get; init; }

    /// <summary>The materials of the tools from 1 on. A tool beyond the list has the material of tool 0.</summary>
    public ValueList<Material> ToolMaterials { get; init; } = ValueList<Material>.Empty;

    /// <summary>The print settings. Line width and heights that they do not give follow from the nozzle of the printer.</summary>
    public PrintSettings Settings
    {
        get;
        init => field = value.NozzleDiameter == Printer.NozzleDiameter ? value : value with { NozzleDiameter = Printer.NozzleDiameter };
    }

    /// <summary>
    /// An object on the bed to print on, at its position, in mm. Travel moves stay above it, extrusions may rest on it, and checks find collisions
    /// with it. Null = none.
    /// </summary>
    public TriMesh? PrintedOn { get; init; }

    /// <summary>Factories of your own checks. Each checked or written file gets new instances.</summary>
    public ValueList<Func<IOwnCheck>> OwnChecks { get; init; } = ValueList<Func<IOwnCheck>>.Empty;

    /// <summary>Converts extrusions to E.</summary>
    public ExtrusionModel Extrusion => new(Printer.ExtrusionUnit, Material.FilamentDiameter, Material.FlowRatio);

    /// <summary>Maximum volumetric flow of printer and material, mm³/s, also in the first layer; infinite if both are unknown.</summary>
    public double MaxFlow => Math.Min(MaxFlowAt(Material.NozzleTemperature),
        MaxFlowAt(Material.FirstLayerNozzleTemperature > 0 ? Material.FirstLayerNozzleTemperature : Material.NozzleTemperature));

    /// <summary>The same at a temperature of the nozzle, °C.</summary>
    internal double MaxFlowAt(double temperature)
    {
        var material = Material.FlowLimits.Count > 0 ? FlowLimit.At(Material.FlowLimits, temperature) : Material.MaxFlow;
        return new[] { Printer.MaxFlow, material }.Where(flow => flow > 0).DefaultIfEmpty(double.PositiveInfinity).Min();
    }

    /// <summary>The setup with the material of a tool.</summary>
    public PrintSetup OfTool(int tool) => tool > 0 && tool <= ToolMaterials.Count ? this with { Material = ToolMaterials[tool - 1] } : this;

    /// <summary>Retraction length of the material, or of the printer, mm.</summary>
    internal double RetractionLength => Material.RetractionLength ?? Printer.RetractionLength;

    /// <summary>Retraction speed of the material, or of the printer, mm/s.</summary>
    internal double RetractionSpeed => Material.RetractionSpeed ?? Printer.RetractionSpeed;

    /// <summary>Z-hop of the material, or of the printer, mm.</summary>
    internal double ZHop => Material.ZHop ?? Printer.ZHop;

    /// <summary>Wipe distance of the material, or of the settings, mm.</summary>
    internal double WipeDistance => Material.WipeDistance ?? Settings.WipeDistance;

    /// <summary>
    /// The setup with other values, each as <c>key=value</c> with any key of the three profiles: <c>layer_height_mm=0.3</c>,
    /// <c>build_volume_mm=300,300,400</c>. Unknown keys and invalid values are errors that name the key. Then the result has no setup.
    /// </summary>
    public Result<PrintSetup> With(params string[] values) => With((IEnumerable<string>)values);

    /// <inheritdoc cref="With(string[])"/>
    public Result<PrintSetup> With(IEnumerable<string> values) => SetupValues.Apply(this, values ?? throw new ArgumentNullException(nameof(values)));

    /// <summary>The keys of settings, printer and material with their values as text, which <see cref="With(string[])"/> reads. Titles are left out.</summary>
    public IReadOnlyList<KeyValuePair<string, string>> Values() => SetupValues.Of(this);

    /// <summary>The keys whose values differ from those of another setup, with both values. Names of default profiles do not count.</summary>
    public IReadOnlyList<(string Key, string Value, string Other)> Differences(PrintSetup other)
    {
        if (other is null) throw new ArgumentNullException(nameof(other));
        return Values().Zip(other.Values(), (one, two) => (one.Key, one.Value, Other: two.Value))
            .Where(d => d.Value != d.Other && d.Key is not ("default_material" or "default_settings")).ToArray();
    }

    /// <summary>Finds conflicting values of this setup. A setup with errors cannot be used.</summary>
    public IReadOnlyList<Diagnostic> Check()
    {
        var diagnostics = new DiagnosticList();
        if (FromNozzle() is { Length: > 0 } sizes)
            diagnostics.Add(Severity.Note, "setup.from_nozzle", $"The nozzle of {NumberFormatter.Format(Printer.NozzleDiameter, 4)} mm sets {sizes}.");
        var widths = ProfileKinds.Settings.Keys.Where(k => k.Name.EndsWith("line_width_mm", StringComparison.Ordinal));
        if (Settings.BeadShape == BeadShape.Stadium && widths.FirstOrDefault(IsNarrow) is { } narrow)
            diagnostics.Add(Severity.Error, "setup.narrow_bead",
                $"{narrow} is less than the layer height. bead_shape=stadium does not allow that. Use rectangle or circle.",
                new SourceLocation(Key: narrow.Name));
        if (Printer.ExtrusionUnit != ExtrusionUnit.None && Settings.LargerLayerHeight > Printer.NozzleDiameter)
            diagnostics.Add(Severity.Warning, "setup.layer_height",
                "The layer height exceeds the nozzle diameter: extrusions will bond poorly. Use thinner layers or a larger nozzle.",
                new SourceLocation(Key: "layer_height_mm"));
        if (Settings.AdaptiveLayers && Settings.AdaptiveMinHeight > Settings.AdaptiveMaxHeight)
            diagnostics.Add(Severity.Error, "setup.adaptive_heights", "adaptive_min_height_mm is greater than adaptive_max_height_mm.",
                new SourceLocation(Key: "adaptive_min_height_mm"));
        if (ToolMaterials.Count >= Printer.ToolCount)
            diagnostics.Add(Severity.Error, "setup.materials", $"{NumberFormatter.Format(ToolMaterials.Count + 1)} materials need as many tools: set "
                + $"tool_offsets_mm of {Printer.Title} to a list with a row for each.", new SourceLocation(Key: "tool_offsets_mm"));
        if (Printer.FirmwareRetraction && !Printer.Flavor.FirmwareRetraction)
            diagnostics.Add(Severity.Error, "setup.no_firmware_retraction",
                $"{Printer.Flavor.Title} has no firmware retraction: set firmware_retraction=false.",
                new SourceLocation(Key: "firmware_retraction"));
        SetupFindings.Add(this, diagnostics);
        return diagnostics.ToList();
    }

    private bool IsNarrow(ProfileKey<PrintSettings> width) => width.Get(Settings) is > 0.0 and double size
        && size < (width.Name == "first_layer_line_width_mm" ? Settings.FirstLayerHeight : Settings.LargerLayerHeight);

    // Sizes that nobody gave, unless the nozzle is the usual one.
    private string FromNozzle()
    {
        if (Printer.NozzleDiameter == PrintSettings.UsualNozzle) return "";
        var given = Settings.AsGiven;
        var sizes = ProfileKinds.Settings.KeysOf("line_width_mm", "layer_height_mm", "first_layer_height_mm");
        return string.Join(", ", sizes.Where(k => k.Get(given) is 0.0).Select(k => k.Name + "=" + NumberFormatter.Format((double)k.Get(Settings), 4)));
    }
}
