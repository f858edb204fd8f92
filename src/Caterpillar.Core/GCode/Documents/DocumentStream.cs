namespace Caterpillar.GCode;

/// <summary>Collects written text as the chunks of a document. What does not fit into memory is kept in a file.</summary>
internal sealed class DocumentStream : WriteStream
{
    private readonly PageFile<byte[]> _file = GCodeDocument.FileFor(MemoryLimit.Default);
    private readonly List<GCodeChunk> _chunks = [];
    private byte[] _buffer = new byte[GCodeChunk.Target];
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
        if (_count > 0) Add(_count);
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
        var (before, cut) = (_buffer, ChunkReader.LastLineEnd(_buffer, _count));
        if (cut > 0) Add(cut);
        _count -= cut;
        _buffer = new byte[(int)Math.Min(Math.Max(GCodeChunk.Target, _count * 2L), ChunkReader.LongestLine * 2L - 64)];
        Buffer.BlockCopy(before, cut, _buffer, 0, _count);
    }

    private void Add(int count) => _chunks.Add(new GCodeChunk(_buffer, 0, count).In(_file));
}
