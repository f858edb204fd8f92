namespace Caterpillar.Flavors;

/// <summary>The rules in the file of a flavor. A rule that it does not name has its usual value.</summary>
internal static class RuleWords
{
    /// <summary>The file of a flavor, after that of the one it is like.</summary>
    public static Dictionary<string, string> Of(string flavor)
    {
        var rows = EmbeddedText.Rows("firmware/" + flavor + ".tsv");
        var words = rows[0][0] == "Like" ? Of(rows[0][1]) : new Dictionary<string, string>(StringComparer.Ordinal);
        foreach (var row in rows) words[row[0]] = row[1];
        words[nameof(FlavorRules.Name)] = flavor;
        return words;
    }

    public static string Text(this IReadOnlyDictionary<string, string> words, string rule, string usual = "")
        => !(words ?? throw new ArgumentNullException(nameof(words))).TryGetValue(rule, out var value) ? usual : value == "-" ? "" : value;

    public static IReadOnlyList<string> List(this IReadOnlyDictionary<string, string> words, string rule, string usual = "")
        => words.Text(rule, usual).Split([", "], StringSplitOptions.RemoveEmptyEntries);

    public static bool Is(this IReadOnlyDictionary<string, string> words, string rule, bool usual = false)
        => words.Text(rule, usual ? "yes" : "no") == "yes";

    public static double Number(this IReadOnlyDictionary<string, string> words, string rule, double usual = 0)
        => NumberReader.TryParse(words.Text(rule), out var number) ? number : usual;

    public static T One<T>(this IReadOnlyDictionary<string, string> words, string rule, T usual = default)
        where T : struct
        => words.Text(rule) is { Length: > 0 } value ? (T)Enum.Parse(typeof(T), value) : usual;
}
