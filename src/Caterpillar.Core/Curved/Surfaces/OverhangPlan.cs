namespace Caterpillar.Curved;

/// <summary>
/// A plan that falls evenly with the distance from where the part stands on the bed, so that its layers descend outward and overhangs lean on what was printed
/// further in (as conical slicing does for round parts). The distance is exact at the nodes of a grid and linear between them.
/// </summary>
internal sealed class OverhangPlan : PlanSurface
{
    private const int Nodes = 400;
    private readonly double _slope;
    private readonly SlopeGrid _grid;
    private readonly double[] _distances;

    /// <param name="foot">Footprint of the part on the bed.</param>
    /// <param name="bounds">The part.</param>
    /// <param name="degrees">Angle of the layers.</param>
    public OverhangPlan(Region foot, Bounds bounds, double degrees)
    {
        var (sin, cos) = Angle.SinCos(degrees);
        _slope = sin / cos;
        var cell = Math.Max(0.25, Math.Max(bounds.Size.X, bounds.Size.Y) / Nodes);
        // A margin, so that what lies on the edge of the part has all of its nodes.
        _grid = new SlopeGrid(bounds.Min - new Vec3(2 * cell, 2 * cell), cell, (int)(bounds.Size.X / cell) + 6, (int)(bounds.Size.Y / cell) + 6);
        _distances = new double[_grid.Count];
        var edges = new List<(Vec3 A, Vec3 B)>();
        foreach (var contour in foot.Contours)
        {
            for (var i = 0; i < contour.Count; i++) edges.Add((contour[i], contour[i + 1 == contour.Count ? 0 : i + 1]));
        }
        var nearest = new int[_distances.Length];
        Sweep(foot, edges, nearest);
    }

    public override double Detail => 4 * _grid.Cell;

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
        var head = HeadSlope.Limit(setup, bounds.Size.LengthXY, bounds.Size.Z);
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
        var (near, u, v) = _grid.Locate(x, y);
        var far = near + _grid.Columns;
        var low = _distances[near] + (_distances[near + 1] - _distances[near]) * u;
        var high = _distances[far] + (_distances[far + 1] - _distances[far]) * u;
        return -_slope * (low + (high - low) * v);
    }

    // Each node takes the nearest edge of its neighbors, in four sweeps; distances to that edge are exact.
    private void Sweep(Region foot, List<(Vec3 A, Vec3 B)> edges, int[] nearest)
    {
        for (var i = 0; i < nearest.Length; i++) (nearest[i], _distances[i]) = (-1, double.PositiveInfinity);
        for (var e = 0; e < edges.Count; e++)
        {
            var (a, b) = edges[e];
            var steps = (int)(a.DistanceTo(b) / _grid.Cell * 2) + 1;
            for (var k = 0; k <= steps; k++)
            {
                var p = Vec3.Lerp(a, b, (double)k / steps);
                int i = (int)((p.X - _grid.Corner.X) / _grid.Cell), j = (int)((p.Y - _grid.Corner.Y) / _grid.Cell);
                for (var c = 0; c < 4; c++) Offer(i + (c & 1), j + (c >> 1), e, edges, nearest);
            }
        }
        for (var pass = 0; pass < 8; pass++)
        {
            int di = (pass & 1) == 0 ? 1 : -1, dj = (pass & 2) == 0 ? 1 : -1;
            for (var j = dj > 0 ? 0 : _grid.Rows - 1; j >= 0 && j < _grid.Rows; j += dj)
            {
                for (var i = di > 0 ? 0 : _grid.Columns - 1; i >= 0 && i < _grid.Columns; i += di)
                {
                    Take(i, j, i - di, j, edges, nearest);
                    Take(i, j, i, j - dj, edges, nearest);
                    Take(i, j, i - di, j - dj, edges, nearest);
                }
            }
        }
        for (var node = 0; node < _distances.Length; node++)
        {
            var place = _grid.At(node);
            if (foot.Contains(place.X, place.Y) || double.IsInfinity(_distances[node])) _distances[node] = 0;
        }
    }

    private void Take(int i, int j, int fromI, int fromJ, List<(Vec3 A, Vec3 B)> edges, int[] nearest)
    {
        if (fromI < 0 || fromJ < 0 || fromI >= _grid.Columns || fromJ >= _grid.Rows) return;
        var edge = nearest[fromJ * _grid.Columns + fromI];
        if (edge >= 0) Offer(i, j, edge, edges, nearest);
    }

    private void Offer(int i, int j, int edge, List<(Vec3 A, Vec3 B)> edges, int[] nearest)
    {
        var (a, b) = edges[edge];
        var node = j * _grid.Columns + i;
        var distance = Math.Sqrt(FlatSegment.SquareDistance(_grid.At(node), a, b));
        if (!(distance < _distances[node])) return;
        (_distances[node], nearest[node]) = (distance, edge);
    }
}
