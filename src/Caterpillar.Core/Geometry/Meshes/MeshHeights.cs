namespace Caterpillar.Geometry;

/// <summary>
/// Heights of a surface above points of the XY plane, and how often it goes around points: the triangles in a grid of cells, so that a query looks at only a
/// few of them. Vertical triangles have no height. Immutable.
/// </summary>
internal sealed class MeshHeights
{
    private const int MaxCells = 1 << 22;

    // In cells.
    private const double Rounding = 1e-6;
    private readonly TriMesh _mesh;
    private readonly double _cell;
    private readonly int _columns;
    private readonly int _rows;
    private readonly int[] _firsts;
    private readonly int[] _items;

    /// <summary>Sorts the triangles of the mesh by their place.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="onlyUp">Leaves out triangles that face down.</param>
    public MeshHeights(TriMesh mesh, bool onlyUp = false)
    {
        _mesh = mesh ?? throw new ArgumentNullException(nameof(mesh));
        var size = mesh.Bounds.Size;
        // As many cells as triangles: one or two of them in each.
        var count = Math.Min(Math.Max(onlyUp ? mesh.TriangleCount / 2 : mesh.TriangleCount, 1), MaxCells);
        _cell = Math.Max(Math.Sqrt(size.X * size.Y / count), Math.Max(size.X, size.Y) / 4096);
        if (!(_cell > 0)) _cell = 1;
        _columns = (int)(size.X / _cell) + 1;
        _rows = (int)(size.Y / _cell) + 1;
        _firsts = new int[_columns * _rows + 1];
        Visit(onlyUp, (cell, _) => _firsts[cell + 1]++);
        for (var i = 0; i + 1 < _firsts.Length; i++) _firsts[i + 1] += _firsts[i];
        _items = new int[_firsts[_firsts.Length - 1]];
        var next = (int[])_firsts.Clone();
        Visit(onlyUp, (cell, triangle) => _items[next[cell]++] = triangle);
    }

    /// <summary>
    /// Highest point of the surface, mm, on the vertical through (x, y) and not above <paramref name="limit"/>; negative infinity if there is none.
    /// </summary>
    public double TopUnder(double x, double y, double limit = double.PositiveInfinity) => TopUnder(x, y, limit, out _);

    /// <summary>The same, and the number of the triangle; −1 if there is none.</summary>
    internal double TopUnder(double x, double y, double limit, out int triangle)
    {
        triangle = -1;
        var best = double.NegativeInfinity;
        var min = _mesh.Bounds.Min;
        var column = (x - min.X) / _cell;
        var row = (y - min.Y) / _cell;
        if (!(column >= 0 && row >= 0 && column < _columns && row < _rows) || _mesh.TriangleCount == 0) return best;
        var cell = (int)row * _columns + (int)column;
        var (vertices, triangles) = (_mesh.RawVertices, _mesh.RawTriangles);
        for (var i = _firsts[cell]; i < _firsts[cell + 1]; i++)
        {
            var t = 3 * _items[i];
            var z = HeightOn(in vertices[triangles[t]], in vertices[triangles[t + 1]], in vertices[triangles[t + 2]], x, y);
            if (!(z <= limit && z > best)) continue;
            best = z;
            triangle = _items[i];
        }
        return best;
    }

    /// <summary>How often some triangles go around a point, by the crossings of the ray straight up; positive inside bodies that face outward.</summary>
    public int Winding(Vec3 point, Func<int, bool> use)
    {
        var min = _mesh.Bounds.Min;
        int column = (int)((point.X - min.X) / _cell), row = (int)((point.Y - min.Y) / _cell);
        if (!_mesh.Bounds.Contains(point.WithZ(min.Z))) return 0;
        var winding = 0;
        for (var i = _firsts[row * _columns + column]; i < _firsts[row * _columns + column + 1]; i++)
        {
            if (!use(_items[i])) continue;
            var (ia, ib, ic) = _mesh.Triangle(_items[i]);
            Vec3 a = _mesh.RawVertices[ia], b = _mesh.RawVertices[ib], c = _mesh.RawVertices[ic];
            var crossing = Crossing(a, b, point) + Crossing(b, c, point) + Crossing(c, a, point);
            if (crossing == 0) continue;
            var normal = Vec3.Cross(b - a, c - a);
            // Height of the triangle over the point against the point's own.
            if (Vec3.Dot(a - point, normal) / normal.Z > 0) winding += crossing > 0 ? 1 : -1;
        }
        return winding;
    }

    /// <summary>Of an edge, seen from above, with the ray from a point along +X: 1 upward, −1 downward. Half open, so that a vertex counts once.</summary>
    public static int Crossing(Vec3 a, Vec3 b, Vec3 p)
    {
        if (a.Y <= p.Y == b.Y <= p.Y) return 0;
        // The same arithmetic for both directions of an edge.
        var (low, high) = a.Y < b.Y ? (a, b) : (b, a);
        var side = (high.X - low.X) * (p.Y - low.Y) - (p.X - low.X) * (high.Y - low.Y);
        return side > 0 ? a.Y < b.Y ? 1 : -1 : 0;
    }

    // NaN outside the triangle; points on an edge belong to both of its triangles.
    private static double HeightOn(in Vec3 a, in Vec3 b, in Vec3 c, double x, double y)
    {
        double ax = a.X - x, ay = a.Y - y, bx = b.X - x, by = b.Y - y, cx = c.X - x, cy = c.Y - y;
        double u = bx * cy - by * cx, v = cx * ay - cy * ax, w = ax * by - ay * bx;
        // All of them have the sign of the area.
        if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0))) return double.NaN;
        var area = (b.X - a.X) * (c.Y - a.Y) - (b.Y - a.Y) * (c.X - a.X);
        return area == 0 ? double.NaN : a.Z * (u / area) + b.Z * (v / area) + c.Z * (w / area);
    }

    // The x that an edge has within a row of cells, with a little to spare for rounding.
    private void Widen(Vec3 a, Vec3 b, double bottom, ref double low, ref double high)
    {
        if (a.Y > b.Y) (a, b) = (b, a);
        double from = bottom - Rounding * _cell, to = bottom + (1 + Rounding) * _cell;
        if (b.Y < from || a.Y > to) return;
        var (first, last) = (a.X, b.X);
        if (a.Y < from) first = a.X + (b.X - a.X) * (from - a.Y) / (b.Y - a.Y);
        if (b.Y > to) last = a.X + (b.X - a.X) * (to - a.Y) / (b.Y - a.Y);
        low = Math.Min(low, Math.Min(first, last));
        high = Math.Max(high, Math.Max(first, last));
    }

    private void Visit(bool onlyUp, Action<int, int> visit)
    {
        var min = _mesh.Bounds.Min;
        for (var t = 0; t < _mesh.TriangleCount; t++)
        {
            var (a, b, c) = _mesh.Triangle(t);
            Vec3 p = _mesh.RawVertices[a], q = _mesh.RawVertices[b], r = _mesh.RawVertices[c];
            // Upright ones have no height.
            var area = (q.X - p.X) * (r.Y - p.Y) - (q.Y - p.Y) * (r.X - p.X);
            if (area == 0 || (onlyUp && area < 0)) continue;
            var bottom = (int)((Math.Min(p.Y, Math.Min(q.Y, r.Y)) - min.Y) / _cell);
            var top = Math.Min(_rows - 1, (int)((Math.Max(p.Y, Math.Max(q.Y, r.Y)) - min.Y) / _cell));
            for (var row = bottom; row <= top; row++)
            {
                // Of the triangle only what lies in the row: a long one touches few of the cells around it.
                var (low, high) = (double.PositiveInfinity, double.NegativeInfinity);
                Widen(p, q, min.Y + row * _cell, ref low, ref high);
                Widen(q, r, min.Y + row * _cell, ref low, ref high);
                Widen(r, p, min.Y + row * _cell, ref low, ref high);
                if (low > high) continue;
                var left = Math.Max(0, (int)((low - min.X) / _cell - Rounding));
                var right = Math.Min(_columns - 1, (int)((high - min.X) / _cell + Rounding));
                for (var column = left; column <= right; column++) visit(row * _columns + column, t);
            }
        }
    }
}
