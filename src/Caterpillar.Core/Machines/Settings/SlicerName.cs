using System.Text.RegularExpressions;
using Caterpillar.Files;

namespace Caterpillar.Machines;

/// <summary>
/// A name of another slicer for one of our keys, from <c>SlicerNames.tsv</c>: <c>wall_loops</c>, or several as in <c>machine_max_jerk_(x,y)</c>. A conversion
/// may follow: nothing for the same unit, <c>*100</c>, <c>/100</c>, <c>90-</c>, words as in <c>0=none 1=grid</c>, or <c>?</c> if a value cannot be converted.
/// </summary>
internal sealed record SlicerName(ProfileKey Key, string Slicer, string Name, string Conversion)
{
    private static readonly Lazy<SlicerName[]> Table = new(Read);

    /// <summary>All names, by key and slicer.</summary>
    public static IReadOnlyList<SlicerName> All => Table.Value;

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

    /// <summary>The value in our unit, or null if it cannot be converted or is outside the range of our key.</summary>
    public string? Convert(string text)
    {
        if (Conversion == "?") return null;
        var word = text.ToLowerInvariant() switch { "true" => "1", "false" => "0", var other => other.Replace(' ', '_') };
        var percent = text.EndsWith("%", StringComparison.Ordinal);
        var isNumber = NumberReader.TryParse(text.TrimEnd('%', ' '), out var number) && Math.Abs(number) < 1e6;
        if (Conversion.Split(' ').FirstOrDefault(c => c.StartsWith(word + "=", StringComparison.Ordinal)) is { } pair) text = pair.Substring(word.Length + 1);
        else if (percent) text = !isNumber ? "" : Ends("_percent") ? Text(number) : Ends("_ratio") ? Text(number / 100) : "";
        else if (Conversion == "90-") text = isNumber && number > 0 ? Text(90 - number) : "";
        else if (Conversion.Length > 0 && Conversion[0] is '*' or '/') text = isNumber ? Text(number * Factor()) : "";
        return Key.Format.Parse(text) is { } raw && Key.Problem(raw) is null ? raw is bool flag ? flag ? "true" : "false" : text : null;
    }

    private bool Ends(string unit) => Key.Name.EndsWith(unit, StringComparison.Ordinal);

    private bool Matches(string name) => Regex.IsMatch(name, "^" + Name.Replace(',', '|') + "$", RegexOptions.IgnoreCase);

    private double Factor()
    {
        var factor = NumberReader.TryParse(Conversion.Substring(1), out var number) ? number : 1;
        return Conversion[0] == '*' ? factor : 1 / factor;
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
}
