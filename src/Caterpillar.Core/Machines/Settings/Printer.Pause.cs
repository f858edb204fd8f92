namespace Caterpillar.Machines;

// What a pause does that is put into a print.
public sealed partial record Printer
{
    /// <summary>Height of the nozzle above the print during a pause.</summary> <value>mm.</value> <remarks>0 = no lift.</remarks>
    public double PauseLift { get; init => field = PauseKeys.PauseLift.Check(value); } = 10;

    /// <summary>Position of the head during a pause; empty = corner of the print with minimum X and Y.</summary>
    /// <value>mm.</value> <remarks>One point, or none.</remarks>
    public ValueList<Vec3> PausePark { get; init => field = PauseKeys.PausePark.Check(value); } = new();

    /// <summary>Retraction length for a pause.</summary> <value>mm.</value>
    public double PauseRetraction { get; init => field = PauseKeys.PauseRetraction.Check(value); } = 2;

    /// <summary>Extra filament extruded after a pause.</summary> <value>mm.</value>
    public double PausePrime { get; init => field = PauseKeys.PausePrime.Check(value); }

    /// <summary>G-code for a pause; empty = command of the flavor.</summary>
    public ValueList<string> PauseGCode { get; init => field = PauseKeys.PauseGCode.Check(value); } = new();
}

/// <summary>Keys of printers: pauses.</summary>
internal static class PauseKeys
{
    public static readonly KeyTable<Printer> All = new();

    public static readonly PrinterNumberKey PauseLift = All.Number("pause_lift_mm", 0, 10_000, p => p.PauseLift, (p, v) => p with { PauseLift = v });
    public static readonly ProfileKey<Printer, ValueList<Vec3>> PausePark = All.Of(
        "pause_park_mm", new RowsFormat<Vec3>(["x", "y"], 1, -100_000, 100_000, n => new Vec3(n[0], n[1], 0), v => [v.X, v.Y]), p => p.PausePark,
        (p, v) => p with { PausePark = v });
    public static readonly PrinterNumberKey PauseRetraction
        = All.Number("pause_retraction_mm", 0, 1000, p => p.PauseRetraction, (p, v) => p with { PauseRetraction = v });
    public static readonly PrinterNumberKey PausePrime = All.Number("pause_prime_mm", 0, 1000, p => p.PausePrime, (p, v) => p with { PausePrime = v });
    public static readonly ProfileKey<Printer, ValueList<string>> PauseGCode
        = All.Of("pause_gcode", new LinesFormat(PrintTemplate.Error), p => p.PauseGCode, (p, v) => p with { PauseGCode = v });
}
