namespace Caterpillar.Machines;

/// <summary>
/// Reads profiles from JSON. Unknown keys, keys with another unit, values of another type and values out of range are errors that name the file, the line and
/// the key. <c>inherits</c> names a profile to start from. Without it, missing values default to the generic printer, PLA and standard settings.
/// </summary>
public static class ProfileReader
{
    /// <summary>
    /// Reads a <see cref="Printer"/>, a <see cref="Material"/> or <see cref="PrintSettings"/>. <paramref name="parent"/> finds the profile that it inherits.
    /// </summary>
    public static Result<T> Read<T>(string json, string file, string name, Func<string, Result<T>>? parent = null)
        where T : class
    {
        var kind = ProfileKinds.Of<T>();
        if (json is null) throw new ArgumentNullException(nameof(json));
        var diagnostics = new List<Diagnostic>();
        var entries = JsonFlat.Read(json, file, diagnostics);
        if (entries is null) return new Result<T>(null, diagnostics);
        var profile = Base(kind, entries, file, name, parent, diagnostics);
        var seen = new HashSet<string>(StringComparer.Ordinal);
        foreach (var entry in entries)
        {
            var place = new SourceLocation(file, entry.Line, entry.Column, entry.Key);
            if (!seen.Add(entry.Key)) diagnostics.Add(new Diagnostic(Severity.Error, "profile.duplicate_key", "Repeated key. Delete one of the two.",
                place));
            else if (entry.Key is not ("inherits" or "$schema")) profile = kind.Apply(profile, entry.Key, entry.Value, place, diagnostics);
        }
        return new Result<T>(diagnostics.Any(d => d.Severity == Severity.Error) ? null : profile, diagnostics);
    }

    private static T Base<T>(ProfileKind<T> kind, List<JsonEntry> entries, string file, string name, Func<string, Result<T>>? parent,
        List<Diagnostic> diagnostics)
        where T : class
    {
        var entry = entries.FirstOrDefault(e => e.Key == "inherits");
        if (entry is null) return kind.Empty(name);
        var place = new SourceLocation(file, entry.Line, entry.Column, entry.Key);
        if (entry.Value is not string wanted)
        {
            diagnostics.Add(new Diagnostic(Severity.Error, "profile.wrong_type", "inherits needs the name of a profile.", place));
            return kind.Empty(name);
        }
        var found = parent?.Invoke(wanted);
        if (found?.Value is null)
            diagnostics.Add(new Diagnostic(Severity.Error, "profile.no_parent", $"The inherited {kind.Noun} \"{wanted}\" is missing or has errors.", place));
        if (found is not null) diagnostics.AddRange(found.Diagnostics);
        return found?.Value is { } value ? kind.Named(value, name) : kind.Empty(name);
    }
}
