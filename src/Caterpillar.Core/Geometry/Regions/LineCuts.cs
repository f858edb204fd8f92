namespace Caterpillar.Geometry;

/// <summary>Where a straight line meets the boundary of a region, as parameters of the line from 0 to 1.</summary>
internal sealed class LineCuts(RegionIndex index)
{
    // In grid units.
    private double _ax, _ay, _bx, _by;
    private double _near;

    /// <summary>The cuts within the line, unsorted.</summary>
    public List<double> Found { get; } = [];

    /// <summary>True if an edge comes near the line or its ends.</summary>
    public bool Touched { get; private set; }

    /// <summary>True if an edge comes near the end of the line.</summary>
    public bool EndTouches { get; private set; }

    /// <summary>Begins with another line, in mm, that no edge meets so far.</summary>
    public void Begin(in Vec3 a, in Vec3 b)
    {
        Found.Clear();
        Touched = EndTouches = false;
        (_ax, _ay, _bx, _by) = (a.X * Grid.PerMm, a.Y * Grid.PerMm, b.X * Grid.PerMm, b.Y * Grid.PerMm);
        _near = 2 / Math.Sqrt((_bx - _ax) * (_bx - _ax) + (_by - _ay) * (_by - _ay));
    }

    /// <summary>Adds the cuts with the edges of one leaf of the index.</summary>
    public void Add(int leaf)
    {
        var tree = index.Tree;
        double ax = _ax, ay = _ay, bx = _bx, by = _by;
        ref readonly var box = ref tree.Boxes[leaf];
        if ((ax < bx ? bx : ax) < box.MinX - 1.0 || (ax < bx ? ax : bx) > box.MaxX + 1.0 || (ay < by ? by : ay) < box.MinY - 1.0
            || (ay < by ? ay : by) > box.MaxY + 1.0)
        {
            return;
        }
        for (var i = tree.LeafStart[leaf]; i < tree.LeafStart[leaf + 1]; i++) Cut(ax, ay, bx, by, index.Segments[i]);
    }

    private void Cut(double ax, double ay, double bx, double by, in Segment s)
    {
        double dx = bx - ax, dy = by - ay, square = dx * dx + dy * dy;
        if (square == 0) return;
        var c = dx * (s.Ay - ay) - dy * (s.Ax - ax);
        var d = dx * (s.By - ay) - dy * (s.Bx - ax);
        // Ends of edges within a grid unit of the line: where it may start or stop running along the boundary.
        if (c * c <= square) Add((dx * (s.Ax - ax) + dy * (s.Ay - ay)) / square);
        if (d * d <= square) Add((dx * (s.Bx - ax) + dy * (s.By - ay)) / square);
        if ((c > 0 && d > 0) || (c < 0 && d < 0)) return;
        double ex = (double)s.Bx - s.Ax, ey = (double)s.By - s.Ay;
        var a = ex * (ay - s.Ay) - ey * (ax - s.Ax);
        var b = ex * (by - s.Ay) - ey * (bx - s.Ax);
        if ((a > 0 && b > 0) || (a < 0 && b < 0) || a == b) return;
        Add(a / (a - b));
    }

    private void Add(double t)
    {
        if (t > 0 && t < 1) Found.Add(t);
        if (!(t > -_near && t < 1 + _near)) return;
        Touched = true;
        if (t > 1 - _near) EndTouches = true;
    }
}
