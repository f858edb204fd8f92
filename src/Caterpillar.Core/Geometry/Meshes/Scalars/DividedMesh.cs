namespace Caterpillar.Geometry;

/// <summary>
/// A mesh whose edges are divided, round by round. A triangle that is divided is divided across its longest edge, too: so none becomes ever narrower
/// (Rivara, 1984). An edge is divided once for all of its triangles, so a closed mesh stays closed. Triangles keep their numbers; those that have been
/// divided are gone.
/// </summary>
internal sealed class DividedMesh
{
    private readonly Func<int, Vec3>? _middle;
    private readonly List<Edge> _edges = [];
    private readonly List<Face> _faces = [];

    // For each side of a triangle, 3 · triangle + corner, another one on the same edge, or −1.
    private readonly List<int> _sides = [];
    private readonly Queue<int> _divided = new();

    /// <summary>A mesh that is still whole.</summary>
    /// <param name="mesh">The mesh. Its vertices keep their numbers; new ones follow.</param>
    /// <param name="middle">Where the edge with a number is divided. Null = in its middle.</param>
    public DividedMesh(TriMesh mesh, Func<int, Vec3>? middle = null)
    {
        _middle = middle;
        Points = new List<Vec3>(mesh.RawVertices);
        var triangles = mesh.RawTriangles;
        var (_, keys) = MeshTopology.SortedEdges(mesh.VertexCount, triangles, out var sameAsBefore);
        var numbers = new int[triangles.Length];
        for (var i = 0; i < keys.Length; i++)
        {
            var side = (int)keys[i];
            if (!sameAsBefore[i]) _edges.Add(Edge.Of(triangles[side], triangles[MeshTopology.Next(side)]));
            numbers[side] = _edges.Count - 1;
        }
        for (var t = 0; t < triangles.Length; t += 3)
            Add((triangles[t], triangles[t + 1], triangles[t + 2]), (numbers[t], numbers[t + 1], numbers[t + 2]));
    }

    /// <summary>The vertices.</summary>
    public List<Vec3> Points { get; }

    /// <summary>Number of edges, divided ones included.</summary>
    public int EdgeCount => _edges.Count;

    /// <summary>Number of triangles ever, divided ones included.</summary>
    public int FaceCount => _faces.Count;

    /// <summary>Number of triangles that are there now.</summary>
    public int Count { get; private set; }

    /// <summary>The ends of an edge, the lower number first.</summary>
    public (int A, int B) Ends(int edge) => (_edges[edge].A, _edges[edge].B);

    public (int A, int B, int C) Corners(int face) => _faces[face].Corners;

    /// <summary>The edges that begin at each corner.</summary>
    public (int AB, int BC, int CA) Edges(int face) => _faces[face].Edges;

    /// <summary>Whether none of a triangle's edges has been divided.</summary>
    public bool IsWhole(int face)
    {
        var (ab, bc, ca) = _faces[face].Edges;
        return Middle(ab) < 0 && Middle(bc) < 0 && Middle(ca) < 0;
    }

    /// <summary>The longest edge of a triangle. Neighbors have to agree on equal lengths, so the numbers of their ends decide.</summary>
    public int Longest(int face)
    {
        var (ab, bc, ca) = _faces[face].Edges;
        return Longer(Longer(ab, bc), ca);
    }

    public double Square(int edge) => (Points[_edges[edge].B] - Points[_edges[edge].A]).LengthSquared;

    /// <summary>The vertex that divides an edge; −1 if it is whole.</summary>
    public int Middle(int edge) => _edges[edge].Halves is >= 0 and var half ? _edges[half].B : -1;

    /// <summary>Divides an edge that there was when the round began, if it has not been divided yet.</summary>
    public void Divide(int edge)
    {
        if (Middle(edge) >= 0) return;
        Divide(edge, _middle?.Invoke(edge) ?? Vec3.Lerp(Points[_edges[edge].A], Points[_edges[edge].B], 0.5));
    }

    /// <summary>Divides a whole edge at a place.</summary>
    public void Divide(int edge, Vec3 at)
    {
        var (a, b) = Ends(edge);
        _edges[edge] = _edges[edge] with { Halves = _edges.Count };
        _edges.Add(Edge.Of(a, Points.Count));
        _edges.Add(Edge.Of(b, Points.Count));
        Points.Add(at);
        _divided.Enqueue(edge);
    }

    /// <summary>Divides the triangles on divided edges: the end of a round.</summary>
    /// <returns>Whether there were any.</returns>
    public bool Split()
    {
        var cut = new List<(int Face, int Across)>();
        while (_divided.Count > 0)
        {
            for (var side = _edges[_divided.Dequeue()].Side; side >= 0; side = _sides[side])
            {
                var face = side / 3;
                if (_faces[face].IsGone) continue;
                cut.Add((face, Longest(face)));
                Divide(cut[cut.Count - 1].Across);
                _faces[face] = _faces[face] with { IsGone = true };
            }
        }
        Count -= cut.Count;
        foreach (var (face, across) in cut) Split(_faces[face].Corners, _faces[face].Edges, across);
        return cut.Count > 0;
    }

    /// <summary>The triangles that are there now, over other places of the vertices.</summary>
    public TriMesh ToMesh(List<Vec3> places) => TriMesh.Own(places.ToArray(), _faces.Where(f => !f.IsGone).Select(f => f.Corners).ToList());

    private void Add((int A, int B, int C) corners, (int AB, int BC, int CA) edges)
    {
        _faces.Add(new Face(corners, edges, IsGone: false));
        Count++;
        AddSide(edges.AB);
        AddSide(edges.BC);
        AddSide(edges.CA);
    }

    private void AddSide(int edge)
    {
        _sides.Add(_edges[edge].Side);
        _edges[edge] = _edges[edge] with { Side = _sides.Count - 1 };
    }

    private void Split((int A, int B, int C) corners, (int AB, int BC, int CA) edges, int across)
    {
        var (a, b, c) = corners;
        var (ab, bc, ca) = edges;
        if (Middle(ab) is >= 0 and var p && Middle(bc) is >= 0 and var q && Middle(ca) is >= 0 and var r)
        {
            int pq = AddEdge(p, q), qr = AddEdge(q, r), rp = AddEdge(r, p);
            Add((a, p, r), (Half(ab, a), rp, Half(ca, a)));
            Add((p, b, q), (Half(ab, b), Half(bc, b), pq));
            Add((r, q, c), (qr, Half(bc, c), Half(ca, c)));
            Add((p, q, r), (pq, qr, rp));
            return;
        }
        // Into two, of which one may have a divided edge.
        if (across == bc) (a, b, c, bc, ca) = (b, c, a, ca, ab);
        else if (across == ca) (a, b, c, bc, ca) = (c, a, b, ab, bc);
        var middle = Middle(across);
        var inner = AddEdge(middle, c);
        AddPiece((a, middle, c), (Half(across, a), inner, ca), ca);
        AddPiece((middle, b, c), (Half(across, b), bc, inner), bc);
    }

    private void AddPiece((int A, int B, int C) corners, (int AB, int BC, int CA) edges, int other)
    {
        if (Middle(other) < 0) Add(corners, edges);
        else Split(corners, edges, other);
    }

    private int AddEdge(int a, int b)
    {
        _edges.Add(Edge.Of(a, b));
        return _edges.Count - 1;
    }

    // The half of a divided edge at one of its ends.
    private int Half(int edge, int end) => _edges[edge].Halves + (_edges[edge].A == end ? 0 : 1);

    private int Longer(int p, int q)
    {
        double first = Square(p), second = Square(q);
        return second > first || (second == first && Ends(q).CompareTo(Ends(p)) < 0) ? q : p;
    }

    // From the lower number to the higher one; the first of its two halves and the first of the sides on it, −1 if there is none.
    private readonly record struct Edge(int A, int B, int Halves, int Side)
    {
        public static Edge Of(int a, int b) => a < b ? new Edge(a, b, -1, -1) : new Edge(b, a, -1, -1);
    }

    private readonly record struct Face((int A, int B, int C) Corners, (int AB, int BC, int CA) Edges, bool IsGone);
}
