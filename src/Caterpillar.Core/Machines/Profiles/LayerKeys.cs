using System.Collections.Generic;
using K = Caterpillar.Machines.Keys<Caterpillar.Machines.PrintSettings>;

namespace Caterpillar.Machines;

/// <summary>Keys of print settings: how a model is divided into layers.</summary>
internal static class LayerKeys
{
    private static readonly string[] LayerVariables = ["z"];

    public static readonly ProfileKey<PrintSettings, LayerCut> LayerCut = K.Choice(
        "layer_cut", s => s.LayerCut, (s, v) => s with { LayerCut = v },
        "Where in its thickness a layer cuts the model.",
        ("middle", Machines.LayerCut.Middle), ("bottom", Machines.LayerCut.Bottom));

    public static readonly ProfileKey<PrintSettings, ValueList<LayerRange>> LayerRanges = new(
        "layer_ranges_mm",
        new RowsFormat<LayerRange>(
            ["from", "to", "thickness"], 0, 1000, 0, 100_000, LayerRange.Of, r => [r.From, r.To, r.Thickness], LayerRange.Problem),
        s => s.LayerRanges, (s, v) => s with { LayerRanges = v },
        "Heights between which layers have a thickness of their own: a list of [from, to, thickness].");

    public static readonly ProfileKey<PrintSettings, string> LayerFormula = new(
        "layer_height_formula", new FormulaFormat(LayerVariables), s => s.LayerFormula, (s, v) => s with { LayerFormula = v },
        "Thickness of the layers as a formula in z, the height in mm at which a layer begins: 0.1 + 0.1 * z / 40; empty for layer_height_mm.");

    public static readonly ProfileKey<PrintSettings, bool> AdaptiveLayers = K.Boolean(
        "adaptive_layers", s => s.AdaptiveLayers, (s, v) => s with { AdaptiveLayers = v },
        "Layers get thinner where the surface is shallow.");

    public static readonly ProfileKey<PrintSettings, double> AdaptiveMinHeight = K.Number(
        "adaptive_min_height_mm", 0.001, 1000, s => s.AdaptiveMinHeight, (s, v) => s with { AdaptiveMinHeight = v },
        "Thinnest layer of adaptive layers.");

    public static readonly ProfileKey<PrintSettings, double> AdaptiveMaxHeight = K.Number(
        "adaptive_max_height_mm", 0.001, 1000, s => s.AdaptiveMaxHeight, (s, v) => s with { AdaptiveMaxHeight = v },
        "Thickest layer of adaptive layers.");

    public static readonly ProfileKey<PrintSettings, double> AdaptiveCusp = K.Number(
        "adaptive_cusp_mm", 0.0001, 1000, s => s.AdaptiveCusp, (s, v) => s with { AdaptiveCusp = v },
        "Adaptive layers: largest distance between the steps of the layers and the surface, measured across the surface.");

    public static readonly ProfileKey<PrintSettings, double> XyCompensation = K.Number(
        "xy_compensation_mm", -100, 100, s => s.XyCompensation, (s, v) => s with { XyCompensation = v },
        "Outlines of the part are moved outwards by this much, or inwards where it is negative.");

    public static readonly ProfileKey<PrintSettings, double> HoleCompensation = K.Number(
        "hole_compensation_mm", -100, 100, s => s.HoleCompensation, (s, v) => s with { HoleCompensation = v },
        "Holes are made larger by this much on every side, or smaller where it is negative.");

    public static readonly ProfileKey<PrintSettings, double> FirstLayerCompensation = K.Number(
        "first_layer_compensation_mm", -100, 100, s => s.FirstLayerCompensation, (s, v) => s with { FirstLayerCompensation = v },
        "The outline of the first layer is moved outwards by this much, or inwards where it is negative (an elephant's foot).");

    public static readonly IReadOnlyList<ProfileKey<PrintSettings>> All =
    [
        LayerCut, LayerRanges, LayerFormula, AdaptiveLayers, AdaptiveMinHeight, AdaptiveMaxHeight, AdaptiveCusp,
        XyCompensation, HoleCompensation, FirstLayerCompensation,
    ];
}
