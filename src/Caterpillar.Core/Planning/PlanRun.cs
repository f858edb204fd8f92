namespace Caterpillar.Planning;

/// <summary>
/// Planning with resolved rules: checks the steps, sorts them, writes the moves. Steps come in one batch or in several, each a whole number of layers, from
/// below; several give the plan that all of them at once would.
/// </summary>
internal sealed class PlanRun
{
    private readonly PlanRules _rules;
    private readonly PlanOptions _options;
    private readonly SortOptions _sort;
    private readonly StepPlanner _planner;
    private readonly PlanReport _counts = new();
    private readonly DiagnosticList _diagnostics = new();
    private readonly CancellationToken _cancel;
    private Vec3? _at;
    private Step? _lastGiven;
    private PrintPath? _lastPath;
    private int _steps;
    private double _moves;

    /// <param name="rules">The rules.</param>
    /// <param name="options">The options of the caller.</param>
    /// <param name="returns">Whether turtles may return to where they branched off.</param>
    /// <param name="take">Takes the toolpath as far as it is planned, again and again; null for nobody.</param>
    /// <param name="cancel">Cancels.</param>
    public PlanRun(PlanRules rules, PlanOptions options, bool returns, Action<Toolpath>? take, CancellationToken cancel)
    {
        (_rules, _options, _cancel, _at) = (rules, options, cancel, options.Start);
        _sort = rules.AddsNothing ? new SortOptions(SortRule.None) : options.Sort;
        _planner = new StepPlanner(rules, options, returns, take, _counts, _diagnostics);
    }

    /// <summary>Plans all steps at once.</summary>
    public static Result<Plan> Run(IReadOnlyList<Step> steps, PlanRules rules, PlanOptions options, IProgress<double>? progress, CancellationToken cancel)
    {
        var returns = steps.Any(s => s is TravelStep { Intent: TravelIntent.Return });
        var run = new PlanRun(rules, options, returns, null, cancel);
        run.Add(steps, progress);
        progress?.Report(1);
        return run.Finish();
    }

    /// <summary>Plans the next steps; none once there is an error.</summary>
    public void Add(IReadOnlyList<Step> steps, IProgress<double>? progress)
    {
        for (var i = 0; i < steps.Count; i++) CheckTool(steps[i], _steps + i);
        if (_diagnostics.HasErrors) return;
        if (TooMuch(steps) is { } tooMuch)
        {
            _diagnostics.Add(tooMuch);
            return;
        }
        var ordered = StepOrder.Find(steps, _sort with { Start = _at }, progress.Part(0, 0.5), _cancel);
        for (var i = 0; i < ordered.Length; i++)
        {
            if (_steps > 0) ordered[i] = new OrderedStep(ordered[i].Step, ordered[i].Path, _steps + ordered[i].Source);
            var path = ordered[i].Path;
            if (_lastPath is not null && path is not null) _counts.SortedTravel += _lastPath.End.DistanceTo(path.Start);
            if (_lastGiven is PathStep before && steps[i] is PathStep after) _counts.UnsortedTravel += before.Path.End.DistanceTo(after.Path.Start);
            (_lastPath, _lastGiven) = (path, steps[i]);
            _at = path?.End ?? (ordered[i].Step is TravelStep travel ? travel.Points[travel.Points.Count - 1] : _at);
        }
        _steps += ordered.Length;
        _planner.Add(ordered, progress.Part(0.5, 1), _cancel);
    }

    /// <summary>The plan of all steps; none if there was an error.</summary>
    public Result<Plan> Finish()
    {
        if (_diagnostics.HasErrors) return new Result<Plan>(null, _diagnostics.ToList());
        if (_steps == 0) _diagnostics.Add(Severity.Warning, "plan.empty", "Nothing to plan: the design has no steps.");
        var toolpath = _planner.Build();
        if (_counts.EmptySegments > 0)
            _diagnostics.Add(Severity.Note, "plan.repeated_point", "A path has the same point twice in a row. The segment without length is left out.", null,
                _counts.EmptySegments);
        return new Result<Plan>(new Plan(toolpath, _counts), _diagnostics.ToList());
    }

    /// <summary>The tools of a printer, after "has".</summary>
    public static string OnlyTools(int count) => count == 1 ? "only tool 0" : $"only tools 0 to {NumberFormatter.Format(count - 1)}";

    // Every segment becomes a move.
    private Diagnostic? TooMuch(IReadOnlyList<Step> steps)
    {
        foreach (var step in steps) _moves += step is PathStep path ? path.Path.RawPoints.Length : 1;
        return _options.Memory.Refuse(_moves * ToolpathBlock.BytesPerMove, $"A toolpath of {NumberFormatter.Format(_moves, 0)} moves");
    }

    private void CheckTool(Step step, int index)
    {
        if (step is null) throw new ArgumentException("A step is null.", nameof(step));
        var tool = step switch { PathStep p => p.Path.Tool, EventStep { Event: ToolEvent e } => e.Tool, _ => 0 };
        var tools = _rules.Tools.Length;
        if (tool >= 0 && tool < tools) return;
        _diagnostics.Add(
            Severity.Error, "plan.unknown_tool",
                $"Step uses tool {NumberFormatter.Format(tool)}, but the printer has {OnlyTools(tools)}.",
            new SourceLocation(Step: index));
    }
}
