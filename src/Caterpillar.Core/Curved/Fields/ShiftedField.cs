namespace Caterpillar.Curved;

/// <summary>A field with a constant added.</summary>
internal sealed class ShiftedField(LayerField inner, double shift) : LayerField
{
    public override double Detail => inner.Detail;

    public override bool StartsLevel => inner.StartsLevel;

    internal override IReadOnlyList<double> Creases { get; } = inner.Creases.Select(v => v + shift).ToArray();

    internal override bool BendsPlan => inner.BendsPlan;

    internal override double Spread(Vec3 point) => inner.Spread(point);

    internal override double Span(Vec3 step) => inner.Span(step);

    public override double Value(Vec3 point) => inner.Value(point) + shift;

    public override double Height(double x, double y, double value) => inner.Height(x, y, value - shift);

    public override bool Covers(double x, double y) => inner.Covers(x, y);

    public override Vec3 Normal(Vec3 point) => inner.Normal(point);

    public override Vec3 ToFlat(Vec3 point)
    {
        var flat = inner.ToFlat(point);
        return flat.WithZ(flat.Z + shift);
    }

    public override Vec3 ToPart(Vec3 flat) => inner.ToPart(flat.WithZ(flat.Z - shift));

    internal override (double First, double Second) Heights(double x, double y, double first, double second)
        => inner.Heights(x, y, first - shift, second - shift);

    internal override LiftedPoint Lift(Vec3 flat, double thickness) => inner.Lift(flat.WithZ(flat.Z - shift), thickness);
}
