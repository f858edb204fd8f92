namespace Caterpillar.Files;

/// <summary>Files that are read from their beginning to their end.</summary>
internal static class InputFile
{
    /// <summary>Opens a file for reading.</summary>
    /// <exception cref="IOException">The file is a folder, cannot be found or cannot be read.</exception>
    public static FileStream Open(string path)
    {
        if (Directory.Exists(path)) throw new IOException($"'{path}' is a folder, not a file.");
        try
        {
            return new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.Read, 1, FileOptions.SequentialScan);
        }
        catch (UnauthorizedAccessException denied)
        {
            throw new IOException($"No permission to read '{path}'.", denied);
        }
    }
}
