using Grasshopper;

namespace Caterpillar.GH.Plugin;

/// <summary>
/// Calls back, on another thread, when a profile of the user's folder changes. It watches the folder of Grasshopper's settings, which is always there, so
/// that a folder for profiles that is made later is seen too.
/// </summary>
internal sealed class ProfileWatcher : IDisposable
{
    private readonly FileSystemWatcher? _watcher;
    private readonly string _folder = Profiles.UserFolder;
    private readonly Action _changed;

    public ProfileWatcher(Action changed)
    {
        _changed = changed;
        try
        {
            if (!Directory.Exists(Folders.SettingsFolder)) return;
            _watcher = new FileSystemWatcher(Folders.SettingsFolder) { IncludeSubdirectories = true };
            _watcher.Changed += (_, e) => Notice(e.FullPath);
            _watcher.Created += (_, e) => Notice(e.FullPath);
            _watcher.Deleted += (_, e) => Notice(e.FullPath);
            _watcher.Renamed += (_, e) => Notice(e.FullPath);
            _watcher.EnableRaisingEvents = true;
        }
        catch (Exception e) when (e is IOException or PlatformNotSupportedException or ArgumentException or UnauthorizedAccessException)
        {
            // A folder that can't be watched is still read at the next solution.
            _watcher?.Dispose();
            _watcher = null;
        }
    }

    public void Dispose() => _watcher?.Dispose();

    // Grasshopper keeps other settings in the folder.
    private void Notice(string path)
    {
        if (path.StartsWith(_folder, StringComparison.Ordinal) || _folder.StartsWith(path, StringComparison.Ordinal)) _changed();
    }
}
