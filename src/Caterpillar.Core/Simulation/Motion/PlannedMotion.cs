namespace Caterpillar.Simulation;

/// <summary>Result of planning: speeds and times, and the heaters over time.</summary>
internal sealed record PlannedMotion(MotionColumns Motion, HeatModel Heat, WaitTimes Waits);

/// <summary>Seconds of waiting, by cause.</summary>
/// <param name="Heating">For heating, from the heating rates of the printer.</param>
/// <param name="Dwells">For dwells (G4).</param>
/// <param name="ToolChanges">For tool changes.</param>
/// <param name="Homing">For homing.</param>
public readonly record struct WaitTimes(double Heating, double Dwells, double ToolChanges, double Homing)
{
    /// <summary>All waits, s.</summary>
    public double Total => Heating + Dwells + ToolChanges + Homing;
}
