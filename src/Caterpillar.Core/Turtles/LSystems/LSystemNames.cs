namespace Caterpillar.Turtles;

/// <summary>Outside variables for the formulas of an L-system, and which of them the formulas use.</summary>
internal sealed class LSystemNames(IReadOnlyList<string> names)
{
    private readonly HashSet<string> _used = new(System.StringComparer.Ordinal);

    public bool Uses(string name) => _used.Contains(name);

    /// <summary>The names of values, then the variables. Variables with the same name as a value are hidden.</summary>
    public string[] After(string[] values)
        => [.. values, .. names.Select((name, i) => values.Contains(name) ? "hidden " + Basics.NumberFormatter.Format(i) : name)];

    /// <summary>Notes the variables in a formula.</summary>
    public void Note(string formula, string[] values)
    {
        if (names.Count == 0) return;
        foreach (var token in Lexer.Read(formula))
        {
            if (token.Kind == TokenKind.Name && !values.Contains(token.Text) && names.Contains(token.Text)) _used.Add(token.Text);
        }
    }
}
