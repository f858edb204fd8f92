namespace Caterpillar.Geometry;

/// <summary>The segments of a region in a box tree, for queries of points and lines. Immutable after construction.</summary>
internal sealed class RegionIndex
{
    public readonly Segment[] Segments;
    public readonly BoxTree Tree = new();

    public RegionIndex(GridPoint[][] paths)
    {
        Segments = new Segment[paths.Sum(path => path.Length)];
        var start = new int[paths.Length + 1];
        var n = 0;
        for (var c = 0; c < paths.Length; c++)
        {
            var path = paths[c];
            for (var i = 0; i < path.Length; i++) Segments[n++] = new Segment(path[i], path[i + 1 == path.Length ? 0 : i + 1]);
            start[c + 1] = n;
        }
        Tree.Build(Segments, null, start, paths.Length);
    }

    /// <summary>True inside and within half a grid unit of the boundary. Coordinates in grid units; false for NaN.</summary>
    public bool Contains(double x, double y)
    {
        if (Tree.Levels == 0) return false;
        var onBoundary = false;
        var winding = Winding(x, y, Tree.Levels - 1, 0, ref onBoundary);
        return onBoundary || winding > 0;
    }

    /// <summary>Whether a segment comes within a distance of a point. In grid units.</summary>
    public bool Reaches(double x, double y, double distance) => Tree.Levels > 0 && Reaches(x, y, distance, Tree.Levels - 1, 0);

    private bool Reaches(double x, double y, double distance, int level, int node)
    {
        ref readonly var box = ref Tree.Boxes[Tree.LevelStart[level] + node];
        if (x < box.MinX - distance || x > box.MaxX + distance || y < box.MinY - distance || y > box.MaxY + distance) return false;
        if (level > 0)
        {
            return Reaches(x, y, distance, level - 1, 2 * node)
                || (2 * node + 1 < Tree.LevelCount[level - 1] && Reaches(x, y, distance, level - 1, 2 * node + 1));
        }
        for (var i = Tree.LeafStart[node]; i < Tree.LeafStart[node + 1]; i++)
        {
            ref readonly var s = ref Segments[i];
            double dx = (double)s.Bx - s.Ax, dy = (double)s.By - s.Ay, px = x - s.Ax, py = y - s.Ay;
            var along = Math.Max(0, Math.Min(1, (px * dx + py * dy) / (dx * dx + dy * dy)));
            var (ex, ey) = (px - along * dx, py - along * dy);
            if (ex * ex + ey * ey <= distance * distance) return true;
        }
        return false;
    }

    private int Winding(double x, double y, int level, int node, ref bool onBoundary)
    {
        ref readonly var box = ref Tree.Boxes[Tree.LevelStart[level] + node];
        if (!(y >= box.MinY - 0.5 && y <= box.MaxY + 0.5 && box.MinX - 0.5 <= x)) return 0;
        var sum = 0;
        if (level > 0)
        {
            sum = Winding(x, y, level - 1, 2 * node, ref onBoundary);
            if (2 * node + 1 < Tree.LevelCount[level - 1]) sum += Winding(x, y, level - 1, 2 * node + 1, ref onBoundary);
            return sum;
        }
        for (var i = Tree.LeafStart[node]; i < Tree.LeafStart[node + 1]; i++)
        {
            ref readonly var s = ref Segments[i];
            double dx = (double)s.Bx - s.Ax, dy = (double)s.By - s.Ay, px = x - s.Ax, py = y - s.Ay;
            var side = dx * py - dy * px;
            if (s.Ay <= y)
            {
                if (s.By > y && side < 0) sum--;
            }
            else if (s.By <= y && side > 0)
            {
                sum++;
            }
            var square = dx * dx + dy * dy;
            if (side * side > 0.25 * square) continue;
            // On the line of the segment: within its ends?
            var along = px * dx + py * dy;
            var beyond = along < 0 ? px * px + py * py : along > square ? (px - dx) * (px - dx) + (py - dy) * (py - dy) : 0;
            if (beyond <= 0.25) onBoundary = true;
        }
        return sum;
    }
}
