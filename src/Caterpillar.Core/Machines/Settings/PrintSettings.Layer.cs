namespace Caterpillar.Machines;

// How a model is divided into layers.
public sealed partial record PrintSettings
{
    /// <summary>Where in its thickness a layer cuts the model.</summary>
    public LayerCut LayerCut { get; init; }

    /// <summary>Heights between which layers have a thickness of their own: a list of [from, to, thickness], mm.</summary>
    public ValueList<LayerRange> LayerRanges { get; init => field = LayerKeys.LayerRanges.Check(value); } = ValueList<LayerRange>.Empty;

    /// <summary>Thickness of the layers as a formula in z, the height in mm at which a layer begins: 0.1 + 0.1 * z / 40; empty for layer_height_mm.</summary>
    public string LayerFormula { get; init => field = LayerKeys.LayerFormula.Check(value); } = "";

    /// <summary>Layers get thinner where the surface is shallow.</summary>
    public bool AdaptiveLayers { get; init; }

    /// <summary>Thinnest layer of adaptive layers, mm.</summary>
    public double AdaptiveMinHeight { get; init => field = LayerKeys.AdaptiveMinHeight.Check(value); } = 0.08;

    /// <summary>Thickest layer of adaptive layers, mm.</summary>
    public double AdaptiveMaxHeight { get; init => field = LayerKeys.AdaptiveMaxHeight.Check(value); } = 0.28;

    /// <summary>Adaptive layers: largest distance between the steps of the layers and the surface, measured across the surface, mm.</summary>
    public double AdaptiveCusp { get; init => field = LayerKeys.AdaptiveCusp.Check(value); } = 0.1;

    /// <summary>Outlines of the part are moved outward by this much, or inward where it is negative, mm.</summary>
    public double XyCompensation { get; init => field = LayerKeys.XyCompensation.Check(value); }

    /// <summary>Holes are made larger by this much on every side, or smaller where it is negative, mm.</summary>
    public double HoleCompensation { get; init => field = LayerKeys.HoleCompensation.Check(value); }

    /// <summary>The outline of the first layer is moved outward by this much, or inward where it is negative (an elephant's foot), mm.</summary>
    public double FirstLayerCompensation { get; init => field = LayerKeys.FirstLayerCompensation.Check(value); }
}
