namespace Caterpillar.Machines;

/// <summary>
/// A name of another slicer for one of our keys, from <c>SlicerNames.tsv</c>: <c>wall_loops</c>, or several as in <c>machine_max_jerk_(x,y)</c>. Rules of
/// conversion may follow: none for the same unit, <c>*100</c>, <c>/100</c>, <c>90-</c>, words as in <c>0=none 1=grid</c>, or <c>?</c> if a value cannot be
/// converted. Some need other values of the same file: <c>%NAME</c> (percents of that one), <c>0~NAME</c> (for 0, that one counts), <c>xyze</c> (values of
/// the four axes), <c>points</c> (an outline of the bed) and <c>lines</c> (a template).
/// </summary>
internal sealed record SlicerName(ProfileKey Key, string Slicer, string Name, string Conversion)
{
    private const string Axes = "xyze", Points = "points", Template = "lines", None = "?";

    private static readonly Lazy<SlicerName[]> Table = new(Read);
    private static readonly Lazy<ILookup<string, SlicerName>> Lookup = new(() => All.ToLookup(n => n.Slicer + " " + n.Name, StringComparer.Ordinal));

    /// <summary>All names, by key and slicer.</summary>
    public static IReadOnlyList<SlicerName> All => Table.Value;

    /// <summary>True if the values are lines of a template.</summary>
    public bool IsTemplate => Conversion == Template;

    /// <summary>The names one by one: those of <c>jerk_(x,y)</c> are jerk_x and jerk_y.</summary>
    public IEnumerable<string> Names => Name.Split('(') is { Length: 2 } parts ? parts[1].TrimEnd(')').Split(',').Select(n => parts[0] + n) : [Name];

    private string[] Rules { get; } = Conversion.Split([' '], StringSplitOptions.RemoveEmptyEntries);

    /// <summary>The names that a slicer has for our keys and that are spelled like this.</summary>
    public static IEnumerable<SlicerName> Of(string slicer, string name) => Lookup.Value[slicer + " " + name];

    /// <summary>
    /// Our key for a name of other slicers, the value in our unit if it can be converted, and a sentence with both; null for all other names.
    /// </summary>
    public static (string Key, string? Value, string Sentence)? Answer(string name, object? raw)
    {
        var value = raw is IReadOnlyList<object> { Count: 1 } list ? list[0] : raw;
        var text = value switch { double number => NumberFormatter.Shortest(number), bool flag => flag ? "true" : "false", _ => value as string ?? "" };
        // A name with two meanings is the one whose value fits. If slicers differ in the unit, no value does.
        var found = All.Where(n => n.Matches(name)).GroupBy(n => n.Key)
            .Select(g => (g.Key, Slicers: string.Join(", ", g.Select(n => n.Slicer)), Values: g.Select(n => n.Convert(text.Trim())).Distinct().ToArray()))
            .OrderBy(g => g.Values.Length == 1 && g.Values[0] is not null ? 0 : 1).FirstOrDefault();
        if (found.Key is not { } key) return null;
        var ours = found.Values.Length == 1 ? found.Values[0] : null;
        var unit = KeyAdvice.Spoken(KeyAdvice.UnitOf(key.Name));
        var sentence = $"{name} ({found.Slicers}) is {key} here"
            + (ours is not null ? $": {key}={ours}." : unit.Length > 0 ? $", in {unit}."
            : key.Kind is KeyKind.Choice or KeyKind.Boolean ? $": {key.Range}." : ".");
        return (key.Name, ours, sentence);
    }

    /// <summary>The value in our unit, or null if it cannot be converted without other values or is outside the range of our key.</summary>
    public string? Convert(string text)
    {
        if (Conversion is None or Axes or Points or Template) return null;
        var word = text.ToLowerInvariant() switch { "true" => "1", "false" => "0", var other => other.Replace(' ', '_') };
        var percent = text.EndsWith("%", StringComparison.Ordinal);
        var isNumber = NumberReader.TryParse(text.TrimEnd('%', ' '), out var number) && Math.Abs(number) < 1e6;
        if (Pair(word, '=') is { } ours) text = ours;
        else if (Rules.Contains(None) || Pair(word, '~') is not null) return null;
        else if (percent) text = !isNumber ? "" : Ends("_percent") ? Text(number) : Ends("_ratio") ? Text(number / 100) : "";
        else if (Rules.Contains("90-")) text = isNumber && number > 0 ? Text(90 - number) : "";
        else if (Array.Find(Rules, r => r[0] is '*' or '/') is { } factor) text = isNumber ? Text(number * Factor(factor)) : "";
        return Key.Format.Parse(text) is { } raw && Key.Problem(raw) is null ? raw is bool flag ? flag ? "true" : "false" : text : null;
    }

    /// <summary>The value in our unit from all values of a file, or null if it has none that can be converted.</summary>
    public string? Convert(IReadOnlyDictionary<string, string> values)
    {
        if (Conversion == Axes)
        {
            var limits = Names.Select(n => FirstOf(values, n)).ToArray();
            var text = string.Join(",", limits);
            return limits.All(l => l is not null) && Key.Format.Parse(text) is { } raw && Key.Problem(raw) is null ? text : null;
        }
        if (Conversion == Points)
        {
            var height = FirstOf(values, "max_print_height") ?? FirstOf(values, "printable_height") ?? "250";
            return values.TryGetValue(Name, out var points) ? BedOutline.Read(points)?.ValueOf(Key.Name, height) : null;
        }
        return FirstOf(values, Name) is { Length: > 0 } first ? Convert(Resolved(first, values, 0)) : null;
    }

    // Follows names of other values, at most as many as any file has in a row.
    private string Resolved(string text, IReadOnlyDictionary<string, string> values, int depth)
    {
        if (depth > 5) return text;
        if (Pair(text, '~') is { } other && Of(other) is { Length: > 0 } instead) text = instead;
        if (!text.EndsWith("%", StringComparison.Ordinal) || Array.Find(Rules, r => r[0] == '%') is not { } whole) return text;
        if (!NumberReader.TryParse(text.TrimEnd('%'), out var percent) || !NumberReader.TryParse(Of(whole.Substring(1)), out var all) || all <= 0) return text;
        return Text(percent / 100 * all);

        string? Of(string name) => FirstOf(values, name) is { Length: > 0 } found
            ? SlicerName.Of(Slicer, name).FirstOrDefault()?.Resolved(found, values, depth + 1) ?? found : null;
    }

    // What follows a word, which may begin or end with a star for any text.
    private string? Pair(string word, char sign)
    {
        foreach (var rule in Rules)
        {
            var at = rule.IndexOf(sign, 0);
            if (at < 1) continue;
            var pattern = rule.Substring(0, at);
            var found = pattern[0] == '*' ? word.IndexOf(pattern.Trim('*'), StringComparison.Ordinal) >= 0 : pattern == word;
            if (found) return rule.Substring(at + 1);
        }
        return null;
    }

    private bool Ends(string unit) => Key.Name.EndsWith(unit, StringComparison.Ordinal);

    private bool Matches(string name) => Regex.IsMatch(name, "^" + Name.Replace(',', '|') + "$", RegexOptions.IgnoreCase);

    private static double Factor(string rule)
    {
        var factor = NumberReader.TryParse(rule.Substring(1), out var number) ? number : 1;
        return rule[0] == '*' ? factor : 1 / factor;
    }

    private static string Text(double number) => NumberFormatter.Format(number, 6);

    private static SlicerName[] Read()
    {
        var keys = ProfileKeys.All.Where(k => k.Name != "title").ToDictionary(k => k.Name, StringComparer.Ordinal);
        var rows = EmbeddedText.Rows("names/SlicerNames.tsv");
        return
        [
            .. from row in rows.Skip(1)
               from column in Enumerable.Range(1, row.Length - 1)
               from cell in row[column].Split([", "], StringSplitOptions.RemoveEmptyEntries)
               let words = cell.Split([' '], 2)
               select new SlicerName(keys[row[0]], rows[0][column], words[0], words.Length > 1 ? words[1] : ""),
        ];
    }

    /// <summary>The first item of a value without quotation marks, or null.</summary>
    public static string? FirstOf(IReadOnlyDictionary<string, string> values, string key)
    {
        if (!values.TryGetValue(key, out var text)) return null;
        text = text.Trim();
        if (text.Length > 1 && text[0] == '"') return text.Substring(1, (text + "\"").IndexOf('"', 1) - 1);
        var first = text.Split(',', ';')[0].Trim();
        return first == "nil" ? null : first;
    }
}
