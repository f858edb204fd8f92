namespace Caterpillar.Drawings;

/// <summary>The basic shapes of SVG as curves in user units. Null if an attribute is invalid. Empty if the shape is empty.</summary>
internal static class SvgShapes
{
    public static IReadOnlyList<Curve>? Line(Func<string, double?> length)
    {
        if (length("x1") is not { } x1 || length("y1") is not { } y1 || length("x2") is not { } x2 || length("y2") is not { } y2) return null;
        return x1 == x2 && y1 == y2 ? [] : [new PolylineCurve([new Vec3(x1, y1), new Vec3(x2, y2)])];
    }

    public static IReadOnlyList<Curve>? Polyline(string text, bool closed)
    {
        if (SvgValues.Numbers(text) is not { } n || n.Length % 2 != 0) return null;
        var points = new List<Vec3>();
        for (var i = 0; i < n.Length; i += 2)
        {
            var point = new Vec3(n[i], n[i + 1]);
            if (points.Count == 0 || points[points.Count - 1] != point) points.Add(point);
        }
        if (points.Count > 3 && points[0] == points[points.Count - 1])
        {
            points.RemoveAt(points.Count - 1);
            closed = true;
        }
        return points.Count < 2 ? [] : [new PolylineCurve(points, closed && points.Count > 2)];
    }

    public static IReadOnlyList<Curve>? Ellipse(double? cx, double? cy, double? rx, double? ry)
    {
        if (cx is not { } x || cy is not { } y || rx is not { } a || ry is not { } b || a < 0 || b < 0) return null;
        if (a == 0 || b == 0) return [];
        var circle = ArcCurve.Circle(Vec3.Zero, 1);
        return [circle.Transformed(new Affine(new Vec3(a, 0), new Vec3(0, b), Vec3.UnitZ, new Vec3(x, y)))];
    }

    public static IReadOnlyList<Curve>? Rectangle(Func<string, double?> length, bool hasRx, bool hasRy)
    {
        if (length("x") is not { } x || length("y") is not { } y || length("width") is not (>= 0 and var w)
            || length("height") is not (>= 0 and var h))
            return null;
        if (w == 0 || h == 0) return [];
        var rx = hasRx ? length("rx") : hasRy ? length("ry") : 0;
        var ry = hasRy ? length("ry") : hasRx ? length("rx") : 0;
        if (rx is not (>= 0 and var a) || ry is not (>= 0 and var b)) return null;
        (a, b) = (Math.Min(a, w / 2), Math.Min(b, h / 2));
        if (a == 0 || b == 0) return [new PolylineCurve([new Vec3(x, y), new Vec3(x + w, y), new Vec3(x + w, y + h), new Vec3(x, y + h)], true)];
        // Corners as quarter ellipses, from the left end of the upper side on (SVG 1.1, 9.2).
        var pieces = new List<Curve>();
        Vec3[] corners = [new(x + w - a, y + b), new(x + w - a, y + h - b), new(x + a, y + h - b), new(x + a, y + b)];
        var here = new Vec3(x + a, y);
        for (var i = 0; i < 4; i++)
        {
            var (sin, cos) = Angle.SinCos(90 * (i - 1));
            var unit = new ArcCurve(Frame.FromAxes(Vec3.Zero, new Vec3(cos, sin), new Vec3(-sin, cos)), 1, 90);
            var arc = unit.Transformed(new Affine(new Vec3(a, 0), new Vec3(0, b), Vec3.UnitZ, corners[i]));
            if (here.DistanceTo(arc.Start) > 1e-12) pieces.Add(new PolylineCurve([here, arc.Start]));
            pieces.Add(arc);
            here = arc.End;
        }
        if (here.DistanceTo(new Vec3(x + a, y)) > 1e-12) pieces.Add(new PolylineCurve([here, new Vec3(x + a, y)]));
        return [new PolyCurve(pieces)];
    }
}
