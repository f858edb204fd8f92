namespace Caterpillar.Machines;

/// <summary>Values of a setup that a file for its printer cannot pass on, or not entirely.</summary>
internal static class SetupFindings
{
    /// <summary>A warning about values without effect, and a note about values beyond the printer.</summary>
    public static void Add(PrintSetup setup, DiagnosticList diagnostics)
    {
        var (printer, material, flavor, motion) = (setup.Printer, setup.Material, setup.Printer.Flavor, new CommandedMotion(setup));
        var lost = new List<string>();
        if (motion.MostAcceleration is null) Lost($"{flavor.Title} has no command for accelerations", motion.Accelerations);
        if (motion.MostJerk is null && printer.Cornering != Cornering.JunctionDeviation) Lost($"{flavor.Title} has no command for jerk", motion.Jerks);
        else if (motion.MostJerk is null) Lost("The printer has cornering=junction_deviation", motion.Jerks);
        if (material.PressureAdvance is not null && PressureAdvance(flavor, 0, 0).Count == 0)
            Lost($"{flavor.Title} has no command for pressure advance", KeysOf("pressure_advance_s"));
        if (material.ChamberTemperature > 0 && !printer.StartGCode.Any(l => l.Split('{', '}').Contains("chamber_temperature_c")))
            Lost($"start_gcode of {printer.Title} does not heat a chamber", KeysOf("chamber_temperature_c"));
        if (printer.FirmwareRetraction && flavor.RetractionSettings == RetractionCommands.None)
        {
            ProfileKey[] own = [.. KeysOf("material_retraction_length_mm", "material_retraction_speed_mm_s").Where(k => k.Get(material) is double)];
            Lost($"{flavor.Title} has no command for the length of its firmware retraction", own);
        }
        if (lost.Count > 0) diagnostics.Add(Severity.Warning, "setup.no_command", string.Join(" ", lost));
        var above = motion.Accelerations.Select(k => (Key: k, Most: motion.MostAcceleration)).Concat(motion.Jerks.Select(k => (Key: k, Most: motion.MostJerk)))
            .Where(k => k.Key.Get(setup.Settings) is double value && value > k.Most)
            .Select(k => $"{k.Key} to {NumberFormatter.Format(k.Most ?? 0, 2)} {k.Key.Unit}").ToArray();
        if (above.Length > 0) diagnostics.Add(Severity.Note, "setup.above_printer", $"{printer.Title} limits {string.Join(", ", above)}.");

        IReadOnlyList<ProfileKey<Material>> KeysOf(params string[] names) => ProfileKinds.Material.KeysOf(names);

        void Lost(string why, IReadOnlyList<ProfileKey> keys)
        {
            if (keys.Count > 0) lost.Add($"{why}: {string.Join(", ", keys)} {(keys.Count == 1 ? "has" : "have")} no effect.");
        }
    }

    /// <summary>Lines that set the pressure advance of a tool, in seconds; none if the flavor has no such command.</summary>
    public static IReadOnlyList<string> PressureAdvance(FlavorRules flavor, double seconds, int tool)
    {
        var lines = Equivalents.Of("M900 K" + NumberFormatter.Format(seconds, 5), FlavorTable.Marlin2.Name, flavor.Name) ?? [];
        return [.. lines.Select(l => Words.Replaced(l, " D0 ", " D" + NumberFormatter.Format(tool) + " "))];
    }
}
