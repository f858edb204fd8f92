namespace Caterpillar.Geometry;

/// <summary>Points in mm, joined by straight segments. A closed polyline does not repeat its first point. Immutable.</summary>
public sealed class Polyline
{
    private readonly Vec3[] _points;

    /// <summary>A polyline through the points (mm), which are copied.</summary>
    public Polyline(IEnumerable<Vec3> points, bool closed = false)
        : this((points ?? throw new ArgumentNullException(nameof(points))).ToArray(), closed)
    {
    }

    private Polyline(Vec3[] points, bool closed)
    {
        _points = points;
        IsClosed = closed;
    }

    /// <summary>The points, mm. A closed polyline does not repeat the first one at the end.</summary>
    public IReadOnlyList<Vec3> Points => _points;

    /// <summary>Number of points.</summary>
    public int Count => _points.Length;

    /// <summary>True if the last point is joined to the first.</summary>
    public bool IsClosed { get; }

    /// <summary>A point, mm.</summary>
    public Vec3 this[int index] => _points[index];

    /// <summary>Number of segments, including the closing one of a closed polyline.</summary>
    public int SegmentCount => _points.Length < 2 ? 0 : IsClosed ? _points.Length : _points.Length - 1;

    /// <summary>Length in mm.</summary>
    public double Length
    {
        get
        {
            var sum = 0.0;
            for (var i = 0; i < SegmentCount; i++) sum += _points[i].DistanceTo(_points[i + 1 == _points.Length ? 0 : i + 1]);
            return sum;
        }
    }

    /// <summary>Bounding box, mm.</summary>
    public Bounds Bounds => Bounds.Of(_points);

    /// <summary>Signed area in mm² of the projection on the XY plane: positive if counterclockwise seen from above.</summary>
    public double SignedAreaXY
    {
        get
        {
            if (_points.Length < 3) return 0;
            // Relative to the first point, so that no digits are lost far from the origin.
            var o = _points[0];
            var sum = 0.0;
            for (var i = 1; i + 1 < _points.Length; i++)
            {
                var a = _points[i] - o;
                var b = _points[i + 1] - o;
                sum += a.X * b.Y - a.Y * b.X;
            }
            return sum / 2;
        }
    }

    /// <summary>Length in mm along points up to each of them, and back to the first one if they are closed.</summary>
    internal static double[] LengthsAlong(Vec3[] points, bool closed = false)
    {
        var lengths = new double[points.Length + (closed ? 1 : 0)];
        for (var i = 1; i < lengths.Length; i++) lengths[i] = lengths[i - 1] + points[i - 1].DistanceTo(points[i % points.Length]);
        return lengths;
    }

    /// <summary>Takes ownership of the array without a copy; for code that has just made it.</summary>
    internal static Polyline Own(Vec3[] points, bool closed) => new(points, closed);

    internal Vec3[] Raw => _points;
}
