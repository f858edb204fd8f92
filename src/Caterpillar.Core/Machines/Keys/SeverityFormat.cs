namespace Caterpillar.Machines;

/// <summary>Severities of checks: a list of texts such as <c>limit.flow=warning</c>.</summary>
internal sealed class SeverityFormat() : KeyFormat<ValueList<CheckSeverity>>(KeyKind.Lines, "a list of texts such as \"limit.flow=warning\"")
{
    private const char Wrong = '!';

    public override string Range => "a list of code=off, note, warning or error";

    public override IReadOnlyList<KeyValuePair<string, object>> Schema =>
    [
        new("type", "array"),
        new("items", new KeyValuePair<string, object>[]
        {
            new("type", "string"),
            new("pattern", "^(" + string.Join("|", CheckCodes.All.Select(c => string.Join("\\.", c.Code.Split('.')))) + ")=(off|note|warning|error)$"),
        }),
    ];

    public override object? Parse(string text)
        => text.Trim().Length == 0 ? Array.Empty<object>() : text.Split(',', '\n').Select(t => (object)t.Trim()).ToArray();

    public override bool TryRead(object raw, out ValueList<CheckSeverity>? value)
    {
        value = null;
        if (raw is not IReadOnlyList<object> list || !list.All(i => i is string)) return false;
        var items = new List<CheckSeverity>();
        foreach (string text in list)
        {
            // What is wrong is kept for the message of Problem.
            items.Add(CheckSeverity.Parse(text, out _) ?? new CheckSeverity(Wrong + text, null));
        }
        value = new ValueList<CheckSeverity>(items);
        return true;
    }

    public override object Write(ValueList<CheckSeverity> value) => value.Select(v => (object)v.ToString()).ToArray();

    public override string? Problem(ValueList<CheckSeverity> value)
    {
        foreach (var item in value)
        {
            if (CheckCodes.Find(item.Code) is not null) continue;
            CheckSeverity.Parse(item.Code.TrimStart(Wrong), out var problem);
            return problem ?? $"has \"{item.Code}\", which is not the code of a check";
        }
        return null;
    }
}
