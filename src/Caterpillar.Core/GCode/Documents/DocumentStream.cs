namespace Caterpillar.GCode;

/// <summary>Collects written text as the chunks of a document. What does not fit into memory is kept in a file.</summary>
internal sealed class DocumentStream : WriteStream
{
    private readonly PageFile<byte[]> _file = GCodeDocument.FileFor(MemoryLimit.Default);
    private readonly List<GCodeChunk> _chunks = [];
    private readonly MemoryStream _text = new();

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
        Add((int)_text.Length);
        return new GCodeDocument(_chunks.ToArray(), name);
    }

    public override void Write(byte[] buffer, int offset, int count)
    {
        _text.Write(buffer, offset, count);
        if (_text.Length >= GCodeChunk.Target) Add(ChunkReader.LastLineEnd(_text.GetBuffer(), (int)_text.Length));
    }

    // What follows the last line end is left for the next chunk.
    private void Add(int count)
    {
        if (count == 0) return;
        var text = _text.ToArray();
        _text.SetLength(0);
        _text.Write(text, count, text.Length - count);
        _chunks.Add(new GCodeChunk(text, 0, count).In(_file));
    }
}
