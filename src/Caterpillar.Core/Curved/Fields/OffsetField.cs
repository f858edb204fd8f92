namespace Caterpillar.Curved;

/// <summary>
/// Layers at equal distances from a surface: its normal offsets. Where those would run into each other, on the hollow side, the distance keeps them apart along
/// a crease.
/// </summary>
internal sealed class OffsetField(TriMesh mesh, bool partial = false) : LayerField
{
    private readonly MeshDistance _distance = new(mesh);
    private readonly MeshHeights _heights = new(mesh);

    // −1 for a surface that faces down.
    private readonly double _side = !mesh.IsWatertight && Enumerable.Range(0, mesh.TriangleCount).Sum(t => mesh.Normal(t).Z) < 0 ? -1 : 1;

    public override double Detail { get; } = Math.Max(0.25, Math.Sqrt(2 * mesh.Area / mesh.TriangleCount));

    public override double Value(Vec3 point) => _side * _distance.Nearest(point).Distance;

    public override double Height(double x, double y, double value)
    {
        var under = _heights.TopUnder(x, y);
        if (double.IsInfinity(under)) return base.Height(x, y, value);
        // The distance changes along its own direction by as much as one moves.
        var z = under + value;
        for (var i = 0; i < 12; i++)
        {
            var near = _distance.Nearest(new Vec3(x, y, z));
            var rest = _side * near.Distance - value;
            if (Math.Abs(rest) < 1e-10) return z;
            var rise = Math.Abs(near.Distance) > 1e-6 ? (z - near.Point.Z) / near.Distance : near.Normal.Z;
            rise *= _side;
            if (!(rise > 0.05)) break;
            z -= rest / rise;
        }
        return base.Height(x, y, value);
    }

    public override Vec3 Normal(Vec3 point)
    {
        var near = _distance.Nearest(point);
        var normal = Math.Abs(near.Distance) > 1e-6 ? (point - near.Point) / near.Distance : near.Normal;
        return normal * _side;
    }

    internal override void Check(DiagnosticList problems) => PlanSurface.Of(mesh).Check(problems);

    public override bool Covers(double x, double y) => !partial || !double.IsInfinity(_heights.TopUnder(x, y));

    internal override LayerField ForPartial() => new OffsetField(mesh, true);

    internal override LayerField FitTo(PartColumns part, PrintSettings settings, DiagnosticList problems)
    {
        foreach (var column in part.Columns)
        {
            if (!partial && !Rises(column, problems)) return this;
        }
        return Anchored(this, part, settings);
    }

    private bool Rises(Column column, DiagnosticList problems)
    {
        // mm: parts as large as their plan reach over its edge by rounding.
        const double Edge = 0.05;
        foreach (var z in new[] { column.Low, column.High })
        {
            var at = new Vec3(column.X, column.Y, z);
            var near = _distance.Nearest(at);
            var aside = (at - near.Point - near.Normal * Vec3.Dot(at - near.Point, near.Normal)).Length;
            if (near.OnRim && aside > Edge)
            {
                problems.Add(Severity.Error, "curved.outside_plan",
                    $"The surface has no point below {at} along its normal: it is too small for the part or has a hole.");
                return false;
            }
            if (!(Normal(at).Z > 1e-3))
            {
                problems.Add(Severity.Error, "curved.overhanging_layers", $"Layers are vertical or overhang at {at}. A nozzle from above cannot print them.");
                return false;
            }
        }
        return true;
    }
}
