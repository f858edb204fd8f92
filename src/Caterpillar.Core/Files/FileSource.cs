namespace Caterpillar.Files;

/// <summary>The bytes of a file while it is read, with its name for messages, and the diagnostics.</summary>
internal abstract class FileSource(byte[] bytes, string name, DiagnosticList diagnostics, IProgress<double>? progress, CancellationToken cancel)
{
    public byte[] Bytes { get; } = bytes;

    public string Name { get; } = name;

    public DiagnosticList Diagnostics { get; } = diagnostics;

    public CancellationToken Cancel { get; } = cancel;

    /// <summary>Reports progress and stops when canceled; to be called regularly.</summary>
    public void Pulse(long done, long all)
    {
        Cancel.ThrowIfCancellationRequested();
        if (all > 0) progress?.Report(Math.Min(1, (double)done / all));
    }

    /// <summary>An error, of the whole file if it has no place. False, for the caller to return.</summary>
    public bool Fail(string code, string message, SourceLocation? place = null)
    {
        Diagnostics.Add(Severity.Error, code, message, place ?? new SourceLocation(Name));
        return false;
    }
}
