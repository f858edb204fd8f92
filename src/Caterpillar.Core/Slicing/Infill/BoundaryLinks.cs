namespace Caterpillar.Slicing;

/// <summary>
/// Joins lines whose ends are neighbors on the boundary, along the boundary. Each end and each stretch is used once at most, and no loop is closed, so walking
/// around a contour turns parallel lines into zigzags.
/// </summary>
internal sealed partial class BoundaryLinks
{
    private readonly List<Vec3> _points = [];
    private readonly List<double> _flow = [];
    private End[] _ends = [];
    private Link[] _links = [];
    private double _anchor;

    /// <summary>The same lines, joined where the distance along the boundary is at most <paramref name="limit"/> mm.</summary>
    /// <param name="area">The area whose boundary the lines end on.</param>
    /// <param name="lines">The lines.</param>
    /// <param name="limit">Longest link along the boundary, mm.</param>
    /// <param name="width">Width of the extrusions, mm, where their turns leave nothing open along the boundary; 0 for plain corners.</param>
    /// <param name="early">How much earlier lines end that turn back sharply, at which a printer nearly stops, mm.</param>
    /// <param name="anchor">How far ends that are not joined are led along the boundary, mm.</param>
    public List<InfillLine> Join(Region area, IReadOnlyList<InfillLine> lines, double limit, double width = 0, double early = 0, double anchor = 0)
    {
        (_width, _early, _anchor) = (width, early, anchor);
        var result = new List<InfillLine>(lines.Count);
        if (lines.Count == 0) return result;
        var boundary = new BoundaryIndex(area);
        var count = Locate(boundary, lines);
        Match(boundary, count, limit, new DisjointSets(lines.Count));
        var done = new bool[lines.Count];
        for (var i = 0; i < lines.Count; i++)
        {
            if (done[i]) continue;
            if (lines[i].Closed || (anchor == 0 && _links[2 * i].To < 0 && _links[2 * i + 1].To < 0)) result.Add(lines[i]);
            // A chain is written from its end that comes first.
            else if (_links[2 * i].To < 0) result.Add(Chain(boundary, lines, 2 * i, done));
            else if (_links[2 * i + 1].To < 0) result.Add(Chain(boundary, lines, 2 * i + 1, done));
        }
        return result;
    }

    private int Locate(BoundaryIndex boundary, IReadOnlyList<InfillLine> lines)
    {
        if (_ends.Length < 2 * lines.Count)
        {
            _ends = new End[2 * lines.Count];
            _links = new Link[2 * lines.Count];
            _places = new Place[2 * lines.Count];
        }
        var count = 0;
        for (var i = 0; i < lines.Count; i++)
        {
            _links[2 * i] = _links[2 * i + 1] = new Link(-1, 0, 0, 0, true);
            _places[2 * i] = _places[2 * i + 1] = new Place(-1, 0, 0, 0);
            if (lines[i].Closed) continue;
            var points = lines[i].Points;
            if (boundary.Find(points[0], out var contour, out var at)) _ends[count++] = new End(contour, at, 2 * i);
            if (boundary.Find(points[points.Length - 1], out contour, out at)) _ends[count++] = new End(contour, at, 2 * i + 1);
        }
        Array.Sort(_ends, 0, count);
        if (_width > 0 || _early > 0 || _anchor > 0) Distances(boundary, count);
        return count;
    }

    private void Match(BoundaryIndex boundary, int count, double limit, DisjointSets chains)
    {
        for (var start = 0; start < count;)
        {
            var contour = _ends[start].Contour;
            var stop = start;
            while (stop < count && _ends[stop].Contour == contour) stop++;
            for (var i = start; i < stop && stop > start + 1; i++)
            {
                var next = i + 1 < stop ? i + 1 : start;
                ref readonly var a = ref _ends[i];
                ref readonly var b = ref _ends[next];
                var distance = b.At - a.At + (next == start ? boundary.Lengths[contour] : 0);
                if (distance > limit || _links[a.Id].To >= 0 || _links[b.Id].To >= 0) continue;
                if (chains.Join(a.Id >> 1, b.Id >> 1)) Tie(a, b);
            }
            start = stop;
        }
    }

    // The contour leads from a to b.
    private void Tie(End a, End b)
    {
        _links[a.Id] = new Link(b.Id, a.Contour, a.At, b.At, true);
        _links[b.Id] = new Link(a.Id, a.Contour, a.At, b.At, false);
    }

    private InfillLine Chain(BoundaryIndex boundary, IReadOnlyList<InfillLine> lines, int end, bool[] done)
    {
        _points.Clear();
        _flow.Clear();
        var varies = false;
        var length = 0.0;
        Vec3? entry = null;
        Anchor(boundary, end, toEnd: true);
        while (true)
        {
            var line = lines[end >> 1];
            done[end >> 1] = true;
            varies |= line.Flow is not null;
            length += line.Length;
            var forward = (end & 1) == 0;
            var n = line.Points.Length;
            for (var i = 0; i < n; i++)
            {
                // Into a point leads the segment before it; into the first one the link.
                var flow = i == 0 ? (entry is null ? 1 : Cross) : line.Flow is null ? 1 : line.Flow[forward ? i - 1 : n - 1 - i];
                Add(i == 0 && entry is { } joined ? joined : line.Points[forward ? i : n - 1 - i], flow);
            }
            var link = _links[end ^ 1];
            if (link.To < 0)
            {
                Anchor(boundary, end ^ 1, toEnd: false);
                break;
            }
            length += link.Upto - link.From + (link.Upto < link.From ? boundary.Lengths[link.Contour] : 0);
            var (leave, join) = (Turn(boundary, lines, end ^ 1, link.Forward), Turn(boundary, lines, link.To, !link.Forward));
            if (leave is { } turn)
            {
                _points[_points.Count - 1] = turn.OnLine;
                Add(turn.Foot, Cross);
                varies = true;
            }
            var from = _points.Count;
            double? start = link.Forward ? leave?.At : join?.At, stop = link.Forward ? join?.At : leave?.At;
            boundary.Corners(link.Contour, start ?? link.From, stop ?? link.Upto, _points);
            if (!link.Forward) _points.Reverse(from, _points.Count - from);
            while (_flow.Count < _points.Count) _flow.Add(1);
            if (join is { } bend) Add(bend.Foot, 1);
            entry = join?.OnLine;
            varies |= join is not null;
            end = link.To;
        }
        var z = lines[end >> 1].Points[0].Z;
        var points = new Vec3[_points.Count];
        for (var i = 0; i < points.Length; i++) points[i] = _points[i].WithZ(z);
        _flow.RemoveAt(0);
        var chain = new InfillLine(points, false, varies ? _flow.ToArray() : null);
        // Lines that end early hold as much material as if they did not.
        return _early > 0 ? chain.Holding(length) : chain;
    }

    // Along the boundary beside a free end, on the side with more room, at most to the middle between it and the next end; toEnd: the chain begins there.
    private void Anchor(BoundaryIndex boundary, int id, bool toEnd)
    {
        var place = _places[id];
        if (_anchor == 0 || place.Contour < 0) return;
        var forward = place.After >= place.Before;
        var length = Math.Min(_anchor, Math.Max(place.Before, place.After) / 2);
        var around = boundary.Lengths[place.Contour];
        var far = place.At + (forward ? length : -length);
        far -= Math.Floor(far / around) * around;
        if (toEnd) Add(boundary.At(place.Contour, far), 1);
        var first = _points.Count;
        boundary.Corners(place.Contour, forward ? place.At : far, forward ? far : place.At, _points);
        if (forward == toEnd) _points.Reverse(first, _points.Count - first);
        while (_flow.Count < _points.Count) _flow.Add(1);
        if (!toEnd) Add(boundary.At(place.Contour, far), 1);
    }

    private void Add(Vec3 point, double flow)
    {
        var last = _points.Count - 1;
        if (last >= 0 && Math.Abs(_points[last].X - point.X) < 1e-6 && Math.Abs(_points[last].Y - point.Y) < 1e-6) return;
        _points.Add(point);
        _flow.Add(flow);
    }

    // To is the end on the other side, or −1; Forward tells whether the contour is followed in its direction.
    private readonly record struct Link(int To, int Contour, double From, double Upto, bool Forward);

    private readonly record struct End(int Contour, double At, int Id) : IComparable<End>
    {
        public int CompareTo(End other)
        {
            if (Contour != other.Contour) return Contour.CompareTo(other.Contour);
            return At != other.At ? At.CompareTo(other.At) : Id.CompareTo(other.Id);
        }
    }
}
