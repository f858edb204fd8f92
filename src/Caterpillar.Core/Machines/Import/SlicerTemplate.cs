namespace Caterpillar.Machines;

/// <summary>
/// Turns G-code templates of other slicers into ours: <c>[name]</c> and <c>{formula}</c> with names of <c>SlicerPlaceholders.tsv</c>, keys with a name here,
/// and values of the file itself. What has no equal becomes a comment, and an unknown condition is false; both give a warning with the line.
/// </summary>
/// <param name="values">Values of the file.</param>
/// <param name="file">Its name, for messages.</param>
/// <param name="report">Gets the warnings.</param>
internal sealed class SlicerTemplate(IReadOnlyDictionary<string, string> values, string file, Action<Diagnostic> report)
{
    private const string Index = @"(?:\[[^\]]*\])?";

    private static readonly Regex Braces = new(@"\{[^{}]*\}|\[[A-Za-z_]\w*\]");
    private static readonly Regex Directive = new(@"^\{\s*(if|elsif|else|endif)\b\s*(.*)\}$", RegexOptions.Singleline);
    private static readonly Regex Matched = new($@"(\w+){Index}\s*(=~|!~)\s*/((?:\\.|[^/\\])*)/");
    private static readonly Regex Compared = new($@"(\w+){Index}\s*(==|!=|<>)\s*""([^""]*)""");
    private static readonly Regex IsNil = new($@"is_nil\s*\(\s*(\w+){Index}\s*\)");
    private static readonly Regex Named = new($@"\b([A-Za-z_]\w*)(\[[^\]]*\])?");
    private static readonly Lazy<Dictionary<string, string>> Placeholders
        = new(() => EmbeddedText.Rows("names/SlicerPlaceholders.tsv").Skip(1).ToDictionary(r => r[0], r => r[1]));

    /// <summary>True once a line became a comment.</summary>
    public bool HasLost { get; private set; }

    /// <summary>The lines of a template of theirs for a key of ours.</summary>
    public IReadOnlyList<string> Lines(string theirs, ProfileKey ours)
    {
        if (!values.TryGetValue(theirs, out var text) || text.Trim().Length == 0) return [];
        if (text[0] == '"') text = text.Substring(1, text.Length - (text[text.Length - 1] == '"' && text.Length > 1 ? 2 : 1));
        if (text.IndexOf('\n', 0) < 0) text = Regex.Replace(text, @"\\(.)", m => m.Groups[1].Value switch { "n" => "\n", "r" => "", "t" => "\t", var c => c });
        var lines = text.TrimEnd().Split('\n');
        return [.. lines.Select((line, i) => Line(line.TrimEnd(), ours, new SourceLocation(file, Key: $"{theirs} line {NumberFormatter.Format(i + 1)}")))];
    }

    /// <summary>A line of a template of theirs for a key of ours.</summary>
    public string Line(string line, ProfileKey ours, SourceLocation place)
    {
        var parts = new List<(string Text, bool IsDirective)>();
        var lost = "";
        var at = 0;
        var comment = line.IndexOf(';', 0);
        foreach (Match match in Braces.Matches(line))
        {
            Plain(line.Substring(at, match.Index - at), at);
            at = match.Index + match.Length;
            if (match.Value[0] == '{' && Directive.Match(match.Value) is { Success: true } directive)
            {
                var (word, condition) = (directive.Groups[1].Value, directive.Groups[2].Value.Trim());
                var hasCondition = word is "if" or "elsif";
                var formula = hasCondition ? Formula(condition, ours) : "";
                if (formula is null) Warn($"The condition \"{condition}\" has no equal here and counts as false.");
                parts.Add(("{" + word + (hasCondition ? " " + (formula ?? "0") : "") + "}", true));
            }
            else if (Value(match.Value.Substring(1, match.Length - 2), ours) is { } value)
            {
                parts.Add((value, false));
            }
            else
            {
                Plain(match.Value, match.Index);
            }
        }
        Plain(line.Substring(at), at);
        if (lost.Length > 0) Warn($"{lost} has no equal here. The line is kept as a comment.");
        HasLost |= lost.Length > 0;
        var after = true;
        return string.Concat(parts.Select(part =>
        {
            var begins = after && !part.IsDirective && lost.Length > 0 && part.Text.Trim().Length > 0;
            after = part.IsDirective || (after && !begins);
            return begins ? "; " + part.Text : part.Text;
        }));

        void Plain(string text, int from)
        {
            if (text.Length > 0) parts.Add((Words.Replaced(Words.Replaced(text, "{", "{{"), "}", "}}"), false));
            var brace = text.IndexOfAny(['{', '}']);
            if (text.Length > 0 && text[0] == '[') brace = 0;
            if (lost.Length == 0 && brace >= 0 && (comment < 0 || from + brace < comment)) lost = text.Trim();
        }

        void Warn(string message) => report(new Diagnostic(Severity.Warning, "import.template", message, place));
    }

    // A name of a text gives the text. Formats as in {x:.2f} are left out: templates format numbers themselves.
    private string? Value(string inside, ProfileKey ours)
    {
        inside = Regex.Replace(Regex.Replace(inside.Trim(), @"^(\w+)[:!][^?]*$", "$1"), @"_(\d)$", "[$1]");
        if (Formula(inside, ours) is { } formula) return "{" + formula + "}";
        return Named.Match(inside) is { Success: true } name && name.Length == inside.Length && SlicerName.FirstOf(values, name.Groups[1].Value) is { } text
            && text.IndexOfAny(['{', '}']) < 0 ? text : null;
    }

    private string? Formula(string text, ProfileKey ours)
    {
        try
        {
            text = Matched.Replace(text, m => Flag(m.Groups[2].Value == "=~" == new Regex("^(?:" + m.Groups[3].Value + ")$", RegexOptions.Singleline,
                TimeSpan.FromSeconds(1)).IsMatch(Whole(m.Groups[1].Value))));
        }
        catch (Exception wrong) when (wrong is ArgumentException or RegexMatchTimeoutException)
        {
            return null;
        }
        text = Compared.Replace(text, m => Flag(m.Groups[2].Value == "==" == (Text(m.Groups[1].Value) == m.Groups[3].Value)));
        text = IsNil.Replace(text, m => Flag(SlicerName.FirstOf(values, m.Groups[1].Value) is null or ""));
        text = Named.Replace(text, m => Name(m.Groups[1].Value, m.Groups[2].Value, ours));
        return PrintTemplate.Error(["{if " + text + "}", "{endif}"]) is null ? text : null;

        string Whole(string name) => values.TryGetValue(name, out var whole) ? Words.Replaced(whole.Trim('"'), "\\n", "\n") : "";
        string Text(string name) => SlicerName.FirstOf(values, name) ?? "";
        string Flag(bool yes) => yes ? "1" : "0";
    }

    // Indices choose a tool, or a coordinate as in print_bed_max[1]. Names that only templates of layers and tools know mean the end or the first tool
    // elsewhere.
    private string Name(string name, string index, ProfileKey ours)
    {
        var tool = index.Trim('[', ']');
        var isFirst = tool is "" or "0" || tool.IndexOf("tool", StringComparison.Ordinal) >= 0 || tool.IndexOf("extruder", StringComparison.Ordinal) >= 0;
        if (Placeholders.Value.TryGetValue(name + index, out var found) || (isFirst && Placeholders.Value.TryGetValue(name, out found)))
        {
            if (ours.Name != "layer_change_gcode") found = found switch { "layer_z_mm" => "print_max_z_mm", "layer" => "layer_count", _ => found };
            return ours.Name != "tool_change_gcode" && found is "tool" or "previous_tool" ? "0" : found;
        }
        if (!isFirst) return name + index;
        var known = SlicerName.All.FirstOrDefault(n => n.Name == name && n.Conversion.Length == 0 && n.Key.Kind is KeyKind.Number or KeyKind.Integer);
        if (known is not null && values.ContainsKey(name)) return known.Key.Name;
        return NumberReader.TryParse(SlicerName.FirstOf(values, name), out var number) ? NumberFormatter.Format(number, 6) : name + index;
    }
}
