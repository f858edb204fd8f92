namespace Caterpillar.Shaping;

/// <summary>The vertices and segments of a path as sample points of a field.</summary>
internal sealed class PathSamples
{
    private readonly Vec3[] _points;
    private readonly double[] _distances;
    private readonly bool _closed;
    private readonly int _number;
    private readonly Role _role;

    public PathSamples(Vec3[] points, PrintPath path, int number, bool closed)
    {
        _points = points;
        _closed = closed;
        _number = number;
        _role = path.Role;
        _distances = new double[points.Length + (closed ? 1 : 0)];
        for (var i = 1; i < _distances.Length; i++) _distances[i] = _distances[i - 1] + points[i - 1].DistanceTo(points[i % points.Length]);
    }

    public PathSample Vertex(int i) => new(_points[i], _distances[i], _distances[_distances.Length - 1], _number, _role);

    public PathSample Middle(int segment)
    {
        var end = (segment + 1) % _points.Length;
        return new PathSample(
            (_points[segment] + _points[end]) * 0.5, (_distances[segment] + _distances[segment + 1]) / 2, _distances[_distances.Length - 1], _number, _role);
    }

    /// <summary>Horizontal unit vector to the left of the path at a vertex; zero if the path goes straight up.</summary>
    public Vec3 Left(int i)
    {
        var before = i > 0 ? i - 1 : _closed ? _points.Length - 1 : 0;
        var after = i + 1 < _points.Length ? i + 1 : _closed ? 0 : i;
        var tangent = Direction(before, i) + Direction(i, after);
        return new Vec3(-tangent.Y, tangent.X).Unit();
    }

    private Vec3 Direction(int from, int to) => (_points[to] - _points[from]).WithZ(0).Unit();
}
