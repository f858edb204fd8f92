namespace Caterpillar.Geometry;

/// <summary>
/// Length along a curve, and the inverse. Straight parts and arcs are exact; others are integrated by ten-point Gauss–Legendre quadrature on intervals that are
/// halved until halving changes nothing beyond the tolerance.
/// </summary>
internal sealed class ArcLength
{
    /// <summary>Tolerance of one interval: 1e-10 mm plus 1e-12 of its length.</summary>
    private const double AbsoluteTolerance = 1e-10;

    private const double RelativeTolerance = 1e-12;
    private const int MaxDepth = 24;

    private static readonly double[] Nodes =
        [0.14887433898163122, 0.43339539412924719, 0.67940956829902441, 0.86506336668898451, 0.97390652851717172];

    private static readonly double[] Weights =
        [0.29552422471475287, 0.26926671930999636, 0.21908636251598204, 0.14945134915058059, 0.06667134430868814];

    private readonly List<Leaf> _leaves = [];

    /// <param name="spans">The spans of a curve, in order.</param>
    public ArcLength(List<CurveSpan> spans)
    {
        Spans = spans;
        for (var i = 0; i < spans.Count; i++)
        {
            if (spans[i].IsEven) Add(i, 0, 1, spans[i].EvenLength);
            else Refine(i, 0, 1, Integral(spans[i], 0, 1), 0);
        }
    }

    /// <summary>Length of the whole curve, mm.</summary>
    public double Total { get; private set; }

    public List<CurveSpan> Spans { get; }

    public int LeafCount => _leaves.Count;

    /// <summary>One of the intervals, in order.</summary>
    public Leaf LeafAt(int index) => _leaves[index];

    /// <summary>The leaf, and the u of its span, at a length from the start.</summary>
    public (int Leaf, double U) Locate(double length)
    {
        var low = Search.First(1, _leaves.Count, (_leaves, length), static (s, i) => s._leaves[i].Start > s.length) - 1;
        var leaf = _leaves[low];
        var target = length - leaf.Start;
        if (!(target > 0)) return (low, leaf.From);
        if (target >= leaf.Length) return (low, leaf.To);
        var share = target / leaf.Length;
        if (Spans[leaf.Span].IsEven) return (low, leaf.From + (leaf.To - leaf.From) * share);
        return (low, Invert(Spans[leaf.Span], leaf, target, share));
    }

    // Newton's method, kept inside a shrinking bracket.
    private static double Invert(CurveSpan span, Leaf leaf, double target, double share)
    {
        double low = leaf.From, high = leaf.To;
        var u = low + (high - low) * share;
        for (var i = 0; i < 60; i++)
        {
            var miss = Integral(span, leaf.From, u) - target;
            if (Math.Abs(miss) <= 1e-12 * (1 + leaf.Length)) break;
            if (miss > 0) high = u;
            else low = u;
            var speed = span.Derivatives(u).First.Length;
            var next = speed > 0 ? u - miss / speed : double.NaN;
            u = next > low && next < high ? next : 0.5 * (low + high);
        }
        return u;
    }

    private void Refine(int span, double a, double b, double whole, int depth)
    {
        var middle = 0.5 * (a + b);
        var left = Integral(Spans[span], a, middle);
        var right = Integral(Spans[span], middle, b);
        var change = Math.Abs(left + right - whole);
        if (change <= AbsoluteTolerance + RelativeTolerance * whole || depth == MaxDepth)
        {
            Add(span, a, middle, left);
            Add(span, middle, b, right);
            return;
        }
        Refine(span, a, middle, left, depth + 1);
        Refine(span, middle, b, right, depth + 1);
    }

    private void Add(int span, double a, double b, double length)
    {
        _leaves.Add(new Leaf(span, a, b, Total, length));
        Total += length;
    }

    private static double Integral(CurveSpan span, double a, double b)
    {
        var half = 0.5 * (b - a);
        var middle = 0.5 * (a + b);
        var sum = 0.0;
        for (var i = 0; i < Nodes.Length; i++)
        {
            var d = half * Nodes[i];
            sum += Weights[i] * (span.Derivatives(middle - d).First.Length + span.Derivatives(middle + d).First.Length);
        }
        return sum * half;
    }

    /// <summary>An interval from one u of a span to another, with the length of the curve up to its start and its own, mm.</summary>
    public readonly record struct Leaf(int Span, double From, double To, double Start, double Length);
}
