namespace Caterpillar.Cli;

/// <summary>Options for layers between boundaries of the model.</summary>
internal sealed class BoundaryOptions
{
    private static readonly string[] CurveEndings = [".csv", ".svg", ".json"];

    private readonly Described<string?> _from = new("--from",
        "With --field harmonic or geodesic: start of the layers, as a mesh or curves on the model (CSV, JSON, SVG, OBJ lines), or a JSON list of its vertices, "
            + "from 0. edge:N = its open edge N, from the longest. Default: found automatically.", "FILE|edge:N");

    private readonly Described<string[]> _to = new("--to",
        "With --field harmonic or geodesic: end of the layers, in the same ways. Repeatable.", "FILE|edge:N");

    public Option[] All => [_from, _to];

    public bool IsGiven(ParseResult arguments) => arguments.GetValue(_from) is not null || arguments.GetValue(_to) is { Length: > 0 };

    /// <summary>The boundaries of a model that was placed from its position in the file.</summary>
    public MeshBoundaries Of(ParseResult arguments, TriMesh mesh, Affine placed, Session session)
    {
        if (!IsGiven(arguments)) return session.ValueOrFail(MeshBoundaries.Find(mesh, session.Cancel));
        var from = arguments.GetValue(_from) is { } file ? Shape(file, placed, session) : null;
        var to = (arguments.GetValue(_to) ?? []).Select(f => Shape(f, placed, session)).ToArray();
        if (to.Length == 0) throw CliException.Usage("--from needs --to.");
        return session.ValueOrFail(MeshBoundaries.Near(mesh, from, to, 0, session.Cancel));
    }

    private static BoundaryShape Shape(string file, Affine placed, Session session)
    {
        if (file.StartsWith("edge:", StringComparison.Ordinal))
        {
            return BoundaryShape.OpenEdge(NumberReader.TryParse(file[5..], out var number) && number is >= 1 and < 1e6 && number % 1 == 0 ? (int)number
                : throw CliException.Usage("edge:N needs a number from 1."));
        }
        if (file.EndsWith(".json", StringComparison.OrdinalIgnoreCase) && Vertices(session.ReadBytes(file)) is { } vertices) return BoundaryShape.Of(vertices);
        if (!CurveEndings.Any(e => file.EndsWith(e, StringComparison.OrdinalIgnoreCase)))
        {
            var read = Meshes.Read([file], session);
            var mesh = TriMesh.Merge((read.Value ?? []).Select(m => m.Mesh));
            if (mesh.TriangleCount > 0) return BoundaryShape.Of(mesh.Transformed(placed));
            // An OBJ file may hold lines only.
            if (!file.EndsWith(".obj", StringComparison.OrdinalIgnoreCase)) session.ValueOrFail(read);
        }
        return BoundaryShape.Of(Curves.ReadPolylines(file, placed, session));
    }

    // A list of whole numbers; other JSON files are curves.
    private static int[]? Vertices(byte[] json)
    {
        try
        {
            return JToken.Parse(Encoding.UTF8.GetString(json)) is JArray { Count: > 0 } list && list.All(n => n.Type == JTokenType.Integer)
                ? list.Select(n => (int)n).ToArray() : null;
        }
        catch (Exception failure) when (failure is JsonException or OverflowException)
        {
            return null;
        }
    }
}
