using Caterpillar.Flavors;

namespace Caterpillar.Machines;

/// <summary>Values of a setup that a file for its printer cannot pass on, or not entirely.</summary>
internal static class SetupFindings
{
    /// <summary>A warning about values without effect, and a note about values beyond the printer.</summary>
    public static IEnumerable<Diagnostic> Of(PrintSetup setup)
    {
        var (printer, material, flavor, motion) = (setup.Printer, setup.Material, setup.Printer.Flavor, setup.Motion);
        var lost = new List<(string Why, ProfileKey[] Keys)>
        {
            ($"{flavor.Title} has no command for accelerations", motion.KnowsAccelerations ? [] : motion.Asked(CommandedMotion.Accelerations)),
            (printer.Cornering == Cornering.JunctionDeviation ? "The printer has cornering=junction_deviation" : $"{flavor.Title} has no command for jerk",
                motion.JerkCommand is not null ? [] : motion.Asked(CommandedMotion.Jerks)),
            ($"{flavor.Title} has no command for pressure advance",
                material.PressureAdvance is null || PressureAdvance(flavor, 0, 0).Count > 0 ? [] : [MaterialKeys.PressureAdvance]),
            ($"start_gcode of {printer.Title} does not heat a chamber",
                material.ChamberTemperature == 0 || printer.StartGCode.Any(Heats) ? [] : [MaterialKeys.ChamberTemperature]),
            ($"{flavor.Title} has no command for the length of its firmware retraction",
                !printer.FirmwareRetraction || flavor.RetractionSettings != RetractionCommands.None ? []
                    : [.. new[] { MaterialKeys.RetractionLength, MaterialKeys.RetractionSpeed }.Where(k => k.Get(material) is double)]),
        };
        lost.RemoveAll(l => l.Keys.Length == 0);
        if (lost.Count > 0)
        {
            var sentences = lost.Select(l => $"{l.Why}: {string.Join<ProfileKey>(", ", l.Keys)} {(l.Keys.Length == 1 ? "has" : "have")} no effect.");
            yield return new Diagnostic(Severity.Warning, "setup.no_command", string.Join(" ", sentences), new SourceLocation(Key: lost[0].Keys[0].Name));
        }
        var above = motion.Above().ToArray();
        if (above.Length == 0) yield break;
        var limits = string.Join(", ", above.Select(a => $"{a.Key} to {NumberFormatter.Format(a.Most, 2)} {a.Key.Unit}"));
        yield return new Diagnostic(Severity.Note, "setup.above_printer", $"{printer.Title} limits {limits}.", new SourceLocation(Key: above[0].Key.Name));
    }

    /// <summary>Lines that set the pressure advance of a tool, in seconds; none if the flavor has no such command.</summary>
    public static IReadOnlyList<string> PressureAdvance(FlavorRules flavor, double seconds, int tool)
    {
        var lines = Equivalents.Of("M900 K" + NumberFormatter.Format(seconds, 5), FlavorTable.Marlin2.Name, flavor.Name) ?? [];
        return [.. lines.Select(l => l.Replace(" D0 ", " D" + NumberFormatter.Format(tool) + " "))];
    }

    private static bool Heats(string line) => line.IndexOf(MaterialKeys.ChamberTemperature.Name, StringComparison.Ordinal) >= 0;
}
