namespace Caterpillar.Machines;

// Layers that follow a surface.
public sealed partial record PrintSettings
{
    /// <summary>Maximum deviation of curved paths and of the deformed model.</summary> <value>mm.</value>
    public double CurvedTolerance { get; init => field = CurvedKeys.CurvedTolerance.Check(value); } = 0.01;

    /// <summary>Maximum change of the gap between curved layers along a move. Moves that exceed it are divided.</summary> <value>% of the gap.</value>
    public double CurvedGapStep { get; init => field = CurvedKeys.CurvedGapStep.Check(value); } = 10;

    /// <summary>Minimum thickness of curved layers. Thinner ones are combined; 0 = 0.15 × nozzle diameter, at most half the layer height.</summary>
    /// <value>mm.</value>
    public double CurvedMinGap { get; init => field = CurvedKeys.CurvedMinGap.Check(value); }

    /// <summary>Maximum thickness of curved layers. Thicker ones are divided; 0 = 0.75 × nozzle diameter, or the layer height if greater.</summary>
    /// <value>mm.</value>
    public double CurvedMaxGap { get; init => field = CurvedKeys.CurvedMaxGap.Check(value); }

    /// <summary>Maximum ratio of the thickest to the thinnest extrusion of curved layers. Thinner layers are combined; 0 = any.</summary>
    /// <remarks>2 or more.</remarks>
    public double CurvedMaxGapRatio { get; init => field = CurvedKeys.CurvedMaxGapRatio.Check(value); }

    /// <summary>Maximum slope of curved layers; 0 = as steep as the print head allows.</summary> <value>Degrees.</value>
    public double CurvedMaxSlope { get; init => field = CurvedKeys.CurvedMaxSlope.Check(value); }
}

/// <summary>Keys of print settings: curved layers.</summary>
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
