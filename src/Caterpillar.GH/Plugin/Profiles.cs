using System;
using System.IO;
using Caterpillar.Machines;
using Grasshopper;

namespace Caterpillar.GH.Plugin;

/// <summary>The built-in profiles, overridden by those in the user's folder.</summary>
internal static class Profiles
{
    /// <summary>The folder of the user's own printers, materials and settings; it need not exist.</summary>
    public static string UserFolder => Path.Combine(Folders.SettingsFolder, "Caterpillar", "printers");

    /// <summary>A library of the profiles that are in the folder now.</summary>
    public static ProfileLibrary Library => new(UserFolder);
}

/// <summary>Calls back, on another thread, when a profile of the user's folder changes.</summary>
internal sealed class ProfileWatcher : IDisposable
{
    private readonly FileSystemWatcher? _watcher;

    public ProfileWatcher(Action changed)
    {
        if (!Directory.Exists(Profiles.UserFolder)) return;
        try
        {
            _watcher = new FileSystemWatcher(Profiles.UserFolder, "*.json") { IncludeSubdirectories = true };
            _watcher.Changed += (_, _) => changed();
            _watcher.Created += (_, _) => changed();
            _watcher.Deleted += (_, _) => changed();
            _watcher.Renamed += (_, _) => changed();
            _watcher.EnableRaisingEvents = true;
        }
        catch (Exception e) when (e is IOException or PlatformNotSupportedException or ArgumentException)
        {
            // A folder that can't be watched is still read at the next solution.
            _watcher?.Dispose();
            _watcher = null;
        }
    }

    public void Dispose() => _watcher?.Dispose();
}
