using Grasshopper;

namespace Caterpillar.GH.Plugin;

/// <summary>The built-in profiles, overridden by those in the user's folder.</summary>
internal static class Profiles
{
    /// <summary>The folder of the user's own printers, materials and settings. It need not exist.</summary>
    public static string UserFolder => Path.Combine(Folders.SettingsFolder, "Caterpillar", "printers");

    /// <summary>A library of the profiles that are in the folder now.</summary>
    public static ProfileLibrary Library => new(UserFolder);

    /// <summary>A setup. What is null is the generic printer, and the material and settings that the printer names. Others are for tools from 1 on.</summary>
    public static Result<PrintSetup> Setup(
        Printer? printer = null, Material? material = null, PrintSettings? settings = null, IEnumerable<Material>? others = null)
    {
        var machine = Given(printer) ?? Library.Printer("generic");
        var filament = Given(material) ?? Library.Material(machine.Value?.DefaultMaterial ?? "pla");
        var rules = Given(settings) ?? Library.Settings(machine.Value?.DefaultSettings ?? "standard");
        Diagnostic[] problems = [.. machine.Diagnostics, .. filament.Diagnostics, .. rules.Diagnostics];
        if (machine.Value is null || filament.Value is null || rules.Value is null) return new Result<PrintSetup>(null, problems);
        var setup = new PrintSetup(machine.Value, filament.Value, rules.Value) { ToolMaterials = new(others ?? []) };
        var findings = setup.Check();
        return new Result<PrintSetup>(findings.Any(f => f.Severity == Severity.Error) ? null : setup, [.. problems, .. findings]);
    }

    /// <summary>The name of a printer, a material or settings.</summary>
    public static string NameOf(object profile) => profile switch
    {
        Printer printer => printer.Name,
        Material material => material.Name,
        _ => ((PrintSettings)profile).Name,
    };

    /// <summary>The printer, the material or the settings of a G-code file.</summary>
    public static Result<T> OfFile<T>(string file)
        where T : class
    {
        var read = ProfileImport.ReadSetup(file);
        object?[] parts = [read.Value?.Printer, read.Value?.Material, read.Value?.Settings];
        return new Result<T>(parts.OfType<T>().FirstOrDefault(), read.Diagnostics);
    }

    private static Result<T>? Given<T>(T? value)
        where T : class
        => value is null ? null : new Result<T>(value, []);
}
