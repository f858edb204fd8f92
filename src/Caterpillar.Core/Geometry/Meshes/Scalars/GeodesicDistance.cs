namespace Caterpillar.Geometry;

/// <summary>
/// Distances along a mesh from a set of vertices, by fast marching (Kimmel and Sethian, 1998): fronts cross triangles as straight lines; across an obtuse angle
/// they come from a vertex of the triangles beyond it, laid flat. Exact where fronts are straight; else the error shrinks with the edges.
/// </summary>
internal sealed class GeodesicDistance
{
    private readonly TriMesh _mesh;
    private readonly int[] _corners;
    private readonly double[] _distance;
    private readonly bool[] _done;
    private readonly int[] _starts;
    private readonly int[] _around;
    private readonly SortedSet<(double Distance, int Vertex)> _front = [];

    private GeodesicDistance(TriMesh mesh)
    {
        _mesh = mesh;
        _corners = mesh.RawTriangles;
        _distance = new double[mesh.VertexCount];
        _done = new bool[mesh.VertexCount];
        for (var i = 0; i < _distance.Length; i++) _distance[i] = double.PositiveInfinity;
        _starts = new int[mesh.VertexCount + 1];
        foreach (var v in _corners) _starts[v + 1]++;
        for (var i = 0; i < mesh.VertexCount; i++) _starts[i + 1] += _starts[i];
        _around = new int[_corners.Length];
        var next = (int[])_starts.Clone();
        for (var h = 0; h < _corners.Length; h++) _around[next[_corners[h]]++] = h;
    }

    /// <summary>The distance of every vertex, mm; infinite on pieces of the mesh without a source.</summary>
    public static double[] From(TriMesh mesh, IEnumerable<int> sources, CancellationToken cancel)
    {
        var marching = new GeodesicDistance(mesh);
        foreach (var source in sources) marching.Offer(source, 0);
        var count = 0;
        while (marching._front.Count > 0)
        {
            if (++count % 4096 == 0) cancel.ThrowIfCancellationRequested();
            var first = marching._front.Min;
            marching._front.Remove(first);
            marching._done[first.Vertex] = true;
            marching.Spread(first.Vertex);
        }
        return marching._distance;
    }

    private void Offer(int vertex, double distance)
    {
        if (_done[vertex] || !(distance < _distance[vertex])) return;
        if (!double.IsInfinity(_distance[vertex])) _front.Remove((_distance[vertex], vertex));
        _distance[vertex] = distance;
        _front.Add((distance, vertex));
    }

    private void Spread(int vertex)
    {
        for (var k = _starts[vertex]; k < _starts[vertex + 1]; k++)
        {
            var h = _around[k];
            var t = h - h % 3;
            int b = _corners[t + (h + 1) % 3], c = _corners[t + (h + 2) % 3];
            Update(b, vertex, c, t + (h + 2) % 3);
            Update(c, vertex, b, h);
        }
    }

    // Of vertex v from the edge between p and q; the half edge is the one opposite v.
    private void Update(int v, int p, int q, int opposite)
    {
        if (_done[v]) return;
        var points = _mesh.RawVertices;
        Vec3 toP = points[p] - points[v], toQ = points[q] - points[v];
        Offer(v, _distance[p] + toP.Length);
        if (Vec3.Dot(toP, toQ) >= 0)
        {
            if (_done[q]) Offer(v, Front(toP.Length, toQ.Length, (points[p] - points[q]).Length, _distance[p], _distance[q]));
            return;
        }
        Unfold(v, p, q, opposite);
    }

    // The front in a triangle, laid flat: the plane wave that has the distances of p and q. Infinite where it does not come through the edge.
    private static double Front(double toP, double toQ, double edge, double p, double q)
    {
        if (!(edge > 0)) return double.PositiveInfinity;
        // p at 0, q at (edge, 0), the vertex at (x, y).
        var x = (edge * edge + toP * toP - toQ * toQ) / (2 * edge);
        var y = Math.Sqrt(Math.Max(0, toP * toP - x * x));
        var along = (q - p) / edge;
        if (!(Math.Abs(along) < 1)) return double.PositiveInfinity;
        var across = Math.Sqrt(1 - along * along);
        // The ray back from the vertex meets the edge between its ends.
        var foot = x - y * along / across;
        return foot < -1e-9 * edge || foot > edge * (1 + 1e-9) ? double.PositiveInfinity : p + along * x + across * y;
    }

    // Lays triangles beyond the edge flat until a vertex comes to lie within the angle at v; then both parts of the angle are acute.
    private void Unfold(int v, int p, int q, int opposite)
    {
        const int Farthest = 6;
        var points = _mesh.RawVertices;
        double toP = (points[p] - points[v]).Length, toQ = (points[q] - points[v]).Length;
        // v at 0, p on the x axis.
        var cos = Vec3.Dot(points[p] - points[v], points[q] - points[v]) / (toP * toQ);
        var sin = Math.Sqrt(Math.Max(0, 1 - cos * cos));
        double px = toP, py = 0, qx = toQ * cos, qy = toQ * sin;
        // Directions at right angles to both sides: what lies between them splits the angle into two acute ones.
        double wallX = qx, wallY = qy;
        var half = opposite;
        var (left, right) = (p, q);
        for (var step = 0; step < Farthest; step++)
        {
            var partner = _mesh.Topology.Partner[half];
            if (partner < 0) return;
            var t = partner - partner % 3;
            var s = _corners[t + (partner + 2) % 3];
            double a = (points[s] - points[left]).Length, b = (points[s] - points[right]).Length;
            double ex = qx - px, ey = qy - py, e = Math.Sqrt(ex * ex + ey * ey);
            if (!(e > 0)) return;
            var along = (e * e + a * a - b * b) / (2 * e);
            var away = Math.Sqrt(Math.Max(0, a * a - along * along));
            // On the far side from v.
            double nx = ey / e, ny = -ex / e;
            if (nx * px + ny * py < 0) (nx, ny) = (-nx, -ny);
            double sx = px + ex / e * along + nx * away, sy = py + ey / e * along + ny * away;
            var acuteToP = sx >= 0;
            var acuteToQ = sx * wallX + sy * wallY >= 0;
            if (acuteToP && acuteToQ)
            {
                var toS = Math.Sqrt(sx * sx + sy * sy);
                if (double.IsInfinity(_distance[s])) return;
                Offer(v, _distance[s] + toS);
                if (!double.IsInfinity(_distance[p])) Offer(v, Front(toP, toS, Math.Sqrt((sx - toP) * (sx - toP) + sy * sy), _distance[p], _distance[s]));
                if (!double.IsInfinity(_distance[q]))
                    Offer(v, Front(toQ, toS, Math.Sqrt((sx - wallX) * (sx - wallX) + (sy - wallY) * (sy - wallY)), _distance[q], _distance[s]));
                return;
            }
            // On through the edge that the angle still holds.
            if (acuteToP) (right, qx, qy) = (s, sx, sy);
            else (left, px, py) = (s, sx, sy);
            half = HalfEdge(t, left, right);
        }
    }

    // Between two corners of a triangle: it begins at the corner after the third one.
    private int HalfEdge(int triangle, int p, int q)
    {
        var third = triangle;
        while (_corners[third] == p || _corners[third] == q) third++;
        return triangle + (third - triangle + 1) % 3;
    }
}
