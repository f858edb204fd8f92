namespace Caterpillar.GCode;

/// <summary>The state of the firmware retraction (G10, G11).</summary>
/// <param name="Lift">Height by which G10 lifts the head, mm.</param>
/// <param name="IsRetracted">True from G10 to G11.</param>
/// <param name="Lifted">Height by which the head is lifted now, mm.</param>
internal readonly record struct RetractionState(double Lift, bool IsRetracted, double Lifted);
