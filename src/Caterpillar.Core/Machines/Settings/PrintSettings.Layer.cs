namespace Caterpillar.Machines;

// How a model is divided into layers.
public sealed partial record PrintSettings
{
    /// <summary>Height at which a layer cuts the model: its middle or its bottom.</summary>
    public SlicingPlane SlicingPlane { get; init; }

    /// <summary>Height ranges with their own layer height: a list of [from, to, layer height].</summary> <value>mm.</value>
    public ValueList<LayerRange> LayerRanges { get; init => field = LayerKeys.LayerRanges.Check(value); } = ValueList<LayerRange>.Empty;

    /// <summary>Layer height as a formula in z (mm), such as 0.1 + 0.1 * z / 40; empty = layer_height_mm.</summary>
    public string LayerFormula { get; init => field = LayerKeys.LayerFormula.Check(value); } = "";

    /// <summary>Use thinner layers where the surface is shallow.</summary>
    public bool AdaptiveLayers { get; init; }

    /// <summary>Minimum height of adaptive layers; 0 = 20 % of the nozzle diameter.</summary> <value>mm.</value>
    public double AdaptiveMinHeight { get => OfNozzle(field, 0.08); init => field = LayerKeys.AdaptiveMinHeight.Check(value); }

    /// <summary>Maximum height of adaptive layers; 0 = 70 % of the nozzle diameter.</summary> <value>mm.</value>
    public double AdaptiveMaxHeight { get => OfNozzle(field, 0.28); init => field = LayerKeys.AdaptiveMaxHeight.Check(value); }

    /// <summary>
    /// Maximum cusp height of adaptive layers: distance between steps and surface, normal to the surface; 0 = layers thinner than layer_height_mm only where
    /// the surface rises by less than 26°.
    /// </summary>
    /// <value>mm.</value>
    public double AdaptiveCuspHeight { get; init => field = LayerKeys.AdaptiveCuspHeight.Check(value); }

    /// <summary>Grow outlines by this much; negative = shrink.</summary> <value>mm.</value>
    public double XySizeCompensation { get; init => field = LayerKeys.XySizeCompensation.Check(value); }

    /// <summary>Enlarge holes by this much on each side; negative = shrink.</summary> <value>mm.</value>
    public double XyHoleCompensation { get; init => field = LayerKeys.XyHoleCompensation.Check(value); }

    /// <summary>
    /// Print round upright holes as polygons with about two sides for each mm of the diameter, whose sides touch the circle: many short chords print too small.
    /// </summary>
    public bool HoleToPolyhole { get; init; }

    /// <summary>Turn these polygons by half a side in every other layer.</summary>
    public bool HoleToPolyholeTwisted { get; init; } = true;

    /// <summary>Maximum deviation of the corners of a round hole from a circle.</summary> <value>mm.</value>
    public double HoleToPolyholeThreshold { get; init => field = LayerKeys.HoleToPolyholeThreshold.Check(value); } = 0.01;

    /// <summary>Shrink the outline of the first layer by this much; negative = grow.</summary> <value>mm.</value>
    public double ElephantFootCompensation { get; init => field = LayerKeys.ElephantFootCompensation.Check(value); }
}

/// <summary>Keys of print settings: layers and compensations.</summary>
internal static class LayerKeys
{
    public static readonly KeyTable<PrintSettings> All = new();

    public static readonly ProfileKey<PrintSettings, SlicingPlane> SlicingPlane
        = All.Choice("slicing_plane", s => s.SlicingPlane, (s, v) => s with { SlicingPlane = v });
    public static readonly ProfileKey<PrintSettings, ValueList<LayerRange>> LayerRanges = All.Of(
        "height_ranges_mm",
        new RowsFormat<LayerRange>(["from", "to", "layer height"], 1000, 0, 100_000, LayerRange.Of, r => [r.From, r.To, r.Thickness], LayerRange.Problem),
        s => s.LayerRanges, (s, v) => s with { LayerRanges = v });
    public static readonly ProfileKey<PrintSettings, string> LayerFormula
        = All.Of("layer_height_formula", new FormulaFormat("z"), s => s.LayerFormula, (s, v) => s with { LayerFormula = v });
    public static readonly FlagKey AdaptiveLayers = All.Boolean("adaptive_layers", s => s.AdaptiveLayers, (s, v) => s with { AdaptiveLayers = v });
    public static readonly NumberKey AdaptiveMinHeight
        = All.NumberOrZero("adaptive_min_height_mm", 0.001, 1000, s => s.AdaptiveMinHeight, (s, v) => s with { AdaptiveMinHeight = v });
    public static readonly NumberKey AdaptiveMaxHeight
        = All.NumberOrZero("adaptive_max_height_mm", 0.001, 1000, s => s.AdaptiveMaxHeight, (s, v) => s with { AdaptiveMaxHeight = v });
    public static readonly NumberKey AdaptiveCuspHeight
        = All.NumberOrZero("adaptive_cusp_height_mm", 0.0001, 1000, s => s.AdaptiveCuspHeight, (s, v) => s with { AdaptiveCuspHeight = v });
    public static readonly NumberKey XySizeCompensation
        = All.Number("xy_size_compensation_mm", -100, 100, s => s.XySizeCompensation, (s, v) => s with { XySizeCompensation = v });
    public static readonly NumberKey XyHoleCompensation
        = All.Number("xy_hole_compensation_mm", -100, 100, s => s.XyHoleCompensation, (s, v) => s with { XyHoleCompensation = v });
    public static readonly FlagKey HoleToPolyhole = All.Boolean("hole_to_polyhole", s => s.HoleToPolyhole, (s, v) => s with { HoleToPolyhole = v });
    public static readonly FlagKey HoleToPolyholeTwisted
        = All.Boolean("hole_to_polyhole_twisted", s => s.HoleToPolyholeTwisted, (s, v) => s with { HoleToPolyholeTwisted = v });
    public static readonly NumberKey HoleToPolyholeThreshold
        = All.Number("hole_to_polyhole_threshold_mm", 0, 10, s => s.HoleToPolyholeThreshold, (s, v) => s with { HoleToPolyholeThreshold = v });
    public static readonly NumberKey ElephantFootCompensation
        = All.Number("elephant_foot_compensation_mm", -100, 100, s => s.ElephantFootCompensation, (s, v) => s with { ElephantFootCompensation = v });
}
