using FlagKey = Caterpillar.Machines.ProfileKey<Caterpillar.Machines.PrintSettings, bool>;
using NumberKey = Caterpillar.Machines.ProfileKey<Caterpillar.Machines.PrintSettings, double>;

namespace Caterpillar.Machines;

// How a model is divided into layers.
public sealed partial record PrintSettings
{
    /// <summary>Where in its thickness a layer cuts the model.</summary>
    public SlicingPlane SlicingPlane { get; init; }

    /// <summary>Heights between which layers have a thickness of their own: a list of [from, to, thickness].</summary> <value>mm.</value>
    public ValueList<LayerRange> LayerRanges { get; init => field = LayerKeys.LayerRanges.Check(value); } = ValueList<LayerRange>.Empty;

    /// <summary>Thickness of the layers as a formula in z, the height in mm at which a layer begins: 0.1 + 0.1 * z / 40; empty for layer_height_mm.</summary>
    public string LayerFormula { get; init => field = LayerKeys.LayerFormula.Check(value); } = "";

    /// <summary>Layers get thinner where the surface is shallow.</summary>
    public bool AdaptiveLayers { get; init; }

    /// <summary>Thinnest layer of adaptive layers.</summary> <value>mm.</value>
    public double AdaptiveMinHeight { get; init => field = LayerKeys.AdaptiveMinHeight.Check(value); } = 0.08;

    /// <summary>Thickest layer of adaptive layers.</summary> <value>mm.</value>
    public double AdaptiveMaxHeight { get; init => field = LayerKeys.AdaptiveMaxHeight.Check(value); } = 0.28;

    /// <summary>Adaptive layers: largest distance between the steps of the layers and the surface, measured across the surface.</summary> <value>mm.</value>
    public double AdaptiveCuspHeight { get; init => field = LayerKeys.AdaptiveCuspHeight.Check(value); } = 0.1;

    /// <summary>Outlines of the part are moved outwards by this much, or inwards where it is negative.</summary> <value>mm.</value>
    public double XySizeCompensation { get; init => field = LayerKeys.XySizeCompensation.Check(value); }

    /// <summary>Holes are made larger by this much on every side, or smaller where it is negative.</summary> <value>mm.</value>
    public double XyHoleCompensation { get; init => field = LayerKeys.XyHoleCompensation.Check(value); }

    /// <summary>The outline of the first layer is moved outwards by this much, or inwards where it is negative (an elephant's foot).</summary>
    /// <value>mm.</value>
    public double ElephantFootCompensation { get; init => field = LayerKeys.ElephantFootCompensation.Check(value); }
}

/// <summary>Keys of print settings: how a model is divided into layers.</summary>
internal static class LayerKeys
{
    public static readonly KeyTable<PrintSettings> All = new();

    public static readonly ProfileKey<PrintSettings, SlicingPlane> SlicingPlane
        = All.Choice("slicing_plane", s => s.SlicingPlane, (s, v) => s with { SlicingPlane = v });
    public static readonly ProfileKey<PrintSettings, ValueList<LayerRange>> LayerRanges = All.Of(
        "height_ranges_mm",
        new RowsFormat<LayerRange>(["from", "to", "thickness"], 1000, 0, 100_000, LayerRange.Of, r => [r.From, r.To, r.Thickness], LayerRange.Problem),
        s => s.LayerRanges, (s, v) => s with { LayerRanges = v });
    public static readonly ProfileKey<PrintSettings, string> LayerFormula
        = All.Of("layer_height_formula", new FormulaFormat("z"), s => s.LayerFormula, (s, v) => s with { LayerFormula = v });
    public static readonly FlagKey AdaptiveLayers = All.Boolean("adaptive_layers", s => s.AdaptiveLayers, (s, v) => s with { AdaptiveLayers = v });
    public static readonly NumberKey AdaptiveMinHeight
        = All.Number("adaptive_min_height_mm", 0.001, 1000, s => s.AdaptiveMinHeight, (s, v) => s with { AdaptiveMinHeight = v });
    public static readonly NumberKey AdaptiveMaxHeight
        = All.Number("adaptive_max_height_mm", 0.001, 1000, s => s.AdaptiveMaxHeight, (s, v) => s with { AdaptiveMaxHeight = v });
    public static readonly NumberKey AdaptiveCuspHeight
        = All.Number("adaptive_cusp_height_mm", 0.0001, 1000, s => s.AdaptiveCuspHeight, (s, v) => s with { AdaptiveCuspHeight = v });
    public static readonly NumberKey XySizeCompensation
        = All.Number("xy_size_compensation_mm", -100, 100, s => s.XySizeCompensation, (s, v) => s with { XySizeCompensation = v });
    public static readonly NumberKey XyHoleCompensation
        = All.Number("xy_hole_compensation_mm", -100, 100, s => s.XyHoleCompensation, (s, v) => s with { XyHoleCompensation = v });
    public static readonly NumberKey ElephantFootCompensation
        = All.Number("elephant_foot_compensation_mm", -100, 100, s => s.ElephantFootCompensation, (s, v) => s with { ElephantFootCompensation = v });
}
