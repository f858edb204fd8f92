namespace Caterpillar.Geometry;

/// <summary>Assigns each hole of a region to the smallest outer contour around it.</summary>
internal static class IslandFinder
{
    public static Region[] Split(Region region)
    {
        var paths = region.Paths;
        var areas = new long[paths.Length];
        var members = new List<GridPoint[]>?[paths.Length];
        var outers = 0;
        for (var i = 0; i < paths.Length; i++)
        {
            areas[i] = Grid.DoubleArea(paths[i], 0, paths[i].Length);
            if (areas[i] <= 0) continue;
            members[i] = new List<GridPoint[]> { paths[i] };
            outers++;
        }
        // The outer contour comes first in each piece.
        if (outers == 1 && areas[0] > 0) return new[] { region };
        for (var i = 0; i < paths.Length; i++)
        {
            if (areas[i] > 0) continue;
            var owner = Owner(i, region, areas);
            if (owner >= 0) members[owner]!.Add(paths[i]);
        }
        var islands = new Region[outers];
        var n = 0;
        foreach (var member in members)
        {
            if (member is not null) islands[n++] = Region.Own(member.ToArray());
        }
        return islands;
    }

    private static int Owner(int hole, Region region, long[] areas)
    {
        var (paths, boxes) = (region.Paths, region.Boxes);
        var owner = -1;
        foreach (var k in region.Reaching([boxes[hole]]))
        {
            if (areas[k] < -areas[hole] || (owner >= 0 && areas[k] >= areas[owner])) continue;
            if (boxes[k].MinX > boxes[hole].MinX || boxes[k].MaxX < boxes[hole].MaxX || boxes[k].MinY > boxes[hole].MinY
                || boxes[k].MaxY < boxes[hole].MaxY)
            {
                continue;
            }
            if (Inside(paths[k], paths[hole])) owner = k;
        }
        return owner;
    }

    // Contours may share vertices but no points within edges, so the middle of an edge decides; in doubled coordinates it is exact.
    private static bool Inside(GridPoint[] outer, GridPoint[] ring)
    {
        long x = (long)ring[0].X + ring[1].X, y = (long)ring[0].Y + ring[1].Y;
        var inside = false;
        var a = outer[outer.Length - 1];
        foreach (var b in outer)
        {
            var up = 2L * b.Y > y;
            if (2L * a.Y > y != up)
            {
                var side = ((long)b.X - a.X) * (y - 2L * a.Y) - ((long)b.Y - a.Y) * (x - 2L * a.X);
                if (side > 0 == up) inside = !inside;
            }
            a = b;
        }
        return inside;
    }
}
