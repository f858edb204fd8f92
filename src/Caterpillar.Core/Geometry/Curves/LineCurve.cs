namespace Caterpillar.Geometry;

/// <summary>A straight line between two points, in mm. The parameter runs from 0 to 1.</summary>
internal sealed class LineCurve : Curve
{
    private readonly Vec3 _from;
    private readonly Vec3 _to;

    /// <exception cref="ArgumentException">A point is not finite, or both are equal.</exception>
    public LineCurve(Vec3 from, Vec3 to)
    {
        _from = Finite(from, nameof(from));
        _to = Finite(to, nameof(to));
        if (from == to) throw new ArgumentException("A line needs two different points.", nameof(to));
    }

    public override double DomainStart => 0;

    public override double DomainEnd => 1;

    public override double Length => _from.DistanceTo(_to);

    public override Bounds Bounds => Bounds.Empty.Include(_from).Include(_to);

    public override Vec3 PointAt(double t) => Vec3.Lerp(_from, _to, Clamp(t));

    /// <inheritdoc/>
    /// <exception cref="ArgumentException">The transform collapses the line to a point.</exception>
    public override Curve Transformed(Affine map) => new LineCurve(map.Apply(_from), map.Apply(_to));

    internal override void AddSpans(List<CurveSpan> spans) => spans.Add(CurveSpan.Straight(_from, _to));
}
