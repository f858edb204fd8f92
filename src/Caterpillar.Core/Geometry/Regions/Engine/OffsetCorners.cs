namespace Caterpillar.Geometry;

/// <summary>How the corners of an offset curve shorten the moved edges, and which edges vanish between two corners.</summary>
internal sealed class OffsetCorners
{
    // An edge that is trimmed to less than this (grid units) might be reversed by rounding.
    private const double ShortestTrimmed = 4;

    private double _d;
    private double[] _length = [];
    private double[] _before = [];
    private double[] _after = [];
    private double[] _x = [];
    private double[] _y = [];
    private int[] _previous = [];
    private int[] _next = [];

    /// <summary>Unit normals of the edges, to the right; edge i starts at vertex i.</summary>
    public double[] Nx = [];

    public double[] Ny = [];

    /// <summary>
    /// Kind of the corner at the start of an edge: 0 a join, 1 a cut of the two moved edges that meet there, 2 the same but with edges dropped in between
    /// (<see cref="Crossing"/>), 3 back through the vertex.
    /// </summary>
    public byte[] Kind = [];

    /// <summary>The edge whose end is at the corner before an edge: the previous one or, if edges were dropped, an earlier one.</summary>
    public int Previous(int edge) => _previous[edge];

    public bool Dropped(int edge) => Kind[edge] == 255;

    /// <summary>Where the moved edges of a corner of kind 2 meet, relative to the start of the edge.</summary>
    public (double X, double Y) Crossing(int edge) => (_x[edge], _y[edge]);

    /// <summary>
    /// Computes all corners for a distance in grid units. Extension gives how far a join extends the moved edges, from the cross and dot products of the
    /// normals.
    /// </summary>
    public void Compute(GridPoint[] path, double distance, Func<double, double, double> extension)
    {
        var n = path.Length;
        _d = distance;
        Reserve(n);
        Edges(path);
        for (int i = 0, before = n - 1; i < n; before = i++)
        {
            var cross = Nx[before] * Ny[i] - Ny[before] * Nx[i];
            var dot = Nx[before] * Nx[i] + Ny[before] * Ny[i];
            if (cross * _d >= 0)
            {
                Kind[i] = 0;
                _before[i] = _after[i] = -extension(cross, dot);
            }
            else if (dot > -0.99)
            {
                Kind[i] = 1;
                _before[i] = _after[i] = Math.Abs(_d * cross) / (1 + dot);
            }
            else
            {
                Kind[i] = 3;
                _before[i] = _after[i] = 0;
            }
        }
        var fits = true;
        for (var i = 0; i < n; i++) fits &= Fits(i, i + 1 == n ? 0 : i + 1);
        if (fits) return;
        if (n > 4) DropEdges(path);
        GoBack(n);
    }

    private void Edges(GridPoint[] path)
    {
        var n = path.Length;
        for (var i = 0; i < n; i++)
        {
            var a = path[i];
            var b = path[i + 1 == n ? 0 : i + 1];
            double dx = (double)b.X - a.X, dy = (double)b.Y - a.Y;
            var length = Math.Sqrt(dx * dx + dy * dy);
            var inverse = length > 0 ? 1 / length : 0;
            _length[i] = length;
            Nx[i] = dy * inverse;
            Ny[i] = -dx * inverse;
            _previous[i] = i == 0 ? n - 1 : i - 1;
            _next[i] = i + 1 == n ? 0 : i + 1;
        }
    }

    private static bool Inward(byte kind) => kind is 1 or 2;

    // Joins that extend an edge count only if the other end is a cut.
    private bool Fits(int edge, int next)
        => !(Inward(Kind[edge]) || Inward(Kind[next])) || _after[edge] + _before[next] + ShortestTrimmed <= _length[edge];

    // An edge between two cuts that does not fit vanishes: its neighbors meet before the offset distance is reached. This is the lower envelope of the moved
    // lines.
    private void DropEdges(GridPoint[] path)
    {
        var n = path.Length;
        var alive = n;
        var budget = 4 * n;
        for (var i = 0; i < n && alive > 4 && budget > 0; budget--)
        {
            var next = _next[i];
            if (Dropped(i) || !Inward(Kind[i]) || !Inward(Kind[next]) || Fits(i, next) || !Meet(path, _previous[i], next))
            {
                i++;
                continue;
            }
            var previous = _previous[i];
            Kind[i] = 255;
            Kind[next] = 2;
            _next[previous] = next;
            _previous[next] = previous;
            alive--;
            // The neighbors have lost some length; earlier ones are checked again.
            i = previous < i ? previous : i + 1;
        }
    }

    private bool Meet(GridPoint[] path, int a, int b)
    {
        var cross = Nx[a] * Ny[b] - Ny[a] * Nx[b];
        var dot = Nx[a] * Nx[b] + Ny[a] * Ny[b];
        if (cross * _d >= 0 || Math.Abs(cross) < 1e-5 || dot < -0.7) return false;
        var end = path[a + 1 == path.Length ? 0 : a + 1];
        double gx = (double)path[b].X - end.X, gy = (double)path[b].Y - end.Y;
        var along = _d - (Nx[a] * gx + Ny[a] * gy);
        var x = (along * Ny[b] - _d * Ny[a]) / cross;
        var y = (_d * Nx[a] - along * Nx[b]) / cross;
        var after = -x * Ny[b] + y * Nx[b];
        var before = (x + gx) * Ny[a] - (y + gy) * Nx[a];
        if (!(after >= 0 && before >= 0 && after < _length[b] && before < _length[a])) return false;
        _x[b] = x;
        _y[b] = y;
        _after[b] = after;
        _before[b] = before;
        return true;
    }

    // Edges that still do not fit go back through the vertices; so do the edges dropped next to them.
    private void GoBack(int n)
    {
        for (var i = 0; i < n; i++)
        {
            if (Dropped(i)) continue;
            var next = _next[i];
            if (Fits(i, next)) continue;
            Restore(i, n);
            Restore(next, n);
        }
    }

    private void Restore(int edge, int n)
    {
        if (!Inward(Kind[edge])) return;
        for (int i = edge, stop = _previous[edge]; i != stop; i = i == 0 ? n - 1 : i - 1)
        {
            Kind[i] = 3;
            _before[i] = _after[i] = 0;
            _previous[i] = i == 0 ? n - 1 : i - 1;
            _next[_previous[i]] = i;
        }
    }

    private void Reserve(int n)
    {
        Buffers.Reserve(ref _length, n);
        Buffers.Reserve(ref _before, n);
        Buffers.Reserve(ref _after, n);
        Buffers.Reserve(ref _x, n);
        Buffers.Reserve(ref _y, n);
        Buffers.Reserve(ref _previous, n);
        Buffers.Reserve(ref _next, n);
        Buffers.Reserve(ref Nx, n);
        Buffers.Reserve(ref Ny, n);
        Buffers.Reserve(ref Kind, n);
    }
}
