namespace Caterpillar.GCode;

/// <summary>Reads a stream of text into chunks that end after line ends.</summary>
internal static class ChunkReader
{
    // What is packed may be small; a plain file says its size.
    private const int FirstBuffer = 64 * 1024;

    // A line is in one piece of memory.
    public const int LongestLine = 1 << 29;

    /// <exception cref="IOException">The stream cannot be read.</exception>
    /// <exception cref="InvalidDataException">A line is longer than <paramref name="longestLine"/> bytes, or packed data is broken.</exception>
    public static IEnumerable<GCodeChunk> Read(Stream stream, int bufferSize, CancellationToken cancel, int longestLine = LongestLine)
    {
        var buffer = new byte[Math.Min(bufferSize, stream.CanSeek ? stream.Length - stream.Position + 1 : FirstBuffer)];
        var count = 0;
        // One more byte shows whether the line ends there.
        var largest = longestLine + 1L;
        var chunks = new List<GCodeChunk>();
        while (true)
        {
            cancel.ThrowIfCancellationRequested();
            count = ReadStream.Fill(stream, buffer, count, buffer.Length);
            var last = count < buffer.Length;
            var cut = last ? count : LastLineEnd(buffer, count);
            if (cut == 0 && !last)
            {
                if (buffer.Length >= largest) throw new InvalidDataException($"A line is longer than {NumberFormatter.Format(longestLine)} bytes.");
                Array.Resize(ref buffer, (int)Math.Min(buffer.Length * 2L, largest));
                continue;
            }
            chunks.Clear();
            GCodeChunk.Cut(buffer, cut, chunks);
            foreach (var chunk in chunks) yield return chunk;
            if (last) yield break;
            var next = Buffers.Unfilled<byte>((int)Math.Max(Math.Min(bufferSize, buffer.Length * 4L), Math.Min((count - cut) * 2L, largest)));
            Buffer.BlockCopy(buffer, cut, next, 0, count - cut);
            count -= cut;
            buffer = next;
        }
    }

    // Index after the last line end; a CR at the very end may be half of a CRLF and is left for the next buffer.
    public static int LastLineEnd(byte[] buffer, int count)
    {
        var at = count - 1;
        if (at >= 0 && buffer[at] == '\r') at--;
        while (at >= 0 && buffer[at] != '\n' && buffer[at] != '\r') at--;
        return at + 1;
    }
}
