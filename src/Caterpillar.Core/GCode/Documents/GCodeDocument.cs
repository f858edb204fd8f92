namespace Caterpillar.GCode;

/// <summary>
/// A G-code file, with every byte unchanged. Lines end with LF, CRLF or CR, also mixed. A byte order mark belongs to the first line but not to its text. Lines
/// are indexed without copying. Immutable.
/// </summary>
public sealed class GCodeDocument
{
    private const long BytesInMemory = 96L << 20;
    private readonly GCodeChunk[] _chunks;
    private int[]? _firstLines;

    internal GCodeDocument(GCodeChunk[] chunks, string name, IReadOnlyList<Diagnostic>? notes = null)
    {
        _chunks = chunks;
        Name = name;
        Notes = notes ?? [];
        foreach (var chunk in chunks) Length += chunk.Length;
    }

    /// <summary>Name of the file, or empty.</summary>
    public string Name { get; }

    /// <summary>Number of bytes (unpacked).</summary>
    public long Length { get; }

    /// <summary>Number of lines, at most 2147483647. Text after the last line end counts as a line if it is not empty.</summary>
    public int LineCount => FirstLines().Last();

    internal IReadOnlyList<GCodeChunk> Chunks => _chunks;

    /// <summary>Diagnostics of unpacking.</summary>
    internal IReadOnlyList<Diagnostic> Notes { get; }

    /// <summary>
    /// A document from bytes. They are not copied: do not change them afterwards. Gzip and binary G-code are unpacked. Of binary G-code, only the text is
    /// kept.
    /// </summary>
    /// <exception cref="InvalidDataException">The bytes are a broken gzip or binary G-code file, or a line is longer than 512 MB.</exception>
    public static GCodeDocument FromBytes(byte[] bytes, string name = "")
    {
        if (bytes is null) throw new ArgumentNullException(nameof(bytes));
        if (GCodeSource.IsPacked(bytes, bytes.Length)) return Unpack(new MemoryStream(bytes, false), name, MemoryLimit.Default, default);
        var chunks = new List<GCodeChunk>(bytes.Length / GCodeChunk.Target + 1);
        GCodeChunk.Cut(bytes, bytes.Length, chunks);
        return new GCodeDocument(chunks.ToArray(), name);
    }

    /// <summary>A document from text. Characters beyond Latin-1 are written as UTF-8.</summary>
    public static GCodeDocument FromText(string text, string name = "") => FromBytes(TextEncoding.Encode(text), name);

    /// <summary>Reads a file: plain, packed with gzip, or binary G-code (.bgcode).</summary>
    /// <returns>The document, or the error <c>gcode.compression</c> if gzip or binary G-code is broken. Decoding reports everything else.</returns>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static Result<GCodeDocument> ReadFile(string path, CancellationToken cancel = default)
    {
        using var stream = InputFile.Open(path);
        return Read(stream, Path.GetFileName(path), null, cancel);
    }

    /// <summary>
    /// Reads a stream to its end: plain, packed with gzip, or binary G-code. The stream stays open. Text that does not fit into a part of the memory limit is
    /// kept in a temporary file.
    /// </summary>
    /// <inheritdoc cref="ReadFile" path="/returns"/>
    /// <exception cref="IOException">The stream cannot be read.</exception>
    public static Result<GCodeDocument> Read(Stream stream, string name = "", MemoryLimit? memory = null, CancellationToken cancel = default)
    {
        if (stream is null) throw new ArgumentNullException(nameof(stream));
        return Guarded(name, () => new Result<GCodeDocument>(Unpack(stream, name, memory ?? MemoryLimit.Default, cancel), []));
    }

    /// <summary>A line by its number, from 1, without its line end. Each byte is one character (Latin-1).</summary>
    public string Line(int number)
    {
        if (number < 1 || number > LineCount) throw new ArgumentOutOfRangeException(nameof(number), "The document has no line with this number.");
        var first = FirstLines();
        var at = Array.BinarySearch(first, number - 1);
        if (at < 0) at = ~at - 1;
        while (first[at + 1] == first[at]) at++;
        var (starts, text, index) = (_chunks[at].LineStarts(), _chunks[at].Text, number - 1 - first[at]);
        var start = starts[index] + (number == 1 ? TextEncoding.MarkLength(_chunks[0]) : 0);
        return TextEncoding.Decode(text, start, LineEnds.Find(text, start, starts[index + 1]));
    }

    /// <summary>Up to <paramref name="count"/> lines from line <paramref name="first"/> (from 1) on.</summary>
    public IReadOnlyList<string> Lines(int first, int count)
    {
        var last = (int)Math.Min((long)first + count - 1, LineCount);
        var lines = new List<string>();
        for (var number = Math.Max(first, 1); number <= last; number++) lines.Add(Line(number));
        return lines;
    }

    /// <summary>Writes the document byte for byte.</summary>
    public void WriteTo(Stream stream)
    {
        foreach (var chunk in _chunks) chunk.WriteTo(stream);
    }

    /// <summary>Writes the whole file or nothing. Binary G-code if its name ends in .bgcode.</summary>
    /// <exception cref="IOException">The file cannot be written.</exception>
    /// <exception cref="OperationCanceledException">Canceled. No part of the file is left.</exception>
    public void WriteFile(string path, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        using var file = new AtomicFile(path);
        BinaryGCode.WriteAs(path, this, file.Stream, progress, cancel);
        file.Commit();
    }

    /// <summary>A copy of the bytes.</summary>
    /// <exception cref="InvalidOperationException">The document is larger than an array can be (2 GB). Use <see cref="WriteTo"/>.</exception>
    public byte[] ToBytes()
    {
        if (Length > int.MaxValue - 64) throw new InvalidOperationException("The document is larger than 2 GB. Write it to a stream.");
        var bytes = new byte[Length];
        var at = 0;
        foreach (var chunk in _chunks)
        {
            Buffer.BlockCopy(chunk.Text, chunk.Start, bytes, at, chunk.Length);
            at += chunk.Length;
        }
        return bytes;
    }

    /// <summary>Name, lines and size, for a panel.</summary>
    public override string ToString()
        => (Name.Length > 0 ? Name + ": " : "") + NumberFormatter.Format(LineCount) + " lines, " + NumberFormatter.Format(Length) + " bytes of G-code";

    /// <summary>Number of lines before each chunk, and of all.</summary>
    internal int[] FirstLines()
    {
        var known = Volatile.Read(ref _firstLines);
        if (known is not null) return known;
        var first = new int[_chunks.Length + 1];
        for (var i = 0; i < _chunks.Length; i++) first[i + 1] = AddLines(first[i], _chunks[i].CountLines());
        Volatile.Write(ref _firstLines, first);
        return first;
    }

    /// <summary>A file for text. The latest is in memory, up to a quarter of a limit.</summary>
    internal static PageFile<byte[]> FileFor(MemoryLimit memory)
        => new(Math.Min(BytesInMemory, memory.Bytes / 4), text => text.Length, WritePage, r => r.ReadBytes(r.ReadInt32()));

    /// <summary>Collects the chunks of a stream while they are read. Those that do not fit into memory are kept in a file.</summary>
    internal static IEnumerable<GCodeChunk> Kept(IEnumerable<GCodeChunk> chunks, List<GCodeChunk> kept, MemoryLimit memory)
    {
        var file = FileFor(memory);
        foreach (var chunk in chunks)
        {
            kept.Add(chunk.In(file));
            yield return kept[kept.Count - 1];
        }
    }

    /// <summary>A number of lines, which is an int.</summary>
    /// <exception cref="InvalidDataException">The number is too large.</exception>
    internal static int AddLines(int lines, int more)
        => lines <= int.MaxValue - more ? lines + more : throw new InvalidDataException("It has more than 2147483647 lines.");

    /// <summary>The result of work on a text, or the error for packed bytes that cannot be unpacked, or for too many lines.</summary>
    internal static Result<T> Guarded<T>(string name, Func<Result<T>> work)
        where T : class
    {
        try
        {
            return work();
        }
        catch (InvalidDataException broken)
        {
            var file = name.Length > 0 ? new SourceLocation(name) : null;
            return new Result<T>("gcode.compression", "The file cannot be read. " + broken.Message, file);
        }
    }

    private static GCodeDocument Unpack(Stream stream, string name, MemoryLimit memory, CancellationToken cancel)
    {
        using var source = new GCodeSource(stream);
        var chunks = new List<GCodeChunk>();
        foreach (var _ in Kept(ChunkReader.Read(source.Text, GCodeChunk.Target, cancel), chunks, memory)) continue;
        return new GCodeDocument(chunks.ToArray(), name, source.Notes());
    }

    private static void WritePage(BinaryWriter writer, byte[] text)
    {
        writer.Write(text.Length);
        writer.Write(text);
    }
}
