namespace Caterpillar.Geometry;

/// <summary>
/// A curve as points in mm, joined by straight segments or arcs. A closed curve does not repeat its first point and has a closing segment. Immutable.
/// </summary>
public sealed class Subdivision
{
    private readonly Vec3[] _points;
    private readonly bool[] _linear;

    internal Subdivision(Vec3[] points, bool closed, bool[] linear, Arc?[]? arcs) => (_points, IsClosed, _linear, RawArcs) = (points, closed, linear, arcs);

    /// <summary>The points, mm. A closed curve does not repeat the first one at the end.</summary>
    public IReadOnlyList<Vec3> Points => _points;

    /// <summary>True if the last point is joined to the first.</summary>
    public bool IsClosed { get; }

    /// <summary>Number of segments.</summary>
    public int SegmentCount => _linear.Length;

    /// <summary>True if the segment is a linear part of the curve, false if it approximates a curved part.</summary>
    public bool IsLinear(int segment) => _linear[segment];

    /// <summary>End point of a segment.</summary>
    public Vec3 EndOf(int segment) => segment + 1 == _points.Length ? _points[0] : _points[segment + 1];

    internal Vec3[] Raw => _points;

    internal Arc?[]? RawArcs { get; }
}
