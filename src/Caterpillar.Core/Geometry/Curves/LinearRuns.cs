namespace Caterpillar.Geometry;

/// <summary>Finds straight runs in points, of which only the ends are kept.</summary>
internal static class LinearRuns
{
    /// <summary>
    /// Adds the numbers of the points of <paramref name="points"/> from <paramref name="first"/> to <paramref name="last"/> to keep, without the first. A run
    /// grows while all its points lie within the tolerance of the chord and none goes back; runs are tried in doubling steps, so that long ones cost little.
    /// </summary>
    public static void Keep(Vec3[] points, int first, int last, double tolerance, List<int> kept)
    {
        for (var start = first; start < last;)
        {
            int good = start + 1, step = 1;
            while (good < last)
            {
                var next = good + step < last ? good + step : last;
                if (IsStraight(points, start, next, tolerance))
                {
                    good = next;
                    step *= 2;
                }
                else if (step > 1)
                {
                    step = step > 2 ? step / 4 + 1 : 1;
                    if (next == good + 1) break;
                }
                else
                {
                    break;
                }
            }
            kept.Add(good);
            start = good;
        }
    }

    /// <summary>True if the points between two others lie along the chord, in order and within the tolerance.</summary>
    private static bool IsStraight(Vec3[] points, int start, int end, double tolerance)
    {
        var from = points[start];
        var chord = points[end] - from;
        var squared = chord.LengthSquared;
        if (!(squared > 0)) return end == start + 1;
        var last = 0.0;
        for (var i = start + 1; i < end; i++)
        {
            var d = points[i] - from;
            var s = Vec3.Dot(d, chord);
            if (s < last || s > squared) return false;
            if ((d - chord * (s / squared)).LengthSquared > tolerance * tolerance) return false;
            last = s;
        }
        return true;
    }
}
