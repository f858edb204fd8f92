namespace Caterpillar.Traces;

/// <summary>
/// Increases the flow of a helix over its first turn, as the gap to the bed grows from 0. Decreases it over the last turn, so that the rim is level.
/// </summary>
public sealed class FlowRamp
{
    /// <summary>A ramp with <paramref name="minimum"/> (0 to 1 of the full area) at its ends. Either end can be omitted.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The minimum is not between 0 and 1.</exception>
    public FlowRamp(double minimum = 0.2, bool start = true, bool end = true)
    {
        if (!(minimum >= 0 && minimum <= 1)) throw new ArgumentOutOfRangeException(nameof(minimum), "The minimum flow must be between 0 and 1.");
        Minimum = minimum;
        Start = start;
        End = end;
    }

    /// <summary>Flow ratio at the ends, 0 to 1.</summary>
    public double Minimum { get; }

    /// <summary>True if the flow increases along the first turn.</summary>
    public bool Start { get; }

    /// <summary>True if the flow decreases along the last turn.</summary>
    public bool End { get; }

    /// <summary>Flow ratio after some turns, with some turns left.</summary>
    internal double At(double turnsDone, double turnsLeft)
    {
        var factor = 1.0;
        if (Start && turnsDone < 1) factor *= Minimum + (1 - Minimum) * Math.Max(0, turnsDone);
        if (End && turnsLeft < 1) factor *= Minimum + (1 - Minimum) * Math.Max(0, turnsLeft);
        return factor;
    }
}
