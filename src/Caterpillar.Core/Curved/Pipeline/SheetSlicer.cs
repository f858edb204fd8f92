namespace Caterpillar.Curved;

/// <summary>
/// Slices surfaces into single walls along the level curves of a field on their mesh: no infill, no top and bottom layers, no supports. With a tool that tilts,
/// walls may overhang and layers need not rise.
/// </summary>
/// <param name="field">The fitted field, which knows the surfaces.</param>
/// <param name="setup">Settings of the whole print, and the nozzle.</param>
/// <param name="rules">Limits of the paths.</param>
/// <param name="options">Threads and tilt.</param>
internal sealed class SheetSlicer(LayerField field, PrintSetup setup, LiftRules rules, CurvedOptions options)
{
    private readonly LiftReport _report = new();
    private readonly Dictionary<SheetField, SheetWalls> _walls = [];

    /// <summary>The layers of all models, level by level.</summary>
    public SlicedLayer[] Slice(IReadOnlyList<SliceModel> models, DiagnosticList problems, IProgress<double>? progress, CancellationToken cancel)
    {
        var parts = models.Where(m => m.Settings.ModelType == ModelType.Part).ToArray();
        var layers = new List<SlicedLayer>();
        for (var i = 0; i < parts.Length; i++)
            layers.AddRange(Walls(parts[i], progress.Part((double)i / parts.Length, (i + 1.0) / parts.Length), cancel));
        LiftFindings.Add(_report, rules, layers.Select(l => l.Steps), problems);
        var cooling = new LayerCooling(setup.Settings);
        var result = new List<SlicedLayer>();
        foreach (var level in layers.GroupBy(l => l.Layer.Z).OrderBy(g => g.Key))
        {
            var together = level.Select((layer, k) => Numbered(layer, result.Count + k)).ToArray();
            cooling.Apply(together);
            result.AddRange(together);
        }
        cooling.Report(problems);
        if (!field.StartsLevel || result.Count == 0) return result.ToArray();
        var onBed = Region.Union(
            result.Where(l => l.Layer.Z <= setup.Settings.FirstLayerHeight + 1e-6).Select(l => WallArea.Of(l, setup.Settings.BeadShape)));
        result[0] = Adhesion.Around(result[0], onBed, onBed, setup.Settings);
        return result.ToArray();
    }

    // The layers of a model that print something.
    private IReadOnlyList<SlicedLayer> Walls(SliceModel model, IProgress<double>? progress, CancellationToken cancel)
    {
        var (sheet, shift) = field.SheetOf(model.Mesh.Mesh)!.Value;
        if (!_walls.TryGetValue(sheet, out var walls)) _walls.Add(sheet, walls = new SheetWalls(sheet, rules.MinGap, LayerRules.GreatestGap(setup)));
        var (first, usual) = (Slicing(model, isFirst: true), Slicing(model, isFirst: false));
        var paths = new IReadOnlyList<PrintPath>[walls.Count - 1];
        var reports = new LiftReport[paths.Length];
        var done = 0;
        var parallel = new ParallelOptions { CancellationToken = cancel, MaxDegreeOfParallelism = options.Threads > 0 ? options.Threads : -1 };
        Parallel.For(0, paths.Length, parallel, i =>
        {
            var tracer = new SheetTracer(walls, rules, SheetWalls.IsFirst(i + 1) ? first : usual, shift);
            paths[i] = tracer.Trace(i + 1);
            reports[i] = tracer.Report;
            // In turn, so that what is reported ascends.
            lock (paths) progress?.Report((double)++done / paths.Length);
        });
        foreach (var report in reports) _report.Add(report);
        var layers = new List<SlicedLayer>();
        for (var i = 0; i < paths.Length; i++)
        {
            if (paths[i].Count == 0) continue;
            var slicing = SheetWalls.IsFirst(i + 1) ? first : usual;
            var layer = new Layer(layers.Count, walls.Level(i + 1), slicing.Thickness, model.Mesh.Name);
            var steps = paths[i].Select(p => new PathStep(slicing.Own(p with { Role = Role.OuterWall, Layer = layer }), new StepGroup(i, 0, StepRank.Walls)));
            // A tool that leans has nothing below its tip but the wall.
            layers.Add(new SlicedLayer(layer, Region.Empty, (options.MaxTilt > 0 ? steps : steps.SelectMany(UphillPaths.Of)).ToArray()));
        }
        return layers;
    }

    private SliceRules Slicing(SliceModel model, bool isFirst)
        => SliceRules.Of(model.Settings, isFirst ? setup.Settings.FirstLayerHeight : setup.Settings.LayerHeight, setup.Settings, isFirst);

    // Groups have the number of their layer in the whole print.
    private static SlicedLayer Numbered(SlicedLayer layer, int number)
        => layer with { Steps = layer.Steps.Select(s => s with { Group = s.Group!.Value with { Layer = number } }).ToArray() };
}
