namespace Caterpillar.Machines;

// How a model is divided into layers.
public sealed partial record PrintSettings
{
    /// <summary>Height at which a layer cuts the model: its middle or its bottom.</summary>
    public SlicingPlane SlicingPlane { get; init; }

    /// <summary>Height ranges with their own layer height: a list of [from, to, layer height].</summary> <value>mm.</value>
    public ValueList<LayerRange> LayerRanges { get; init => field = Keys.Check(value); } = ValueList<LayerRange>.Empty;

    /// <summary>Layer height as a formula in z (mm), such as 0.1 + 0.1 * z / 40; empty = layer_height_mm.</summary>
    public string LayerFormula { get; init => field = Keys.Check(value); } = "";

    /// <summary>Use thinner layers where the surface is shallow.</summary>
    public bool AdaptiveLayers { get; init; }

    /// <summary>Minimum height of adaptive layers; 0 = 20 % of the nozzle diameter.</summary> <value>mm.</value>
    public double AdaptiveMinHeight { get => OfNozzle(field, 0.08); init => field = Keys.Check(value); }

    /// <summary>Maximum height of adaptive layers; 0 = 70 % of the nozzle diameter.</summary> <value>mm.</value>
    public double AdaptiveMaxHeight { get => OfNozzle(field, 0.28); init => field = Keys.Check(value); }

    /// <summary>
    /// Maximum cusp height of adaptive layers: distance between steps and surface, normal to the surface; 0 = layers thinner than layer_height_mm only where
    /// the surface rises by less than 26°.
    /// </summary>
    /// <value>mm.</value>
    public double AdaptiveCuspHeight { get; init => field = Keys.Check(value); }

    /// <summary>Grow outlines by this much; negative = shrink.</summary> <value>mm.</value>
    public double XySizeCompensation { get; init => field = Keys.Check(value); }

    /// <summary>Enlarge holes by this much on each side; negative = shrink.</summary> <value>mm.</value>
    public double XyHoleCompensation { get; init => field = Keys.Check(value); }

    /// <summary>
    /// Print round upright holes as polygons with about two sides for each mm of the diameter, whose sides touch the circle: many short chords print too small.
    /// </summary>
    public bool HoleToPolyhole { get; init; }

    /// <summary>Turn these polygons by half a side in every other layer.</summary>
    public bool HoleToPolyholeTwisted { get; init; } = true;

    /// <summary>Maximum deviation of the corners of a round hole from a circle.</summary> <value>mm.</value>
    public double HoleToPolyholeThreshold { get; init => field = Keys.Check(value); } = 0.01;

    /// <summary>Shrink the outline of the first layer by this much; negative = grow.</summary> <value>mm.</value>
    public double ElephantFootCompensation { get; init => field = Keys.Check(value); }
}
