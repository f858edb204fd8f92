namespace Caterpillar.Geometry;

/// <summary>
/// Divides a line or arc until its image under a map is smooth: until straight segments between the images of the points match it within a tolerance.
/// </summary>
internal static class SmoothDivision
{
    private const int MaxDepth = 14;

    // The image of a piece is tested at these parameters; the uneven spacing keeps periodic maps from hiding between them.
    private static readonly double[] Tests = [0.19, 0.37, 0.5, 0.68, 0.83];

    /// <summary>
    /// Appends the points after <paramref name="start"/>, the last of which is <paramref name="end"/>, and for each the share of the segment that leads to it.
    /// </summary>
    /// <param name="start">Start of the segment, mm.</param>
    /// <param name="end">End of the segment, mm.</param>
    /// <param name="arc">Its geometry if it is not straight.</param>
    /// <param name="tolerance">mm; positive.</param>
    /// <param name="map">Maps a run of points along the segment.</param>
    /// <param name="points">Receives the points, before the mapping.</param>
    /// <param name="shares">Receives the shares, whose sum is 1; null if not needed.</param>
    public static void Divide(Vec3 start, Vec3 end, Arc? arc, double tolerance, Func<Vec3[], Vec3[]> map, List<Vec3> points, List<double>? shares = null)
        => new Division(start, end, arc, tolerance, map, points, shares).Split(0, 1, 0);

    private sealed class Division(Vec3 start, Vec3 end, Arc? arc, double tolerance, Func<Vec3[], Vec3[]> map, List<Vec3> points, List<double>? shares)
    {
        public void Split(double from, double to, int depth)
        {
            if (depth < MaxDepth && !IsSmooth(from, to))
            {
                var middle = (from + to) / 2;
                Split(from, middle, depth + 1);
                Split(middle, to, depth + 1);
                return;
            }
            points.Add(to == 1 ? end : At(to));
            shares?.Add(to - from);
        }

        private bool IsSmooth(double from, double to)
        {
            var samples = new Vec3[Tests.Length + 2];
            samples[0] = At(from);
            for (var i = 0; i < Tests.Length; i++) samples[i + 1] = At(from + (to - from) * Tests[i]);
            samples[samples.Length - 1] = At(to);
            var mapped = map(samples);
            Vec3 a = mapped[0], b = mapped[mapped.Length - 1];
            for (var i = 1; i < mapped.Length - 1; i++)
            {
                // Points that are not finite are reported where the segment is mapped, not here.
                if (mapped[i].DistanceToSegment(a, b) > tolerance) return false;
            }
            return true;
        }

        private Vec3 At(double t) => Arc.PointAt(arc, start, end, t);
    }
}
