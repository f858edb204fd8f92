namespace Caterpillar.Machines;

// What holds up the parts of a print that hang in the air.
public sealed partial record PrintSettings
{
    /// <summary>The kind of supports.</summary>
    public SupportKind Support { get; init; } = SupportKind.None;

    /// <summary>Whether supports may stand on the part, or on the bed only.</summary>
    public SupportPlace SupportPlace { get; init; } = SupportPlace.Everywhere;

    /// <summary>Surfaces that lean farther out than this from the vertical are supported, degrees.</summary>
    public double SupportAngle { get; init => field = SupportKeys.SupportAngle.Check(value); } = 50;

    /// <summary>Air between supports and the walls of the part, mm.</summary>
    public double SupportXyGap { get; init => field = SupportKeys.SupportXyGap.Check(value); } = 0.6;

    /// <summary>Least air between a support and the part above it, mm.</summary>
    public double SupportTopGap { get; init => field = SupportKeys.SupportTopGap.Check(value); } = 0.2;

    /// <summary>Least air between a support and the part below it, mm.</summary>
    public double SupportBottomGap { get; init => field = SupportKeys.SupportBottomGap.Check(value); } = 0.2;

    /// <summary>How much of a grid is filled, %.</summary>
    public double SupportPercent { get; init => field = SupportKeys.SupportPercent.Check(value); } = 15;

    /// <summary>Dense layers at the top of supports.</summary>
    public int SupportInterfaceLayers { get; init => field = SupportKeys.SupportInterfaceLayers.Check(value); } = 2;

    /// <summary>How much of the dense layers is filled, %.</summary>
    public double SupportInterfacePercent { get; init => field = SupportKeys.SupportInterfacePercent.Check(value); } = 75;

    /// <summary>Distance between the tips of trees, mm.</summary>
    public double SupportTipDistance { get; init => field = SupportKeys.SupportTipDistance.Check(value); } = 2.5;

    /// <summary>How far the branches of trees lean, degrees from the vertical.</summary>
    public double SupportBranchAngle { get; init => field = SupportKeys.SupportBranchAngle.Check(value); } = 40;

    /// <summary>Greatest diameter of the branches of trees, mm.</summary>
    public double SupportBranchDiameter { get; init => field = SupportKeys.SupportBranchDiameter.Check(value); } = 5;

    /// <summary>Speed of supports, mm/s; 0 for the print speed.</summary>
    public double SupportSpeed { get; init => field = SupportKeys.SupportSpeed.Check(value); }

    /// <summary>What a model is for; set for a single one of several.</summary>
    public ModelUse ModelUse { get; init; } = ModelUse.Part;
}
