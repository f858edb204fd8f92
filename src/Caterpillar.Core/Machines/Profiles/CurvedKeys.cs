using System.Collections.Generic;
using K = Caterpillar.Machines.Keys<Caterpillar.Machines.PrintSettings>;

namespace Caterpillar.Machines;

/// <summary>Keys of print settings: layers that follow a surface.</summary>
internal static class CurvedKeys
{
    public static readonly ProfileKey<PrintSettings, double> CurvedTolerance = K.Number(
        "curved_tolerance_mm", 0.0001, 10, s => s.CurvedTolerance, (s, v) => s with { CurvedTolerance = v },
        "Distance of printed chords from their curved path, and of the bent model from the exact one.");

    public static readonly ProfileKey<PrintSettings, double> CurvedGapStep = K.Number(
        "curved_gap_step_percent", 0.1, 100, s => s.CurvedGapStep, (s, v) => s with { CurvedGapStep = v },
        "Change of the gap between curved layers along one move, beyond which the move is divided.");

    public static readonly ProfileKey<PrintSettings, double> CurvedMinGap = K.NumberOrZero(
        "curved_min_gap_mm", 0.001, 100, s => s.CurvedMinGap, (s, v) => s with { CurvedMinGap = v },
        "Where curved layers are thinner than this, several are printed at once; 0 for 0.15 nozzles, at most half of the layer height.");

    public static readonly ProfileKey<PrintSettings, double> CurvedMaxGap = K.NumberOrZero(
        "curved_max_gap_mm", 0.001, 100, s => s.CurvedMaxGap, (s, v) => s with { CurvedMaxGap = v },
        "Curved layers that are thicker than this somewhere are divided; 0 for three quarters of the nozzle, or the layer height if that is more.");

    public static readonly ProfileKey<PrintSettings, double> CurvedMaxGapRatio = K.NumberOrZero(
        "curved_max_gap_ratio", 2, 1000, s => s.CurvedMaxGapRatio, (s, v) => s with { CurvedMaxGapRatio = v },
        "The thickest strand of curved layers is at most so many times as high as the thinnest: where layers are thinner, several are printed at once; 0 for "
        + "any.");

    public static readonly ProfileKey<PrintSettings, double> CurvedMaxSlope = K.Number(
        "curved_max_slope_deg", 0, 89, s => s.CurvedMaxSlope, (s, v) => s with { CurvedMaxSlope = v },
        "Steepest curved layers; 0 takes what the head of the printer allows.");

    public static readonly IReadOnlyList<ProfileKey<PrintSettings>> All =
    [
        CurvedTolerance, CurvedGapStep, CurvedMinGap, CurvedMaxGap, CurvedMaxGapRatio, CurvedMaxSlope,
    ];
}
