using Caterpillar.Machines;

namespace Caterpillar.Curved;

/// <summary>Numbers for bringing paths back from flat layers. Lengths in mm.</summary>
/// <param name="Settings">The settings of the print.</param>
/// <param name="MinGap">Thinner extrusions are printed only every second layer, or fourth, and so on; 0 for none.</param>
/// <param name="MaxSlope">Degrees; steeper pieces are reported, and left out of partial prints.</param>
/// <param name="Onto">What is printed on; null where extrusions keep their gap.</param>
/// <param name="Partial">Whether pieces that cannot be printed are left out.</param>
internal sealed record LiftRules(PrintSettings Settings, double MinGap, double MaxSlope, PlanSurface? Onto, bool Partial)
{
    /// <summary>Distance of chords from the curved path.</summary>
    public double Tolerance { get; } = Settings.CurvedTolerance;

    /// <summary>Change of the gap along one bead, of the gap.</summary>
    public double GapShare { get; } = Settings.CurvedGapStep / 100;

    /// <summary>Extrusions with nothing of the part below them fill up to so much above what is printed on, mm.</summary>
    public double MaxFill { get; init; }

    /// <summary>Whether paths may lie beyond the surface that they follow, so that its edge has to be found.</summary>
    public bool FindsEdge { get; init; }
}
