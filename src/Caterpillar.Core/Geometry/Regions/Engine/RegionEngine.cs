namespace Caterpillar.Geometry;

/// <summary>
/// The clipper: takes contours and gives the rings of the inside. It cuts the contours at their crossings, computes winding numbers and follows the boundary.
/// If nothing crosses or touches, complete contours are kept or dropped. Keeps its arrays for the next call; one thread at a time.
/// </summary>
internal sealed class RegionEngine
{
    public readonly Arrangement Arrangement = new();
    public readonly OffsetCurve Curve = new();
    public readonly ContourSimplifier Simplifier = new();
    private readonly PlanarGraph _graph = new();
    private readonly RingTracer _tracer = new();
    private readonly List<GridPoint[]> _rings = new();
    private List<(int Contour, bool Forward)>? _kept;

    /// <summary>Does something for numbers from one up to another, in parallel: each thread has an engine.</summary>
    public static void ForEach(int from, int to, ParallelOptions options, Action<int, RegionEngine> act)
        => Parallel.For(from, to, options, () => new RegionEngine(), (i, _, engine) =>
        {
            act(i, engine);
            return engine;
        }, _ => { });

    public void Clear() => Arrangement.Clear();

    public void Add(GridPoint[] path, byte operand = 0) => Arrangement.Add(path, 0, path.Length, operand);

    public void Add(GridPoint[][] paths, byte operand = 0)
    {
        foreach (var path in paths) Arrangement.Add(path, 0, path.Length, operand);
    }

    /// <summary>The rings of the inside: outers counterclockwise, holes clockwise, each simple, none crossing.</summary>
    public GridPoint[][] Run(InsideRule rule)
    {
        _rings.Clear();
        Arrangement.Resolve();
        if (Arrangement.Touches || Arrangement.Cut)
        {
            _graph.Build(Arrangement);
            _tracer.Trace(_graph, rule, _rings);
        }
        else
        {
            for (var c = 0; c < Arrangement.Contours; c++) Isolated(c, rule);
        }
        return _rings.ToArray();
    }

    /// <summary>
    /// The same, but if nothing crosses or touches it gives the indices of the contours that bound the inside (in the order they were added), each with whether
    /// its direction is kept, and no rings.
    /// </summary>
    public GridPoint[][] Run(InsideRule rule, List<(int Contour, bool Forward)> kept)
    {
        _kept = kept;
        var rings = Run(rule);
        _kept = null;
        return rings;
    }

    // A contour that touches nothing, not even itself.
    private void Isolated(int c, InsideRule rule)
    {
        int start = Arrangement.ContourStart[c], end = Arrangement.ContourStart[c + 1];
        var segments = Arrangement.Segments;
        // The point just left of the leftmost (then lowest) vertex is outside of the contour, and the contour turns there.
        var leftmost = start;
        for (var i = start + 1; i < end; i++)
        {
            if (segments[i].Ax < segments[leftmost].Ax || (segments[i].Ax == segments[leftmost].Ax && segments[i].Ay < segments[leftmost].Ay)) leftmost = i;
        }
        Arrangement.Tree.Winding(segments, Arrangement.Operand, segments[leftmost].Ax, segments[leftmost].Ay, out var first, out var second);
        var previous = segments[leftmost == start ? end - 1 : leftmost - 1];
        var turn = Grid.Cross(previous.A, previous.B, segments[leftmost].B);
        var step = turn > 0 ? 1 : -1;
        var outside = rule.Holds(first, second);
        var inside = Arrangement.Operand[c] == 0 ? rule.Holds(first + step, second) : rule.Holds(first, second + step);
        if (inside == outside) return;
        Keep(c, forward: inside == step > 0);
    }

    private void Keep(int c, bool forward)
    {
        int start = Arrangement.ContourStart[c], end = Arrangement.ContourStart[c + 1];
        var segments = Arrangement.Segments;
        if (_kept is not null)
        {
            _kept.Add((Arrangement.Source[c], forward));
            return;
        }
        var count = 0;
        for (var i = start; i < end; i++)
        {
            if (!Straight(i, start, end)) count++;
        }
        if (count < 3) return;
        var ring = new GridPoint[count];
        var n = 0;
        for (var i = start; i < end; i++)
        {
            if (!Straight(i, start, end)) ring[forward ? n++ : count - ++n] = segments[i].A;
        }
        _rings.Add(ring);
    }

    private bool Straight(int i, int start, int end)
    {
        var segments = Arrangement.Segments;
        ref readonly var before = ref segments[i == start ? end - 1 : i - 1];
        ref readonly var s = ref segments[i];
        return before.Side(s.Bx, s.By) == 0;
    }
}
