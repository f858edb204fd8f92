namespace Caterpillar.Geometry;

/// <summary>A polyline as a curve, in mm. The parameter is the index of the segment plus the fraction along it.</summary>
public sealed class PolylineCurve : Curve
{
    private readonly Vec3[] _points;

    /// <exception cref="ArgumentException">There are fewer than two points (three if closed), or one is not finite.</exception>
    public PolylineCurve(IEnumerable<Vec3> points, bool closed = false)
        : this(new Polyline(points, closed))
    {
    }

    /// <exception cref="ArgumentException">There are fewer than two points (three if closed), or one is not finite.</exception>
    public PolylineCurve(Polyline polyline)
    {
        Polyline = polyline ?? throw new ArgumentNullException(nameof(polyline));
        _points = polyline.Raw;
        if (_points.Length < (polyline.IsClosed ? 3 : 2)) throw new ArgumentException("A polyline needs two points, a closed one three.", nameof(polyline));
        foreach (var p in _points) Finite(p, nameof(polyline));
    }

    /// <summary>The polyline.</summary>
    public Polyline Polyline { get; }

    public override double DomainEnd => Polyline.SegmentCount;

    public override bool IsClosed => Polyline.IsClosed || base.IsClosed;

    public override double Length => Polyline.Length;

    public override Bounds Bounds => Polyline.Bounds;

    public override Vec3 PointAt(double t)
    {
        t = Clamp(t);
        var i = Math.Min((int)t, Polyline.SegmentCount - 1);
        return Vec3.Lerp(_points[i], At(i + 1), t - i);
    }

    public override Curve Transformed(Affine map) => new PolylineCurve(Polyline.Own(Array.ConvertAll(_points, map.Apply), Polyline.IsClosed));

    internal override void AddSpans(List<CurveSpan> spans)
    {
        for (var i = 0; i < Polyline.SegmentCount; i++)
        {
            if (_points[i] != At(i + 1)) spans.Add(new CurveSpan(_points[i], At(i + 1)));
        }
    }

    private Vec3 At(int i) => i == _points.Length ? _points[0] : _points[i];
}
