using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Expressions;

namespace Caterpillar.Machines;

/// <summary>
/// Reads profiles from JSON. Unknown keys, keys with another unit, values of another kind and values outside their range are errors that name the file, the
/// line and the key.
/// <c>inherits</c> names a profile to start from; without it the values are those of the generic printer, PLA and the standard settings.
/// </summary>
public static class ProfileReader
{
    /// <summary>Reads a printer; <paramref name="parent"/> finds the profile that it inherits.</summary>
    public static Result<Printer> ReadPrinter(string json, string file, string name, Func<string, Result<Printer>>? parent = null)
        => Read(ProfileKinds.Printer, json, file, name, parent);

    /// <summary>Reads a material; <paramref name="parent"/> finds the profile that it inherits.</summary>
    public static Result<Material> ReadMaterial(string json, string file, string name, Func<string, Result<Material>>? parent = null)
        => Read(ProfileKinds.Material, json, file, name, parent);

    /// <summary>Reads print settings; <paramref name="parent"/> finds the profile that they inherit.</summary>
    public static Result<PrintSettings> ReadSettings(string json, string file, string name, Func<string, Result<PrintSettings>>? parent = null)
        => Read(ProfileKinds.Settings, json, file, name, parent);

    internal static Result<T> Read<T>(ProfileKind<T> kind, string json, string file, string name, Func<string, Result<T>>? parent)
        where T : class
    {
        if (json is null) throw new ArgumentNullException(nameof(json));
        var diagnostics = new List<Diagnostic>();
        var entries = JsonFlat.Read(json, file, diagnostics);
        if (entries is null) return new Result<T>(null, diagnostics);
        var profile = Base(kind, entries, file, name, parent, diagnostics);
        var seen = new HashSet<string>(StringComparer.Ordinal);
        foreach (var entry in entries)
        {
            var place = new SourceLocation(file, entry.Line, entry.Column, entry.Key);
            if (!seen.Add(entry.Key)) diagnostics.Add(new Diagnostic(Severity.Error, "profile.repeated_key", "This key is repeated.",
                place));
            else if (entry.Key is not ("inherits" or "$schema")) profile = Apply(kind, profile, entry.Key, entry.Value, place, diagnostics);
        }
        return new Result<T>(diagnostics.Any(d => d.Severity == Severity.Error) ? null : profile, diagnostics);
    }

    /// <summary>The profile with one more value, or the same and an error.</summary>
    internal static T Apply<T>(ProfileKind<T> kind, T profile, string key, object? raw, SourceLocation place, List<Diagnostic> diagnostics)
        where T : class
    {
        if (kind.Find(key) is not { } found)
        {
            diagnostics.Add(Unknown(kind.Noun, key, kind.Keys.Select(k => k.Name).Concat(["inherits"]), place));
            return profile;
        }
        if (raw is null)
        {
            diagnostics.Add(new Diagnostic(Severity.Error, "profile.wrong_kind", $"{key} needs {found.Format.Expected}.", place));
            return profile;
        }
        var changed = found.Set(profile, raw, out var problem);
        if (changed is not null) return changed;
        var code = problem!.StartsWith("needs", StringComparison.Ordinal) ? "profile.wrong_kind" : "profile.out_of_range";
        diagnostics.Add(new Diagnostic(Severity.Error, code, $"{key} {problem}." + (raw is string word ? found.Format.Hint(word) : ""), place));
        return profile;
    }

    /// <summary>Advice on a key that does not exist.</summary>
    internal static Diagnostic Unknown(string noun, string key, IEnumerable<string> known, SourceLocation place)
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
        else if (group.Count > 0) message += $"; did you mean {Listed(group)}?";
        else if (SpellingSuggestion.Nearest(key, names) is { } near) message += $"; did you mean {near}?";
        else if (KeyAdvice.Alike(key, names, whole: false) is { Count: > 0 } alike) message += $"; did you mean {Listed(alike)}?";
        return new Diagnostic(Severity.Error, "profile.unknown_key", message.EndsWith("?", StringComparison.Ordinal) ? message : message + ".", place);
    }

    private static string Listed(IReadOnlyList<string> names)
        => names.Count == 1 ? names[0] : string.Join(", ", names.Take(names.Count - 1)) + " or " + names[names.Count - 1];

    private static T Base<T>(ProfileKind<T> kind, List<JsonEntry> entries, string file, string name, Func<string, Result<T>>? parent,
        List<Diagnostic> diagnostics)
        where T : class
    {
        var entry = entries.FirstOrDefault(e => e.Key == "inherits");
        if (entry is null) return kind.Empty(name);
        var place = new SourceLocation(file, entry.Line, entry.Column, entry.Key);
        if (entry.Value is not string wanted)
        {
            diagnostics.Add(new Diagnostic(Severity.Error, "profile.wrong_kind", "inherits needs the name of a profile.", place));
            return kind.Empty(name);
        }
        var found = parent?.Invoke(wanted);
        if (found?.Value is null)
        {
            diagnostics.Add(new Diagnostic(Severity.Error, "profile.no_parent", $"The {kind.Noun} \"{wanted}\" to inherit from cannot be read.", place));
        }
        if (found is not null) diagnostics.AddRange(found.Diagnostics);
        return found?.Value is { } value ? kind.Named(value, name) : kind.Empty(name);
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
