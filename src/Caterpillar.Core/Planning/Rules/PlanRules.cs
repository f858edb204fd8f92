namespace Caterpillar.Planning;

/// <summary>A tool as planning needs it. Amounts of E are in its own unit.</summary>
/// <param name="VolumePerE">mm³ per unit of E; null for a tool without E.</param>
/// <param name="RetractE">E of a retraction; 0 = off.</param>
/// <param name="RetractSpeed">mm/s of filament.</param>
/// <param name="DeretractionSpeed">mm/s of filament.</param>
/// <param name="ExtraE">Extra E beyond the balance after each restore.</param>
/// <param name="LengthPerE">mm of filament per unit of E.</param>
internal sealed record ToolRules(double? VolumePerE, double RetractE, double RetractSpeed, double DeretractionSpeed, double ExtraE, double LengthPerE = 1)
{
    /// <summary>Pressure advance, s; null = no command.</summary>
    public double? PressureAdvance { get; init; }

    /// <summary>Material that machine and tool can push, mm³/s.</summary>
    public double MaxFlow { get; init; } = double.PositiveInfinity;

    /// <summary>Its temperatures, fan, Z-hop and wipe; null = none are known.</summary>
    public Material? Material { get; init; }

    /// <summary>Temperature without overrides, °C; null if the material does not state it.</summary>
    public double? Temperature(bool isFirstLayer) => Material is not { NozzleTemperature: > 0 } material ? null
        : isFirstLayer && material.FirstLayerNozzleTemperature > 0 ? material.FirstLayerNozzleTemperature : material.NozzleTemperature;

    /// <summary>E per mm³ of material; 0 = a tool without E.</summary>
    public double EOf(double volume) => VolumePerE is { } unit ? volume / unit : 0;

    /// <summary>mm of filament for an amount of E.</summary>
    public double FilamentLength(double e) => e * LengthPerE;
}

/// <summary>Settings and printer, and what planning needs of both and of the material, resolved. Lengths in mm, speeds in mm/s.</summary>
/// <param name="Policy">What planning adds.</param>
/// <param name="Settings">The settings.</param>
/// <param name="Printer">The printer.</param>
/// <param name="Tools">The tools, by their number.</param>
internal sealed record PlanRules(PlanPolicy Policy, PrintSettings Settings, Printer Printer, ToolRules[] Tools)
{
    /// <summary>The last decimal of coordinates in the file.</summary>
    public double Rounded => Math.Pow(10, -Printer.DecimalsXyz);

    /// <summary>Height of a travel above what it passes.</summary>
    public double Clearance { get; init; }

    /// <summary>The space that the head needs along a travel, for the above_path.</summary>
    public HeadCorridor Head { get; init; } = new([(0.5, 0)]);

    /// <summary>The underside of nozzle and head, and boxes around its other parts, as the checks know them.</summary>
    public HeadShape Outline { get; init; } = new([(0.5, 0)]);

    /// <inheritdoc cref="Outline"/>
    public ValueList<Bounds> HeadBoxes { get; init; } = ValueList<Bounds>.Empty;

    /// <summary>Side of the cells of what is printed so far.</summary>
    public double Cell => Math.Max(0.25, Settings.LineWidth / 4);

    /// <summary>True if the machine waits after layers shorter than the minimum layer time.</summary>
    public bool Waits => !AddsNothing && Settings.LayerTimeWait != LayerTimeWait.None;

    public double WipeDistance { get; init; }

    /// <summary>False for firmware retraction, which cannot be spread over a move.</summary>
    public bool CanWipe => !Printer.FirmwareRetraction;

    /// <summary>The value without overrides; null if the material does not state it.</summary>
    public double? BedTemperature => Tools[0].Material is { BedTemperature: > 0 and var celsius } ? celsius : null;

    /// <summary>The same in the first layer, if it differs.</summary>
    public double? FirstLayerBedTemperature
        => Tools[0].Material is { BedTemperature: > 0, FirstLayerBedTemperature: > 0 and var celsius } ? celsius : null;

    /// <summary>Accelerations and jerk by role; null = none is commanded.</summary>
    public CommandedMotion? Motion { get; init; }

    /// <summary>Settings of the firmware retraction; null = those of the firmware.</summary>
    public RetractionEvent? FirmwareRetraction { get; init; }

    /// <summary>Speed of a segment of a path, mm/s, as far as the flow allows.</summary>
    public double SpeedOf(PrintPath path, in Bead bead, bool firstLayer)
    {
        var speed = bead.Speed > 0 ? bead.Speed : Settings.SpeedOf(path.Role, firstLayer);
        var most = Tools[path.Tool].MaxFlow;
        return speed * bead.Area > most ? most / bead.Area : speed;
    }

    /// <summary>Number of the layer of a path, or, if it has none and the policy is the printer's, of a height above the bed; −1 otherwise.</summary>
    public int LayerOf(PrintPath path, double z)
    {
        const double Rounding = 1e-6;
        if (path.Layer is { } layer) return layer.Index;
        if (AddsNothing) return -1;
        var above = z - Settings.FirstLayerHeight - Rounding;
        return above <= 0 ? 0 : (int)Math.Min(1e6, Math.Ceiling(above / Settings.LayerHeight));
    }

    public bool AddsNothing => Policy == PlanPolicy.AsDrawn;
}
