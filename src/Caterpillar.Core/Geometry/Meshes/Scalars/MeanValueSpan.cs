namespace Caterpillar.Geometry;

/// <summary>
/// The height of a surface that spans closed curves which lie over each other nowhere, by mean value coordinates in plan (Hormann and Floater, 2006): smooth,
/// it meets the curves, and spans the curves of a plane by that plane.
/// </summary>
internal sealed class MeanValueSpan
{
    private readonly double[] _x;
    private readonly double[] _y;
    private readonly double[] _z;
    private readonly int[] _next;

    // Of each curve, and the number of all vertices.
    private readonly int[] _firsts;

    /// <summary>A span of curves, of which the holes run the other way round than the outlines.</summary>
    public MeanValueSpan(IReadOnlyList<Vec3[]> curves)
    {
        var count = curves.Sum(curve => curve.Length);
        (_x, _y, _z, _next) = (new double[count], new double[count], new double[count], new int[count]);
        _firsts = new int[curves.Count + 1];
        var (at, number) = (0, 0);
        foreach (var curve in curves)
        {
            var first = at;
            foreach (var p in curve)
            {
                (_x[at], _y[at], _z[at], _next[at]) = (p.X, p.Y, p.Z, at + 1);
                at++;
            }
            _next[at - 1] = first;
            _firsts[++number] = at;
        }
    }

    /// <summary>The height over a place, also outside of the curves; NaN if there is none.</summary>
    public double Height(double x, double y)
    {
        double sum = 0, weights = 0;
        var (xs, ys, zs) = (_x, _y, _z);
        for (var curve = 0; curve + 1 < _firsts.Length; curve++)
        {
            // The end of an edge is the start of the next one.
            var last = _firsts[curve + 1] - 1;
            double ax = xs[last] - x, ay = ys[last] - y, az = zs[last];
            var a = Math.Sqrt(ax * ax + ay * ay);
            var perA = 1 / a;
            if (a < 1e-9) return az;
            for (var k = _firsts[curve]; k <= last; k++)
            {
                double bx = xs[k] - x, by = ys[k] - y, bz = zs[k];
                var b = Math.Sqrt(bx * bx + by * by);
                if (b < 1e-9) return bz;
                // The tangent of half the angle under which the edge is seen.
                double cross = ax * by - ay * bx, dot = a * b + ax * bx + ay * by;
                if (dot <= 1e-12 * a * b) return (az * b + bz * a) / (a + b);
                // One division for both.
                var shared = 1 / (dot * b);
                var (tangent, perB) = (cross * b * shared, dot * shared);
                sum += tangent * (perA * az + perB * bz);
                weights += tangent * (perA + perB);
                (ax, ay, az, a, perA) = (bx, by, bz, b, perB);
            }
        }
        return sum / weights;
    }

    /// <summary>How many turns the curves make about a place: 0 outside.</summary>
    public int Winding(double x, double y)
    {
        var turns = 0;
        for (var i = 0; i < _x.Length; i++)
        {
            var k = _next[i];
            if (_y[i] <= y == _y[k] <= y) continue;
            var side = (_x[k] - _x[i]) * (y - _y[i]) - (_y[k] - _y[i]) * (x - _x[i]);
            if (_y[i] <= y && side > 0) turns++;
            else if (_y[i] > y && side < 0) turns--;
        }
        return turns;
    }

    /// <summary>Square of the distance in plan to the nearest vertex, mm².</summary>
    public double SquareTo(double x, double y)
    {
        var least = double.PositiveInfinity;
        for (var i = 0; i < _x.Length; i++)
        {
            double dx = _x[i] - x, dy = _y[i] - y;
            least = Math.Min(least, dx * dx + dy * dy);
        }
        return least;
    }
}
