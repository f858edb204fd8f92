namespace Caterpillar.Machines;

/// <summary>Advice on an unknown key.</summary>
internal static class KeyAdvice
{
    // Longest first: the unit of a key is the longest of these that it ends in.
    private static readonly string[] Units = new[]
    {
        "mm3_s", "mm_s2", "mm_s3", "mm_min", "mm_sec", "mm_s", "mm2", "mm3", "mm", "cm3_s", "cm_s", "cm", "m_s2", "m_s", "m", "um", "micron", "microns", "inch",
            "inches", "in_s", "in_min", "in",
        "g_cm3", "kg_m3", "g_ml", "g", "c_s", "c", "celsius", "f", "fahrenheit", "k", "kelvin", "deg", "degrees", "degree", "rad", "radians", "percent", "pct",
            "ratio", "factor", "s", "sec", "seconds", "ms", "min",
        "moves", "count", "per_kg", "per_g",
    }.OrderByDescending(u => u.Length).ThenBy(u => u, StringComparer.Ordinal).ToArray();

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
    public static string UnitOf(string key) => Units.FirstOrDefault(u => key.EndsWith("_" + u, StringComparison.Ordinal)) ?? "";

    /// <summary>A unit as people write it; nothing for ratios and counts.</summary>
    public static string Spoken(string unit) => unit switch
    {
        "ratio" or "factor" or "moves" or "count" or "per_kg" => "",
        "c_s" => "°C/s",
        "mm_s" => "mm/s",
        "mm_s2" => "mm/s²",
        "mm3_s" => "mm³/s",
        "c" => "°C",
        "f" => "°F",
        "k" => "K",
        "deg" => "degrees",
        "percent" => "%",
        "g_cm3" => "g/cm³",
        "mm_min" => "mm/min",
        "cm_s" => "cm/s",
        "m_s" => "m/s",
        _ => unit.Replace('_', ' '),
    };

    // In the singular, without short units.
    private static string[] Words(string key)
        => key.ToLowerInvariant().Split('_', ' ', '-').Where(w => w.Length > 2).Select(w => w.Length > 3 ? w.TrimEnd('s') : w).Distinct().ToArray();

    private static string Stem(string key)
    {
        var unit = UnitOf(key);
        return unit.Length == 0 ? key : key.Substring(0, key.Length - unit.Length - 1);
    }
}
