using Caterpillar.Machines;

namespace Caterpillar.GH.Plugin;

/// <summary>A kind of profile: its plural noun, its usual profile and its keys, and how profiles are listed, found, named, written and read.</summary>
internal sealed record ProfileKind<T>(
    string Plural,
    string Usual,
    IReadOnlyList<ProfileKey> Keys,
    Func<ProfileLibrary, IReadOnlyList<string>> Names,
    Func<ProfileLibrary, string, Result<T>> Find,
    Func<T, string> NameOf,
    Func<T, string> Write,
    Func<string, string, Result<T>> Read)
    where T : class;

/// <summary>The three kinds.</summary>
internal static class ProfileKinds
{
    public static readonly ProfileKind<Printer> Printer = new("printers", "generic", ProfileKeys.Printer, l => l.PrinterNames,
        (l, name) => l.Printer(name), p => p.Name, ProfileWriter.Write, (json, name) => ProfileReader.ReadPrinter(json, "definition", name));

    public static readonly ProfileKind<Material> Material = new("materials", "pla", ProfileKeys.Material, l => l.MaterialNames,
        (l, name) => l.Material(name), m => m.Name, ProfileWriter.Write, (json, name) => ProfileReader.ReadMaterial(json, "definition", name));

    public static readonly ProfileKind<PrintSettings> Settings = new("settings", "standard", ProfileKeys.Settings, l => l.SettingsNames,
        (l, name) => l.Settings(name), s => s.Name, ProfileWriter.Write, (json, name) => ProfileReader.ReadSettings(json, "definition", name));
}
