namespace Caterpillar.Slicing;

/// <summary>
/// Leaves points away whose place and width are within tolerances of the straight line between their neighbors, in one pass: from a kept point the chord
/// grows as long as it stays in the wedge of the points it passes (Zhao and Saalfeld 1997), and its slope of width in the slopes that they allow. It ends where
/// it covers about as much as they do.
/// </summary>
internal static class PathThinning
{
    // By how much the area that a chord covers may be off: a share of it, and mm².
    private const double AreaShare = 0.002;
    private const double AreaTolerance = 0.002;

    // How many points on a chord looks for a better end.
    private const int Patience = 16;

    /// <summary>The points to keep.</summary>
    public static (Vec3[] Points, double[] Widths) Thin(
        IReadOnlyList<Vec3> points, IReadOnlyList<double> widths, bool closed, double tolerance, double widthTolerance)
    {
        var n = points.Count;
        // A closed path is cut open where it begins and ends at the same point.
        var last = closed ? n : n - 1;
        var kept = new List<Vec3>();
        var keptWidths = new List<double>();
        for (var from = 0; from <= last;)
        {
            if (from < n)
            {
                kept.Add(points[from]);
                keptWidths.Add(widths[from]);
            }
            from = from == last ? last + 1 : Reach(points, widths, from, last, tolerance, widthTolerance);
        }
        return (kept.ToArray(), keptWidths.ToArray());
    }

    private static int Reach(IReadOnlyList<Vec3> points, IReadOnlyList<double> widths, int from, int last, double tolerance, double widthTolerance)
    {
        var a = points[from];
        double lowX = 0, lowY = 0, highX = 0, highY = 0, farthest = 0;
        double leastSlope = double.NegativeInfinity, mostSlope = double.PositiveInfinity;
        var reached = from + 1;
        var area = 0.0;
        for (var to = from + 1; to <= last && to <= reached + Patience; to++)
        {
            var before = (to - 1) % points.Count;
            area += (points[to % points.Count] - points[before]).LengthXY * (widths[to % points.Count] + widths[before]) / 2;
            var b = points[to % points.Count] - a;
            var distance = b.LengthXY;
            var rise = widths[to % points.Count] - widths[from];
            // Outside the wedge, going back, or outside the slopes: the chord ends one point before.
            if (farthest > 0)
            {
                if (distance < farthest || lowX * b.Y - lowY * b.X < 0 || highX * b.Y - highY * b.X > 0) break;
                if (rise < leastSlope * distance || rise > mostSlope * distance) break;
            }
            if (distance <= tolerance)
            {
                if (Math.Abs(rise) > widthTolerance) break;
                reached = to;
                continue;
            }
            var w = tolerance / distance;
            double lx = b.X + b.Y * w, ly = b.Y - b.X * w, hx = b.X - b.Y * w, hy = b.Y + b.X * w;
            if (farthest == 0 || lowX * ly - lowY * lx > 0) (lowX, lowY) = (lx, ly);
            if (farthest == 0 || highX * hy - highY * hx < 0) (highX, highY) = (hx, hy);
            leastSlope = Math.Max(leastSlope, (rise - widthTolerance) / distance);
            mostSlope = Math.Min(mostSlope, (rise + widthTolerance) / distance);
            farthest = distance;
            var covered = distance * (widths[from] + widths[to % points.Count]) / 2;
            if (Math.Abs(covered - area) <= AreaShare * area + AreaTolerance) reached = to;
        }
        return reached;
    }
}
