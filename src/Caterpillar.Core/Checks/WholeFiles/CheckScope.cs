using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>Facts about the checked toolpath.</summary>
/// <param name="NozzleTemperature">Temperature of the nozzles at the beginning, °C.</param>
/// <param name="IsWholeFile">True for a file with start and end code, which must home and heat.</param>
/// <param name="HasMacros">True if it calls firmware macros, which may home and heat.</param>
/// <param name="IsPlanned">True if its E values were compared with a plan.</param>
internal sealed record CheckScope(double NozzleTemperature, bool IsWholeFile = false, bool HasMacros = false, bool IsPlanned = false)
{
    /// <summary>A file: if it heats the nozzle itself, the nozzle starts cold. Otherwise a firmware macro heats it, and it starts hot.</summary>
    public static CheckScope OfFile(DecodedGCode file, PrintSetup setup)
    {
        var isReady = BeginsReady(file);
        var celsius = HeatsItself(file.Toolpath) && !isReady ? 0 : setup.Material.NozzleTemperature;
        return new CheckScope(celsius, true, file.Ignored.Keys.Any(IsMacro) || isReady);
    }

    /// <summary>A file written with the templates of a printer. Without start G-code, the nozzle starts hot.</summary>
    public static CheckScope OfWritten(DecodedGCode file, PrintSetup setup)
        => (setup.Printer.StartGCode.Count > 0 ? OfFile(file, setup) : new CheckScope(setup.Material.NozzleTemperature)) with { IsPlanned = true };

    /// <summary>True if a toolpath sets the temperature of a nozzle.</summary>
    public static bool HeatsItself(Toolpath toolpath)
    {
        foreach (var entry in toolpath.Events)
        {
            if (entry.Event is NozzleTemperatureEvent) return true;
        }
        return false;
    }

    // Ultimakers home, heat and prime before the file begins.
    private static bool BeginsReady(DecodedGCode file)
        => file.Flavor.Name == "ultigcode" || file.Evidence.Any(e => e.EndsWith(";FLAVOR:Griffin", StringComparison.Ordinal));

    private static bool IsMacro(string command) => command.Length > 5 && command.All(c => char.IsLetter(c) || c == '_' || char.IsDigit(c));
}
