namespace Caterpillar.Slicing;

/// <summary>
/// Takes layers through the stages in blocks from below: while one block gets its outlines, the layers whose upper neighbors are known by then get
/// their filling. So few layers are in flight, and what comes out is in order, whatever the number of threads.
/// </summary>
internal sealed class LayerStream
{
    private const int Block = 16;
    private readonly LayerWork[] _layers;
    private readonly int[] _needed;
    private readonly ParallelOptions _options;
    private readonly ConcurrentBag<LayerTools> _tools = [];

    /// <param name="layers">The layers of all bodies in the order in which they are wanted.</param>
    /// <param name="threads">Number of threads. 0 = all cores.</param>
    /// <param name="cancel">Cancels the call.</param>
    public LayerStream(LayerWork[] layers, int threads, CancellationToken cancel)
    {
        _layers = layers;
        _options = new ParallelOptions { CancellationToken = cancel, MaxDegreeOfParallelism = threads > 0 ? threads : -1 };
        for (var i = 0; i < layers.Length; i++) layers[i].Order = i;
        _needed = Array.ConvertAll(layers, LastNeeded);
        // A layer is never finished before a lower one.
        for (var i = 1; i < _needed.Length; i++) _needed[i] = Math.Max(_needed[i], _needed[i - 1]);
    }

    /// <summary>The finished layers in their order. While they are taken, the next block is sliced.</summary>
    public IEnumerable<SlicedLayer> Run(IProgress<double>? progress)
    {
        var done = new SlicedLayer[_layers.Length];
        var (work, next) = Begin(done, default);
        try
        {
            for (var before = default(Front); before.Filled < _layers.Length;)
            {
                work.GetAwaiter().GetResult();
                var (first, reached) = (before.Filled, next);
                if (reached.Filled < _layers.Length) (work, next) = Begin(done, reached);
                progress?.Report((double)(reached.Filled + reached.Outlined) / (2 * _layers.Length));
                for (var i = first; i < reached.Filled; i++)
                {
                    yield return done[i];
                    done[i] = null!;
                    Release(_layers[i]);
                }
                before = reached;
            }
        }
        finally
        {
            OwnThread.Wait(work);
        }
    }

    // Begins the block above what has been reached.
    private (Task Work, Front Next) Begin(SlicedLayer[] done, Front reached)
    {
        var next = new Front(Math.Min(_layers.Length, reached.Outlined + Block), reached.Filled);
        while (next.Filled < _layers.Length && _needed[next.Filled] < reached.Outlined) next = next with { Filled = next.Filled + 1 };
        int fills = next.Filled - reached.Filled, all = fills + next.Outlined - reached.Outlined;
        // One by one, for some take many times as long as others.
        var each = Partitioner.Create(Enumerable.Range(0, all), EnumerablePartitionerOptions.NoBuffering);
        void Work() => Parallel.ForEach(each, _options, () => _tools.TryTake(out var tools) ? tools : new LayerTools(), (i, _, tools) =>
        {
            if (i < fills) done[reached.Filled + i] = FillStage.Run(_layers[reached.Filled + i], tools);
            else OutlineStage.Run(_layers[reached.Outlined + i - fills], tools.Engine);
            return tools;
        }, _tools.Add);
        if (_options.MaxDegreeOfParallelism != 1) return (Task.Run(Work), next);
        Work();
        return (Task.CompletedTask, next);
    }

    // The next layers need the regions of those below them; the islands of the last one, or of those whose infill is printed at once.
    private static void Release(LayerWork layer)
    {
        var at = layer.Index - layer.Rules.Settings.CombineInfillLayers;
        if (at >= 0) layer.Body.Layers[at].Islands = [];
    }

    private static int LastNeeded(LayerWork layer) => layer.Body.Layers[FillStage.LastNeeded(layer)].Order;

    // So many layers have their outlines, and their filling.
    private readonly record struct Front(int Outlined, int Filled);
}
