namespace Caterpillar.Geometry;

/// <summary>
/// The parts of the segments of a path inside a region, or outside. Segments that follow each other are near the same edges, and are mostly on the same side of
/// all.
/// </summary>
/// <param name="index">The region.</param>
/// <param name="outside">Keep what is outside.</param>
/// <param name="together">Segments that look for edges together.</param>
internal sealed class LineClipper(RegionIndex index, bool outside, int together = 16)
{
    private readonly LineCuts _cuts = new(index);
    private readonly List<int> _leaves = [];
    private Vec3[] _path = [];
    private int _run;
    private int _after;
    private bool? _last;

    /// <summary>Parts are those of the segments of this path, closed.</summary>
    public void Follow(Vec3[] path) => (_path, _run, _after) = (path, -1, -1);

    /// <summary>Adds the kept parts of a segment of the path as parameters from 0 to 1, in order and joined where they touch.</summary>
    public void Parts(int segment, List<(double From, double To)> parts)
    {
        Vec3 a = _path[segment], b = _path[segment + 1 == _path.Length ? 0 : segment + 1];
        Cut(segment, a, b);
        var goesOn = _after == segment && _last is not null && !_cuts.Touched;
        // The end of a segment that ends at an edge tells nothing of the next.
        _after = _cuts.EndTouches ? -1 : segment + 1;
        if (goesOn)
        {
            if (_last == true) parts.Add((0, 1));
            return;
        }
        var from = 0.0;
        foreach (var to in InOrder())
        {
            if (to <= from) continue;
            _last = Keeps(Vec3.Lerp(a, b, (from + to) / 2));
            if (_last == true)
            {
                if (parts.Count > 0 && parts[parts.Count - 1].To == from) parts[parts.Count - 1] = (parts[parts.Count - 1].From, to);
                else parts.Add((from, to));
            }
            from = to;
        }
    }

    /// <summary>True if all of a line is kept.</summary>
    public bool IsWhole(Vec3 a, Vec3 b)
    {
        var parts = new List<(double From, double To)>();
        Follow([a, b]);
        Parts(0, parts);
        return parts.Count == 1 && parts[0] == (0, 1);
    }

    private void Cut(int segment, Vec3 a, Vec3 b)
    {
        if (segment / together != _run) FindLeaves(segment / together);
        _cuts.Begin(a, b);
        foreach (var leaf in _leaves) _cuts.Add(leaf);
    }

    // The cuts with the end of the segment.
    private List<double> InOrder()
    {
        if (_cuts.Found.Count > 1) _cuts.Found.Sort();
        _cuts.Found.Add(1);
        return _cuts.Found;
    }

    private bool Keeps(Vec3 point) => index.Contains(point.X * Grid.PerMm, point.Y * Grid.PerMm) != outside;

    // The leaves of edges near a run of segments.
    private void FindLeaves(int run)
    {
        _run = run;
        _leaves.Clear();
        var tree = index.Tree;
        if (tree.Levels == 0) return;
        double minX = double.PositiveInfinity, minY = minX, maxX = double.NegativeInfinity, maxY = maxX;
        for (var i = run * together; i <= (run + 1) * together && i <= _path.Length; i++)
        {
            ref readonly var p = ref _path[i == _path.Length ? 0 : i];
            double x = p.X * Grid.PerMm, y = p.Y * Grid.PerMm;
            if (x < minX) minX = x;
            if (x > maxX) maxX = x;
            if (y < minY) minY = y;
            if (y > maxY) maxY = y;
        }
        FindLeaves(minX, minY, maxX, maxY, tree.Levels - 1, 0);
    }

    private void FindLeaves(double minX, double minY, double maxX, double maxY, int level, int node)
    {
        var tree = index.Tree;
        ref readonly var box = ref tree.Boxes[tree.LevelStart[level] + node];
        if (maxX < box.MinX - 1.0 || minX > box.MaxX + 1.0 || maxY < box.MinY - 1.0 || minY > box.MaxY + 1.0) return;
        if (level == 0)
        {
            _leaves.Add(node);
            return;
        }
        FindLeaves(minX, minY, maxX, maxY, level - 1, 2 * node);
        if (2 * node + 1 < tree.LevelCount[level - 1]) FindLeaves(minX, minY, maxX, maxY, level - 1, 2 * node + 1);
    }
}
