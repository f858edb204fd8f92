namespace Caterpillar.Basics;

/// <summary>A value or null, and the diagnostics. Without a value, at least one diagnostic is an error.</summary>
public sealed class Result<T>
    where T : class
{
    /// <summary>The value, or null if errors prevented one.</summary>
    public T? Value { get; }

    /// <summary>The diagnostics, one entry per kind, in the order of first appearance.</summary>
    public IReadOnlyList<Diagnostic> Diagnostics { get; }

    /// <summary>A value or null, and diagnostics.</summary>
    public Result(T? value, IReadOnlyList<Diagnostic> diagnostics)
    {
        Value = value;
        Diagnostics = diagnostics ?? throw new ArgumentNullException(nameof(diagnostics));
    }

    /// <summary>No value, because of an error.</summary>
    internal Result(string code, string message, SourceLocation? place = null)
        : this(null, [new Diagnostic(Severity.Error, code, message, place)])
    {
    }

    /// <summary>True if a diagnostic is an error.</summary>
    public bool HasErrors => Diagnostics.Any(d => d.Severity == Severity.Error);

    /// <summary>The value, or an exception if the diagnostics contain errors. Warnings and notes do not throw.</summary>
    /// <exception cref="DiagnosticException">The value is missing, or the diagnostics contain an error.</exception>
    public T OrThrow() => Value is { } value && !HasErrors ? value : throw new DiagnosticException(Diagnostics);
}
