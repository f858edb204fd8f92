namespace Caterpillar.Machines;

/// <summary>
/// Lines of G-code with values and conditions: <c>M104 S{nozzle_temperature_c}</c>, <c>{if bed_temperature_c &gt; 0}</c> … <c>{elsif …}</c> … <c>{else}</c> …
/// <c>{endif}</c>. Braces contain a formula of <see cref="Expressions.Formula"/> with named numbers, or the name of a text. Flags are 1 and 0. Numbers are
/// written with up to five decimals. A line with only directives gives no line. <c>{{</c> and <c>}}</c> are literal braces. Immutable.
/// </summary>
internal sealed class Template(IReadOnlyList<TemplatePart> parts, TemplateNames names)
{
    private const int Decimals = 5;

    /// <summary>Reads a template. Errors have its line and column, and file and key of <paramref name="source"/>.</summary>
    public static Result<Template> Parse(IReadOnlyList<string> lines, TemplateNames names, SourceLocation source)
    {
        var parser = new TemplateParser(names, source);
        parser.Parse(lines);
        return new Result<Template>(parser.Problems.Count == 0 ? new Template(parser.Parts, names) : null, parser.Problems);
    }

    /// <summary>The lines for these values. An unknown or infinite value is an error.</summary>
    public Result<IReadOnlyList<string>> Render(TemplateValues values)
    {
        var problems = new List<Diagnostic>();
        var slots = names.Numbers.Select(n => values.Number(n) ?? double.NaN).ToArray();
        var missing = names.Numbers.Where(n => values.Number(n) is null).ToArray();
        var lines = new List<string>();
        var line = new StringBuilder();
        var directives = false;
        // For each open if: whether this branch is taken, and whether one was taken.
        var open = new Stack<(bool Now, bool Done)>();
        foreach (var part in parts)
        {
            var active = open.All(o => o.Now);
            directives |= part.IsDirective;
            switch (part.Kind)
            {
                case TemplatePartKind.If:
                    var yes = active && Evaluate(part, slots, missing, problems) != 0;
                    open.Push((yes, yes));
                    break;
                case TemplatePartKind.Elsif:
                    var (_, done) = open.Pop();
                    var now = !done && open.All(o => o.Now) && Evaluate(part, slots, missing, problems) != 0;
                    open.Push((now, done || now));
                    break;
                case TemplatePartKind.Else:
                    var before = open.Pop().Done;
                    open.Push((!before, true));
                    break;
                case TemplatePartKind.Endif:
                    open.Pop();
                    break;
                case TemplatePartKind.LineEnd:
                    var text = line.ToString();
                    // A line inside a branch that is not taken, or with only directives, is dropped.
                    if (text.Trim().Length > 0 || (!directives && active)) lines.Add(text.TrimEnd());
                    line.Clear();
                    directives = false;
                    break;
                default:
                    if (active) line.Append(Text(part, values, slots, missing, problems));
                    break;
            }
        }
        return new Result<IReadOnlyList<string>>(problems.Count == 0 ? lines : null, problems);
    }

    private static string Text(TemplatePart part, TemplateValues values, double[] slots, string[] missing, List<Diagnostic> problems) => part.Kind switch
    {
        TemplatePartKind.Text => part.Text,
        TemplatePartKind.Name => values.Text(part.Text) ?? "",
        _ => NumberFormatter.Format(Evaluate(part, slots, missing, problems), Decimals),
    };

    private static double Evaluate(TemplatePart part, double[] slots, string[] missing, List<Diagnostic> problems)
    {
        var value = part.Formula!.Evaluate(slots);
        if (missing.FirstOrDefault(n => Mentions(part.Text, n)) is { } name)
            problems.Add(new Diagnostic(Severity.Error, "template.no_value", $"{name} has no value here.", part.Place));
        else if (double.IsNaN(value) || double.IsInfinity(value))
            problems.Add(new Diagnostic(Severity.Error, "template.not_finite", $"\"{part.Text}\" is not a finite number.", part.Place));
        else
            return value;
        return 0;
    }

    private static bool Mentions(string text, string name)
    {
        for (var at = text.IndexOf(name, StringComparison.Ordinal); at >= 0; at = text.IndexOf(name, at + 1, StringComparison.Ordinal))
        {
            var before = at > 0 && IsLetter(text[at - 1]);
            var after = at + name.Length < text.Length && IsLetter(text[at + name.Length]);
            if (!before && !after) return true;
        }
        return false;
    }

    private static bool IsLetter(char c) => c == '_' || char.IsLetterOrDigit(c);
}
