namespace Caterpillar.Slicing;

/// <summary>How close two loops come to each other, seen from above.</summary>
internal static class LoopGap
{
    /// <summary>Whether two loops cross or come as close as a distance, mm.</summary>
    public static bool IsWithin(Vec3[] a, Vec3[] b, double distance)
    {
        var box = Bounds.Of(b);
        var square = distance * distance;
        for (var i = 0; i < a.Length; i++)
        {
            Vec3 from = a[i], to = a[i + 1 == a.Length ? 0 : i + 1];
            if (IsApart(from, to, box.Min, box.Max, distance)) continue;
            for (var k = 0; k < b.Length; k++)
            {
                Vec3 start = b[k], end = b[k + 1 == b.Length ? 0 : k + 1];
                if (!IsApart(from, to, start, end, distance) && IsWithin(from, to, start, end, square)) return true;
            }
        }
        return false;
    }

    // Whether the boxes around two segments are farther apart.
    private static bool IsApart(Vec3 a, Vec3 b, Vec3 c, Vec3 d, double distance)
        => Math.Min(a.X, b.X) > Math.Max(c.X, d.X) + distance || Math.Min(c.X, d.X) > Math.Max(a.X, b.X) + distance
            || Math.Min(a.Y, b.Y) > Math.Max(c.Y, d.Y) + distance || Math.Min(c.Y, d.Y) > Math.Max(a.Y, b.Y) + distance;

    // Segments that do not cross are closest at one of their ends.
    private static bool IsWithin(Vec3 a, Vec3 b, Vec3 c, Vec3 d, double square)
        => (Side(a, b, c) * Side(a, b, d) < 0 && Side(c, d, a) * Side(c, d, b) < 0)
            || FlatSegment.SquareDistance(c, a, b) <= square || FlatSegment.SquareDistance(d, a, b) <= square
            || FlatSegment.SquareDistance(a, c, d) <= square || FlatSegment.SquareDistance(b, c, d) <= square;

    private static double Side(Vec3 a, Vec3 b, Vec3 p) => (b.X - a.X) * (p.Y - a.Y) - (b.Y - a.Y) * (p.X - a.X);
}
