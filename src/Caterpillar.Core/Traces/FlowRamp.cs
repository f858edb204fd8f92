namespace Caterpillar.Traces;

/// <summary>
/// Increases the flow of a helix over its first turn, as the gap to the bed grows from 0. Decreases it over the last turn, so that the rim is level. Either
/// end can be omitted.
/// </summary>
/// <param name="minimum">Flow ratio at the ends, 0 to 1.</param>
/// <param name="start">True if the flow increases along the first turn.</param>
/// <param name="end">True if the flow decreases along the last turn.</param>
/// <exception cref="ArgumentOutOfRangeException">The minimum is not between 0 and 1.</exception>
public sealed class FlowRamp(double minimum = 0.2, bool start = true, bool end = true)
{
    private readonly double _minimum = minimum is >= 0 and <= 1 ? minimum
        : throw new ArgumentOutOfRangeException(nameof(minimum), "The minimum flow must be between 0 and 1.");

    /// <summary>Flow ratio after some turns, with some turns left.</summary>
    internal double At(double turnsDone, double turnsLeft) => (start ? Part(turnsDone) : 1) * (end ? Part(turnsLeft) : 1);

    private double Part(double turns) => turns < 1 ? _minimum + (1 - _minimum) * Math.Max(0, turns) : 1;
}
