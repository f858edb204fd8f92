using System.Collections.Generic;
using Caterpillar.Expressions;

namespace Caterpillar.Machines;

/// <summary>A formula in some variables, or nothing.</summary>
internal sealed class FormulaFormat(string[] variables) : KeyFormat<string>
{
    public override KeyKind Kind => KeyKind.Text;

    public override string Expected => "a formula";

    public override string Range => "a formula in " + string.Join(", ", variables) + ", or empty";

    public override IReadOnlyList<KeyValuePair<string, object>> Schema => [new("type", "string")];

    public override object? Parse(string text) => text.Trim();

    public override bool TryRead(object raw, out string? value)
    {
        value = raw as string;
        return value is not null;
    }

    public override object Write(string value) => value;

    public override string? Problem(string value)
    {
        if (value.Length == 0) return null;
        var formula = Formula.Compile(value, variables);
        return formula.Value is null ? "is no formula: " + formula.Diagnostics[0].Message.TrimEnd('.') : null;
    }
}
