using FlagKey = Caterpillar.Machines.ProfileKey<Caterpillar.Machines.PrintSettings, bool>;
using NumberKey = Caterpillar.Machines.ProfileKey<Caterpillar.Machines.PrintSettings, double>;

namespace Caterpillar.Machines;

// How a model is divided into layers.
public sealed partial record PrintSettings
{
    /// <summary>Where in its thickness a layer cuts the model.</summary>
    public LayerCut LayerCut { get; init; }

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
    public double AdaptiveCusp { get; init => field = LayerKeys.AdaptiveCusp.Check(value); } = 0.1;

    /// <summary>Outlines of the part are moved outwards by this much, or inwards where it is negative.</summary> <value>mm.</value>
    public double XyCompensation { get; init => field = LayerKeys.XyCompensation.Check(value); }

    /// <summary>Holes are made larger by this much on every side, or smaller where it is negative.</summary> <value>mm.</value>
    public double HoleCompensation { get; init => field = LayerKeys.HoleCompensation.Check(value); }

    /// <summary>The outline of the first layer is moved outwards by this much, or inwards where it is negative (an elephant's foot).</summary>
    /// <value>mm.</value>
    public double FirstLayerCompensation { get; init => field = LayerKeys.FirstLayerCompensation.Check(value); }
}

/// <summary>Keys of print settings: how a model is divided into layers.</summary>
internal static class LayerKeys
{
    public static readonly KeyTable<PrintSettings> All = new();

    public static readonly ProfileKey<PrintSettings, LayerCut> LayerCut = All.Choice("layer_cut", s => s.LayerCut, (s, v) => s with { LayerCut = v });
    public static readonly ProfileKey<PrintSettings, ValueList<LayerRange>> LayerRanges = All.Of(
        "layer_ranges_mm",
        new RowsFormat<LayerRange>(["from", "to", "thickness"], 1000, 0, 100_000, LayerRange.Of, r => [r.From, r.To, r.Thickness], LayerRange.Problem),
        s => s.LayerRanges, (s, v) => s with { LayerRanges = v });
    public static readonly ProfileKey<PrintSettings, string> LayerFormula
        = All.Of("layer_height_formula", new FormulaFormat("z"), s => s.LayerFormula, (s, v) => s with { LayerFormula = v });
    public static readonly FlagKey AdaptiveLayers = All.Boolean("adaptive_layers", s => s.AdaptiveLayers, (s, v) => s with { AdaptiveLayers = v });
    public static readonly NumberKey AdaptiveMinHeight
        = All.Number("adaptive_min_height_mm", 0.001, 1000, s => s.AdaptiveMinHeight, (s, v) => s with { AdaptiveMinHeight = v });
    public static readonly NumberKey AdaptiveMaxHeight
        = All.Number("adaptive_max_height_mm", 0.001, 1000, s => s.AdaptiveMaxHeight, (s, v) => s with { AdaptiveMaxHeight = v });
    public static readonly NumberKey AdaptiveCusp = All.Number("adaptive_cusp_mm", 0.0001, 1000, s => s.AdaptiveCusp, (s, v) => s with { AdaptiveCusp = v });
    public static readonly NumberKey XyCompensation
        = All.Number("xy_compensation_mm", -100, 100, s => s.XyCompensation, (s, v) => s with { XyCompensation = v });
    public static readonly NumberKey HoleCompensation
        = All.Number("hole_compensation_mm", -100, 100, s => s.HoleCompensation, (s, v) => s with { HoleCompensation = v });
    public static readonly NumberKey FirstLayerCompensation
        = All.Number("first_layer_compensation_mm", -100, 100, s => s.FirstLayerCompensation, (s, v) => s with { FirstLayerCompensation = v });
}
