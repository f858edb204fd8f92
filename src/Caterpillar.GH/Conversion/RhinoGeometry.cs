namespace Caterpillar.GH.Conversion;

/// <summary>Between the library's geometry in mm and Rhino's in document units.</summary>
internal static class RhinoGeometry
{
    // Maximum deviation of chords from arcs in mm, on the screen and when baked.
    private const double ChordTolerance = 0.01;

    public static Vec3 ToVec(Rg.Point3d point, DocumentUnits units) => new Vec3(point.X, point.Y, point.Z) * units.ToMillimeters;

    public static Vec3 ToVec(GH_Point point, DocumentUnits units) => ToVec((Rg.Point3d)point.ScriptVariable(), units);

    public static Rg.Point3d ToPoint(Vec3 point, DocumentUnits units)
    {
        var scale = units.FromMillimeters;
        return new Rg.Point3d(point.X * scale, point.Y * scale, point.Z * scale);
    }

    public static Rg.BoundingBox ToBox(Bounds bounds, DocumentUnits units)
        => bounds.IsEmpty ? Rg.BoundingBox.Empty : new Rg.BoundingBox(ToPoint(bounds.Min, units), ToPoint(bounds.Max, units));

    /// <summary>A box that is valid.</summary>
    public static Bounds ToBounds(Rg.BoundingBox box, DocumentUnits units) => new(ToVec(box.Min, units), ToVec(box.Max, units));

    public static Color ToColor(Rgb color) => Color.FromArgb(color.R, color.G, color.B);

    public static Rg.Plane ToPlane(Frame frame, DocumentUnits units)
        => new(ToPoint(frame.Origin, units), new Rg.Vector3d(frame.X.X, frame.X.Y, frame.X.Z), new Rg.Vector3d(frame.Y.X, frame.Y.Y, frame.Y.Z));

    public static Frame ToFrame(Rg.Plane plane, DocumentUnits units)
        => Frame.FromAxes(ToVec(plane.Origin, units), new Vec3(plane.XAxis.X, plane.XAxis.Y, plane.XAxis.Z),
            new Vec3(plane.YAxis.X, plane.YAxis.Y, plane.YAxis.Z));

    /// <summary>A map of document units as a map of mm. Null if it is a perspective map.</summary>
    public static Affine? ToAffine(Rg.Transform t, DocumentUnits units)
    {
        if (t.M30 != 0 || t.M31 != 0 || t.M32 != 0 || !(t.M33 != 0)) return null;
        var s = 1 / t.M33;
        return new Affine(new Vec3(t.M00, t.M10, t.M20) * s, new Vec3(t.M01, t.M11, t.M21) * s, new Vec3(t.M02, t.M12, t.M22) * s,
            new Vec3(t.M03, t.M13, t.M23) * (s * units.ToMillimeters));
    }

    /// <summary>A map of mm as a map of document units.</summary>
    public static Rg.Transform ToTransform(Affine map, DocumentUnits units)
    {
        var s = units.FromMillimeters;
        return new Rg.Transform(1)
        {
            M00 = map.XAxis.X, M01 = map.YAxis.X, M02 = map.ZAxis.X, M03 = map.Shift.X * s,
            M10 = map.XAxis.Y, M11 = map.YAxis.Y, M12 = map.ZAxis.Y, M13 = map.Shift.Y * s,
            M20 = map.XAxis.Z, M21 = map.YAxis.Z, M22 = map.ZAxis.Z, M23 = map.Shift.Z * s,
        };
    }

    /// <summary>A path as a polyline. A closed one ends at its start. Null if it has no length.</summary>
    public static Rg.PolylineCurve? ToCurve(PrintPath path, DocumentUnits units)
    {
        var lines = new List<Rg.Line>();
        for (var i = 0; i < path.SegmentCount; i++) AddLines(lines, path.Points[i], path.EndOf(i), path.ArcOf(i), units);
        return PolylineMaker.Of(lines);
    }

    /// <summary>One segment, an arc as chords. Nothing if it has no length.</summary>
    public static void AddLines(List<Rg.Line> lines, Vec3 start, Vec3 end, Arc? arc, DocumentUnits units)
    {
        if (arc is not { } turn)
        {
            if (start != end) lines.Add(new Rg.Line(ToPoint(start, units), ToPoint(end, units)));
            return;
        }
        var chords = turn.ChordCount(start, ChordTolerance);
        var last = ToPoint(start, units);
        for (var k = 1; k <= chords; k++)
        {
            var next = ToPoint(k == chords ? end : turn.PointAt(start, end, (double)k / chords), units);
            lines.Add(new Rg.Line(last, next));
            last = next;
        }
    }

    /// <summary>Outline of the bed of a printer.</summary>
    public static Rg.Curve ToBed(Printer printer, DocumentUnits units)
    {
        var box = printer.BuildBounds;
        if (printer.BedShape == BedShape.Round)
            return new Rg.ArcCurve(new Rg.Circle(ToPoint(box.Center.WithZ(box.Min.Z), units), box.Size.X / 2 * units.FromMillimeters));
        var (a, c) = (box.Min, box.Max.WithZ(box.Min.Z));
        Vec3[] corners = [a, new(c.X, a.Y, a.Z), c, new(a.X, c.Y, a.Z), a];
        return new Rg.PolylineCurve(Array.ConvertAll(corners, p => ToPoint(p, units)));
    }

    /// <summary>A closed contour as a polyline that ends at its start.</summary>
    public static Rg.PolylineCurve? ToCurve(Polyline contour, double z, DocumentUnits units)
    {
        var points = new List<Rg.Point3d>(contour.Count + 1);
        foreach (var p in contour.Points) points.Add(ToPoint(p.WithZ(z), units));
        if (contour.IsClosed && contour.Count > 0) points.Add(points[0]);
        return PolylineMaker.Of(points);
    }
}
