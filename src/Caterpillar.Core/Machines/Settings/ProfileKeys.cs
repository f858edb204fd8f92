namespace Caterpillar.Machines;

/// <summary>All keys of profiles, by kind: the one table for reader, writer, schema, templates, <c>--set</c> and manual.</summary>
public static class ProfileKeys
{
    /// <summary>Keys of a kind of profile: <see cref="Printer"/>, <see cref="Material"/> or <see cref="PrintSettings"/>.</summary>
    public static IReadOnlyList<ProfileKey> Of<T>()
        where T : class
        => ProfileKinds.Of<T>().Keys;

    /// <summary>The keys of all three kinds.</summary>
    public static IEnumerable<ProfileKey> All => Of<Printer>().Concat(Of<Material>()).Concat(Of<PrintSettings>());

    /// <summary>An error for a name that is no key of a kind of profile, with the key that was probably meant.</summary>
    public static Diagnostic Unknown<T>(string name)
        where T : class
        => UnknownKey.Problem(ProfileKinds.Of<T>().Plural, name, null, Of<T>().Select(k => k.Name).Where(k => k != "title"), new SourceLocation(Key: name));
}
