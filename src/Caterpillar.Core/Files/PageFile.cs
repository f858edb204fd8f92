namespace Caterpillar.Files;

/// <summary>
/// Keeps data of any length in parts: all in memory, or, if that is too much, the latest up to a quarter of it, and the others in a temporary file, which is
/// deleted as soon as nothing uses it any more. Thread-safe.
/// </summary>
/// <param name="memory">Bytes in memory.</param>
/// <param name="size">The bytes of a part.</param>
/// <param name="write">Writes a part.</param>
/// <param name="read">Reads it again.</param>
internal sealed class PageFile<T>(long memory, Func<T, long> size, Action<BinaryWriter, T> write, Func<BinaryReader, T> read)
    where T : class
{
    private const int BufferSize = 64 * 1024;

    // Parts in memory, whatever their size.
    private const int Least = 2;
    private readonly Queue<Page<T>> _inMemory = new();
    private long _bytes;
    private bool _isTooMuch;
    private BinaryWriter? _writer;
    private BinaryReader? _reader;

    /// <summary>Adds a part, which does not change any more.</summary>
    /// <exception cref="IOException">The temporary folder has no room.</exception>
    public Page<T> Add(T value)
    {
        var page = new Page<T>(this);
        lock (_inMemory) Keep(page, value);
        return page;
    }

    /// <summary>A part that is not in memory.</summary>
    internal T Load(Page<T> page)
    {
        lock (_inMemory)
        {
            if (page.InMemory is { } known) return known;
            _reader!.BaseStream.Position = page.At;
            var value = read(_reader);
            Keep(page, value);
            return value;
        }
    }

    private void Keep(Page<T> page, T value)
    {
        page.InMemory = value;
        _inMemory.Enqueue(page);
        _bytes += size(value);
        // Whoever reads one part after the other meets none in memory, however many there are.
        _isTooMuch |= _bytes > memory;
        while (_bytes > (_isTooMuch ? memory / 4 : memory) && _inMemory.Count > Least)
        {
            var oldest = _inMemory.Dequeue();
            _bytes -= size(oldest.InMemory!);
            if (oldest.At < 0) Write(oldest);
            oldest.InMemory = null;
        }
    }

    private void Write(Page<T> page)
    {
        if (_writer is null)
        {
            var file = Open();
            (_writer, _reader) = (new BinaryWriter(file), new BinaryReader(file));
        }
        page.At = _writer.BaseStream.Seek(0, SeekOrigin.End);
        write(_writer, page.InMemory!);
    }

    private static FileStream Open()
    {
        var path = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N"));
        var file = new FileStream(path, FileMode.CreateNew, FileAccess.ReadWrite, FileShare.Delete, BufferSize, FileOptions.DeleteOnClose);
        // Where an open file can be deleted, nothing is left of it even if the program is killed.
        if (Path.DirectorySeparatorChar == '/') File.Delete(path);
        return file;
    }
}

/// <summary>A part of a <see cref="PageFile{T}"/>.</summary>
internal sealed class Page<T>(PageFile<T> file)
    where T : class
{
    private T? _inMemory;

    /// <summary>The part. It is read again if it is not in memory.</summary>
    public T Value => InMemory ?? file.Load(this);

    internal T? InMemory
    {
        get => Volatile.Read(ref _inMemory);
        set => Volatile.Write(ref _inMemory, value);
    }

    /// <summary>Its place in the file; −1 = not written yet.</summary>
    internal long At { get; set; } = -1;
}
