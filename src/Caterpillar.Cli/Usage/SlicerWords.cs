namespace Caterpillar.Cli;

/// <summary>Answers to options of other slicers, which are keys or options with other names here.</summary>
internal static class SlicerWords
{
    /// <summary>
    /// Words for a key with an example value, or for an option of a verb (* = any verb that has it). Names of keys in other slicers come from
    /// <see cref="SlicerName"/>.
    /// </summary>
    public static readonly (string Words, string Answer)[] Table
        = [.. EmbeddedText.Rows("names/SlicerWords.tsv").Skip(1).Select(row => (row[0], row[1]))];

    /// <summary>A sentence with the key or option for a word of another slicer, or null.</summary>
    /// <param name="option">The unknown option.</param>
    /// <param name="value">The number that follows it, or null.</param>
    /// <param name="verb">The verb.</param>
    /// <param name="verbs">All verbs.</param>
    public static string? Advice(string option, string? value, Command verb, IEnumerable<Command> verbs)
    {
        var word = option.TrimStart('-').Replace('-', '_').ToLowerInvariant();
        var answer = Table.FirstOrDefault(t => t.Words.Split(' ').Contains(word) && (t.Answer[0] != '*' || Has(verb, t.Answer.Split(' ')[1]))).Answer;
        if (answer is null && SlicerName.Answer(word, value) is { } name) (answer, value) = (ExampleOf(name.Key), value is null ? null : name.Value ?? "VALUE");
        else if (answer is null && KeyOf(word) is { } key) answer = ExampleOf(key);
        var others = verbs.Where(v => Has(v, option)).Select(v => v.Name).ToArray();
        var isKey = answer?.IndexOf('=') > 0 && !answer.Contains(' ');
        if (others.Length > 0 && (answer is null || (isKey && !Slices(verb)))) return $"It is an option of {string.Join(", ", others)}.";
        if (answer is null) return null;
        if (isKey)
        {
            var set = value is null ? answer : answer[..(answer.IndexOf('=') + 1)] + value;
            return Slices(verb) ? $"Set the key: --set {set}" : $"Set the key for slicing: caterpillar slice MODEL --set {set}";
        }
        var parts = answer.Split(' ', 2);
        if (parts[0] == "*") return $"Use {parts[1]}";
        var input = verbs.FirstOrDefault(v => v.Name == parts[0])?.Arguments.FirstOrDefault(a => a.Arity.MinimumNumberOfValues > 0);
        return parts[0] == verb.Name ? $"Use {parts[1]}" : $"Use: caterpillar {parts[0]} {(input is null ? "" : input.Name + " ")}{parts[1]}";
    }

    private static bool Slices(Command verb) => verb.Name is "slice" or "turtle" or "curves";

    private static bool Has(Command verb, string option) => verb.Options.Any(o => !o.Hidden && o.Name == option);

    private static string ExampleOf(string key)
        => Table.FirstOrDefault(t => t.Answer.StartsWith(key + "=", StringComparison.Ordinal)).Answer ?? key + "=VALUE";

    // A key with or without its unit.
    private static string? KeyOf(string word)
    {
        var known = ProfileKeys.All.Select(k => k.Name).Where(k => k != "title").ToArray();
        return known.Contains(word) ? word : KeyAdvice.OtherUnit(word, known);
    }
}
