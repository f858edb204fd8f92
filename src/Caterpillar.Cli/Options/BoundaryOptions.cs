namespace Caterpillar.Cli;

/// <summary>Options for layers between boundaries of the model.</summary>
internal sealed class BoundaryOptions
{
    private static readonly string[] CurveEndings = [".csv", ".svg", ".json"];

    private readonly Described<string?> _from = new("--from",
        "With --field harmonic or geodesic: start of the layers, as a mesh or curves on the model (CSV, JSON, SVG, OBJ lines). Default: found automatically.",
        "FILE");

    private readonly Described<string[]> _to = new("--to",
        "With --field harmonic or geodesic: end of the layers, as a mesh or curves on the model. Repeatable.", "FILE");

    public Option[] All => [_from, _to];

    public bool IsGiven(ParseResult arguments) => arguments.GetValue(_from) is not null || arguments.GetValue(_to) is { Length: > 0 };

    /// <summary>The boundaries of a model that was moved from its position in the file.</summary>
    public MeshBoundaries Of(ParseResult arguments, TriMesh mesh, Vec3 shift, Session session)
    {
        if (!IsGiven(arguments)) return session.ValueOrFail(MeshBoundaries.Find(mesh, session.Cancel));
        var from = arguments.GetValue(_from) is { } file ? Shape(file, shift, session) : null;
        var to = (arguments.GetValue(_to) ?? []).Select(f => Shape(f, shift, session)).ToArray();
        if (to.Length == 0) throw new CliException(ExitCode.Usage, "--from needs --to.");
        return session.ValueOrFail(MeshBoundaries.Near(mesh, from, to, 0, session.Cancel));
    }

    private static BoundaryShape Shape(string file, Vec3 shift, Session session)
    {
        if (!CurveEndings.Any(e => file.EndsWith(e, StringComparison.OrdinalIgnoreCase)))
        {
            var read = Meshes.Read([file], session);
            var mesh = TriMesh.Merge((read.Value ?? []).Select(m => m.Mesh));
            if (mesh.TriangleCount > 0) return BoundaryShape.Of(mesh.Moved(shift));
            // An OBJ file may hold lines only.
            if (!file.EndsWith(".obj", StringComparison.OrdinalIgnoreCase)) session.ValueOrFail(read);
        }
        return BoundaryShape.Of(Curves.ReadPolylines(file, shift, session));
    }
}
