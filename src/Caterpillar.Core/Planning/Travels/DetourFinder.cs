namespace Caterpillar.Planning;

/// <summary>
/// Paths around what is printed, at one height: A* (Hart, Nilsson and Raphael 1968) on a lattice around the start, whose edges are tested only when they are
/// taken; then corners are cut where possible. The search stays within the ellipse of paths not longer than a bound, and within a number of nodes.
/// </summary>
internal sealed class DetourFinder(Deposit deposit, HeadCorridor head)
{
    private const int MaxNodes = 4000;
    private const double Flush = 1e-6;
    private readonly double _step = Math.Min(2, Math.Max(0.5, head.TipRadius));
    private readonly Dictionary<(int X, int Y), Node> _nodes = [];
    private readonly SortedSet<(double Cost, int Serial, int X, int Y)> _open = [];
    private int _serial;

    private sealed class Node
    {
        public double Length;
        public (int X, int Y) From;
        public bool Done;
    }

    /// <summary>
    /// Points after the start, the last is the end; null if no free path within the bound was found. Both ends are at the height of the path.
    /// </summary>
    public List<Vec3>? Find(Vec3 start, Vec3 end, double maxLength)
    {
        if (!IsFree(start, start) || !IsFree(end, end)) return null;
        _nodes.Clear();
        _open.Clear();
        _serial = 0;
        _nodes[(0, 0)] = new Node();
        _open.Add((start.DistanceTo(end), 0, 0, 0));
        for (var visited = 0; _open.Count > 0 && visited < MaxNodes;)
        {
            var next = _open.Min;
            _open.Remove(next);
            var (_, _, x, y) = next;
            var node = _nodes[(x, y)];
            if (node.Done || double.IsInfinity(node.Length)) continue;
            visited++;
            var at = Place(start, x, y);
            if ((x, y) != (0, 0) && !IsFree(Place(start, node.From.X, node.From.Y), at))
            {
                // Another neighbor may still reach it.
                node.Length = double.PositiveInfinity;
                continue;
            }
            node.Done = true;
            if (at.DistanceTo(end) <= 1.5 * _step && node.Length + at.DistanceTo(end) <= maxLength && IsFree(at, end)) return Points(start, end, (x, y));
            for (var dx = -1; dx <= 1; dx++)
            {
                for (var dy = -1; dy <= 1; dy++)
                {
                    Reach(start, end, maxLength, (x, y), (x + dx, y + dy), node.Length + (dx != 0 && dy != 0 ? Math.Sqrt(2) : 1) * _step);
                }
            }
        }
        return null;
    }

    private void Reach(Vec3 start, Vec3 end, double maxLength, (int X, int Y) from, (int X, int Y) to, double length)
    {
        var cost = length + Place(start, to.X, to.Y).DistanceTo(end);
        if (cost > maxLength) return;
        if (_nodes.TryGetValue(to, out var known))
        {
            if (known.Done || known.Length <= length) return;
            known.Length = length;
            known.From = from;
        }
        else
        {
            _nodes[to] = new Node { Length = length, From = from };
        }
        _open.Add((cost, ++_serial, to.X, to.Y));
    }

    private List<Vec3> Points(Vec3 start, Vec3 end, (int X, int Y) last)
    {
        var points = new List<Vec3> { end };
        for (var at = last; at != (0, 0); at = _nodes[at].From) points.Add(Place(start, at.X, at.Y));
        points.Add(start);
        points.Reverse();
        var path = new List<Vec3>();
        for (var i = 0; i < points.Count - 1;)
        {
            var next = points.Count - 1;
            while (next > i + 1 && !IsFree(points[i], points[next])) next--;
            path.Add(points[next]);
            i = next;
        }
        return path;
    }

    private Vec3 Place(Vec3 start, int x, int y) => new(start.X + x * _step, start.Y + y * _step, start.Z);

    private bool IsFree(Vec3 a, Vec3 b) => head.RequiredHeight(deposit, a, b, a.Z) <= a.Z + Flush;
}
