namespace Caterpillar.Geometry;

/// <summary>
/// For each of some ascending heights the triangles that its plane cuts, in ascending order: a counting sort over the z ranges of the triangles. A
/// vertex at or above the plane is above, so a triangle is cut where lowest vertex &lt; plane ≤ highest vertex.
/// </summary>
internal sealed class LayerBuckets
{
    private readonly double[] _heights;
    private readonly double _scale;
    private readonly int[] _first;
    private readonly int[] _last;

    public LayerBuckets(TriMesh mesh, double[] ascending)
    {
        _heights = ascending;
        var n = ascending.Length;
        var span = n > 1 ? ascending[n - 1] - ascending[0] : 0;
        _scale = span > 0 ? (n - 1) / span : 0;
        if (double.IsInfinity(_scale)) _scale = 0;
        Counts = new long[n];
        _first = new int[mesh.TriangleCount];
        _last = new int[mesh.TriangleCount];
        Measure(mesh);
    }

    /// <summary>Number of cut triangles for each height.</summary>
    public long[] Counts { get; }

    /// <summary>Triangles of the heights from <paramref name="from"/> up to <paramref name="to"/>, one height after the other.</summary>
    public int[] Fill(int from, int to)
    {
        long all = 0;
        var next = new int[to - from];
        for (var i = from; i < to; i++)
        {
            next[i - from] = (int)all;
            all += Counts[i];
        }
        var triangles = new int[all];
        for (var t = 0; t < _first.Length; t++)
        {
            var last = Math.Min(_last[t], to);
            for (var layer = Math.Max(_first[t], from); layer < last; layer++) triangles[next[layer - from]++] = t;
        }
        return triangles;
    }

    private void Measure(TriMesh mesh)
    {
        var vertices = mesh.RawVertices;
        var triangles = mesh.RawTriangles;
        var above = new int[vertices.Length];
        for (var v = 0; v < above.Length; v++) above[v] = AtOrBelow(vertices[v].Z);
        var steps = new long[_heights.Length + 1];
        for (var t = 0; t < _first.Length; t++)
        {
            int a = above[triangles[3 * t]], b = above[triangles[3 * t + 1]], c = above[triangles[3 * t + 2]];
            var low = a < b ? a : b;
            var high = a < b ? b : a;
            if (c < low) low = c;
            if (c > high) high = c;
            _first[t] = low;
            _last[t] = high;
            steps[low]++;
            steps[high]--;
        }
        long sum = 0;
        for (var i = 0; i < Counts.Length; i++) Counts[i] = sum += steps[i];
    }

    // How many heights are at or below z: for those the vertex is above the plane.
    private int AtOrBelow(double z)
    {
        var n = _heights.Length;
        if (z < _heights[0]) return 0;
        if (z >= _heights[n - 1]) return n;
        var at = Math.Min(n - 1, (int)((z - _heights[0]) * _scale) + 1);
        for (var tries = 0; tries < 4; tries++)
        {
            if (_heights[at - 1] > z) at--;
            else if (_heights[at] <= z) at++;
            else return at;
        }
        return Search.First(1, n - 1, (_heights, z), static (s, i) => s._heights[i] > s.z);
    }
}
