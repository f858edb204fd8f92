namespace Caterpillar.Files;

/// <summary>
/// Writes to another stream on its own thread, so that writing does not wait. Everything is written after <see cref="Finish"/>. An error of the other stream
/// is thrown by the next write or by <see cref="Finish"/>.
/// </summary>
internal sealed class QueuedStream(Stream target) : WriteStream
{
    private readonly BytePipe _pipe = new();
    private Task? _writing;

    public override void Write(byte[] buffer, int offset, int count)
    {
        _writing ??= OwnThread.Run(Pass);
        if (_writing.IsFaulted) _writing.GetAwaiter().GetResult();
        _pipe.Write(buffer, offset, count);
    }

    /// <summary>Waits until everything is written.</summary>
    public void Finish()
    {
        _pipe.Complete();
        _writing?.GetAwaiter().GetResult();
    }

    protected override void Dispose(bool disposing)
    {
        if (disposing)
        {
            _pipe.Complete();
            // Whoever wants to know of its problem has asked before.
            if (_writing is not null) OwnThread.Wait(_writing);
            _pipe.Dispose();
        }
        base.Dispose(disposing);
    }

    private void Pass()
    {
        try
        {
            _pipe.CopyTo(target);
        }
        finally
        {
            _pipe.Stop();
        }
    }
}
