namespace Caterpillar.Traces;

/// <summary>
/// Raises the flow of a helix over its first turn, where the gap to the bed grows from nothing, and lowers it over its last, so that the rim ends level.
/// </summary>
public sealed class FlowRamp
{
    /// <summary>A ramp from <paramref name="minimum"/> (0 to 1 of the full area) at the very ends; either end can be omitted.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The minimum is not between 0 and 1.</exception>
    public FlowRamp(double minimum = 0.2, bool start = true, bool end = true)
    {
        if (!(minimum >= 0 && minimum <= 1)) throw new ArgumentOutOfRangeException(nameof(minimum), "The minimum flow must be between 0 and 1.");
        Minimum = minimum;
        Start = start;
        End = end;
    }

    /// <summary>Factor of the flow at the ends, 0 to 1.</summary>
    public double Minimum { get; }

    /// <summary>The flow grows along the first turn.</summary>
    public bool Start { get; }

    /// <summary>The flow falls along the last turn.</summary>
    public bool End { get; }

    /// <summary>Factor on the area after some turns, with some turns left to go.</summary>
    internal double At(double turnsDone, double turnsLeft)
    {
        var factor = 1.0;
        if (Start && turnsDone < 1) factor *= Minimum + (1 - Minimum) * Math.Max(0, turnsDone);
        if (End && turnsLeft < 1) factor *= Minimum + (1 - Minimum) * Math.Max(0, turnsLeft);
        return factor;
    }
}
