using FlagKey = Caterpillar.Machines.ProfileKey<Caterpillar.Machines.Printer, bool>;
using NumberKey = Caterpillar.Machines.ProfileKey<Caterpillar.Machines.Printer, double>;

namespace Caterpillar.Machines;

// Retraction, lifts and the progress of a print.
public sealed partial record Printer
{
    /// <summary>Filament retracted before a travel; 0 for none.</summary> <value>mm.</value>
    public double RetractionDistance { get; init => field = RetractionKeys.RetractionDistance.Check(value); } = 0.8;

    /// <summary>Speed of retraction, of the filament.</summary> <value>mm/s.</value>
    public double RetractionSpeed { get; init => field = RetractionKeys.RetractionSpeed.Check(value); } = 35;

    /// <summary>Speed of restoring, of the filament; 0 for the retraction speed.</summary> <value>mm/s.</value>
    public double RestoreSpeed { get; init => field = RetractionKeys.RestoreSpeed.Check(value); }

    /// <summary>Extra filament when restoring, beyond what was retracted.</summary> <value>mm.</value>
    public double RestoreExtra { get; init => field = RetractionKeys.RestoreExtra.Check(value); }

    /// <summary>Retraction by the firmware (G10, G11), with its own distance and speed.</summary>
    public bool FirmwareRetraction { get; init; }

    /// <summary>Files state the print time (;TIME) and the progress (M73), if the dialect knows it.</summary>
    public bool ProgressLines { get; init; } = true;

    /// <summary>Clearance of travels above what was printed.</summary> <value>mm.</value>
    public double LiftClearance { get; init => field = RetractionKeys.LiftClearance.Check(value); } = 0.4;

    /// <summary>Speed of moves straight up and down.</summary> <value>mm/s.</value>
    public double LiftSpeed { get; init => field = RetractionKeys.LiftSpeed.Check(value); } = 10;
}

/// <summary>Keys of printers: retraction, lifts and the progress of a print.</summary>
internal static class RetractionKeys
{
    public static readonly KeyTable<Printer> All = new();

    public static readonly NumberKey RetractionDistance
        = All.Number("retraction_distance_mm", 0, 1000, p => p.RetractionDistance, (p, v) => p with { RetractionDistance = v });
    public static readonly NumberKey RetractionSpeed
        = All.Number("retraction_speed_mm_s", 0.01, 10_000, p => p.RetractionSpeed, (p, v) => p with { RetractionSpeed = v });
    public static readonly NumberKey RestoreSpeed = All.Number("restore_speed_mm_s", 0, 10_000, p => p.RestoreSpeed, (p, v) => p with { RestoreSpeed = v });
    public static readonly NumberKey RestoreExtra = All.Number("restore_extra_mm", 0, 1000, p => p.RestoreExtra, (p, v) => p with { RestoreExtra = v });
    public static readonly FlagKey FirmwareRetraction
        = All.Boolean("firmware_retraction", p => p.FirmwareRetraction, (p, v) => p with { FirmwareRetraction = v });
    public static readonly FlagKey ProgressLines = All.Boolean("progress_lines", p => p.ProgressLines, (p, v) => p with { ProgressLines = v });
    public static readonly NumberKey LiftClearance = All.Number("lift_clearance_mm", 0, 1000, p => p.LiftClearance, (p, v) => p with { LiftClearance = v });
    public static readonly NumberKey LiftSpeed = All.Number("lift_speed_mm_s", 0.01, 10_000, p => p.LiftSpeed, (p, v) => p with { LiftSpeed = v });
}
