namespace Caterpillar.Geometry;

/// <summary>
/// Segments that meet at end points only, as a graph with the winding numbers of both operands on both sides of every edge. One ray per connected component
/// gives the first winding number; the others follow by turning around the vertices, exactly.
/// </summary>
internal sealed class PlanarGraph
{
    public readonly VertexTable Vertices = new();

    /// <summary>Edge e goes from Tail[e] to Head[e]; equal and opposite segments are one edge.</summary>
    public int[] Tail = new int[256];
    public int[] Head = new int[256];
    public bool[] Dead = new bool[256];
    public int Edges;

    /// <summary>
    /// Around vertex v counterclockwise from due west: Half[HalfStart[v]] up to HalfStart[v + 1]; a half-edge is 2·edge, + 1 when v is the head.
    /// </summary>
    public int[] HalfStart = new int[257];
    public int[] Half = new int[512];

    // By how much the winding numbers on the left of an edge exceed those on the right, and those on the right.
    private int[] _firstStep = new int[256];
    private int[] _secondStep = new int[256];
    private int[] _firstRight = new int[256];
    private int[] _secondRight = new int[256];
    private bool[] _known = new bool[256];
    private bool[] _seen = new bool[256];
    private int[] _stack = new int[64];
    private int[] _fill = new int[256];
    private readonly HalfEdgeSorter _sorter = new();

    public int Other(int half) => (half & 1) == 0 ? Head[half >> 1] : Tail[half >> 1];

    /// <summary>+1 where the inside is left of the edge only, −1 where it is right of it only, else 0.</summary>
    public int Boundary(int edge, InsideRule rule)
    {
        if (Dead[edge]) return 0;
        var right = rule.Holds(_firstRight[edge], _secondRight[edge]);
        var left = rule.Holds(_firstRight[edge] + _firstStep[edge], _secondRight[edge] + _secondStep[edge]);
        return left == right ? 0 : left ? 1 : -1;
    }

    public void Build(Arrangement a)
    {
        Edges = a.Count;
        Reserve();
        Vertices.Clear(Edges);
        for (var c = 0; c < a.Contours; c++)
        {
            int start = a.ContourStart[c], end = a.ContourStart[c + 1];
            var first = a.Operand[c] == 0 ? 1 : 0;
            for (var i = start; i < end; i++)
            {
                var v = Vertices.Add(a.Segments[i].Ax, a.Segments[i].Ay);
                Tail[i] = v;
                if (i > start) Head[i - 1] = v;
                Dead[i] = false;
                _known[i] = false;
                _firstStep[i] = first;
                _secondStep[i] = 1 - first;
            }
            Head[end - 1] = Tail[start];
        }
        Link();
        for (var v = 0; v < Vertices.Count; v++) SortAndMerge(v);
        Array.Clear(_seen, 0, Vertices.Count);
        for (var v = 0; v < Vertices.Count; v++)
        {
            if (!_seen[v]) Spread(v, a);
        }
    }

    private void Reserve()
    {
        var n = Edges;
        Buffers.Reserve(ref Tail, n);
        Buffers.Reserve(ref Head, n);
        Buffers.Reserve(ref Dead, n);
        Buffers.Reserve(ref HalfStart, n + 1);
        Buffers.Reserve(ref Half, 2 * n);
        Buffers.Reserve(ref _firstStep, n);
        Buffers.Reserve(ref _secondStep, n);
        Buffers.Reserve(ref _firstRight, n);
        Buffers.Reserve(ref _secondRight, n);
        Buffers.Reserve(ref _known, n);
        Buffers.Reserve(ref _seen, n);
        Buffers.Reserve(ref _fill, n);
    }

    private void Link()
    {
        var n = Vertices.Count;
        Array.Clear(_fill, 0, n);
        for (var e = 0; e < Edges; e++)
        {
            _fill[Tail[e]]++;
            _fill[Head[e]]++;
        }
        var sum = 0;
        for (var v = 0; v < n; v++)
        {
            HalfStart[v] = sum;
            sum += _fill[v];
            _fill[v] = HalfStart[v];
        }
        HalfStart[n] = sum;
        for (var e = 0; e < Edges; e++)
        {
            Half[_fill[Tail[e]]++] = 2 * e;
            Half[_fill[Head[e]]++] = 2 * e + 1;
        }
    }

    private void SortAndMerge(int v)
    {
        int start = HalfStart[v], end = HalfStart[v + 1];
        // The order of two does not matter except at a vertex where a ray arrives; there it is sorted.
        if (end - start > 2) _sorter.Sort(this, v, start, end);
        for (var i = start; i < end; i++)
        {
            var h = Half[i];
            if (Dead[h >> 1]) continue;
            var target = Other(h);
            for (var k = i + 1; k < end && Other(Half[k]) == target; k++)
            {
                if (!Dead[Half[k] >> 1]) Merge(h, Half[k]);
            }
        }
    }

    private void Merge(int into, int half)
    {
        int e = into >> 1, f = half >> 1;
        var sign = (into & 1) == (half & 1) ? 1 : -1;
        _firstStep[e] += sign * _firstStep[f];
        _secondStep[e] += sign * _secondStep[f];
        Dead[f] = true;
    }

    private void Spread(int root, Arrangement a)
    {
        int start = HalfStart[root], end = HalfStart[root + 1];
        if (end - start == 2) _sorter.Sort(this, root, start, end);
        var p = Vertices.Points[root];
        a.Tree.Winding(a.Segments, a.Operand, p.X, p.Y, out var first, out var second);
        var depth = 0;
        _seen[root] = true;
        Turn(root, start, first, second, ref depth);
        while (depth > 0)
        {
            var half = _stack[--depth];
            var v = Other(half);
            if (_seen[v]) continue;
            _seen[v] = true;
            var position = HalfStart[v];
            while (Half[position] != (half ^ 1)) position++;
            // After (counterclockwise of) the half-edge that leads back is the area left of it: right of the edge if it is its head.
            var e = half >> 1;
            var forward = (half & 1) == 1;
            Turn(v, position + 1, _firstRight[e] + (forward ? _firstStep[e] : 0), _secondRight[e] + (forward ? _secondStep[e] : 0), ref depth);
        }
    }

    // Goes once around a vertex from a half-edge, with the winding numbers of the area just clockwise of it.
    private void Turn(int v, int from, int first, int second, ref int depth)
    {
        int start = HalfStart[v], end = HalfStart[v + 1], count = end - start;
        Buffers.Reserve(ref _stack, depth + count);
        for (int k = 0, i = from; k < count; k++, i++)
        {
            if (i >= end) i = start;
            var half = Half[i];
            var e = half >> 1;
            if (Dead[e]) continue;
            var sign = (half & 1) == 0 ? 1 : -1;
            if (!_known[e])
            {
                _known[e] = true;
                _firstRight[e] = sign > 0 ? first : first - _firstStep[e];
                _secondRight[e] = sign > 0 ? second : second - _secondStep[e];
                _stack[depth++] = half;
            }
            first += sign * _firstStep[e];
            second += sign * _secondStep[e];
        }
    }
}
