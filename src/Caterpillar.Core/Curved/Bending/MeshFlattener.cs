namespace Caterpillar.Curved;

/// <summary>
/// Bends a mesh so that the layers of a field are flat. Triangles are divided where they do not match their bent image within a tolerance; an edge is divided
/// once for both of its triangles, so a closed mesh stays closed.
/// </summary>
internal sealed class MeshFlattener
{
    private const int MaxTriangles = 12_000_000;
    private readonly BentPieces _pieces;
    private readonly ParallelOptions _options;
    private readonly List<Vec3> _part;
    private readonly List<Vec3> _flat;
    private readonly Dictionary<long, int> _numbers;
    private readonly List<Edge> _edges;
    private readonly List<(int A, int B, int C)> _split = [];
    private List<Face> _faces;
    private List<Face> _next = [];

    // Edges before this one have been tested.
    private int _tested;

    private MeshFlattener(TriMesh mesh, LayerField field, double tolerance, ParallelOptions options)
    {
        _options = options;
        _part = new List<Vec3>(mesh.RawVertices);
        var bent = new Vec3[mesh.VertexCount];
        Parallel.For(0, bent.Length, options, i => bent[i] = field.ToFlat(mesh.RawVertices[i]));
        _flat = new List<Vec3>(bent);
        _pieces = new BentPieces(field, tolerance, _part, _flat);
        // As many edges as a closed mesh has.
        var edges = mesh.TriangleCount * 3 / 2;
        (_numbers, _edges, _faces) = (new Dictionary<long, int>(edges), new List<Edge>(edges), new List<Face>(mesh.TriangleCount));
        var triangles = mesh.RawTriangles;
        for (var t = 0; t < triangles.Length; t += 3) _faces.Add(FaceOf(triangles[t], triangles[t + 1], triangles[t + 2]));
    }

    /// <summary>The bent mesh, or null if it would have more than 12 million triangles.</summary>
    /// <exception cref="OperationCanceledException">The call was canceled.</exception>
    public static TriMesh? Flatten(TriMesh mesh, LayerField field, double tolerance, int threads, CancellationToken cancel)
    {
        var options = new ParallelOptions { CancellationToken = cancel, MaxDegreeOfParallelism = threads > 0 ? threads : -1 };
        var flattener = new MeshFlattener(mesh, field, tolerance, options);
        while (flattener.Refine())
        {
            if (flattener._faces.Count > MaxTriangles) return null;
            cancel.ThrowIfCancellationRequested();
        }
        return TriMesh.Own(flattener._flat.ToArray(), flattener._faces.ConvertAll(f => (f.A, f.B, f.C)));
    }

    // One round: false when nothing had to be divided.
    private bool Refine()
    {
        var first = _tested;
        _tested = _edges.Count;
        var middles = new (Vec3 Part, Vec3 Flat)?[_tested - first];
        Parallel.For(0, middles.Length, _options, i => middles[i] = _pieces.Test(_edges[first + i].A, _edges[first + i].B));
        for (var i = 0; i < middles.Length; i++)
        {
            if (middles[i] is { } middle) SetMiddle(first + i, middle);
        }
        var bent = new bool[_faces.Count];
        Parallel.For(0, bent.Length, _options, i =>
            bent[i] = !_faces[i].Tested && IsWhole(_faces[i]) && !_pieces.IsFlat(_faces[i].A, _faces[i].B, _faces[i].C));
        for (var i = 0; i < bent.Length; i++)
        {
            var face = _faces[i];
            if (bent[i])
            {
                if (_pieces.CanDivide(face.A, face.B)) Divide(face.AB);
                if (_pieces.CanDivide(face.B, face.C)) Divide(face.BC);
                if (_pieces.CanDivide(face.C, face.A)) Divide(face.CA);
            }
            else if (IsWhole(face))
            {
                _faces[i] = face with { Tested = true };
            }
        }
        while (DivideLongest())
        {
        }
        _next.Clear();
        foreach (var face in _faces)
        {
            if (IsWhole(face))
            {
                _next.Add(face);
                continue;
            }
            _split.Clear();
            TriangleSplit.Add(_part, (face.A, face.B, face.C), (_edges[face.AB].Middle, _edges[face.BC].Middle, _edges[face.CA].Middle), _split);
            foreach (var (a, b, c) in _split) _next.Add(FaceOf(a, b, c));
        }
        (_faces, _next) = (_next, _faces);
        return _faces.Count > _next.Count;
    }

    private Face FaceOf(int a, int b, int c) => new(a, b, c, EdgeOf(a, b), EdgeOf(b, c), EdgeOf(c, a), false);

    private int EdgeOf(int a, int b)
    {
        // Multiplied by an odd number, which keeps keys apart and spreads their hashes: those of neighbors would be almost alike.
        var key = unchecked((a < b ? ((long)a << 32) | (uint)b : ((long)b << 32) | (uint)a) * -7046029254386353131L);
        if (_numbers.TryGetValue(key, out var number)) return number;
        _numbers.Add(key, _edges.Count);
        _edges.Add(a < b ? new Edge(a, b, -1) : new Edge(b, a, -1));
        return _edges.Count - 1;
    }

    private bool IsWhole(in Face face) => _edges[face.AB].Middle < 0 && _edges[face.BC].Middle < 0 && _edges[face.CA].Middle < 0;

    // A triangle that is divided is divided across its longest edge, too: so none becomes ever narrower (Rivara, 1984).
    private bool DivideLongest()
    {
        var found = false;
        foreach (var face in _faces)
        {
            if (IsWhole(face)) continue;
            double ab = Square(face.A, face.B), bc = Square(face.B, face.C), ca = Square(face.C, face.A);
            var longest = ab >= bc && ab >= ca ? face.AB : bc >= ca ? face.BC : face.CA;
            if (_edges[longest].Middle >= 0) continue;
            Divide(longest);
            found = true;
        }
        return found;
    }

    private double Square(int a, int b) => (_part[a] - _part[b]).LengthSquared;

    private void Divide(int edge)
    {
        if (_edges[edge].Middle >= 0) return;
        SetMiddle(edge, _pieces.Middle(_edges[edge].A, _edges[edge].B));
    }

    private void SetMiddle(int edge, (Vec3 Part, Vec3 Flat) middle)
    {
        _edges[edge] = _edges[edge] with { Middle = _part.Count };
        _part.Add(middle.Part);
        _flat.Add(middle.Flat);
    }

    // The number of its middle is −1 where an edge stays whole.
    private readonly record struct Edge(int A, int B, int Middle);

    private readonly record struct Face(int A, int B, int C, int AB, int BC, int CA, bool Tested);
}
