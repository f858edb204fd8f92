namespace Caterpillar.Turtles;

/// <summary>
/// The folders whose files a script may read (<c>include</c>, <c>image</c>), with their subfolders. A name is looked up next to the file that contains it,
/// then in the folders. Files elsewhere are an error, also through <c>..</c> or a link.
/// </summary>
public sealed class ScriptFiles
{
    /// <summary>Maximum size of a file, bytes.</summary>
    public const int MaxBytes = 64 << 20;

    private readonly string[] _folders;

    /// <param name="folders">The folder of the script first. Without folders, the script may not read files.</param>
    public ScriptFiles(params string[] folders)
        => _folders = (folders ?? throw new ArgumentNullException(nameof(folders))).Select(f => Path.GetFullPath(f.Length == 0 ? "." : f)).ToArray();

    /// <summary>No files.</summary>
    public static ScriptFiles None { get; } = new();

    /// <summary>The path of the file in a token. <paramref name="from"/> is the file with the token, or null for the script itself.</summary>
    /// <exception cref="FormulaException">The file does not exist or must not be read.</exception>
    internal string Find(Token name, string? from)
    {
        if (_folders.Length == 0) throw Error("This script has no folder, so it cannot read files.", name);
        var outside = false;
        foreach (var folder in new[] { from is null ? _folders[0] : Path.GetDirectoryName(from)! }.Concat(_folders).Distinct(StringComparer.Ordinal))
        {
            if (Combine(folder, name) is not { } path) continue;
            if (!IsInside(path))
            {
                outside = true;
                continue;
            }
            if (Directory.Exists(path)) throw Error($"'{name.Text}' is a folder, not a file.", name);
            if (!File.Exists(path)) continue;
            if (!IsInside(Path.GetFullPath(FileLinks.Target(path)))) throw Error($"'{name.Text}' links out of the folders that the script may read.", name);
            return path;
        }
        throw Error(outside ? $"'{name.Text}' is outside the folders that the script may read." : $"File '{name.Text}' not found.", name);
    }

    /// <exception cref="FormulaException">The file cannot be read or is too large.</exception>
    internal static byte[] Read(string path, Token name)
    {
        try
        {
            using var file = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.Read);
            if (file.Length > MaxBytes) throw Error($"'{name.Text}' is larger than {MemoryLimit.Text(MaxBytes)}.", name);
            var bytes = new byte[file.Length];
            return ReadStream.Fill(file, bytes, 0, bytes.Length) == bytes.Length ? bytes
                : throw Error($"'{name.Text}' became shorter while it was being read.", name);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw Error($"'{name.Text}' cannot be read.", name);
        }
    }

    private static string? Combine(string folder, Token name)
    {
        try
        {
            return name.Text.Trim().Length == 0 ? null : Path.GetFullPath(Path.Combine(folder, name.Text));
        }
        catch (Exception e) when (e is ArgumentException or NotSupportedException or PathTooLongException)
        {
            return null;
        }
    }

    private bool IsInside(string path) => _folders.Any(f => Below(path, f) || Below(path, Path.GetFullPath(FileLinks.Target(f))));

    private static bool Below(string path, string folder)
        => path.StartsWith(folder.TrimEnd(Path.DirectorySeparatorChar) + Path.DirectorySeparatorChar, StringComparison.Ordinal);

    private static FormulaException Error(string message, Token name) => new("turtle.file", message, name);
}
