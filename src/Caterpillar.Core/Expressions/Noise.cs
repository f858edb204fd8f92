namespace Caterpillar.Expressions;

/// <summary>
/// Smooth random numbers in space: gradient noise (Perlin, "Improving noise", SIGGRAPH 2002) with a hash of the seed and the cell instead of a table, so that
/// it does not repeat. Only sums and products: the same bits on every runtime.
/// </summary>
internal static class Noise
{
    // Beyond, neighboring numbers are too far apart for a fraction.
    private const double Farthest = 1e9;

    /// <summary>A value from 0 to 1, with 0.5 on average and at integers; NaN for coordinates beyond a billion.</summary>
    public static double At(int seed, double x, double y, double z)
    {
        if (!(Math.Abs(x) <= Farthest && Math.Abs(y) <= Farthest && Math.Abs(z) <= Farthest)) return double.NaN;
        double cellX = Math.Floor(x), cellY = Math.Floor(y), cellZ = Math.Floor(z);
        long i = (long)cellX, j = (long)cellY, k = (long)cellZ;
        x -= cellX;
        y -= cellY;
        z -= cellZ;
        double u = Fade(x), v = Fade(y), w = Fade(z);
        var near = Lerp(
            Lerp(Corner(seed, i, j, k, x, y, z), Corner(seed, i + 1, j, k, x - 1, y, z), u),
            Lerp(Corner(seed, i, j + 1, k, x, y - 1, z), Corner(seed, i + 1, j + 1, k, x - 1, y - 1, z), u), v);
        if (w == 0) return ToUnit(near);
        var far = Lerp(
            Lerp(Corner(seed, i, j, k + 1, x, y, z - 1), Corner(seed, i + 1, j, k + 1, x - 1, y, z - 1), u),
            Lerp(Corner(seed, i, j + 1, k + 1, x, y - 1, z - 1), Corner(seed, i + 1, j + 1, k + 1, x - 1, y - 1, z - 1), u), v);
        return ToUnit(Lerp(near, far, w));
    }

    private static double ToUnit(double value) => Math.Max(0, Math.Min(1, 0.5 + 0.5 * value));

    private static double Fade(double t) => t * t * t * (t * (t * 6 - 15) + 10);

    private static double Lerp(double a, double b, double t) => a + t * (b - a);

    // The product of the distance with one of twelve directions, to the middles of the edges of a cube.
    private static double Corner(int seed, long i, long j, long k, double x, double y, double z)
    {
        ulong bits;
        unchecked
        {
            bits = SeededRandom.Mix((ulong)seed * 0x9E3779B97F4A7C15 + (ulong)i);
            bits = SeededRandom.Mix(bits + (ulong)j);
            bits = SeededRandom.Mix(bits + (ulong)k);
        }
        var (a, b) = (int)((bits >> 2) % 3) switch { 0 => (x, y), 1 => (x, z), _ => (y, z) };
        return ((bits & 1) == 0 ? a : -a) + ((bits & 2) == 0 ? b : -b);
    }
}
