namespace Caterpillar.Machines;

/// <summary>Severities of checks: a list of texts such as <c>limit.flow=warning</c>.</summary>
internal sealed class SeverityFormat() : TextsFormat<CheckSeverity>("a list of texts such as \"limit.flow=warning\"")
{
    private const char Wrong = '!';

    public override string Range => "a list of code=off, note, warning or error";

    protected override string Pattern
        => "^(" + string.Join("|", CheckCodes.All.Select(c => string.Join("\\.", c.Code.Split('.')))) + ")=(off|note|warning|error)$";

    // What is wrong is kept for the message of Problem.
    protected override CheckSeverity Item(string text) => CheckSeverity.Parse(text, out _) ?? new CheckSeverity(Wrong + text, null);

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
