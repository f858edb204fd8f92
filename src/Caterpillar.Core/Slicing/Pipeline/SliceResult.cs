namespace Caterpillar.Slicing;

/// <summary>The layers of all models, from bottom to top.</summary>
public class SliceResult
{
    internal SliceResult(IReadOnlyList<SlicedLayer> layers) => Layers = layers;

    /// <summary>
    /// The layers by height; layers of equal height in the order of their models. With several tools, layers are divided into what each tool prints. Curved
    /// layers may be divided into pieces to keep the print head clear of printed parts. Then each piece is a layer of its own, in print order.
    /// </summary>
    public IReadOnlyList<SlicedLayer> Layers { get; }

    /// <summary>The paths of all layers, as steps for planning.</summary>
    public IReadOnlyList<Step> ToSteps() => Layers.SelectMany(l => l.Steps).ToList<Step>();
}
