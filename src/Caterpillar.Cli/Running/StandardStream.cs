namespace Caterpillar.Cli;

/// <summary>Standard output, or standard error, which may be closed: nobody reads the messages then, but the work goes on.</summary>
internal sealed class StandardStream(Stream inner, bool isForMessages) : WriteStream
{
    public override void Write(byte[] buffer, int offset, int count)
    {
        try
        {
            inner.Write(buffer, offset, count);
        }
        catch (Exception closed) when (closed is IOException or UnauthorizedAccessException)
        {
            if (!isForMessages) throw new IOException("Standard output cannot be written: it is closed or full.", closed);
        }
    }

    public override void Flush() => inner.Flush();
}
