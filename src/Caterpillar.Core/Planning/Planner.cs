namespace Caterpillar.Planning;

/// <summary>
/// Plans the steps of a design as machine moves: sorts paths within their groups, adds travel moves, Z-hops and retractions from the settings, and computes E
/// from the beads. The same input always gives the same plan.
/// </summary>
public static class Planner
{
    // mm
    private const double Everywhere = 1e6;

    /// <summary>Plans steps. No value if a step uses a tool that the printer does not have.</summary>
    /// <exception cref="ArgumentException">A step is null.</exception>
    /// <exception cref="OperationCanceledException">Planning was canceled.</exception>
    public static Result<Toolpath> Plan(
        IReadOnlyList<Step> steps, PrintSetup setup, PlanOptions? options = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        var result = PlanWithReport(steps, setup, options, progress, cancel);
        return new Result<Toolpath>(result.Value?.Toolpath, result.Diagnostics);
    }

    /// <summary>Plans steps and counts the effects of each rule.</summary>
    /// <inheritdoc cref="Plan(IReadOnlyList{Step}, PrintSetup, PlanOptions?, IProgress{double}?, CancellationToken)" path="/exception"/>
    public static Result<Plan> PlanWithReport(
        IReadOnlyList<Step> steps, PrintSetup setup, PlanOptions? options = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (steps is null) throw new ArgumentNullException(nameof(steps));
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        options = OptionsFor(setup, options);
        try
        {
            return PlanRun.Run(steps, Rules(setup, options.Policy), options, progress, cancel);
        }
        catch (DiagnosticException tooMuch)
        {
            return new Result<Plan>(null, tooMuch.Diagnostics);
        }
    }

    /// <summary>
    /// Toolpaths one after the other. In between, the head retracts, and travels over everything that is printed. Of decoded files the start and end code is
    /// left out. No value if one uses a tool that the printer does not have.
    /// </summary>
    /// <exception cref="OperationCanceledException">Merging was canceled.</exception>
    public static Result<Toolpath> Merge(
        IReadOnlyList<Toolpath> toolpaths, PrintSetup setup, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (toolpaths is null) throw new ArgumentNullException(nameof(toolpaths));
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        var top = setup.PrintedOn?.Bounds.Max.Z ?? double.NegativeInfinity;
        return new ToolpathMerger(Rules(setup, PlanPolicy.Printer), top).Run(toolpaths, progress, cancel);
    }

    /// <summary>Planning of steps that come batch by batch, each a whole number of layers and from below, without travels of a turtle.</summary>
    /// <param name="setup">The printer, material and settings.</param>
    /// <param name="options">Options of planning.</param>
    /// <param name="take">Takes the toolpath as far as it is planned, again and again, on the thread that plans.</param>
    /// <param name="cancel">Cancels.</param>
    internal static PlanRun Begin(PrintSetup setup, PlanOptions? options, Action<Toolpath> take, CancellationToken cancel)
    {
        options = OptionsFor(setup, options);
        return new PlanRun(Rules(setup, options.Policy), options, false, take, cancel);
    }

    private static PlanOptions OptionsFor(PrintSetup setup, PlanOptions? options)
    {
        options ??= new PlanOptions();
        if (options.Obstacle is null && setup.PrintedOn is { } existing) options = options with { Obstacle = existing };
        return setup.Settings.SortPaths ? options : options with { Sort = options.Sort with { Rule = SortRule.None } };
    }

    internal static PlanRules Rules(PrintSetup setup, PlanPolicy policy)
    {
        var (printer, material, settings) = (setup.Printer, setup.Material, setup.Settings);
        var motion = policy == PlanPolicy.AsDrawn ? null : new CommandedMotion(setup);
        var heads = HeadCorridor.Rings(printer.HeadOutline.Select(p => (p.Radius, p.Height)))
            .Concat(printer.HeadBoxes.Select(b => (b.ReachXY, b.Min.Z))).ToArray();
        ToolRules[] tools = [.. Enumerable.Range(0, printer.ToolCount).Select(tool => ToolRulesOf(setup.OfTool(tool), policy))];
        return new PlanRules(policy, settings, printer, tools)
        {
            Clearance = setup.ZHop,
            Head = new HeadCorridor(heads.Length > 0 ? heads : [(printer.NozzleDiameter, 0)]),
            Outline = new HeadShape(printer.HeadOutline.Select(p => (p.Radius, p.Height))),
            HeadBoxes = new([.. printer.HeadBoxes, .. printer.Beams(Everywhere)]),
            WipeDistance = setup.WipeDistance,
            Motion = motion is { MostAcceleration: null, MostJerk: null } ? null : motion,
            FirmwareRetraction = motion is not null && printer.FirmwareRetraction && (material.RetractionLength ?? material.RetractionSpeed) is not null
                ? new RetractionEvent(material.RetractionLength, material.RetractionSpeed, null, null) : null,
        };
    }

    private static ToolRules ToolRulesOf(PrintSetup setup, PlanPolicy policy)
    {
        var law = setup.Extrusion;
        return new ToolRules(
            law.VolumePerE,
            law.EOfFilament(setup.RetractionLength),
            setup.RetractionSpeed,
            setup.Printer.DeretractionSpeed > 0 ? setup.Printer.DeretractionSpeed : setup.RetractionSpeed,
            law.EOfFilament(setup.Printer.DeretractionExtra),
            law.FilamentPerE)
        {
            PressureAdvance = policy == PlanPolicy.AsDrawn ? null : setup.Material.PressureAdvance,
            // As drawn, a design that asks for too much is refused when it is written.
            MaxFlow = policy == PlanPolicy.AsDrawn ? double.PositiveInfinity : setup.MaxFlow,
            Material = setup.Material,
        };
    }
}
