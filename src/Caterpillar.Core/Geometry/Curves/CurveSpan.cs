namespace Caterpillar.Geometry;

/// <summary>A smooth span of a curve, with its own parameter u from 0 to 1: a straight line at constant speed, an arc, or a rational Bézier piece.</summary>
internal readonly struct CurveSpan
{
    private readonly BezierSpan? _bezier;
    private readonly ArcCurve? _arc;

    private CurveSpan(Vec3 start, Vec3 end, BezierSpan? bezier, ArcCurve? arc)
    {
        Start = start;
        End = end;
        _bezier = bezier;
        _arc = arc;
    }

    public static CurveSpan Straight(Vec3 start, Vec3 end) => new(start, end, null, null);

    public static CurveSpan Of(BezierSpan bezier) => new(bezier.Point(0), bezier.Point(1), bezier, null);

    public static CurveSpan Of(ArcCurve arc) => new(arc.Start, arc.End, null, arc);

    public Vec3 Start { get; }

    public Vec3 End { get; }

    public ArcCurve? Arc => _arc;

    public BezierSpan? Bezier => _bezier;

    /// <summary>True if length is linear in u.</summary>
    public bool IsEven => _bezier is null;

    public Vec3 StartTangent => _arc is not null ? _arc.Derivatives(0).First.Unit() : _bezier is not null ? _bezier.StartTangent : (End - Start).Unit();

    public Vec3 EndTangent => _arc is not null ? _arc.Derivatives(1).First.Unit() : _bezier is not null ? _bezier.EndTangent : (End - Start).Unit();

    /// <summary>Length of a span that <see cref="IsEven"/>, mm.</summary>
    public double EvenLength => _arc is not null ? _arc.Length : Start.DistanceTo(End);

    public bool IsStraight(double tolerance) => _arc is null && (_bezier is null || _bezier.IsStraight(tolerance));

    public Vec3 Point(double u)
        => _arc is not null ? _arc.PointAt(u) : _bezier is not null ? _bezier.Point(u) : Vec3.Lerp(Start, End, u);

    /// <summary>First and second derivative with respect to u.</summary>
    public (Vec3 First, Vec3 Second) Derivatives(double u)
    {
        if (_bezier is not null) return _bezier.Derivatives(u);
        return _arc is not null ? _arc.Derivatives(u) : (End - Start, Vec3.Zero);
    }

    /// <summary>The angle between two unit vectors, 0 to 180 degrees.</summary>
    public static double TurnDegrees(Vec3 a, Vec3 b) => Angle.Atan2(Vec3.Cross(a, b).Length, Vec3.Dot(a, b));

    /// <summary>1/mm; infinite if the derivative is zero.</summary>
    public double Curvature(double u)
    {
        if (_arc is not null) return 1 / _arc.Radius;
        if (_bezier is null) return 0;
        var (first, second) = _bezier.Derivatives(u);
        var speed = first.Length;
        return speed > 0 ? Vec3.Cross(first, second).Length / (speed * speed * speed) : double.PositiveInfinity;
    }
}
