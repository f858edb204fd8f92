namespace Caterpillar.Files;

/// <summary>Writes to another stream, which stays open, and counts the written bytes and lines (LF, CRLF or CR).</summary>
internal sealed class CountingStream(Stream inner) : WriteStream
{
    private int _ends;
    private byte _last = (byte)'\n';

    public long Bytes { get; private set; }

    /// <summary>Lines so far. Text after the last line end is a line, too.</summary>
    public int Lines => _ends + (_last is (byte)'\n' or (byte)'\r' ? 0 : 1);

    public override void Write(byte[] buffer, int offset, int count)
    {
        if (count == 0) return;
        inner.Write(buffer, offset, count);
        if (Bytes > 0 && _last == '\r' && buffer[offset] == '\n') _ends--;
        Bytes += count;
        _last = buffer[offset + count - 1];
#if NET8_0_OR_GREATER
        var text = buffer.AsSpan(offset, count);
        _ends += text.Count((byte)'\n');
        if (text.Contains((byte)'\r')) _ends += text.Count((byte)'\r') - text.Count("\r\n"u8);
#else
        for (var i = offset; i < offset + count; i++)
        {
            if (buffer[i] == '\r' || (buffer[i] == '\n' && (i == offset || buffer[i - 1] != '\r'))) _ends++;
        }
#endif
    }

    public override void Flush() => inner.Flush();
}
