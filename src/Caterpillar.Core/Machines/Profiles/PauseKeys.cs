using System.Collections.Generic;
using Caterpillar.Geometry;
using K = Caterpillar.Machines.Keys<Caterpillar.Machines.Printer>;

namespace Caterpillar.Machines;

/// <summary>The keys of printers for pauses.</summary>
internal static class PauseKeys
{
    public static readonly ProfileKey<Printer, double> Lift = K.Number(
        "pause_lift_mm", 0, 10_000, p => p.PauseLift, (p, v) => p with { PauseLift = v }, "Height of the nozzle above the print during a pause.");

    public static readonly ProfileKey<Printer, ValueList<Vec3>> Park = new(
        "pause_park_mm", new RowsFormat<Vec3>(["x", "y"], 0, 1, -100_000, 100_000, n => new Vec3(n[0], n[1], 0), v => [v.X, v.Y]),
        p => p.PausePark, (p, v) => p with { PausePark = v },
        "Where the head waits during a pause; without it, the corner with the least X and Y that the print reaches.");

    public static readonly ProfileKey<Printer, double> Retraction = K.Number(
        "pause_retraction_mm", 0, 1000, p => p.PauseRetraction, (p, v) => p with { PauseRetraction = v }, "Filament retracted during a pause.");

    public static readonly ProfileKey<Printer, double> Prime = K.Number(
        "pause_prime_mm", 0, 1000, p => p.PausePrime, (p, v) => p with { PausePrime = v },
        "Extra filament after a pause, beyond what was retracted.");

    public static readonly ProfileKey<Printer, ValueList<string>> Command = K.Lines(
        "pause_command", p => p.PauseCommand, (p, v) => p with { PauseCommand = v }, "Lines that pause; without them, the command of the dialect.");

    public static readonly IReadOnlyList<ProfileKey<Printer>> All = [Lift, Park, Retraction, Prime, Command];
}
