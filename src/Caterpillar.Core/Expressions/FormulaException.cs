using System;

namespace Caterpillar.Expressions;

/// <summary>Ends the reading or running of a formula or a script; the facades turn it into a diagnostic.</summary>
internal sealed class FormulaException(string code, string message, int line, int column) : Exception(message)
{
    public string Code { get; } = code;

    public int Line { get; } = line;

    public int Column { get; } = column;
}
