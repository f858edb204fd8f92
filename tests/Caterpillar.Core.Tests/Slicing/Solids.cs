using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

/// <summary>Simple solids, and slicing them.</summary>
internal static class Solids
{
    public static TriMesh Block(double x0, double y0, double z0, double x1, double y1, double z1)
        => Loft(z0, [new(x0, y0), new(x1, y0), new(x1, y1), new(x0, y1)], z1, [new(x0, y0), new(x1, y0), new(x1, y1), new(x0, y1)]);

    /// <summary>A cone around the Z axis between two heights; a radius of 0 gives a tip.</summary>
    public static TriMesh Cone(double z0, double r0, double z1, double r1, int sides = 96) => Loft(z0, Circle(r0, sides), z1, Circle(r1, sides));

    /// <summary>A solid between two outlines with as many corners, which are stars around their centers.</summary>
    public static TriMesh Loft(double z0, Vec3[] low, double z1, Vec3[] high)
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

    public static Vec3[] Circle(double radius, int sides)
    {
        var points = new Vec3[sides];
        for (var i = 0; i < sides; i++)
        {
            var (sin, cos) = Angle.SinCos(360.0 * i / sides);
            points[i] = new Vec3(radius * cos, radius * sin);
        }
        return points;
    }

    public static Result<SliceResult> Try(PrintSettings settings, params TriMesh[] meshes)
        => PlanarSlicer.Slice([new NamedMesh("test", TriMesh.Merge(meshes))], settings);

    public static IReadOnlyList<SlicedLayer> Slice(PrintSettings settings, params TriMesh[] meshes)
    {
        var result = Try(settings, meshes);
        Assert.That(result.Diagnostics.Where(d => d.Severity == Severity.Error), Is.Empty);
        return result.Value!.Layers;
    }

    public static PrintPath[] Paths(SlicedLayer layer, params Role[] roles)
        => layer.Steps.Select(s => s.Path).Where(p => roles.Length == 0 || Array.IndexOf(roles, p.Role) >= 0).ToArray();

    public static double Volume(IEnumerable<SlicedLayer> layers) => layers.SelectMany(l => l.Steps).Sum(s => s.Path.Volume);
}
