namespace Caterpillar.Geometry;

/// <summary>
/// A curve as points in mm with straight segments or arcs between them. A closed one does not repeat its first point and has a segment back to it. Immutable.
/// </summary>
public sealed class Subdivision
{
    private readonly Vec3[] _points;
    private readonly bool[] _linear;
    private readonly Arc?[]? _arcs;

    internal Subdivision(Vec3[] points, bool closed, bool[] linear, Arc?[]? arcs)
    {
        _points = points;
        _linear = linear;
        _arcs = arcs;
        IsClosed = closed;
    }

    /// <summary>mm; the first is not repeated at the end of a closed curve.</summary>
    public IReadOnlyList<Vec3> Points => _points;

    /// <summary>The last point is joined to the first.</summary>
    public bool IsClosed { get; }

    /// <summary>Pieces between points.</summary>
    public int SegmentCount => _linear.Length;

    /// <summary>True if the segment is a linear part of the curve, false if it approximates a piece of a curved part.</summary>
    public bool IsLinear(int segment) => _linear[segment];

    /// <summary>End point of a segment.</summary>
    public Vec3 EndOf(int segment) => segment + 1 == _points.Length ? _points[0] : _points[segment + 1];

    internal Vec3[] Raw => _points;

    internal Arc?[]? RawArcs => _arcs;
}
