using System;

namespace Caterpillar.Geometry;

/// <summary>
/// Heights of a surface above points of the XY plane: the triangles in a grid of cells, so that a query looks at only a few of them. Vertical triangles
/// have no height. Immutable.
/// </summary>
public sealed class MeshHeights
{
    private const int MaxCells = 1 << 22;
    private readonly TriMesh _mesh;
    private readonly double _cell;
    private readonly int _columns;
    private readonly int _rows;
    private readonly int[] _firsts;
    private readonly int[] _items;

    public MeshHeights(TriMesh mesh)
    {
        _mesh = mesh ?? throw new ArgumentNullException(nameof(mesh));
        var size = mesh.Bounds.Size;
        // As many cells as triangles: one or two of them in each.
        var count = Math.Min(Math.Max(mesh.TriangleCount, 1), MaxCells);
        _cell = Math.Max(Math.Sqrt(size.X * size.Y / count), Math.Max(size.X, size.Y) / 4096);
        if (!(_cell > 0)) _cell = 1;
        _columns = (int)(size.X / _cell) + 1;
        _rows = (int)(size.Y / _cell) + 1;
        _firsts = new int[_columns * _rows + 1];
        Visit((cell, _) => _firsts[cell + 1]++);
        for (var i = 0; i + 1 < _firsts.Length; i++) _firsts[i + 1] += _firsts[i];
        _items = new int[_firsts[_firsts.Length - 1]];
        var next = (int[])_firsts.Clone();
        Visit((cell, triangle) => _items[next[cell]++] = triangle);
    }

    /// <summary>
    /// Highest point of the surface, mm, on the vertical through (x, y) and not above <paramref name="limit"/>; negative infinity if there is none.
    /// </summary>
    public double TopUnder(double x, double y, double limit = double.PositiveInfinity)
    {
        var best = double.NegativeInfinity;
        var min = _mesh.Bounds.Min;
        var column = (x - min.X) / _cell;
        var row = (y - min.Y) / _cell;
        if (!(column >= 0 && row >= 0 && column < _columns && row < _rows) || _mesh.TriangleCount == 0) return best;
        var cell = (int)row * _columns + (int)column;
        for (var i = _firsts[cell]; i < _firsts[cell + 1]; i++)
        {
            var (a, b, c) = _mesh.Triangle(_items[i]);
            var z = HeightOn(_mesh.Vertices[a], _mesh.Vertices[b], _mesh.Vertices[c], x, y);
            if (z <= limit && z > best) best = z;
        }
        return best;
    }

    // NaN outside the triangle; points on an edge belong to both of its triangles.
    private static double HeightOn(Vec3 a, Vec3 b, Vec3 c, double x, double y)
    {
        var area = (b.X - a.X) * (c.Y - a.Y) - (b.Y - a.Y) * (c.X - a.X);
        if (area == 0) return double.NaN;
        var u = ((b.X - x) * (c.Y - y) - (b.Y - y) * (c.X - x)) / area;
        var v = ((c.X - x) * (a.Y - y) - (c.Y - y) * (a.X - x)) / area;
        var w = ((a.X - x) * (b.Y - y) - (a.Y - y) * (b.X - x)) / area;
        return u >= 0 && v >= 0 && w >= 0 ? a.Z * u + b.Z * v + c.Z * w : double.NaN;
    }

    private void Visit(Action<int, int> visit)
    {
        var min = _mesh.Bounds.Min;
        for (var t = 0; t < _mesh.TriangleCount; t++)
        {
            var (a, b, c) = _mesh.Triangle(t);
            Vec3 p = _mesh.Vertices[a], q = _mesh.Vertices[b], r = _mesh.Vertices[c];
            var left = (int)((Math.Min(p.X, Math.Min(q.X, r.X)) - min.X) / _cell);
            var right = Math.Min(_columns - 1, (int)((Math.Max(p.X, Math.Max(q.X, r.X)) - min.X) / _cell));
            var bottom = (int)((Math.Min(p.Y, Math.Min(q.Y, r.Y)) - min.Y) / _cell);
            var top = Math.Min(_rows - 1, (int)((Math.Max(p.Y, Math.Max(q.Y, r.Y)) - min.Y) / _cell));
            for (var row = bottom; row <= top; row++)
            {
                for (var column = left; column <= right; column++) visit(row * _columns + column, t);
            }
        }
    }
}
