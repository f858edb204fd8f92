namespace Caterpillar.Curved;

/// <summary>
/// A plan that falls evenly with the distance from where the part stands on the bed, so that its layers descend outward and overhangs lean on what was printed
/// further in (as conical slicing does for round parts). The distance is exact at the nodes of a grid and linear between them.
/// </summary>
internal sealed class OverhangPlan : PlanSurface
{
    private const int Nodes = 400;
    private readonly double _slope;
    private readonly double _cell;
    private readonly Vec3 _corner;
    private readonly int _columns;
    private readonly int _rows;
    private readonly double[] _distances;

    /// <param name="foot">Footprint of the part on the bed.</param>
    /// <param name="bounds">The part.</param>
    /// <param name="degrees">Angle of the layers.</param>
    public OverhangPlan(Region foot, Bounds bounds, double degrees)
    {
        var (sin, cos) = Angle.SinCos(degrees);
        _slope = sin / cos;
        _cell = Math.Max(0.25, Math.Max(bounds.Size.X, bounds.Size.Y) / Nodes);
        // A margin, so that what lies on the edge of the part has all of its nodes.
        _corner = bounds.Min - new Vec3(2 * _cell, 2 * _cell);
        _columns = (int)(bounds.Size.X / _cell) + 6;
        _rows = (int)(bounds.Size.Y / _cell) + 6;
        _distances = new double[_columns * _rows];
        var edges = new List<(Vec3 A, Vec3 B)>();
        foreach (var contour in foot.Contours)
        {
            for (var i = 0; i < contour.Count; i++) edges.Add((contour[i], contour[i + 1 == contour.Count ? 0 : i + 1]));
        }
        var nearest = new int[_distances.Length];
        Sweep(foot, edges, nearest);
    }

    public override double Detail => 4 * _cell;

    public static Result<PlanSurface> For(IReadOnlyList<NamedMesh> models, PrintSetup setup, double? degrees)
    {
        var first = setup.Settings.FirstLayerHeight;
        var foot = Region.Empty;
        var bounds = Bounds.Empty;
        foreach (var model in models)
        {
            bounds = bounds.Include(model.Mesh.Bounds);
            var section = MeshSections.At(model.Mesh, [first / 2], new SectionOptions(), null, default).Value![0];
            foot = foot.Union(Region.From(section.Loops, FillRule.NonZero, false, new RegionEngine()));
        }
        if (foot.IsEmpty)
        {
            return new Result<PlanSurface>(null, [new Diagnostic(Severity.Error, "curved.nothing_on_bed",
                "No part touches the bed, so layers cannot descend from it to the overhangs.")]);
        }
        const double Steep = 45;
        var head = setup.Settings.CurvedMaxSlope > 0 ? setup.Settings.CurvedMaxSlope
            : HeadSlope.Limit(setup.Printer, bounds.Size.LengthXY, bounds.Size.Z);
        // A degree less than the limit: what is computed reaches it.
        var angle = degrees ?? AngleFor(models.Select(m => m.Mesh), foot, 2 * first, Steep, Math.Max(0, head - 1));
        return new Result<PlanSurface>(new OverhangPlan(foot, bounds, angle), []);
    }

    /// <summary>The angle that makes the flattest overhang as steep as <paramref name="wanted"/> degrees from the horizontal, at most a limit.</summary>
    public static double AngleFor(IEnumerable<TriMesh> meshes, Region foot, double above, double wanted, double limit)
    {
        var (sin, cos) = Angle.SinCos(wanted);
        var flattest = double.PositiveInfinity;
        foreach (var mesh in meshes)
        {
            for (var t = 0; t < mesh.TriangleCount; t++)
            {
                var normal = mesh.Normal(t);
                var (a, b, c) = mesh.Triangle(t);
                var top = Math.Max(mesh.Vertices[a].Z, Math.Max(mesh.Vertices[b].Z, mesh.Vertices[c].Z));
                var center = (mesh.Vertices[a] + mesh.Vertices[b] + mesh.Vertices[c]) / 3;
                // Over the foot layers are level whatever the angle.
                if (normal.Z < -1e-6 && top > above && !foot.Contains(center.X, center.Y)) flattest = Math.Min(flattest, normal.LengthXY / -normal.Z);
            }
        }
        return Math.Min(limit, Math.Max(0, Angle.Atan2(sin / cos - flattest, 1)));
    }

    public override double Height(double x, double y)
    {
        var u = Math.Max(0, Math.Min(_columns - 1.001, (x - _corner.X) / _cell));
        var v = Math.Max(0, Math.Min(_rows - 1.001, (y - _corner.Y) / _cell));
        int i = (int)u, j = (int)v, at = j * _columns + i;
        var low = _distances[at] + (_distances[at + 1] - _distances[at]) * (u - i);
        var high = _distances[at + _columns] + (_distances[at + _columns + 1] - _distances[at + _columns]) * (u - i);
        return -_slope * (low + (high - low) * (v - j));
    }

    // Each node takes the nearest edge of its neighbors, in four sweeps; distances to that edge are exact.
    private void Sweep(Region foot, List<(Vec3 A, Vec3 B)> edges, int[] nearest)
    {
        for (var i = 0; i < nearest.Length; i++) (nearest[i], _distances[i]) = (-1, double.PositiveInfinity);
        for (var e = 0; e < edges.Count; e++)
        {
            var (a, b) = edges[e];
            var steps = (int)(a.DistanceTo(b) / _cell * 2) + 1;
            for (var k = 0; k <= steps; k++)
            {
                var p = Vec3.Lerp(a, b, (double)k / steps);
                int i = (int)((p.X - _corner.X) / _cell), j = (int)((p.Y - _corner.Y) / _cell);
                for (var c = 0; c < 4; c++) Offer(i + (c & 1), j + (c >> 1), e, edges, nearest);
            }
        }
        for (var pass = 0; pass < 8; pass++)
        {
            int di = (pass & 1) == 0 ? 1 : -1, dj = (pass & 2) == 0 ? 1 : -1;
            for (var j = dj > 0 ? 0 : _rows - 1; j >= 0 && j < _rows; j += dj)
            {
                for (var i = di > 0 ? 0 : _columns - 1; i >= 0 && i < _columns; i += di)
                {
                    Take(i, j, i - di, j, edges, nearest);
                    Take(i, j, i, j - dj, edges, nearest);
                    Take(i, j, i - di, j - dj, edges, nearest);
                }
            }
        }
        for (var j = 0; j < _rows; j++)
        {
            for (var i = 0; i < _columns; i++)
            {
                var inside = foot.Contains(_corner.X + i * _cell, _corner.Y + j * _cell);
                if (inside || double.IsInfinity(_distances[j * _columns + i])) _distances[j * _columns + i] = 0;
            }
        }
    }

    private void Take(int i, int j, int fromI, int fromJ, List<(Vec3 A, Vec3 B)> edges, int[] nearest)
    {
        if (fromI < 0 || fromJ < 0 || fromI >= _columns || fromJ >= _rows) return;
        var edge = nearest[fromJ * _columns + fromI];
        if (edge >= 0) Offer(i, j, edge, edges, nearest);
    }

    private void Offer(int i, int j, int edge, List<(Vec3 A, Vec3 B)> edges, int[] nearest)
    {
        if (i < 0 || j < 0 || i >= _columns || j >= _rows) return;
        var (a, b) = edges[edge];
        var p = new Vec3(_corner.X + i * _cell, _corner.Y + j * _cell);
        var distance = Math.Sqrt(FlatSegment.SquareDistance(p, a, b));
        if (!(distance < _distances[j * _columns + i])) return;
        _distances[j * _columns + i] = distance;
        nearest[j * _columns + i] = edge;
    }
}
