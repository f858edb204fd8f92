namespace Caterpillar.Curved;

/// <summary>
/// The walls of a surface: its level curves, each as high as its distance from the wall below, measured along the surface. Where levels are too far apart there
/// are more of them, at halves, quarters and so on; where they are too close, only every second wall is printed, or every fourth.
/// </summary>
internal sealed class SheetWalls
{
    private const int MostHalvings = 6;

    // Distance of the points at which walls are looked at, mm.
    private const double Step = 1;
    private readonly SheetField _field;
    private readonly double _usual;
    private readonly double _least;
    private readonly double _most;
    private readonly double[] _levels;
    private readonly LevelCurves _curves;

    /// <param name="field">The surface and its layers.</param>
    /// <param name="least">Least height of a wall, mm.</param>
    /// <param name="most">Greatest height of a wall, mm.</param>
    public SheetWalls(SheetField field, double least, double most)
    {
        (_field, _least, _most) = (field, least, most);
        _usual = field.Levels[field.Levels.Length - 1] - field.Levels[field.Levels.Length - 2];
        _levels = Divided(field.Levels, 1 << MostHalvings);
        // The upper boundary may be whole faces.
        var inside = (double[])_levels.Clone();
        inside[inside.Length - 1] -= 1e-6 * _usual;
        var strides = field.Slopes.Select(Stride).ToArray();
        var corners = field.Mesh.RawTriangles;
        _curves = new LevelCurves(field.Mesh, field.Values, inside, (t, level)
            => level % strides[corners[t]] == 0 || level % strides[corners[t + 1]] == 0 || level % strides[corners[t + 2]] == 0);
    }

    /// <summary>Number of levels. Level 0 is the lower boundary.</summary>
    public int Count => _levels.Length;

    /// <summary>Value of a level.</summary>
    public double Level(int level) => _levels[level];

    /// <summary>True for levels of the first layer.</summary>
    public static bool IsFirst(int level) => level <= 1 << MostHalvings;

    /// <summary>The curves of a level. Closed ones do not repeat their first point. Any thread.</summary>
    /// <param name="level">From 1.</param>
    /// <param name="tolerance">mm.</param>
    public IEnumerable<(IReadOnlyList<SheetPoint> Points, bool IsClosed)> Curves(int level, double tolerance)
    {
        foreach (var curve in _curves.Trace(level, tolerance))
        {
            var points = new List<SheetPoint>();
            for (var i = 0; i < curve.SegmentCount; i++)
            {
                Vec3 from = curve[i], to = curve[(i + 1) % curve.Count];
                var parts = (int)Math.Ceiling(from.DistanceTo(to) / Step);
                for (var k = 0; k < parts; k++) points.Add(At(Vec3.Lerp(from, to, (double)k / parts), level));
            }
            if (!curve.IsClosed) points.Add(At(curve[curve.Count - 1], level));
            yield return (points, curve.IsClosed);
        }
    }

    /// <summary>A point of a level.</summary>
    public SheetPoint At(Vec3 point, int level)
    {
        var slope = _field.Slope(point);
        return new SheetPoint(point, level % Stride(slope.Slope) == 0 ? Height(point, slope, level) : 0);
    }

    // Where values change so fast, one of so many levels is printed.
    private int Stride(double slope)
    {
        var stride = 1 << MostHalvings;
        var height = _usual / slope;
        for (; stride > 1 && height > _most; stride /= 2) height /= 2;
        for (; stride < 1 << (2 * MostHalvings) && height < _least; stride *= 2) height *= 2;
        return stride;
    }

    // Down along the surface to the next wall that is printed, or to the lower boundary.
    private double Height(Vec3 point, (Vec3 Direction, double Slope) slope, int level)
    {
        var height = 0.0;
        while (true)
        {
            var stride = Stride(slope.Slope);
            var next = (level - 1) / stride * stride;
            var step = Distance(point, slope, level, next, out var below);
            // Where walls come closer, one may be printed in between.
            while (level - next > 1 && Stride(below.Slope) < level - next)
            {
                next = level - (level - next) / 2;
                step = Distance(point, slope, level, next, out below);
            }
            height += step;
            if (next == 0 || next % Stride(below.Slope) == 0) return height;
            point -= slope.Direction * step;
            (slope, level) = (below, next);
        }
    }

    // Along the surface from one level to a lower one.
    private double Distance(Vec3 point, (Vec3 Direction, double Slope) slope, int level, int lower, out (Vec3 Direction, double Slope) below)
    {
        var change = _levels[level] - _levels[lower];
        below = _field.Slope(point - slope.Direction * Math.Min(change / slope.Slope, 4 * _most));
        return Math.Min(2 * change / (slope.Slope + below.Slope), 4 * _most);
    }

    private static double[] Divided(double[] levels, int parts)
    {
        var result = new double[(levels.Length - 1) * parts + 1];
        for (var i = 0; i < result.Length; i++)
        {
            var (whole, part) = (i / parts, i % parts);
            result[i] = part == 0 ? levels[whole] : levels[whole] + (levels[whole + 1] - levels[whole]) * part / parts;
        }
        return result;
    }
}

/// <summary>A point of a wall, and its height there.</summary>
/// <param name="Point">mm.</param>
/// <param name="Height">mm; 0 = nothing is printed.</param>
internal readonly record struct SheetPoint(Vec3 Point, double Height);
