namespace Caterpillar.Machines;

// The closed layers at the top and the bottom of a part, and bridges.
public sealed partial record PrintSettings
{
    /// <summary>Number of solid top layers.</summary>
    public int TopLayers { get; init => field = TopBottomKeys.TopLayers.Check(value); } = 4;

    /// <summary>Number of solid bottom layers.</summary>
    public int BottomLayers { get; init => field = TopBottomKeys.BottomLayers.Check(value); } = 4;

    /// <summary>Minimum thickness of solid top layers. More layers are added if they are thinner.</summary> <value>mm.</value>
    public double TopThickness { get; init => field = TopBottomKeys.TopThickness.Check(value); } = 0.7;

    /// <summary>Minimum thickness of solid bottom layers. More layers are added if they are thinner.</summary> <value>mm.</value>
    public double BottomThickness { get; init => field = TopBottomKeys.BottomThickness.Check(value); } = 0.7;

    /// <summary>Pattern of top surfaces.</summary>
    public InfillPattern TopPattern { get; init => field = TopBottomKeys.TopPattern.Check(value); } = InfillPattern.Monotonic;

    /// <summary>Pattern of bottom surfaces.</summary>
    public InfillPattern BottomPattern { get; init => field = TopBottomKeys.BottomPattern.Check(value); } = InfillPattern.Monotonic;

    /// <summary>Direction of solid infill in the first layer, counterclockwise from +X. It turns by 90° each layer.</summary> <value>Degrees.</value>
    public double SolidInfillAngle { get; init => field = TopBottomKeys.SolidInfillAngle.Check(value); } = 45;

    /// <summary>Width of solid infill and bottom surfaces; 0 = line width.</summary> <value>mm.</value>
    public double SolidInfillLineWidth { get => OfNozzle(field, 0); init => field = TopBottomKeys.SolidInfillLineWidth.Check(value); }

    /// <summary>Minimum width of top and bottom surfaces. Narrower ones are left to the walls.</summary> <value>mm.</value>
    public double MinSolidWidth { get; init => field = TopBottomKeys.MinSolidWidth.Check(value); } = 0.2;

    /// <summary>Distance by which top and bottom solid layers extend into the infill, to anchor them.</summary> <value>mm.</value>
    public double SolidInfillExpansion { get; init => field = TopBottomKeys.SolidInfillExpansion.Check(value); } = 0.6;

    /// <summary>Make infill areas smaller than this solid.</summary> <value>mm².</value>
    public double SolidInfillThresholdArea { get; init => field = TopBottomKeys.SolidInfillThresholdArea.Check(value); } = 10;

    /// <summary>Fill internal solid areas narrower than this along their outline; 0 = off.</summary> <value>mm.</value>
    public double NarrowSolidInfill { get; init => field = TopBottomKeys.NarrowSolidInfill.Check(value); } = 4;

    /// <summary>Speed of top surfaces; 0 = outer wall speed.</summary> <value>mm/s.</value>
    public double TopSurfaceSpeed { get; init => field = TopBottomKeys.TopSurfaceSpeed.Check(value); }

    /// <summary>Speed of solid infill; 0 = infill speed.</summary> <value>mm/s.</value>
    public double SolidInfillSpeed { get; init => field = TopBottomKeys.SolidInfillSpeed.Check(value); }

    /// <summary>Iron top surfaces: the hot nozzle passes over them again with little flow.</summary>
    public bool Ironing { get; init; }

    /// <summary>Distance between ironing lines.</summary> <value>mm.</value>
    public double IroningSpacing { get; init => field = TopBottomKeys.IroningSpacing.Check(value); } = 0.1;

    /// <summary>Ironing flow, in % of a full layer.</summary> <value>%.</value>
    public double IroningFlowPercent { get; init => field = TopBottomKeys.IroningFlowPercent.Check(value); } = 10;

    /// <summary>Ironing speed; 0 = printing speed.</summary> <value>mm/s.</value>
    public double IroningSpeed { get; init => field = TopBottomKeys.IroningSpeed.Check(value); } = 15;

    /// <summary>Detect bridges and print them in the direction that holds best.</summary>
    public bool Bridges { get; init; } = true;

    /// <summary>Length by which bridges overlap the material that anchors them.</summary> <value>mm.</value>
    public double BridgeAnchor { get; init => field = TopBottomKeys.BridgeAnchor.Check(value); } = 1;

    /// <summary>Bridge flow ratio.</summary>
    public double BridgeFlowRatio { get; init => field = TopBottomKeys.BridgeFlowRatio.Check(value); } = 1;

    /// <summary>Bridge speed; 0 = printing speed.</summary> <value>mm/s.</value>
    public double BridgeSpeed { get; init => field = TopBottomKeys.BridgeSpeed.Check(value); } = 25;

    /// <summary>Fan speed for bridges.</summary> <value>%.</value>
    public double BridgeFanSpeedPercent { get; init => field = TopBottomKeys.BridgeFanSpeedPercent.Check(value); } = 100;

    /// <summary>Print the first solid layer over sparse infill as a bridge, across the infill lines.</summary>
    public bool InfillBridges { get; init; } = true;

    /// <summary>Flow ratio of bridges over infill.</summary>
    public double InfillBridgeFlowRatio { get; init => field = TopBottomKeys.InfillBridgeFlowRatio.Check(value); } = 1;

    /// <summary>Speed of bridges over infill; 0 = bridge speed.</summary> <value>mm/s.</value>
    public double InfillBridgeSpeed { get; init => field = TopBottomKeys.InfillBridgeSpeed.Check(value); } = 40;

    /// <summary>Flow ratio of a part, or of the region that a modifier covers.</summary>
    public double PartFlowRatio { get; init => field = TopBottomKeys.PartFlowRatio.Check(value); } = 1;

    /// <summary>Speed, fan and flow of overhanging walls: a list of [% of the width that overhangs, mm/s (0 = unchanged), fan %, flow ratio].</summary>
    public ValueList<OverhangClass> OverhangClasses { get; init => field = TopBottomKeys.OverhangClasses.Check(value); } = OverhangClass.Usual;
}

/// <summary>Keys of print settings: top and bottom layers, ironing, bridges, overhangs.</summary>
internal static class TopBottomKeys
{
    public static readonly KeyTable<PrintSettings> All = new();

    public static readonly IntegerKey TopLayers = All.Integer("top_layers", 0, 100_000, s => s.TopLayers, (s, v) => s with { TopLayers = v });
    public static readonly IntegerKey BottomLayers = All.Integer("bottom_layers", 0, 100_000, s => s.BottomLayers, (s, v) => s with { BottomLayers = v });
    public static readonly NumberKey TopThickness = All.Number("top_thickness_mm", 0, 10_000, s => s.TopThickness, (s, v) => s with { TopThickness = v });
    public static readonly NumberKey BottomThickness
        = All.Number("bottom_thickness_mm", 0, 10_000, s => s.BottomThickness, (s, v) => s with { BottomThickness = v });
    public static readonly ProfileKey<PrintSettings, InfillPattern> TopPattern
        = All.Choice("top_pattern", s => s.TopPattern, (s, v) => s with { TopPattern = v }, InfillKeys.Solid);
    public static readonly ProfileKey<PrintSettings, InfillPattern> BottomPattern
        = All.Choice("bottom_pattern", s => s.BottomPattern, (s, v) => s with { BottomPattern = v }, InfillKeys.Solid);
    public static readonly NumberKey SolidInfillAngle
        = All.Number("solid_infill_angle_deg", -360, 360, s => s.SolidInfillAngle, (s, v) => s with { SolidInfillAngle = v });
    public static readonly NumberKey SolidInfillLineWidth
        = All.NozzleSize("solid_infill_line_width_mm", s => s.SolidInfillLineWidth, (s, v) => s with { SolidInfillLineWidth = v });
    public static readonly NumberKey MinSolidWidth = All.Number("min_solid_width_mm", 0, 1000, s => s.MinSolidWidth, (s, v) => s with { MinSolidWidth = v });
    public static readonly NumberKey SolidInfillExpansion
        = All.Number("solid_infill_expansion_mm", 0, 1000, s => s.SolidInfillExpansion, (s, v) => s with { SolidInfillExpansion = v });
    public static readonly NumberKey SolidInfillThresholdArea
        = All.Number("solid_infill_threshold_area_mm2", 0, 1e9, s => s.SolidInfillThresholdArea, (s, v) => s with { SolidInfillThresholdArea = v });
    public static readonly NumberKey NarrowSolidInfill
        = All.Number("narrow_solid_infill_mm", 0, 1000, s => s.NarrowSolidInfill, (s, v) => s with { NarrowSolidInfill = v });
    public static readonly NumberKey TopSurfaceSpeed
        = All.Number("top_surface_speed_mm_s", 0, 10_000, s => s.TopSurfaceSpeed, (s, v) => s with { TopSurfaceSpeed = v });
    public static readonly NumberKey SolidInfillSpeed
        = All.Number("solid_infill_speed_mm_s", 0, 10_000, s => s.SolidInfillSpeed, (s, v) => s with { SolidInfillSpeed = v });
    public static readonly FlagKey Ironing = All.Boolean("ironing", s => s.Ironing, (s, v) => s with { Ironing = v });
    public static readonly NumberKey IroningSpacing
        = All.Number("ironing_spacing_mm", 0.01, 100, s => s.IroningSpacing, (s, v) => s with { IroningSpacing = v });
    public static readonly NumberKey IroningFlowPercent
        = All.Number("ironing_flow_percent", 0, 100, s => s.IroningFlowPercent, (s, v) => s with { IroningFlowPercent = v });
    public static readonly NumberKey IroningSpeed = All.Number("ironing_speed_mm_s", 0, 10_000, s => s.IroningSpeed, (s, v) => s with { IroningSpeed = v });
    public static readonly FlagKey Bridges = All.Boolean("bridges", s => s.Bridges, (s, v) => s with { Bridges = v });
    public static readonly NumberKey BridgeAnchor = All.Number("bridge_anchor_mm", 0, 1000, s => s.BridgeAnchor, (s, v) => s with { BridgeAnchor = v });
    public static readonly NumberKey BridgeFlowRatio
        = All.Number("bridge_flow_ratio", 0.01, 10, s => s.BridgeFlowRatio, (s, v) => s with { BridgeFlowRatio = v });
    public static readonly NumberKey BridgeSpeed = All.Number("bridge_speed_mm_s", 0, 10_000, s => s.BridgeSpeed, (s, v) => s with { BridgeSpeed = v });
    public static readonly NumberKey BridgeFanSpeedPercent
        = All.Number("bridge_fan_speed_percent", 0, 100, s => s.BridgeFanSpeedPercent, (s, v) => s with { BridgeFanSpeedPercent = v });
    public static readonly FlagKey InfillBridges = All.Boolean("infill_bridges", s => s.InfillBridges, (s, v) => s with { InfillBridges = v });
    public static readonly NumberKey InfillBridgeFlowRatio
        = All.Number("infill_bridge_flow_ratio", 0.01, 10, s => s.InfillBridgeFlowRatio, (s, v) => s with { InfillBridgeFlowRatio = v });
    public static readonly NumberKey InfillBridgeSpeed
        = All.Number("infill_bridge_speed_mm_s", 0, 10_000, s => s.InfillBridgeSpeed, (s, v) => s with { InfillBridgeSpeed = v });
    public static readonly NumberKey PartFlowRatio = All.Number("part_flow_ratio", 0.01, 10, s => s.PartFlowRatio, (s, v) => s with { PartFlowRatio = v });
    public static readonly ProfileKey<PrintSettings, ValueList<OverhangClass>> OverhangClasses = All.Of(
        "overhang_classes",
        new RowsFormat<OverhangClass>(
            ["percent", "speed", "fan", "flow"], 20, 0, 10_000, OverhangClass.Of, c => [c.Percent, c.Speed, c.MinFanSpeedPercent, c.Flow],
                OverhangClass.Problem),
        s => s.OverhangClasses, (s, v) => s with { OverhangClasses = v });
}
