namespace Caterpillar.Geometry;

/// <summary>Collects vertices and triangles, welds equal vertices, drops invalid triangles, and counts them.</summary>
internal sealed class MeshBuilder
{
    private readonly VertexWelder _welder;
    private readonly Vec3[]? _vertices;
    private int[] _triangles;
    private int _used;

    public MeshBuilder(int expectedVertices, int expectedTriangles)
    {
        _welder = new VertexWelder(expectedVertices);
        _triangles = new int[Math.Max(48, 3L * expectedTriangles <= int.MaxValue ? 3 * expectedTriangles : 48)];
    }

    /// <summary>
    /// For triangles of vertices that are welded already. They may be added in the order in which they are in <paramref name="corners"/>, whose memory is used
    /// for them.
    /// </summary>
    public MeshBuilder(Vec3[] vertices, int[] corners)
    {
        _welder = new VertexWelder(0);
        (_vertices, _triangles) = (vertices, corners);
    }

    /// <summary>A mesh whose vertices become others of it, by their numbers.</summary>
    public static MeshBuilder Merging(TriMesh mesh, int[] targets)
    {
        var builder = new MeshBuilder(mesh.VertexCount, mesh.TriangleCount);
        var ids = Array.ConvertAll(targets, target => builder.AddVertex(mesh.RawVertices[target].X, mesh.RawVertices[target].Y, mesh.RawVertices[target].Z));
        var triangles = mesh.RawTriangles;
        for (var t = 0; t < triangles.Length; t += 3) builder.AddTriangle(ids[triangles[t]], ids[triangles[t + 1]], ids[triangles[t + 2]]);
        return builder;
    }

    public int TriangleCount => _used / 3;

    /// <summary>Triangles with a repeated vertex, which were dropped.</summary>
    public int Degenerate { get; private set; }

    /// <summary>Faces with a coordinate that is not finite or too large, which were dropped.</summary>
    public int NotFinite { get; private set; }

    /// <summary>The number of the vertex, −1 if a coordinate cannot be used.</summary>
    public int AddVertex(double x, double y, double z)
    {
        const double Max = TriMesh.MaxCoordinate;
        return Math.Abs(x) <= Max && Math.Abs(y) <= Max && Math.Abs(z) <= Max ? _welder.Add(x, y, z) : -1;
    }

    public void AddTriangle(int a, int b, int c)
    {
        if (a < 0 || b < 0 || c < 0)
        {
            NotFinite++;
            return;
        }
        if (a == b || b == c || c == a)
        {
            Degenerate++;
            return;
        }
        if (_used + 3 > _triangles.Length) Array.Resize(ref _triangles, (int)Math.Min(2L * _triangles.Length, int.MaxValue / 3 * 3 - 48));
        _triangles[_used] = a;
        _triangles[_used + 1] = b;
        _triangles[_used + 2] = c;
        _used += 3;
    }

    /// <summary>Adds the image of a mesh; false if a vertex ends up too far out (its triangles are counted in <see cref="NotFinite"/>).</summary>
    public bool Append(TriMesh mesh, Affine map)
    {
        var plain = map == Affine.Identity;
        var mirrored = map.Determinant < 0;
        var ids = new int[mesh.VertexCount];
        var good = true;
        for (var i = 0; i < ids.Length; i++)
        {
            var p = plain ? mesh.RawVertices[i] : map.Apply(mesh.RawVertices[i]);
            ids[i] = AddVertex(p.X, p.Y, p.Z);
            good &= ids[i] >= 0;
        }
        var triangles = mesh.RawTriangles;
        for (var t = 0; t < triangles.Length; t += 3)
        {
            if (mirrored) AddTriangle(ids[triangles[t]], ids[triangles[t + 2]], ids[triangles[t + 1]]);
            else AddTriangle(ids[triangles[t]], ids[triangles[t + 1]], ids[triangles[t + 2]]);
        }
        return good;
    }

    /// <summary>The mesh, without unused vertices. The builder must not be used afterwards.</summary>
    public TriMesh ToMesh()
    {
        if (_triangles.Length != _used) Array.Resize(ref _triangles, _used);
        return TriMesh.Own(MeshCleaning.DropUnused(_vertices ?? _welder.ToArray(), _triangles), _triangles);
    }

    /// <summary>The mesh as read from a file, also without duplicate triangles. Reports dropped triangles and naked edges.</summary>
    public TriMesh ToMesh(string name, bool closeCracks, DiagnosticList diagnostics)
    {
        var source = new SourceLocation(name);
        if (NotFinite > 0)
        {
            diagnostics.Add(Severity.Warning, "mesh.not_finite",
                "A face with a coordinate that is not finite or beyond 1e9 mm is ignored.", source, NotFinite);
        }
        var mesh = ToMesh();
        var degenerate = Degenerate + MeshCleaning.CountFlat(mesh);
        if (degenerate > 0)
        {
            diagnostics.Add(Severity.Note, "mesh.degenerate_faces",
                Degenerate == 0 ? "A face has no area."
                    : $"A face has no area. Faces ignored because two vertices are equal: {NumberFormatter.Format(Degenerate)}.",
                source, degenerate);
        }
        if (mesh.TriangleCount == 0) return mesh;
        mesh = MeshCleaning.DropDuplicates(mesh, source, diagnostics);
        if (closeCracks && mesh.Topology.OpenEdges > 0) mesh = CrackSnap.Close(mesh, source, diagnostics);
        mesh = MeshOrientation.Unify(mesh, source, diagnostics);
        MeshCleaning.ReportTopology(mesh, source, diagnostics);
        return mesh;
    }
}
