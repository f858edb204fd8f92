using System.IO;
using System.IO.Compression;

namespace Caterpillar.Cli;

/// <summary>Opens files that may be packed with gzip.</summary>
internal static class Unpacked
{
    /// <summary>The unpacked bytes of a stream.</summary>
    public static Stream Open(Stream stream)
    {
        // Two bytes tell; a stream that cannot go back gets them handed on.
        var head = new byte[2];
        var count = 0;
        for (int read; count < 2 && (read = stream.Read(head, count, 2 - count)) > 0;) count += read;
        var packed = count == 2 && head[0] == 0x1F && head[1] == 0x8B;
        if (stream.CanSeek) stream.Position -= count;
        else stream = new Rejoined(head, count, stream);
        return packed ? new GZipStream(stream, CompressionMode.Decompress) : stream;
    }

    private sealed class Rejoined(byte[] head, int headCount, Stream rest) : ReadStream
    {
        private int _taken;

        public override int Read(byte[] buffer, int offset, int count)
        {
            var taken = 0;
            while (_taken < headCount && taken < count) buffer[offset + taken++] = head[_taken++];
            return taken > 0 || count == 0 ? taken : rest.Read(buffer, offset, count);
        }

        protected override void Dispose(bool disposing)
        {
            if (disposing) rest.Dispose();
            base.Dispose(disposing);
        }
    }
}
