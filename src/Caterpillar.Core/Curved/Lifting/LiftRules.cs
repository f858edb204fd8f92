namespace Caterpillar.Curved;

/// <summary>Numbers for bringing paths back from flat layers. Lengths in mm.</summary>
/// <param name="Settings">The settings of the print.</param>
/// <param name="MinGap">Minimum gap, mm. Thinner layers are printed only every second time, or fourth, and so on. 0 = off.</param>
/// <param name="MaxSlope">Degrees; steeper pieces are reported, and left out of partial prints.</param>
/// <param name="Onto">Surface to print on. Null = extrusions keep their gap.</param>
/// <param name="Partial">Whether pieces that cannot be printed are left out.</param>
internal sealed record LiftRules(PrintSettings Settings, double MinGap, double MaxSlope, PlanSurface? Onto, bool Partial)
{
    /// <summary>Distance of chords from the curved path.</summary>
    public double Tolerance { get; } = Settings.CurvedTolerance;

    /// <summary>Change of the gap along one bead, of the gap.</summary>
    public double GapShare { get; } = Settings.CurvedGapStep / 100;

    /// <summary>Length along which one bead fills any gap, mm: within half its width, an extrusion does not follow it.</summary>
    public double GapLength { get; } = Settings.LineWidth / 2;

    /// <summary>Maximum gap above the surface to print on that extrusions fill if no part is below them, mm.</summary>
    public double MaxFill { get; init; }

    /// <summary>Height between the lowest and the highest point of a layer, at most, mm.</summary>
    public double Rise { get; init; }

    /// <summary>Radius of the tip of the nozzle and half the width of an extrusion, mm.</summary>
    public double TipReach { get; init; }

    /// <summary>True if paths may be beyond the surface that they follow, so that its edge must be found.</summary>
    public bool FindsEdge { get; init; }
}
