namespace Caterpillar.Checks;

/// <summary>Size of the G-code that was written.</summary>
/// <param name="Bytes">Size of the G-code.</param>
/// <param name="Lines">Number of its lines.</param>
/// <param name="Overridden">Number of errors that the reason overrode.</param>
/// <param name="PrintTime">Print time without start and end code, s; null if the print was not timed.</param>
public sealed record WrittenGCode(long Bytes, long Lines, int Overridden, double? PrintTime = null);
