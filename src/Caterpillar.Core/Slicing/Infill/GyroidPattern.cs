namespace Caterpillar.Slicing;

/// <summary>
/// Plane sections of sin x cos y + sin y cos z + sin z cos x = 0 (Schoen 1970). At each height the section is two families of waves, along y = φ ± acos(c)
/// where |sin z| ≤ |cos z| and along x otherwise, so one period is computed and repeated.
/// </summary>
internal static class GyroidPattern
{
    /// <summary>Length of all sections per area, times the period; the mean over a period of heights.</summary>
    public const double MeanLength = 2.4586;

    public static List<Polyline> Waves(InfillRequest request)
    {
        var period = MeanLength * request.Spacing;
        var (sin, cos) = Angle.SinCos(request.Z / period % 1 * 360);
        // Along u, or, with the roles of the axes exchanged, along v.
        var exchanged = Math.Abs(sin) > Math.Abs(cos);
        var frame = new PatternFrame(request.Area, request.Angle);
        var (minAlong, maxAlong, minAcross, maxAcross) = exchanged
            ? (frame.MinV, frame.MaxV, frame.MinU, frame.MaxU)
            : (frame.MinU, frame.MaxU, frame.MinV, frame.MaxV);
        var waves = new List<Polyline>();
        long first = (long)Math.Floor(minAlong / period), last = (long)Math.Floor(maxAlong / period);
        for (var branch = -1; branch <= 1; branch += 2)
        {
            var wave = Period(sin, cos, exchanged, branch, period, request.Chords);
            double low = double.PositiveInfinity, high = double.NegativeInfinity;
            foreach (var p in wave)
            {
                low = Math.Min(low, p.Across);
                high = Math.Max(high, p.Across);
            }
            for (var row = (long)Math.Ceiling((minAcross - high) / period); row * period + low <= maxAcross; row++)
            {
                var points = new Vec3[(last - first + 1) * (wave.Count - 1) + 1];
                var n = 0;
                for (var k = first; k <= last; k++)
                {
                    // The last place of a period is the first of the next.
                    for (var i = 0; i < (k == last ? wave.Count : wave.Count - 1); i++)
                    {
                        double along = wave[i].Along + k * period, across = wave[i].Across + row * period;
                        points[n++] = exchanged ? frame.At(across, along) : frame.At(along, across);
                    }
                }
                waves.Add(Polyline.Own(points, closed: false));
            }
        }
        return waves;
    }

    // One period of a branch, subdivided until chords lie within the tolerance.
    private static List<(double Along, double Across)> Period(double sin, double cos, bool exchanged, int branch, double period, double chords)
    {
        const int Pieces = 8;
        var wave = new List<(double Along, double Across)> { (0, Across(0)) };
        for (var i = 0; i < Pieces; i++)
        {
            double from = 360.0 * i / Pieces, to = 360.0 * (i + 1) / Pieces;
            Divide(from, Across(from), to, Across(to), 6);
        }
        return wave;

        double Across(double along)
        {
            var (s, c) = Angle.SinCos(along);
            var (a, b, d) = exchanged ? (sin, c, -s * cos) : (s, cos, -c * sin);
            // The direction of (a, b) must not pass ±180° within a period.
            if (exchanged && sin < 0) (a, b, d) = (-a, -b, -d);
            var ratio = Math.Min(Math.Max(d / Math.Sqrt(a * a + b * b), -1), 1);
            return (Angle.Atan2(b, a) + branch * Angle.Atan2(Math.Sqrt(1 - ratio * ratio), ratio)) / 360 * period;
        }

        void Divide(double from, double start, double to, double end, int depth)
        {
            double middle = (from + to) / 2, across = Across(middle);
            double run = (to - from) / 360 * period, rise = end - start;
            var off = Math.Abs(across - (start + end) / 2) * run / Math.Sqrt(run * run + rise * rise);
            if (off > chords && depth > 0)
            {
                Divide(from, start, middle, across, depth - 1);
                Divide(middle, across, to, end, depth - 1);
                return;
            }
            wave.Add((to / 360 * period, end));
        }
    }
}
