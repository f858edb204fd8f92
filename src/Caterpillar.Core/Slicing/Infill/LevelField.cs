namespace Caterpillar.Slicing;

/// <summary>A formula over the area of one layer, and its zeros between two points.</summary>
internal sealed class LevelField
{
    private readonly Formula _formula;
    private readonly FormulaContext _context;
    private readonly double[] _values;

    public LevelField(InfillRequest request)
    {
        _formula = request.Formula ?? throw new ArgumentException("The formula is missing.", nameof(request));
        _values = [0, 0, request.Z, request.Layer, request.Spacing, request.Width];
        if (_formula.Variables.Count > _values.Length) throw new ArgumentException("The formula has too many variables for an infill.", nameof(request));
        _context = new FormulaContext(_values);
        Tolerance = request.Tolerance;
    }

    /// <summary>Maximum deviation of lines from the curve, mm.</summary>
    public double Tolerance { get; }

    public double At(double x, double y)
    {
        _values[0] = x;
        _values[1] = y;
        return _formula.Evaluate(_context);
    }

    /// <summary>The zero between two places of different sign, by regula falsi with halved weights (Illinois); false at a pole.</summary>
    public bool Zero(Vec3 a, double fa, Vec3 b, double fb, out Vec3 zero)
    {
        double low = 0, high = 1, start = fa, end = fb, most = Math.Max(Math.Abs(fa), Math.Abs(fb));
        // An end may be the pole itself.
        if (double.IsInfinity(most)) most = Math.Min(Math.Abs(fa), Math.Abs(fb));
        var close = Tolerance / 20 / Math.Max(a.DistanceTo(b), 1e-12);
        var side = 0;
        double t = 0.5, f = 0;
        for (var i = 0; i < 60 && high - low > close; i++)
        {
            // Every fourth step halves, for functions that jump.
            t = i % 4 == 3 ? (low + high) / 2 : (low * end - high * start) / (end - start);
            if (!(t > low && t < high)) t = (low + high) / 2;
            var p = Vec3.Lerp(a, b, t);
            f = At(p.X, p.Y);
            if (double.IsNaN(f)) break;
            if (f >= 0 == fb >= 0)
            {
                if (high - t < close / 4 && i > 3) low = Math.Max(low, t - close);
                (high, end) = (t, f);
                if (side == 1) start /= 2;
                side = 1;
            }
            else
            {
                (low, start) = (t, f);
                if (side == -1) end /= 2;
                side = -1;
            }
            if (Math.Abs(f) <= 1e-12 * most) break;
        }
        zero = Vec3.Lerp(a, b, t);
        return Math.Abs(f) <= most;
    }

    /// <summary>The place of the curve next to the middle of a chord, on its bisector; false where none is found within half the chord.</summary>
    public bool Bulge(Vec3 a, Vec3 b, out Vec3 place, out double distance)
    {
        var chord = b - a;
        var length = chord.LengthXY;
        var middle = Vec3.Lerp(a, b, 0.5);
        var normal = new Vec3(-chord.Y, chord.X) / length;
        double t0 = 0, f0 = At(middle.X, middle.Y), t1 = length / 16;
        (place, distance) = (middle, 0);
        if (f0 == 0) return true;
        for (var i = 0; i < 12; i++)
        {
            place = middle + normal * t1;
            var f1 = At(place.X, place.Y);
            if (f1 == f0 || double.IsNaN(f1)) return false;
            var t2 = t1 - f1 * (t1 - t0) / (f1 - f0);
            if (!(Math.Abs(t2) <= length / 2)) return false;
            (t0, f0, t1) = (t1, f1, t2);
            if (Math.Abs(t1 - t0) > Tolerance / 20) continue;
            place = middle + normal * t1;
            distance = Math.Abs(t1);
            return true;
        }
        return false;
    }
}
