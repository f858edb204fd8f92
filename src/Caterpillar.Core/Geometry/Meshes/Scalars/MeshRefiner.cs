namespace Caterpillar.Geometry;

/// <summary>Divides the edges of a mesh until none is longer than a length; its surface stays the same, and closed meshes stay closed.</summary>
internal sealed class MeshRefiner
{
    private readonly List<Vec3> _points;
    private readonly List<(int A, int B)> _parents = [];
    private readonly Dictionary<long, int> _middles = [];
    private List<(int A, int B, int C)> _faces = [];

    private MeshRefiner(TriMesh mesh)
    {
        _points = new List<Vec3>(mesh.RawVertices);
        var triangles = mesh.RawTriangles;
        for (var t = 0; t < triangles.Length; t += 3) _faces.Add((triangles[t], triangles[t + 1], triangles[t + 2]));
    }

    /// <summary>The vertices of the mesh keep their numbers; new ones follow.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="longest">mm, positive.</param>
    /// <param name="most">No further division from so many triangles on.</param>
    /// <param name="cancel">Cancels the call.</param>
    /// <returns>The mesh, and for each new vertex the two in whose middle it lies.</returns>
    public static (TriMesh Mesh, IReadOnlyList<(int A, int B)> Parents) Refine(TriMesh mesh, double longest, int most, CancellationToken cancel)
    {
        var refiner = new MeshRefiner(mesh);
        while (refiner._faces.Count < most && refiner.Round(longest * longest)) cancel.ThrowIfCancellationRequested();
        return (TriMesh.Own(refiner._points.ToArray(), refiner._faces), refiner._parents);
    }

    private bool Round(double square)
    {
        _middles.Clear();
        foreach (var (a, b, c) in _faces)
        {
            var (p, q, length) = Longest(a, b, c);
            if (length > square) Divide(p, q);
        }
        if (_middles.Count == 0) return false;
        // A triangle that is divided is divided across its longest edge, too: so none becomes ever narrower (Rivara, 1984).
        var found = true;
        while (found)
        {
            found = false;
            foreach (var (a, b, c) in _faces)
            {
                if (Middle(a, b) < 0 && Middle(b, c) < 0 && Middle(c, a) < 0) continue;
                var (p, q, _) = Longest(a, b, c);
                if (Middle(p, q) >= 0) continue;
                Divide(p, q);
                found = true;
            }
        }
        var next = new List<(int A, int B, int C)>(_faces.Count * 2);
        foreach (var face in _faces)
            TriangleSplit.Add(_points, face, (Middle(face.A, face.B), Middle(face.B, face.C), Middle(face.C, face.A)), next);
        _faces = next;
        return true;
    }

    private (int P, int Q, double Square) Longest(int a, int b, int c)
    {
        double ab = Square(a, b), bc = Square(b, c), ca = Square(c, a);
        // Neighbors have to agree on equal lengths, so the order of the numbers decides.
        var (p, q, most) = (a, b, ab);
        if (bc > most || (bc == most && Key(b, c) < Key(p, q))) (p, q, most) = (b, c, bc);
        if (ca > most || (ca == most && Key(c, a) < Key(p, q))) (p, q, most) = (c, a, ca);
        return (p, q, most);
    }

    private double Square(int a, int b) => a < b ? (_points[b] - _points[a]).LengthSquared : (_points[a] - _points[b]).LengthSquared;

    private static long Key(int a, int b) => a < b ? ((long)a << 32) | (uint)b : ((long)b << 32) | (uint)a;

    private int Middle(int a, int b) => _middles.TryGetValue(Spread(a, b), out var middle) ? middle : -1;

    private void Divide(int a, int b)
    {
        if (Middle(a, b) >= 0) return;
        _middles.Add(Spread(a, b), _points.Count);
        _parents.Add((a, b));
        _points.Add(a < b ? Vec3.Lerp(_points[a], _points[b], 0.5) : Vec3.Lerp(_points[b], _points[a], 0.5));
    }

    // Multiplied by an odd number, which keeps keys apart and spreads their hashes.
    private static long Spread(int a, int b) => unchecked(Key(a, b) * -7046029254386353131L);
}
