namespace Caterpillar.Geometry;

/// <summary>
/// Fills a ring of open edges with triangles between its vertices: those of the smallest cost by dynamic programming over the ring (as in Barequet and Sharir
/// 1995, "Filling gaps in the boundary of a polyhedron"). The cost is the area, and for each crease its length times the sine of half its angle, in units of
/// the mean length of the edges. One sharp crease so costs less than two blunt ones: faces beyond the ring go on to the edge in which they meet, where the
/// smallest area alone would cut that off. Angles between triangles of the patch are those of the best parts (Liepa 2003, "Filling holes in meshes").
/// </summary>
internal sealed class RingPatch
{
    private readonly TriMesh _mesh;
    private readonly int[] _ring;
    private readonly Vec3[] _points;

    // Directions of the triangles beyond the edges of the ring.
    private readonly Vec3[] _beyond;
    private readonly double _scale;

    // For a part of the ring from i to j, at i * n + j: its cost, and the third corner of the triangle on its chord.
    private readonly double[] _cost;
    private readonly int[] _split;

    private RingPatch(TriMesh mesh, int[] ring)
    {
        (_mesh, _ring) = (mesh, ring);
        var n = ring.Length;
        (_points, _beyond, _cost, _split) = (new Vec3[n], new Vec3[n], new double[n * n], new int[n * n]);
        for (var i = 0; i < n; i++)
        {
            _points[i] = mesh.RawVertices[mesh.RawTriangles[ring[i]]];
            // Edges run against the ring, so the one from here on begins at the next vertex.
            var (a, b, c) = mesh.Triangle(ring[(i + 1) % n] / 3);
            _beyond[i] = Unit(Vec3.Cross(mesh.RawVertices[b] - mesh.RawVertices[a], mesh.RawVertices[c] - mesh.RawVertices[a]));
        }
        for (var i = 0; i < n; i++) _scale += _points[i].DistanceTo(_points[(i + 1) % n]) / n;
    }

    /// <summary>Adds the triangles to the patch and returns their area, mm².</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="ring">Its open half-edges around the hole, each at the vertex where it begins; they run against the order of the ring.</param>
    /// <param name="patch">Gets the vertices of the triangles.</param>
    public static double Fill(TriMesh mesh, int[] ring, List<int> patch)
    {
        var filling = new RingPatch(mesh, ring);
        for (var span = 2; span < ring.Length; span++)
        {
            for (var i = 0; i + span < ring.Length; i++) filling.Choose(i, i + span);
        }
        return filling.Collect(patch);
    }

    private void Choose(int i, int j)
    {
        var n = _ring.Length;
        var least = double.PositiveInfinity;
        for (var k = i + 1; k < j; k++)
        {
            var cross = Vec3.Cross(_points[k] - _points[i], _points[j] - _points[i]);
            var cost = _cost[i * n + k] + _cost[k * n + j] + cross.Length / 2;
            // Creases only add to it.
            if (!(cost < least)) continue;
            var direction = Unit(cross);
            cost += Crease(i, k, direction) + Crease(k, j, direction);
            if (j - i == n - 1) cost += Crease(j, i, direction);
            if (!(cost < least)) continue;
            least = cost;
            _split[i * n + j] = k;
        }
        _cost[i * n + j] = least;
    }

    // Between a triangle and what lies beyond one of its sides: the surface around the hole, or a part of the patch.
    private double Crease(int i, int j, Vec3 direction)
    {
        var n = _ring.Length;
        Vec3 p = _points[i], q = _points[j];
        var other = (i + 1) % n == j ? _beyond[i] : Unit(Vec3.Cross(_points[_split[i * n + j]] - p, q - p));
        return _scale * p.DistanceTo(q) * Math.Sqrt(Math.Max(0, (1 - Vec3.Dot(direction, other)) / 2));
    }

    private double Collect(List<int> patch)
    {
        var n = _ring.Length;
        var area = 0.0;
        var open = new Stack<(int, int)>();
        open.Push((0, n - 1));
        while (open.Count > 0)
        {
            var (i, j) = open.Pop();
            if (j - i < 2) continue;
            var k = _split[i * n + j];
            foreach (var corner in new[] { i, k, j }) patch.Add(_mesh.RawTriangles[_ring[corner]]);
            area += Vec3.Cross(_points[k] - _points[i], _points[j] - _points[i]).Length / 2;
            open.Push((i, k));
            open.Push((k, j));
        }
        return area;
    }

    private static Vec3 Unit(Vec3 v) => v.Length is > 0 and var length ? v / length : Vec3.Zero;
}
