namespace Caterpillar.Geometry;

/// <summary>
/// An indexed triangle mesh in mm. Equal vertices are merged (−0.0 = 0.0), every vertex is used, and no triangle has the same vertex twice. Triangles are
/// counterclockwise seen from outside. Immutable.
/// </summary>
public sealed class TriMesh
{
    /// <summary>Maximum coordinate of a vertex, mm.</summary>
    public const double MaxCoordinate = 1e9;

    private readonly Vec3[] _vertices;
    private readonly int[] _triangles;
    private readonly Lazy<MeshTopology> _topology;
    private readonly Lazy<double> _volume;

    private TriMesh(Vec3[] vertices, int[] triangles, Lazy<MeshTopology>? topology = null, Lazy<double>? volume = null)
    {
        _vertices = vertices;
        _triangles = triangles;
        _topology = topology ?? new Lazy<MeshTopology>(() => new MeshTopology(_vertices, _triangles));
        _volume = volume ?? new Lazy<double>(MeasureVolume);
        Bounds = BoundsOf(vertices);
    }

    /// <summary>
    /// A mesh from points (mm) and three point indices per triangle. Equal points are merged. Unused points and triangles with a repeated point are dropped.
    /// </summary>
    /// <exception cref="ArgumentException">An index is out of range, the number of indices is not a multiple of three, or a point is not finite or beyond <see
    /// cref="MaxCoordinate"/>.</exception>
    public static TriMesh Create(IReadOnlyList<Vec3> points, IReadOnlyList<int> triangles)
    {
        if (points is null) throw new ArgumentNullException(nameof(points));
        if (triangles is null) throw new ArgumentNullException(nameof(triangles));
        if (triangles.Count % 3 != 0) throw new ArgumentException("Each triangle needs three indices.", nameof(triangles));
        var builder = new MeshBuilder(points.Count, triangles.Count / 3);
        var ids = new int[points.Count];
        for (var i = 0; i < ids.Length; i++)
        {
            ids[i] = builder.AddVertex(points[i].X, points[i].Y, points[i].Z);
            if (ids[i] < 0) throw new ArgumentException($"Point {points[i]} is not finite or beyond 1e9 mm.", nameof(points));
        }
        for (var i = 0; i < triangles.Count; i++)
        {
            if ((uint)triangles[i] >= (uint)ids.Length) throw new ArgumentException("A triangle uses a point that does not exist.", nameof(triangles));
        }
        for (var i = 0; i < triangles.Count; i += 3) builder.AddTriangle(ids[triangles[i]], ids[triangles[i + 1]], ids[triangles[i + 2]]);
        return builder.ToMesh();
    }

    /// <summary>The empty mesh.</summary>
    public static TriMesh Empty { get; } = new([], []);

    /// <summary>The vertices, mm.</summary>
    public IReadOnlyList<Vec3> Vertices => _vertices;

    /// <summary>Three vertex indices per triangle.</summary>
    public IReadOnlyList<int> Indices => _triangles;

    /// <summary>Number of vertices.</summary>
    public int VertexCount => _vertices.Length;

    /// <summary>Number of triangles.</summary>
    public int TriangleCount => _triangles.Length / 3;

    /// <summary>Bounding box, mm.</summary>
    public Bounds Bounds { get; }

    /// <summary>Vertex indices of a triangle.</summary>
    public (int A, int B, int C) Triangle(int index) => (_triangles[3 * index], _triangles[3 * index + 1], _triangles[3 * index + 2]);

    /// <summary>Outward unit normal of a triangle. Zero if it has no area.</summary>
    public Vec3 Normal(int index) => Cross(3 * index).Unit();

    /// <summary>Surface area, mm².</summary>
    public double Area => Enumerable.Range(0, TriangleCount).Sum(t => Cross(3 * t).Length) / 2;

    /// <summary>
    /// Signed volume in mm³ (divergence theorem), positive for a closed mesh whose triangles face outward. Overlaps count twice. Not meaningful for an open
    /// mesh.
    /// </summary>
    public double Volume => _volume.Value;

    /// <summary>Number of naked edges, which have only one triangle.</summary>
    public int NakedEdgeCount => Topology.OpenEdges;

    /// <summary>Number of edges with more than two triangles.</summary>
    public int NonManifoldEdgeCount => Topology.NonManifoldEdges;

    /// <summary>Number of edges whose two triangles have opposite normals: one of them is inside out.</summary>
    public int WindingConflictCount => Topology.WindingConflicts;

    /// <summary>True if every edge has two triangles with consistent normals. Bodies may still intersect.</summary>
    public bool IsWatertight => Topology.IsWatertight && _triangles.Length > 0;

    /// <summary>The transformed mesh. Mirroring flips the triangles, so that they still face outward.</summary>
    /// <exception cref="ArgumentException">The transform is singular, not finite, or moves a vertex beyond <see cref="MaxCoordinate"/>.</exception>
    public TriMesh Transformed(Affine map)
    {
        if (map with { Shift = Vec3.Zero } == Affine.Identity && StayApart(map.Shift)) return Shifted(map.Shift);
        var determinant = map.Determinant;
        if (!(Math.Abs(determinant) > 0)) throw new ArgumentException("The transform is singular or not finite.", nameof(map));
        var builder = new MeshBuilder(_vertices.Length, TriangleCount);
        if (!builder.Append(this, map)) throw new ArgumentException("The transform moves a vertex beyond 1e9 mm.", nameof(map));
        return builder.ToMesh().WithEdgesOf(this);
    }

    // Which triangles meet along an edge does not depend on where they are, other than for edges of more than two.
    private TriMesh WithEdgesOf(TriMesh other)
    {
        if (!other._topology.IsValueCreated || other.NonManifoldEdgeCount > 0 || _triangles.Length != other._triangles.Length) return this;
        for (var i = 0; i < _triangles.Length; i++)
        {
            if (_triangles[i] != other._triangles[i]) return this;
        }
        return new TriMesh(_vertices, other._triangles, other._topology);
    }

    /// <summary>The mesh moved by a vector in mm.</summary>
    public TriMesh Moved(Vec3 shift) => Transformed(Affine.Move(shift));

    private TriMesh Shifted(Vec3 shift)
    {
        var vertices = new Vec3[_vertices.Length];
        for (var i = 0; i < vertices.Length; i++) vertices[i] = _vertices[i] + shift;
        var isKnown = _topology.IsValueCreated;
        return new TriMesh(vertices, _triangles, isKnown && NonManifoldEdgeCount == 0 ? _topology : null, isKnown && IsWatertight ? _volume : null);
    }

    // True if rounding does not make two vertices one. Where coordinates are multiples of a step that is twice the rounding of whatever they become, it cannot;
    // numbers of files are, but for those near 0, where they are finer. One of two vertices that become one would have such a coordinate, and the other one,
    // too, would be near 0 there: few vertices have to be compared.
    private bool StayApart(Vec3 shift)
    {
        var most = Math.Max(Math.Max(Bounds.Max.DistanceTo(Vec3.Zero), Bounds.Min.DistanceTo(Vec3.Zero)), shift.Length) * 2;
        if (!(most < MaxCoordinate)) return false;
        var perStep = 1L << 51;
        while (perStep > 1 && most > 1)
        {
            perStep >>= 1;
            most /= 2;
        }
        // Numbers of 24 bits are multiples of the step from here on.
        const double Small = 1 << 24;
        VertexWelder? welder = null;
        var near = 0;
        foreach (var v in _vertices)
        {
            double x = v.X * perStep, y = v.Y * perStep, z = v.Z * perStep;
            if (Math.Abs(x) > Small && Math.Abs(y) > Small && Math.Abs(z) > Small)
            {
                if (x != (long)x || y != (long)y || z != (long)z) return false;
                continue;
            }
            if ((Math.Abs(x) > Small && x != (long)x) || (Math.Abs(y) > Small && y != (long)y) || (Math.Abs(z) > Small && z != (long)z)) return false;
            var moved = v + shift;
            welder ??= new VertexWelder(_vertices.Length / 64);
            near++;
            welder.Add(moved.X, moved.Y, moved.Z);
        }
        return welder is null || welder.Count == near;
    }

    /// <summary>Several meshes merged into one. Equal vertices are merged.</summary>
    public static TriMesh Merge(IEnumerable<TriMesh> meshes)
    {
        var all = (meshes ?? throw new ArgumentNullException(nameof(meshes))).ToArray();
        if (all.Length == 1) return all[0];
        var builder = new MeshBuilder(all.Sum(m => m.VertexCount), all.Sum(m => m.TriangleCount));
        foreach (var mesh in all) builder.Append(mesh, Affine.Identity);
        return builder.ToMesh();
    }

    /// <summary>A box.</summary>
    internal static TriMesh Box(Bounds box)
        => Create([.. box.Corners()], [0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 1, 3, 7, 1, 7, 5, 3, 2, 6, 3, 6, 7, 2, 0, 4, 2, 4, 6]);

    /// <summary>Takes ownership of the arrays without a copy or check; for <see cref="MeshBuilder"/>.</summary>
    internal static TriMesh Own(Vec3[] vertices, int[] triangles) => triangles.Length == 0 ? Empty : new TriMesh(vertices, triangles);

    /// <summary>The same from the corners of each triangle.</summary>
    internal static TriMesh Own(Vec3[] vertices, List<(int A, int B, int C)> faces)
    {
        var triangles = new int[3 * faces.Count];
        for (var i = 0; i < faces.Count; i++) (triangles[3 * i], triangles[3 * i + 1], triangles[3 * i + 2]) = faces[i];
        return Own(vertices, triangles);
    }

    internal Vec3[] RawVertices => _vertices;

    internal int[] RawTriangles => _triangles;

    internal MeshTopology Topology => _topology.Value;

    private Vec3 Cross(int t)
    {
        var a = _vertices[_triangles[t]];
        return Vec3.Cross(_vertices[_triangles[t + 1]] - a, _vertices[_triangles[t + 2]] - a);
    }

    private double MeasureVolume()
    {
        if (_triangles.Length == 0) return 0;
        // Open meshes: relative to the origin. Closed ones do not depend on it, so the nearest useful origin keeps the digits.
        var o = IsWatertight ? Bounds.Center : Vec3.Zero;
        var sum = 0.0;
        for (var t = 0; t < _triangles.Length; t += 3)
        {
            sum += Vec3.Dot(_vertices[_triangles[t]] - o, Vec3.Cross(_vertices[_triangles[t + 1]] - o, _vertices[_triangles[t + 2]] - o));
        }
        return sum / 6;
    }

    private static Bounds BoundsOf(Vec3[] points)
    {
        if (points.Length == 0) return Bounds.Empty;
        double x0 = points[0].X, y0 = points[0].Y, z0 = points[0].Z, x1 = x0, y1 = y0, z1 = z0;
        foreach (var p in points)
        {
            if (p.X < x0) x0 = p.X;
            if (p.X > x1) x1 = p.X;
            if (p.Y < y0) y0 = p.Y;
            if (p.Y > y1) y1 = p.Y;
            if (p.Z < z0) z0 = p.Z;
            if (p.Z > z1) z1 = p.Z;
        }
        return new Bounds(new Vec3(x0, y0, z0), new Vec3(x1, y1, z1));
    }
}
