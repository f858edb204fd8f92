namespace Caterpillar.Geometry;

/// <summary>
/// Reads mesh files: STL (binary and ASCII), OBJ, PLY (ASCII and both binary byte orders) and 3MF, also compressed with gzip. The format is detected from
/// the bytes, and from the name if they are not conclusive. STL, OBJ and PLY give one mesh, 3MF one per item on the plate. 3MF units are converted to mm;
/// other files are read as mm, or in <see cref="MeshReadOptions.UnitLength"/>. Equal vertices are merged, and polygons are split into fans of triangles.
/// Unreadable bytes give errors, never exceptions.
/// </summary>
public static class MeshReader
{
    /// <summary>Reads a file. Errors have codes <c>mesh.*</c> and the location in the file.</summary>
    /// <exception cref="IOException">The file cannot be read from the disk.</exception>
    /// <exception cref="OperationCanceledException">Reading was canceled.</exception>
    public static Result<IReadOnlyList<NamedMesh>> Read(string path, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (path is null) throw new ArgumentNullException(nameof(path));
        return Read(File.ReadAllBytes(path), path, null, progress, cancel);
    }

    /// <summary>Reads the bytes of a file. Messages use <paramref name="name"/>, and its extension may determine the format.</summary>
    public static Result<IReadOnlyList<NamedMesh>> Read(
        byte[] bytes, string name, MeshReadOptions? options = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (bytes is null) throw new ArgumentNullException(nameof(bytes));
        if (name is null) throw new ArgumentNullException(nameof(name));
        var diagnostics = new DiagnosticList();
        try
        {
            return ReadAll(bytes, name, diagnostics, options ?? new MeshReadOptions(), progress, cancel);
        }
        catch (DiagnosticException tooMuch)
        {
            return new Result<IReadOnlyList<NamedMesh>>(null, [.. diagnostics.ToList(), .. tooMuch.Diagnostics]);
        }
    }

    /// <summary>The file's name without folder and extensions.</summary>
    internal static string PlainName(string name)
    {
        var slash = name.LastIndexOfAny(['/', '\\']);
        var plain = GzipReader.PlainName(name.Substring(slash + 1));
        var dot = plain.LastIndexOf('.');
        return dot > 0 ? plain.Substring(0, dot) : plain;
    }

    private static Result<IReadOnlyList<NamedMesh>> ReadAll(
        byte[] bytes, string name, DiagnosticList diagnostics, MeshReadOptions options, IProgress<double>? progress, CancellationToken cancel)
    {
        var meshes = new List<NamedMesh>();
        var plain = GzipBytes.Unpack(bytes, name, "mesh.compression", diagnostics, options.Memory, cancel);
        var good = plain is not null && ReadPlain(new MeshSource(plain, name, diagnostics, options, progress, cancel), meshes);
        if (good && options.UnitLength != 1 && !IsThreeMf(plain!))
        {
            var map = Affine.Scale(options.UnitLength, options.UnitLength, options.UnitLength);
            for (var i = 0; i < meshes.Count; i++) meshes[i] = new NamedMesh(meshes[i].Name, meshes[i].Mesh.Transformed(map));
        }
        if (good && meshes.All(m => m.Mesh.TriangleCount == 0))
            diagnostics.Add(Severity.Error, "mesh.empty", "The file has no faces.", new SourceLocation(name));
        progress?.Report(1);
        var value = good && !diagnostics.HasErrors ? meshes.Where(m => m.Mesh.TriangleCount > 0).ToArray() : null;
        return new Result<IReadOnlyList<NamedMesh>>(value, diagnostics.ToList());
    }

    private static bool ReadPlain(MeshSource source, List<NamedMesh> meshes)
    {
        var bytes = source.Bytes;
        var ending = Path.GetExtension(GzipReader.PlainName(source.Name).Replace('\\', '/').Split('/').Last()).ToUpperInvariant();
        if (IsThreeMf(bytes)) return ThreeMfReader.Read(source, meshes);
        if (StartsWith(bytes, "ply\n") || StartsWith(bytes, "ply\r")) return PlyReader.Read(source, meshes);
        switch (ending)
        {
            case ".STL":
                return StlReader.Read(source, meshes);
            case ".OBJ":
                return ObjReader.Read(source, meshes);
            case ".PLY":
                return source.ErrorInBinary("mesh.syntax", "A PLY file must start with the line \"ply\".", 0);
            case ".3MF":
                return source.ErrorInBinary("mesh.syntax", "A 3MF file must be a zip archive.", 0);
        }
        if (StlReader.HasBinaryLength(bytes) || StlTextReader.LooksLikeText(bytes)) return StlReader.Read(source, meshes);
        if (LooksLikeObj(bytes)) return ObjReader.Read(source, meshes);
        return source.ErrorInBinary("mesh.unknown_format", "Unknown mesh format. Use STL, OBJ, PLY or 3MF.", 0);
    }

    private static bool IsThreeMf(byte[] bytes) => StartsWith(bytes, "PK\u0003\u0004");

    // A line that begins with "v " and a number, in the first kilobytes.
    private static bool LooksLikeObj(byte[] bytes)
    {
        var cursor = new TextCursor(bytes, ByteOrderMark.Length(bytes), Math.Min(bytes.Length, 65536));
        while (cursor.SkipSpace())
        {
            var start = cursor.SkipWord();
            if (cursor.WordIs(start, "v") && cursor.SkipSpaces() && cursor.ReadNumber(out _)) return true;
            if (bytes[start] == 0) return false;
            cursor.SkipLine();
        }
        return false;
    }

    private static bool StartsWith(byte[] bytes, string text) => bytes.Take(text.Length).SequenceEqual(text.Select(c => (byte)c));
}
