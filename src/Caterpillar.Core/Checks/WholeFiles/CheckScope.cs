namespace Caterpillar.Checks;

/// <summary>Facts about the checked toolpath.</summary>
/// <param name="NozzleTemperature">Temperature of the nozzles at the beginning, °C.</param>
/// <param name="IsWholeFile">True for a file with start and end code, which must home and heat.</param>
/// <param name="Homes">True if it calls a macro that homes, or that may home.</param>
/// <param name="Heats">The same for heating.</param>
/// <param name="IsPlanned">True if its E values were compared with a plan.</param>
internal sealed record CheckScope(double NozzleTemperature, bool IsWholeFile = false, bool Homes = false, bool Heats = false, bool IsPlanned = false)
{
    /// <summary>Commands that are not harmless everywhere.</summary>
    public IReadOnlyList<UsedCommand> Commands { get; init; } = [];

    /// <summary>The first line that is not start code; 0 = unknown.</summary>
    public int FirstLine { get; init; }

    /// <summary>Commands of the file before it was edited. Null = the file is only checked, not written.</summary>
    public IReadOnlyList<UsedCommand>? Before { get; init; }

    /// <summary>True for lines that the writer makes itself.</summary>
    public Func<int, bool> IsOwnLine { get; init; } = _ => false;

    /// <summary>True if a macro switches the heaters off.</summary>
    public bool Cools { get; init; }

    /// <summary>A file: if it heats the nozzle itself, the nozzle starts cold. Otherwise a firmware macro heats it, and it starts hot.</summary>
    public static CheckScope OfFile(DecodedGCode file, PrintSetup setup)
    {
        var isReady = BeginsReady(file);
        var celsius = HeatsItself(file.Toolpath) && !isReady ? 0 : setup.Material.NozzleTemperature;
        var macros = file.Used.Select(u => (Macro: MacroEffect.Of(setup.Printer.Macros, u.Name), IsOpen: MayDoAnything(u))).ToArray();
        var homes = isReady || macros.Any(m => m.Macro?.Homes ?? m.IsOpen);
        var heats = isReady || macros.Any(m => m.Macro?.Heats ?? m.IsOpen);
        return new CheckScope(celsius, true, homes, heats)
        {
            Commands = file.Used,
            FirstLine = file.FirstLayerLine,
            Cools = macros.Any(m => m.Macro?.Cools ?? false) || file.Used.Any(u => u.Name is "END_PRINT" or "PRINT_END"),
        };
    }

    /// <summary>A file written with the templates of a printer. Without start G-code, the nozzle starts hot.</summary>
    public static CheckScope OfWritten(DecodedGCode file, PrintSetup setup)
        => (setup.Printer.StartGCode.Count > 0 ? OfFile(file, setup) : new CheckScope(setup.Material.NozzleTemperature) { Commands = file.Used })
            with { IsPlanned = true, Before = [] };

    /// <summary>True if a toolpath sets the temperature of a nozzle.</summary>
    public static bool HeatsItself(Toolpath toolpath) => toolpath.Events.Any(e => e.Event is NozzleTemperatureEvent);

    // Ultimakers home, heat and prime before the file begins.
    private static bool BeginsReady(DecodedGCode file)
        => file.Flavor.Name == "ultigcode" || file.Evidence.Any(e => e.EndsWith(";FLAVOR:Griffin", StringComparison.Ordinal));

    // Start macros and macro files home and heat, and what is not understood may.
    private static bool MayDoAnything(UsedCommand used)
        => used.Command is null ? used.Name.Length > 5 && used.Name.All(c => char.IsLetterOrDigit(c) || c == '_')
            : used.Name is "START_PRINT" or "PRINT_START" or "M98";
}
