namespace Caterpillar.Machines;

/// <summary>Writes profiles as JSON with all keys. Reading the text gives an equal profile.</summary>
public static class ProfileWriter
{
    /// <summary>A printer as JSON with all its keys.</summary>
    public static string Write(Printer printer) => Write(ProfileKinds.Printer.Keys, printer);

    /// <summary>A material as JSON with all its keys.</summary>
    public static string Write(Material material) => Write(ProfileKinds.Material.Keys, material);

    /// <summary>Print settings as JSON with all their keys; 0 for what follows from the nozzle.</summary>
    public static string Write(PrintSettings settings) => Write(ProfileKinds.Settings.Keys, settings?.AsGiven!);

    private static string Write<T>(IEnumerable<ProfileKey<T>> keys, T profile)
        where T : class
    {
        if (profile is null) throw new ArgumentNullException(nameof(profile));
        return ProfileJson.Write(keys.Select(k => new KeyValuePair<string, object>(k.Name, k.Get(profile))));
    }
}
