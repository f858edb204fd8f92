namespace Caterpillar.Simulation;

/// <summary>What planning gives: speeds and times, and the heaters over time.</summary>
internal sealed record PlannedMotion(MotionColumns Motion, HeatModel Heat, WaitTimes Waits);

/// <summary>Seconds in which the machine waits, by cause.</summary>
/// <param name="Heating">For heat, by the model of the printer.</param>
/// <param name="Dwells">Because the program says so.</param>
/// <param name="ToolChanges">For changes of the tool.</param>
/// <param name="Homing">For homing.</param>
public readonly record struct WaitTimes(double Heating, double Dwells, double ToolChanges, double Homing)
{
    /// <summary>All waits, s.</summary>
    public double Total => Heating + Dwells + ToolChanges + Homing;
}
