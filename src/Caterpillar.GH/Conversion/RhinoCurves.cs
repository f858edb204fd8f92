namespace Caterpillar.GH.Conversion;

/// <summary>Rhino's curves in document units as the library's in mm: polylines and arcs as such, everything else by control points and knots.</summary>
internal static class RhinoCurves
{
    // Points closer than this, in mm, are one.
    private const double LeastSegment = 1e-9;

    /// <summary>The curve of any curve type: curves, lines, polylines, arcs and circles, bare or on a wire. Null for anything else.</summary>
    public static Rg.Curve? In(object? source) => Wrapped.Bare(source) switch
    {
        Rg.Curve curve => curve,
        Rg.Line line => new Rg.LineCurve(line),
        Rg.Polyline polyline => polyline.ToPolylineCurve(),
        Rg.Arc arc => new Rg.ArcCurve(arc),
        Rg.Circle circle => new Rg.ArcCurve(circle),
        IGH_GeometricGoo goo when goo.ScriptVariable() is not IGH_Goo and var bare => In(bare),
        _ => null,
    };

    /// <exception cref="InputProblem">The curve is not valid.</exception>
    public static Curve ToCurve(Rg.Curve curve, DocumentUnits units)
    {
        // Polylines with doubled points call themselves invalid, and are repaired here.
        if (curve.TryGetPolyline(out var polyline)) return ToPolyline(polyline, units);
        if (!curve.IsValid) throw new InputProblem("The curve is not valid.");
        if (curve.TryGetArc(out var arc)) return ToArc(arc, units);
        if (curve is Rg.PolyCurve { SegmentCount: 1 } single) return ToCurve(single.SegmentCurve(0), units);
        if (curve is Rg.PolyCurve joined && joined.SegmentCount > 1)
        {
            // Rhino keeps small gaps between segments; the path goes over them.
            return new PolyCurve(Enumerable.Range(0, joined.SegmentCount).Select(i => ToCurve(joined.SegmentCurve(i), units)), double.MaxValue);
        }
        return ToNurbs(curve.ToNurbsCurve() ?? throw new InputProblem("The curve has no NURBS form."), units);
    }

    /// <summary>Chords that stay within a tolerance of a curve, mm.</summary>
    public static Polyline Chords(Rg.Curve curve, double tolerance, DocumentUnits units)
    {
        var exact = ToCurve(curve, units);
        return new Polyline(CurveSubdivider.Subdivide(exact, new SubdivisionOptions { ChordTolerance = tolerance }).Points, exact.IsClosed);
    }

    private static PolylineCurve ToPolyline(Rg.Polyline polyline, DocumentUnits units)
    {
        var points = new List<Vec3>(polyline.Count);
        foreach (var p in polyline)
        {
            if (!p.IsValid) throw new InputProblem("The curve is not valid.");
            var point = RhinoGeometry.ToVec(p, units);
            if (points.Count == 0 || point.DistanceTo(points[points.Count - 1]) > LeastSegment) points.Add(point);
        }
        if (points.Count < 2) throw new InputProblem("The curve has no length.");
        var closed = points.Count > 3 && points[0].DistanceTo(points[points.Count - 1]) <= Curve.JoinTolerance;
        if (closed) points.RemoveAt(points.Count - 1);
        return new PolylineCurve(points, closed);
    }

    private static ArcCurve ToArc(Rg.Arc arc, DocumentUnits units)
    {
        var center = RhinoGeometry.ToVec(arc.Center, units);
        var start = RhinoGeometry.ToVec(arc.StartPoint, units) - center;
        var normal = arc.Plane.ZAxis;
        var ahead = Vec3.Cross(new Vec3(normal.X, normal.Y, normal.Z), start);
        return new ArcCurve(Frame.FromAxes(center, start, ahead), arc.Radius * units.ToMillimeters, System.Math.Min(arc.AngleDegrees, 360));
    }

    // Rhino omits the first and the last knot, which have no influence.
    private static NurbsCurve ToNurbs(Rg.NurbsCurve curve, DocumentUnits units)
    {
        var points = new List<Vec3>();
        var weights = new List<double>();
        for (var i = 0; i < curve.Points.Count; i++)
        {
            points.Add(RhinoGeometry.ToVec(curve.Points[i].Location, units));
            weights.Add(curve.IsRational ? curve.Points[i].Weight : 1);
        }
        var knots = new List<double> { curve.Knots[0] };
        for (var i = 0; i < curve.Knots.Count; i++) knots.Add(curve.Knots[i]);
        knots.Add(curve.Knots[curve.Knots.Count - 1]);
        return new NurbsCurve(curve.Degree, points, knots, weights);
    }
}
