namespace Caterpillar.Simulation;

/// <summary>What planning gives: speeds and times, and the heaters over time.</summary>
internal sealed record PlannedMotion(MotionColumns Motion, HeatModel Heat, WaitTimes Waits);
