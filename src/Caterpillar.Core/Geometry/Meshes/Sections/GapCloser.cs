namespace Caterpillar.Geometry;

/// <summary>
/// Joins open contours to closed ones. Ends at the same place are joined first; then the nearest ends, within distances that grow fourfold up to the
/// largest gap: an end to a beginning, and only when those are four times as far away an end to an end (a part that is turned inside out; the shorter one
/// is turned round). A contour closes on itself while others are still joined only where it is at least twice as long as the gap, so that a fragment does
/// not curl up. After each round no two ends of different contours are that near, so the number of pairs stays in proportion to the number of ends.
/// </summary>
internal sealed class GapCloser(List<Polyline> lines, double gap)
{
    private const double FirstReach = 1e-6;
    private const double Growth = 4;

    // Line i begins at node 2i and ends at node 2i + 1.
    private readonly int[] _mate = Enumerable.Repeat(-1, 2 * lines.Count).ToArray();
    private readonly DisjointSets _chains = new(lines.Count);
    private readonly double[] _length = lines.Select(l => l.Length).ToArray();
    private readonly List<int> _free = [.. Enumerable.Range(0, 2 * lines.Count)];
    private readonly List<(double Distance, int A, int B)> _pairs = [];
    private readonly Dictionary<(long, long), int> _cells = [];
    private readonly int[] _nextInCell = new int[2 * lines.Count];
    private int _closed;
    private double _sum;
    private double _widest;

    /// <summary>Joins lines where possible: closed contours are added to the loops, the rest stays in <paramref name="open"/>.</summary>
    public static ClosedGaps Close(List<Polyline> open, List<Polyline> loops, double gap)
    {
        if (open.Count == 0 || !(gap >= 0)) return default;
        var closer = new GapCloser(open, gap);
        closer.JoinEqualEnds();
        // Parts that are turned inside out are joined within a quarter of the reach, so two more rounds bring them to the full gap.
        for (var reach = FirstReach; gap > 0 && closer._free.Count > 0 && reach < gap * Growth * Growth; reach *= Growth) closer.JoinWithin(reach);
        closer.CloseTheRest();
        closer.Assemble(loops);
        return new ClosedGaps(closer._closed, closer._sum, closer._widest);
    }

    private Vec3 Position(int node) => lines[node >> 1][(node & 1) == 0 ? 0 : lines[node >> 1].Count - 1];

    // Ends at exactly the same place: beginnings meet ends in their order, what is left over meets its like.
    private void JoinEqualEnds()
    {
        var order = _free.ToArray();
        Array.Sort(order, (a, b) =>
        {
            Vec3 p = Position(a), q = Position(b);
            return p.X != q.X ? p.X.CompareTo(q.X) : p.Y != q.Y ? p.Y.CompareTo(q.Y) : a.CompareTo(b);
        });
        for (int from = 0, to; from < order.Length; from = to)
        {
            var place = Position(order[from]);
            for (to = from + 1; to < order.Length && Position(order[to]) == place; to++)
            {
            }
            if (to - from < 2) continue;
            foreach (var turning in new[] { false, true })
            {
                int begin = from, end = from;
                while (true)
                {
                    // The next free pair: one pointer for each side, so a heap of ends at one place takes linear time.
                    while (begin < to && (_mate[order[begin]] >= 0 || (!turning && (order[begin] & 1) != 0))) begin++;
                    end = turning ? begin + 1 : end;
                    while (end < to && (_mate[order[end]] >= 0 || (!turning && (order[end] & 1) == 0))) end++;
                    if (begin >= to || end >= to) break;
                    if (!Join(order[begin], order[end], 0, false)) end++;
                    else if (turning) begin = end;
                }
            }
        }
        DropJoined();
    }

    private void JoinWithin(double reach)
    {
        FindPairs(Math.Min(reach, gap));
        foreach (var turning in new[] { false, true })
        {
            foreach (var (distance, a, b) in _pairs)
            {
                if (((a ^ b) & 1) == 0 == turning && (!turning || distance <= reach / Growth)) Join(a, b, distance, false);
            }
        }
        DropJoined();
    }

    private void CloseTheRest()
    {
        foreach (var node in _free)
        {
            if (_mate[node] >= 0) continue;
            var other = OtherEnd(node);
            var distance = Position(node).DistanceTo(Position(other));
            if (distance <= gap && _length[_chains.Of(node >> 1)] > 1.05 * distance) Join(node, other, distance, true);
        }
    }

    private int OtherEnd(int node)
    {
        var end = node ^ 1;
        while (_mate[end] >= 0) end = _mate[end] ^ 1;
        return end;
    }

    private bool Join(int a, int b, double distance, bool closeShort)
    {
        if (_mate[a] >= 0 || _mate[b] >= 0) return false;
        var (ca, cb) = (_chains.Of(a >> 1), _chains.Of(b >> 1));
        if (ca == cb && !closeShort && _length[ca] < 2 * distance) return false;
        _mate[a] = b;
        _mate[b] = a;
        if (ca != cb)
        {
            _chains.Join(ca, cb);
            _length[_chains.Of(ca)] = _length[ca] + distance + _length[cb];
        }
        _closed++;
        _sum += distance;
        _widest = Math.Max(_widest, distance);
        return true;
    }

    private void DropJoined() => _free.RemoveAll(node => _mate[node] >= 0);

    // All pairs of free ends within the reach, nearest first, ties by the order of the lines.
    private void FindPairs(double reach)
    {
        _cells.Clear();
        _pairs.Clear();
        foreach (var node in _free)
        {
            var p = Position(node);
            var (x, y) = ((long)Math.Floor(p.X / reach), (long)Math.Floor(p.Y / reach));
            for (var i = 0; i < 9; i++)
            {
                if (!_cells.TryGetValue((x + i % 3 - 1, y + i / 3 - 1), out var other)) continue;
                for (; other >= 0; other = _nextInCell[other])
                {
                    var distance = p.DistanceTo(Position(other));
                    if (distance <= reach) _pairs.Add((distance, other, node));
                }
            }
            _nextInCell[node] = _cells.TryGetValue((x, y), out var first) ? first : -1;
            _cells[(x, y)] = node;
        }
        _pairs.Sort((p, q) => p.Distance != q.Distance ? p.Distance.CompareTo(q.Distance) : p.A != q.A ? p.A.CompareTo(q.A) : p.B.CompareTo(q.B));
    }

    private void Assemble(List<Polyline> loops)
    {
        var used = new bool[lines.Count];
        var open = new List<Polyline>();
        // Open chains first, from either end; what is left is closed.
        for (var node = 0; node < _mate.Length; node++)
        {
            if (_mate[node] < 0 && !used[node >> 1]) open.Add(Trace(node, used, false)!);
        }
        for (var line = 0; line < used.Length; line++)
        {
            if (!used[line] && Trace(2 * line, used, true) is { } loop) loops.Add(loop);
        }
        lines.Clear();
        lines.AddRange(open);
    }

    private Polyline? Trace(int start, bool[] used, bool closed)
    {
        var points = new List<Vec3>();
        double along = 0, against = 0;
        for (var node = start; node >= 0 && !used[node >> 1]; node = _mate[node ^ 1])
        {
            var line = lines[node >> 1];
            used[node >> 1] = true;
            var forward = (node & 1) == 0;
            if (forward) along += line.Length;
            else against += line.Length;
            for (var i = 0; i < line.Count; i++)
            {
                var p = line[forward ? i : line.Count - 1 - i];
                if (points.Count == 0 || points[points.Count - 1] != p) points.Add(p);
            }
        }
        if (against > along) points.Reverse();
        var array = points.ToArray();
        if (!closed) return Polyline.Own(array, false);
        var count = array.Length;
        var first = PolylineCleaning.DropSpikes(array, ref count);
        return count < 3 ? null : PolylineCleaning.ToPolyline(array, count, true, first);
    }
}
