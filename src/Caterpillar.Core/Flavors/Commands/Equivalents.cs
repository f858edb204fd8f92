namespace Caterpillar.Flavors;

/// <summary>Commands of one flavor in the words of another, from <c>Equivalents.tsv</c>.</summary>
internal static class Equivalents
{
    private static readonly Lazy<string[][]> Rows = new(() => EmbeddedText.Rows("flavors/Equivalents.tsv"));

    /// <summary>A line without comment in the words of another flavor.</summary>
    /// <returns>The lines, none if the other flavor has no such command, or null if the table does not have the line.</returns>
    public static IReadOnlyList<string>? Of(string line, string from, string to)
    {
        var names = Rows.Value[0];
        var (a, b) = (Array.IndexOf(names, from), Array.IndexOf(names, to));
        if (a < 0) return null;
        var words = Words(line);
        foreach (var row in Rows.Value.Skip(1))
        {
            if (row[a] == "-" || Match(Words(row[a]), words) is not { } values) continue;
            return b < 0 || row[b] == "-" ? [] : [.. row[b].Split('&').Select(cell => Fill(cell.Trim(), values)).Where(filled => filled.Length > 0)];
        }
        return null;
    }

    /// <summary>Commands of a flavor that are always written in the words of another.</summary>
    public static IReadOnlyList<string> AlwaysOf(string from, string to)
    {
        var names = Rows.Value[0];
        var (a, b) = (Array.IndexOf(names, from), Array.IndexOf(names, to));
        if (a < 0 || b < 0) return [];
        return [.. Rows.Value.Where(r => r[0] == "!" && r[a] != "-" && r[b] != "-" && r[a] != r[b]).Select(r => r[a].Split(' ')[0]).Distinct()];
    }

    // The command, then the words with their keys: a letter, or a name with an equals sign.
    private static List<(string Key, string Value)> Words(string line)
    {
        var parts = line.Split([' '], StringSplitOptions.RemoveEmptyEntries);
        var rest = parts.Length > 1 ? line.Substring(line.IndexOf(" ", StringComparison.Ordinal)).Trim() : "";
        var words = new List<(string, string)> { (parts[0].ToUpperInvariant(), rest) };
        foreach (var part in parts.Skip(1))
        {
            var equals = part.IndexOf("=", StringComparison.Ordinal);
            words.Add((part.Substring(0, Math.Max(equals, 1)).ToUpperInvariant(), part.Substring(Math.Max(equals, 0) + 1)));
        }
        return words;
    }

    // The values in braces; null if the line is another one.
    private static Dictionary<string, string>? Match(List<(string Key, string Value)> cell, List<(string Key, string Value)> line)
    {
        if (cell[0].Key != line[0].Key) return null;
        var values = new Dictionary<string, string>(StringComparer.Ordinal);
        foreach (var (key, value) in cell.Skip(1))
        {
            var says = key == "{" ? line[0].Value : line.Skip(1).FirstOrDefault(w => w.Key == key).Value;
            var brace = (key == "{" ? "{" : "") + value;
            // Texts go to the end of the line.
            if (value == "{text}" && says is not null) says = line[0].Value.Substring(line[0].Value.IndexOf("=", StringComparison.Ordinal) + 1).Trim('"');
            if (brace[0] != '{')
            {
                if (!string.Equals(says, brace, StringComparison.OrdinalIgnoreCase)) return null;
                continue;
            }
            if (says is not null) values[brace] = says;
        }
        return values.Count > 0 || cell.Count == 1 || cell.Skip(1).All(w => w.Key != "{" && w.Value.IndexOf("{", StringComparison.Ordinal) < 0) ? values : null;
    }

    // Words whose values the line does not have are left out; without any value nothing is left.
    private static string Fill(string cell, Dictionary<string, string> values)
    {
        var filled = new List<string>();
        var (has, lacks) = (false, false);
        foreach (var part in cell.Split(' '))
        {
            var open = part.IndexOf("{", StringComparison.Ordinal);
            if (open < 0)
            {
                filled.Add(part);
                continue;
            }
            if (!values.TryGetValue(part.Substring(open), out var value))
            {
                lacks = true;
                continue;
            }
            has = true;
            filled.Add(part.Substring(0, open) + value);
        }
        return lacks && !has ? "" : string.Join(" ", filled);
    }
}
