namespace Caterpillar.Geometry;

/// <summary>
/// Winding number of some triangles of a mesh around points: crossings of the ray straight up. The triangles are binned by X, so a question looks at a
/// part of them.
/// </summary>
internal sealed class VerticalRays
{
    private readonly TriMesh _mesh;
    private readonly double _left;
    private readonly double _width;
    private readonly int[] _firsts;
    private readonly int[] _items;

    public VerticalRays(TriMesh mesh, Func<int, bool> use)
    {
        _mesh = mesh;
        var bins = Math.Max(1, Math.Min(4096, mesh.TriangleCount / 8));
        _left = mesh.Bounds.Min.X;
        _width = Math.Max(mesh.Bounds.Size.X / bins, 1e-9);
        _firsts = new int[bins + 1];
        for (var t = 0; t < mesh.TriangleCount; t++)
        {
            if (!use(t)) continue;
            var (from, to) = Span(t);
            for (var bin = from; bin <= to; bin++) _firsts[bin + 1]++;
        }
        for (var bin = 0; bin < bins; bin++) _firsts[bin + 1] += _firsts[bin];
        _items = new int[_firsts[bins]];
        var next = (int[])_firsts.Clone();
        for (var t = 0; t < mesh.TriangleCount; t++)
        {
            if (!use(t)) continue;
            var (from, to) = Span(t);
            for (var bin = from; bin <= to; bin++) _items[next[bin]++] = t;
        }
    }

    /// <summary>How often the triangles go around a point; positive inside bodies that face outward.</summary>
    public int Winding(Vec3 point)
    {
        var bin = Bin(point.X);
        var winding = 0;
        for (var i = _firsts[bin]; i < _firsts[bin + 1]; i++)
        {
            var (ia, ib, ic) = _mesh.Triangle(_items[i]);
            Vec3 a = _mesh.RawVertices[ia], b = _mesh.RawVertices[ib], c = _mesh.RawVertices[ic];
            var crossing = Crossing(a, b, point) + Crossing(b, c, point) + Crossing(c, a, point);
            if (crossing == 0) continue;
            var normal = Vec3.Cross(b - a, c - a);
            if (normal.Z == 0) continue;
            // Height of the triangle over the point against the point's own.
            var above = Vec3.Dot(a - point, normal) / normal.Z > 0;
            if (above) winding += crossing > 0 ? 1 : -1;
        }
        return winding;
    }

    // Of the edge, seen from above, with the ray from the point along +X; half open, so that a vertex counts once.
    private static int Crossing(Vec3 a, Vec3 b, Vec3 p)
    {
        if (a.Y <= p.Y == b.Y <= p.Y) return 0;
        // The same arithmetic for both directions of an edge.
        var (low, high) = a.Y < b.Y ? (a, b) : (b, a);
        var side = (high.X - low.X) * (p.Y - low.Y) - (p.X - low.X) * (high.Y - low.Y);
        return side > 0 ? a.Y < b.Y ? 1 : -1 : 0;
    }

    private (int From, int To) Span(int t)
    {
        var (a, b, c) = _mesh.Triangle(t);
        double x = _mesh.RawVertices[a].X, y = _mesh.RawVertices[b].X, z = _mesh.RawVertices[c].X;
        return (Bin(Math.Min(x, Math.Min(y, z))), Bin(Math.Max(x, Math.Max(y, z))));
    }

    private int Bin(double x) => Math.Max(0, Math.Min(_firsts.Length - 2, (int)((x - _left) / _width)));
}
