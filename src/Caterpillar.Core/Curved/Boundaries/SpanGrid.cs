namespace Caterpillar.Curved;

/// <summary>
/// The heights of layers whose outlines on a mesh are known, over the nodes of a grid in plan: inside of their outlines layers span them (mean value
/// coordinates), and go on a little beyond. Between nodes and between levels heights are linear.
/// </summary>
internal sealed class SpanGrid(Bounds bounds, double cell, double[] levels)
{
    // Nodes around the part. Steps between nodes within which heights around outlines are their own; farther out those of the nearest ones count.
    private const int Margin = 3;
    private const int Around = 9;
    private const double LeastGap = 1e-5;

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
            // A level without curves lies on the one below; beyond their outlines levels might cross.
            if (grid._heights[i].Length == 0) grid._heights[i] = Enumerable.Repeat(mesh.Bounds.Min.Z, grid._nodes.Count).ToArray();
            for (var n = 0; i > 0 && n < grid._nodes.Count; n++) grid._heights[i][n] = Math.Max(grid._heights[i][n], grid._heights[i - 1][n] + LeastGap);
        }
        return grid;
    }

    /// <summary>The height of a level over a place, mm.</summary>
    public double Height(double x, double y, double level)
    {
        var place = _nodes.Locate(x, y);
        var i = Array.BinarySearch(levels, level);
        i = Math.Min(Math.Max(i < 0 ? ~i - 1 : i, 0), levels.Length - 2);
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

    private double[] Spanned(List<Vec3[]> curves)
    {
        if (curves.Count == 0) return [];
        var islands = SpanIsland.Of(curves);
        var owners = SpanIsland.Owners(islands, _nodes);
        var steps = Enumerable.Repeat(-1, _nodes.Count).ToArray();
        var heights = new double[_nodes.Count];
        var outlines = new List<int>();
        for (var i = 0; i < islands.Count; i++)
        {
            foreach (var n in islands[i].NodesAlong(_nodes))
            {
                if (steps[n] == 0) continue;
                if (owners[n] < 0) owners[n] = i;
                steps[n] = 0;
                heights[n] = Span(n);
                outlines.Add(n);
            }
        }
        // Also around outlines: what leans out lies there, above the level below. Farther out nodes take the height of the nearest ones.
        _nodes.Grow(outlines, (from, to) =>
        {
            if (steps[to] >= 0) return false;
            steps[to] = steps[from] + 1;
            var inside = owners[to] >= 0;
            if (!inside) owners[to] = owners[from];
            heights[to] = inside || steps[to] <= Around ? Span(to) : heights[from];
            return true;
        });
        return heights;

        double Span(int n)
        {
            var (x, y, _) = _nodes.At(n);
            return islands[owners[n]].Height(x, y, steps[n]);
        }
    }
}
