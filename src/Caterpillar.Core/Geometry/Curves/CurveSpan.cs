namespace Caterpillar.Geometry;

/// <summary>A smooth span of a curve, with its own parameter u from 0 to 1: a straight line at constant speed, an arc, or a rational Bézier piece.</summary>
internal readonly record struct CurveSpan(Vec3 Start, Vec3 End, BezierSpan? Bezier = null, ArcCurve? Arc = null)
{
    public static CurveSpan Of(BezierSpan bezier) => new(bezier.Point(0), bezier.Point(1), bezier);

    public static CurveSpan Of(ArcCurve arc) => new(arc.Start, arc.End, Arc: arc);

    /// <summary>True if length is linear in u.</summary>
    public bool IsEven => Bezier is null;

    public Vec3 StartTangent => Arc is not null ? Arc.Derivatives(0).First.Unit() : Bezier is not null ? Bezier.StartTangent : (End - Start).Unit();

    public Vec3 EndTangent => Arc is not null ? Arc.Derivatives(1).First.Unit() : Bezier is not null ? Bezier.EndTangent : (End - Start).Unit();

    /// <summary>Length of a span that <see cref="IsEven"/>, mm.</summary>
    public double EvenLength => Arc is not null ? Arc.Length : Start.DistanceTo(End);

    public bool IsStraight(double tolerance) => Arc is null && (Bezier is null || Bezier.IsStraight(tolerance));

    public Vec3 Point(double u)
        => Arc is not null ? Arc.PointAt(u) : Bezier is not null ? Bezier.Point(u) : Vec3.Lerp(Start, End, u);

    /// <summary>First and second derivative with respect to u.</summary>
    public (Vec3 First, Vec3 Second) Derivatives(double u)
        => Bezier is not null ? Bezier.Derivatives(u) : Arc is not null ? Arc.Derivatives(u) : (End - Start, Vec3.Zero);

    /// <summary>The angle between two unit vectors, 0 to 180 degrees.</summary>
    public static double TurnDegrees(Vec3 a, Vec3 b) => Angle.Atan2(Vec3.Cross(a, b).Length, Vec3.Dot(a, b));

    /// <summary>1/mm; infinite if the derivative is zero.</summary>
    public double Curvature(double u)
    {
        if (Arc is not null) return 1 / Arc.Radius;
        var (first, second) = Derivatives(u);
        var speed = first.Length;
        return speed > 0 ? Vec3.Cross(first, second).Length / (speed * speed * speed) : double.PositiveInfinity;
    }
}
