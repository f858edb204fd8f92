namespace Caterpillar.Curved;

/// <summary>A plan that is moved, scaled, or rotated about Z.</summary>
internal sealed class TransformedPlan(PlanSurface plan, Affine map) : PlanSurface
{
    private readonly Affine _back = map.Inverse;

    public override double Detail => plan.Detail * Math.Min(map.XAxis.Length, map.YAxis.Length);

    internal override bool IsLevel => plan.IsLevel;

    public override double Height(double x, double y)
    {
        var place = _back.Apply(new Vec3(x, y));
        return plan.Height(place.X, place.Y) * map.ZAxis.Z + map.Shift.Z;
    }

    internal override (double ByX, double ByY) Slope(double x, double y)
    {
        var place = _back.Apply(new Vec3(x, y));
        var (byX, byY) = plan.Slope(place.X, place.Y);
        return (map.ZAxis.Z * (byX * _back.XAxis.X + byY * _back.XAxis.Y), map.ZAxis.Z * (byX * _back.YAxis.X + byY * _back.YAxis.Y));
    }

    public override bool Covers(double x, double y)
    {
        var place = _back.Apply(new Vec3(x, y));
        return plan.Covers(place.X, place.Y);
    }

    internal override void Check(DiagnosticList problems) => plan.Check(problems);
}
