namespace Caterpillar.Machines;

/// <summary>True or false.</summary>
internal sealed class BooleanFormat() : KeyFormat<bool>(KeyKind.Boolean, "true or false")
{
    public override string Range => Expected;

    public override IReadOnlyList<KeyValuePair<string, object>> Schema => [new("type", "boolean")];

    public override object? Parse(string text) => text.Trim() switch
    {
        "true" or "yes" or "on" or "1" => true,
        "false" or "no" or "off" or "0" => false,
        _ => null,
    };

    public override bool Fits(object raw) => raw is bool;

    public override bool Read(object raw) => (bool)raw;

    public override object Write(bool value) => value;

    public override string? Problem(bool value) => null;
}

/// <summary>Text on one line.</summary>
internal class TextFormat(string expected = "text") : KeyFormat<string>(KeyKind.Text, expected)
{
    public override string Range => "text on one line";

    public override IReadOnlyList<KeyValuePair<string, object>> Schema => [new("type", "string"), new("minLength", 1.0)];

    public override object? Parse(string text) => text.Trim();

    public override bool Fits(object raw) => raw is string;

    public override string Read(object raw) => (string)raw;

    public override object Write(string value) => value;

    public override string? Problem(string value)
        => value.Length == 0 ? "must not be empty" : value.IndexOfAny(['\n', '\r']) >= 0 ? "must be on one line" : null;
}

/// <summary>A formula in some variables, or empty.</summary>
internal sealed class FormulaFormat(params string[] variables) : TextFormat("a formula")
{
    public override string Range => "a formula in " + string.Join(", ", variables) + ", or empty";

    public override IReadOnlyList<KeyValuePair<string, object>> Schema => [new("type", "string")];

    public override string? Problem(string value)
    {
        if (value.Length == 0) return null;
        var formula = Formula.Compile(value, variables);
        return formula.Value is null ? "is not a valid formula: " + formula.Diagnostics[0].Message.TrimEnd('.') : null;
    }
}

/// <summary>One of several words.</summary>
internal sealed class ChoiceFormat(params (string Word, object Value)[] choices)
    : KeyFormat<object>(KeyKind.Choice, Words.Either([.. choices.Select(c => c.Word)]))
{
    public override string Range => Expected;

    public override IReadOnlyList<string> Choices => [.. choices.Select(c => c.Word)];

    public override string Hint(string word) => SpellingSuggestion.Hint(word, Choices);

    public override IReadOnlyList<KeyValuePair<string, object>> Schema => [new("enum", Choices.ToArray<object>())];

    public override object? Parse(string text) => text.Trim();

    public override bool Fits(object raw) => choices.Any(c => c.Word.Equals(raw));

    public override object Read(object raw) => choices.First(c => c.Word.Equals(raw)).Value;

    public override object Write(object value) => choices.First(c => Equals(c.Value, value)).Word;

    public override string? Problem(object value) => choices.Any(c => Equals(c.Value, value)) ? null : "must be " + Range;
}

/// <summary>Lines of a template.</summary>
internal sealed class LinesFormat(Func<ValueList<string>, Diagnostic?> check)
    : TextsFormat<string>("a list of lines", "a list of lines of text", line => line, lines => ProblemOf(lines, check))
{
    /// <summary>The code of the first error of the template, or null.</summary>
    public string? ErrorCode(object raw) => Fits(raw) ? check(Read(raw))?.Code : null;

    public override object? Parse(string text)
        => text.Length == 0 ? Array.Empty<object>() : text.Split(["\r\n", "\n", "\\n"], StringSplitOptions.None).Cast<object>().ToArray();

    private static string? ProblemOf(ValueList<string> value, Func<ValueList<string>, Diagnostic?> check)
        => value.Any(l => l is null || l.IndexOfAny(['\n', '\r']) >= 0) ? "has an entry of more than one line"
            : check(value) is { } error ? $"has an error in {error.Source}: {error.Message.TrimEnd('.')}" : null;
}
