using Caterpillar.Basics;
using Caterpillar.Expressions;

namespace Caterpillar.Machines;

/// <summary>Advice on a key that does not exist.</summary>
internal static class UnknownKey
{
    /// <summary>An error that names the key that was probably meant, or where the key belongs.</summary>
    public static Diagnostic Problem(string noun, string key, IEnumerable<string> known, SourceLocation place)
    {
        var names = known.ToArray();
        // A word that begins several keys names their subject, not one of them without its unit.
        var group = KeyAdvice.Alike(key, names, whole: true);
        var isSubject = group.Count > 1 && key.All(c => c != '_');
        if (!isSubject && KeyAdvice.OtherUnit(key, names) is { } other)
        {
            var (wrong, right) = (KeyAdvice.UnitOf(key), KeyAdvice.UnitOf(other));
            var reason = wrong.Length == 0 ? $"{key} does not state its unit" : right.Length == 0 ? $"{key} has no unit"
                : $"{key} is measured in {Spoken(right)}, not in {Spoken(wrong)}";
            return new Diagnostic(Severity.Error, "profile.wrong_unit", $"{reason}: the key is {other}.", place);
        }
        var message = $"{key} is not a key of {(noun == "settings" ? "settings" : "a " + noun)}";
        if (ProfileKinds.KindOf(key) is { } kind && !names.Contains(key)) message += $"; it belongs to {kind}";
        else if (group.Count > 0) message += $"; did you mean {Words.Either(group)}?";
        else if (SpellingSuggestion.Nearest(key, names) is { } near) message += $"; did you mean {near}?";
        else if (KeyAdvice.Alike(key, names, whole: false) is { Count: > 0 } alike) message += $"; did you mean {Words.Either(alike)}?";
        return new Diagnostic(Severity.Error, "profile.unknown_key", message.EndsWith("?", StringComparison.Ordinal) ? message : message + ".", place);
    }

    private static string Spoken(string unit) => unit switch
    {
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
}
