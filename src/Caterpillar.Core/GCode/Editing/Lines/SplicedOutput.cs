namespace Caterpillar.GCode;

/// <summary>
/// Writes the parts of a spliced file to a stream, on its own thread if asked, so that splicing does not wait. Everything is written after
/// <see cref="Finish"/>. An error of the stream is thrown by the next <see cref="Write"/> or by <see cref="Finish"/>.
/// </summary>
internal sealed class SplicedOutput(Stream target, LineStyle style, bool hasThread) : IDisposable
{
    private const int MostWaiting = 4;
    private readonly BlockingCollection<SplicedChunk> _waiting = new(MostWaiting);
    private readonly ConcurrentBag<SplicedChunk> _free = [];
    private byte[] _buffer = [];
    private volatile bool _isStopped;
    private Task? _writing;

    /// <summary>An empty part, perhaps one that was written before.</summary>
    public SplicedChunk NewChunk() => _free.TryTake(out var chunk) ? chunk : new SplicedChunk();

    public void Write(SplicedChunk chunk)
    {
        if (!hasThread)
        {
            WriteNow(chunk);
            return;
        }
        _writing ??= OwnThread.Run(WriteAll);
        if (_writing.IsFaulted) _writing.GetAwaiter().GetResult();
        while (!_isStopped && !_waiting.TryAdd(chunk, 20))
        {
        }
    }

    /// <summary>Waits until everything is written.</summary>
    public void Finish()
    {
        _waiting.CompleteAdding();
        _writing?.GetAwaiter().GetResult();
    }

    public void Dispose()
    {
        _waiting.CompleteAdding();
        // Whoever wants to know of its problem has asked before.
        if (_writing is not null) OwnThread.Wait(_writing);
        _waiting.Dispose();
    }

    private void WriteAll()
    {
        try
        {
            while (_waiting.TryTake(out var chunk, -1)) WriteNow(chunk);
        }
        finally
        {
            _isStopped = true;
        }
    }

    private void WriteNow(SplicedChunk chunk)
    {
        chunk.WriteTo(target, style, ref _buffer);
        _free.Add(chunk);
    }
}
