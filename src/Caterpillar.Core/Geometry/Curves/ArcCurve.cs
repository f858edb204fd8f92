namespace Caterpillar.Geometry;

/// <summary>
/// A circular arc or full circle in any plane, in mm. It starts on the X axis of its frame and turns about its Z axis. The parameter runs from 0 to 1.
/// </summary>
public sealed class ArcCurve : Curve
{
    /// <param name="frame">Center and plane. The arc starts in the X direction.</param>
    /// <param name="radius">Radius in mm, above 0.</param>
    /// <param name="sweep">Angle in degrees, positive from X toward Y, at most ±360.</param>
    /// <exception cref="ArgumentException">The radius is not positive, or the sweep is zero, not finite or more than 360°.</exception>
    public ArcCurve(Frame frame, double radius, double sweep = 360)
    {
        if (!(radius > 0) || double.IsInfinity(radius)) throw new ArgumentException("The radius of an arc must be positive.", nameof(radius));
        if (!(Math.Abs(sweep) <= 360) || sweep == 0) throw new ArgumentException("The sweep of an arc must be at most 360 degrees and not 0.", nameof(sweep));
        Finite(frame.Origin, nameof(frame));
        Frame = frame;
        Radius = radius;
        Sweep = sweep;
    }

    /// <summary>Center and plane. The arc starts in the X direction.</summary>
    public Frame Frame { get; }

    /// <summary>Center, mm.</summary>
    public Vec3 Center => Frame.Origin;

    /// <summary>Radius, mm.</summary>
    public double Radius { get; }

    /// <summary>Angle in degrees, positive from the X axis of the frame toward its Y axis.</summary>
    public double Sweep { get; }

    public override bool IsClosed => Math.Abs(Sweep) == 360 || base.IsClosed;

    public override double Length => Radius * Math.Abs(Angle.ToRadians(Sweep));

    /// <summary>A full circle in a horizontal plane, counterclockwise from its point with the maximum X.</summary>
    public static ArcCurve Circle(Vec3 center, double radius) => new(Frame.At(center), radius);

    public override Vec3 PointAt(double t)
    {
        t = Clamp(t);
        var (sin, cos) = Angle.SinCos(Sweep * t);
        return Center + Frame.X * (Radius * cos) + Frame.Y * (Radius * sin);
    }

    public override Curve Transformed(Affine map)
    {
        var x = map.ApplyDirection(Frame.X);
        var y = map.ApplyDirection(Frame.Y);
        var (lx, ly) = (x.Length, y.Length);
        if (!(lx > 0) || Math.Abs(lx - ly) > 1e-12 * lx || Math.Abs(Vec3.Dot(x, y)) > 1e-12 * lx * ly) return ToNurbs().Transformed(map);
        return new ArcCurve(Frame.FromAxes(map.Apply(Center), x, y), Radius * lx, Sweep);
    }

    /// <summary>The arc as a rational curve of degree 2, with one piece per 90 degrees (Piegl and Tiller, The NURBS Book, 7.3).</summary>
    public NurbsCurve ToNurbs()
    {
        var pieces = Math.Max(1, (int)Math.Ceiling(Math.Abs(Sweep) / 90 - 1e-12));
        var step = Sweep / pieces;
        var weight = Angle.Cos(step / 2);
        var points = new List<Vec3>();
        var weights = new List<double>();
        var knots = new List<double> { 0, 0, 0 };
        for (var i = 0; i <= pieces; i++)
        {
            if (i > 0)
            {
                var (sin, cos) = Angle.SinCos(step * (i - 0.5));
                var r = Radius / weight;
                points.Add(Center + Frame.X * (r * cos) + Frame.Y * (r * sin));
                weights.Add(weight);
                var knot = (double)i / pieces;
                knots.Add(knot);
                knots.Add(knot);
            }
            points.Add(PointAt((double)i / pieces));
            weights.Add(1);
        }
        knots.Add(1);
        return new NurbsCurve(2, points, knots, weights);
    }

    public override Bounds Bounds
    {
        get
        {
            var bounds = Bounds.Empty.Include(Start).Include(End);
            foreach (var axis in new[] { Vec3.UnitX, Vec3.UnitY, Vec3.UnitZ })
            {
                var peak = Angle.Atan2(Vec3.Dot(Frame.Y, axis), Vec3.Dot(Frame.X, axis));
                for (var turn = -540; turn <= 540; turn += 180)
                {
                    var t = (peak + turn) / Sweep;
                    if (t > 0 && t < 1) bounds = bounds.Include(PointAt(t));
                }
            }
            return bounds;
        }
    }

    internal (Vec3 First, Vec3 Second) Derivatives(double u)
    {
        var (sin, cos) = Angle.SinCos(Sweep * u);
        var rate = Angle.ToRadians(Sweep);
        return ((Frame.Y * cos - Frame.X * sin) * (Radius * rate), (Frame.X * cos + Frame.Y * sin) * (-Radius * rate * rate));
    }

    internal override void AddSpans(List<CurveSpan> spans) => spans.Add(CurveSpan.Of(this));
}
