namespace Caterpillar.Curved;

/// <summary>A plan at another place.</summary>
internal sealed class MovedPlan(PlanSurface plan, Vec3 shift) : PlanSurface
{
    public override double Detail => plan.Detail;

    internal override bool IsLevel => plan.IsLevel;

    public override double Height(double x, double y) => plan.Height(x - shift.X, y - shift.Y) + shift.Z;

    internal override (double ByX, double ByY) Slope(double x, double y) => plan.Slope(x - shift.X, y - shift.Y);

    public override bool Covers(double x, double y) => plan.Covers(x - shift.X, y - shift.Y);

    internal override void Check(DiagnosticList problems) => plan.Check(problems);
}
