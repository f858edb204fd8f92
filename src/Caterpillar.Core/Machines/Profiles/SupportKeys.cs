using System.Collections.Generic;
using K = Caterpillar.Machines.Keys<Caterpillar.Machines.PrintSettings>;

namespace Caterpillar.Machines;

/// <summary>Keys of print settings: supports.</summary>
internal static class SupportKeys
{
    public static readonly ProfileKey<PrintSettings, SupportKind> Support = K.Choice(
        "support", s => s.Support, (s, v) => s with { Support = v },
        "What holds up parts of the print that hang in the air: nothing, columns of lines, or branches.",
        ("none", SupportKind.None), ("grid", SupportKind.Grid), ("tree", SupportKind.Tree));

    public static readonly ProfileKey<PrintSettings, SupportPlace> SupportPlace = K.Choice(
        "support_place", s => s.SupportPlace, (s, v) => s with { SupportPlace = v },
        "Supports stand on bed and part, or on the bed only.",
        ("everywhere", Machines.SupportPlace.Everywhere), ("bed", Machines.SupportPlace.Bed));

    public static readonly ProfileKey<PrintSettings, double> SupportAngle = K.Number(
        "support_angle_deg", 0, 90, s => s.SupportAngle, (s, v) => s with { SupportAngle = v },
        "Surfaces that lean farther out than this from the vertical are supported; 90 for none but those in enforcers.");

    public static readonly ProfileKey<PrintSettings, double> SupportXyGap = K.Number(
        "support_xy_gap_mm", 0.05, 100, s => s.SupportXyGap, (s, v) => s with { SupportXyGap = v },
        "Air between supports and the walls of the part.");

    public static readonly ProfileKey<PrintSettings, double> SupportTopGap = K.Number(
        "support_top_gap_mm", 0, 100, s => s.SupportTopGap, (s, v) => s with { SupportTopGap = v },
        "Least air between a support and the part above it; it is rounded up to whole layers.");

    public static readonly ProfileKey<PrintSettings, double> SupportBottomGap = K.Number(
        "support_bottom_gap_mm", 0, 100, s => s.SupportBottomGap, (s, v) => s with { SupportBottomGap = v },
        "Least air between a support and the part below it; it is rounded up to whole layers.");

    public static readonly ProfileKey<PrintSettings, double> SupportPercent = K.Number(
        "support_percent", 1, 100, s => s.SupportPercent, (s, v) => s with { SupportPercent = v },
        "How much of the columns of support grid is filled.");

    public static readonly ProfileKey<PrintSettings, int> SupportInterfaceLayers = K.Integer(
        "support_interface_layers", 0, 1000, s => s.SupportInterfaceLayers, (s, v) => s with { SupportInterfaceLayers = v },
        "Dense layers at the top of supports.");

    public static readonly ProfileKey<PrintSettings, double> SupportInterfacePercent = K.Number(
        "support_interface_percent", 1, 100, s => s.SupportInterfacePercent, (s, v) => s with { SupportInterfacePercent = v },
        "How much of the dense layers is filled.");

    public static readonly ProfileKey<PrintSettings, double> SupportTipDistance = K.Number(
        "support_tip_distance_mm", 0.2, 100, s => s.SupportTipDistance, (s, v) => s with { SupportTipDistance = v },
        "Distance between the tips of support tree.");

    public static readonly ProfileKey<PrintSettings, double> SupportBranchAngle = K.Number(
        "support_branch_angle_deg", 0, 70, s => s.SupportBranchAngle, (s, v) => s with { SupportBranchAngle = v },
        "How far the branches of support tree lean, from the vertical.");

    public static readonly ProfileKey<PrintSettings, double> SupportBranchDiameter = K.Number(
        "support_branch_diameter_mm", 0.2, 100, s => s.SupportBranchDiameter, (s, v) => s with { SupportBranchDiameter = v },
        "Greatest diameter of the branches of support tree.");

    public static readonly ProfileKey<PrintSettings, double> SupportSpeed = K.Number(
        "support_speed_mm_s", 0, 10_000, s => s.SupportSpeed, (s, v) => s with { SupportSpeed = v },
        "Speed of supports; 0 for the print speed.");

    public static readonly ProfileKey<PrintSettings, ModelUse> ModelUse = K.Choice(
        "model_use", s => s.ModelUse, (s, v) => s with { ModelUse = v },
        "What a model is for (--for MODEL:model_use=...): to be printed; or as a body in which nothing is supported, everything that is seen from below is, or "
            + "parts have its settings.",
        ("part", Machines.ModelUse.Part), ("support_blocker", Machines.ModelUse.SupportBlocker), ("support_enforcer", Machines.ModelUse.SupportEnforcer),
        ("modifier", Machines.ModelUse.Modifier));

    public static readonly IReadOnlyList<ProfileKey<PrintSettings>> All =
    [
        Support, SupportPlace, SupportAngle, SupportXyGap, SupportTopGap, SupportBottomGap, SupportPercent, SupportInterfaceLayers,
        SupportInterfacePercent, SupportTipDistance, SupportBranchAngle, SupportBranchDiameter, SupportSpeed, ModelUse,
    ];
}
