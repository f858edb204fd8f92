using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;

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
    /// <param name="threads">Degree of parallelism, 0 for all cores.</param>
    /// <param name="cancel">Cancels.</param>
    public LayerStream(LayerWork[] layers, int threads, CancellationToken cancel)
    {
        _layers = layers;
        _options = new ParallelOptions { CancellationToken = cancel, MaxDegreeOfParallelism = threads > 0 ? threads : -1 };
        for (var i = 0; i < layers.Length; i++) layers[i].Order = i;
        _needed = Array.ConvertAll(layers, LastNeeded);
        // A layer is never finished before a lower one.
        for (var i = 1; i < _needed.Length; i++) _needed[i] = Math.Max(_needed[i], _needed[i - 1]);
    }

    /// <summary>The finished layers in their order.</summary>
    public IEnumerable<SlicedLayer> Run(IProgress<double>? progress)
    {
        var done = new SlicedLayer[_layers.Length];
        int outlined = 0, filled = 0;
        while (filled < _layers.Length)
        {
            var outlineTo = Math.Min(_layers.Length, outlined + Block);
            var fillTo = filled;
            while (fillTo < _layers.Length && _needed[fillTo] < outlined) fillTo++;
            int fills = fillTo - filled, all = fills + outlineTo - outlined, first = filled, from = outlined;
            Parallel.For(0, all, _options, Take, (i, _, tools) =>
            {
                if (i < fills) done[first + i] = FillStage.Run(_layers[first + i], tools);
                else OutlineStage.Run(_layers[from + i - fills], tools);
                return tools;
            }, _tools.Add);
            (filled, outlined) = (fillTo, outlineTo);
            progress?.Report((double)(filled + outlined) / (2 * _layers.Length));
            for (var i = first; i < fillTo; i++)
            {
                yield return done[i];
                done[i] = null!;
                Release(_layers[i]);
            }
        }
    }

    // The next layers need the regions of those below them; the islands of the last one, or of those whose infill is printed at once.
    private static void Release(LayerWork layer)
    {
        var at = layer.Index - layer.Rules.Settings.InfillEvery;
        if (at >= 0) layer.Body.Layers[at].Islands = [];
    }

    private LayerTools Take() => _tools.TryTake(out var tools) ? tools : new LayerTools();

    private static int LastNeeded(LayerWork layer) => layer.Body.Layers[FillStage.LastNeeded(layer)].Order;
}
