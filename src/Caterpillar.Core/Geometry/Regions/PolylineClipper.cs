namespace Caterpillar.Geometry;

/// <summary>
/// Cuts lines at the boundary of a region and keeps the pieces inside, or outside. A piece is classified by its midpoint, so rounding can't invert the rest.
/// </summary>
internal sealed class PolylineClipper(RegionIndex index, bool outside)
{
    private readonly LineClipper _clipper = new(index, outside, together: 1);
    private readonly List<(double From, double To)> _parts = [];
    private readonly List<Vec3> _current = [];
    private readonly List<Polyline> _pieces = [];

    public IReadOnlyList<Polyline> Pieces => _pieces;

    public void Clip(Polyline line)
    {
        var first = _pieces.Count;
        var whole = true;
        _clipper.Follow(line.Raw);
        for (var i = 0; i < line.SegmentCount; i++)
        {
            Vec3 a = line[i], b = line[i + 1 == line.Count ? 0 : i + 1];
            _parts.Clear();
            _clipper.Parts(i, _parts);
            foreach (var (from, to) in _parts) Extend(Vec3.Lerp(a, b, from), Vec3.Lerp(a, b, to));
            whole &= _parts.Count == 1 && _parts[0] == (0, 1);
        }
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
