namespace Caterpillar.Slicing;

/// <summary>
/// Slices meshes into planar layers with walls, top/bottom surfaces, infill and supports. Overlapping solids of a model are printed as their union.
/// </summary>
public static class PlanarSlicer
{
    /// <summary>Maximum number of models in one print.</summary>
    internal const int MaxModels = 10_000;

    /// <summary>Slices meshes at the positions where they are printed (Z = 0 is the bed).</summary>
    /// <param name="models">The models. Each has its own layers.</param>
    /// <param name="settings">Print settings.</param>
    /// <param name="options">Threads, memory and infill lines.</param>
    /// <param name="progress">Progress, 0 to 1.</param>
    /// <param name="cancel">Cancels the call.</param>
    /// <returns>The layers, or none on an error, and the diagnostics: <c>slice.empty</c>, <c>slice.below_bed</c>, <c>slice.too_many_layers</c>,
    /// <c>slice.too_many_models</c> (over 10,000), <c>slice.layer_formula</c>, <c>slice.spiral_vase_divided</c>, <c>slice.spiral_vase_lag</c>,
    /// <c>slice.layer_time</c>, <c>slice.no_curves</c>. For settings without effect: <c>slice.no_effect</c>, <c>slice.whole_print</c>, <c>slice.no_support</c>.
    /// For each broken mesh: <c>slice.broken_mesh</c> (repairs and omissions) and <c>slice.lost_layers</c> (an error). For each model:
    /// <c>slice.too_thin</c>. For each modifier without effect: <c>slice.modifier_outside</c>.</returns>
    /// <exception cref="OperationCanceledException">The call was canceled.</exception>
    public static Result<SliceResult> Slice(
        IReadOnlyList<NamedMesh> models, PrintSettings settings, SliceOptions? options = null, IProgress<double>? progress = null,
        CancellationToken cancel = default)
    {
        if (models is null) throw new ArgumentNullException(nameof(models));
        return SliceEach(models.Select(m => new SliceModel(m, settings)).ToArray(), settings, options, progress, cancel);
    }

    /// <summary>Slices models that have their own settings. Settings of the whole print (order, skirt) come from <paramref name="common"/>.</summary>
    /// <inheritdoc cref="Slice"/>
    public static Result<SliceResult> SliceEach(
        IReadOnlyList<SliceModel> models, PrintSettings common, SliceOptions? options = null, IProgress<double>? progress = null,
        CancellationToken cancel = default)
    {
        if (models is null) throw new ArgumentNullException(nameof(models));
        if (common is null) throw new ArgumentNullException(nameof(common));
        if (models.Count > MaxModels)
            return new("slice.too_many_models",
                $"The print has {NumberFormatter.Format(models.Count)} models. The maximum is {NumberFormatter.Format(MaxModels)}.");
        try
        {
            return Sliced(models, common, options ?? new SliceOptions(), progress, cancel);
        }
        catch (DiagnosticException tooMuch)
        {
            return new Result<SliceResult>(null, tooMuch.Diagnostics);
        }
    }

    private static Result<SliceResult> Sliced(
        IReadOnlyList<SliceModel> models, PrintSettings common, SliceOptions options, IProgress<double>? progress, CancellationToken cancel)
    {
        var threads = options.Threads;
        var affordable = new SliceMemory(options.Memory);
        var problems = new DiagnosticList();
        // One for each model, so not in the list that counts.
        var findings = new List<Diagnostic>();
        foreach (var model in models)
        {
            if (PrintWideKeys.SetBy(model.Settings, common) is not { Count: > 0 } ignored) continue;
            var (keys, apply) = (string.Join(", ", ignored), ignored.Count == 1 ? "applies" : "apply");
            findings.Add(new Diagnostic(Severity.Warning, "slice.whole_print",
                $"{keys} {apply} to the whole print. Values for one model are ignored.", new SourceLocation(model.Mesh.Name)));
        }
        findings.AddRange(IdleSettings.Of(models, common));
        var helpers = models.Where(m => m.Settings.ModelType != ModelType.Part).ToArray();
        if (helpers.Length > 0) models = models.Where(m => m.Settings.ModelType == ModelType.Part).ToArray();
        if (UnitHint.Of(ModelPlacement.BoxOf([.. models.Select(m => m.Mesh)]).Size) is { } unit) findings.Add(unit);
        if (models.All(m => m.Settings.Support == SupportKind.None) && helpers.FirstOrDefault(m => m.Settings.ModelType != ModelType.Modifier) is { } idle)
        {
            findings.Add(new Diagnostic(Severity.Warning, "slice.no_support",
                "This model has no effect because support=none. Set support=grid or support=tree. With support_angle_deg=90, only enforcers get supports.",
                new SourceLocation(idle.Mesh.Name)));
        }
        if (common.MergeOverlappingModels) models = OverlappingModels.Merge(models, threads, problems, cancel);
        var modifiers = new Modifiers(helpers.Where(m => m.Settings.ModelType == ModelType.Modifier).ToArray());
        var bodies = new List<Body>();
        var cutter = new BodyCutter(common, options, affordable, problems, findings, cancel);
        for (var i = 0; i < models.Count; i++)
        {
            var body = cutter.Cut(models[i], i, progress.Part(0.4 * i / models.Count, 0.4 * (i + 1) / models.Count));
            modifiers.Apply(body, common, threads, cancel);
            bodies.Add(body);
        }
        modifiers.Report(problems);
        if (findings.Any(d => d.Severity == Severity.Error)) return new Result<SliceResult>(null, [.. problems.ToList(), .. findings]);
        var ordered = common.PrintSequence == PrintSequence.ByObject
            ? bodies.OrderBy(b => b.Model.Mesh.Bounds.Max.Z).ThenBy(b => b.Number).SelectMany(b => b.Layers).ToArray()
            : bodies.SelectMany(b => b.Layers).OrderBy(l => l.Plan.Top).ThenBy(l => l.Body.Number).ToArray();
        var parallel = new ParallelOptions { CancellationToken = cancel, MaxDegreeOfParallelism = threads > 0 ? threads : -1 };
        var stream = new LayerStream(ordered, threads, cancel);
        using var supports = PrintSupports.Begin(ordered, bodies, helpers, common, parallel);
        var finish = new LayerFinish(ordered, bodies, common, supports, problems, options);
        foreach (var layer in affordable.Watch(stream.Run(progress.Part(0.4, 1)))) finish.Add(layer);
        var kept = finish.End();
        foreach (var body in bodies) ThinPlaces.Report(body, findings);
        if (kept.Length == 0 && !problems.HasErrors)
            problems.Add(Severity.Error, "slice.empty", Nothing(models, ordered));
        return new Result<SliceResult>(kept.Length > 0 ? new SliceResult(kept) : null, [.. problems.ToList(), .. findings]);
    }

    private static string Nothing(IReadOnlyList<SliceModel> models, LayerWork[] layers)
    {
        if (models.Count == 0) return "Nothing to print: no model has model_type=part.";
        if (layers.All(l => l.Region.IsEmpty))
        {
            var sheets = models.Any(m => !m.Mesh.Mesh.IsWatertight) ? " Set open_contours=walls to print open surfaces as single walls." : "";
            return "Nothing to print: no layer of the models has a closed contour." + sheets;
        }
        if (models.All(m => m.Settings is { WallCount: 0, InfillDensityPercent: 0, InfillSpacing: 0, TopLayers: 0, BottomLayers: 0 }))
            return "Nothing to print: the settings have no walls, no infill and no top or bottom layers.";
        var width = NumberFormatter.Format(models[0].Settings.LineWidth, 3);
        return $"Nothing to print: all contours are narrower than a line ({width} mm), or the settings leave nothing to fill them. Check line_width_mm.";
    }
}
