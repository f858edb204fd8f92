namespace Caterpillar.Machines;

// What holds up the parts of a print that hang in the air.
public sealed partial record PrintSettings
{
    /// <summary>Supports: none, grid, or tree.</summary>
    public SupportKind Support { get; init; } = SupportKind.None;

    /// <summary>Supports everywhere, or on the build plate only.</summary>
    public SupportPlacement SupportPlacement { get; init; } = SupportPlacement.Everywhere;

    /// <summary>Overhang angle from the vertical above which supports are added; 90 = only in enforcers.</summary> <value>Degrees.</value>
    public double SupportAngle { get; init => field = Keys.Check(value); } = 50;

    /// <summary>Longest bridge without supports, held at both ends by straight lines and walls; 0 = bridges are supported.</summary> <value>mm.</value>
    public double MaxBridgeLength { get; init => field = Keys.Check(value); } = 60;

    /// <summary>No supports below overhangs of up to 5 mm, no wider than 4 lines, that begin at the part.</summary>
    public bool SupportRemoveSmallOverhang { get; init; } = true;

    /// <summary>Horizontal gap between supports and part.</summary> <value>mm.</value>
    public double SupportXyGap { get; init => field = Keys.Check(value); } = 0.6;

    /// <summary>Minimum vertical gap between a support and the part above, rounded up to whole layers.</summary> <value>mm.</value>
    public double SupportTopGap { get; init => field = Keys.Check(value); } = 0.2;

    /// <summary>Minimum vertical gap between a support and the part below, rounded up to whole layers.</summary> <value>mm.</value>
    public double SupportBottomGap { get; init => field = Keys.Check(value); } = 0.2;

    /// <summary>Density of grid supports.</summary> <value>%.</value>
    public double SupportDensityPercent { get; init => field = Keys.Check(value); } = 15;

    /// <summary>Number of interface layers at the top of supports.</summary>
    public int SupportInterfaceLayers { get; init => field = Keys.Check(value); } = 2;

    /// <summary>Density of support interface layers.</summary> <value>%.</value>
    public double SupportInterfaceDensityPercent { get; init => field = Keys.Check(value); } = 75;

    /// <summary>Distance between the tips of tree supports.</summary> <value>mm.</value>
    public double TreeTipDistance { get; init => field = Keys.Check(value); } = 5;

    /// <summary>Maximum angle of tree branches from the vertical.</summary> <value>Degrees.</value>
    public double TreeBranchAngle { get; init => field = Keys.Check(value); } = 40;

    /// <summary>Angle at which tree branches get thicker downwards.</summary> <value>Degrees.</value>
    public double TreeBranchDiameterAngle { get; init => field = Keys.Check(value); } = 5;

    /// <summary>Maximum diameter of tree branches.</summary> <value>mm.</value>
    public double TreeBranchDiameter { get; init => field = Keys.Check(value); } = 5;

    /// <summary>Speed of supports; 0 = printing speed.</summary> <value>mm/s.</value>
    public double SupportSpeed { get; init => field = Keys.Check(value); }

    /// <summary>Type of a model: part, support blocker, support enforcer, or modifier.</summary>
    public ModelType ModelType { get; init; } = ModelType.Part;
}
