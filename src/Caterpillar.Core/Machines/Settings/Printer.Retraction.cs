namespace Caterpillar.Machines;

// Retraction and lifts.
public sealed partial record Printer
{
    /// <summary>Retraction length; 0 = off.</summary> <value>mm.</value>
    public double RetractionLength { get; init => field = RetractionKeys.RetractionLength.Check(value); } = 0.8;

    /// <summary>Retraction speed.</summary> <value>mm/s.</value>
    public double RetractionSpeed { get; init => field = RetractionKeys.RetractionSpeed.Check(value); } = 35;

    /// <summary>Deretraction speed; 0 = retraction speed.</summary> <value>mm/s.</value>
    public double DeretractionSpeed { get; init => field = RetractionKeys.DeretractionSpeed.Check(value); }

    /// <summary>Extra filament extruded after each deretraction.</summary> <value>mm.</value>
    public double DeretractionExtra { get; init => field = RetractionKeys.DeretractionExtra.Check(value); }

    /// <summary>Retract with G10 and G11. Length and speed are set in the firmware.</summary>
    public bool FirmwareRetraction { get; init; }

    /// <summary>Z-hop: height of travel moves above what has been printed.</summary> <value>mm.</value>
    public double ZHop { get; init => field = RetractionKeys.ZHop.Check(value); } = 0.4;

    /// <summary>Speed of vertical travel moves.</summary> <value>mm/s.</value>
    public double ZHopSpeed { get; init => field = RetractionKeys.ZHopSpeed.Check(value); } = 10;
}

/// <summary>Keys of printers: retraction and Z-hop.</summary>
internal static class RetractionKeys
{
    public static readonly KeyTable<Printer> All = new();

    public static readonly PrinterNumberKey RetractionLength
        = All.Number("retraction_length_mm", 0, 1000, p => p.RetractionLength, (p, v) => p with { RetractionLength = v });
    public static readonly PrinterNumberKey RetractionSpeed
        = All.Number("retraction_speed_mm_s", 0.01, 10_000, p => p.RetractionSpeed, (p, v) => p with { RetractionSpeed = v });
    public static readonly PrinterNumberKey DeretractionSpeed
        = All.Number("deretraction_speed_mm_s", 0, 10_000, p => p.DeretractionSpeed, (p, v) => p with { DeretractionSpeed = v });
    public static readonly PrinterNumberKey DeretractionExtra
        = All.Number("deretraction_extra_mm", 0, 1000, p => p.DeretractionExtra, (p, v) => p with { DeretractionExtra = v });
    public static readonly PrinterFlagKey FirmwareRetraction
        = All.Boolean("firmware_retraction", p => p.FirmwareRetraction, (p, v) => p with { FirmwareRetraction = v });
    public static readonly PrinterNumberKey ZHop = All.Number("z_hop_mm", 0, 1000, p => p.ZHop, (p, v) => p with { ZHop = v });
    public static readonly PrinterNumberKey ZHopSpeed = All.Number("z_hop_speed_mm_s", 0.01, 10_000, p => p.ZHopSpeed, (p, v) => p with { ZHopSpeed = v });
}
