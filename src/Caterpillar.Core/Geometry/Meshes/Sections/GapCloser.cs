using System;
using System.Collections.Generic;

namespace Caterpillar.Geometry;

/// <summary>
/// Joins open contours whose ends lie within a distance: first ends to beginnings; then, where surfaces are turned inside out, ends to ends and
/// beginnings to beginnings (the part with the smaller length is turned round). The nearest pair goes first, ties by the order of the lines. A line
/// closes on itself only where it is at least twice as long as the gap.
/// </summary>
internal sealed class GapCloser
{
    private readonly List<Polyline> _lines;
    private readonly double _gap;

    // Line i begins at node 2i and ends at node 2i + 1.
    private readonly int[] _mate;
    private readonly int[] _chain;
    private readonly double[] _length;

    private GapCloser(List<Polyline> lines, double gap)
    {
        _lines = lines;
        _gap = gap;
        _mate = new int[2 * lines.Count];
        _chain = new int[lines.Count];
        _length = new double[lines.Count];
        for (var i = 0; i < lines.Count; i++)
        {
            _mate[2 * i] = _mate[2 * i + 1] = -1;
            _chain[i] = i;
            _length[i] = lines[i].Length;
        }
    }

    /// <summary>
    /// Joins what can be joined: closed contours are added to the loops, the rest stays in <paramref name="open"/>. Returns how many gaps were
    /// closed and the widest in mm.
    /// </summary>
    public static (int Closed, double Widest) Close(List<Polyline> open, List<Polyline> loops, double gap)
    {
        if (open.Count == 0 || !(gap > 0)) return (0, 0);
        var closer = new GapCloser(open, gap);
        var (closed, widest) = closer.Match();
        if (closed == 0) return (0, 0);
        closer.Assemble(loops);
        return (closed, widest);
    }

    private Vec3 Position(int node) => _lines[node >> 1][(node & 1) == 0 ? 0 : _lines[node >> 1].Count - 1];

    private (int Closed, double Widest) Match()
    {
        var pairs = Candidates();
        var closed = 0;
        var widest = 0.0;
        foreach (var turning in new[] { false, true })
        {
            foreach (var (distance, a, b) in pairs)
            {
                if (((a ^ b) & 1) == 0 != turning || _mate[a] >= 0 || _mate[b] >= 0) continue;
                var (ca, cb) = (Root(a >> 1), Root(b >> 1));
                if (ca == cb && _length[ca] < 2 * distance) continue;
                _mate[a] = b;
                _mate[b] = a;
                if (ca != cb)
                {
                    _chain[Math.Max(ca, cb)] = Math.Min(ca, cb);
                    _length[Math.Min(ca, cb)] = _length[ca] + distance + _length[cb];
                }
                closed++;
                widest = Math.Max(widest, distance);
            }
        }
        return (closed, widest);
    }

    // All pairs of ends within the gap, nearest first.
    private List<(double Distance, int A, int B)> Candidates()
    {
        var size = Math.Max(_gap, 1e-6);
        var cells = new Dictionary<(long, long), List<int>>();
        var pairs = new List<(double Distance, int A, int B)>();
        for (var node = 0; node < _mate.Length; node++)
        {
            var p = Position(node);
            var (x, y) = ((long)Math.Floor(p.X / size), (long)Math.Floor(p.Y / size));
            for (var i = 0; i < 9; i++)
            {
                if (!cells.TryGetValue((x + i % 3 - 1, y + i / 3 - 1), out var others)) continue;
                foreach (var other in others)
                {
                    var distance = p.DistanceTo(Position(other));
                    if (distance <= _gap) pairs.Add((distance, other, node));
                }
            }
            if (!cells.TryGetValue((x, y), out var list)) cells.Add((x, y), list = []);
            list.Add(node);
        }
        pairs.Sort((p, q) => p.Distance != q.Distance ? p.Distance.CompareTo(q.Distance) : p.A != q.A ? p.A.CompareTo(q.A) : p.B.CompareTo(q.B));
        return pairs;
    }

    private int Root(int line)
    {
        while (_chain[line] != line) line = _chain[line] = _chain[_chain[line]];
        return line;
    }

    private void Assemble(List<Polyline> loops)
    {
        var used = new bool[_lines.Count];
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
        _lines.Clear();
        _lines.AddRange(open);
    }

    private Polyline? Trace(int start, bool[] used, bool closed)
    {
        var points = new List<Vec3>();
        double along = 0, against = 0;
        for (var node = start; node >= 0 && !used[node >> 1]; node = _mate[node ^ 1])
        {
            var line = _lines[node >> 1];
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
        return count < 3 ? null : PolylineCleaning.ToPolyline(array, count, true, false, first);
    }
}
