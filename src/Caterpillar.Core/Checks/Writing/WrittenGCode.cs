namespace Caterpillar.Checks;

/// <summary>Size of the G-code that was written.</summary>
/// <param name="Bytes">Size of the G-code.</param>
/// <param name="Lines">Number of its lines.</param>
/// <param name="Overridden">Number of errors that the reason overrode.</param>
/// <param name="PrintTime">Print time with start and end code, s; null if all checks are off, so that the file is not read back.</param>
public sealed record WrittenGCode(long Bytes, long Lines, int Overridden, double? PrintTime = null)
{
    /// <summary>All moves of the file, with start and end code; null if it was not read back.</summary>
    internal Toolpath? File { get; init; }
}

/// <summary>A file that was written, read back and checked.</summary>
/// <param name="Findings">The findings; null if the text differs from the one that was checked.</param>
/// <param name="Lines">Number of lines.</param>
/// <param name="Bytes">Size.</param>
/// <param name="Read">All moves of the file and the seconds that they take; null if it was not read back.</param>
internal sealed record CheckedGCode(IReadOnlyList<Diagnostic>? Findings, long Lines, long Bytes, (Toolpath File, double Seconds)? Read);
