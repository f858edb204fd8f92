namespace Caterpillar.Machines;

/// <summary>Advice on an unknown key.</summary>
internal static class KeyAdvice
{
    // As in keys, and as people write them.
    private static readonly Dictionary<string, string> Units = EmbeddedText.Rows("names/KeyUnits.tsv").Skip(1).ToDictionary(r => r[0], r => r[1]);

    /// <summary>The key that was probably meant by a name with another unit (<c>layer_height_cm</c>) or no unit (<c>layer_height</c>), or null.</summary>
    public static string? OtherUnit(string key, IEnumerable<string> known)
    {
        var stem = Stem(key);
        return known.FirstOrDefault(k => k != key && Stem(k) == stem);
    }

    /// <summary>
    /// The keys that share the most words with a name (<c>brim</c>, <c>wall_line_count</c>), in the order of the keys. If <paramref name="whole"/> is true,
    /// only keys with all words.
    /// </summary>
    public static IReadOnlyList<string> Alike(string name, IEnumerable<string> known, bool whole)
    {
        const int Most = 6;
        var words = Words(name);
        var ranked = known.Select(k => (Key: k, Shared: Words(k).Intersect(words).Count())).Where(k => k.Shared > 0).ToArray();
        var most = whole ? words.Length : ranked.Length == 0 ? 0 : ranked.Max(k => k.Shared);
        return [.. ranked.Where(k => k.Shared == most).Select(k => k.Key).Take(Most)];
    }

    /// <summary>The unit at the end of a key, or an empty text.</summary>
    public static string UnitOf(string key)
        => Units.Keys.Where(u => key.EndsWith("_" + u, StringComparison.Ordinal)).OrderByDescending(u => u.Length).FirstOrDefault() ?? "";

    /// <summary>A unit as people write it; nothing for ratios and counts.</summary>
    public static string Spoken(string unit) => Units.TryGetValue(unit, out var spoken) ? spoken : "";

    // In the singular, without short units.
    private static string[] Words(string key)
        => key.ToLowerInvariant().Split('_', ' ', '-').Where(w => w.Length > 2).Select(w => w.Length > 3 ? w.TrimEnd('s') : w).Distinct().ToArray();

    private static string Stem(string key)
    {
        var unit = UnitOf(key);
        return unit.Length == 0 ? key : key.Substring(0, key.Length - unit.Length - 1);
    }
}
