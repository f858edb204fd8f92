using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;

namespace Caterpillar.Tests.Slicing;

/// <summary>Upright solids on a region: its contours as walls, its triangles as bottom and top.</summary>
internal static class Prism
{
    /// <summary>From z = 0 up to a height.</summary>
    public static TriMesh On(Region region, double height)
    {
        var points = new List<Vec3>();
        var triangles = new List<int>();
        foreach (var island in region.Islands) Add(island, height, points, triangles);
        return TriMesh.Create(points, triangles);
    }

    private static void Add(Region island, double height, List<Vec3> points, List<int> triangles)
    {
        var loops = new List<int[]>();
        var flat = new List<Vec3>();
        // The outline is the largest, counterclockwise; holes are negative.
        foreach (var contour in island.Contours.OrderByDescending(c => c.SignedAreaXY))
        {
            loops.Add(Enumerable.Range(flat.Count, contour.Count).ToArray());
            flat.AddRange(contour.Raw);
        }
        var (low, high) = (points.Count, points.Count + flat.Count);
        points.AddRange(flat.Select(p => p.WithZ(0)));
        points.AddRange(flat.Select(p => p.WithZ(height)));
        foreach (var loop in loops)
        {
            for (var i = 0; i < loop.Length; i++)
            {
                int a = loop[i], b = loop[(i + 1) % loop.Length];
                triangles.AddRange([low + a, low + b, high + b, low + a, high + b, high + a]);
            }
        }
        foreach (var (a, b, c) in Ears(flat, OneLoop(flat, loops))) triangles.AddRange([high + a, high + b, high + c, low + a, low + c, low + b]);
    }

    // Each hole is joined to what is outside of it by the shortest line that crosses no contour.
    private static List<int> OneLoop(List<Vec3> points, List<int[]> loops)
    {
        var all = new List<int>(loops[0]);
        var edges = loops.SelectMany(l => l.Select((v, i) => (A: points[v], B: points[l[(i + 1) % l.Length]]))).ToList();
        foreach (var hole in loops.Skip(1).OrderByDescending(l => l.Max(v => points[v].X)))
        {
            var (at, to) = Enumerable.Range(0, all.Count).SelectMany(i => Enumerable.Range(0, hole.Length).Select(j => (At: i, To: j)))
                .OrderBy(p => points[all[p.At]].DistanceTo(points[hole[p.To]]))
                .First(p => !edges.Exists(e => Cross(points[all[p.At]], points[hole[p.To]], e.A, e.B)));
            edges.Add((points[all[at]], points[hole[to]]));
            all.InsertRange(at + 1, [.. Enumerable.Range(0, hole.Length + 1).Select(k => hole[(to + k) % hole.Length]), all[at]]);
        }
        return all;
    }

    private static List<(int A, int B, int C)> Ears(List<Vec3> points, List<int> loop)
    {
        var ears = new List<(int, int, int)>();
        while (loop.Count > 3)
        {
            var ear = Enumerable.Range(0, loop.Count).First(i => IsEar(points, loop, i));
            ears.Add((At(loop, ear - 1), loop[ear], At(loop, ear + 1)));
            loop.RemoveAt(ear);
        }
        ears.Add((loop[0], loop[1], loop[2]));
        return ears;
    }

    private static bool IsEar(List<Vec3> points, List<int> loop, int i)
    {
        Vec3 a = points[At(loop, i - 1)], b = points[loop[i]], c = points[At(loop, i + 1)];
        return Side(a, b, c) > 0
            && !loop.Exists(v => points[v] is var p && p != a && p != b && p != c && Side(a, b, p) >= 0 && Side(b, c, p) >= 0 && Side(c, a, p) >= 0);
    }

    private static int At(List<int> loop, int i) => loop[(i + loop.Count) % loop.Count];

    private static bool Cross(Vec3 a, Vec3 b, Vec3 c, Vec3 d) => Side(a, b, c) * Side(a, b, d) < 0 && Side(c, d, a) * Side(c, d, b) < 0;

    private static double Side(Vec3 a, Vec3 b, Vec3 c) => (b.X - a.X) * (c.Y - a.Y) - (b.Y - a.Y) * (c.X - a.X);
}
