namespace Caterpillar.Checks;

/// <summary>What was written.</summary>
/// <param name="Bytes">Size of the G-code.</param>
/// <param name="Lines">Number of its lines.</param>
/// <param name="Overridden">Findings that would have refused it and were overridden by a reason.</param>
/// <param name="PrintTime">Seconds that the print takes without start and end code; null where it was not timed.</param>
public sealed record WrittenGCode(long Bytes, long Lines, int Overridden, double? PrintTime = null);
