using System;
using System.Collections.Generic;

namespace Caterpillar.Geometry;

/// <summary>A point on a curve: parameter, position in mm, and distance in mm from the query point.</summary>
public readonly record struct CurvePoint(double Parameter, Vec3 Point, double Distance);

/// <summary>
/// A curve in space, in mm, over an interval of a parameter: <see cref="LineCurve"/>, <see cref="PolylineCurve"/>, <see cref="ArcCurve"/>,
/// <see cref="NurbsCurve"/> or several joined (<see cref="PolyCurve"/>). Immutable.
/// </summary>
public abstract class Curve
{
    /// <summary>Ends closer than this, in mm, are the same point.</summary>
    public const double JoinTolerance = 1e-6;

    private protected Curve()
    {
    }

    /// <summary>Parameter of the start.</summary>
    public abstract double DomainStart { get; }

    /// <summary>Parameter of the end; larger than that of the start.</summary>
    public abstract double DomainEnd { get; }

    /// <summary>The first point, mm.</summary>
    public Vec3 Start => PointAt(DomainStart);

    /// <summary>The last point, mm; the first one of a closed curve.</summary>
    public Vec3 End => PointAt(DomainEnd);

    /// <summary>True if it ends where it starts, within <see cref="JoinTolerance"/>.</summary>
    public virtual bool IsClosed => Start.DistanceTo(End) <= JoinTolerance;

    /// <summary>The point at a parameter; outside of the domain that of the nearer end.</summary>
    public abstract Vec3 PointAt(double t);

    /// <summary>The first derivative with respect to the parameter; where it jumps, that after the parameter.</summary>
    public abstract Vec3 DerivativeAt(double t);

    /// <summary>Unit vector in the direction of travel; zero only if the curve has no direction at all.</summary>
    public Vec3 TangentAt(double t)
    {
        var direction = DerivativeAt(t);
        if (direction.LengthSquared > 1e-24) return direction.Unit();
        var step = (DomainEnd - DomainStart) * 1e-6;
        var ahead = PointAt(Math.Min(t + step, DomainEnd)) - PointAt(Math.Max(t - step, DomainStart));
        return ahead.LengthSquared > 0 ? ahead.Unit() : direction.Unit();
    }

    /// <summary>Length in mm; see <see cref="ArcLength"/> for its error bound and for the inverse from length to parameter.</summary>
    public virtual double Length => ArcLength.Of(this).Total;

    /// <summary>The parameter at a length in mm from the start. For many of them use <see cref="ArcLength"/>.</summary>
    public double ParameterAtLength(double length) => ArcLength.Of(this).ParameterAt(length);

    /// <summary>The point of the curve nearest to another point; among equally near ones the first found.</summary>
    public CurvePoint ClosestPoint(Vec3 point) => ClosestPointSearch.Find(this, point);

    /// <summary>The part between two parameters, in the same direction.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The parameters are not ascending or not in the domain.</exception>
    public Curve SubCurve(double from, double to)
    {
        if (!(from >= DomainStart && to <= DomainEnd && from < to))
        {
            throw new ArgumentOutOfRangeException(nameof(from), "The parameters must ascend within the domain.");
        }
        return from == DomainStart && to == DomainEnd ? this : Part(from, to);
    }

    /// <summary>The parts before and after a parameter.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The parameter is not inside the domain.</exception>
    public (Curve Before, Curve After) Split(double t) => (SubCurve(DomainStart, t), SubCurve(t, DomainEnd));

    /// <summary>The same curve in reverse.</summary>
    public abstract Curve Reversed();

    /// <summary>The image under an affine map. An arc becomes a NURBS curve if its image is not an arc.</summary>
    public abstract Curve Transformed(Affine map);

    /// <summary>The box around the curve: exact for straight parts and arcs, around the control points for others.</summary>
    public abstract Bounds Bounds { get; }

    /// <summary>The parameters inside the domain, and the start of a closed curve, where the direction jumps by more than an angle in degrees.</summary>
    public IReadOnlyList<double> Kinks(double degrees = 0.5)
    {
        var kinks = new List<double>();
        var spans = Spans();
        for (var i = 0; i < spans.Count; i++)
        {
            if (i == 0 && !IsClosed) continue;
            var before = spans[i == 0 ? spans.Count - 1 : i - 1];
            if (CurveSpan.TurnDegrees(before.EndTangent, spans[i].StartTangent) > degrees) kinks.Add(spans[i].From);
        }
        return kinks;
    }

    /// <summary>The smooth spans of the curve in order; spans without length are dropped.</summary>
    internal List<CurveSpan> Spans()
    {
        var spans = new List<CurveSpan>();
        AddSpans(spans, DomainStart, 1);
        return spans;
    }

    // Adds the spans, with their parameters mapped to start + (t − DomainStart)·scale.
    internal abstract void AddSpans(List<CurveSpan> spans, double start, double scale);

    private protected abstract Curve Part(double from, double to);

    private protected double Clamp(double t) => !(t > DomainStart) ? DomainStart : t > DomainEnd ? DomainEnd : t;

    private protected static Vec3 Finite(Vec3 point, string name)
        => point.IsFinite ? point : throw new ArgumentException("A point of a curve is not finite.", name);
}
