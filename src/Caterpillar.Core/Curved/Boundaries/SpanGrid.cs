namespace Caterpillar.Curved;

/// <summary>
/// The heights of layers whose outlines on a mesh are known, over the nodes of a grid in plan: inside of their outlines layers span them (mean value
/// coordinates), and go on a little beyond. Between nodes and between levels heights are linear.
/// </summary>
internal sealed class SpanGrid(Bounds bounds, double cell, double[] levels)
{
    // Nodes around the outlines that are found exactly; farther out the nearest of them counts.
    private const int Margin = 3;

    private readonly double _x = bounds.Min.X - Margin * cell;
    private readonly double _y = bounds.Min.Y - Margin * cell;
    private readonly int _columns = (int)Math.Ceiling(bounds.Size.X / cell) + 2 * Margin + 1;
    private readonly int _rows = (int)Math.Ceiling(bounds.Size.Y / cell) + 2 * Margin + 1;

    // For each level, row by row.
    private readonly double[][] _heights = new double[levels.Length][];

    /// <summary>Distance of nodes, mm.</summary>
    public double Cell { get; } = cell;

    /// <summary>Heights from the level curves of values at the vertices of a mesh.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="values">One for each vertex, rising from 0.</param>
    /// <param name="levels">Ascending, at least two.</param>
    public static SpanGrid Of(TriMesh mesh, double[] values, double[] levels)
    {
        var size = mesh.Bounds.Size;
        var grid = new SpanGrid(mesh.Bounds, Math.Min(2, Math.Max(0.3, Math.Max(size.X, size.Y) / 120)), levels);
        // The first and the last level lie on boundaries, which may be whole faces.
        var inside = (double[])levels.Clone();
        var edge = 1e-6 * levels[levels.Length - 1];
        for (var i = 0; i < inside.Length; i++) inside[i] = Math.Min(Math.Max(inside[i], edge), levels[levels.Length - 1] - edge);
        var curves = new LevelCurves(mesh, values, inside);
        Parallel.For(0, levels.Length, i => grid._heights[i] = grid.Spanned(curves.Trace(i, 0.002).Where(c => c.Count > 2).Select(c => c.Raw).ToList()));
        for (var i = 0; i < levels.Length; i++)
        {
            // A level without curves lies on the one below.
            if (grid._heights[i].Length == 0) grid._heights[i] = i > 0 ? grid._heights[i - 1] : grid.Flat(mesh.Bounds.Min.Z);
        }
        grid.Rise();
        return grid;
    }

    /// <summary>The height of a level over a place, mm.</summary>
    public double Height(double x, double y, double level)
    {
        var (node, u, v) = Locate(x, y);
        var i = Below(level);
        double low = At(i, node, u, v), high = At(i + 1, node, u, v);
        return low + (high - low) * (level - levels[i]) / (levels[i + 1] - levels[i]);
    }

    /// <summary>The level at a place in space.</summary>
    public double Level(Vec3 p)
    {
        var (node, u, v) = Locate(p.X, p.Y);
        var low = Search.First(1, levels.Length - 1, (Grid: this, node, u, v, p.Z), static (s, i) => s.Grid.At(i, s.node, s.u, s.v) > s.Z) - 1;
        double from = At(low, node, u, v), to = At(low + 1, node, u, v);
        return levels[low] + (levels[low + 1] - levels[low]) * (p.Z - from) / (to - from);
    }

    private int Below(double level)
    {
        var i = Array.BinarySearch(levels, level);
        return Math.Min(Math.Max(i < 0 ? ~i - 1 : i, 0), levels.Length - 2);
    }

    private (int Node, double U, double V) Locate(double x, double y)
    {
        double u = Math.Min(Math.Max((x - _x) / Cell, 0), _columns - 1.000001), v = Math.Min(Math.Max((y - _y) / Cell, 0), _rows - 1.000001);
        int column = (int)u, row = (int)v;
        return (row * _columns + column, u - column, v - row);
    }

    private double At(int level, int node, double u, double v)
    {
        var z = _heights[level];
        double low = z[node] + (z[node + 1] - z[node]) * u, high = z[node + _columns] + (z[node + _columns + 1] - z[node + _columns]) * u;
        return low + (high - low) * v;
    }

    private double[] Flat(double height) => Enumerable.Repeat(height, _columns * _rows).ToArray();

    private double[] Spanned(List<Vec3[]> curves)
    {
        if (curves.Count == 0) return [];
        var result = Flat(double.NaN);
        var spans = SpanIslands.Of(curves);
        foreach (var (_, bounds) in spans)
        {
            var (left, right) = Range(bounds.Min.X - _x, bounds.Max.X - _x, _columns);
            var (bottom, top) = Range(bounds.Min.Y - _y, bounds.Max.Y - _y, _rows);
            for (var j = bottom; j <= top; j++)
            {
                for (var i = left; i <= right; i++)
                {
                    if (!double.IsNaN(result[j * _columns + i])) continue;
                    double x = _x + i * Cell, y = _y + j * Cell;
                    result[j * _columns + i] = SpanIslands.Nearest(spans, x, y).Height(x, y);
                }
            }
        }
        Spread(result);
        return result;
    }

    private (int From, int To) Range(double low, double high, int count)
        => (Math.Max(0, (int)Math.Floor(low / Cell) - Margin), Math.Min(count - 1, (int)Math.Ceiling(high / Cell) + Margin));

    // Nodes without a height take that of their neighbors, from the known ones outward.
    private void Spread(double[] heights)
    {
        var front = new List<int>();
        for (var n = 0; n < heights.Length; n++)
        {
            if (!double.IsNaN(heights[n])) front.Add(n);
        }
        while (front.Count > 0)
        {
            var next = new List<int>();
            foreach (var n in front)
            {
                int column = n % _columns, row = n / _columns;
                if (column > 0) Take(n, n - 1);
                if (column + 1 < _columns) Take(n, n + 1);
                if (row > 0) Take(n, n - _columns);
                if (row + 1 < _rows) Take(n, n + _columns);
            }
            front = next;

            void Take(int from, int to)
            {
                if (!double.IsNaN(heights[to])) return;
                heights[to] = heights[from];
                next.Add(to);
            }
        }
    }

    // Beyond their outlines layers might cross.
    private void Rise()
    {
        const double Least = 1e-5;
        for (var i = 1; i < _heights.Length; i++)
        {
            if (ReferenceEquals(_heights[i], _heights[i - 1])) _heights[i] = (double[])_heights[i].Clone();
            for (var n = 0; n < _heights[i].Length; n++) _heights[i][n] = Math.Max(_heights[i][n], _heights[i - 1][n] + Least);
        }
    }
}
