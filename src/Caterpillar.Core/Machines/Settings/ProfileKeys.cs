namespace Caterpillar.Machines;

/// <summary>All keys of profiles, by kind: the one table for reader, writer, schema, templates, <c>--set</c> and manual.</summary>
public static class ProfileKeys
{
    /// <summary>Keys of printers.</summary>
    public static IReadOnlyList<ProfileKey> Printer => ProfileKinds.Printer.Keys;

    /// <summary>Keys of materials.</summary>
    public static IReadOnlyList<ProfileKey> Material => ProfileKinds.Material.Keys;

    /// <summary>Keys of print settings.</summary>
    public static IReadOnlyList<ProfileKey> Settings => ProfileKinds.Settings.Keys;

    /// <summary>The keys of all three kinds.</summary>
    public static IEnumerable<ProfileKey> All => Printer.Concat(Material).Concat(Settings);

    /// <summary>An error for a name that is not among some keys, with the key that was probably meant.</summary>
    /// <param name="kinds">Plural noun of the profiles: <c>printers</c>.</param>
    /// <param name="keys">Their keys.</param>
    /// <param name="name">The unknown name.</param>
    public static Diagnostic Unknown(string kinds, IReadOnlyList<ProfileKey> keys, string name)
        => UnknownKey.Problem(kinds, name, null, keys.Select(k => k.Name).Where(k => k != "title"), new SourceLocation(Key: name));
}
