namespace Caterpillar.Toolpaths;

/// <summary>Segments seen from above.</summary>
internal static class FlatSegment
{
    /// <summary>The part between two values of y, as a span of x.</summary>
    public static bool RowSpan(Vec3 a, Vec3 b, double low, double high, out double x0, out double x1)
    {
        x0 = Math.Min(a.X, b.X);
        x1 = Math.Max(a.X, b.X);
        var dy = b.Y - a.Y;
        if (dy == 0) return a.Y >= low && a.Y <= high;
        var t0 = Math.Max(0, Math.Min((low - a.Y) / dy, (high - a.Y) / dy));
        var t1 = Math.Min(1, Math.Max((low - a.Y) / dy, (high - a.Y) / dy));
        if (t0 > t1) return false;
        var u = a.X + (b.X - a.X) * t0;
        var v = a.X + (b.X - a.X) * t1;
        x0 = Math.Max(x0, Math.Min(u, v));
        x1 = Math.Min(x1, Math.Max(u, v));
        return true;
    }

    /// <summary>Keeps the parameters t with start + step * t from min to max. False if none are left.</summary>
    public static bool Slab(double start, double step, double min, double max, ref double low, ref double high)
    {
        if (step == 0) return start >= min && start <= max;
        var t0 = (min - start) / step;
        var t1 = (max - start) / step;
        low = Math.Max(low, Math.Min(t0, t1));
        high = Math.Min(high, Math.Max(t0, t1));
        return low <= high;
    }

    /// <summary>Parameter from 0 to 1 of the point nearest to another.</summary>
    public static double Parameter(Vec3 p, Vec3 a, Vec3 b)
    {
        double dx = b.X - a.X, dy = b.Y - a.Y;
        var square = dx * dx + dy * dy;
        return square > 0 ? Math.Min(1, Math.Max(0, ((p.X - a.X) * dx + (p.Y - a.Y) * dy) / square)) : 0;
    }

    /// <summary>Square of the distance of a point, mm².</summary>
    public static double SquareDistance(Vec3 p, Vec3 a, Vec3 b)
    {
        var t = Parameter(p, a, b);
        double x = p.X - a.X - (b.X - a.X) * t, y = p.Y - a.Y - (b.Y - a.Y) * t;
        return x * x + y * y;
    }
}
