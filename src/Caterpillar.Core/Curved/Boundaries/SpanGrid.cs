namespace Caterpillar.Curved;

/// <summary>
/// The heights of layers whose outlines on a mesh are known, over the nodes of a grid in plan: inside of their outlines layers span them (mean value
/// coordinates), and go on a little beyond. Between nodes and between levels heights are linear.
/// </summary>
internal sealed class SpanGrid(Bounds bounds, double cell, double[] levels)
{
    // Nodes around the outlines that are found exactly; farther out the nearest of them counts.
    private const int Margin = 3;

    private readonly SlopeGrid _nodes = new(bounds.Min - new Vec3(Margin * cell, Margin * cell), cell,
        (int)Math.Ceiling(bounds.Size.X / cell) + 2 * Margin + 1, (int)Math.Ceiling(bounds.Size.Y / cell) + 2 * Margin + 1);

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
        Parallel.For(0, levels.Length, i => grid._heights[i] = grid.Spanned(curves.Trace(i, 0.004).Where(c => c.Count > 2).Select(c => c.Raw).ToList()));
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
        var place = _nodes.Locate(x, y);
        var i = Below(level);
        double low = _nodes.Between(_heights[i], place), high = _nodes.Between(_heights[i + 1], place);
        return low + (high - low) * (level - levels[i]) / (levels[i + 1] - levels[i]);
    }

    /// <summary>The level at a place in space.</summary>
    public double Level(Vec3 p)
    {
        var place = _nodes.Locate(p.X, p.Y);
        var low = Search.First(1, levels.Length - 1, (_nodes, _heights, place, p.Z), static (s, i) => s._nodes.Between(s._heights[i], s.place) > s.Z) - 1;
        double from = _nodes.Between(_heights[low], place), to = _nodes.Between(_heights[low + 1], place);
        return levels[low] + (levels[low + 1] - levels[low]) * (p.Z - from) / (to - from);
    }

    private int Below(double level)
    {
        var i = Array.BinarySearch(levels, level);
        return Math.Min(Math.Max(i < 0 ? ~i - 1 : i, 0), levels.Length - 2);
    }

    private double[] Flat(double height) => Enumerable.Repeat(height, _nodes.Count).ToArray();

    private double[] Spanned(List<Vec3[]> curves)
    {
        if (curves.Count == 0) return [];
        var result = Flat(double.NaN);
        var spans = SpanIslands.Of(curves);
        // Also around outlines: what leans out lies there, above the level below.
        var reached = spans.ConvertAll(s => s.Bounds.Grow((Margin + 1) * Cell));
        for (var n = 0; n < result.Length; n++)
        {
            var (x, y, _) = _nodes.At(n);
            if (reached.Exists(b => b.Contains(new Vec3(x, y, b.Min.Z)))) result[n] = SpanIslands.Nearest(spans, x, y).Height(x, y);
        }
        Spread(result);
        return result;
    }

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
                int column = n % _nodes.Columns, row = n / _nodes.Columns;
                if (column > 0) Take(n, n - 1);
                if (column + 1 < _nodes.Columns) Take(n, n + 1);
                if (row > 0) Take(n, n - _nodes.Columns);
                if (row + 1 < _nodes.Rows) Take(n, n + _nodes.Columns);
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
