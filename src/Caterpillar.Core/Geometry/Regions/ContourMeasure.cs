namespace Caterpillar.Geometry;

/// <summary>Area and boundary length enclosed by contours, from their coordinates in double instead of on the 10 nm grid of <see cref="Region"/>.</summary>
internal static class ContourMeasure
{
    /// <summary>
    /// Measures the union of the solids (winding number not 0) of closed contours. If no contours cross or touch, sums over the points as they are;
    /// else over the boundary of the union, computed on a grid of 2⁻²⁹ of half the extent (so errors are near 1e-9 of it).
    /// </summary>
    /// <returns>Area in mm², length of the boundary in mm, and the number of its counterclockwise and clockwise loops.</returns>
    /// <exception cref="ArgumentException">A coordinate is not a number, or infinite.</exception>
    public static (double Area, double Perimeter, int Outer, int Holes) NonZero(IReadOnlyList<Polyline> contours)
    {
        var bounds = Bounds.Empty;
        foreach (var contour in contours)
        {
            if (contour is null) throw new ArgumentException("A contour is missing.", nameof(contours));
            foreach (var p in contour.Raw)
            {
                if (!(Math.Abs(p.X) <= 1e150 && Math.Abs(p.Y) <= 1e150))
                    throw new ArgumentException("Coordinates of contours must be finite numbers.", nameof(contours));
                bounds = bounds.Include(new Vec3(p.X, p.Y));
            }
        }
        var half = Math.Max(bounds.Size.X, bounds.Size.Y) / 2;
        if (!(half > 0)) return default;
        var perMm = (Grid.Limit - 2) / half;
        var engine = new RegionEngine { Arrangement = { Reach = 4 } };
        foreach (var contour in contours) engine.Add(ToGrid(contour.Raw, bounds.Center, perMm));
        var kept = new List<(int Contour, bool Forward)>();
        var rings = engine.Run(InsideRule.NonZero, kept);
        double area = 0, perimeter = 0;
        int outer = 0, holes = 0;
        foreach (var (index, forward) in kept)
        {
            var contour = contours[index];
            var signed = forward ? contour.SignedAreaXY : -contour.SignedAreaXY;
            if (signed > 0) outer++;
            else holes++;
            area += signed;
            perimeter += contour.Length;
        }
        foreach (var ring in rings)
        {
            var twice = Grid.DoubleArea(ring, 0, ring.Length);
            if (twice > 0) outer++;
            else holes++;
            area += twice / (2 * perMm * perMm);
            perimeter += Grid.Length(ring) / perMm;
        }
        return (area, perimeter, outer, holes);
    }

    private static GridPoint[] ToGrid(Vec3[] points, Vec3 center, double perMm)
        => Array.ConvertAll(points, p => new GridPoint(Grid.Round((p.X - center.X) * perMm), Grid.Round((p.Y - center.Y) * perMm)));
}
