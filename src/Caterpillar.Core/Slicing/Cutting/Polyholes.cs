namespace Caterpillar.Slicing;

/// <summary>
/// Round holes as polygons. The chords of a circle lie inside it, and each corner draws the extrusion inwards, so holes come out too small. A polygon of few
/// sides that touch the circle comes out right: Palmer, "Polyholes" (hydraraptor.blogspot.com, 2011).
/// </summary>
internal static class Polyholes
{
    // A hole with fewer corners is meant to have them, and so is a side that takes more than this, degrees.
    private const int LeastCorners = 9;
    private const double LongestSide = 45;

    // mm; edges between the triangles of a side leave points on it.
    private const double Straight = 0.0005;

    /// <summary>Sides of the polygon of a hole, mm: two for each mm.</summary>
    public static int SidesOf(double diameter) => Math.Max(3, (int)Math.Floor(2 * diameter + 0.5));

    /// <summary>The region with polygons in place of its round holes.</summary>
    /// <param name="region">The region.</param>
    /// <param name="threshold">How far corners of round holes may lie off the circle, mm.</param>
    /// <param name="turned">Turns the polygons by half a side.</param>
    /// <param name="engine">Clips.</param>
    public static Region In(Region region, double threshold, bool turned, RegionEngine engine)
    {
        var all = new List<GridPoint[]>();
        var found = false;
        foreach (var island in region.Simplified(Straight, engine).Islands)
        {
            var kept = new List<GridPoint[]> { island.Paths[0] };
            var holes = new List<Polyline>();
            for (var i = 1; i < island.Paths.Length; i++)
            {
                if (Circle(island.Paths[i], threshold) is { } circle) holes.Add(Polygon(circle.Center, circle.Radius, turned));
                else kept.Add(island.Paths[i]);
            }
            found |= holes.Count > 0;
            all.AddRange(holes.Count == 0 ? island.Paths
                : Region.Own(kept.ToArray()).Subtract(Region.From(holes, FillRule.NonZero, false, engine), engine).Paths);
        }
        return found ? Region.Own(all.ToArray()) : region;
    }

    private static Polyline Polygon(Vec3 center, double radius, bool turned)
    {
        var sides = SidesOf(2 * radius);
        var corner = radius / Angle.SinCos(180.0 / sides).Cos;
        var points = new Vec3[sides];
        for (var i = 0; i < sides; i++)
        {
            var (sin, cos) = Angle.SinCos(360.0 * (i + (turned ? 0.5 : 0)) / sides);
            points[i] = center + new Vec3(cos, sin) * corner;
        }
        return Polyline.Own(points, closed: true);
    }

    // The circle through three corners far apart, if all others lie on it, too.
    private static (Vec3 Center, double Radius)? Circle(GridPoint[] hole, double threshold)
    {
        var n = hole.Length;
        if (n < LeastCorners) return null;
        Vec3 a = Grid.ToMm(hole[0]), b = Grid.ToMm(hole[n / 3]) - a, c = Grid.ToMm(hole[2 * n / 3]) - a;
        var cross = 2 * (b.X * c.Y - b.Y * c.X);
        if (cross == 0) return null;
        double bb = b.LengthSquared, cc = c.LengthSquared;
        var toCenter = new Vec3((c.Y * bb - b.Y * cc) / cross, (b.X * cc - c.X * bb) / cross);
        var (center, radius) = (a + toCenter, toCenter.LengthXY);
        var longest = 2 * radius * Angle.SinCos(LongestSide / 2).Sin;
        for (var i = 0; i < n; i++)
        {
            var p = Grid.ToMm(hole[i]);
            if (Math.Abs((p - center).LengthXY - radius) > threshold || (p - Grid.ToMm(hole[i == 0 ? n - 1 : i - 1])).LengthXY > longest) return null;
        }
        return (center, radius);
    }
}
