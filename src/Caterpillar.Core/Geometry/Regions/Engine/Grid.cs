namespace Caterpillar.Geometry;

/// <summary>A point on the grid of regions: 10 nm.</summary>
internal readonly record struct GridPoint(int X, int Y)
{
    public bool Equals(GridPoint other) => X == other.X && Y == other.Y;

    public override int GetHashCode() => unchecked(X * 397 ^ Y);

    public override string ToString() => $"({X}, {Y})";
}

/// <summary>The integer grid of regions. With |coordinate| ≤ 2²⁹ cross products of differences stay below 2⁶², exact in 64 bits.</summary>
internal static class Grid
{
    /// <summary>Grid units per mm.</summary>
    public const double PerMm = 100_000;

    /// <summary>Largest coordinate, in grid units.</summary>
    public const int Limit = 1 << 29;

    /// <summary>Largest coordinate, in mm.</summary>
    public const double LimitMm = Limit / PerMm;

    public static GridPoint FromMm(Vec3 p, string parameter) => new(FromMm(p.X, parameter), FromMm(p.Y, parameter));

    public static int FromMm(double mm, string parameter)
    {
        // Written so that NaN fails.
        if (!(Math.Abs(mm) <= LimitMm)) throw new ArgumentException("Coordinates of a region must be numbers within ±5368.709 mm.", parameter);
        return Round(mm * PerMm);
    }

    public static Vec3 ToMm(GridPoint p) => new(p.X / PerMm, p.Y / PerMm);

    /// <summary>Nearest integer; halves are rounded up. For values in the range of int.</summary>
    public static int Round(double value) => (int)Math.Floor(value + 0.5);

    /// <summary>Cross product of b − a and c − a: positive if c is left of the line from a to b. Exact.</summary>
    public static long Cross(GridPoint a, GridPoint b, GridPoint c)
        => ((long)b.X - a.X) * ((long)c.Y - a.Y) - ((long)b.Y - a.Y) * ((long)c.X - a.X);

    /// <summary>Length of a closed ring, in grid units.</summary>
    public static double Length(GridPoint[] ring)
    {
        var sum = 0.0;
        var a = ring[ring.Length - 1];
        foreach (var b in ring)
        {
            double dx = (double)b.X - a.X, dy = (double)b.Y - a.Y;
            sum += Math.Sqrt(dx * dx + dy * dy);
            a = b;
        }
        return sum;
    }

    /// <summary>Twice the signed area of a ring. Exact for simple rings (partial sums may wrap around, the total does not).</summary>
    public static long DoubleArea(GridPoint[] ring, int start, int count)
    {
        var sum = 0L;
        var o = ring[start];
        for (var i = start + 1; i + 1 < start + count; i++)
        {
            unchecked
            {
                sum += Cross(o, ring[i], ring[i + 1]);
            }
        }
        return sum;
    }
}
