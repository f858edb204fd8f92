using System;
using System.Collections.Generic;

namespace Caterpillar.Geometry;

/// <summary>
/// Cuts lines at the boundary of a region and keeps the pieces inside, or outside. A piece is classified by its midpoint, so rounding can't invert the rest.
/// </summary>
internal sealed partial class LineClipper
{
    private readonly RegionIndex _index;
    private readonly bool _outside;
    private readonly List<double> _cuts = new();
    private readonly List<Vec3> _current = new();
    private readonly List<Polyline> _pieces = new();
    private double _near;
    private bool _touched, _endTouches;

    public LineClipper(RegionIndex index, bool outside)
    {
        _index = index;
        _outside = outside;
    }

    public IReadOnlyList<Polyline> Pieces => _pieces;

    public void Clip(Polyline line)
    {
        var first = _pieces.Count;
        var whole = true;
        bool? inside = null;
        for (var i = 0; i < line.SegmentCount; i++) Segment(line[i], line[i + 1 == line.Count ? 0 : i + 1], ref whole, ref inside);
        var open = _current.Count > 0;
        if (line.IsClosed && whole && open)
        {
            _pieces.Add(line);
            _current.Clear();
            return;
        }
        Flush();
        if (line.IsClosed && open && _pieces.Count > first + 1) JoinAround(line[0], first);
    }

    /// <summary>True if no piece of the line is cut off.</summary>
    public bool IsWhole(Vec3 a, Vec3 b)
    {
        _cuts.Clear();
        Cuts(a.X * Grid.PerMm, a.Y * Grid.PerMm, b.X * Grid.PerMm, b.Y * Grid.PerMm);
        _cuts.Sort();
        _cuts.Add(1);
        var from = 0.0;
        foreach (var to in _cuts)
        {
            if (to <= from) continue;
            var middle = Vec3.Lerp(a, b, (from + to) / 2);
            if (_index.Contains(middle.X * Grid.PerMm, middle.Y * Grid.PerMm) == _outside) return false;
            from = to;
        }
        return true;
    }

    // Whether the last piece was kept holds for the next segment too, as long as no edge is near.
    private void Segment(Vec3 a, Vec3 b, ref bool whole, ref bool? last)
    {
        if (a.X == b.X && a.Y == b.Y)
        {
            if (_index.Contains(a.X * Grid.PerMm, a.Y * Grid.PerMm) != _outside) Extend(a, b);
            return;
        }
        _cuts.Clear();
        _touched = _endTouches = false;
        double dx = (b.X - a.X) * Grid.PerMm, dy = (b.Y - a.Y) * Grid.PerMm;
        _near = 2 / Math.Sqrt(dx * dx + dy * dy);
        Cuts(a.X * Grid.PerMm, a.Y * Grid.PerMm, b.X * Grid.PerMm, b.Y * Grid.PerMm);
        if (!_touched && last is { } same)
        {
            if (same) Extend(a, b);
            return;
        }
        _cuts.Sort();
        _cuts.Add(1);
        var from = 0.0;
        var start = 0.0;
        var kept = false;
        foreach (var to in _cuts)
        {
            if (to <= from) continue;
            var middle = Vec3.Lerp(a, b, (from + to) / 2);
            var keep = _index.Contains(middle.X * Grid.PerMm, middle.Y * Grid.PerMm) != _outside;
            if (keep && !kept) start = from;
            if (!keep && kept) Extend(Vec3.Lerp(a, b, start), Vec3.Lerp(a, b, from));
            if (!keep)
            {
                Flush();
                whole = false;
            }
            kept = keep;
            from = to;
        }
        if (kept) Extend(Vec3.Lerp(a, b, start), b);
        last = _endTouches ? null : kept;
    }

    private void Extend(Vec3 from, Vec3 to)
    {
        if (_current.Count == 0 || _current[_current.Count - 1] != from)
        {
            Flush();
            _current.Add(from);
        }
        _current.Add(to);
    }

    private void Flush()
    {
        if (_current.Count > 1) _pieces.Add(Polyline.Own(_current.ToArray(), closed: false));
        _current.Clear();
    }

    // The last piece of a closed line continues as its first one.
    private void JoinAround(Vec3 seam, int first)
    {
        var head = _pieces[first];
        var tail = _pieces[_pieces.Count - 1];
        if (head[0] != seam || tail[tail.Count - 1] != seam) return;
        var points = new Vec3[tail.Count + head.Count - 1];
        Array.Copy(tail.Raw, points, tail.Count);
        Array.Copy(head.Raw, 1, points, tail.Count, head.Count - 1);
        _pieces[first] = Polyline.Own(points, closed: false);
        _pieces.RemoveAt(_pieces.Count - 1);
    }

    private void Cuts(double ax, double ay, double bx, double by)
    {
        if (_index.Tree.Levels > 0) Descend(ax, ay, bx, by, _index.Tree.Levels - 1, 0);
    }

    private void Descend(double ax, double ay, double bx, double by, int level, int node)
    {
        var tree = _index.Tree;
        ref readonly var box = ref tree.Boxes[tree.LevelStart[level] + node];
        if (Math.Max(ax, bx) < box.MinX - 1.0 || Math.Min(ax, bx) > box.MaxX + 1.0 || Math.Max(ay, by) < box.MinY - 1.0
            || Math.Min(ay, by) > box.MaxY + 1.0)
        {
            return;
        }
        if (level > 0)
        {
            Descend(ax, ay, bx, by, level - 1, 2 * node);
            if (2 * node + 1 < tree.LevelCount[level - 1]) Descend(ax, ay, bx, by, level - 1, 2 * node + 1);
            return;
        }
        for (var i = tree.LeafStart[node]; i < tree.LeafStart[node + 1]; i++) Cut(ax, ay, bx, by, _index.Segments[i]);
    }

    private void Cut(double ax, double ay, double bx, double by, in Segment s)
    {
        double dx = bx - ax, dy = by - ay, square = dx * dx + dy * dy;
        if (square == 0) return;
        var c = dx * (s.Ay - ay) - dy * (s.Ax - ax);
        var d = dx * (s.By - ay) - dy * (s.Bx - ax);
        // Ends of edges within a grid unit of the line: where it may start or stop running along the boundary.
        if (c * c <= square) Add((dx * (s.Ax - ax) + dy * (s.Ay - ay)) / square);
        if (d * d <= square) Add((dx * (s.Bx - ax) + dy * (s.By - ay)) / square);
        if ((c > 0 && d > 0) || (c < 0 && d < 0)) return;
        double ex = (double)s.Bx - s.Ax, ey = (double)s.By - s.Ay;
        var a = ex * (ay - s.Ay) - ey * (ax - s.Ax);
        var b = ex * (by - s.Ay) - ey * (bx - s.Ax);
        if ((a > 0 && b > 0) || (a < 0 && b < 0) || a == b) return;
        Add(a / (a - b));
    }

    private void Add(double t)
    {
        if (t > 0 && t < 1) _cuts.Add(t);
        if (!(t > -_near && t < 1 + _near)) return;
        _touched = true;
        if (t > 1 - _near) _endTouches = true;
    }
}
