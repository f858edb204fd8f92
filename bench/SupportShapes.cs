using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;

namespace Caterpillar.Bench;

/// <summary>Solids that hang over, for <see cref="SupportTable"/>.</summary>
internal static class SupportShapes
{
    /// <summary>Their names and meshes.</summary>
    public static IEnumerable<(string Name, TriMesh Mesh)> All()
    {
        yield return ("mushroom", TriMesh.Merge([Cone(0, 6, 20, 4), Cone(19.5, 20, 24, 22), Cone(23.5, 22, 34, 3)]));
        yield return ("table", TriMesh.Merge([Block(18, 18, 0, 24, 24, 30.5), Block(0, 0, 30, 42, 42, 33)]));
        yield return ("T", TriMesh.Merge([Block(20, 0, 0, 28, 10, 30.5), Block(0, 0, 30, 48, 10, 36)]));
        yield return ("arch", Arch());
        yield return ("branches", TriMesh.Merge([Cone(0, 6, 40, 5), .. Enumerable.Range(0, 5).Select(k => Branch(72 * k, 10 + 5 * k))]));
    }

    // A half ring on two legs, of blocks.
    private static TriMesh Arch() => TriMesh.Merge([.. Enumerable.Range(0, 36).Select(k =>
    {
        Vec3 At(double radius, int n) => new(radius * Angle.Cos(5.0 * n), 0, 10 + radius * Angle.Sin(5.0 * n));
        Vec3[] ring = [At(18, k), At(24, k), At(24, k + 1), At(18, k + 1)];
        return Hull([.. ring.Select(p => p with { Y = -5 }), .. ring.Select(p => p with { Y = 5 })]);
    }), Block(18, -5, 0, 24, 5, 10), Block(-24, -5, 0, -18, 5, 10)]);

    // A box of four corners in front and four in the back.
    private static TriMesh Hull(Vec3[] c) => TriMesh.Create(c,
        [0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6, 0, 4, 5, 0, 5, 1, 1, 5, 6, 1, 6, 2, 2, 6, 7, 2, 7, 3, 3, 7, 4, 3, 4, 0]);

    // From the stem outward, leaning by 70° from the vertical.
    private static TriMesh Branch(double direction, double z)
    {
        var (sin, cos) = Angle.SinCos(direction);
        var axis = new Vec3(cos, sin);
        var low = Circle(3, 48);
        var length = 25;
        var rise = length / (Angle.Sin(70) / Angle.Cos(70));
        return Loft(z, [.. low.Select(p => p + 1 * axis)], z + rise, [.. low.Select(p => p + (1 + length) * axis)]);
    }

    private static TriMesh Block(double x0, double y0, double z0, double x1, double y1, double z1)
        => Hull([new(x0, y0, z0), new(x1, y0, z0), new(x1, y0, z1), new(x0, y0, z1), new(x0, y1, z0), new(x1, y1, z0), new(x1, y1, z1), new(x0, y1, z1)]);

    private static TriMesh Cone(double z0, double r0, double z1, double r1) => Loft(z0, Circle(r0, 96), z1, Circle(r1, 96));

    private static Vec3[] Circle(double radius, int sides)
        => [.. Enumerable.Range(0, sides).Select(i => radius * new Vec3(Angle.Cos(360.0 * i / sides), Angle.Sin(360.0 * i / sides)))];

    private static TriMesh Loft(double z0, Vec3[] low, double z1, Vec3[] high)
    {
        var n = low.Length;
        var points = low.Select(p => p.WithZ(z0)).Concat(high.Select(p => p.WithZ(z1))).ToList();
        points.Add(low.Aggregate(Vec3.Zero, (s, p) => s + p / n).WithZ(z0));
        points.Add(high.Aggregate(Vec3.Zero, (s, p) => s + p / n).WithZ(z1));
        var triangles = new List<int>();
        for (var i = 0; i < n; i++)
        {
            var k = (i + 1) % n;
            triangles.AddRange([i, k, n + k, i, n + k, n + i, 2 * n, k, i, 2 * n + 1, n + i, n + k]);
        }
        return TriMesh.Create(points, triangles);
    }
}
