namespace Caterpillar.Cli;

/// <summary>Reads a stream that may block forever (standard input), and stops waiting when the work is canceled.</summary>
internal sealed class StoppableStream(Stream inner, CancellationToken cancel) : ReadStream
{
    protected override void Dispose(bool disposing)
    {
        if (disposing) inner.Dispose();
        base.Dispose(disposing);
    }

    public override int Read(byte[] buffer, int offset, int count)
    {
        var read = Task.Run(() => inner.Read(buffer, offset, count), cancel);
        OwnThread.WaitOr(read, cancel);
        return read.GetAwaiter().GetResult();
    }
}
