using System.IO;
using System.Security.Cryptography;

namespace Caterpillar.Cli;

/// <summary>Reads through another stream and adds what was read to a hash.</summary>
internal sealed class HashingStream(Stream inner, IncrementalHash hash) : ReadStream
{
    public override bool CanSeek => inner.CanSeek;

    public override long Length => inner.Length;

    public override int Read(byte[] buffer, int offset, int count)
    {
        var read = inner.Read(buffer, offset, count);
        hash.AppendData(buffer, offset, read);
        return read;
    }
}
