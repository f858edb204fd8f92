using Caterpillar.Basics;

namespace Caterpillar.Files;

/// <summary>
/// Writes to another stream on a thread of its own, so that who writes to this one can go on meanwhile. All is written after <see cref="Finish"/>. A problem
/// of the other stream comes up in the next write, or there.
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

    /// <summary>Waits until all is written.</summary>
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
