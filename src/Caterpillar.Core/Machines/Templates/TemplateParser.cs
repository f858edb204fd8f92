namespace Caterpillar.Machines;

/// <summary>Splits lines into text, values and directives, and checks their nesting.</summary>
internal sealed class TemplateParser(TemplateNames names, SourceLocation source)
{
    // Every part asks all the conditions around it.
    private const int MaxNesting = 100;

    private readonly List<TemplatePart> _parts = [];
    private readonly List<Diagnostic> _problems = [];

    // For each open if: its location, and whether its else has come.
    private readonly Stack<(SourceLocation Place, bool Else)> _open = new();

    private bool _tooDeep;

    public IReadOnlyList<TemplatePart> Parts => _parts;

    public IReadOnlyList<Diagnostic> Problems => _problems;

    public void Parse(IReadOnlyList<string> lines)
    {
        for (var i = 0; i < lines.Count; i++)
        {
            Line(lines[i], i + 1);
            _parts.Add(new TemplatePart(TemplatePartKind.LineEnd, "", Place(i + 1, lines[i].Length + 1)));
        }
        foreach (var (place, _) in _open.Reverse()) Problem("template.no_endif", "{if} without {endif}.", place);
    }

    private void Line(string line, int number)
    {
        var text = new StringBuilder();
        for (var at = 0; at < line.Length; at++)
        {
            var c = line[at];
            if (c is not ('{' or '}'))
            {
                text.Append(c);
                continue;
            }
            if (at + 1 < line.Length && line[at + 1] == c)
            {
                text.Append(c);
                at++;
                continue;
            }
            var end = c == '{' ? line.IndexOfAny(['}'], at) : -1;
            if (end < 0)
            {
                Problem("template.brace", c == '{' ? "Brace without a closing brace. Write {{ for a literal brace."
                    : "Closing brace without an opening brace. Write }} for a literal brace.", Place(number, at + 1));
                return;
            }
            Flush(text, number, at);
            Braces(line.Substring(at + 1, end - at - 1), Place(number, at + 2));
            at = end;
        }
        Flush(text, number, line.Length);
    }

    private void Flush(StringBuilder text, int number, int at)
    {
        if (text.Length > 0) _parts.Add(new TemplatePart(TemplatePartKind.Text, text.ToString(), Place(number, at + 1)));
        text.Clear();
    }

    private void Braces(string inside, SourceLocation place)
    {
        var trimmed = inside.Trim();
        var word = trimmed.Split([' ', '\t', '('], 2)[0];
        switch (word)
        {
            case "if":
                if (_open.Count == MaxNesting && !_tooDeep)
                    Problem("template.nesting", $"Conditions are nested more than {NumberFormatter.Format(MaxNesting)} deep.", place);
                _tooDeep |= _open.Count == MaxNesting;
                if (!_tooDeep) Condition(TemplatePartKind.If, inside, word, place);
                _open.Push((place, false));
                return;
            case "elsif" or "elseif" or "elif":
                if (_open.Count == 0) Problem("template.no_if", $"{{{word}}} without {{if}}.", place);
                else if (_open.Peek().Else) Problem("template.after_else", $"{{{word}}} after {{else}}.", place);
                Condition(TemplatePartKind.Elsif, inside, word, place);
                return;
            case "else" when trimmed == "else":
                if (_open.Count == 0) Problem("template.no_if", "{else} without {if}.", place);
                else if (_open.Peek().Else) Problem("template.after_else", "Second {else} of an {if}.", place);
                else _open.Push((_open.Pop().Place, true));
                _parts.Add(new TemplatePart(TemplatePartKind.Else, "", place));
                return;
            case "endif" when trimmed == "endif":
                if (_open.Count == 0) Problem("template.no_if", "{endif} without {if}.", place);
                else _open.Pop();
                _parts.Add(new TemplatePart(TemplatePartKind.Endif, "", place));
                return;
        }
        if (names.Texts.Contains(trimmed)) _parts.Add(new TemplatePart(TemplatePartKind.Name, trimmed, place));
        else Formula(TemplatePartKind.Value, inside, 0, place);
    }

    private void Condition(TemplatePartKind kind, string inside, string word, SourceLocation place)
        => Formula(kind, inside, inside.IndexOf(word, StringComparison.Ordinal) + word.Length, place);

    private void Formula(TemplatePartKind kind, string inside, int from, SourceLocation place)
    {
        var text = inside.Substring(from);
        if (text.Trim().Length == 0)
        {
            Problem("template.empty", kind == TemplatePartKind.Value ? "Empty braces." : "Missing condition.", place);
            return;
        }
        var formula = Expressions.Formula.Compile(text, names.Numbers, place);
        foreach (var problem in formula.Diagnostics)
        {
            var code = problem.Code == "formula.unknown" ? "template.unknown_name" : problem.Code;
            _problems.Add(problem with { Code = code, Source = place with { Column = place.Column + from + (problem.Source?.Column ?? 1) - 1 } });
        }
        if (formula.Value is { UsesRandom: true }) Problem("template.random", "Templates cannot contain random numbers.", place);
        _parts.Add(new TemplatePart(kind, text.Trim(), place, formula.Value));
    }

    private void Problem(string code, string message, SourceLocation place) => _problems.Add(new Diagnostic(Severity.Error, code, message, place));

    private SourceLocation Place(int line, int column) => source with { Line = line, Column = column };
}
