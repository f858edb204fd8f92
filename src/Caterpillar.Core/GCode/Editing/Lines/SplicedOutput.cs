namespace Caterpillar.GCode;

/// <summary>
/// Writes the parts of a spliced file to a stream, one at a time, in the background if requested. Everything is written after <see cref="Finish"/>. An error
/// of the stream is thrown by the next <see cref="Write"/> or by <see cref="Finish"/>.
/// </summary>
internal sealed class SplicedOutput(Stream target, LineStyle style, bool hasThread) : IDisposable
{
    private byte[] _buffer = [];
    private SplicedChunk? _free;
    private Task _writing = Task.CompletedTask;

    /// <summary>An empty part, perhaps one that was written before.</summary>
    public SplicedChunk NewChunk() => Interlocked.Exchange(ref _free, null) ?? new SplicedChunk();

    public void Write(SplicedChunk chunk)
    {
        Finish();
        if (hasThread) _writing = Task.Run(() => WriteNow(chunk));
        else WriteNow(chunk);
    }

    /// <summary>Waits until everything is written.</summary>
    public void Finish() => _writing.GetAwaiter().GetResult();

    // Whoever wants to know of its problem has asked before.
    public void Dispose() => OwnThread.Wait(_writing);

    private void WriteNow(SplicedChunk chunk)
    {
        chunk.WriteTo(target, style, ref _buffer);
        _free = chunk;
    }
}
