namespace Caterpillar.Files;

/// <summary>A stream that can only be read, from beginning to end.</summary>
internal abstract class ReadStream : OneWayStream
{
    public override bool CanRead => true;

    public override bool CanWrite => false;

    public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();

    /// <summary>Reads until the buffer is full or the stream ends. Returns the number of bytes.</summary>
    internal static int Fill(Stream stream, byte[] buffer, int from, int to)
    {
        while (from < to)
        {
            var read = stream.Read(buffer, from, to - from);
            if (read <= 0) break;
            from += read;
        }
        return from;
    }
}

/// <summary>A stream whose first bytes were read in advance and are returned again.</summary>
internal sealed class PeekedStream(byte[] head, int known, Stream rest) : ReadStream
{
    private int _taken;

    /// <summary>Reads the first bytes into <paramref name="head"/>. The returned stream still begins with them.</summary>
    public static Stream Peek(Stream stream, byte[] head, out int count)
    {
        count = Fill(stream, head, 0, head.Length);
        if (!stream.CanSeek) return new PeekedStream(head, count, stream);
        stream.Position -= count;
        return stream;
    }

    public override int Read(byte[] buffer, int offset, int count)
    {
        if (_taken >= known) return rest.Read(buffer, offset, count);
        var part = Math.Min(count, known - _taken);
        Buffer.BlockCopy(head, _taken, buffer, offset, part);
        _taken += part;
        return part;
    }

    protected override void Dispose(bool disposing)
    {
        if (disposing) rest.Dispose();
        base.Dispose(disposing);
    }
}
