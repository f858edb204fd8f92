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

    /// <summary>The segment nearest to a point and the place in it from 0 to 1; −1 if none is nearer than a distance. In grid units.</summary>
    public (int Segment, double Share) Nearest(double x, double y, double distance)
    {
        var best = (Segment: -1, Share: 0.0, Square: distance * distance);
        if (Tree.Levels > 0) Nearest(x, y, Tree.Levels - 1, 0, ref best);
        return (best.Segment, best.Share);
    }

    private void Nearest(double x, double y, int level, int node, ref (int Segment, double Share, double Square) best)
    {
        if (SquareTo(x, y, level, node) >= best.Square) return;
        if (level > 0)
        {
            int near = 2 * node, far = near + 1;
            if (far >= Tree.LevelCount[level - 1]) far = -1;
            else if (SquareTo(x, y, level - 1, far) < SquareTo(x, y, level - 1, near)) (near, far) = (far, near);
            Nearest(x, y, level - 1, near, ref best);
            if (far >= 0) Nearest(x, y, level - 1, far, ref best);
            return;
        }
        for (var i = Tree.LeafStart[node]; i < Tree.LeafStart[node + 1]; i++)
        {
            ref readonly var s = ref Segments[i];
            double dx = (double)s.Bx - s.Ax, dy = (double)s.By - s.Ay, px = x - s.Ax, py = y - s.Ay;
            var share = Math.Min(Math.Max((px * dx + py * dy) / (dx * dx + dy * dy), 0), 1);
            double ex = px - share * dx, ey = py - share * dy;
            if (ex * ex + ey * ey < best.Square) best = (i, share, ex * ex + ey * ey);
        }
    }

    // Of the distance from a box.
    private double SquareTo(double x, double y, int level, int node)
    {
        ref readonly var box = ref Tree.Boxes[Tree.LevelStart[level] + node];
        var dx = Math.Max(Math.Max(box.MinX - x, x - box.MaxX), 0);
        var dy = Math.Max(Math.Max(box.MinY - y, y - box.MaxY), 0);
        return dx * dx + dy * dy;
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
