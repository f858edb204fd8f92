namespace Caterpillar.Basics;

/// <summary>Errors of a call as an exception (<see cref="Result{T}.OrThrow"/>).</summary>
public sealed class DiagnosticException : Exception
{
    /// <summary>The message contains the errors of the diagnostics, one per line.</summary>
    public DiagnosticException(IReadOnlyList<Diagnostic> diagnostics)
        : base(Text(diagnostics ?? throw new ArgumentNullException(nameof(diagnostics))))
        => Diagnostics = diagnostics;

    /// <summary>All diagnostics of the call, including warnings and notes.</summary>
    public IReadOnlyList<Diagnostic> Diagnostics { get; }

    private static string Text(IReadOnlyList<Diagnostic> diagnostics)
    {
        var errors = diagnostics.Where(d => d.Severity == Severity.Error).ToArray();
        return errors.Length > 0 ? string.Join("\n", errors.Select(e => e.ToString())) : "No result.";
    }
}
