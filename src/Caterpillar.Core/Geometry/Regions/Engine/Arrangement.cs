namespace Caterpillar.Geometry;

/// <summary>
/// Closed contours on the grid, cut at their crossings until segments meet at end points only. A crossing is rounded to the grid, which moves its two segments
/// slightly and may cause new crossings: those are searched for again, among the segments that moved, until there are none. It terminates, because every cut
/// leaves the length |dx| + |dy| of a contour as it is and no segment is shorter than 1 (after Hobby, "Practical segment intersection with finite precision
/// output", 1999).
/// </summary>
internal sealed class Arrangement
{
    // After this many rounds of cutting at crossings only, segments are also drawn to all points (vertices and new crossings) whose unit square they pass
    // through. Otherwise bundles of almost parallel lines would move by one unit in each of hundreds of rounds.
    private const int ExactRounds = 2;

    // After this many rounds, all segments are tested, not only those that moved: full snap rounding, which leaves no crossings.
    private const int LocalRounds = 6;

    // Rounded in double, a crossing may be off by one unit, so the proof of snap rounding does not quite apply.
    private const int MaxRounds = 64;

    public Segment[] Segments = new Segment[256];
    public int Count;
    public int[] ContourStart = new int[16];
    public byte[] Operand = new byte[16];

    /// <summary>Index of the call of <see cref="Add"/> that added a contour.</summary>
    public int[] Source = new int[16];
    public int Contours;
    public readonly BoxTree Tree = new();

    /// <summary>True if segments that do not follow each other in a contour share an end point.</summary>
    public bool Touches;

    /// <summary>True if any segment was cut.</summary>
    public bool Cut;

    /// <summary>
    /// In half units: how far from a segment a vertex may be to be snapped to. 1 (the segment passes through the vertex's unit square) happens only where
    /// needed; more, from the first round on: for contours whose vertices were on others' edges before they were rounded. Set after <see cref="Clear"/>.
    /// </summary>
    public int Reach = 1;

    /// <summary>Number of rounds of the last resolution.</summary>
    public int Rounds;

    private int _added;
    private bool _snapping;
    private bool _drawing;
    private bool _conflict;
    private bool[] _fresh = new bool[256];
    private readonly SegmentSplitter _splitter = new();
    private readonly ContourOrder _order = new();

    public void Clear()
    {
        _added = 0;
        Reach = 1;
        Count = 0;
        Contours = 0;
        ContourStart[0] = 0;
    }

    /// <summary>Adds a closed contour; equal consecutive points are merged, fewer than two different points add nothing.</summary>
    public void Add(GridPoint[] points, int start, int count, byte operand)
    {
        var source = _added++;
        if (count < 2) return;
        Buffers.Reserve(ref Segments, Count + count);
        Buffers.Reserve(ref ContourStart, Contours + 2);
        Buffers.Reserve(ref Operand, Contours + 1);
        Buffers.Reserve(ref Source, Contours + 1);
        var n = Count;
        var a = points[start + count - 1];
        for (var i = start; i < start + count; i++)
        {
            var b = points[i];
            if (a == b) continue;
            Segments[n++] = new Segment(a, b);
            a = b;
        }
        if (n < Count + 2) return;
        Count = n;
        Source[Contours] = source;
        Operand[Contours++] = operand;
        ContourStart[Contours] = n;
    }

    /// <summary>Cuts until no segments cross, touch from the side or partly overlap. Segments that are equal or opposite remain.</summary>
    public void Resolve()
    {
        if (Contours > 8) _order.Apply(ref Segments, ref ContourStart, ref Operand, ref Source, Contours);
        Touches = false;
        Cut = false;
        SetFresh();
        for (var round = 0; ; round++)
        {
            _drawing = Reach > 1 && round < ExactRounds;
            _snapping = _drawing || round >= ExactRounds;
            if (round >= LocalRounds) SetFresh();
            _conflict = false;
            Rounds = round;
            Tree.Build(Segments, _fresh, ContourStart, Contours);
            if (Tree.Levels == 0) return;
            _splitter.Clear(Count);
            Self(Tree.Levels - 1, 0);
            if (!_conflict || round == MaxRounds) return;
            Cut = true;
            if (round >= ExactRounds) SnapToCuts();
            Count = _splitter.Apply(ref Segments, ref _fresh, Count, ContourStart, Contours);
        }
    }

    private void SetFresh()
    {
        if (_fresh.Length < Count) _fresh = new bool[Segments.Length];
        for (var i = 0; i < Count; i++) _fresh[i] = true;
    }

    private void SnapToCuts()
    {
        var count = _splitter.Count;
        for (var k = 0; k < count; k++) SnapAll(_splitter.Point(k), Tree.Levels - 1, 0);
    }

    private void SnapAll(GridPoint p, int level, int node)
    {
        ref readonly var box = ref Tree.Boxes[Tree.LevelStart[level] + node];
        if (p.X < box.MinX || p.X > box.MaxX || p.Y < box.MinY || p.Y > box.MaxY) return;
        if (level > 0)
        {
            SnapAll(p, level - 1, 2 * node);
            if (2 * node + 1 < Tree.LevelCount[level - 1]) SnapAll(p, level - 1, 2 * node + 1);
            return;
        }
        for (var i = Tree.LeafStart[node]; i < Tree.LeafStart[node + 1]; i++) Snap(i, Segments[i], p.X, p.Y);
    }

    private void Self(int level, int node)
    {
        if (!Tree.Fresh[Tree.LevelStart[level] + node] || Tree.Monotone[Tree.LevelStart[level] + node] != 0) return;
        if (level == 0)
        {
            var (end, contour) = (Tree.LeafStart[node + 1], Tree.LeafContour[node]);
            for (var i = Tree.LeafStart[node]; i < end; i++) TestAll(i, GridBox.Of(Segments[i]), i + 1, end, contour, contour);
            return;
        }
        var left = 2 * node;
        Self(level - 1, left);
        if (left + 1 >= Tree.LevelCount[level - 1]) return;
        Self(level - 1, left + 1);
        Pair(level - 1, left, left + 1);
    }

    private void Pair(int level, int m, int n)
    {
        var start = Tree.LevelStart[level];
        if (!GridBox.Overlap(Tree.Boxes[start + m], Tree.Boxes[start + n]) || !(Tree.Fresh[start + m] | Tree.Fresh[start + n])) return;
        if (level == 0)
        {
            PairOfLeaves(m, n);
            return;
        }
        var count = Tree.LevelCount[level - 1];
        var second = 2 * m + 1 < count;
        Pair(level - 1, 2 * m, 2 * n);
        if (second) Pair(level - 1, 2 * m + 1, 2 * n);
        if (2 * n + 1 >= count) return;
        Pair(level - 1, 2 * m, 2 * n + 1);
        if (second) Pair(level - 1, 2 * m + 1, 2 * n + 1);
    }

    private void PairOfLeaves(int m, int n)
    {
        ref readonly var other = ref Tree.Boxes[n];
        var (start, end) = (Tree.LeafStart[n], Tree.LeafStart[n + 1]);
        for (var i = Tree.LeafStart[m]; i < Tree.LeafStart[m + 1]; i++)
        {
            var box = GridBox.Of(Segments[i]);
            if (GridBox.Overlap(box, other)) TestAll(i, box, start, end, Tree.LeafContour[m], Tree.LeafContour[n]);
        }
    }

    // A segment against a run of others, most of which are beside its box.
    private void TestAll(int i, in GridBox box, int from, int end, int contourI, int contourJ)
    {
        var segments = Segments;
        var (minX, minY, maxX, maxY) = (box.MinX, box.MinY, box.MaxX, box.MaxY);
        for (var j = from; j < end; j++)
        {
            ref readonly var t = ref segments[j];
            if (((t.Ax < minX) & (t.Bx < minX)) | ((t.Ax > maxX) & (t.Bx > maxX))
                || ((t.Ay < minY) & (t.By < minY)) | ((t.Ay > maxY) & (t.By > maxY))) continue;
            if (_fresh[i] | _fresh[j]) Test(i, j, contourI, contourJ);
        }
    }

    private void Test(int i, int j, int contourI, int contourJ)
    {
        ref readonly var s = ref Segments[i];
        ref readonly var t = ref Segments[j];
        bool aa = s.Ax == t.Ax && s.Ay == t.Ay, ab = s.Ax == t.Bx && s.Ay == t.By;
        bool ba = s.Bx == t.Ax && s.By == t.Ay, bb = s.Bx == t.Bx && s.By == t.By;
        if (aa | ab | ba | bb)
        {
            if ((aa & bb) | (ab & ba))
            {
                Touches = true;
                return;
            }
            var start = ContourStart[contourI];
            var follow = contourI == contourJ && (j == i + 1 || (i == start && j == ContourStart[contourI + 1] - 1));
            if (!follow) Touches = true;
            if (_snapping)
            {
                if (!aa && !ba) Snap(i, s, t.Ax, t.Ay);
                if (!ab && !bb) Snap(i, s, t.Bx, t.By);
                if (!aa && !ab) Snap(j, t, s.Ax, s.Ay);
                if (!ba && !bb) Snap(j, t, s.Bx, s.By);
            }
            CommonEnd(i, j, aa || ab ? s.A : s.B, aa || ab ? s.B : s.A, aa || ba ? t.B : t.A);
            return;
        }
        if (_snapping)
        {
            Snap(i, s, t.Ax, t.Ay);
            Snap(i, s, t.Bx, t.By);
            Snap(j, t, s.Ax, s.Ay);
            Snap(j, t, s.Bx, s.By);
        }
        var c = s.Side(t.Ax, t.Ay);
        var d = s.Side(t.Bx, t.By);
        if ((c > 0 && d > 0) || (c < 0 && d < 0)) return;
        var a = t.Side(s.Ax, s.Ay);
        var b = t.Side(s.Bx, s.By);
        if ((a > 0 && b > 0) || (a < 0 && b < 0)) return;
        if (a != 0 && b != 0 && c != 0 && d != 0)
        {
            Crossing(i, j, a, b);
            return;
        }
        if (c == 0 && Within(s, t.Ax, t.Ay)) CutAt(i, t.Ax, t.Ay);
        if (d == 0 && Within(s, t.Bx, t.By)) CutAt(i, t.Bx, t.By);
        if (a == 0 && Within(t, s.Ax, s.Ay)) CutAt(j, s.Ax, s.Ay);
        if (b == 0 && Within(t, s.Bx, s.By)) CutAt(j, s.Bx, s.By);
    }

    private void CutAt(int i, int x, int y)
    {
        if (_splitter.Add(i, x, y, Segments[i])) _conflict = true;
    }

    // Cuts a segment that passes through the unit square around a point of the grid (a hot pixel) at that point.
    private void Snap(int i, in Segment s, int x, int y)
    {
        var reach = Math.Abs((long)s.Bx - s.Ax) + Math.Abs((long)s.By - s.Ay);
        if (Within(s, x, y) && 2 * Math.Abs(s.Side(x, y)) <= (_drawing ? Reach * reach : reach) && _splitter.Add(i, x, y, s) && _drawing) _conflict = true;
    }

    // Two segments from one point to u and v: they overlap when the directions are the same.
    private void CommonEnd(int i, int j, GridPoint common, GridPoint u, GridPoint v)
    {
        if (Grid.Cross(common, u, v) != 0) return;
        long ux = (long)u.X - common.X, uy = (long)u.Y - common.Y, vx = (long)v.X - common.X, vy = (long)v.Y - common.Y;
        if (ux * vx + uy * vy <= 0) return;
        if (Math.Abs(ux) + Math.Abs(uy) < Math.Abs(vx) + Math.Abs(vy)) CutAt(j, u.X, u.Y);
        else CutAt(i, v.X, v.Y);
    }

    private void Crossing(int i, int j, long a, long b)
    {
        ref readonly var s = ref Segments[i];
        ref readonly var t = ref Segments[j];
        var share = (double)a / (a - b);
        var x = Grid.Round(s.Ax + share * ((double)s.Bx - s.Ax));
        var y = Grid.Round(s.Ay + share * ((double)s.By - s.Ay));
        x = Clamp(Clamp(x, s.Ax, s.Bx), t.Ax, t.Bx);
        y = Clamp(Clamp(y, s.Ay, s.By), t.Ay, t.By);
        CutAt(i, x, y);
        CutAt(j, x, y);
    }

    private static int Clamp(int value, int p, int q) => p < q ? Math.Min(Math.Max(value, p), q) : Math.Min(Math.Max(value, q), p);

    // In the box of a segment.
    private static bool Within(in Segment s, int x, int y)
        => x >= Math.Min(s.Ax, s.Bx) && x <= Math.Max(s.Ax, s.Bx) && y >= Math.Min(s.Ay, s.By) && y <= Math.Max(s.Ay, s.By);
}
