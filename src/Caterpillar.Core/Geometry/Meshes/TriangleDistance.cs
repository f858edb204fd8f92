namespace Caterpillar.Geometry;

/// <summary>The nearest point of a triangle, by the regions of its corners, edges and face (Ericson, "Real-Time Collision Detection", section 5.1.5).</summary>
internal static class TriangleDistance
{
    /// <summary>The point and its barycentric coordinates, 0 if it is on the opposite side.</summary>
    public static (Vec3 Point, double U, double V, double W) Nearest(Vec3 p, Vec3 a, Vec3 b, Vec3 c)
    {
        Vec3 ab = b - a, ac = c - a, ap = p - a;
        double d1 = Vec3.Dot(ab, ap), d2 = Vec3.Dot(ac, ap);
        if (d1 <= 0 && d2 <= 0) return (a, 1, 0, 0);
        var bp = p - b;
        double d3 = Vec3.Dot(ab, bp), d4 = Vec3.Dot(ac, bp);
        if (d3 >= 0 && d4 <= d3) return (b, 0, 1, 0);
        var vc = d1 * d4 - d3 * d2;
        if (vc <= 0 && d1 >= 0 && d3 <= 0)
        {
            var t = d1 / (d1 - d3);
            return (a + ab * t, 1 - t, t, 0);
        }
        var cp = p - c;
        double d5 = Vec3.Dot(ab, cp), d6 = Vec3.Dot(ac, cp);
        if (d6 >= 0 && d5 <= d6) return (c, 0, 0, 1);
        var vb = d5 * d2 - d1 * d6;
        if (vb <= 0 && d2 >= 0 && d6 <= 0)
        {
            var t = d2 / (d2 - d6);
            return (a + ac * t, 1 - t, 0, t);
        }
        var va = d3 * d6 - d5 * d4;
        if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
        {
            var t = (d4 - d3) / (d4 - d3 + (d5 - d6));
            return (b + (c - b) * t, 0, 1 - t, t);
        }
        var sum = va + vb + vc;
        double v = vb / sum, w = vc / sum;
        return (a + ab * v + ac * w, 1 - v - w, v, w);
    }
}
