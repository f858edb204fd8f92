namespace Caterpillar.Machines;

/// <summary>A kind of profile: its folder, keys and record.</summary>
internal sealed class ProfileKind<T>(string noun, string folder, IReadOnlyList<ProfileKey<T>> keys, Func<T> empty, Func<T, string, T> named)
    where T : class
{
    private readonly Dictionary<string, ProfileKey<T>> _byName = keys.ToDictionary(k => k.Name, StringComparer.Ordinal);
    private readonly Dictionary<string, ProfileKey<T>> _byProperty = keys.ToDictionary(k => k.Property, StringComparer.Ordinal);

    /// <summary><c>printer</c>, <c>material</c> or <c>settings</c>.</summary>
    public string Noun => noun;

    public string Plural => noun == "settings" ? noun : noun + "s";

    /// <summary>Folder under <c>printers/</c>, with a trailing slash.</summary>
    public string Folder => folder;

    public IReadOnlyList<ProfileKey<T>> Keys => keys;

    public T Empty(string name) => named(empty(), name);

    public T Named(T profile, string name) => named(profile, name);

    public ProfileKey<T>? Find(string key) => _byName.TryGetValue(key, out var found) ? found : null;

    /// <summary>Keys by name, all of them known.</summary>
    public ProfileKey<T>[] KeysOf(params string[] names) => Array.ConvertAll(names, name => _byName[name]);

    /// <summary>A value of a property itself if it is in the range of its key.</summary>
    /// <exception cref="ArgumentOutOfRangeException">It is not.</exception>
    public TValue Check<TValue>(TValue value, [CallerMemberName] string property = "") => _byProperty[property].Check(value);

    /// <summary>The profile with one more value, or the unchanged profile and an error.</summary>
    public T Apply(T profile, string key, object? raw, SourceLocation place, List<Diagnostic> diagnostics)
    {
        if (Find(key) is not { } found)
        {
            diagnostics.Add(UnknownKey.Problem(Plural, key, raw, Keys.Select(k => k.Name).Concat(["inherits"]), place));
            return profile;
        }
        if (raw is null)
        {
            diagnostics.Add(new Diagnostic(Severity.Error, "profile.wrong_type", $"{key} needs {found.Format.Expected}.", place));
            return profile;
        }
        var changed = found.Set(profile, raw, out var problem);
        if (changed is not null) return changed;
        var code = (found.Format as LinesFormat)?.ErrorCode(raw)
            ?? (problem!.StartsWith("needs", StringComparison.Ordinal) ? "profile.wrong_type" : "profile.out_of_range");
        problem += problem!.EndsWith("?", StringComparison.Ordinal) ? "" : ".";
        diagnostics.Add(new Diagnostic(Severity.Error, code, $"{key} {problem}" + (raw is string word ? found.Format.Hint(word) : ""), place));
        return profile;
    }
}

/// <summary>The three kinds of profiles.</summary>
internal static class ProfileKinds
{
    public static readonly ProfileKind<Printer> Printer = new("printer", "",
        KeyTable.Read<Printer>("Printer.tsv", typeof(Printer).GetProperties(), OwnFormats.Printer, p => p with { }),
        () => new Printer(), (p, name) => p with { Name = name });

    public static readonly ProfileKind<Material> Material = new("material", "materials/",
        KeyTable.Read<Material>("Material.tsv", typeof(Material).GetProperties(), OwnFormats.Material, m => m with { }),
        () => new Material(), (m, name) => m with { Name = name });

    public static readonly ProfileKind<PrintSettings> Settings = new("settings", "settings/",
        KeyTable.Read<PrintSettings>("PrintSettings.tsv", typeof(PrintSettings).GetProperties(), OwnFormats.Settings, s => s with { }),
        () => new PrintSettings(), (s, name) => s with { Name = name });

    /// <summary>The kind of the profiles of a type: a printer, a material or print settings.</summary>
    public static ProfileKind<T> Of<T>()
        where T : class
        => new object[] { Printer, Material, Settings }.OfType<ProfileKind<T>>().Single();

    /// <summary>The kind of profile that has a key, for messages.</summary>
    public static string? KindOf(string key)
        => Printer.Find(key) is not null ? "printers" : Material.Find(key) is not null ? "materials" : Settings.Find(key) is not null ? "settings" : null;
}
