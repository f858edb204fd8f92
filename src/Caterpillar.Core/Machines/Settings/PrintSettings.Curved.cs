using NumberKey = Caterpillar.Machines.ProfileKey<Caterpillar.Machines.PrintSettings, double>;

namespace Caterpillar.Machines;

// Layers that follow a surface.
public sealed partial record PrintSettings
{
    /// <summary>Distance of printed chords from their curved path, and of the bent model from the exact one.</summary> <value>mm.</value>
    public double CurvedTolerance { get; init => field = CurvedKeys.CurvedTolerance.Check(value); } = 0.01;

    /// <summary>Change of the gap between curved layers along one move, beyond which the move is divided.</summary> <value>% of the gap.</value>
    public double CurvedGapStep { get; init => field = CurvedKeys.CurvedGapStep.Check(value); } = 10;

    /// <summary>Where curved layers are thinner than this, several are printed at once; 0 for 0.15 nozzles, at most half of the layer height.</summary>
    /// <value>mm.</value>
    public double CurvedMinGap { get; init => field = CurvedKeys.CurvedMinGap.Check(value); }

    /// <summary>
    /// Curved layers that are thicker than this somewhere are divided; 0 for three quarters of the nozzle, or the layer height if that is more.
    /// </summary>
    /// <value>mm.</value>
    public double CurvedMaxGap { get; init => field = CurvedKeys.CurvedMaxGap.Check(value); }

    /// <summary>
    /// The thickest extrusion of curved layers is at most so many times as high as the thinnest: where layers are thinner, several are printed at once; 0 for
    /// any.
    /// </summary>
    /// <remarks>2 or more.</remarks>
    public double CurvedMaxGapRatio { get; init => field = CurvedKeys.CurvedMaxGapRatio.Check(value); }

    /// <summary>Steepest curved layers; 0 takes what the head of the printer allows.</summary> <value>Degrees.</value>
    public double CurvedMaxSlope { get; init => field = CurvedKeys.CurvedMaxSlope.Check(value); }
}

/// <summary>Keys of print settings: layers that follow a surface.</summary>
internal static class CurvedKeys
{
    public static readonly KeyTable<PrintSettings> All = new();

    public static readonly NumberKey CurvedTolerance
        = All.Number("curved_tolerance_mm", 0.0001, 10, s => s.CurvedTolerance, (s, v) => s with { CurvedTolerance = v });
    public static readonly NumberKey CurvedGapStep
        = All.Number("curved_gap_step_percent", 0.1, 100, s => s.CurvedGapStep, (s, v) => s with { CurvedGapStep = v });
    public static readonly NumberKey CurvedMinGap
        = All.NumberOrZero("curved_min_gap_mm", 0.001, 100, s => s.CurvedMinGap, (s, v) => s with { CurvedMinGap = v });
    public static readonly NumberKey CurvedMaxGap
        = All.NumberOrZero("curved_max_gap_mm", 0.001, 100, s => s.CurvedMaxGap, (s, v) => s with { CurvedMaxGap = v });
    public static readonly NumberKey CurvedMaxGapRatio
        = All.NumberOrZero("curved_max_gap_ratio", 2, 1000, s => s.CurvedMaxGapRatio, (s, v) => s with { CurvedMaxGapRatio = v });
    public static readonly NumberKey CurvedMaxSlope = All.Number("curved_max_slope_deg", 0, 89, s => s.CurvedMaxSlope, (s, v) => s with { CurvedMaxSlope = v });
}
