using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Threading;

namespace Caterpillar.GCode;

/// <summary>Reads a stream into chunks that end behind line ends; gzip and binary G-code are recognized by their first bytes.</summary>
internal static class ChunkReader
{
    public static IEnumerable<GCodeChunk> Read(Stream stream, int bufferSize, CancellationToken cancel)
    {
        var head = new byte[4];
        var known = Fill(stream, head, 0);
        if (BinaryGCode.IsBinary(head, known))
        {
            using var whole = new MemoryStream();
            whole.Write(head, 0, known);
            stream.CopyTo(whole);
            var text = BinaryGCode.Unpack(whole.ToArray(), cancel);
            var pieces = new List<GCodeChunk>();
            GCodeDocument.Cut(text, text.Length, pieces);
            foreach (var piece in pieces) yield return piece;
            yield break;
        }
        if (!GCodeDocument.IsGzip(head, known))
        {
            foreach (var chunk in Plain(stream, head, known, bufferSize, cancel)) yield return chunk;
            yield break;
        }
        var packed = new Joined(head, known, stream);
        using var unpacked = new GZipStream(packed, CompressionMode.Decompress, true);
        long length = 0;
        foreach (var chunk in Plain(unpacked, head, 0, bufferSize, cancel))
        {
            length += chunk.Length;
            yield return chunk;
        }
        // The runtimes take the end of a cut-off file for the end of its text; its last bytes tell the length.
        if (packed.StatedLength is not { } stated || length < stated) throw new InvalidDataException("It is cut off.");
    }

    private static IEnumerable<GCodeChunk> Plain(Stream stream, byte[] head, int known, int bufferSize, CancellationToken cancel)
    {
        var buffer = new byte[bufferSize];
        Buffer.BlockCopy(head, 0, buffer, 0, known);
        var count = known;
        var chunks = new List<GCodeChunk>();
        while (true)
        {
            cancel.ThrowIfCancellationRequested();
            count = Fill(stream, buffer, count);
            var last = count < buffer.Length;
            var cut = last ? count : LastLineEnd(buffer, count);
            if (cut == 0 && !last)
            {
                Array.Resize(ref buffer, checked(buffer.Length * 2));
                continue;
            }
            chunks.Clear();
            GCodeDocument.Cut(buffer, cut, chunks);
            foreach (var chunk in chunks) yield return chunk;
            if (last) yield break;
            var next = new byte[Math.Max(bufferSize, (count - cut) * 2)];
            Buffer.BlockCopy(buffer, cut, next, 0, count - cut);
            count -= cut;
            buffer = next;
        }
    }

    // Index behind the last line end; a CR at the very end may be half of a CRLF and is left for the next buffer.
    private static int LastLineEnd(byte[] buffer, int count)
    {
        var at = count - 1;
        if (at >= 0 && buffer[at] == '\r') at--;
        while (at >= 0 && buffer[at] != '\n' && buffer[at] != '\r') at--;
        return at + 1;
    }

    private static int Fill(Stream stream, byte[] buffer, int count)
    {
        while (count < buffer.Length)
        {
            var read = stream.Read(buffer, count, buffer.Length - count);
            if (read <= 0) break;
            count += read;
        }
        return count;
    }

    // Bytes that were looked at, and then the rest of the stream.
    private sealed class Joined(byte[] head, int count, Stream rest) : Stream
    {
        private readonly byte[] _last = new byte[4];
        private int _at;
        private long _read;

        /// <summary>The unpacked length in the last bytes (that of the last member), or null where there is no trailer.</summary>
        public long? StatedLength => _read < 18 ? null : _last[0] + 256L * (_last[1] + 256L * (_last[2] + 256L * _last[3]));

        public override bool CanRead => true;

        public override bool CanSeek => false;

        public override bool CanWrite => false;

        public override long Length => throw new NotSupportedException();

        public override long Position
        {
            get => throw new NotSupportedException();
            set => throw new NotSupportedException();
        }

        public override int Read(byte[] buffer, int offset, int length)
        {
            var part = _at < count ? Math.Min(length, count - _at) : rest.Read(buffer, offset, length);
            if (_at < count) Buffer.BlockCopy(head, _at, buffer, offset, part);
            _at = Math.Min(_at + part, count);
            for (var i = Math.Max(part - 4, 0); i < part; i++)
            {
                Buffer.BlockCopy(_last, 1, _last, 0, 3);
                _last[3] = buffer[offset + i];
            }
            _read += part;
            return part;
        }

        public override void Flush()
        {
        }

        public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

        public override void SetLength(long value) => throw new NotSupportedException();

        public override void Write(byte[] buffer, int offset, int length) => throw new NotSupportedException();
    }
}
