namespace Caterpillar.Geometry;

/// <summary>Collects the points at which segments have to be cut, and cuts them all at once in the order along each segment.</summary>
internal sealed class SegmentSplitter
{
    private int[] _head = new int[256];
    private int[] _next = new int[64];
    private GridPoint[] _points = new GridPoint[64];
    private long[] _keys = new long[16];
    private GridPoint[] _sorted = new GridPoint[16];
    private Segment[] _spare = new Segment[256];
    private bool[] _spareFresh = new bool[256];

    public int Count { get; private set; }

    public void Clear(int segments)
    {
        Buffers.Reserve(ref _head, segments);
        Array.Clear(_head, 0, segments);
        Count = 0;
    }

    public GridPoint Point(int k) => _points[k];

    /// <summary>Cuts a segment at a point in its box; false at its end points, where there is nothing to cut.</summary>
    public bool Add(int segment, int x, int y, in Segment s)
    {
        if ((x == s.Ax && y == s.Ay) || (x == s.Bx && y == s.By)) return false;
        Buffers.Reserve(ref _points, Count + 1);
        Buffers.Reserve(ref _next, Count + 1);
        _points[Count] = new GridPoint(x, y);
        _next[Count++] = _head[segment];
        _head[segment] = Count;
        return true;
    }

    /// <summary>Cuts. Returns the new number of segments and moves the contours' starts; only the parts of cut segments are fresh.</summary>
    public int Apply(ref Segment[] segments, ref bool[] fresh, int count, int[] contourStart, int contours)
    {
        Buffers.Reserve(ref _spare, count + Count);
        Buffers.Reserve(ref _spareFresh, _spare.Length);
        var n = 0;
        var i = 0;
        for (var c = 0; c < contours; c++)
        {
            var end = contourStart[c + 1];
            for (; i < end; i++)
            {
                if (_head[i] == 0)
                {
                    _spareFresh[n] = false;
                    _spare[n++] = segments[i];
                }
                else
                {
                    n = Parts(segments[i], _head[i], n);
                }
            }
            contourStart[c + 1] = n;
        }
        (segments, _spare) = (_spare, segments);
        (fresh, _spareFresh) = (_spareFresh, fresh);
        return n;
    }

    private void Sort(int count)
    {
        if (count > 24)
        {
            Array.Sort(_keys, _sorted, 0, count);
            return;
        }
        for (var i = 1; i < count; i++)
        {
            var key = _keys[i];
            var p = _sorted[i];
            var k = i;
            for (; k > 0 && _keys[k - 1] > key; k--)
            {
                _keys[k] = _keys[k - 1];
                _sorted[k] = _sorted[k - 1];
            }
            _keys[k] = key;
            _sorted[k] = p;
        }
    }

    private int Parts(in Segment s, int head, int n)
    {
        long dx = (long)s.Bx - s.Ax, dy = (long)s.By - s.Ay;
        var count = 0;
        for (var r = head; r != 0; r = _next[r - 1])
        {
            Buffers.Reserve(ref _keys, count + 1);
            Buffers.Reserve(ref _sorted, count + 1);
            var p = _points[r - 1];
            _keys[count] = dx * ((long)p.X - s.Ax) + dy * ((long)p.Y - s.Ay);
            _sorted[count++] = p;
        }
        Sort(count);
        var a = s.A;
        for (var k = 0; k < count; k++)
        {
            // Rounding keeps the order along both axes; where the double that was rounded was off, the point is pushed back into the order.
            var p = _sorted[k];
            var x = (dx >= 0 ? p.X < a.X : p.X > a.X) ? a.X : p.X;
            var y = (dy >= 0 ? p.Y < a.Y : p.Y > a.Y) ? a.Y : p.Y;
            var b = new GridPoint(x, y);
            if (b == a || b == s.B) continue;
            _spareFresh[n] = true;
            _spare[n++] = new Segment(a, b);
            a = b;
        }
        _spareFresh[n] = true;
        _spare[n++] = new Segment(a, s.B);
        return n;
    }
}
