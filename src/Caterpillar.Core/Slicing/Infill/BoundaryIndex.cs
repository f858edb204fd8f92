namespace Caterpillar.Slicing;

/// <summary>Places on the boundary of a region by contour and arc length.</summary>
internal sealed class BoundaryIndex
{
    // Ends of cut lines lie on the boundary but for rounding, in grid units.
    private const double Reach = 8;

    private readonly RegionIndex _index;
    private readonly int[] _contour;
    private readonly int[] _first;
    private readonly double[] _at;
    private double _best;
    private int _segment;
    private double _share;

    public BoundaryIndex(Region region)
    {
        _index = region.Index;
        var paths = region.Paths;
        var segments = _index.Segments;
        _contour = new int[segments.Length];
        _first = new int[paths.Length + 1];
        _at = new double[segments.Length];
        Lengths = new double[paths.Length];
        var n = 0;
        for (var c = 0; c < paths.Length; c++)
        {
            _first[c] = n;
            var sum = 0.0;
            for (var i = 0; i < paths[c].Length; i++, n++)
            {
                _contour[n] = c;
                _at[n] = sum;
                sum += Length(segments[n]);
            }
            Lengths[c] = sum;
        }
        _first[paths.Length] = n;
    }

    /// <summary>Length of each contour, mm.</summary>
    public double[] Lengths { get; }

    /// <summary>The contour of a point (mm) and its arc length there, mm. False if it is on none.</summary>
    public bool Find(Vec3 point, out int contour, out double at)
    {
        contour = -1;
        at = 0;
        if (!Search(point, Reach)) return false;
        contour = _contour[_segment];
        at = _at[_segment] + _share * Length(_index.Segments[_segment]);
        return true;
    }

    /// <summary>The place at an arc length of a contour, mm, which may be negative or more than once around.</summary>
    public Vec3 At(int contour, double at)
    {
        var length = Lengths[contour];
        at -= Math.Floor(at / length) * length;
        int low = _first[contour], high = _first[contour + 1];
        // The last segment that begins before.
        while (high - low > 1)
        {
            var middle = (low + high) / 2;
            if (_at[middle] > at) high = middle;
            else low = middle;
        }
        ref readonly var s = ref _index.Segments[low];
        return Vec3.Lerp(Grid.ToMm(s.A), new Vec3(s.Bx, s.By) / Grid.PerMm, Math.Min((at - _at[low]) / Length(s), 1));
    }

    /// <summary>The place of the boundary that is nearest to a point, mm.</summary>
    public Vec3 Nearest(Vec3 point)
    {
        if (!Search(point, 4.0 * Grid.Limit)) return point;
        ref readonly var s = ref _index.Segments[_segment];
        return new Vec3(s.Ax + _share * ((double)s.Bx - s.Ax), s.Ay + _share * ((double)s.By - s.Ay)) / Grid.PerMm;
    }

    /// <summary>Adds the corners of a contour between two arc lengths, in its direction; an end below the start lies after a full turn.</summary>
    public void Corners(int contour, double from, double to, List<Vec3> points)
    {
        int first = _first[contour], end = _first[contour + 1];
        // The first corner after the start.
        int low = first, high = end;
        while (low < high)
        {
            var middle = (low + high) / 2;
            if (_at[middle] > from) high = middle;
            else low = middle + 1;
        }
        if (to >= from)
        {
            for (var i = low; i < end && _at[i] < to; i++) points.Add(Corner(i));
            return;
        }
        for (var i = low; i < end; i++) points.Add(Corner(i));
        for (var i = first; i < end && _at[i] < to; i++) points.Add(Corner(i));
    }

    private static double Length(in Segment s)
    {
        double dx = (double)s.Bx - s.Ax, dy = (double)s.By - s.Ay;
        return Math.Sqrt(dx * dx + dy * dy) / Grid.PerMm;
    }

    private Vec3 Corner(int i) => Grid.ToMm(_index.Segments[i].A);

    // The nearest segment within a reach.
    private bool Search(Vec3 point, double reach)
    {
        _best = reach * reach;
        _segment = -1;
        if (_index.Tree.Levels > 0) Descend(point.X * Grid.PerMm, point.Y * Grid.PerMm, _index.Tree.Levels - 1, 0);
        return _segment >= 0;
    }

    private void Descend(double x, double y, int level, int node)
    {
        var tree = _index.Tree;
        if (Distance(x, y, level, node) >= _best) return;
        if (level > 0)
        {
            int near = 2 * node, far = near + 1;
            if (far >= tree.LevelCount[level - 1]) far = -1;
            else if (Distance(x, y, level - 1, far) < Distance(x, y, level - 1, near)) (near, far) = (far, near);
            Descend(x, y, level - 1, near);
            if (far >= 0) Descend(x, y, level - 1, far);
            return;
        }
        for (var i = tree.LeafStart[node]; i < tree.LeafStart[node + 1]; i++)
        {
            ref readonly var s = ref _index.Segments[i];
            double dx = (double)s.Bx - s.Ax, dy = (double)s.By - s.Ay, px = x - s.Ax, py = y - s.Ay;
            var t = Math.Min(Math.Max((px * dx + py * dy) / (dx * dx + dy * dy), 0), 1);
            double ex = px - t * dx, ey = py - t * dy, distance = ex * ex + ey * ey;
            if (distance >= _best) continue;
            _best = distance;
            _segment = i;
            _share = t;
        }
    }

    // Square of the distance from a box, in grid units.
    private double Distance(double x, double y, int level, int node)
    {
        ref readonly var box = ref _index.Tree.Boxes[_index.Tree.LevelStart[level] + node];
        var dx = Math.Max(Math.Max(box.MinX - x, x - box.MaxX), 0);
        var dy = Math.Max(Math.Max(box.MinY - y, y - box.MaxY), 0);
        return dx * dx + dy * dy;
    }
}
