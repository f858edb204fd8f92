namespace Caterpillar.Drawings;

/// <summary>
/// Reads curve files: points of CSV or JSON with optional settings, line elements of OBJ, and paths and basic shapes of SVG. CSV cells are separated by commas,
/// semicolons, tabs or spaces. All formats can be compressed with gzip. The format is detected from the name, or else from the content. Invalid content gives
/// errors with line and column, never exceptions.
/// </summary>
public static class CurveReader
{
    /// <summary>Reads a file. Errors have codes <c>curves.*</c>.</summary>
    /// <exception cref="IOException">The file cannot be read from the disk.</exception>
    /// <exception cref="OperationCanceledException">Reading was canceled.</exception>
    public static Result<IReadOnlyList<UserCurve>> Read(
        string path, CurveReadOptions? options = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (path is null) throw new ArgumentNullException(nameof(path));
        return Read(File.ReadAllBytes(path), path, options, progress, cancel);
    }

    /// <summary>Reads the bytes of a file. <paramref name="name"/> appears in messages, and its extension can determine the format.</summary>
    public static Result<IReadOnlyList<UserCurve>> Read(
        byte[] bytes, string name, CurveReadOptions? options = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (bytes is null) throw new ArgumentNullException(nameof(bytes));
        if (name is null) throw new ArgumentNullException(nameof(name));
        options ??= new CurveReadOptions();
        var diagnostics = new DiagnosticList();
        var plain = GzipBytes.Unpack(bytes, name, "curves.compression", diagnostics, options.Memory, cancel);
        if (plain is null) return new Result<IReadOnlyList<UserCurve>>(null, diagnostics.ToList());
        var source = new CurveSource(plain, name, options, diagnostics, progress, cancel);
        ReaderOf(plain, name)(source);
        if (!diagnostics.HasErrors && source.Curves.Count == 0)
            diagnostics.Add(Severity.Error, "curves.empty", "The file has no curves.", new SourceLocation(name));
        progress?.Report(1);
        return new Result<IReadOnlyList<UserCurve>>(diagnostics.HasErrors ? null : source.Curves, diagnostics.ToList());
    }

    private static Action<CurveSource> ReaderOf(byte[] bytes, string name)
    {
        var plain = GzipReader.PlainName(name);
        if (Ends(plain, ".svg") || Ends(plain, ".svgz")) return SvgReader.Read;
        if (Ends(plain, ".json")) return JsonCurves.Read;
        if (Ends(plain, ".obj")) return ObjCurves.Read;
        if (Ends(plain, ".csv") || Ends(plain, ".tsv") || Ends(plain, ".txt") || Ends(plain, ".xyz")) return CsvCurves.Read;
        var at = ByteOrderMark.Length(bytes);
        while (at < bytes.Length && bytes[at] <= ' ') at++;
        if (at >= bytes.Length) return CsvCurves.Read;
        if (bytes[at] == '<') return SvgReader.Read;
        if (bytes[at] == '{' || bytes[at] == '[') return JsonCurves.Read;
        return bytes[at] is (byte)'v' or (byte)'o' or (byte)'g' or (byte)'l' && at + 1 < bytes.Length && bytes[at + 1] == ' ' ? ObjCurves.Read : CsvCurves.Read;
    }

    private static bool Ends(string name, string ending) => name.EndsWith(ending, StringComparison.OrdinalIgnoreCase);
}
