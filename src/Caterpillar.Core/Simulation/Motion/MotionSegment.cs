namespace Caterpillar.Simulation;

/// <summary>
/// A straight move as the planner sees it: what limits it alone, and (after planning) its speeds. Squares of speeds in mm²/s², lengths in mm.
/// </summary>
internal struct MotionSegment
{
    public double Length;

    // mm/s²
    public double Acceleration;

    // Highest speed within the segment.
    public double Speed2;

    // Highest speed at its start: corner and speeds of both sides.
    public double Entry2;

    // Speed from which the machine may stand still at once, and to which it may jump from rest.
    public double Rest2;

    // How much the second, slower profile of minimum_cruise_ratio may change the square of the speed.
    public double SlowGain;

    // Results.
    public double Start2;
    public double Peak2;
    public double End2;

    // Scratch: highest start of the slower profile.
    public double Slow2;

    public readonly double Gain => 2 * Acceleration * Length;
}
