namespace Caterpillar.Toolpaths;

/// <summary>
/// The top of an object under the print, for checks: exact heights, and lines over its surface for collisions of the head. The lines are at most 0.005 mm above
/// the surface, so that a nozzle that follows the surface does not collide. Immutable.
/// </summary>
internal sealed class ObjectTop
{
    // Lengths in mm.
    private const double Tolerance = 0.005;
    private const double Peak = 0.02;

    // Lines and places along them at most.
    private const int MostSamples = 1000;

    // Nothing of an object is forgotten.
    private const double KeepDepth = 1e6;
    private readonly MeshHeights _heights;

    /// <param name="mesh">The object.</param>
    /// <param name="cell">Distance of lines, mm. Larger on large objects.</param>
    public ObjectTop(TriMesh mesh, double cell)
    {
        _heights = new MeshHeights(mesh);
        Lines = new Deposit(cell, KeepDepth);
        if (mesh.TriangleCount > 0) AddLines(mesh, Math.Max(cell, Math.Max(mesh.Bounds.Size.X, mesh.Bounds.Size.Y) / MostSamples));
    }

    /// <summary>The lines over the surface, for collisions of the head.</summary>
    public Deposit Lines { get; }

    /// <summary>Highest point of the object at a place, not above a limit, mm. Negative infinity = none.</summary>
    public double Under(double x, double y, double limit) => _heights.TopUnder(x, y, limit);

    private void AddLines(TriMesh mesh, double step)
    {
        Vec3 min = mesh.Bounds.Min, size = mesh.Bounds.Size;
        int columns = Math.Max(1, (int)Math.Ceiling(size.X / step)), rows = Math.Max(1, (int)Math.Ceiling(size.Y / step));
        double X(int column) => min.X + size.X * column / columns;
        double Y(int row) => min.Y + size.Y * row / rows;
        var tops = new double[rows + 1][];
        Parallel.For(0, tops.Length, row =>
        {
            var line = new double[columns + 1];
            for (var column = 0; column <= columns; column++) line[column] = _heights.TopUnder(X(column), Y(row));
            tops[row] = line;
        });
        for (var row = 0; row <= rows; row++)
        {
            for (var first = 0; first <= columns; first++)
            {
                if (double.IsInfinity(tops[row][first])) continue;
                var last = Straight(tops[row], first, size.X / columns);
                Lines.Add(new Vec3(X(first), Y(row), tops[row][first]), new Vec3(X(last), Y(row), tops[row][last]), 0);
                if (last > first && last < columns) last--;
                first = last;
            }
        }
        if (!(size.X > 0 && size.Y > 0)) return;
        // Peaks between the lines.
        foreach (var p in mesh.RawVertices)
        {
            int column = (int)Math.Min(columns - 1, (p.X - min.X) / size.X * columns), row = (int)Math.Min(rows - 1, (p.Y - min.Y) / size.Y * rows);
            var around = Math.Max(Math.Max(tops[row][column], tops[row][column + 1]), Math.Max(tops[row + 1][column], tops[row + 1][column + 1]));
            if (p.Z > around + Peak) Lines.Add(p, p, 0);
        }
    }

    // The last place up to which heights lie on a line.
    private static int Straight(double[] heights, int first, double step)
    {
        var (least, most) = (double.NegativeInfinity, double.PositiveInfinity);
        var last = first;
        for (var i = first + 1; i < heights.Length && !double.IsInfinity(heights[i]); i++)
        {
            var run = (i - first) * step;
            var slope = (heights[i] - heights[first]) / run;
            if (!(slope >= least && slope <= most)) break;
            least = Math.Max(least, slope - Tolerance / run);
            most = Math.Min(most, slope + Tolerance / run);
            last = i;
        }
        return last;
    }
}
