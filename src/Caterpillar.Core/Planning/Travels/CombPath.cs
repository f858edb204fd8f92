namespace Caterpillar.Planning;

/// <summary>
/// Paths inside a region around its corners: along the inset boundary where the straight line leaves it, then pulled tight. A connected region is left and
/// entered again across the same contour, so there is always such a path.
/// </summary>
/// <param name="inset">Distance that the path keeps from the boundary where it can, mm.</param>
internal sealed class CombPath(double inset)
{
    // mm; on the contour itself, rounding would decide whether a line leaves the region there.
    private const double Within = 1e-3;

    private readonly RegionEngine _engine = new();
    private readonly List<(double T, int Contour, int Segment)> _cuts = [];
    private Region? _region;
    private Region _inner = Region.Empty;

    /// <summary>Points after the start, the last is the end; null if no path within a bound (mm) was found.</summary>
    public List<Vec3>? Find(Vec3 from, Vec3 to, Region region, double longest)
    {
        if (!region.Contains(from.X, from.Y) || !region.Contains(to.X, to.Y)) return null;
        if (!ReferenceEquals(region, _region))
        {
            _region = region;
            _inner = region.Offset(-inset, JoinStyle.Miter, 2, 0.005, _engine).Simplified(inset / 10, _engine);
        }
        if (_inner.IsEmpty || Entry(from, region) is not { } a || Entry(to, region) is not { } b) return null;
        var walk = new List<Vec3> { from.WithZ(to.Z), a.WithZ(to.Z) };
        Walk(a.WithZ(to.Z), b.WithZ(to.Z), walk);
        walk.Add(b.WithZ(to.Z));
        walk.Add(to);
        var path = new List<Vec3> { from.WithZ(to.Z) };
        Pull(walk, 0, walk.Count - 1, path);
        for (var i = path.Count - 2; i > 0; i--)
        {
            if (IsFree(path[i - 1], path[i + 1], i == 1 || i == path.Count - 2)) path.RemoveAt(i);
        }
        var length = 0.0;
        for (var i = 1; i < path.Count; i++)
        {
            length += path[i].DistanceTo(path[i - 1]);
            if (!IsFree(path[i - 1], path[i], i == 1 || i == path.Count - 1)) return null;
        }
        path.RemoveAt(0);
        return length <= longest ? path : null;
    }

    // The point itself inside the inset region, else the nearest one of that, if it is near.
    private Vec3? Entry(Vec3 at, Region region)
    {
        if (_inner.Contains(at.X, at.Y)) return at;
        if (_inner.NearestEdge(at, 2 * inset) is not { } near || !region.ContainsLine(at, near)) return null;
        var within = near + Within * (near - at).WithZ(0).Unit();
        return _inner.Contains(within.X, within.Y) ? within : near;
    }

    // Adds the points between a and b: from each place where the line leaves the region along its contour to where the line last crosses that.
    private void Walk(Vec3 a, Vec3 b, List<Vec3> path)
    {
        _cuts.Clear();
        var contours = _inner.Contours;
        for (var c = 0; c < contours.Count; c++)
        {
            for (var i = 0; i < contours[c].Count; i++)
            {
                if (Crossing(a, b, contours[c][i], contours[c][i + 1 == contours[c].Count ? 0 : i + 1]) is { } t) _cuts.Add((t, c, i));
            }
        }
        _cuts.Sort();
        for (var first = 0; first < _cuts.Count; first++)
        {
            var last = _cuts.FindLastIndex(cut => cut.Contour == _cuts[first].Contour);
            if (last == first) continue;
            var contour = contours[_cuts[first].Contour];
            Vec3 leaves = Vec3.Lerp(a, b, _cuts[first].T), enters = Vec3.Lerp(a, b, _cuts[last].T);
            path.Add(leaves);
            Along(contour, leaves, _cuts[first].Segment, enters, _cuts[last].Segment, path);
            path.Add(enters);
            first = last;
        }
    }

    // The vertices from a point on one segment of a contour to a point on another, the shorter of both directions.
    private static void Along(Polyline contour, Vec3 leaves, int from, Vec3 enters, int to, List<Vec3> path)
    {
        if (from == to) return;
        var n = contour.Count;
        double forward = 0, all = 0;
        for (var i = 0; i < n; i++)
        {
            Vec3 p = contour[i], q = contour[i + 1 == n ? 0 : i + 1];
            var length = p.DistanceTo(q);
            all += length;
            if (i == from) forward += (leaves - q).LengthXY;
            else if (i == to) forward += (enters - p).LengthXY;
            else if (from < to ? i > from && i < to : i > from || i < to) forward += length;
        }
        if (forward > all / 2)
        {
            for (var i = from; i != to; i = i == 0 ? n - 1 : i - 1) path.Add(contour[i].WithZ(leaves.Z));
            return;
        }
        for (var i = from; i != to;)
        {
            i = i + 1 == n ? 0 : i + 1;
            path.Add(contour[i].WithZ(leaves.Z));
        }
    }

    // Straight where that is free; else through the point of the walk that lies farthest from the straight line.
    private void Pull(List<Vec3> walk, int first, int last, List<Vec3> path)
    {
        if (last - first > 1 && !IsFree(walk[first], walk[last], first == 0 || last == walk.Count - 1))
        {
            var farthest = first + 1;
            var most = -1.0;
            var along = (walk[last] - walk[first]).Unit();
            for (var i = first + 1; i < last; i++)
            {
                var off = walk[i] - walk[first];
                var t = Vec3.Dot(off, along);
                // Also points beyond the ends of the line are far from it.
                var distance = t < 0 ? off.LengthSquared : t > (walk[last] - walk[first]).Length ? (walk[i] - walk[last]).LengthSquared
                    : off.LengthSquared - t * t;
                if (distance <= most) continue;
                most = distance;
                farthest = i;
            }
            Pull(walk, first, farthest, path);
            Pull(walk, farthest, last, path);
            return;
        }
        path.Add(walk[last]);
    }

    // At the ends of a travel, which lie on extrusions, the region itself counts.
    private bool IsFree(Vec3 a, Vec3 b, bool atEnd) => (a - b).LengthXY < 1e-4 || (atEnd ? _region! : _inner).ContainsLine(a, b);

    private static double? Crossing(Vec3 a, Vec3 b, Vec3 p, Vec3 q)
    {
        double dx = b.X - a.X, dy = b.Y - a.Y;
        var c = dx * (p.Y - a.Y) - dy * (p.X - a.X);
        var d = dx * (q.Y - a.Y) - dy * (q.X - a.X);
        if (c > 0 == d > 0) return null;
        double ex = q.X - p.X, ey = q.Y - p.Y;
        var below = ex * dy - ey * dx;
        if (below == 0) return null;
        var t = (ex * (p.Y - a.Y) - ey * (p.X - a.X)) / below;
        return t is >= 0 and <= 1 ? t : null;
    }
}
