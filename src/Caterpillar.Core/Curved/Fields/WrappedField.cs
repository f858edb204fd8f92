namespace Caterpillar.Curved;

/// <summary>A field made from another one, like it in all that is not changed.</summary>
internal abstract class WrappedField(LayerField inner) : LayerField
{
    protected LayerField Inner { get; } = inner;

    public override double Detail => Inner.Detail;

    public override bool StartsLevel => Inner.StartsLevel;

    internal override IReadOnlyList<double> Creases => Inner.Creases;

    internal override bool BendsPlan => Inner.BendsPlan;

    public override double Value(Vec3 point) => Inner.Value(point);

    public override double Height(double x, double y, double value) => Inner.Height(x, y, value);

    public override bool Covers(double x, double y) => Inner.Covers(x, y);

    public override Vec3 Normal(Vec3 point) => Inner.Normal(point);

    internal override double Spread(Vec3 point) => Inner.Spread(point);

    internal override double Span(Vec3 step) => Inner.Span(step);

    internal override (double First, double Second) Heights(double x, double y, double first, double second) => Inner.Heights(x, y, first, second);

    internal override PrintSettings Suited(PrintSettings settings) => Inner.Suited(settings);

    internal override void Check(DiagnosticList problems) => Inner.Check(problems);
}
