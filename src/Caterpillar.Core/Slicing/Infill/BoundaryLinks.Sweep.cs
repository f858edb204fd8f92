namespace Caterpillar.Slicing;

// A sweep of parallel rows: each piece of a row comes after all pieces of the row before that it lies next to.
internal sealed partial class BoundaryLinks
{
    /// <summary>
    /// Pieces of rows in an order in which each comes after its neighbors in the row before; the next one is the nearest that is free. They are joined along
    /// the boundary where that is at most <paramref name="limit"/> mm (negative for never).
    /// </summary>
    /// <param name="area">The area whose boundary the pieces end on.</param>
    /// <param name="lines">The pieces, by row and along the row.</param>
    /// <param name="spans">Row of each piece, and from where to where it goes along the rows.</param>
    /// <param name="limit">Longest link along the boundary, mm.</param>
    /// <param name="width">Width of the extrusions, mm, as for <see cref="Join"/>.</param>
    /// <param name="early">How much earlier pieces end that turn back sharply, mm, as for <see cref="Join"/>.</param>
    public List<InfillLine> Sweep(
        Region area, IReadOnlyList<InfillLine> lines, IReadOnlyList<(int Row, double From, double To)> spans, double limit, double width = 0, double early = 0)
    {
        (_width, _early, _anchor) = (width, early, 0);
        var result = new List<InfillLine>(lines.Count);
        if (lines.Count == 0) return result;
        var boundary = new BoundaryIndex(area);
        var count = Locate(boundary, lines);
        var place = Enumerable.Repeat(-1, 2 * lines.Count).ToArray();
        for (var i = 0; i < count; i++) place[_ends[i].Id] = i;
        var (next, waiting) = Neighbors(spans);
        var free = new List<int>();
        for (var i = 0; i < lines.Count; i++)
        {
            if (waiting[i] == 0) free.Add(i);
        }
        var done = new bool[lines.Count];
        var position = lines[0].Points[0];
        while (free.Count > 0)
        {
            var first = Nearest(free, lines, position);
            var end = first;
            while (true)
            {
                free.Remove(end >> 1);
                foreach (var follower in next[end >> 1])
                {
                    if (--waiting[follower] == 0) free.Add(follower);
                }
                var on = limit < 0 ? -1 : Onward(boundary, place, end ^ 1, count, free, limit);
                if (on < 0) break;
                end = on;
            }
            result.Add(Chain(boundary, lines, first, done));
            var points = lines[end >> 1].Points;
            position = (end & 1) == 0 ? points[points.Length - 1] : points[0];
        }
        return result;
    }

    // The pieces of the next row that a piece lies next to, and how many of the row before each waits for.
    private static (List<int>[] Next, int[] Waiting) Neighbors(IReadOnlyList<(int Row, double From, double To)> spans)
    {
        var next = new List<int>[spans.Count];
        var waiting = new int[spans.Count];
        var from = 0;
        for (var i = 0; i < spans.Count; i++)
        {
            next[i] = [];
            while (from < spans.Count && (spans[from].Row <= spans[i].Row || (spans[from].Row == spans[i].Row + 1 && spans[from].To < spans[i].From))) from++;
            for (var j = from; j < spans.Count && spans[j].Row == spans[i].Row + 1 && spans[j].From <= spans[i].To; j++)
            {
                next[i].Add(j);
                waiting[j]++;
            }
        }
        return (next, waiting);
    }

    // The end to enter by.
    private static int Nearest(List<int> free, IReadOnlyList<InfillLine> lines, Vec3 position)
    {
        var best = -1;
        var least = double.PositiveInfinity;
        foreach (var i in free)
        {
            var points = lines[i].Points;
            double start = (points[0] - position).LengthSquared, stop = (points[points.Length - 1] - position).LengthSquared;
            if (Math.Min(start, stop) >= least) continue;
            least = Math.Min(start, stop);
            best = 2 * i + (stop < start ? 1 : 0);
        }
        return best;
    }

    // The end next to this one on the boundary, tied to it, if its piece is free and near.
    private int Onward(BoundaryIndex boundary, int[] place, int id, int count, List<int> free, double limit)
    {
        var at = place[id];
        if (at < 0) return -1;
        for (var step = 1; step >= -1; step -= 2)
        {
            var end = _ends[at];
            var other = at + step;
            var around = 0.0;
            if (other < 0 || other >= count || _ends[other].Contour != end.Contour)
            {
                // Past the start of the contour.
                other = at;
                while (other - step >= 0 && other - step < count && _ends[other - step].Contour == end.Contour) other -= step;
                around = boundary.Lengths[end.Contour];
            }
            var distance = (_ends[other].At - end.At) * step + around;
            if (other == at || distance > limit || !free.Contains(_ends[other].Id >> 1)) continue;
            if (step > 0) Tie(end, _ends[other]);
            else Tie(_ends[other], end);
            return _ends[other].Id;
        }
        return -1;
    }
}
