namespace Caterpillar.GCode;

/// <summary>
/// Writes Prusa's binary G-code (.bgcode, specification of libbgcode version 1): producer, printer metadata, thumbnails, settings, and the G-code in blocks of
/// 64 KB with heatshrink 12/4, all with checksums. Deflate is not used, because its bytes depend on the runtime. Reading it gives the same lines, except that
/// comments with a block of their own move to the beginning or the end. Lines end with LF.
/// </summary>
internal static class BinaryGCode
{
    private const int BlockText = 65536;

    /// <summary>True for the file names of binary G-code: .bgcode or .bgc.</summary>
    public static bool IsName(string file)
        => file.EndsWith(".bgcode", StringComparison.OrdinalIgnoreCase) || file.EndsWith(".bgc", StringComparison.OrdinalIgnoreCase);

    /// <summary>Writes a document.</summary>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    /// <exception cref="OperationCanceledException">Canceled. A part is written.</exception>
    public static void Write(GCodeDocument document, Stream stream, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        var tables = BinaryTables.Of(document, cancel);
        stream.Write([(byte)'G', (byte)'C', (byte)'D', (byte)'E', 1, 0, 0, 0, 1, 0], 0, 10);
        if (tables.File.Count > 0) Block(stream, BinaryBlockKind.File, 0, Text(tables.File), 0);
        Block(stream, BinaryBlockKind.Printer, 0, Text(tables.Printer), 0);
        foreach (var (image, data) in tables.Images) Block(stream, BinaryBlockKind.Thumbnail, 0, data,
            image.Format switch { "JPG" => 1, "QOI" => 2, _ => 0 }, image.Width, image.Height);
        Block(stream, BinaryBlockKind.Print, 0, Text(tables.Print), 0);
        // Readers want a table of settings, be it empty.
        var settings = Text(tables.Settings);
        Block(stream, BinaryBlockKind.Slicer, settings.Length > 0 ? 3 : 0, settings, 0);
        if (tables.Json is { } json) Block(stream, BinaryBlockKind.Slicer, json.Length > 0 ? 3 : 0, json, 1);
        Code(document, stream, tables, progress, cancel);
    }

    /// <summary>Writes a document as binary G-code if the file name asks for it, otherwise unchanged.</summary>
    /// <inheritdoc cref="Write" path="/exception"/>
    public static void WriteAs(string file, GCodeDocument document, Stream stream, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (IsName(file)) Write(document, stream, progress, cancel);
        else document.WriteTo(stream);
    }

    /// <summary>Writes text as binary G-code if the file name asks for it, otherwise unchanged. Empty text writes nothing.</summary>
    /// <inheritdoc cref="Write" path="/exception"/>
    public static void WriteAs(string file, Stream stream, Action<Stream> writeText, CancellationToken cancel = default)
    {
        if (!IsName(file))
        {
            writeText(stream);
            return;
        }
        using var text = new MemoryStream();
        writeText(text);
        if (text.Length > 0) Write(GCodeDocument.FromBytes(text.ToArray()), stream, null, cancel);
    }

    private static void Code(GCodeDocument document, Stream stream, BinaryTables tables, IProgress<double>? progress, CancellationToken cancel)
    {
        using var plain = new MemoryStream();
        var line = 0;
        var any = false;
        var chunks = document.Chunks;
        void Flush()
        {
            if (plain.Length == 0 && any) return;
            any = true;
            Block(stream, BinaryBlockKind.GCode, 3, plain.ToArray(), 0);
            plain.SetLength(0);
        }
        for (var i = 0; i < chunks.Count; i++)
        {
            cancel.ThrowIfCancellationRequested();
            progress?.Report((double)i / chunks.Count);
            var text = chunks[i].Text;
            var starts = chunks[i].LineStarts();
            for (var k = 0; k + 1 < starts.Length; k++)
            {
                if (tables.Holds(line++)) continue;
                var start = starts[k] + (line == 1 ? TextEncoding.MarkLength(chunks[0]) : 0);
                var end = LineEnds.Find(text, start, starts[k + 1]);
                if (plain.Length > 0 && plain.Length + end - start + 1 > BlockText) Flush();
                plain.Write(text, start, end - start);
                plain.WriteByte((byte)'\n');
            }
        }
        Flush();
        progress?.Report(1);
    }

    private static byte[] Text(IReadOnlyList<KeyValuePair<string, string>> table)
    {
        var text = new System.Text.StringBuilder();
        foreach (var pair in table) text.Append(pair.Key).Append('=').Append(pair.Value).Append('\n');
        return TextEncoding.Encode(text.ToString());
    }

    private static void Block(Stream stream, BinaryBlockKind kind, int compression, byte[] data, params int[] parameters)
    {
        var packed = compression == 0 ? data : Heatshrink.Pack(data, 12, 4);
        using var block = new MemoryStream();
        using var writer = new BinaryWriter(block);
        writer.Write((ushort)kind);
        writer.Write((ushort)compression);
        writer.Write(data.Length);
        if (compression != 0) writer.Write(packed.Length);
        foreach (var parameter in parameters) writer.Write((ushort)parameter);
        writer.Write(packed);
        writer.Write(Crc32.Of(block.GetBuffer(), 0, (int)block.Length));
        block.WriteTo(stream);
    }
}
