using System.Collections.Generic;
using Caterpillar.Machines;

namespace Caterpillar.Slicing;

/// <summary>Divides a height into layers.</summary>
internal static class LayerPlan
{
    private const int MaxLayers = 1_000_000;

    /// <summary>
    /// Layers from the bed up to a height (mm): the first of its own thickness, the others alike. A layer belongs to the
    /// plan when the place where it cuts lies below the height. Null where there would be more than a million.
    /// </summary>
    public static PlannedLayer[]? Of(double height, PrintSettings settings)
    {
        var layers = new List<PlannedLayer>();
        // Multiples of the thickness, not sums, so that a hundred layers do not drift.
        for (var i = 0; ; i++)
        {
            var layer = i == 0
                ? Layer(settings.FirstLayerHeight, settings.FirstLayerHeight)
                : Layer(settings.FirstLayerHeight + i * settings.LayerHeight, settings.LayerHeight);
            if (!(layer.Cut < height)) return layers.ToArray();
            if (layers.Count == MaxLayers) return null;
            layers.Add(layer);
        }
    }

    private static PlannedLayer Layer(double top, double thickness) => new(top, thickness, top - thickness / 2);
}
