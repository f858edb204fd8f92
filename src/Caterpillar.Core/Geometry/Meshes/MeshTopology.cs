namespace Caterpillar.Geometry;

/// <summary>
/// The triangles of a mesh that meet along each edge. Half-edge 3·t + k runs from corner k of triangle t to the next corner; its partner is the
/// half-edge of the neighbor in the opposite direction. Built by a counting sort over the lower vertex of every edge.
/// </summary>
internal sealed class MeshTopology
{
    private const int VerticesPerPiece = 16_384;
    private const int MostPieces = 8;
    private readonly int[] _triangles;

    public MeshTopology(Vec3[] vertices, int[] triangles)
    {
        _triangles = triangles;
        Partner = new int[triangles.Length];
        var (starts, keys) = Bucket(vertices.Length, triangles);
        // The edges of different vertices have nothing in common.
        var pieces = Math.Max(1, Math.Min(MostPieces, vertices.Length / VerticesPerPiece));
        var counts = new EdgeCounts[pieces];
        void PairPiece(int piece)
        {
            int first = (int)((long)vertices.Length * piece / pieces), last = (int)((long)vertices.Length * (piece + 1) / pieces);
            var count = new EdgeCounts();
            for (var v = first; v < last; v++) PairEdges(vertices, keys, starts[v], starts[v + 1], ref count);
            counts[piece] = count;
        }
        if (pieces == 1) PairPiece(0);
        else Parallel.For(0, pieces, PairPiece);
        foreach (var count in counts)
        {
            OpenEdges += count.Open;
            NonManifoldEdges += count.NonManifold;
            WindingConflicts += count.Conflicts;
            IsPaired &= !count.HasUnpaired;
        }
    }

    /// <summary>The opposite half-edge in the neighboring triangle, −1 if there is none.</summary>
    public int[] Partner { get; }

    /// <summary>Edges with one triangle.</summary>
    public int OpenEdges { get; private set; }

    /// <summary>Edges with more than two triangles.</summary>
    public int NonManifoldEdges { get; private set; }

    /// <summary>Edges whose two triangles run along them in the same direction.</summary>
    public int WindingConflicts { get; private set; }

    public bool IsWatertight => OpenEdges == 0 && NonManifoldEdges == 0 && WindingConflicts == 0;

    /// <summary>True if every half-edge has a partner: then every section consists of closed loops.</summary>
    public bool IsPaired { get; private set; } = true;

    // Half-edges by their lower vertex, each as (higher vertex, half-edge).
    private static (int[] Starts, long[] Keys) Bucket(int vertices, int[] triangles)
    {
        var starts = new int[vertices + 1];
        for (var t = 0; t < triangles.Length; t += 3)
        {
            int a = triangles[t], b = triangles[t + 1], c = triangles[t + 2];
            starts[a < b ? a : b]++;
            starts[b < c ? b : c]++;
            starts[c < a ? c : a]++;
        }
        var sum = 0;
        for (var v = 0; v <= vertices; v++) sum += starts[v];
        for (var v = vertices; v >= 0; v--)
        {
            sum -= starts[v];
            starts[v] = sum;
        }
        var keys = new long[triangles.Length];
        var next = (int[])starts.Clone();
        for (var t = 0; t < triangles.Length; t += 3)
        {
            int a = triangles[t], b = triangles[t + 1], c = triangles[t + 2];
            if (a < b) keys[next[a]++] = (long)b << 32 | (uint)t;
            else keys[next[b]++] = (long)a << 32 | (uint)t;
            if (b < c) keys[next[b]++] = (long)c << 32 | (uint)(t + 1);
            else keys[next[c]++] = (long)b << 32 | (uint)(t + 1);
            if (c < a) keys[next[c]++] = (long)a << 32 | (uint)(t + 2);
            else keys[next[a]++] = (long)c << 32 | (uint)(t + 2);
        }
        return (starts, keys);
    }

    /// <summary>
    /// All half-edges (low word of a key) sorted by their edge; true in <paramref name="sameAsBefore"/> where one lies on the same edge as the one before it.
    /// </summary>
    public static (int[] Starts, long[] Keys) SortedEdges(int vertices, int[] triangles, out bool[] sameAsBefore)
    {
        var (starts, keys) = Bucket(vertices, triangles);
        sameAsBefore = new bool[keys.Length];
        for (var v = 0; v < vertices; v++)
        {
            Sort(keys, starts[v], starts[v + 1]);
            for (var i = starts[v] + 1; i < starts[v + 1]; i++) sameAsBefore[i] = keys[i] >> 32 == keys[i - 1] >> 32;
        }
        return (starts, keys);
    }

    private static void Sort(long[] keys, int from, int to)
    {
        if (to - from > 40)
        {
            Array.Sort(keys, from, to - from);
            return;
        }
        for (var i = from + 1; i < to; i++)
        {
            var key = keys[i];
            var j = i;
            for (; j > from && keys[j - 1] > key; j--) keys[j] = keys[j - 1];
            keys[j] = key;
        }
    }

    // The edges from one vertex to higher ones.
    private void PairEdges(Vec3[] vertices, long[] keys, int from, int to, ref EdgeCounts count)
    {
        if (to == from) return;
        Sort(keys, from, to);
        for (int i = from, end; i < to; i = end)
        {
            end = i + 1;
            while (end < to && keys[end] >> 32 == keys[i] >> 32) end++;
            Pair(vertices, keys, i, end, ref count);
        }
    }

    private void Pair(Vec3[] vertices, long[] keys, int from, int to, ref EdgeCounts count)
    {
        var first = (int)keys[from];
        if (to - from == 1)
        {
            Partner[first] = -1;
            count.Open++;
            count.HasUnpaired = true;
            return;
        }
        if (to - from == 2)
        {
            var second = (int)keys[from + 1];
            if (IsForward(first) != IsForward(second))
            {
                Partner[first] = second;
                Partner[second] = first;
                return;
            }
            Partner[first] = Partner[second] = -1;
            count.Conflicts++;
            count.HasUnpaired = true;
            return;
        }
        count.NonManifold++;
        if (!RadialPairing.Pair(vertices, _triangles, keys, from, to, Partner)) count.HasUnpaired = true;
    }

    private bool IsForward(int halfEdge) => _triangles[halfEdge] < _triangles[Next(halfEdge)];

    public static int Next(int halfEdge) => halfEdge % 3 == 2 ? halfEdge - 2 : halfEdge + 1;

    private struct EdgeCounts
    {
        public int Open, NonManifold, Conflicts;
        public bool HasUnpaired;
    }
}
