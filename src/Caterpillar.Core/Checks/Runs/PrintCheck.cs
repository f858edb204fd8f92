using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>
/// Checks a print for moves outside the build volume, collisions, too much material, cold extrusion, and the rest of <see cref="CheckCodes"/>. Findings of
/// one code are one diagnostic, with the first move and a count. The printer sets their severities.
/// </summary>
public static class PrintCheck
{
    /// <summary>Checks a toolpath against a printer, material and settings.</summary>
    /// <returns>Findings with the codes of <see cref="CheckCodes"/>. The source is the first such move, with its step or line.</returns>
    public static IReadOnlyList<Diagnostic> Run(Toolpath toolpath, PrintSetup setup, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        return Run(toolpath, setup, new CheckScope(setup.Material.NozzleTemperature), progress, cancel);
    }

    /// <summary>
    /// Checks a decoded file, which may heat the nozzle itself or leave that to a macro of the firmware. If it does not state its filament diameter, the
    /// diameter of the material is used.
    /// </summary>
    /// <inheritdoc cref="Run(Toolpath, PrintSetup, IProgress{double}?, CancellationToken)" path="/returns"/>
    public static IReadOnlyList<Diagnostic> Run(
        DecodedGCode file, PrintSetup setup, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (file is null) throw new ArgumentNullException(nameof(file));
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        setup = Mapped(setup, file);
        var toolpath = AsPrinted(file, setup);
        var findings = Run(toolpath, setup, CheckScope.OfFile(file, setup), progress, cancel);
        if (file.Report.File is not { Length: > 0 } name) return findings;
        return findings.Select(d => d.WithSource(s => (s ?? new SourceLocation()) with { File = name })).ToArray();
    }

    /// <summary>
    /// The setup to check the edited toolpath of a file against. If the file heats the nozzle itself, the nozzle starts cold. Otherwise a macro of the firmware
    /// heats it, and it starts hot.
    /// </summary>
    public static PrintSetup SetupForFile(PrintSetup setup, Toolpath toolpath)
    {
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        return CheckScope.HeatsItself(toolpath) ? setup with { Material = setup.Material with { NozzleTemperature = 0 } } : setup;
    }

    internal static IReadOnlyList<Diagnostic> Run(
        Toolpath toolpath, PrintSetup setup, CheckScope scope, IProgress<double>? progress, CancellationToken cancel)
    {
        using var checks = new MoveChecks(setup, toolpath.Tools, () => new Findings(setup.Printer, toolpath), cancel);
        return checks.Finish(toolpath, scope, progress);
    }

    /// <summary>The setup with the mapped axes that a file states.</summary>
    internal static PrintSetup Mapped(PrintSetup setup, DecodedGCode file)
        => file.MappingsOn(setup.Printer) is { Count: > 0 } stated ? setup with { Printer = setup.Printer with { AxisMappings = new(stated) } } : setup;

    /// <summary>The toolpath of a file on the unrolled surface, with the volumes of its tools.</summary>
    internal static Toolpath AsPrinted(DecodedGCode file, PrintSetup setup) => WithVolumes(file.Unrolled(setup.Printer), setup);

    /// <summary>The toolpath of a file; tools without a stated filament use the filament of the material.</summary>
    internal static Toolpath WithVolumes(Toolpath toolpath, PrintSetup setup)
    {
        if (toolpath.Tools.All(t => t.VolumePerE is not null) || setup.Printer.ExtrusionUnit == ExtrusionUnit.None) return toolpath;
        var known = new ToolpathTool(ExtrusionModel.FilamentAreaOf(setup.Material.FilamentDiameter));
        return toolpath.WithTools(toolpath.Tools.Select(t => t.VolumePerE is null ? known : t));
    }
}
