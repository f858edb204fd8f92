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
        var (segment, share) = _index.Nearest(point.X * Grid.PerMm, point.Y * Grid.PerMm, Reach);
        contour = segment < 0 ? -1 : _contour[segment];
        at = segment < 0 ? 0 : _at[segment] + share * Length(_index.Segments[segment]);
        return segment >= 0;
    }

    /// <summary>The place at an arc length of a contour, mm, which may be negative or more than once around.</summary>
    public Vec3 At(int contour, double at)
    {
        var length = Lengths[contour];
        at -= Math.Floor(at / length) * length;
        // The last segment that begins before.
        var last = After(at, _first[contour] + 1, _first[contour + 1]) - 1;
        ref readonly var s = ref _index.Segments[last];
        return Vec3.Lerp(Grid.ToMm(s.A), new Vec3(s.Bx, s.By) / Grid.PerMm, Math.Min((at - _at[last]) / Length(s), 1));
    }

    /// <summary>Adds the corners of a contour between two arc lengths, in its direction; an end below the start lies after a full turn.</summary>
    public void Corners(int contour, double from, double to, List<Vec3> points)
    {
        int first = _first[contour], end = _first[contour + 1];
        for (var i = After(from, first, end); i < end && (_at[i] < to || to < from); i++) points.Add(Corner(i));
        for (var i = first; i < end && _at[i] < to && to < from; i++) points.Add(Corner(i));
    }

    // The first of some segments that begins after an arc length, or else the end.
    private int After(double at, int first, int end) => Search.First(first, end, (_at, at), static (s, i) => s._at[i] > s.at);

    private static double Length(in Segment s)
    {
        double dx = (double)s.Bx - s.Ax, dy = (double)s.By - s.Ay;
        return Math.Sqrt(dx * dx + dy * dy) / Grid.PerMm;
    }

    private Vec3 Corner(int i) => Grid.ToMm(_index.Segments[i].A);
}
