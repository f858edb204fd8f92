namespace Caterpillar.Geometry;

/// <summary>
/// Nearest points of a mesh, by a tree of boxes. The sign of a distance follows the normals of what is nearest, those of edges and vertices weighted by angle
/// (Bærentzen and Aanæs, "Signed distance computation using the angle weighted pseudonormal", 2005). Immutable.
/// </summary>
internal sealed class MeshDistance
{
    private const int LeafSize = 4;
    private readonly Vec3[] _vertices;
    private readonly int[] _triangles;
    private readonly int[] _order;
    private readonly List<Node> _nodes = [];
    private readonly Vec3[] _vertexNormals;
    private readonly HashSet<int> _rims = [];
    private readonly Dictionary<(int, int), (Vec3 Normal, int Count)> _edges = [];

    /// <exception cref="ArgumentException">The mesh has no triangles.</exception>
    public MeshDistance(TriMesh mesh)
    {
        if (mesh.TriangleCount == 0) throw new ArgumentException("A mesh without triangles has no nearest point.", nameof(mesh));
        _vertices = mesh.RawVertices;
        _triangles = mesh.RawTriangles;
        _vertexNormals = new Vec3[_vertices.Length];
        _order = new int[mesh.TriangleCount];
        var centers = new Vec3[_order.Length];
        for (var t = 0; t < _order.Length; t++)
        {
            _order[t] = t;
            var (a, b, c) = Corners(t);
            centers[t] = (a + b + c) / 3;
            AddNormals(t, a, b, c);
        }
        foreach (var edge in _edges)
        {
            if (edge.Value.Count == 1) _rims.UnionWith([edge.Key.Item1, edge.Key.Item2]);
        }
        Build(centers, 0, _order.Length);
    }

    /// <summary>The nearest point of the mesh, mm.</summary>
    /// <param name="p">Any point, mm.</param>
    public NearestOnMesh Nearest(Vec3 p)
    {
        var best = double.PositiveInfinity;
        var triangle = -1;
        var stack = new int[64];
        var count = 0;
        stack[count++] = 0;
        while (count > 0)
        {
            var at = stack[--count];
            var node = _nodes[at];
            if (node.Distance(p) >= best) continue;
            if (node.Right < 0)
            {
                for (var i = node.First; i < node.First + node.Count; i++)
                {
                    var square = SquareDistance(p, _order[i]);
                    if (square > best || (square == best && _order[i] > triangle)) continue;
                    best = square;
                    triangle = _order[i];
                }
                continue;
            }
            // The nearer child last, so that it is looked at first.
            var (left, right) = (at + 1, node.Right);
            if (_nodes[left].Distance(p) < _nodes[right].Distance(p)) (left, right) = (right, left);
            stack[count++] = left;
            stack[count++] = right;
        }
        return Describe(p, triangle);
    }

    private NearestOnMesh Describe(Vec3 p, int triangle)
    {
        var (a, b, c) = Corners(triangle);
        var (q, u, v, w) = TriangleDistance.Nearest(p, a, b, c);
        int i = _triangles[3 * triangle], j = _triangles[3 * triangle + 1], k = _triangles[3 * triangle + 2];
        const double Zero = 1e-12;
        bool noA = u <= Zero, noB = v <= Zero, noC = w <= Zero;
        Vec3 normal;
        var rim = false;
        if (noA && noB) normal = Corner(k, out rim);
        else if (noB && noC) normal = Corner(i, out rim);
        else if (noA && noC) normal = Corner(j, out rim);
        else if (noA) normal = Edge(j, k, out rim);
        else if (noB) normal = Edge(k, i, out rim);
        else if (noC) normal = Edge(i, j, out rim);
        else normal = Vec3.Cross(b - a, c - a);
        var distance = p.DistanceTo(q);
        return new NearestOnMesh(q, Vec3.Dot(p - q, normal) < 0 ? -distance : distance, normal.Unit(), rim, triangle, new Vec3(u, v, w));
    }

    private Vec3 Corner(int vertex, out bool rim)
    {
        rim = _rims.Contains(vertex);
        return _vertexNormals[vertex];
    }

    private Vec3 Edge(int a, int b, out bool rim)
    {
        var (normal, count) = _edges[a < b ? (a, b) : (b, a)];
        rim = count == 1;
        return normal;
    }

    private void AddNormals(int t, Vec3 a, Vec3 b, Vec3 c)
    {
        var normal = Vec3.Cross(b - a, c - a).Unit();
        int i = _triangles[3 * t], j = _triangles[3 * t + 1], k = _triangles[3 * t + 2];
        _vertexNormals[i] += normal * Turn(b - a, c - a);
        _vertexNormals[j] += normal * Turn(c - b, a - b);
        _vertexNormals[k] += normal * Turn(a - c, b - c);
        AddEdge(i, j, normal);
        AddEdge(j, k, normal);
        AddEdge(k, i, normal);
    }

    private void AddEdge(int a, int b, Vec3 normal)
    {
        var key = a < b ? (a, b) : (b, a);
        _edges.TryGetValue(key, out var sum);
        _edges[key] = (sum.Normal + normal, sum.Count + 1);
    }

    private static double Turn(Vec3 a, Vec3 b) => Basics.Angle.Atan2(Vec3.Cross(a, b).Length, Vec3.Dot(a, b));

    private (Vec3 A, Vec3 B, Vec3 C) Corners(int t) => (_vertices[_triangles[3 * t]], _vertices[_triangles[3 * t + 1]], _vertices[_triangles[3 * t + 2]]);

    private double SquareDistance(Vec3 p, int t)
    {
        var (a, b, c) = Corners(t);
        return (TriangleDistance.Nearest(p, a, b, c).Point - p).LengthSquared;
    }

    private int Build(Vec3[] centers, int first, int count)
    {
        var at = _nodes.Count;
        var box = Bounds.Empty;
        var middle = Bounds.Empty;
        for (var i = first; i < first + count; i++)
        {
            var (a, b, c) = Corners(_order[i]);
            box = box.Include(a).Include(b).Include(c);
            middle = middle.Include(centers[_order[i]]);
        }
        _nodes.Add(new Node(box.Min, box.Max, first, count, -1));
        if (count <= LeafSize) return at;
        // Along the longest side of the centers, at the median.
        var size = middle.Size;
        var axis = size.X >= size.Y && size.X >= size.Z ? 0 : size.Y >= size.Z ? 1 : 2;
        double Key(int t) => axis == 0 ? centers[t].X : axis == 1 ? centers[t].Y : centers[t].Z;
        Array.Sort(_order, first, count, Comparer<int>.Create((x, y) => Key(x) != Key(y) ? Key(x).CompareTo(Key(y)) : x.CompareTo(y)));
        var half = count / 2;
        Build(centers, first, half);
        var right = Build(centers, first + half, count - half);
        _nodes[at] = _nodes[at] with { Right = right };
        return at;
    }

    private readonly record struct Node(Vec3 Min, Vec3 Max, int First, int Count, int Right)
    {
        // Square of the distance of a point from the box.
        public double Distance(Vec3 p)
        {
            var x = Math.Max(0, Math.Max(Min.X - p.X, p.X - Max.X));
            var y = Math.Max(0, Math.Max(Min.Y - p.Y, p.Y - Max.Y));
            var z = Math.Max(0, Math.Max(Min.Z - p.Z, p.Z - Max.Z));
            return x * x + y * y + z * z;
        }
    }
}

/// <summary>The nearest point of a mesh.</summary>
/// <param name="Point">mm.</param>
/// <param name="Distance">mm; negative on the side away from the normals.</param>
/// <param name="Normal">Unit normal of the mesh there.</param>
/// <param name="OnRim">True if the point is on a naked edge.</param>
/// <param name="Triangle">Its triangle.</param>
/// <param name="Weights">Barycentric coordinates in the triangle.</param>
internal readonly record struct NearestOnMesh(Vec3 Point, double Distance, Vec3 Normal, bool OnRim, int Triangle, Vec3 Weights);
