namespace Caterpillar.Geometry;

/// <summary>
/// Cuts lines at the boundary of a region and keeps the pieces inside, or outside. A piece is classified by its midpoint, so rounding can't invert the rest.
/// </summary>
internal sealed class PolylineClipper(RegionIndex index, bool outside)
{
    private readonly LineCuts _cuts = new(index);
    private readonly List<Vec3> _current = [];
    private readonly List<Polyline> _pieces = [];

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
        var from = 0.0;
        foreach (var to in Cuts(a, b))
        {
            if (to <= from) continue;
            if (!Keeps(Vec3.Lerp(a, b, (from + to) / 2))) return false;
            from = to;
        }
        return true;
    }

    // Whether the last piece was kept holds for the next segment too, as long as no edge is near.
    private void Segment(Vec3 a, Vec3 b, ref bool whole, ref bool? last)
    {
        if (a.X == b.X && a.Y == b.Y)
        {
            if (Keeps(a)) Extend(a, b);
            return;
        }
        var cuts = Cuts(a, b);
        if (!_cuts.Touched && last is { } same)
        {
            if (same) Extend(a, b);
            return;
        }
        var from = 0.0;
        var start = 0.0;
        var kept = false;
        foreach (var to in cuts)
        {
            if (to <= from) continue;
            var keep = Keeps(Vec3.Lerp(a, b, (from + to) / 2));
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
        last = _cuts.EndTouches ? null : kept;
    }

    // In order, with the end of the line.
    private List<double> Cuts(Vec3 a, Vec3 b)
    {
        _cuts.Begin(a, b);
        _cuts.AddAll();
        _cuts.Found.Sort();
        _cuts.Found.Add(1);
        return _cuts.Found;
    }

    private bool Keeps(Vec3 point) => index.Contains(point.X * Grid.PerMm, point.Y * Grid.PerMm) != outside;

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
        System.Array.Copy(tail.Raw, points, tail.Count);
        System.Array.Copy(head.Raw, 1, points, tail.Count, head.Count - 1);
        _pieces[first] = Polyline.Own(points, closed: false);
        _pieces.RemoveAt(_pieces.Count - 1);
    }
}
