namespace Caterpillar.Machines;

// Layers that follow a surface.
public sealed partial record PrintSettings
{
    /// <summary>Distance of printed chords from their curved path, and of the bent mesh from the exact one, mm.</summary>
    public double CurvedTolerance { get; init => field = CurvedKeys.CurvedTolerance.Check(value); } = 0.01;

    /// <summary>Change of the gap between layers along one move, beyond which the move is divided, % of the gap.</summary>
    public double CurvedGapStep { get; init => field = CurvedKeys.CurvedGapStep.Check(value); } = 10;

    /// <summary>Where curved layers are thinner than this, several are printed at once, mm; 0 for 0.15 nozzles, at most half of the layer height.</summary>
    public double CurvedMinGap { get; init => field = CurvedKeys.CurvedMinGap.Check(value); }

    /// <summary>Curved layers that are thicker than this somewhere are divided, mm; 0 for three quarters of the nozzle.</summary>
    public double CurvedMaxGap { get; init => field = CurvedKeys.CurvedMaxGap.Check(value); }

    /// <summary>How many times as high as the thinnest strand of curved layers the thickest may be, 2 or more; 0 for any.</summary>
    public double CurvedMaxGapRatio { get; init => field = CurvedKeys.CurvedMaxGapRatio.Check(value); }

    /// <summary>Steepest curved layers, degrees; 0 takes what the head of the printer allows.</summary>
    public double CurvedMaxSlope { get; init => field = CurvedKeys.CurvedMaxSlope.Check(value); }
}
