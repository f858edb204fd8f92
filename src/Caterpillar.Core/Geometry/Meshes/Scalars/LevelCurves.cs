namespace Caterpillar.Geometry;

/// <summary>The curves on a mesh where values at its vertices have a level, linear in each triangle.</summary>
internal sealed class LevelCurves
{
    private readonly TriMesh _mesh;
    private readonly double[] _values;
    private readonly double[] _levels;
    private readonly List<int>[] _crossed;

    /// <summary>Prepares the levels.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="values">One for each vertex.</param>
    /// <param name="levels">Ascending.</param>
    /// <param name="isWanted">Of a triangle, by its first corner, and a level: whether the curve is needed there. Null = everywhere.</param>
    public LevelCurves(TriMesh mesh, double[] values, double[] levels, Func<int, int, bool>? isWanted = null)
    {
        _mesh = mesh;
        _values = values;
        _levels = levels;
        _crossed = new List<int>[levels.Length];
        for (var i = 0; i < levels.Length; i++) _crossed[i] = [];
        var corners = mesh.RawTriangles;
        for (var t = 0; t < corners.Length; t += 3)
        {
            double a = values[corners[t]], b = values[corners[t + 1]], c = values[corners[t + 2]];
            double low = Math.Min(a, Math.Min(b, c)), high = Math.Max(a, Math.Max(b, c));
            if (!(high > low)) continue;
            var first = Array.BinarySearch(levels, low);
            first = first < 0 ? ~first : first + 1;
            for (var i = first; i < levels.Length && levels[i] <= high; i++)
            {
                if (isWanted is null || isWanted(t, i)) _crossed[i].Add(t);
            }
        }
    }

    /// <summary>
    /// The curves of one level; seen from outside higher values lie above, so that outlines run counter-clockwise. Points that a straight line does not need
    /// are left away. Any thread.
    /// </summary>
    /// <param name="level">Its number.</param>
    /// <param name="tolerance">How far the curves may lie off the exact ones, mm.</param>
    public List<Polyline> Trace(int level, double tolerance)
    {
        var corners = _mesh.RawTriangles;
        var partner = _mesh.Topology.Partner;
        var left = new HashSet<int>(_crossed[level]);
        var result = new List<Polyline>();
        // Open ones from their beginning first.
        foreach (var t in _crossed[level])
        {
            var before = partner[HalfEdge(t, level, rising: false)];
            if (before < 0 || !left.Contains(before - before % 3)) Follow(t);
        }
        foreach (var t in _crossed[level]) Follow(t);
        return result;

        void Follow(int t)
        {
            if (!left.Remove(t)) return;
            var line = new List<Vec3> { Crossing(HalfEdge(t, level, rising: false), level) };
            while (true)
            {
                var rising = HalfEdge(t, level, rising: true);
                line.Add(Crossing(rising, level));
                var next = partner[rising];
                if (next < 0) break;
                t = next - next % 3;
                if (!left.Remove(t)) break;
            }
            var thinned = Thinned(line, tolerance);
            if (thinned.Count > (thinned.IsClosed ? 2 : 1)) result.Add(thinned);
        }

        int HalfEdge(int t, int at, bool rising)
        {
            for (var k = 0; k < 3; k++)
            {
                bool from = _values[corners[t + k]] >= _levels[at], to = _values[corners[t + (k + 1) % 3]] >= _levels[at];
                if (from != to && to == rising) return t + k;
            }
            throw new InvalidOperationException("The level does not cross the triangle.");
        }
    }

    private Vec3 Crossing(int half, int level)
    {
        var corners = _mesh.RawTriangles;
        var t = half - half % 3;
        int a = corners[half], b = corners[t + (half + 1) % 3];
        if (a > b) (a, b) = (b, a);
        return Vec3.Lerp(_mesh.RawVertices[a], _mesh.RawVertices[b], (_levels[level] - _values[a]) / (_values[b] - _values[a]));
    }

    private static Polyline Thinned(List<Vec3> line, double tolerance)
    {
        var kept = LineThinner.Thin(line, tolerance);
        var closed = line[line.Count - 1].DistanceTo(line[0]) <= 1e-9;
        if (!closed) kept.Add(line[line.Count - 1]);
        return Polyline.Own(kept.ToArray(), closed);
    }
}
