namespace Caterpillar.Curved;

/// <summary>
/// Slices meshes along the level sets of a field (Caterpillar 2019, section 3.2, "curved slicer"). The part is bent until its layers are flat, sliced by
/// <see cref="PlanarSlicer"/> with all of its settings, and the paths are bent back. Each bead fills the gap between its layer and the one below.
/// </summary>
public static class CurvedSlicer
{
    /// <summary>Slices meshes at the positions where they are printed (Z = 0 is the bed).</summary>
    /// <param name="models">The models. All of them use the same field.</param>
    /// <param name="field">Field whose level sets are the layers.</param>
    /// <param name="setup">Print settings and printer. The print head limits the slope of the layers.</param>
    /// <param name="options">Surface to print on, partial printing, infill lines, threads and memory.</param>
    /// <param name="progress">Progress, 0 to 1.</param>
    /// <param name="cancel">Cancels the call.</param>
    /// <returns>The layers, whose Z is the value of the field, and diagnostics with the codes of <see cref="PlanarSlicer"/> and <c>curved.*</c>.
    /// </returns>
    /// <exception cref="OperationCanceledException">The call was canceled.</exception>
    public static Result<CurvedResult> Slice(
        IReadOnlyList<NamedMesh> models, LayerField field, PrintSetup setup, CurvedOptions? options = null, IProgress<double>? progress = null,
        CancellationToken cancel = default)
    {
        if (models is null) throw new ArgumentNullException(nameof(models));
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        return SliceEach(models.Select(m => new SliceModel(m, setup.Settings)).ToArray(), field, setup, options, progress, cancel);
    }

    /// <summary>Slices models that have their own settings.</summary>
    /// <inheritdoc cref="Slice"/>
    public static Result<CurvedResult> SliceEach(
        IReadOnlyList<SliceModel> models, LayerField field, PrintSetup setup, CurvedOptions? options = null, IProgress<double>? progress = null,
        CancellationToken cancel = default)
    {
        if (models is null) throw new ArgumentNullException(nameof(models));
        if (field is null) throw new ArgumentNullException(nameof(field));
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        options ??= new CurvedOptions();
        var problems = new DiagnosticList();
        if (options.Partial) field = field.ForPartial();
        field.Check(problems);
        var part = PartColumns.Of(models.Select(m => m.Mesh.Mesh));
        if (!problems.HasErrors) CheckCover(field, part, options, problems);
        if (problems.HasErrors) return new Result<CurvedResult>(null, problems.ToList());
        field = field.FitTo(part, setup.Settings, problems);
        if (setup.Settings.RaftLayers > 0 || setup.Settings.PurgeTower || (!field.StartsLevel && setup.Settings.HasSkirtOrBrim))
            problems.Add(Severity.Note, "curved.no_skirt",
                "Curved layers have no raft and no purge tower. If they do not start level, they have no skirt or brim either.");
        if (!problems.HasErrors && field.Sheet is { } sheet) return Sheets(models, field, sheet, part, setup, options, problems, progress, cancel);
        if (!problems.HasErrors) CheckDefined(field, part, problems);
        if (problems.HasErrors) return new Result<CurvedResult>(null, problems.ToList());

        field = StretchedField.Of(field, part);
        var flat = new List<SliceModel>();
        for (var i = 0; i < models.Count; i++)
        {
            progress?.Report(0.3 * i / models.Count);
            var mesh = field.FlatMesh(models[i].Mesh.Mesh)
                ?? MeshFlattener.Flatten(models[i].Mesh.Mesh, field, setup.Settings.CurvedTolerance, options.Threads, cancel);
            if (mesh is null)
            {
                problems.Add(Severity.Error, "curved.too_fine", "The bent model would have more than 12 million faces. Use a smoother field or increase "
                    + "curved_tolerance_mm.", new SourceLocation(models[i].Mesh.Name));
                return new Result<CurvedResult>(null, problems.ToList());
            }
            flat.Add(new SliceModel(new NamedMesh(models[i].Mesh.Name, mesh), OnField(models[i].Settings, field)));
        }
        var common = OnField(setup.Settings, field);
        var limits = new GapLimits(field, part, setup.Settings, LayerRules.GreatestGap(setup));
        var sliced = PlanarSlicer.SliceEach(flat, common, new SliceOptions
        {
            Threads = options.Threads, Memory = options.Memory, Divide = limits.Divide,
            InfillLines = options.InfillLines is { } lines ? z => Flat(lines(z), field, z) : null,
        }, progress.Part(0.3, 0.75), cancel);
        problems.AddRange(sliced.Diagnostics);
        if (sliced.Value is not { } result) return new Result<CurvedResult>(null, problems.ToList());
        var least = LayerRules.LeastGap(setup);
        // Thinner places are printed several layers at once.
        if (setup.Settings.CurvedMaxGapRatio > 0)
            least = Math.Max(least, limits.Thickest(result.Layers.Select(l => l.Layer)) / setup.Settings.CurvedMaxGapRatio);
        var rules = Rules(setup, options, part, least, RiseOf(result, field));
        var layers = Lifted(result.Layers, field, rules, options.Threads, problems, progress.Part(0.75, 1), cancel);
        return Arranged(layers, field, setup, options, "no part of the models is above the surface and within the plan", problems);
    }

    // Surfaces as single walls.
    private static Result<CurvedResult> Sheets(
        IReadOnlyList<SliceModel> models, LayerField field, SheetField sheet, PartColumns part, PrintSetup setup, CurvedOptions options,
        DiagnosticList problems, IProgress<double>? progress, CancellationToken cancel)
    {
        var rules = Rules(setup, options, part, LayerRules.LeastGap(setup), sheet.Rise());
        // Layers, and points of walls about 1 mm apart, until they are planned.
        var bytes = (4000.0 * sheet.Levels.Length + 120 * sheet.WallLength) * models.Count;
        if (options.Memory.Refuse(bytes, "The walls of the surface", null, "Increase the layer height.") is { } tooMuch)
            return new Result<CurvedResult>(null, [tooMuch]);
        sheet.CheckTool(options.MaxTilt, options.Partial, problems);
        var layers = new SheetSlicer(field, setup, rules, options).Slice(models, problems, progress, cancel);
        return Arranged(layers, field, setup, options, "no part of the surface is above the bed", problems);
    }

    private static Result<CurvedResult> Arranged(
        SlicedLayer[] layers, LayerField field, PrintSetup setup, CurvedOptions options, string nothing, DiagnosticList problems)
    {
        if (layers.Length == 0 && !problems.HasErrors) problems.Add(Severity.Error, "slice.empty", $"Nothing to print: {nothing}.");
        if (problems.HasErrors) return new Result<CurvedResult>(null, problems.ToList());
        layers = PatchOrder.Arrange(layers, setup.Printer, problems, options.MaxTilt > 0);
        for (var i = 0; options.Take is not null && i < layers.Length; i++)
        {
            options.Take(layers[i].Steps);
            layers[i] = layers[i] with { Steps = [] };
        }
        return new Result<CurvedResult>(new CurvedResult(layers, field), problems.ToList());
    }

    private static LiftRules Rules(PrintSetup setup, CurvedOptions options, PartColumns part, double least, double rise)
    {
        // A tool that tilts sees the slope from its own axis; overhanging layers cannot be printed by any.
        var slope = HeadSlope.Limit(setup, part.Bounds.Size.LengthXY, rise);
        return new LiftRules(setup.Settings, least, Math.Min(89.9, slope + options.MaxTilt), options.Onto ?? PlanSurface.Level(0), options.Partial)
        {
            // Without a partial print it was looked for in the whole part.
            FindsEdge = options.Partial,
            Rise = rise,
            TipReach = setup.Printer.HeadOutline[0].Radius + setup.Settings.LineWidth / 2,
            MaxFill = options.Onto is null ? 0 : LayerRules.GreatestGap(setup),
        };
    }

    // The layers back in the part; without those of which nothing is printed.
    private static SlicedLayer[] Lifted(
        IReadOnlyList<SlicedLayer> flat, LayerField field, LiftRules rules, int threads, DiagnosticList problems, IProgress<double>? progress,
        CancellationToken cancel)
    {
        var neighbors = new LayerNeighbors(flat);
        var layers = new SlicedLayer[flat.Count];
        var reports = new LiftReport[layers.Length];
        var done = 0;
        var parallel = new ParallelOptions { CancellationToken = cancel, MaxDegreeOfParallelism = threads > 0 ? threads : -1 };
        Parallel.For(0, layers.Length, parallel, i =>
        {
            var lifter = new PathLifter(field, rules, neighbors);
            var steps = new List<PathStep>(flat[i].Steps.Count);
            foreach (var step in flat[i].Steps)
            {
                cancel.ThrowIfCancellationRequested();
                steps.AddRange(lifter.Lift(step).SelectMany(UphillPaths.Of));
            }
            var region = field is StretchedField stretched ? stretched.ToPlan(flat[i].Region, flat[i].Layer.Z) : flat[i].Region;
            layers[i] = flat[i] with { Region = region, Steps = IsLevel(steps) ? Within(steps, region) : WithoutRegions(steps) };
            reports[i] = lifter.Report;
            // In turn, so that what is reported ascends.
            lock (layers) progress?.Report((double)++done / layers.Length);
        });
        var report = new LiftReport();
        foreach (var layer in reports) report.Add(layer);
        LiftFindings.Add(report, rules, layers.Select(l => l.Steps), problems);
        return Array.FindAll(layers, l => l.Steps.Count > 0);
    }

    // Where lines in plan lie among flat layers.
    private static IReadOnlyList<Polyline> Flat(IReadOnlyList<Polyline> lines, LayerField field, double value)
    {
        if (!field.BendsPlan) return lines;
        return lines.Select(l => new Polyline(l.Points.Select(p => field.ToFlat(p.WithZ(field.Height(p.X, p.Y, value)))), l.IsClosed)).ToArray();
    }

    private static bool IsLevel(List<PathStep> steps)
        => steps.TrueForAll(s => Array.TrueForAll(s.Path.RawPoints, p => Math.Abs(p.Z - steps[0].Path.Start.Z) <= 1e-6));

    private static List<PathStep> Within(List<PathStep> steps, Region region)
        => steps.ConvertAll(s => s.Region is null || ReferenceEquals(s.Region, region) ? s : s with { Region = region });

    // Level travels inside the part would run through curved layers; steps that are joined may have lost pieces between them.
    private static List<PathStep> WithoutRegions(List<PathStep> steps)
        => steps.ConvertAll(s => s.Region is null ? s : new PathStep(s.Path, s.Group) { KeepStart = s.KeepStart });

    // The head sees no more of a layer than its rise: found from the samples of the part.
    private static double RiseOf(SliceResult flat, LayerField field) => flat.Layers.Select(layer =>
        Bounds.Of(layer.Region.Contours.SelectMany(c => c.Points, (_, p) => field.ToPart(p.WithZ(layer.Layer.Z)))).Size.Z).DefaultIfEmpty().Max();

    // Bent arcs are none.
    private static PrintSettings OnField(PrintSettings settings, LayerField field)
    {
        settings = field.Suited(settings with { RaftLayers = 0, ArcFittingTolerance = 0 });
        return field.StartsLevel ? settings : settings.WithoutSkirtAndBrim;
    }

    private static void CheckCover(LayerField field, PartColumns part, CurvedOptions options, DiagnosticList problems)
    {
        var outside = part.Columns.Where(c => !field.Covers(c.X, c.Y)).ToList();
        if (outside.Count == 0) return;
        var share = 100.0 * outside.Count / part.Columns.Count;
        problems.Add(options.Partial ? Severity.Warning : Severity.Error, "curved.outside_plan",
            $"The plan does not cover {NumberFormatter.Format(share, share < 1 ? 2 : 0)} % of the part, first at x {Text(outside[0].X)}, "
            + $"y {Text(outside[0].Y)} mm. "
            + (options.Partial ? "That area is not printed." : "It is too small, next to the part or has a hole."));
    }

    private static void CheckDefined(LayerField field, PartColumns part, DiagnosticList problems)
    {
        foreach (var column in part.Columns)
        {
            var point = new Vec3(column.X, column.Y, column.High);
            var flat = field.ToFlat(point);
            if (flat.IsFinite && field.ToPart(flat).IsFinite) continue;
            problems.Add(Severity.Error, "curved.undefined", $"The field has no value at {point}.");
            return;
        }
    }

    private static string Text(double value) => NumberFormatter.Format(value, 2);
}
