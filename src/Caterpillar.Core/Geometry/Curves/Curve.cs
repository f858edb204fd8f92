namespace Caterpillar.Geometry;

/// <summary>
/// A parametric curve in space, in mm: <see cref="PolylineCurve"/>, <see cref="ArcCurve"/>,
/// <see cref="NurbsCurve"/> or several joined curves (<see cref="PolyCurve"/>). Immutable.
/// </summary>
public abstract class Curve
{
    /// <summary>Maximum distance between ends that count as the same point, mm.</summary>
    public const double JoinTolerance = 1e-6;

    private protected Curve()
    {
    }

    /// <summary>Parameter of the start.</summary>
    public virtual double DomainStart => 0;

    /// <summary>Parameter of the end, greater than <see cref="DomainStart"/>.</summary>
    public virtual double DomainEnd => 1;

    /// <summary>The first point, mm.</summary>
    public Vec3 Start => PointAt(DomainStart);

    /// <summary>The last point, mm. Equal to the first for a closed curve.</summary>
    public Vec3 End => PointAt(DomainEnd);

    /// <summary>True if the end is at the start, within <see cref="JoinTolerance"/>.</summary>
    public virtual bool IsClosed => Start.DistanceTo(End) <= JoinTolerance;

    /// <summary>The point at a parameter, mm. Outside the domain, the nearer end.</summary>
    public abstract Vec3 PointAt(double t);

    /// <summary>Length in mm.</summary>
    public virtual double Length => new ArcLength(Spans()).Total;

    /// <summary>The transformed curve. An arc becomes a NURBS curve if its image is not an arc.</summary>
    public abstract Curve Transformed(Affine map);

    /// <summary>Bounding box in mm: exact for lines and arcs, around the control points for other curves.</summary>
    public abstract Bounds Bounds { get; }

    /// <summary>The smooth spans of the curve in order; spans without length are dropped.</summary>
    internal List<CurveSpan> Spans()
    {
        var spans = new List<CurveSpan>();
        AddSpans(spans);
        return spans;
    }

    internal abstract void AddSpans(List<CurveSpan> spans);

    private protected double Clamp(double t) => !(t > DomainStart) ? DomainStart : t > DomainEnd ? DomainEnd : t;

    private protected static Vec3 Finite(Vec3 point, string name)
        => point.IsFinite ? point : throw new ArgumentException("The points of a curve must be finite.", name);
}
