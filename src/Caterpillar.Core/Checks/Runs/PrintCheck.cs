namespace Caterpillar.Checks;

/// <summary>
/// Checks a print for moves outside the build volume, collisions, too much material, cold extrusion, and the rest of <see cref="CheckCodes"/>. Findings of
/// one code are one diagnostic, with the first move and a count. The printer sets their severities.
/// </summary>
public static class PrintCheck
{
    // Half of a wide extrusion, mm.
    private const double StandingEdge = 1;

    /// <summary>Checks a toolpath against a printer, material and settings.</summary>
    /// <returns>Findings with the codes of <see cref="CheckCodes"/>. The source is the first such move, with its step or line.</returns>
    public static IReadOnlyList<Diagnostic> Run(Toolpath toolpath, PrintSetup setup, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        return Run(setup.Printer.Turned(toolpath, cancel), setup, new CheckScope(setup.Material.NozzleTemperature), progress, cancel);
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
        var findings = RunFile(file, setup, null, progress, cancel);
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

    /// <summary>The findings of a decoded file, which may continue on a part that stands on the bed, and of the file before its edits.</summary>
    internal static IReadOnlyList<Diagnostic> RunFile(
        DecodedGCode file, PrintSetup setup, DecodedGCode? before, IProgress<double>? progress, CancellationToken cancel)
    {
        if (StandingPart(file) is { } part) setup = setup with { PrintedOn = part };
        if (file.MappingsOn(setup.Printer) is { Count: > 0 } mappings) setup = setup with { Printer = setup.Printer with { AxisMappings = new(mappings) } };
        setup = setup with { Printer = file.AxesOn(setup.Printer) };
        var toolpath = WithVolumes(file.Unrolled(setup.Printer), setup);
        return Run(toolpath, setup, CheckScope.OfFile(file, setup) with { Before = before?.Used }, progress, cancel);
    }

    /// <summary>
    /// Whether the moved print of a file stays on the bed, and inside the build volume if the file has its setup: findings that it did not have before.
    /// </summary>
    internal static IReadOnlyList<Diagnostic> OfMoved(DecodedGCode file, Toolpath moved, CancellationToken cancel)
    {
        var found = OnBed(file, moved, cancel);
        if (found.Count == 0) return found;
        var before = OnBed(file, file.Toolpath, cancel);
        return [.. found.Where(d => before.All(b => b.Code != d.Code))];
    }

    private static IReadOnlyList<Diagnostic> OnBed(DecodedGCode file, Toolpath toolpath, CancellationToken cancel)
    {
        var (take, end) = OnBedInParts(file, toolpath, cancel);
        take(toolpath);
        return end();
    }

    /// <summary>The same for a print in parts, of which only the tools are known: what takes and returns them, and what tells the findings then.</summary>
    internal static (Func<Toolpath, Toolpath> Take, Func<IReadOnlyList<Diagnostic>> End) OnBedInParts(
        DecodedGCode file, Toolpath toolpath, CancellationToken cancel)
    {
        var setup = new PrintSetup() with { PrintedOn = StandingPart(file) };
        toolpath = WithVolumes(toolpath, setup);
        var own = FileSetup.Of(file.Settings)?.Printer;
        var findings = new Findings(own ?? setup.Printer, toolpath);
        var bed = new DepositCheck(setup, findings, cancel, isOnlyBed: true);
        var run = new CheckRun(own is { RotaryAxes.Count: 0, AxisMappings.Count: 0 } ? [new PositionCheck(own, findings), bed] : [bed], toolpath.Tools, cancel);
        string[] codes = [CheckCodes.TooLow, CheckCodes.Squeezed, CheckCodes.InAir, CheckCodes.Outside, CheckCodes.Below, CheckCodes.ExcludedArea];
        return (part => run.Take(part), End);

        IReadOnlyList<Diagnostic> End()
        {
            run.End(toolpath);
            return [.. findings.ToList(toolpath.Count).Where(d => codes.Contains(d.Code))
                .Select(d => d.WithSource(s => s is null ? s : s with { File = file.Report.File }))];
        }
    }

    // The top of the part, as wide as what is printed on it. Null = none.
    private static TriMesh? StandingPart(DecodedGCode file)
    {
        if (!file.Settings.TryGetValue(Continuation.Setting, out var text) || !NumberReader.TryParse(text, out var z) || !(z is > 0 and < 1e5)) return null;
        var box = new MoveFilter { Kinds = [MoveKind.Print], FirstLayer = int.MinValue }.BoundsIn(file.Toolpath);
        if (box.IsEmpty) return null;
        var (a, b) = (box.Min - new Vec3(StandingEdge, StandingEdge), box.Max + new Vec3(StandingEdge, StandingEdge));
        return TriMesh.Create([new Vec3(a.X, a.Y, z), new Vec3(b.X, a.Y, z), new Vec3(b.X, b.Y, z), new Vec3(a.X, b.Y, z)], [0, 1, 2, 0, 2, 3]);
    }

    internal static IReadOnlyList<Diagnostic> Run(
        Toolpath toolpath, PrintSetup setup, CheckScope scope, IProgress<double>? progress, CancellationToken cancel)
    {
        using var checks = new MoveChecks(setup, toolpath.Tools, () => new Findings(setup.Printer, toolpath), cancel, MoveChecks.FewBlocks);
        return checks.Finish(toolpath, scope, progress);
    }

    /// <summary>The toolpath of a file; tools without a stated filament use the filament of the material.</summary>
    internal static Toolpath WithVolumes(Toolpath toolpath, PrintSetup setup)
    {
        if (toolpath.Tools.All(t => t.VolumePerE is not null) || setup.Printer.ExtrusionUnit == ExtrusionUnit.None) return toolpath;
        return toolpath.With(tools: toolpath.Tools.Select((t, i)
            => t.VolumePerE is null ? new ToolpathTool(ExtrusionModel.FilamentAreaOf(setup.OfTool(i).Material.FilamentDiameter)) : t));
    }
}
