namespace Caterpillar.Geometry;

/// <summary>A point of a contour with its inward normal and the disc that touches there.</summary>
/// <param name="Point">mm.</param>
/// <param name="Normal">Unit vector to the inside.</param>
/// <param name="Edge">The edge it lies on; for a vertex, the one that begins there or, before the corner, the one that ends there.</param>
/// <param name="Along">How far along the edge, 0 to 1.</param>
/// <param name="Disc">The disc.</param>
internal readonly record struct BoundarySample(Vec3 Point, Vec3 Normal, int Edge, double Along, InnerDisc Disc)
{
    public Vec3 Center => Point + Normal * Disc.Radius;
}

/// <summary>
/// Points along contours, so close that the thickness between them is nearly straight; corners that point inward have a fan of normals. A disc at a vertex
/// also touches the opposite edge, which gets a sample there: between such places the thickness is exactly straight, and no more samples are needed.
/// </summary>
internal sealed class BoundarySampler
{
    private const double FanDegrees = 15;

    // mm: the longest stretch that may be even, how far from an even one its middle may be, and how near samples come to the ends of an edge.
    private const double Longest = 1;
    private const double Straightness = 0.004;
    private const double Ends = 0.005;

    // Cosine of the angle between contacts on sides that open by less than 15°.
    private const double Parallel = -0.966;

    // Below this turn (cosine), 15°, a vertex is a point of a smooth curve.
    private const double SmoothDot = 0.966;

    /// <summary>The edges of the region.</summary>
    public readonly SegmentGrid Edges = new();

    private readonly ThicknessProbe _probe;
    private readonly List<BoundarySample> _corners = [];
    private readonly List<int> _near = [];
    private double _step;
    private double _limit;
    private bool _all;
    private bool[] _wanted = [];
    private int[] _cornerStart = [];
    private int[] _touchStart = [];
    private int[] _filled = [];
    private BoundarySample[] _touches = [];

    public BoundarySampler() => _probe = new ThicknessProbe(Edges);

    /// <summary>Takes a region instead of the one before, whose memory is used again.</summary>
    /// <param name="region">The region.</param>
    /// <param name="strips">Its parts whose edges need discs; the ends of other edges have infinite ones. Null for all of it.</param>
    /// <param name="step">Distance of neighbors at uneven thickness, mm.</param>
    /// <param name="limit">Discs of this radius and above are infinite, mm.</param>
    public void Aim(Region region, Region? strips, double step, double limit)
    {
        Edges.Take(region.Paths, strips?.Bounds.Grow(2 * limit) ?? region.Bounds, limit);
        (_step, _limit, _all) = (step, limit, strips is null);
        if (strips is not null) Want(strips);
        _corners.Clear();
        Buffers.Reserve(ref _cornerStart, Edges.Count + 1);
        for (var edge = 0; edge < Edges.Count; edge++)
        {
            Corner(Edges.Previous[edge], edge);
            _cornerStart[edge + 1] = _corners.Count;
        }
        FindTouches();
    }

    /// <summary>Samples a contour once around, into a list that is cleared first.</summary>
    public void Take(int contour, List<BoundarySample> samples)
    {
        samples.Clear();
        for (var edge = Edges.ContourStart[contour]; edge < Edges.ContourStart[contour + 1]; edge++)
        {
            for (var i = _cornerStart[edge]; i < _cornerStart[edge + 1]; i++) samples.Add(_corners[i]);
            if ((_all || _wanted[edge]) && Edges.Length[edge] > 0.25 * _step) Along(edge, samples);
        }
    }

    private void Want(Region strips)
    {
        Buffers.Reserve(ref _wanted, Edges.Count);
        Array.Clear(_wanted, 0, Edges.Count);
        foreach (var strip in strips.Islands)
        {
            var box = strip.Bounds;
            Edges.Near(box.Min.X - 1e-3, box.Min.Y - 1e-3, box.Max.X + 1e-3, box.Max.Y + 1e-3, _near);
            foreach (var i in _near) _wanted[i] = true;
        }
    }

    private void Along(int edge, List<BoundarySample> samples)
    {
        // A smooth vertex has its sample already; one on the edge as near would turn over when it is moved.
        int before = Edges.Previous[edge], next = Edges.Next[edge];
        bool smoothStart = Smooth(before, edge), smoothEnd = Smooth(edge, next);
        var ends = Ends / Edges.Length[edge];
        var from = smoothStart ? _corners[_cornerStart[edge]] with { Normal = Edges.Normal[edge] } : Sample(edge, ends);
        if (!smoothStart) samples.Add(from);
        for (var i = _touchStart[edge]; i < _touchStart[edge + 1]; i++)
        {
            var touch = _touches[i];
            if (touch.Along - from.Along < 2 * ends || 1 - touch.Along < 2 * ends) continue;
            Stretch(from, touch, samples);
            samples.Add(touch);
            from = touch;
        }
        var to = smoothEnd ? _corners[_cornerStart[next]] with { Normal = Edges.Normal[edge], Edge = edge, Along = 1 } : Sample(edge, 1 - ends);
        Stretch(from, to, samples);
        if (!smoothEnd) samples.Add(to);
    }

    // What is needed between two samples of an edge.
    private void Stretch(in BoundarySample from, in BoundarySample to, List<BoundarySample> samples)
    {
        if (Linear(from.Disc, to.Disc)) return;
        var count = Math.Max(1, (int)Math.Ceiling((to.Along - from.Along) * Edges.Length[from.Edge] / Longest));
        var a = from;
        for (var k = 1; k <= count; k++)
        {
            var b = k == count ? to : Sample(from.Edge, from.Along + (to.Along - from.Along) * k / count);
            Between(a, b, samples);
            if (k < count) samples.Add(b);
            a = b;
        }
    }

    // Thick at both ends, with nothing that comes nearer in between, or both discs on the same opposite edge.
    private bool Linear(in InnerDisc a, in InnerDisc b)
    {
        if (double.IsInfinity(a.Radius) || double.IsInfinity(b.Radius)) return double.IsInfinity(a.Radius) && double.IsInfinity(b.Radius);
        if (a.Radius <= 0 || b.Radius <= 0) return false;
        if (a.Edge == b.Edge) return a.Along > 0 || b.Along > 0;
        return (a.Along == 0 && Edges.Next[b.Edge] == a.Edge) || (b.Along == 0 && Edges.Next[a.Edge] == b.Edge);
    }

    private bool Smooth(int before, int edge) => Vec3.Dot(Edges.Normal[before], Edges.Normal[edge]) > SmoothDot;

    private BoundarySample Sample(int edge, double along)
    {
        var p = Edges.Points[edge] + (Edges.Points[Edges.Next[edge]] - Edges.Points[edge]) * along;
        return new BoundarySample(p, Edges.Normal[edge], edge, along, _probe.At(p, Edges.Normal[edge], edge, edge, _limit));
    }

    private void Between(in BoundarySample from, in BoundarySample to, List<BoundarySample> samples)
    {
        if ((to.Along - from.Along) * Edges.Length[from.Edge] <= _step) return;
        var middle = Sample(from.Edge, (from.Along + to.Along) / 2);
        var straight = Even(from.Disc, middle.Disc, to.Disc);
        if (!straight) Between(from, middle, samples);
        samples.Add(middle);
        if (!straight) Between(middle, to, samples);
    }

    private static bool Even(in InnerDisc a, in InnerDisc b, in InnerDisc c)
    {
        if (double.IsInfinity(a.Radius) || double.IsInfinity(b.Radius) || double.IsInfinity(c.Radius))
            return double.IsInfinity(a.Radius) && double.IsInfinity(b.Radius) && double.IsInfinity(c.Radius);
        return Math.Max(a.Opposite, Math.Max(b.Opposite, c.Opposite)) < Parallel && Math.Abs(a.Radius + c.Radius - 2 * b.Radius) < Straightness;
    }

    private void Corner(int before, int edge)
    {
        var probed = _all || _wanted[edge] || _wanted[before];
        Vec3 v = Edges.Points[edge], m = Edges.Normal[before], n = Edges.Normal[edge];
        var dot = m.X * n.X + m.Y * n.Y;
        var cross = m.X * n.Y - m.Y * n.X;
        var wide = new InnerDisc(double.PositiveInfinity, v, edge, 0, 1);
        if (dot > SmoothDot)
        {
            var middle = m + n;
            middle /= middle.LengthXY;
            _corners.Add(new BoundarySample(v, middle, edge, 0, probed ? _probe.At(v, middle, edge, before, _limit) : wide));
        }
        else if (cross > 0)
        {
            // A corner of the outline: no disc fits into it.
            var none = probed ? new InnerDisc(0, v, edge, 0, 1) : wide;
            _corners.Add(new BoundarySample(v, m, before, 1, none));
            _corners.Add(new BoundarySample(v, n, edge, 0, none));
        }
        else
        {
            var turn = Angle.Atan2(cross, dot);
            var parts = probed ? Math.Max(1, (int)Math.Ceiling(-turn / FanDegrees)) : 1;
            for (var k = 0; k <= parts; k++)
            {
                var (sin, cos) = Angle.SinCos(turn * k / parts);
                var normal = new Vec3(m.X * cos - m.Y * sin, m.X * sin + m.Y * cos);
                var (at, along) = k == 0 ? (before, 1.0) : (edge, 0.0);
                _corners.Add(new BoundarySample(v, normal, at, along, probed ? _probe.At(v, normal, edge, before, _limit) : wide));
            }
        }
    }

    // The places where discs of vertices touch the insides of edges, by edge and along it.
    private void FindTouches()
    {
        var n = Edges.Count;
        Buffers.Reserve(ref _touchStart, n + 1);
        Buffers.Reserve(ref _filled, n);
        Array.Clear(_touchStart, 0, n + 1);
        Array.Clear(_filled, 0, n);
        foreach (var corner in _corners)
        {
            if (Touch(corner)) _touchStart[corner.Disc.Edge + 1]++;
        }
        for (var i = 0; i < n; i++) _touchStart[i + 1] += _touchStart[i];
        Buffers.Reserve(ref _touches, _touchStart[n]);
        for (var v = 0; v < n; v++)
        {
            for (var i = _cornerStart[v]; i < _cornerStart[v + 1]; i++)
            {
                var corner = _corners[i];
                if (!Touch(corner)) continue;
                var disc = corner.Disc;
                var touch = new BoundarySample(
                    disc.Contact, Edges.Normal[disc.Edge], disc.Edge, disc.Along, new InnerDisc(disc.Radius, corner.Point, v, 0, disc.Opposite));
                var at = _touchStart[disc.Edge] + _filled[disc.Edge]++;
                for (; at > _touchStart[disc.Edge] && _touches[at - 1].Along > touch.Along; at--) _touches[at] = _touches[at - 1];
                _touches[at] = touch;
            }
        }
    }

    private bool Touch(in BoundarySample corner)
        => corner.Disc.Radius > 0 && !double.IsInfinity(corner.Disc.Radius) && corner.Disc.Along > 0 && (_all || _wanted[corner.Disc.Edge]);
}
