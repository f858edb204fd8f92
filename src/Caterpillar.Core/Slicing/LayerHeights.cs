using System;
using System.Collections.Generic;

namespace Caterpillar.Slicing;

/// <summary>A planar layer before it is cut: its top and its thickness, mm above the bed.</summary>
internal readonly record struct PlannedLayer(double Top, double Thickness)
{
    /// <summary>Where the mesh is cut: in the middle.</summary>
    public double Cut => Top - Thickness / 2;

    /// <summary>Layers from the bed up to a height: the first of its own thickness, the others alike, as many as have their middle below the height.</summary>
    public static PlannedLayer[] StackTo(double height, double first, double others)
    {
        var layers = new List<PlannedLayer>();
        // Multiples of the thickness, not sums, so that a hundred layers do not drift.
        for (var i = 0; ; i++)
        {
            var layer = i == 0 ? new PlannedLayer(first, first) : new PlannedLayer(first + i * others, others);
            if (!(layer.Cut < height)) return layers.ToArray();
            if (layers.Count == 1_000_000) throw new ArgumentOutOfRangeException(nameof(others), "More than a million layers: the layers are too thin.");
            layers.Add(layer);
        }
    }
}
