using System;
using System.IO;
using Caterpillar.Files;

namespace Caterpillar.Cli;

/// <summary>Writes through to another stream, which stays open, and counts the bytes and lines (which LF, CRLF and CR end) of what is written.</summary>
internal sealed class CountingStream(Stream inner) : WriteStream
{
    private int _ends;
    private byte _last = (byte)'\n';

    public long Bytes { get; private set; }

    /// <summary>Lines so far; what follows the last line end is one, too.</summary>
    public int Lines => _ends + (_last is (byte)'\n' or (byte)'\r' ? 0 : 1);

    public override void Write(byte[] buffer, int offset, int count) => Write(buffer.AsSpan(offset, count));

    public override void Write(ReadOnlySpan<byte> text)
    {
        if (text.IsEmpty) return;
        inner.Write(text);
        Bytes += text.Length;
        _ends += text.Count((byte)'\n');
        if (text.Contains((byte)'\r')) _ends += text.Count((byte)'\r') - text.Count("\r\n"u8);
        if (_last == '\r' && Bytes > text.Length && text[0] == '\n') _ends--;
        _last = text[^1];
    }

    public override void Flush() => inner.Flush();
}
