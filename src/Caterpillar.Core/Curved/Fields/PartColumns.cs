namespace Caterpillar.Curved;

/// <summary>
/// Sample columns of a part: places in plan with the lowest and the highest point of the part over them. Fields take their constants from them.
/// </summary>
internal sealed class PartColumns(IReadOnlyList<Column> columns, Bounds bounds)
{
    /// <summary>Columns of the grid along each axis.</summary>
    public const int Cells = 96;

    public IReadOnlyList<Column> Columns { get; } = columns;

    public Bounds Bounds { get; } = bounds;

    /// <summary>Samples of meshes: a grid over their plan, and their vertices.</summary>
    public static PartColumns Of(IEnumerable<TriMesh> meshes)
    {
        var columns = new List<Column>();
        var solids = meshes.Where(m => m.TriangleCount > 0).ToArray();
        foreach (var mesh in solids) Sample(mesh, columns);
        return new PartColumns(columns, solids.Aggregate(Bounds.Empty, (bounds, mesh) => bounds.Include(mesh.Bounds)));
    }

    private static void Sample(TriMesh mesh, List<Column> columns)
    {
        var box = mesh.Bounds;
        double stepX = Math.Max(box.Size.X / Cells, 1e-6), stepY = Math.Max(box.Size.Y / Cells, 1e-6);
        var low = new double[Cells * Cells];
        var high = new double[Cells * Cells];
        for (var i = 0; i < low.Length; i++) (low[i], high[i]) = (double.PositiveInfinity, double.NegativeInfinity);
        var vertices = mesh.RawVertices;
        var triangles = mesh.RawTriangles;
        for (var t = 0; t < triangles.Length; t += 3)
        {
            Vec3 a = vertices[triangles[t]], b = vertices[triangles[t + 1]], c = vertices[triangles[t + 2]];
            var area = (b.X - a.X) * (c.Y - a.Y) - (b.Y - a.Y) * (c.X - a.X);
            if (area == 0) continue;
            var lastRow = Cell(Math.Max(a.Y, Math.Max(b.Y, c.Y)), box.Min.Y, stepY);
            var lastColumn = Cell(Math.Max(a.X, Math.Max(b.X, c.X)), box.Min.X, stepX);
            for (var row = Cell(Math.Min(a.Y, Math.Min(b.Y, c.Y)), box.Min.Y, stepY); row <= lastRow; row++)
            {
                for (var column = Cell(Math.Min(a.X, Math.Min(b.X, c.X)), box.Min.X, stepX); column <= lastColumn; column++)
                {
                    double x = box.Min.X + (column + 0.5) * stepX, y = box.Min.Y + (row + 0.5) * stepY;
                    var u = ((b.X - x) * (c.Y - y) - (b.Y - y) * (c.X - x)) / area;
                    var v = ((c.X - x) * (a.Y - y) - (c.Y - y) * (a.X - x)) / area;
                    var w = 1 - u - v;
                    if (u < 0 || v < 0 || w < 0) continue;
                    var z = a.Z * u + b.Z * v + c.Z * w;
                    var cell = row * Cells + column;
                    if (z < low[cell]) low[cell] = z;
                    if (z > high[cell]) high[cell] = z;
                }
            }
        }
        for (var i = 0; i < low.Length; i++)
        {
            if (low[i] > high[i]) continue;
            columns.Add(new Column(box.Min.X + (i % Cells + 0.5) * stepX, box.Min.Y + (i / Cells + 0.5) * stepY, low[i], high[i]));
        }
        // Vertices hold the extremes; of fine meshes a part of them will do.
        var every = Math.Max(1, vertices.Length / 20_000);
        for (var i = 0; i < vertices.Length; i += every) columns.Add(new Column(vertices[i].X, vertices[i].Y, vertices[i].Z, vertices[i].Z));
    }

    private static int Cell(double value, double from, double step) => Math.Min(Cells - 1, Math.Max(0, (int)((value - from) / step - 0.5)));
}

/// <summary>A place of a part in plan, mm, with its lowest and highest point there.</summary>
internal readonly record struct Column(double X, double Y, double Low, double High);
