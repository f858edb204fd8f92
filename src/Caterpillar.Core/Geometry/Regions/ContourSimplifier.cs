namespace Caterpillar.Geometry;

/// <summary>Douglas-Peucker on closed paths, without recursion; the first vertex and the one farthest from it stay.</summary>
internal sealed class ContourSimplifier
{
    private readonly double _square;
    private bool[] _keep = new bool[256];
    private int[] _stack = new int[128];

    /// <summary>For a tolerance in grid units.</summary>
    public ContourSimplifier(double tolerance) => _square = tolerance * tolerance;

    public GridPoint[] Points { get; private set; } = new GridPoint[256];

    public int Count { get; private set; }

    public void Simplify(GridPoint[] path)
    {
        var n = path.Length;
        if (_keep.Length <= n)
        {
            _keep = new bool[2 * n];
            Points = new GridPoint[2 * n];
        }
        for (var i = 0; i <= n; i++) _keep[i] = false;
        var far = 0;
        var most = -1.0;
        for (var i = 1; i < n; i++)
        {
            double dx = (double)path[i].X - path[0].X, dy = (double)path[i].Y - path[0].Y;
            if (dx * dx + dy * dy <= most) continue;
            most = dx * dx + dy * dy;
            far = i;
        }
        _keep[0] = true;
        _keep[far] = true;
        Chain(path, 0, far);
        Chain(path, far, n);
        Count = 0;
        for (var i = 0; i < n; i++)
        {
            if (_keep[i]) Points[Count++] = path[i];
        }
    }

    // From vertex first to vertex last; index n is vertex 0 again.
    private void Chain(GridPoint[] path, int first, int last)
    {
        var depth = 0;
        while (true)
        {
            var split = Farthest(path, first, last);
            if (split > 0)
            {
                _keep[split] = true;
                if (depth == _stack.Length) System.Array.Resize(ref _stack, 2 * depth);
                _stack[depth++] = last;
                last = split;
                continue;
            }
            if (depth == 0) return;
            first = last;
            last = _stack[--depth];
        }
    }

    private int Farthest(GridPoint[] path, int first, int last)
    {
        var a = path[first];
        var b = path[last == path.Length ? 0 : last];
        double dx = (double)b.X - a.X, dy = (double)b.Y - a.Y;
        var length = dx * dx + dy * dy;
        // All in squares times the square of the chord's length, which saves the division.
        var scale = length > 0 ? length : 1;
        var best = _square * scale;
        var at = 0;
        for (var i = first + 1; i < last; i++)
        {
            double px = (double)path[i].X - a.X, py = (double)path[i].Y - a.Y;
            var along = px * dx + py * dy;
            var distance = dx * py - dy * px;
            distance *= distance;
            if (along <= 0) distance = (px * px + py * py) * scale;
            else if (along >= length) distance = ((px - dx) * (px - dx) + (py - dy) * (py - dy)) * scale;
            if (distance <= best) continue;
            best = distance;
            at = i;
        }
        return at;
    }
}
