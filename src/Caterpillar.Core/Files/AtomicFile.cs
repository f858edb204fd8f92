namespace Caterpillar.Files;

/// <summary>
/// A file that is written completely or not at all. Bytes go to a temporary file next to it, which gets its name in <see cref="Commit"/>. Disposed before that,
/// it leaves no trace, and an older file does not change. Links stay links: their target is replaced. The new file gets the permissions of the older one. A
/// device or a pipe is written directly.
/// </summary>
internal sealed class AtomicFile : IDisposable
{
    // Names may have 255 bytes.
    private const int MaxNameLength = 60;
    private readonly string _target;
    private readonly string? _temporary;
    private FileStream? _stream;

    /// <exception cref="IOException">The folder does not exist or cannot be written, or the path is a folder.</exception>
    /// <exception cref="UnauthorizedAccessException">No permission to write it.</exception>
    public AtomicFile(string path)
    {
        _target = FileLinks.Target(Path.GetFullPath(path ?? throw new ArgumentNullException(nameof(path))));
        if (Directory.Exists(_target)) throw new IOException($"{path} is a folder, not a file.");
        if (!Directory.Exists(Path.GetDirectoryName(_target)!)) throw new DirectoryNotFoundException($"{path}: folder not found.");
        _stream = FileLinks.Special(_target);
        if (_stream is not null) return;
        var name = Path.GetFileName(_target);
        if (name.Length > MaxNameLength) name = name.Substring(0, MaxNameLength);
        _temporary = Path.Combine(Path.GetDirectoryName(_target)!, "." + name + "." + Path.GetRandomFileName());
        try
        {
            _stream = FileLinks.Create(_temporary, _target);
        }
        catch (UnauthorizedAccessException)
        {
            // The message would name the temporary file.
            throw new UnauthorizedAccessException($"Access to the path '{path}' is denied.");
        }
    }

    /// <summary>The temporary file to write to.</summary>
    public Stream Stream => _stream ?? throw new ObjectDisposedException(nameof(AtomicFile));

    /// <summary>False for a device or a pipe, which are written directly.</summary>
    public bool IsTemporary => _temporary is not null;

    /// <summary>Moves the file into place.</summary>
    /// <exception cref="IOException">The disk is full, or the older file cannot be replaced. It does not change.</exception>
    /// <exception cref="UnauthorizedAccessException">No permission to replace the older file.</exception>
    public void Commit()
    {
        try
        {
            Stream.Dispose();
            if (_temporary is not null) FileLinks.Replace(_temporary, _target);
        }
        catch
        {
            Dispose();
            throw;
        }
        _stream = null;
    }

    /// <summary>Removes the temporary file while another thread may still write it.</summary>
    public void Abandon()
    {
        try
        {
            if (_temporary is not null) File.Delete(_temporary);
        }
        catch (Exception open) when (open is IOException or UnauthorizedAccessException)
        {
        }
    }

    public void Dispose()
    {
        if (_stream is null) return;
        try
        {
            _stream.Dispose();
        }
        finally
        {
            _stream = null;
            if (_temporary is not null) File.Delete(_temporary);
        }
    }
}
