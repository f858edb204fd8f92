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

    /// <summary>An upper bound of this reach up to some height.</summary>
    internal double Reach(double excess, double half, bool lenient)
        => lenient && Reach(excess) <= 3 * FlatRadius ? Math.Max(excess, Reach(excess - FlatRadius) + half) : Reach(excess) + half;

    /// <summary>
    /// How high the tip may be above a plane that rises by so much for each mm, while the head reaches to the axis of an extrusion on it, mm. Extrusions are at
    /// most so many mm above the tip, and half of their width is given.
    /// </summary>
    internal double Depth(double rise, double half, double most, bool lenient)
    {
        var wide = lenient ? Math.Min(most, HeightAt(3 * FlatRadius)) : 0;
        var depth = lenient ? Math.Max(0, (rise - 1) * wide) : double.NegativeInfinity;
        if (wide > FlatRadius) depth = Math.Max(depth, Depth(rise, 0, wide - FlatRadius) - FlatRadius + rise * half);
        return most > wide ? Math.Max(depth, Depth(rise, wide, most) + rise * half) : depth;
    }

    // The same for extrusions without a width, so many mm above the tip: linear between the points of the outline.
    private double Depth(double rise, double least, double most)
    {
        var depth = Math.Max(rise * Reach(least) - least, rise * Reach(most) - most);
        for (var i = 0; i < _radii.Length && _heights[i] < most; i++)
        {
            if (_heights[i] >= least) depth = Math.Max(depth, rise * _radii[i] - _heights[i]);
        }
        return depth;
    }

    private (double Start, double Slope, double End) ConeAbove(double excess)
    {
        var i = _radii.Length - 1;
        while (_heights[i] > excess) i--;
        return (_radii[i] - _slopes[i] * _heights[i], _slopes[i], i + 1 < _radii.Length ? _heights[i + 1] : double.PositiveInfinity);
    }
}
