namespace Caterpillar.GH.Goos;

/// <summary>Paths and toolpaths as geometry of Rhino and Grasshopper. Null if they have none of the requested type.</summary>
internal static class NativeCasts
{
    public static object? Of(PrintPath path, Type wanted, DocumentUnits units)
    {
        if (wanted == typeof(Rg.Line) || wanted == typeof(GH_Line))
        {
            if (path.SegmentCount != 1 || path.HasArcs) return null;
            var line = new Rg.Line(RhinoGeometry.ToPoint(path.Start, units), RhinoGeometry.ToPoint(path.End, units));
            return wanted == typeof(GH_Line) ? new GH_Line(line) : line;
        }
        if (wanted == typeof(Rg.Arc) || wanted == typeof(GH_Arc) || wanted == typeof(Rg.Circle)
            || wanted == typeof(GH_Circle))
        {
            return Round(path, wanted, units);
        }
        if (wanted == typeof(Rg.Polyline)) return RhinoGeometry.ToCurve(path, units) is { } chords && chords.TryGetPolyline(out var polyline) ? polyline : null;
        if (typeof(Rg.PolylineCurve) == wanted) return RhinoGeometry.ToCurve(path, units);
        return AsCurve(wanted, () => CurveJoiner.ToCurve(path, units));
    }

    public static object? Of(Toolpath toolpath, Type wanted, DocumentUnits units)
    {
        if (wanted != typeof(Rg.Mesh) && wanted != typeof(GH_Mesh)) return AsCurve(wanted, () => CurveJoiner.ToCurve(toolpath, units));
        var mesh = ExtrusionMeshes.ToMesh(ExtrusionMesh.Of(toolpath, 0, toolpath.Count), units, null);
        if (mesh is null || wanted == typeof(Rg.Mesh)) return mesh;
        var goo = new GH_Mesh();
        return goo.CastFrom(mesh) ? goo : null;
    }

    // Other goo is left alone: text at least describes itself.
    private static object? AsCurve(Type wanted, Func<Rg.Curve?> make)
    {
        if (typeof(Rg.Curve) == wanted) return make();
        return wanted != typeof(IGH_Goo) && wanted != typeof(object) && wanted.IsAssignableFrom(typeof(GH_Curve))
            && make() is { } curve ? new GH_Curve(curve) : null;
    }

    private static object? Round(PrintPath path, Type wanted, DocumentUnits units)
    {
        if (path.SegmentCount != 1 || path.ArcOf(0) is not { } arc || !CurveJoiner.IsPlain(path.Start, path.EndOf(0), arc)) return null;
        var round = CurveJoiner.ToArc(path.Start, arc, units);
        if (wanted == typeof(Rg.Arc)) return round;
        if (wanted == typeof(GH_Arc)) return new GH_Arc(round);
        if (Math.Abs(arc.Sweep) < 360) return null;
        var circle = new Rg.Circle(round.Plane, round.Radius);
        return wanted == typeof(GH_Circle) ? new GH_Circle(circle) : circle;
    }
}
