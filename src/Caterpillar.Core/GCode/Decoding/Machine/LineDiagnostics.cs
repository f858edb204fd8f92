namespace Caterpillar.GCode;

/// <summary>Diagnostics with the current line.</summary>
internal sealed class LineDiagnostics
{
    /// <summary>The current line, from 1.</summary>
    public int Line;

    public DiagnosticList List { get; } = new();

    public void Warn(string code, string message) => Add(Severity.Warning, code, message);

    public void Add(Severity severity, string code, string message) => List.Add(severity, code, message, new SourceLocation(Line: Line));
}
