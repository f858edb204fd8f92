namespace Caterpillar.Machines;

/// <summary>Writes profiles as JSON with all keys. Reading the text gives an equal profile.</summary>
public static class ProfileWriter
{
    /// <summary>A printer, a material, or print settings with 0 for what follows from the nozzle.</summary>
    public static string Write<T>(T profile)
        where T : class
    {
        var given = (profile as PrintSettings)?.AsGiven as T ?? profile ?? throw new ArgumentNullException(nameof(profile));
        return ProfileJson.Write(ProfileKinds.Of<T>().Keys.Select(k => new KeyValuePair<string, object>(k.Name, k.Get(given))));
    }
}
