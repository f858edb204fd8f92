namespace Caterpillar.Geometry;

/// <summary>
/// Leaves away points of a path in XY where a segment is short: a machine is slow there, and its file is long. Of the two ends of such a segment the one goes
/// that changes the path less; where both are needed, both stay.
/// </summary>
internal static class ShortSegments
{
    // mm; closer points are one.
    private const double Same = 0.004;

    /// <summary>The points to keep, by their numbers, or null for all of them. The first stays, and the last of an open path.</summary>
    /// <param name="points">The path, mm.</param>
    /// <param name="closed">Whether it goes back to its first point.</param>
    /// <param name="least">Shorter segments are short, mm.</param>
    /// <param name="tolerance">How far what stays may be from any point, mm.</param>
    /// <param name="area">How much area may lie between what stays and what was there in one place, mm².</param>
    public static int[]? Keep(Vec3[] points, bool closed, double least, double tolerance, double area)
    {
        var last = closed ? points.Length : points.Length - 1;
        var next = 1;
        while (next <= last && Length(points, next - 1, next) >= least) next++;
        if (next > last) return null;
        var kept = new List<int>(last);
        for (var i = 0; i < next; i++) kept.Add(i);
        for (; next <= last; next++)
        {
            kept.Add(next);
            while (kept.Count > 2 || (kept.Count == 2 && next < last))
            {
                var k = kept.Count;
                var length = Length(points, kept[k - 2], next);
                if (length >= least) break;
                var before = k > 2 ? Change(points, kept[k - 3], next, tolerance, area) : double.PositiveInfinity;
                var here = next < last ? Change(points, kept[k - 2], next + 1, tolerance, area) : double.PositiveInfinity;
                if (double.IsInfinity(before) && double.IsInfinity(here) && length >= Same) break;
                var removed = next == last || (k > 2 && before < here) ? k - 2 : k - 1;
                kept.RemoveAt(removed);
                if (removed == k - 1) break;
            }
        }
        if (closed) kept.RemoveAt(kept.Count - 1);
        return kept.Count == points.Length ? null : kept.ToArray();
    }

    private static Vec3 At(Vec3[] points, int i) => points[i < points.Length ? i : i - points.Length];

    private static double Length(Vec3[] points, int from, int to) => (At(points, to) - At(points, from)).LengthXY;

    // The area between the chord and the farthest point, or infinity beyond a limit.
    private static double Change(Vec3[] points, int from, int to, double tolerance, double area)
    {
        var a = points[from];
        var chord = At(points, to) - a;
        var length = chord.LengthXY;
        var farthest = 0.0;
        for (var i = from + 1; i < to; i++)
        {
            var p = points[i] - a;
            var t = length > 0 ? Math.Min(Math.Max((p.X * chord.X + p.Y * chord.Y) / (length * length), 0), 1) : 0;
            farthest = Math.Max(farthest, (p - chord * t).LengthXY);
        }
        var change = farthest * length / 2;
        return farthest > tolerance || change > area ? double.PositiveInfinity : change;
    }
}
