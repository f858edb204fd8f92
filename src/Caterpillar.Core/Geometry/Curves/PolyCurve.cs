namespace Caterpillar.Geometry;

/// <summary>Curves joined end to start. The parameter is the index of the piece plus the fraction of its domain. Nested polycurves are flattened.</summary>
public sealed class PolyCurve : Curve
{
    private readonly Curve[] _pieces;

    /// <param name="pieces">The curves, at least one.</param>
    /// <param name="joinTolerance">Maximum gap between the end of one piece and the start of the next, mm.</param>
    /// <exception cref="ArgumentException">There are no pieces, or a gap is larger.</exception>
    public PolyCurve(IEnumerable<Curve> pieces, double joinTolerance = 1e-3)
    {
        _pieces = (pieces ?? throw new ArgumentNullException(nameof(pieces))).SelectMany(p => p is PolyCurve poly ? poly._pieces : [p]).ToArray();
        if (_pieces.Length == 0) throw new ArgumentException("A polycurve needs at least one piece.", nameof(pieces));
        for (var i = 1; i < _pieces.Length; i++)
        {
            if (!(_pieces[i - 1].End.DistanceTo(_pieces[i].Start) <= joinTolerance))
                throw new ArgumentException($"Piece {i} does not start where the previous one ends.", nameof(pieces));
        }
    }

    /// <summary>The pieces in order. Each starts where the previous one ends.</summary>
    public IReadOnlyList<Curve> Pieces => _pieces;

    public override double DomainEnd => _pieces.Length;

    public override Bounds Bounds => _pieces.Aggregate(Bounds.Empty, (b, p) => b.Include(p.Bounds));

    public override Vec3 PointAt(double t)
    {
        t = Clamp(t);
        var i = Math.Min((int)t, _pieces.Length - 1);
        var piece = _pieces[i];
        var share = t - i;
        return piece.PointAt(share >= 1 ? piece.DomainEnd : piece.DomainStart + share * (piece.DomainEnd - piece.DomainStart));
    }

    public override Curve Transformed(Affine map) => new PolyCurve(_pieces.Select(p => p.Transformed(map)), double.MaxValue);

    internal override void AddSpans(List<CurveSpan> spans)
    {
        foreach (var piece in _pieces) piece.AddSpans(spans);
    }
}
