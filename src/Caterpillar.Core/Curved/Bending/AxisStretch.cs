namespace Caterpillar.Curved;

/// <summary>
/// Positions along an axis, stretched so that their distances are those along a surface: the integral of a stretch that is linear between even nodes, and
/// goes on beyond them.
/// </summary>
internal sealed class AxisStretch
{
    private readonly double _from;
    private readonly double _step;
    private readonly double[] _stretch;

    // The stretched positions of the nodes.
    private readonly double[] _at;

    /// <summary>A stretch that keeps one position.</summary>
    public AxisStretch(double from, double step, double[] stretch, double kept)
    {
        _from = from;
        _step = step;
        _stretch = stretch;
        _at = new double[stretch.Length];
        for (var i = 1; i < _at.Length; i++) _at[i] = _at[i - 1] + step * (stretch[i - 1] + stretch[i]) / 2;
        var shift = kept - At(kept).To;
        for (var i = 0; i < _at.Length; i++) _at[i] += shift;
    }

    /// <summary>The stretched position, and how much lengths grow there.</summary>
    public (double To, double Stretch) At(double u)
    {
        var i = (int)Math.Min(Math.Max((u - _from) / _step, 0), _at.Length - 1);
        var d = u - _from - i * _step;
        if (d < 0 || i == _at.Length - 1) return (_at[i] + d * _stretch[i], _stretch[i]);
        var more = (_stretch[i + 1] - _stretch[i]) * d / _step;
        return (_at[i] + d * (_stretch[i] + more / 2), _stretch[i] + more);
    }
}
