using System.Collections.Generic;
using K = Caterpillar.Machines.Keys<Caterpillar.Machines.PrintSettings>;

namespace Caterpillar.Machines;

/// <summary>Keys of print settings: the closed layers at the top and the bottom of a part, and bridges.</summary>
internal static class SkinKeys
{
    public static readonly ProfileKey<PrintSettings, int> TopLayers = K.Integer(
        "top_layers", 0, 100_000, s => s.TopLayers, (s, v) => s with { TopLayers = v },
        "Closed layers below every surface that is seen from above.");

    public static readonly ProfileKey<PrintSettings, int> BottomLayers = K.Integer(
        "bottom_layers", 0, 100_000, s => s.BottomLayers, (s, v) => s with { BottomLayers = v },
        "Closed layers above every surface that is seen from below.");

    public static readonly ProfileKey<PrintSettings, double> TopThickness = K.Number(
        "top_thickness_mm", 0, 10_000, s => s.TopThickness, (s, v) => s with { TopThickness = v },
        "Least thickness of the closed layers at the top; more layers are closed where they are thin.");

    public static readonly ProfileKey<PrintSettings, double> BottomThickness = K.Number(
        "bottom_thickness_mm", 0, 10_000, s => s.BottomThickness, (s, v) => s with { BottomThickness = v },
        "Least thickness of the closed layers at the bottom; more layers are closed where they are thin.");

    public static readonly ProfileKey<PrintSettings, InfillPattern> TopPattern = K.Choice(
        "top_pattern", s => s.TopPattern, (s, v) => s with { TopPattern = v },
        "Lines of the surfaces seen from above.", InfillKeys.SolidPatterns);

    public static readonly ProfileKey<PrintSettings, InfillPattern> BottomPattern = K.Choice(
        "bottom_pattern", s => s.BottomPattern, (s, v) => s with { BottomPattern = v },
        "Lines of the surfaces seen from below.", InfillKeys.SolidPatterns);

    public static readonly ProfileKey<PrintSettings, double> SkinAngle = K.Number(
        "skin_angle_deg", -360, 360, s => s.SkinAngle, (s, v) => s with { SkinAngle = v },
        "Direction of the skins in the first layer, from +X; it turns by a quarter from layer to layer.");

    public static readonly ProfileKey<PrintSettings, double> SkinWidth = K.NumberOrZero(
        "skin_line_width_mm", 0.01, 1000, s => s.SkinWidth, (s, v) => s with { SkinWidth = v },
        "Width of the strands of the skins; 0 for the line width.");

    public static readonly ProfileKey<PrintSettings, double> SkinMinWidth = K.Number(
        "skin_min_width_mm", 0, 1000, s => s.SkinMinWidth, (s, v) => s with { SkinMinWidth = v },
        "Skins narrower than this are left to the walls.");

    public static readonly ProfileKey<PrintSettings, double> SkinExpand = K.Number(
        "skin_expand_mm", 0, 1000, s => s.SkinExpand, (s, v) => s with { SkinExpand = v },
        "How far skins reach into the infill, which holds them there.");

    public static readonly ProfileKey<PrintSettings, double> SolidBelow = K.Number(
        "solid_below_area_mm2", 0, 1e9, s => s.SolidBelow, (s, v) => s with { SolidBelow = v },
        "Pieces of infill smaller than this area are made solid.");

    public static readonly ProfileKey<PrintSettings, double> NarrowSolid = K.Number(
        "narrow_solid_mm", 0, 1000, s => s.NarrowSolid, (s, v) => s with { NarrowSolid = v },
        "Closed areas inside that are narrower than this are filled along their outline, which is quicker; 0 for lines everywhere.");

    public static readonly ProfileKey<PrintSettings, double> TopSkinSpeed = K.Number(
        "top_skin_speed_mm_s", 0, 10_000, s => s.TopSkinSpeed, (s, v) => s with { TopSkinSpeed = v },
        "Speed of the surfaces seen from above; 0 for the speed of outer walls.");

    public static readonly ProfileKey<PrintSettings, double> SolidInfillSpeed = K.Number(
        "solid_infill_speed_mm_s", 0, 10_000, s => s.SolidInfillSpeed, (s, v) => s with { SolidInfillSpeed = v },
        "Speed of the other closed layers; 0 for the speed of the infill.");

    public static readonly ProfileKey<PrintSettings, bool> Ironing = K.Boolean(
        "ironing", s => s.Ironing, (s, v) => s with { Ironing = v },
        "The hot nozzle goes over surfaces seen from above once more, with little material, and smooths them.");

    public static readonly ProfileKey<PrintSettings, double> IroningSpacing = K.Number(
        "ironing_spacing_mm", 0.01, 100, s => s.IroningSpacing, (s, v) => s with { IroningSpacing = v },
        "Distance between the lines of ironing.");

    public static readonly ProfileKey<PrintSettings, double> IroningFlowPercent = K.Number(
        "ironing_flow_percent", 0, 100, s => s.IroningFlowPercent, (s, v) => s with { IroningFlowPercent = v },
        "Material of ironing, of what would fill its layer.");

    public static readonly ProfileKey<PrintSettings, double> IroningSpeed = K.Number(
        "ironing_speed_mm_s", 0, 10_000, s => s.IroningSpeed, (s, v) => s with { IroningSpeed = v },
        "Speed of ironing; 0 for the print speed.");

    public static readonly ProfileKey<PrintSettings, bool> Bridges = K.Boolean(
        "bridges", s => s.Bridges, (s, v) => s with { Bridges = v },
        "Skins over air are spanned in the direction in which they are held best.");

    public static readonly ProfileKey<PrintSettings, double> BridgeAnchor = K.Number(
        "bridge_anchor_mm", 0, 1000, s => s.BridgeAnchor, (s, v) => s with { BridgeAnchor = v },
        "How far a bridge lies on what holds it.");

    public static readonly ProfileKey<PrintSettings, double> BridgeFlow = K.Number(
        "bridge_flow", 0.01, 10, s => s.BridgeFlow, (s, v) => s with { BridgeFlow = v },
        "Material of bridges, of that of the other strands.");

    public static readonly ProfileKey<PrintSettings, double> BridgeSpeed = K.Number(
        "bridge_speed_mm_s", 0, 10_000, s => s.BridgeSpeed, (s, v) => s with { BridgeSpeed = v },
        "Speed of bridges; 0 for the print speed.");

    public static readonly ProfileKey<PrintSettings, double> BridgeFanPercent = K.Number(
        "bridge_fan_percent", 0, 100, s => s.BridgeFanPercent, (s, v) => s with { BridgeFanPercent = v },
        "Fan while a bridge is printed.");

    public static readonly ProfileKey<PrintSettings, bool> InfillBridges = K.Boolean(
        "infill_bridges", s => s.InfillBridges, (s, v) => s with { InfillBridges = v },
        "The first closed layer over sparse infill is printed across its lines, as bridges are.");

    public static readonly ProfileKey<PrintSettings, double> InfillBridgeFlow = K.Number(
        "infill_bridge_flow", 0.01, 10, s => s.InfillBridgeFlow, (s, v) => s with { InfillBridgeFlow = v },
        "Material of bridges over infill, of that of the other strands.");

    public static readonly ProfileKey<PrintSettings, double> InfillBridgeSpeed = K.Number(
        "infill_bridge_speed_mm_s", 0, 10_000, s => s.InfillBridgeSpeed, (s, v) => s with { InfillBridgeSpeed = v },
        "Speed of bridges over infill; 0 for the speed of bridges.");

    public static readonly ProfileKey<PrintSettings, double> PartFlow = K.Number(
        "part_flow", 0.01, 10, s => s.PartFlow, (s, v) => s with { PartFlow = v },
        "Material of all strands of a part or of what a modifier covers, of the usual.");

    public static readonly ProfileKey<PrintSettings, ValueList<OverhangClass>> OverhangClasses = new(
        "overhang_classes",
        new RowsFormat<OverhangClass>(
            ["percent", "speed", "fan", "flow"], 0, 20, 0, 10_000, OverhangClass.Of, c => [c.Percent, c.Speed, c.FanPercent, c.Flow], OverhangClass.Problem),
        s => s.OverhangClasses, (s, v) => s with { OverhangClasses = v },
        "Walls over air, classed by the percentage of their width that hangs over: a list of [percent, mm/s (0 as usual), fan percent, flow factor].");

    public static readonly IReadOnlyList<ProfileKey<PrintSettings>> All =
    [
        TopLayers, BottomLayers, TopThickness, BottomThickness, TopPattern, BottomPattern, SkinAngle, SkinWidth,
        SkinMinWidth, SkinExpand, SolidBelow, NarrowSolid, TopSkinSpeed, SolidInfillSpeed, Ironing, IroningSpacing,
        IroningFlowPercent, IroningSpeed, Bridges, BridgeAnchor, BridgeFlow, BridgeSpeed, BridgeFanPercent,
        InfillBridges, InfillBridgeFlow, InfillBridgeSpeed, PartFlow, OverhangClasses,
    ];
}
