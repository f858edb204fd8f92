namespace Caterpillar.Expressions;

/// <summary>Suggests the word that was probably meant.</summary>
public static class SpellingSuggestion
{
    /// <summary>The nearest known word (fewest changed, missing, added or swapped letters), or null if none is close.</summary>
    public static string? Nearest(string word, IEnumerable<string> known)
    {
        string? best = null;
        var limit = word.Length <= 2 ? 1 : word.Length <= 5 ? 2 : 3;
        var distance = limit + 1;
        foreach (var candidate in known)
        {
            if (Math.Abs(candidate.Length - word.Length) >= distance) continue;
            var d = Distance(word.ToLowerInvariant(), candidate.ToLowerInvariant());
            if (d >= distance) continue;
            distance = d;
            best = candidate;
        }
        return best is not null && distance < Math.Max(word.Length, best.Length) ? best : null;
    }

    /// <summary>The sentence " Did you mean …?", or nothing.</summary>
    public static string Hint(string word, IEnumerable<string> known) => Nearest(word, known) is { } near ? $" Did you mean '{near}'?" : "";

    private static int Distance(string a, string b)
    {
        var before = new int[b.Length + 1];
        var last = new int[b.Length + 1];
        var row = new int[b.Length + 1];
        for (var j = 0; j <= b.Length; j++) last[j] = j;
        for (var i = 1; i <= a.Length; i++)
        {
            row[0] = i;
            for (var j = 1; j <= b.Length; j++)
            {
                row[j] = Math.Min(Math.Min(row[j - 1], last[j]) + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1));
                if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = Math.Min(row[j], before[j - 2] + 1);
            }
            (before, last, row) = (last, row, before);
        }
        return last[b.Length];
    }
}
