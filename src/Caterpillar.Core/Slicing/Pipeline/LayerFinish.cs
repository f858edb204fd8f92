namespace Caterpillar.Slicing;

/// <summary>
/// Adds everything that depends on earlier layers or on all models on the bed: seams, vases, supports, raft, skirt and minimum layer time. Layers are passed
/// on height by height, as soon as no layer above can change them.
/// </summary>
/// <param name="works">The layers in their order, as they are sliced.</param>
/// <param name="bodies">Models to print.</param>
/// <param name="settings">The settings of the print.</param>
/// <param name="supports">Adds supports. Null = no supports.</param>
/// <param name="problems">Receives diagnostics.</param>
/// <param name="options">Who takes finished layers, and the bed.</param>
internal sealed class LayerFinish(
    LayerWork[] works, IReadOnlyList<Body> bodies, PrintSettings settings, PrintSupports? supports, DiagnosticList problems,
    SliceOptions options)
{
    private const double SameHeight = 1e-9;
    private readonly Dictionary<Body, (VaseSpiral Spiral, int Last)> _vases = [];
    private readonly Dictionary<Body, SeamPlacer> _seams = [];
    private readonly LayerCooling _cooling = new(settings);

    // Then the skirt, which goes around all that stands on the bed, waits for all layers.
    private readonly bool _isByObject = bodies.Count > 1 && settings.PrintSequence == PrintSequence.ByObject;

    // All layers, null once they are given on.
    private readonly List<SlicedLayer?> _all = [];
    private int _given;

    // What stands on the bed, where all layers are known; else those of the lowest height.
    private List<SlicedLayer>? _low;

    // The layers of each height, where tools take turns: their order depends on all of them. Curved layers keep theirs.
    private readonly List<SlicedLayer[]>? _levels = options.Divide is null && ToolTurns.AreNeeded(works) ? [] : null;
    private bool _begun;

    // Those of the height that is being collected, and all that are finished.
    private readonly List<SlicedLayer> _level = [];
    private readonly List<SlicedLayer> _finished = [];
    private int _count;

    private bool TakesTurns => bodies.Count > 1 && !_isByObject;

    /// <summary>The next layer.</summary>
    public void Add(SlicedLayer layer)
    {
        var work = works[_count++];
        if (!_seams.TryGetValue(work.Body, out var placer)) _seams.Add(work.Body, placer = new SeamPlacer(work.Body));
        var finished = placer.Next(work, layer);
        if (work.VaseLoop is not null)
        {
            if (!_vases.TryGetValue(work.Body, out var vase)) vase = (new VaseSpiral(!TakesTurns), 0);
            finished = vase.Spiral.Next(work, layer);
            _vases[work.Body] = (vase.Spiral, finished.Steps.Count > 0 ? _all.Count : vase.Last);
        }
        else
        {
            finished = LayerArcs.Fit(finished, work.Rules.Settings.ArcFittingTolerance, ofPart: true);
        }
        _all.Add(finished);
        if (options.Take is null || _isByObject || _levels is not null) return;
        // The highest layer of a vase may yet become its end.
        var open = supports?.AddTo(_all, waits: false) ?? _all.Count;
        foreach (var vase in _vases.Values) open = Math.Min(open, vase.Last);
        Release(open);
    }

    /// <summary>All finished layers that print something.</summary>
    public SlicedLayer[] End()
    {
        foreach (var body in _vases.Keys.OrderBy(b => b.Number)) EndVase(_vases[body].Spiral, _vases[body].Last, body);
        for (var supported = 0; supports is not null && supported < _all.Count;)
        {
            supported = supports.AddTo(_all, waits: true);
            if (!_isByObject) Release(supported);
        }
        if (_isByObject) _low = Low();
        Release(_all.Count);
        EndLevel();
        if (_levels is not null) TakeTurns();
        _cooling.Report(problems);
        return _finished.ToArray();
    }

    private void Release(int end)
    {
        for (; _given < end; _given++)
        {
            var layer = _all[_given]!;
            _all[_given] = null;
            if (layer.Steps.Count == 0) continue;
            if (_level.Count > 0 && Math.Abs(layer.Layer.Z - _level[0].Layer.Z) >= SameHeight) EndLevel();
            _level.Add(layer);
        }
    }

    private void EndLevel()
    {
        if (_level.Count == 0) return;
        if (!_begun) Begin();
        _begun = true;
        Collect(_level.ToArray());
        _level.Clear();
    }

    private void Collect(SlicedLayer[] level)
    {
        if (_levels is null) GiveOn(level);
        else _levels.Add(level);
    }

    private void GiveOn(SlicedLayer[] level)
    {
        for (var i = 0; i < level.Length; i++) level[i] = LayerArcs.Fit(level[i], settings.ArcFittingTolerance, ofPart: false);
        _cooling.Apply(level);
        options.Take?.Invoke(level);
        foreach (var layer in level) _finished.Add(options.Take is null ? layer : layer with { Steps = [] });
    }

    private void TakeTurns()
    {
        var (turns, number) = (ToolTurns.Of(_levels!), 0);
        var volume = settings.PurgeVolume > 0 ? settings.PurgeVolume : options.Printer.SharedNozzle ? 140 : 15;
        if (settings.PurgeTower || settings.PurgeIntoInfill)
        {
            foreach (var turn in turns.SelectMany(t => t).Where(t => t.Changes)) turn.Purge = volume;
        }
        if (settings.PurgeIntoInfill) turns.ForEach(InfillPurge.Take);
        if (settings.PurgeTower && settings.PrintSequence == PrintSequence.ByLayer) PurgeTower.Add(turns, settings, options.Printer);
        else if (turns.Sum(t => t.Count(turn => turn.Purge > 0)) is > 0 and var left)
            problems.Add(Severity.Warning, "slice.purge", "The infill after a tool change is less than purge_volume_mm3. Set purge_tower=true.", null, left);
        foreach (var turn in turns) GiveOn(ToolTurns.Layers(turn, ref number));
    }

    // All objects that stand as low as the first layer, which are those that the loops go around together.
    private List<SlicedLayer> Low()
    {
        var printed = _all.Select(l => l!).Where(l => l.Steps.Count > 0).ToList();
        return printed.FindAll(l => l.Layer.Z <= printed[0].Layer.Z + SameHeight);
    }

    // Below the first layers and around them.
    private void Begin()
    {
        var low = _low ?? _level;
        var parts = low.Select(l => WallArea.Of(l, settings.BeadShape)).ToArray();
        var covered = Region.Union(parts.Concat(low.Select(l => l.Support)));
        _low = null;
        if (settings.RaftLayers == 0)
        {
            _level[0] = Adhesion.Around(_level[0], Region.Union(parts), covered, settings);
            return;
        }
        foreach (var layer in Raft.Below(covered, settings))
            Collect([layer.Layer.Index > 0 ? layer : Adhesion.Around(layer, layer.Region, layer.Region, settings)]);
    }

    private void EndVase(VaseSpiral spiral, int last, Body body)
    {
        if (spiral.Finish() is { } end) _all[last] = end;
        if (settings.CoastingDistance > 0 && TakesTurns)
        {
            var open = NumberFormatter.Format(settings.CoastingDistance, 2);
            problems.Add(Severity.Warning, "slice.spiral_vase_lag",
                $"The print head leaves the vase after each turn to print other models, and coasting_distance_mm leaves a gap of {open} mm in its wall. "
                + "Set print_sequence=by_object to print one model at a time.", body.Source);
        }
        if (spiral.Divided == 0) return;
        problems.Add(Severity.Warning, "slice.spiral_vase_divided",
            "A layer of the vase has several pieces. Only the largest is printed, because a vase has one wall.", body.Source, spiral.Divided);
    }
}
