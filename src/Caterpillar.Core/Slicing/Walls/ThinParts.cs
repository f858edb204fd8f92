namespace Caterpillar.Slicing;

/// <summary>Tells the thin parts of regions from the thick ones, by shrinking and growing back.</summary>
internal static class ThinParts
{
    private const double ArcTolerance = 0.005;

    /// <summary>Corners that are sharper than 29° are thin places; others belong to the thick part.</summary>
    public const double MiterLimit = 4;

    /// <summary>Grown back by a little more than it was shrunk, mm, so that rounding leaves no film.</summary>
    public const double Film = 1e-3;

    /// <summary>What of a region is thinner than twice a distance.</summary>
    /// <param name="region">The region.</param>
    /// <param name="half">mm.</param>
    /// <param name="smallest">Thin contours with less area than this are none, mm².</param>
    /// <param name="engine">Clips.</param>
    /// <param name="thick">The other part and some more, or the region itself if nothing is thin.</param>
    public static Region Of(Region region, double half, double smallest, RegionEngine engine, out Region thick)
        => Of(region, region.Offset(-half, JoinStyle.Miter, MiterLimit, ArcTolerance, engine), half, smallest, engine, out thick);

    /// <summary>The same where the shrunk region is known, or the pieces of it that matter; the engine has made nothing since.</summary>
    public static Region Of(Region region, Region core, double half, double smallest, RegionEngine engine, out Region thick)
    {
        thick = region;
        if (core.IsEmpty)
        {
            thick = core;
            return region;
        }
        // Where all contours are still there and meet nowhere, no two sides are near; what is left are corners.
        var apart = !engine.Arrangement.Touches && !engine.Arrangement.Cut && core.Paths.Length == region.Paths.Length;
        if (apart && !HasSharpCorner(region)) return Region.Empty;
        var grown = core.Offset(half + Film, JoinStyle.Miter, MiterLimit, ArcTolerance, engine);
        var thin = region.Subtract(grown, engine).WithoutSmallContours(smallest);
        if (!thin.IsEmpty) thick = grown;
        return thin;
    }

    /// <summary>What of a region is thicker than twice a distance, with its corners; a region without thin places stays what it is.</summary>
    public static Region Thick(Region region, double half, RegionEngine engine)
    {
        if (region.IsEmpty) return region;
        var thin = Of(region, half, 0, engine, out var thick);
        return thin.IsEmpty ? region : thick.Intersect(region, engine);
    }

    // A corner of less than 30° is thin at its tip.
    private static bool HasSharpCorner(Region region)
    {
        foreach (var path in region.Paths)
        {
            var a = path[path.Length - 2];
            var b = path[path.Length - 1];
            foreach (var c in path)
            {
                double ux = (double)b.X - a.X, uy = (double)b.Y - a.Y, vx = (double)c.X - b.X, vy = (double)c.Y - b.Y;
                var dot = ux * vx + uy * vy;
                if (dot < 0 && ux * vy - uy * vx > 0 && dot * dot > 0.75 * (ux * ux + uy * uy) * (vx * vx + vy * vy)) return true;
                a = b;
                b = c;
            }
        }
        return false;
    }
}
