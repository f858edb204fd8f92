namespace Caterpillar.Geometry;

/// <summary>A mesh file that is being read.</summary>
internal sealed class MeshSource(
    byte[] bytes, string name, DiagnosticList diagnostics, MeshReadOptions options, IProgress<double>? progress, CancellationToken cancel)
    : FileSource(bytes, name, diagnostics, progress, cancel)
{
    // What a triangle, its half of a vertex and their neighbors take until the mesh is clean.
    private const double BytesPerTriangle = 160;

    // What a mesh takes besides.
    private const double BytesPerMesh = 1500;

    public int Length => Bytes.Length;

    /// <summary>Threads to use.</summary>
    public int Threads { get; } = options.Threads > 0 ? options.Threads : Environment.ProcessorCount;

    /// <summary>Stops where the meshes, with so many triangles in all, would take too much memory.</summary>
    /// <exception cref="DiagnosticException">They would.</exception>
    public void Afford(long triangles, long meshes = 1)
    {
        var bytes = Length + triangles * BytesPerTriangle + meshes * BytesPerMesh;
        if (bytes <= options.Memory.Bytes) return;
        var of = triangles > 0 ? $" of {NumberFormatter.Format(triangles)} triangles" : "";
        var items = meshes > 1 ? $"{NumberFormatter.Format(meshes)} meshes{of}" : $"A mesh{of}";
        options.Memory.Check(bytes, items, new SourceLocation(Name));
    }

    /// <summary>An error at a byte of a text file; the location is given as line and column.</summary>
    public bool ErrorInText(string code, string message, int offset) => Fail(code, message, PlaceInText(offset));

    /// <summary>An error at a byte of a binary file.</summary>
    public bool ErrorInBinary(string code, string message, long offset)
        => Fail(code, $"{message} (byte {NumberFormatter.Format(offset)})", new SourceLocation(Name));

    /// <summary>Reports something about the file, or a location in it.</summary>
    public void Note(Severity severity, string code, string message, SourceLocation? place = null, int count = 1)
        => Diagnostics.Add(severity, code, message, place ?? new SourceLocation(Name), count);

    public SourceLocation PlaceInText(int offset)
    {
        var line = 1;
        var start = 0;
        for (var i = 0; i < offset && i < Length; i++)
        {
            if (Bytes[i] != '\n') continue;
            line++;
            start = i + 1;
        }
        return new SourceLocation(Name, line, offset - start + 1);
    }
}
