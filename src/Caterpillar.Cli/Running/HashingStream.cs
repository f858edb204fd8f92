using System.Security.Cryptography;

namespace Caterpillar.Cli;

/// <summary>
/// Reads through another stream and hashes what was read. A reader may look ahead and seek back: every byte is hashed once, in the order of the file.
/// </summary>
internal sealed class HashingStream(Stream inner, IncrementalHash hash) : ReadStream
{
    private long _hashed;

    public override bool CanSeek => inner.CanSeek;

    public override long Length => inner.Length;

    public override long Position
    {
        get => inner.Position;
        set => inner.Position = value;
    }

    public override long Seek(long offset, SeekOrigin origin) => inner.Seek(offset, origin);

    public override int Read(byte[] buffer, int offset, int count)
    {
        var at = inner.CanSeek ? inner.Position : _hashed;
        var read = inner.Read(buffer, offset, count);
        var known = _hashed - at;
        if (known >= 0 && known < read)
        {
            hash.AppendData(buffer, offset + (int)known, read - (int)known);
            _hashed = at + read;
        }
        return read;
    }
}
