using System;
using System.Collections.Generic;
using System.Linq;

namespace Caterpillar.Machines;

/// <summary>One of the three kinds of profiles: its folder, its keys, its record.</summary>
internal sealed class ProfileKind<T>(string noun, string folder, IReadOnlyList<ProfileKey<T>> keys, Func<T> empty, Func<T, string, T> named)
    where T : class
{
    private readonly Dictionary<string, ProfileKey<T>> _byName = keys.ToDictionary(k => k.Name, StringComparer.Ordinal);

    /// <summary><c>printer</c>, <c>material</c> or <c>settings</c>.</summary>
    public string Noun => noun;

    /// <summary>Folder under <c>printers/</c>, with a trailing slash.</summary>
    public string Folder => folder;

    public IReadOnlyList<ProfileKey<T>> Keys => keys;

    public T Empty(string name) => named(empty(), name);

    public T Named(T profile, string name) => named(profile, name);

    public ProfileKey<T>? Find(string key) => _byName.TryGetValue(key, out var found) ? found : null;
}

/// <summary>The three kinds of profiles.</summary>
internal static class ProfileKinds
{
    public static readonly ProfileKind<Printer> Printer = new("printer", "", PrinterKeys.All, () => new Printer(), (p, name) => p with { Name = name });

    public static readonly ProfileKind<Material> Material = new("material", "materials/", MaterialKeys.All, () => new Material(),
        (m, name) => m with { Name = name });

    public static readonly ProfileKind<PrintSettings> Settings = new("settings", "settings/", SettingsKeys.All, () => new PrintSettings(),
        (s, name) => s with { Name = name });

    /// <summary>The kind of profiles that has a key, for messages.</summary>
    public static string? KindOf(string key)
        => Printer.Find(key) is not null ? "printers" : Material.Find(key) is not null ? "materials" : Settings.Find(key) is not null ? "settings" : null;
}
