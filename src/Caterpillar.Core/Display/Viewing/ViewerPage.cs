namespace Caterpillar.Display;

/// <summary>
/// A web page that shows a print or a model in 3D: extrusions in true size, colors by role, speed and more, sliders for layers and time, the print head, the
/// lines of the file, and findings. A single file without dependencies, for browsers with WebGL 2.
/// </summary>
public static class ViewerPage
{
    private static readonly string[] Scripts = ["unpack.js", "colors.js", "camera.js", "shapes.js", "scene.js", "frames.js", "range.js", "panel.js", "main.js"];

    /// <summary>Writes the page in UTF-8.</summary>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public static void Write(ViewerContent content, Stream stream, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (content is null) throw new ArgumentNullException(nameof(content));
        if (stream is null) throw new ArgumentNullException(nameof(stream));
        var moves = content.Toolpath is null ? null : MoveColumns.Of(content, progress, cancel);
        Fill("viewer.html", stream, (name, text) => Part(name, text, content, moves, cancel));
    }

    /// <summary>
    /// Writes the page as a script, which gives any other page the element <c>caterpillar-viewer</c> to show it in. The script needs no other file.
    /// </summary>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    internal static void WriteScript(ViewerContent content, Stream stream, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        using var page = new MemoryStream();
        Write(content, page, progress, cancel);
        var html = Encoding.UTF8.GetString(page.GetBuffer(), 0, (int)page.Length);
        // Only ASCII, whatever encoding the other page has.
        Fill("element.js", stream, (name, text)
            => text.Write(JsonConvert.ToString(name == "title" ? content.Title : html, '"', StringEscapeHandling.EscapeNonAscii)));
    }

    /// <summary>Writes the page to a file, completely or not at all; a script where the file ends in .js.</summary>
    /// <exception cref="IOException">The file cannot be written.</exception>
    /// <exception cref="OperationCanceledException">Canceled. No part of the file is left.</exception>
    public static void WriteFile(ViewerContent content, string path, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (path is null) throw new ArgumentNullException(nameof(path));
        using var file = new AtomicFile(path);
        if (IsScript(path)) WriteScript(content, file.Stream, progress, cancel);
        else Write(content, file.Stream, progress, cancel);
        file.Commit();
    }

    internal static bool IsScript(string path) => path.EndsWith(".js", StringComparison.OrdinalIgnoreCase);

    // A template, whose places are filled.
    private static void Fill(string template, Stream stream, Action<string, TextWriter> part)
    {
        using var text = new StreamWriter(stream, new UTF8Encoding(false), 1 << 16, leaveOpen: true) { NewLine = "\n" };
        foreach (var piece in Resource(template).Split(new[] { "{{" }, StringSplitOptions.None))
        {
            var end = piece.IndexOf("}}", StringComparison.Ordinal);
            if (end >= 0) part(piece.Substring(0, end), text);
            text.Write(end >= 0 ? piece.Substring(end + 2) : piece);
        }
    }

    private static void Part(string name, TextWriter text, ViewerContent content, MoveColumns? moves, CancellationToken cancel)
    {
        switch (name)
        {
            case "title": text.Write(Escaped(content.Title)); break;
            case "style": text.Write(Resource("viewer.css")); break;
            case "head": text.Write(PageHead.ToJson(content, moves)); break;
            case "moves": if (moves is not null) Packed(text, moves.All.Select(column => column.ToBytes()), cancel); break;
            case "model": if (content.Model is { TriangleCount: > 0 } model) Packed(text, ModelColumns.Of(model), cancel); break;
            case "gcode": if (content.GCode is { } code) GCode(text, code, cancel); break;
            case "script": foreach (var script in Scripts) text.Write(Resource(script)); break;
            default: throw new InvalidOperationException($"The page has no part {name}.");
        }
    }

    private static void GCode(TextWriter text, byte[] code, CancellationToken cancel)
    {
        using var lines = new MemoryStream();
        using (var unpacked = GzipReader.Open(new MemoryStream(code, false))) unpacked.CopyTo(lines);
        Packed(text, [lines.ToArray()], cancel, lengths: false);
    }

    // Each part with its length in four bytes, all of it as gzip in base 64.
    private static void Packed(TextWriter text, IEnumerable<byte[]> parts, CancellationToken cancel, bool lengths = true)
    {
        using var memory = new MemoryStream();
        using (var gzip = new GZipStream(memory, CompressionLevel.Optimal, leaveOpen: true))
        {
            foreach (var part in parts)
            {
                cancel.ThrowIfCancellationRequested();
                if (lengths) gzip.Write([(byte)part.Length, (byte)(part.Length >> 8), (byte)(part.Length >> 16), (byte)(part.Length >> 24)], 0, 4);
                gzip.Write(part, 0, part.Length);
            }
        }
        Base64(text, memory.GetBuffer(), (int)memory.Length, cancel);
    }

    private static void Base64(TextWriter text, byte[] bytes, int count, CancellationToken cancel)
    {
        const int Piece = 3 << 16;
        for (var at = 0; at < count; at += Piece)
        {
            cancel.ThrowIfCancellationRequested();
            text.Write(Convert.ToBase64String(bytes, at, Math.Min(Piece, count - at)));
        }
    }

    private static string Resource(string name) => EmbeddedText.Read("viewer/" + name);

    // No part of the page may begin in the title.
    private static string Escaped(string text) => string.Join("&#123;", WebUtility.HtmlEncode(text).Split('{'));
}
