namespace Caterpillar.GCode;

/// <summary>Collects written text as the chunks of a document, without another copy.</summary>
internal sealed class DocumentStream : WriteStream
{
    private const int FirstBuffer = 64 * 1024;
    private const int LargestBuffer = 4 * 1024 * 1024;
    private readonly List<GCodeChunk> _chunks = [];
    private byte[] _buffer = new byte[FirstBuffer];
    private int _count;

    /// <summary>The document that is written, unless there are errors.</summary>
    public static Result<GCodeDocument> Collect(Func<Stream, IReadOnlyList<Diagnostic>> write, string? name)
    {
        using var memory = new DocumentStream();
        var failed = new Result<GCodeDocument>(null, write(memory));
        return failed.HasErrors ? failed : new Result<GCodeDocument>(memory.ToDocument(name ?? ""), failed.Diagnostics);
    }

    /// <summary>Returns the document. Do not write afterwards.</summary>
    public GCodeDocument ToDocument(string name)
    {
        GCodeChunk.Cut(_buffer, _count, _chunks);
        return new GCodeDocument(_chunks.ToArray(), name);
    }

    public override void Write(byte[] buffer, int offset, int count)
    {
        while (count > 0)
        {
            if (_count == _buffer.Length) Seal();
            var part = Math.Min(count, _buffer.Length - _count);
            Buffer.BlockCopy(buffer, offset, _buffer, _count, part);
            _count += part;
            offset += part;
            count -= part;
        }
    }

    // What follows the last line end goes into the next buffer; a longer line makes it longer.
    private void Seal()
    {
        var cut = ChunkReader.LastLineEnd(_buffer, _count);
        GCodeChunk.Cut(_buffer, cut, _chunks);
        var rest = _count - cut;
        var next = new byte[(int)Math.Min(Math.Max(Math.Min(_buffer.Length * 4L, LargestBuffer), rest * 2L), ChunkReader.LongestLine * 2L - 64)];
        Buffer.BlockCopy(_buffer, cut, next, 0, rest);
        (_buffer, _count) = (next, rest);
    }
}
