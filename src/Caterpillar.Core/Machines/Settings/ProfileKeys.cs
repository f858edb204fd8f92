namespace Caterpillar.Machines;

/// <summary>All keys of profiles, by the kind of profile: the one table that reader, writer, schema, templates, <c>--set</c> and the manual read.</summary>
internal static class ProfileKeys
{
    /// <summary>Keys of printers.</summary>
    public static IReadOnlyList<ProfileKey> Printer => ProfileKinds.Printer.Keys;

    /// <summary>Keys of materials.</summary>
    public static IReadOnlyList<ProfileKey> Material => ProfileKinds.Material.Keys;

    /// <summary>Keys of print settings.</summary>
    public static IReadOnlyList<ProfileKey> Settings => ProfileKinds.Settings.Keys;
}
