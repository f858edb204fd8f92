using Caterpillar.Files;

namespace Caterpillar.Cli;

/// <summary>Reads a stream that may block forever (standard input), and stops waiting when the work is canceled.</summary>
internal sealed class StoppableStream(Stream inner, CancellationToken cancel) : ReadStream
{
    public override int Read(byte[] buffer, int offset, int count)
    {
        var read = Task.Run(() => inner.Read(buffer, offset, count), cancel);
        try
        {
            read.Wait(cancel);
        }
        catch (AggregateException failed)
        {
            throw failed.InnerException!;
        }
        return read.Result;
    }
}
