namespace Caterpillar.Slicing;

/// <summary>
/// The supports of a print. They need the regions of all layers and nothing else, so they are found and filled while the layers are filled, and printed with
/// the layers beside them.
/// </summary>
internal sealed class PrintSupports : IDisposable
{
    // Levels that are filled before they are given on.
    private const int Block = 32;
    private readonly CancellationToken _cancel;
    private readonly CancellationTokenSource _stop;
    private readonly BlockingCollection<Filled[]> _filled = [];
    private readonly ConcurrentBag<LayerTools> _tools = [];
    private readonly Task _work;

    // What is filled and waits for its layers, and the number of layers from the lowest on that have their supports.
    private Filled[] _next = [];
    private int _at;
    private int _supported;

    private PrintSupports(LayerWork[] works, Func<ParallelOptions, List<SupportStack>> build, ParallelOptions options)
    {
        _cancel = options.CancellationToken;
        _stop = CancellationTokenSource.CreateLinkedTokenSource(_cancel);
        var own = new ParallelOptions { CancellationToken = _stop.Token, MaxDegreeOfParallelism = options.MaxDegreeOfParallelism };
        void Work()
        {
            try
            {
                Fill(build(own), works, own);
            }
            finally
            {
                _filled.CompleteAdding();
            }
        }
        if (options.MaxDegreeOfParallelism == 1) Work();
        _work = options.MaxDegreeOfParallelism == 1 ? Task.CompletedTask : OwnThread.Run(Work);
    }

    /// <summary>Starts the supports, or returns null if no model needs them. Afterwards the regions of all layers are known.</summary>
    /// <param name="works">The layers in their order, before they are sliced.</param>
    /// <param name="bodies">What is printed.</param>
    /// <param name="helpers">Bodies in which supports are blocked or enforced.</param>
    /// <param name="common">The settings of the print.</param>
    /// <param name="options">Threads, and cancelling.</param>
    public static PrintSupports? Begin(
        LayerWork[] works, IReadOnlyList<Body> bodies, IReadOnlyList<SliceModel> helpers, PrintSettings common, ParallelOptions options)
    {
        if (!works.Any(w => w.Rules.Settings.Support != SupportKind.None)) return null;
        RegionEngine.ForEach(0, works.Length, options, (i, engine) => LayerRegion.Find(works[i], engine));
        return new PrintSupports(works, own => Build(works, bodies, helpers, common, own), options);
    }

    /// <summary>Adds what is filled to layers, in place; returns how many of them, from the lowest on, have their supports now.</summary>
    /// <param name="layers">The layers so far, also those without steps; null where they need nothing any more.</param>
    /// <param name="waits">Waits until something is filled.</param>
    public int AddTo(List<SlicedLayer?> layers, bool waits)
    {
        if (_at == _next.Length && _filled.TryTake(out var next, waits ? Timeout.Infinite : 0, _cancel)) (_next, _at) = (next, 0);
        for (; _at < _next.Length && _next[_at].Layer < layers.Count; _at++)
        {
            var (at, support, steps) = _next[_at];
            var layer = layers[at]!;
            if (steps.Count > 0) layers[at] = layer with { Steps = [.. layer.Steps, .. steps], Support = support };
            _supported = at + 1;
        }
        if (_at < _next.Length || !_filled.IsCompleted) return _supported;
        OwnThread.Wait(_work);
        _work.GetAwaiter().GetResult();
        return layers.Count;
    }

    /// <summary>Stops unfinished work and waits for it.</summary>
    public void Dispose()
    {
        _stop.Cancel();
        OwnThread.Wait(_work);
        _filled.Dispose();
        _stop.Dispose();
    }

    private static List<SupportStack> Build(
        LayerWork[] works, IReadOnlyList<Body> bodies, IReadOnlyList<SliceModel> helpers, PrintSettings common, ParallelOptions options)
    {
        var stacks = SupportStack.Of(bodies, common);
        TriMesh[] Used(ModelType use) => helpers.Where(h => h.Settings.ModelType == use).Select(h => h.Mesh.Mesh).ToArray();
        var (blockers, enforcers) = (Used(ModelType.SupportBlocker), Used(ModelType.SupportEnforcer));
        foreach (var stack in stacks)
        {
            // Bodies that stand in this stack need no second look: its levels hold them.
            var others = works.Where(w => w.Rules.Settings != stack.Settings || common.PrintSequence == PrintSequence.ByObject || stack.Settings.AdaptiveLayers)
                .Where(w => w.Body != stack.Levels[0].Work.Body).ToArray();
            new SupportBuilder(stack, options).Build(others, blockers, enforcers);
        }
        return stacks;
    }

    private void Fill(List<SupportStack> stacks, LayerWork[] works, ParallelOptions options)
    {
        var places = Enumerable.Range(0, works.Length).ToDictionary(i => works[i]);
        var levels = stacks
            .SelectMany(s => s.Levels.Where(l => !l.Pieces.IsEmpty).Select(l => (Layer: places[l.Work], Level: l, s.Settings)))
            .OrderBy(l => l.Layer).ToArray();
        for (var first = 0; first < levels.Length; first += Block)
        {
            var filled = new Filled[Math.Min(Block, levels.Length - first)];
            Parallel.For(0, filled.Length, options, () => _tools.TryTake(out var tools) ? tools : new LayerTools(), (i, _, tools) =>
            {
                var (layer, level, settings) = levels[first + i];
                filled[i] = new Filled(layer, level.Pieces, new SupportFiller(level, settings, tools).Fill());
                return tools;
            }, _tools.Add);
            _filled.Add(filled);
        }
    }

    // The supports of a layer.
    private readonly record struct Filled(int Layer, Region Support, List<PathStep> Steps);
}
