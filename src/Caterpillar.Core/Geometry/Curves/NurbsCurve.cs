namespace Caterpillar.Geometry;

/// <summary>
/// A rational B-spline curve of any degree, in mm. The knot vector is full (control points + degree + 1 knots), clamped or not. The domain is from knot
/// [degree] to knot [number of control points].
/// Evaluation is de Boor's algorithm in homogeneous coordinates; Bézier pieces come from its polar form (Ramshaw 1989).
/// </summary>
public sealed class NurbsCurve : Curve
{
    private const int MaxDegree = 64;

    private readonly HomogeneousPoint[] _controls;
    private readonly double[] _knots;

    /// <param name="degree">Degree, 1 to 64.</param>
    /// <param name="points">Control points in mm, not multiplied by their weights, at least degree + 1.</param>
    /// <param name="knots">Knots in ascending order: control points + degree + 1 values.</param>
    /// <param name="weights">A positive weight for each control point, or null for 1.</param>
    /// <exception cref="ArgumentException">The counts do not match, a value is not finite, the knots are not ascending, break the curve or have an empty
    /// domain, or a weight is not positive.</exception>
    public NurbsCurve(int degree, IEnumerable<Vec3> points, IEnumerable<double> knots, IEnumerable<double>? weights = null)
    {
        var controls = (points ?? throw new ArgumentNullException(nameof(points))).ToArray();
        _knots = (knots ?? throw new ArgumentNullException(nameof(knots))).ToArray();
        var w = weights?.ToArray();
        if (degree is < 1 or > MaxDegree) throw new ArgumentException("The degree must be 1 to 64.", nameof(degree));
        if (controls.Length <= degree) throw new ArgumentException("A NURBS curve needs more control points than its degree.", nameof(points));
        if (_knots.Length != controls.Length + degree + 1)
            throw new ArgumentException($"{controls.Length} control points of degree {degree} need {controls.Length + degree + 1} knots, not {_knots.Length}.",
                nameof(knots));
        if (w is not null && w.Length != controls.Length) throw new ArgumentException("Every control point needs a weight.", nameof(weights));
        for (var i = 0; i < _knots.Length; i++)
        {
            if (double.IsNaN(_knots[i] - _knots[i]) || (i > 0 && _knots[i] < _knots[i - 1]))
                throw new ArgumentException("Knots must be finite and ascending.", nameof(knots));
        }
        if (!(_knots[degree] < _knots[controls.Length])) throw new ArgumentException("The domain of the knots is empty.", nameof(knots));
        for (var i = degree + 1; i + degree < controls.Length; i++)
        {
            if (_knots[i] == _knots[i + degree] && _knots[i] > _knots[degree] && _knots[i] < _knots[controls.Length])
                throw new ArgumentException("An inner knot that repeats more often than the degree breaks the curve.", nameof(knots));
        }
        _controls = new HomogeneousPoint[controls.Length];
        for (var i = 0; i < controls.Length; i++)
        {
            var weight = w is null ? 1 : w[i];
            if (!(weight > 0) || double.IsInfinity(weight)) throw new ArgumentException("Weights must be positive.", nameof(weights));
            _controls[i] = HomogeneousPoint.Of(Finite(controls[i], nameof(points)), weight);
        }
        Degree = degree;
    }

    private NurbsCurve(int degree, HomogeneousPoint[] controls, double[] knots) => (Degree, _controls, _knots) = (degree, controls, knots);

    /// <summary>Degree of the curve.</summary>
    public int Degree { get; }

    /// <summary>Control points in mm, not multiplied by their weights.</summary>
    public IReadOnlyList<Vec3> ControlPoints => Array.ConvertAll(_controls, c => c.Point);

    /// <summary>Weights of the control points.</summary>
    public IReadOnlyList<double> Weights => Array.ConvertAll(_controls, c => c.Weight);

    /// <summary>Knots in ascending order: control points + degree + 1 values.</summary>
    public IReadOnlyList<double> Knots => (double[])_knots.Clone();

    public override double DomainStart => _knots[Degree];

    public override double DomainEnd => _knots[_controls.Length];

    public override Bounds Bounds
    {
        get
        {
            var bounds = Bounds.Empty;
            foreach (var span in Spans()) bounds = bounds.Include(span.Bezier!.Hull);
            return bounds.IsEmpty ? bounds.Include(Start) : bounds;
        }
    }

    /// <summary>A clamped curve with uniform inner knots.</summary>
    /// <inheritdoc cref="NurbsCurve(int, IEnumerable{Vec3}, IEnumerable{double}, IEnumerable{double}?)" path="/exception"/>
    public static NurbsCurve Clamped(int degree, IReadOnlyList<Vec3> points, IReadOnlyList<double>? weights = null)
    {
        if (points is null) throw new ArgumentNullException(nameof(points));
        var knots = new double[points.Count + degree + 1];
        for (var i = 0; i < knots.Length; i++) knots[i] = Math.Min(Math.Max(0, i - degree), Math.Max(1, points.Count - degree));
        return new NurbsCurve(degree, points, knots, weights);
    }

    /// <summary>A smooth closed curve with uniform knots. The first point is not repeated.</summary>
    /// <inheritdoc cref="NurbsCurve(int, IEnumerable{Vec3}, IEnumerable{double}, IEnumerable{double}?)" path="/exception"/>
    public static NurbsCurve Periodic(int degree, IReadOnlyList<Vec3> points, IReadOnlyList<double>? weights = null)
    {
        if (points is null) throw new ArgumentNullException(nameof(points));
        if (points.Count < 3 || degree < 1) throw new ArgumentException("A periodic curve needs three control points.", nameof(points));
        var count = points.Count + degree;
        var knots = Enumerable.Range(-degree, count + degree + 1).Select(i => (double)i);
        return new NurbsCurve(degree, Enumerable.Range(0, count).Select(i => points[i % points.Count]), knots,
            weights is null ? null : Enumerable.Range(0, count).Select(i => weights[i % weights.Count]));
    }

    public override Vec3 PointAt(double t)
    {
        t = Clamp(t);
        var work = new HomogeneousPoint[Degree + 1];
        Polar(SpanOf(t), (_, _) => t, work);
        return work[Degree].Point;
    }

    public override Curve Transformed(Affine map)
        => new NurbsCurve(Degree, Array.ConvertAll(_controls, c => HomogeneousPoint.Of(map.Apply(c.Point), c.Weight)), _knots);

    internal override void AddSpans(List<CurveSpan> spans)
    {
        for (var span = Degree; span < _controls.Length; span++)
        {
            if (!(_knots[span] < _knots[span + 1])) continue;
            var piece = Piece(span);
            if (!piece.IsPoint) spans.Add(CurveSpan.Of(piece));
        }
    }

    private BezierSpan Piece(int span)
    {
        var (a, b) = (_knots[span], _knots[span + 1]);
        var work = new HomogeneousPoint[Degree + 1];
        var controls = new HomogeneousPoint[Degree + 1];
        for (var i = 0; i <= Degree; i++)
        {
            var ends = i;
            Polar(span, (r, p) => r <= p - ends ? a : b, work);
            controls[i] = work[Degree];
        }
        return new BezierSpan(controls);
    }

    // de Boor's algorithm with an argument for each level; work[degree] holds the value.
    private void Polar(int span, Func<int, int, double> argument, HomogeneousPoint[] work)
    {
        var p = Degree;
        Array.Copy(_controls, span - p, work, 0, p + 1);
        for (var r = 1; r <= p; r++)
        {
            var t = argument(r, p);
            for (var k = p; k >= r; k--)
            {
                var i = span - p + k;
                var low = _knots[i];
                work[k] = HomogeneousPoint.Mix(work[k - 1], work[k], (t - low) / (_knots[i + p - r + 1] - low));
            }
        }
    }

    // The number of the non-empty knot span that holds t.
    private int SpanOf(double t)
    {
        var low = Search.First(Degree + 1, _controls.Length, (_knots, t), static (s, i) => s._knots[i] > s.t) - 1;
        while (low > Degree && !(_knots[low] < _knots[low + 1])) low--;
        return low;
    }
}
