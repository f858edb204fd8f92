namespace Caterpillar.Geometry;

/// <summary>Quick answers about two regions, so that the regions of neighboring layers need to be combined only where they differ.</summary>
internal static class RegionNeighbors
{
    /// <summary>
    /// The contours whose boxes reach into a box. Inside the box the result covers what the region covers; outside of it holes may be filled.
    /// </summary>
    public static Region Near(this Region region, in GridBox box) => Only(region, [box]);

    /// <summary>The same for several boxes, each with what is around it up to a distance, mm.</summary>
    public static Region Near(this Region region, IReadOnlyList<GridBox> boxes, double distance)
        => Only(region, [.. boxes.Select(box => box.Grown(distance))]);

    // A hole never stays without its outline, whose box is larger.
    private static Region Only(Region region, GridBox[] places)
    {
        GridPoint[][] near = [.. region.Reaching(places).Select(i => region.Paths[i])];
        return near.Length == region.Paths.Length ? region : Region.Own(near);
    }

    /// <summary>
    /// The contours that reach into a box, each without the corners that do not matter inside of it. Inside the box the result covers what the region
    /// covers; outside of it contours may cross, so it is only good for clipping what lies in the box.
    /// </summary>
    public static Region Cropped(this Region region, in GridBox box)
    {
        var paths = new List<GridPoint[]>();
        foreach (var i in region.Reaching([box]))
        {
            var path = Cropped(region.Paths[i], box);
            if (path.Length > 2) paths.Add(path);
        }
        return Region.Own([.. paths]);
    }

    // A run of corners that are all on the same side of the box, such as left of it, is replaced by its first and its last one.
    private static GridPoint[] Cropped(GridPoint[] path, in GridBox box)
    {
        var kept = new GridPoint[path.Length];
        int count = 0, run = 0, sides = 0;
        foreach (var p in path)
        {
            var side = (p.X < box.MinX ? 1 : p.X > box.MaxX ? 2 : 0) | (p.Y < box.MinY ? 4 : p.Y > box.MaxY ? 8 : 0);
            var same = (sides & side) != 0;
            run = same ? run + 1 : 1;
            sides = same ? sides & side : side;
            if (run > 2) count--;
            kept[count++] = p;
        }
        if (count < path.Length) Array.Resize(ref kept, count);
        return kept;
    }

    /// <summary>True if both have the same contours, vertex by vertex.</summary>
    public static bool SameAs(this Region region, Region other)
        => ReferenceEquals(region, other)
            || (region.Paths.Length == other.Paths.Length && region.Paths.Zip(other.Paths, (a, b) => a.SequenceEqual(b)).All(same => same));

    /// <summary>
    /// True if the other region lies inside a region and their boundaries do not meet. Where they do it is false, even if nothing of the other sticks out.
    /// </summary>
    public static bool Surrounds(this Region region, Region other)
    {
        if (other.IsEmpty) return true;
        if (region.IsEmpty) return false;
        GridBox box = region.Box, inner = other.Box;
        if (inner.MinX <= box.MinX || inner.MinY <= box.MinY || inner.MaxX >= box.MaxX || inner.MaxY >= box.MaxY) return false;
        if (RegionMeeting.Meet(region.Index, other.Index)) return false;
        if (!other.Paths.All(path => region.Index.Contains(path[0].X, path[0].Y))) return false;
        // A hole of this region within the other one.
        return !region.Reaching([inner]).Any(i => other.Index.Contains(region.Paths[i][0].X, region.Paths[i][0].Y));
    }

    /// <summary>True if a small region neither touches this one nor is inside it or around a piece of it.</summary>
    public static bool IsApartFrom(this Region region, Region small)
    {
        var box = small.Box;
        var near = region.Near(box);
        if (near.IsEmpty || small.IsEmpty) return true;
        if (RegionMeeting.Meet(region.Index, small.Index)) return false;
        return !small.Paths.Any(path => region.Index.Contains(path[0].X, path[0].Y)) && !near.Paths.Any(path => small.Index.Contains(path[0].X, path[0].Y));
    }

    /// <summary>The point of the boundary nearest to a place, in mm and at its height; null if none is nearer than a distance, mm.</summary>
    public static Vec3? NearestEdge(this Region region, Vec3 place, double within = double.PositiveInfinity)
    {
        var (segment, share) = region.Index.Nearest(place.X * Grid.PerMm, place.Y * Grid.PerMm, within * Grid.PerMm);
        if (segment < 0) return null;
        ref readonly var s = ref region.Index.Segments[segment];
        return (new Vec3(s.Ax + share * ((double)s.Bx - s.Ax), s.Ay + share * ((double)s.By - s.Ay)) / Grid.PerMm).WithZ(place.Z);
    }
}
