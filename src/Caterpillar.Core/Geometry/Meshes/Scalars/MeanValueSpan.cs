namespace Caterpillar.Geometry;

/// <summary>
/// The height of a surface that spans closed curves which lie over each other nowhere, by mean value coordinates in plan (Hormann and Floater, 2006): smooth,
/// it meets the curves, and spans the curves of a plane by that plane.
/// </summary>
/// <param name="curves">The curves, of which the holes run the other way round than the outlines.</param>
internal sealed class MeanValueSpan(IReadOnlyList<Vec3[]> curves)
{
    /// <summary>The height over a place, also outside of the curves; NaN if there is none.</summary>
    public double Height(double x, double y)
    {
        double sum = 0, weights = 0;
        foreach (var curve in curves)
        {
            // The end of an edge is the start of the next one.
            var last = curve[curve.Length - 1];
            double ax = last.X - x, ay = last.Y - y, az = last.Z;
            var a = Math.Sqrt(ax * ax + ay * ay);
            var perA = 1 / a;
            if (a < 1e-9) return az;
            for (var k = 0; k < curve.Length; k++)
            {
                double bx = curve[k].X - x, by = curve[k].Y - y, bz = curve[k].Z;
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
}
