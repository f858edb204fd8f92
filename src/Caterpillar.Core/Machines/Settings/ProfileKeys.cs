namespace Caterpillar.Machines;

/// <summary>All keys of profiles, by kind: the one table for reader, writer, schema, templates, <c>--set</c> and manual.</summary>
internal static class ProfileKeys
{
    /// <summary>Keys of printers.</summary>
    public static IReadOnlyList<ProfileKey> Printer => ProfileKinds.Printer.Keys;

    /// <summary>Keys of materials.</summary>
    public static IReadOnlyList<ProfileKey> Material => ProfileKinds.Material.Keys;

    /// <summary>Keys of print settings.</summary>
    public static IReadOnlyList<ProfileKey> Settings => ProfileKinds.Settings.Keys;

    /// <summary>The keys of all three kinds.</summary>
    public static IEnumerable<ProfileKey> All => Printer.Concat(Material).Concat(Settings);
}
