namespace Caterpillar.Machines;

/// <summary>
/// Profiles by name: the built-in ones and the ones of a user folder, which contains printers as <c>*.json</c>, materials in <c>materials/</c> and settings in
/// <c>settings/</c>. A user's profile overrides the built-in one of the same name and may inherit it. Profiles are read on request, so changes of the folder
/// take effect at once.
/// </summary>
public sealed class ProfileLibrary
{
    private const long LargestFile = 16 << 20;
    private readonly string[] _folders;

    /// <param name="userFolder">Folder of the user's profiles; null = none. It need not exist.</param>
    public ProfileLibrary(string? userFolder = null)
        : this(userFolder is null ? [] : [userFolder])
    {
    }

    private ProfileLibrary(string[] folders) => _folders = folders;

    /// <summary>Names of all profiles of a kind, sorted.</summary>
    /// <typeparam name="T"><see cref="Machines.Printer"/>, <see cref="Machines.Material"/> or <see cref="PrintSettings"/>.</typeparam>
    public IReadOnlyList<string> Names<T>()
        where T : class
    {
        var kind = ProfileKinds.Of<T>();
        var names = new SortedSet<string>(StringComparer.Ordinal);
        foreach (var (path, _) in Resources())
        {
            if (!path.StartsWith(kind.Folder, StringComparison.Ordinal) || path.IndexOf('/', kind.Folder.Length) >= 0) continue;
            names.Add(path.Substring(kind.Folder.Length, path.Length - kind.Folder.Length - ".json".Length));
        }
        foreach (var folder in _folders.Select(f => Path.Combine(f, kind.Folder)).Where(Directory.Exists))
            names.UnionWith(Directory.GetFiles(folder, "*.json").Select(f => Path.GetFileNameWithoutExtension(f)));
        return names.ToArray();
    }

    /// <summary>A printer by its name, or from a file (a name with a folder or with <c>.json</c>).</summary>
    /// <exception cref="IOException">An existing file cannot be read.</exception>
    public Result<Printer> Printer(string nameOrFile) => Find<Printer>(nameOrFile);

    /// <summary>A material by its name, or from a file.</summary>
    /// <inheritdoc cref="Printer" path="/exception"/>
    public Result<Material> Material(string nameOrFile) => Find<Material>(nameOrFile);

    /// <summary>Print settings by their name, or from a file.</summary>
    /// <inheritdoc cref="Printer" path="/exception"/>
    public Result<PrintSettings> Settings(string nameOrFile) => Find<PrintSettings>(nameOrFile);

    /// <summary>A profile by its name, or from a file.</summary>
    /// <inheritdoc cref="Names" path="/typeparam"/>
    /// <inheritdoc cref="Printer" path="/exception"/>
    public Result<T> Find<T>(string nameOrFile)
        where T : class
    {
        if (nameOrFile is null) throw new ArgumentNullException(nameof(nameOrFile));
        var kind = ProfileKinds.Of<T>();
        if (!IsFile(nameOrFile)) return Named(kind, nameOrFile, []);
        if (!File.Exists(nameOrFile))
            return new("profile.not_found", $"File {nameOrFile} not found.", new SourceLocation(nameOrFile));
        if (new FileInfo(nameOrFile).Length > LargestFile)
            return new("profile.not_an_object", "The file has more than 16 MB. It is not a profile.", new SourceLocation(nameOrFile));
        return Read(kind, new Source(nameOrFile, Path.GetFileNameWithoutExtension(nameOrFile), () => File.ReadAllText(nameOrFile)), []);
    }

    /// <summary>
    /// A complete setup. Material and settings default to the printer's <c>default_material</c> and <c>default_settings</c>, which for the file of a printer
    /// may be in its folder. <paramref name="values"/> are <c>key=value</c> for any key of the three, applied in order; keys of materials apply to all tools.
    /// <paramref name="toolMaterials"/> are the materials of the tools from 1 on.
    /// </summary>
    /// <inheritdoc cref="Printer" path="/exception"/>
    public Result<PrintSetup> Setup(
        string printer = "generic", string? material = null, string? settings = null, IEnumerable<string>? values = null,
        IReadOnlyList<string>? toolMaterials = null)
    {
        var machine = Printer(printer);
        var known = IsFile(printer) && Path.GetDirectoryName(Path.GetFullPath(printer)) is { } folder ? new ProfileLibrary([folder, .. _folders]) : this;
        var materialResult = known.Material(material ?? machine.Value?.DefaultMaterial ?? "pla");
        var settingsResult = known.Settings(settings ?? machine.Value?.DefaultSettings ?? "standard");
        var others = (toolMaterials ?? []).Select(known.Material).ToArray();
        var diagnostics = machine.Diagnostics.Concat(materialResult.Diagnostics).Concat(settingsResult.Diagnostics)
            .Concat(others.SelectMany(m => m.Diagnostics)).ToList();
        if (machine.Value is null || materialResult.Value is null || settingsResult.Value is null || Array.Exists(others, m => m.Value is null))
            return new Result<PrintSetup>(null, diagnostics);
        var plain = new PrintSetup(machine.Value, materialResult.Value, settingsResult.Value) { ToolMaterials = new(others.Select(m => m.Value!)) };
        var setup = plain.With(values ?? []);
        diagnostics.AddRange(setup.Diagnostics);
        if (setup.Value is null) return new Result<PrintSetup>(null, diagnostics);
        var findings = setup.Value.Check();
        diagnostics.AddRange(findings);
        return new Result<PrintSetup>(findings.Any(d => d.Severity == Severity.Error) ? null : setup.Value, diagnostics);
    }

    private Result<T> Named<T>(ProfileKind<T> kind, string name, IReadOnlyList<string> chain)
        where T : class
    {
        foreach (var source in Sources(kind, name))
        {
            // A profile that inherits its own name means the one it overrides.
            if (!chain.Contains(source.File)) return Read(kind, source, chain);
        }
        if (chain.Count > 0 && Sources(kind, name).Any())
            return new("profile.circular_inheritance", $"The {kind.Noun} \"{name}\" inherits itself. Change its inherits.", new SourceLocation(chain[0]));
        var names = Names<T>();
        var near = SpellingSuggestion.Nearest(name, names);
        return new Result<T>(
            "profile.not_found", $"{char.ToUpperInvariant(kind.Noun[0])}{kind.Noun.Substring(1)} \"{name}\" not found. "
                + (near is not null ? $"Did you mean {near}?" : "Available: " + string.Join(", ", names) + "."), null);
    }

    private Result<T> Read<T>(ProfileKind<T> kind, Source source, IReadOnlyList<string> chain)
        where T : class
        => ProfileReader.Read<T>(source.Read(), source.File, source.Name, parent => Named(kind, parent, [.. chain, source.File]));

    private IEnumerable<Source> Sources<T>(ProfileKind<T> kind, string name)
        where T : class
    {
        if (name.IndexOfAny(['/', '\\', '.']) >= 0) yield break;
        foreach (var file in _folders.Select(f => Path.Combine(f, kind.Folder, name + ".json")).Where(File.Exists))
            yield return new Source(file, name, () => File.ReadAllText(file));
        var resource = Resources().FirstOrDefault(r => r.Path == kind.Folder + name + ".json").Resource;
        if (resource is not null) yield return new Source("printers/" + kind.Folder + name + ".json", name, () => EmbeddedText.Read(resource));
    }

    private static bool IsFile(string name) => name.IndexOfAny(['/', '\\']) >= 0 || name.EndsWith(".json", StringComparison.OrdinalIgnoreCase);

    // Paths below printers/; resources made on Windows have backslashes.
    private static IEnumerable<(string Path, string? Resource)> Resources()
        => typeof(ProfileLibrary).Assembly.GetManifestResourceNames()
            .Where(r => r.StartsWith("printers/", StringComparison.Ordinal))
            .Select(r => (r.Substring("printers/".Length).Replace('\\', '/'), (string?)r));

    private sealed record Source(string File, string Name, Func<string> Read);
}
