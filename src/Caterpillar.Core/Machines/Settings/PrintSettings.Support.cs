namespace Caterpillar.Machines;

// What holds up the parts of a print that hang in the air.
public sealed partial record PrintSettings
{
    /// <summary>Supports: none, grid, or tree.</summary>
    public SupportKind Support { get; init; } = SupportKind.None;

    /// <summary>Supports everywhere, or on the build plate only.</summary>
    public SupportPlacement SupportPlacement { get; init; } = SupportPlacement.Everywhere;

    /// <summary>Overhang angle from the vertical above which supports are added; 90 = only in enforcers.</summary> <value>Degrees.</value>
    public double SupportAngle { get; init => field = SupportKeys.SupportAngle.Check(value); } = 50;

    /// <summary>Longest bridge without supports, held at both ends by straight lines and walls; 0 = bridges are supported.</summary> <value>mm.</value>
    public double MaxBridgeLength { get; init => field = SupportKeys.MaxBridgeLength.Check(value); } = 60;

    /// <summary>No supports below overhangs of up to 5 mm, no wider than 4 lines, that begin at the part.</summary>
    public bool SupportRemoveSmallOverhang { get; init; } = true;

    /// <summary>Horizontal gap between supports and part.</summary> <value>mm.</value>
    public double SupportXyGap { get; init => field = SupportKeys.SupportXyGap.Check(value); } = 0.6;

    /// <summary>Minimum vertical gap between a support and the part above, rounded up to whole layers.</summary> <value>mm.</value>
    public double SupportTopGap { get; init => field = SupportKeys.SupportTopGap.Check(value); } = 0.2;

    /// <summary>Minimum vertical gap between a support and the part below, rounded up to whole layers.</summary> <value>mm.</value>
    public double SupportBottomGap { get; init => field = SupportKeys.SupportBottomGap.Check(value); } = 0.2;

    /// <summary>Density of grid supports.</summary> <value>%.</value>
    public double SupportDensityPercent { get; init => field = SupportKeys.SupportDensityPercent.Check(value); } = 15;

    /// <summary>Number of interface layers at the top of supports.</summary>
    public int SupportInterfaceLayers { get; init => field = SupportKeys.SupportInterfaceLayers.Check(value); } = 2;

    /// <summary>Density of support interface layers.</summary> <value>%.</value>
    public double SupportInterfaceDensityPercent { get; init => field = SupportKeys.SupportInterfaceDensityPercent.Check(value); } = 75;

    /// <summary>Distance between the tips of tree supports.</summary> <value>mm.</value>
    public double TreeTipDistance { get; init => field = SupportKeys.TreeTipDistance.Check(value); } = 5;

    /// <summary>Maximum angle of tree branches from the vertical.</summary> <value>Degrees.</value>
    public double TreeBranchAngle { get; init => field = SupportKeys.TreeBranchAngle.Check(value); } = 40;

    /// <summary>Angle at which tree branches get thicker downwards.</summary> <value>Degrees.</value>
    public double TreeBranchDiameterAngle { get; init => field = SupportKeys.TreeBranchDiameterAngle.Check(value); } = 5;

    /// <summary>Maximum diameter of tree branches.</summary> <value>mm.</value>
    public double TreeBranchDiameter { get; init => field = SupportKeys.TreeBranchDiameter.Check(value); } = 5;

    /// <summary>Speed of supports; 0 = printing speed.</summary> <value>mm/s.</value>
    public double SupportSpeed { get; init => field = SupportKeys.SupportSpeed.Check(value); }

    /// <summary>Type of a model: part, support blocker, support enforcer, or modifier.</summary>
    public ModelType ModelType { get; init; } = ModelType.Part;
}

/// <summary>Keys of print settings: supports.</summary>
internal static class SupportKeys
{
    public static readonly KeyTable<PrintSettings> All = new();

    public static readonly ProfileKey<PrintSettings, SupportKind> Support = All.Choice("support", s => s.Support, (s, v) => s with { Support = v });
    public static readonly ProfileKey<PrintSettings, SupportPlacement> SupportPlacement
        = All.Choice("support_placement", s => s.SupportPlacement, (s, v) => s with { SupportPlacement = v });
    public static readonly NumberKey SupportAngle = All.Number("support_angle_deg", 0, 90, s => s.SupportAngle, (s, v) => s with { SupportAngle = v });
    public static readonly NumberKey MaxBridgeLength
        = All.Number("max_bridge_length_mm", 0, 1000, s => s.MaxBridgeLength, (s, v) => s with { MaxBridgeLength = v });
    public static readonly ProfileKey<PrintSettings, bool> SupportRemoveSmallOverhang
        = All.Boolean("support_remove_small_overhang", s => s.SupportRemoveSmallOverhang, (s, v) => s with { SupportRemoveSmallOverhang = v });
    public static readonly NumberKey SupportXyGap = All.Number("support_xy_gap_mm", 0.05, 100, s => s.SupportXyGap, (s, v) => s with { SupportXyGap = v });
    public static readonly NumberKey SupportTopGap = All.Number("support_top_gap_mm", 0, 100, s => s.SupportTopGap, (s, v) => s with { SupportTopGap = v });
    public static readonly NumberKey SupportBottomGap
        = All.Number("support_bottom_gap_mm", 0, 100, s => s.SupportBottomGap, (s, v) => s with { SupportBottomGap = v });
    public static readonly NumberKey SupportDensityPercent
        = All.Number("support_density_percent", 1, 100, s => s.SupportDensityPercent, (s, v) => s with { SupportDensityPercent = v });
    public static readonly IntegerKey SupportInterfaceLayers
        = All.Integer("support_interface_layers", 0, 1000, s => s.SupportInterfaceLayers, (s, v) => s with { SupportInterfaceLayers = v });
    public static readonly NumberKey SupportInterfaceDensityPercent
        = All.Number("support_interface_density_percent", 1, 100, s => s.SupportInterfaceDensityPercent, (s, v)
            => s with { SupportInterfaceDensityPercent = v });
    public static readonly NumberKey TreeTipDistance
        = All.Number("tree_tip_distance_mm", 0.2, 100, s => s.TreeTipDistance, (s, v) => s with { TreeTipDistance = v });
    public static readonly NumberKey TreeBranchAngle
        = All.Number("tree_branch_angle_deg", 0, 70, s => s.TreeBranchAngle, (s, v) => s with { TreeBranchAngle = v });
    public static readonly NumberKey TreeBranchDiameterAngle
        = All.Number("tree_branch_diameter_angle_deg", 0, 15, s => s.TreeBranchDiameterAngle, (s, v) => s with { TreeBranchDiameterAngle = v });
    public static readonly NumberKey TreeBranchDiameter
        = All.Number("tree_branch_diameter_mm", 0.2, 100, s => s.TreeBranchDiameter, (s, v) => s with { TreeBranchDiameter = v });
    public static readonly NumberKey SupportSpeed = All.Number("support_speed_mm_s", 0, 10_000, s => s.SupportSpeed, (s, v) => s with { SupportSpeed = v });
    public static readonly ProfileKey<PrintSettings, ModelType> ModelType = All.Choice("model_type", s => s.ModelType, (s, v) => s with { ModelType = v });
}
