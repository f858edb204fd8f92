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
        var shift = kept - At(kept);
        for (var i = 0; i < _at.Length; i++) _at[i] += shift;
    }

    /// <summary>The stretched position.</summary>
    public double At(double u)
    {
        var i = (int)Math.Min(Math.Max((u - _from) / _step, 0), _at.Length - 1);
        var d = u - _from - i * _step;
        if (d < 0 || i == _at.Length - 1) return _at[i] + d * _stretch[i];
        return _at[i] + d * (_stretch[i] + (_stretch[i + 1] - _stretch[i]) * d / _step / 2);
    }

    /// <summary>The position that the stretch at a share between two with the same nodes moves to a place, and how much lengths grow there.</summary>
    public static (double From, double Stretch) Inverse(AxisStretch a, AxisStretch b, double t, double to)
    {
        var last = a._at.Length - 1;
        double first = Node(0), end = Node(last);
        var i = (int)Math.Min(Math.Max((to - first) / (end - first) * last, 0), last - 1);
        while (i > 0 && Node(i) > to) i--;
        while (i < last - 1 && Node(i + 1) < to) i++;
        double rest = to - Node(i), stretch = StretchAt(i);
        if (rest < 0) return (a._from + rest / stretch, stretch);
        if (to > end) return (a._from + last * a._step + (to - end) / StretchAt(last), StretchAt(last));
        // Where stretches are linear, their squares are linear in the stretched position.
        var there = Math.Sqrt(stretch * stretch + 2 * (StretchAt(i + 1) - stretch) / a._step * rest);
        return (a._from + i * a._step + 2 * rest / (stretch + there), there);

        double Node(int k) => a._at[k] + (b._at[k] - a._at[k]) * t;

        double StretchAt(int k) => a._stretch[k] + (b._stretch[k] - a._stretch[k]) * t;
    }
}
