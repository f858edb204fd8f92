namespace Caterpillar.Slicing;

/// <summary>Plans the layers of models and cuts them there.</summary>
/// <param name="common">The settings of the print.</param>
/// <param name="options">Threads, infill lines, and what divides planned layers further.</param>
/// <param name="memory">Counts the layers.</param>
/// <param name="problems">Receives diagnostics that are counted over all models.</param>
/// <param name="findings">Receives diagnostics of each model.</param>
/// <param name="cancel">Cancels the call.</param>
internal sealed class BodyCutter(
    PrintSettings common, SliceOptions options, SliceMemory memory, DiagnosticList problems, List<Diagnostic> findings, CancellationToken cancel)
{
    /// <summary>A model with its layers before the first stage, or without layers if no part of it is above the bed.</summary>
    public Body Cut(SliceModel model, int number, IProgress<double>? progress)
    {
        var (mesh, settings) = (model.Mesh.Mesh, model.Settings);
        var body = new Body(model.Mesh, number, cancel) { InfillLines = options.InfillLines };
        if (mesh.Bounds.IsEmpty) return body;
        if (mesh.Bounds.Min.Z < -1e-6)
        {
            problems.Add(Severity.Warning, "slice.below_bed",
                $"Model extends {NumberFormatter.Format(-mesh.Bounds.Min.Z, 3)} mm below the bed. That part is not printed.", body.Source);
        }
        if (settings is { InfillPattern: InfillPattern.Curves, InfillCurves.Count: 0 } && (settings.InfillDensityPercent > 0 || settings.InfillSpacing > 0))
        {
            problems.Add(Severity.Warning, "slice.no_curves",
                "infill_pattern=curves has no curves, so no infill is printed. Set infill_curves_mm or --infill-curves FILE.", body.Source);
        }
        var planned = new LayerPlan(mesh, settings).Layers();
        foreach (var problem in planned.Diagnostics) problems.Add(problem with { Source = problem.Source ?? body.Source });
        if (planned.Value is not { } plan) return body;
        if (options.Divide is { } divide) plan = divide(plan);
        memory.Plan(body, plan);
        var lift = Raft.Lift(common);
        var sections = ModelSections.Cut(body.Model, Array.ConvertAll(plan, l => l.Cut), settings, options.Threads, findings, progress, cancel);
        var rules = new Dictionary<(double, bool), SliceRules>();
        body.Layers = new LayerWork[plan.Length];
        for (var i = 0; i < plan.Length; i++)
        {
            var kind = (plan[i].Thickness, First: i == 0 && common.RaftLayers == 0);
            if (!rules.TryGetValue(kind, out var rule)) rules.Add(kind, rule = SliceRules.Of(settings, kind.Thickness, common, kind.First));
            body.Layers[i] = new LayerWork(body, i, plan[i] with { Top = plan[i].Top + lift }, rule with { Top = plan[i].Top }) { Section = sections[i] };
        }
        return body;
    }
}
