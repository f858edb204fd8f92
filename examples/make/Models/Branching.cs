using System.Collections.Generic;
using Caterpillar.Geometry;

namespace Caterpillar.Examples;

/// <summary>
/// A trunk that splits into two branches, mm. Sections are Cassini ovals whose foci move apart with the height. The model is bent, so that the ends of the
/// branches fall outward. It is polygonized on tetrahedra.
/// </summary>
internal static class Branching
{
    private const double Cell = 2;
    private const int Wide = 24;
    private const int Deep = 13;
    private const int High = 32;

    public static TriMesh Make()
    {
        var points = new List<Vec3>();
        var triangles = new List<int>();
        for (var k = -1; k <= High; k++)
        {
            for (var j = -Deep; j < Deep; j++)
            {
                for (var i = -Wide; i < Wide; i++) Cube(i, j, k, points, triangles);
            }
        }
        return TriMesh.Create(points, triangles);
    }

    private static void Cube(int i, int j, int k, List<Vec3> points, List<int> triangles)
    {
        // Six tetrahedra around the diagonal.
        (int X, int Y, int Z)[] corners =
            [(i, j, k), (i + 1, j, k), (i + 1, j + 1, k), (i, j + 1, k), (i, j, k + 1), (i + 1, j, k + 1), (i + 1, j + 1, k + 1), (i, j + 1, k + 1)];
        int[] around = [1, 2, 3, 7, 4, 5, 1];
        for (var n = 0; n < 6; n++) Tetrahedron([corners[0], corners[around[n]], corners[around[n + 1]], corners[6]], points, triangles);
    }

    private static void Tetrahedron((int X, int Y, int Z)[] nodes, List<Vec3> points, List<int> triangles)
    {
        var inside = new List<(int X, int Y, int Z)>();
        var outside = new List<(int X, int Y, int Z)>();
        foreach (var node in nodes) (Value(node) < 0 ? inside : outside).Add(node);
        if (inside.Count is 0 or 4) return;
        var outward = Middle(outside) - Middle(inside);
        if (inside.Count == 1) Add(Cross(inside[0], outside[0]), Cross(inside[0], outside[1]), Cross(inside[0], outside[2]));
        if (inside.Count == 3) Add(Cross(inside[0], outside[0]), Cross(inside[1], outside[0]), Cross(inside[2], outside[0]));
        if (inside.Count == 2)
        {
            Vec3 a = Cross(inside[0], outside[0]), b = Cross(inside[0], outside[1]), c = Cross(inside[1], outside[1]), d = Cross(inside[1], outside[0]);
            Add(a, b, c);
            Add(a, c, d);
        }

        void Add(Vec3 a, Vec3 b, Vec3 c)
        {
            if (a == b || b == c || c == a) return;
            var faces = Vec3.Dot(Vec3.Cross(b - a, c - a), outward) > 0;
            var first = points.Count;
            points.AddRange([Bent(a), Bent(b), Bent(c)]);
            triangles.AddRange(faces ? [first, first + 1, first + 2] : [first, first + 2, first + 1]);
        }
    }

    private static Vec3 Cross((int X, int Y, int Z) inside, (int X, int Y, int Z) outside)
    {
        // The ends are flat.
        if (outside.Z < 0 || outside.Z > High) return Place(inside);
        double from = Value(inside), to = Value(outside);
        return Vec3.Lerp(Place(inside), Place(outside), -from / (to - from));
    }

    private static Vec3 Middle(List<(int X, int Y, int Z)> nodes)
    {
        var sum = Vec3.Zero;
        foreach (var node in nodes) sum += Place(node) / nodes.Count;
        return sum;
    }

    private static Vec3 Place((int X, int Y, int Z) node) => new(node.X * Cell, node.Y * Cell, node.Z * Cell);

    private static double Value((int X, int Y, int Z) node)
    {
        if (node.Z < 0 || node.Z > High) return 1;
        double x = node.X * Cell, y = node.Y * Cell, focus = 6 + 30.0 * node.Z / High, radius = 22 + 5.0 * node.Z / High;
        var product = ((x - focus) * (x - focus) + y * y) * ((x + focus) * (x + focus) + y * y);
        return product - radius * radius * radius * radius;
    }

    private static Vec3 Bent(Vec3 p) => new(p.X, p.Y, p.Z * (1.05 - 0.0045 * System.Math.Sqrt(p.X * p.X + 100)));
}
