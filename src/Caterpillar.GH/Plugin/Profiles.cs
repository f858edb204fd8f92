using Caterpillar.Machines;
using Grasshopper;

namespace Caterpillar.GH.Plugin;

/// <summary>The built-in profiles, overridden by those in the user's folder.</summary>
internal static class Profiles
{
    /// <summary>The folder of the user's own printers, materials and settings. It need not exist.</summary>
    public static string UserFolder => Path.Combine(Folders.SettingsFolder, "Caterpillar", "printers");

    /// <summary>A library of the profiles that are in the folder now.</summary>
    public static ProfileLibrary Library => new(UserFolder);
}
