namespace Caterpillar.GH.Conversion;

/// <summary>
/// Polyline curves that are valid for Rhino. Duplicate neighbors are dropped. A line there and back gets a point in its middle, because three points whose
/// ends meet would be a closed curve without an inside.
/// </summary>
internal static class PolylineMaker
{
    // Rhino's own limit is 2.3e-10 units.
    private const double Least = 1e-9;

    /// <summary>A curve through points. Null if it would have no length.</summary>
    public static Rg.PolylineCurve? Of(IEnumerable<Rg.Point3d> points)
    {
        var kept = new List<Rg.Point3d>();
        foreach (var point in points)
        {
            if (kept.Count == 0 || point.DistanceTo(kept[kept.Count - 1]) > Least) kept.Add(point);
        }
        if (kept.Count == 3 && kept[0].DistanceTo(kept[2]) <= Least) kept.Insert(2, Middle(kept[1], kept[2]));
        return kept.Count > 1 ? new Rg.PolylineCurve(kept) : null;
    }

    /// <summary>A curve along lines that follow each other.</summary>
    public static Rg.PolylineCurve? Of(IReadOnlyList<Rg.Line> lines)
    {
        if (lines.Count == 0) return null;
        var points = new List<Rg.Point3d>(lines.Count + 1) { lines[0].From };
        foreach (var line in lines) points.Add(line.To);
        return Of(points);
    }

    private static Rg.Point3d Middle(Rg.Point3d a, Rg.Point3d b) => new((a.X + b.X) / 2, (a.Y + b.Y) / 2, (a.Z + b.Z) / 2);
}
