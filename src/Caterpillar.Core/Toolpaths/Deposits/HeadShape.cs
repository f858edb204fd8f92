namespace Caterpillar.Toolpaths;

/// <summary>
/// The underside of nozzle and head around their axis: cones between the points of an outline, from the flat of the tip outward. Distances are seen from
/// above, heights from the tip, mm.
/// </summary>
internal sealed class HeadShape
{
    private readonly double[] _radii;
    private readonly double[] _heights;

    // Radius gained for each mm of height above a point of the outline; the last has none.
    private readonly double[] _slopes;

    /// <param name="outline">Radius and height, ascending from the tip outward. The first height is 0.</param>
    /// <exception cref="ArgumentException">The outline does not start at 0 or does not ascend.</exception>
    public HeadShape(IEnumerable<(double Radius, double Height)> outline)
    {
        var points = (outline ?? throw new ArgumentNullException(nameof(outline))).ToArray();
        _radii = Array.ConvertAll(points, p => p.Radius);
        _heights = Array.ConvertAll(points, p => p.Height);
        if (points.Length == 0 || _heights[0] != 0) throw new ArgumentException("The outline of a head must begin at the tip, at height 0.", nameof(outline));
        for (var i = 1; i < points.Length; i++)
        {
            if (!(_radii[i] > _radii[i - 1]) || !(_heights[i] >= _heights[i - 1]))
                throw new ArgumentException("The radii and heights of an outline must be in ascending order.", nameof(outline));
            if (_heights[i] == 0) FlatRadius = _radii[i];
        }
        FlatRadius = Math.Max(FlatRadius, _radii[0]);
        _slopes = new double[points.Length];
        for (var i = 1; i < points.Length; i++)
        {
            if (_heights[i] > _heights[i - 1]) _slopes[i - 1] = (_radii[i] - _radii[i - 1]) / (_heights[i] - _heights[i - 1]);
        }
    }

    /// <summary>Radius of the flat of the tip.</summary>
    public double FlatRadius { get; }

    /// <summary>Reach of the head from its axis for a top <paramref name="excess"/> mm above the tip, mm. Negative if the top is not above the tip.</summary>
    public double Reach(double excess)
    {
        if (!(excess > 0)) return -1;
        var (radii, heights) = (_radii, _heights);
        var i = radii.Length - 1;
        while (i > 0 && heights[i] >= excess) i--;
        return i == radii.Length - 1 ? radii[i] : radii[i] + _slopes[i] * (excess - heights[i]);
    }

    /// <summary>Height of the underside at a distance from the axis, mm, minus 1e-9 for rounding. Infinite beyond the head.</summary>
    internal double HeightAt(double distance)
    {
        if (!(distance > _radii[0])) return 0;
        for (var i = 1; i < _radii.Length; i++)
        {
            if (distance > _radii[i]) continue;
            return _heights[i - 1] + (_heights[i] - _heights[i - 1]) * (distance - _radii[i - 1]) / (_radii[i] - _radii[i - 1]) - 1e-9;
        }
        return double.PositiveInfinity;
    }

    /// <summary>
    /// The reach from the axis of the head to the axis of an extrusion with half its width, above some height, as far as it is linear: its value for an excess
    /// of 0, its slope, and the excess at which it ends. If lenient, an extrusion next to the axis that rises by less than 45° does not count if only the flat
    /// of the tip digs into it.
    /// </summary>
    internal (double Start, double Slope, double End) PieceAbove(double excess, double half, bool lenient)
    {
        var (start, slope, end) = ConeAbove(excess);
        var wide = slope > 0 ? (3 * FlatRadius - start) / slope : start > 3 * FlatRadius ? 0 : double.PositiveInfinity;
        start += half;
        if (!lenient || wide <= excess) return (start, slope, end);
        end = Math.Min(end, wide);
        if (excess < FlatRadius) return (0, 1, Math.Min(end, FlatRadius));
        var inner = ConeAbove(excess - FlatRadius);
        inner.Start += half - inner.Slope * FlatRadius;
        end = Math.Min(Math.Min(end, inner.End + FlatRadius), Math.Min(Equal(start, slope), Equal(inner.Start, inner.Slope)));
        var middle = double.IsInfinity(end) ? excess + 1 : (excess + end) / 2;
        if (inner.Start + inner.Slope * middle > middle) return (inner.Start, inner.Slope, end);
        return start + slope * middle < middle ? (start, slope, end) : (0, 1, end);

        // Where a line is as far out as it is high.
        double Equal(double from, double gain) => from / (1 - gain) is var at && at > excess ? at : double.PositiveInfinity;
    }

    /// <summary>A linear upper bound of this reach up to some height.</summary>
    internal ReachLine LineAbove(double excess, bool lenient)
    {
        lenient &= Reach(excess) <= 3 * FlatRadius;
        if (lenient && excess <= FlatRadius) return new(0, 1, false, excess);
        var shift = lenient ? FlatRadius : 0;
        var slope = lenient ? 1 : (Reach(excess) - FlatRadius) / excess;
        var start = Reach(excess - shift) - slope * excess;
        for (var i = 0; i < _radii.Length && _heights[i] + shift < excess; i++) start = Math.Max(start, _radii[i] - slope * (_heights[i] + shift));
        return new(start, slope, true, excess);
    }

    private (double Start, double Slope, double End) ConeAbove(double excess)
    {
        var i = _radii.Length - 1;
        while (_heights[i] > excess) i--;
        return (_radii[i] - _slopes[i] * _heights[i], _slopes[i], i + 1 < _radii.Length ? _heights[i + 1] : double.PositiveInfinity);
    }
}

/// <summary>A linear bound of the reach of a head: its value at 0, its slope, whether to add half the width of an extrusion, and up to what excess.</summary>
internal readonly record struct ReachLine(double Start, double Slope, bool AddsHalf, double Most)
{
    public double At(double excess, double half) => Start + Slope * excess + (AddsHalf ? half : 0);
}
