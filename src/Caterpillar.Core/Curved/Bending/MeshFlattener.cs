namespace Caterpillar.Curved;

/// <summary>Bends a mesh so that the layers of a field are flat. Triangles are divided where they do not match their bent image within a tolerance.</summary>
internal sealed class MeshFlattener
{
    private const int MaxTriangles = 12_000_000;
    private readonly DividedMesh _mesh;
    private readonly BentPieces _pieces;
    private readonly ParallelOptions _options;
    private readonly List<Vec3> _flat;

    // Edges and triangles before these have been tested.
    private int _edges;
    private int _faces;

    private MeshFlattener(TriMesh mesh, LayerField field, double tolerance, ParallelOptions options)
    {
        _options = options;
        var bent = new Vec3[mesh.VertexCount];
        Parallel.For(0, bent.Length, options, i => bent[i] = field.ToFlat(mesh.RawVertices[i]));
        _flat = new List<Vec3>(bent);
        _mesh = new DividedMesh(mesh, Middle);
        _pieces = new BentPieces(field, tolerance, _mesh.Points, _flat);
    }

    /// <summary>The bent mesh, or null if it would have more than 12 million triangles.</summary>
    /// <exception cref="OperationCanceledException">The call was canceled.</exception>
    public static TriMesh? Flatten(TriMesh mesh, LayerField field, double tolerance, int threads, CancellationToken cancel)
    {
        var options = new ParallelOptions { CancellationToken = cancel, MaxDegreeOfParallelism = threads > 0 ? threads : -1 };
        var flattener = new MeshFlattener(mesh, field, tolerance, options);
        while (flattener.Refine())
        {
            if (flattener._mesh.Count > MaxTriangles) return null;
            cancel.ThrowIfCancellationRequested();
        }
        return flattener._mesh.ToMesh(flattener._flat);
    }

    // One round: false when nothing had to be divided.
    private bool Refine()
    {
        var first = _edges;
        _edges = _mesh.EdgeCount;
        var middles = new (Vec3 Part, Vec3 Flat)?[_edges - first];
        Parallel.For(0, middles.Length, _options, i => middles[i] = _pieces.Test(_mesh.Ends(first + i)));
        for (var i = 0; i < middles.Length; i++)
        {
            if (middles[i] is not { } middle) continue;
            _flat.Add(middle.Flat);
            _mesh.Divide(first + i, middle.Part);
        }
        var start = _faces;
        _faces = _mesh.FaceCount;
        var bent = new bool[_faces - start];
        Parallel.For(0, bent.Length, _options, i => bent[i] = _mesh.IsWhole(start + i) && !_pieces.IsFlat(_mesh.Corners(start + i)));
        for (var i = 0; i < bent.Length; i++)
        {
            if (!bent[i]) continue;
            var (ab, bc, ca) = _mesh.Edges(start + i);
            foreach (var edge in new[] { ab, bc, ca })
            {
                if (_pieces.CanDivide(_mesh.Ends(edge))) _mesh.Divide(edge);
            }
        }
        return _mesh.Split();
    }

    private Vec3 Middle(int edge)
    {
        var (part, flat) = _pieces.Middle(_mesh.Ends(edge));
        _flat.Add(flat);
        return part;
    }
}
