namespace Caterpillar.Curved;

/// <summary>A field with a constant added.</summary>
internal sealed class ShiftedField(LayerField inner, double shift) : WrappedField(inner)
{
    internal override IReadOnlyList<double> Creases { get; } = inner.Creases.Select(v => v + shift).ToArray();

    public override double Value(Vec3 point) => Inner.Value(point) + shift;

    public override double Height(double x, double y, double value) => Inner.Height(x, y, value - shift);

    public override Vec3 ToFlat(Vec3 point)
    {
        var flat = Inner.ToFlat(point);
        return flat.WithZ(flat.Z + shift);
    }

    public override Vec3 ToPart(Vec3 flat) => Inner.ToPart(flat.WithZ(flat.Z - shift));

    internal override (double First, double Second) Heights(double x, double y, double first, double second)
        => Inner.Heights(x, y, first - shift, second - shift);

    internal override LiftedPoint Lift(Vec3 flat, double thickness) => Inner.Lift(flat.WithZ(flat.Z - shift), thickness);
}
