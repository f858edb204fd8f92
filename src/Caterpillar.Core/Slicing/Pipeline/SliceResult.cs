using Caterpillar.Toolpaths;

namespace Caterpillar.Slicing;

/// <summary>The layers of all objects, from below.</summary>
public class SliceResult
{
    internal SliceResult(IReadOnlyList<SlicedLayer> layers) => Layers = layers;

    /// <summary>
    /// By height; layers of equal height in the order of their objects. Curved layers whose pieces the head would have to go through are in pieces, each a
    /// layer of its own, in the order in which they can be printed.
    /// </summary>
    public IReadOnlyList<SlicedLayer> Layers { get; }

    /// <summary>All paths as steps for planning.</summary>
    public IReadOnlyList<Step> ToSteps()
    {
        var steps = new List<Step>();
        foreach (var layer in Layers) steps.AddRange(layer.Steps);
        return steps;
    }
}
