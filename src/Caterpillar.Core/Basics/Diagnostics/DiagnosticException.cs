namespace Caterpillar.Basics;

/// <summary>Errors of a call, thrown where the caller asked for a value or an exception (<see cref="Result{T}.OrThrow"/>).</summary>
public sealed class DiagnosticException : Exception
{
    /// <summary>The message is the text of the errors among the diagnostics, one a line.</summary>
    public DiagnosticException(IReadOnlyList<Diagnostic> diagnostics)
        : base(Text(diagnostics ?? throw new ArgumentNullException(nameof(diagnostics))))
        => Diagnostics = diagnostics;

    /// <summary>All that the call had to say, warnings and notes too.</summary>
    public IReadOnlyList<Diagnostic> Diagnostics { get; }

    private static string Text(IReadOnlyList<Diagnostic> diagnostics)
    {
        var errors = diagnostics.Where(d => d.Severity == Severity.Error).ToArray();
        return errors.Length > 0 ? string.Join("\n", errors.Select(e => e.ToString())) : "There is no result.";
    }
}
