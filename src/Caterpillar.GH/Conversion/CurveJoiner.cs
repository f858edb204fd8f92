namespace Caterpillar.GH.Conversion;

/// <summary>Makes one Rhino curve of segments that follow each other: a polyline, or with arcs a polycurve.</summary>
internal sealed class CurveJoiner(DocumentUnits units)
{
    private readonly List<Rg.Line> _lines = [];
    private Rg.PolyCurve? _joined;

    /// <summary>The course of a path, with its horizontal arcs as arcs. Null if it has no length.</summary>
    public static Rg.Curve? ToCurve(PrintPath path, DocumentUnits units)
    {
        var joiner = new CurveJoiner(units);
        for (var i = 0; i < path.SegmentCount; i++) joiner.Add(path.Points[i], path.EndOf(i), path.ArcOf(i));
        return joiner.Finish();
    }

    /// <summary>The course of the head through all moves of a toolpath. Null if it has no length.</summary>
    public static Rg.Curve? ToCurve(Toolpath toolpath, DocumentUnits units)
    {
        var joiner = new CurveJoiner(units);
        for (var i = 0; i < toolpath.Count; i++)
        {
            var move = toolpath[i];
            // Where the head starts may be unknown.
            if (move.Start.IsFinite && move.End.IsFinite) joiner.Add(move.Start, move.End, move.Arc);
        }
        return joiner.Finish();
    }

    /// <summary>True for an arc that Rhino has, too: horizontal, without a rise, of one turn at most.</summary>
    public static bool IsPlain(Vec3 start, Vec3 end, Arc arc) => arc.Plane == ArcPlane.XY && start.Z == end.Z && Math.Abs(arc.Sweep) <= 360;

    /// <summary>An arc that <see cref="IsPlain"/>.</summary>
    public static Rg.Arc ToArc(Vec3 start, Arc arc, DocumentUnits units)
    {
        // Clockwise arcs turn about an axis that points down.
        var outward = start - arc.Center.WithZ(start.Z);
        var side = new Rg.Vector3d(-outward.Y, outward.X, 0) * (arc.Sweep < 0 ? -1 : 1);
        var plane = new Rg.Plane(RhinoGeometry.ToPoint(arc.Center.WithZ(start.Z), units), new Rg.Vector3d(outward.X, outward.Y, 0), side);
        return new Rg.Arc(plane, arc.Radius(start) * units.FromMillimeters, Basics.Angle.ToRadians(Math.Abs(arc.Sweep)));
    }

    public void Add(Vec3 start, Vec3 end, Arc? arc)
    {
        if (arc is { } turn && IsPlain(start, end, turn))
        {
            _joined ??= new Rg.PolyCurve();
            Flush(_joined);
            _joined.Append(new Rg.ArcCurve(ToArc(start, turn, units)));
        }
        else
        {
            RhinoGeometry.AddLines(_lines, start, end, arc, units);
        }
    }

    /// <summary>The curve. Null if nothing has a length.</summary>
    public Rg.Curve? Finish()
    {
        if (_joined is null) return PolylineMaker.Of(_lines);
        Flush(_joined);
        return _joined;
    }

    private void Flush(Rg.PolyCurve joined)
    {
        if (PolylineMaker.Of(_lines) is { } part) joined.Append(part);
        _lines.Clear();
    }
}
