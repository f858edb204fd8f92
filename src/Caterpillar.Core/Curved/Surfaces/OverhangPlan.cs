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
        for (var node = 0; node < _distances.Length; node++)
        {
            var place = _grid.At(node);
            if (!foot.Contains(place.X, place.Y) && foot.NearestEdge(place) is { } edge) _distances[node] = place.DistanceTo(edge);
        }
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

    public override double Height(double x, double y) => -_slope * _grid.Between(_distances, _grid.Locate(x, y));
}
