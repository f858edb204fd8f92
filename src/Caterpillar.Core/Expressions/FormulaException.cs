namespace Caterpillar.Expressions;

/// <summary>Stops the compilation or run of a formula or script. Public classes turn it into a diagnostic.</summary>
internal sealed class FormulaException(string code, string message, int line, int column) : Exception(message)
{
    public FormulaException(string code, string message, Token at) : this(code, message, at.Line, at.Column)
    {
    }

    public string Code { get; } = code;

    public int Line { get; } = line;

    public int Column { get; } = column;

    /// <summary>The included file; null = the text itself.</summary>
    public string? File { get; set; }
}
