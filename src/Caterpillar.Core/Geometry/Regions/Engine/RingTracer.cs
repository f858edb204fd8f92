namespace Caterpillar.Geometry;

/// <summary>
/// Follows the boundary of the inside through a graph and gives simple rings with the inside on their left. At vertices where several rings meet it keeps
/// to the same piece of the inside; a ring that returns to a vertex is cut there.
/// </summary>
internal sealed class RingTracer
{
    private sbyte[] _side = new sbyte[256];
    private int[] _place = new int[256];
    private int[] _degree = new int[256];
    private int[] _path = new int[256];

    public void Trace(PlanarGraph graph, InsideRule rule, List<GridPoint[]> rings)
    {
        Buffers.Reserve(ref _side, graph.Edges);
        Buffers.Reserve(ref _place, graph.Edges);
        Buffers.Reserve(ref _degree, graph.Edges);
        Buffers.Reserve(ref _path, graph.Edges + 1);
        for (var v = 0; v < graph.Vertices.Count; v++)
        {
            _place[v] = -1;
            _degree[v] = 0;
        }
        for (var e = 0; e < graph.Edges; e++)
        {
            _side[e] = (sbyte)graph.Boundary(e, rule);
            if (_side[e] == 0) continue;
            _degree[graph.Tail[e]]++;
            _degree[graph.Head[e]]++;
        }
        for (var e = 0; e < graph.Edges; e++)
        {
            if (_side[e] != 0) Follow(graph, _side[e] > 0 ? 2 * e : 2 * e + 1, rings);
        }
    }

    private void Follow(PlanarGraph graph, int half, List<GridPoint[]> rings)
    {
        var count = 0;
        while (half >= 0)
        {
            var v = (half & 1) == 0 ? graph.Tail[half >> 1] : graph.Head[half >> 1];
            if (_place[v] >= 0) count = Close(graph, _place[v], count, rings);
            _place[v] = count;
            _path[count++] = v;
            _side[half >> 1] = 0;
            half = Next(graph, half);
        }
        // The walk ends where it started: the rest is the last ring.
        Close(graph, 0, count, rings);
    }

    // The first boundary half-edge clockwise of the reverse half-edge that leaves with the inside on its left; -1 at the end.
    private int Next(PlanarGraph graph, int half)
    {
        var v = graph.Other(half);
        int start = graph.HalfStart[v], end = graph.HalfStart[v + 1];
        var back = start;
        while (graph.Half[back] != (half ^ 1)) back++;
        for (var i = back == start ? end - 1 : back - 1; i != back; i = i == start ? end - 1 : i - 1)
        {
            var h = graph.Half[i];
            var side = _side[h >> 1];
            if (side != 0 && side > 0 == ((h & 1) == 0)) return h;
        }
        return -1;
    }

    // Takes the ring path[from..count) out of the path.
    private int Close(PlanarGraph graph, int from, int count, List<GridPoint[]> rings)
    {
        var points = graph.Vertices.Points;
        var kept = 0;
        for (var i = from; i < count; i++)
        {
            _place[_path[i]] = -1;
            if (!Straight(graph, i == from ? count - 1 : i - 1, i, i + 1 == count ? from : i + 1)) kept++;
        }
        if (kept >= 3)
        {
            var ring = new GridPoint[kept];
            kept = 0;
            for (var i = from; i < count; i++)
            {
                if (!Straight(graph, i == from ? count - 1 : i - 1, i, i + 1 == count ? from : i + 1)) ring[kept++] = points[_path[i]];
            }
            rings.Add(ring);
        }
        return from;
    }

    // A vertex between two collinear edges of the boundary and nothing else is not needed.
    private bool Straight(PlanarGraph graph, int before, int at, int after)
    {
        var v = _path[at];
        var points = graph.Vertices.Points;
        return _degree[v] == 2 && Grid.Cross(points[_path[before]], points[v], points[_path[after]]) == 0;
    }
}
