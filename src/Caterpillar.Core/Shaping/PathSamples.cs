namespace Caterpillar.Shaping;

/// <summary>The vertices and segments of a path as sample points of a field.</summary>
internal sealed class PathSamples(Vec3[] points, PrintPath path, int number, bool closed)
{
    private readonly double[] _distances = Polyline.LengthsAlong(points, closed);

    public PathSample Vertex(int i) => new(points[i], _distances[i], _distances[_distances.Length - 1], number, path.Role);

    public PathSample Middle(int segment)
    {
        var end = (segment + 1) % points.Length;
        return new PathSample(
            (points[segment] + points[end]) * 0.5, (_distances[segment] + _distances[segment + 1]) / 2, _distances[_distances.Length - 1], number, path.Role);
    }

    /// <summary>Horizontal unit vector to the left of the path at a vertex; zero if the path goes straight up.</summary>
    public Vec3 Left(int i)
    {
        var before = i > 0 ? i - 1 : closed ? points.Length - 1 : 0;
        var after = i + 1 < points.Length ? i + 1 : closed ? 0 : i;
        var tangent = Direction(before, i) + Direction(i, after);
        return new Vec3(-tangent.Y, tangent.X).Unit();
    }

    private Vec3 Direction(int from, int to) => (points[to] - points[from]).WithZ(0).Unit();
}
