using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Curved;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Tests.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Curved;

/// <summary>Solids between two surfaces, and slicing them along fields.</summary>
internal static class CurvedSolids
{
    /// <summary>Massive, so that volumes can be compared; nothing that is not part of the solid; any slope.</summary>
    public static readonly PrintSettings Massive = new()
    {
        LayerHeight = 0.5, FirstLayerHeight = 0.5, LineWidth = 0.8, BeadShape = BeadShape.Rectangle, WallCount = 1, InfillDensityPercent = 100,
            InfillOverlapPercent = 0,
        Resolution = 0, SkirtLoops = 0, TopLayers = 0, BottomLayers = 0, MinLayerTime = 0, OverhangClasses = ValueList<OverhangClass>.Empty,
            CurvedMaxSlope = 80,
        CurvedMaxGap = 2,
    };

    /// <summary>A block over a rectangle between two surfaces.</summary>
    public static TriMesh Between(Bounds plan, int steps, Func<double, double, double> low, Func<double, double, double> high)
    {
        var points = new List<Vec3>();
        for (var side = 0; side < 2; side++)
        {
            for (var j = 0; j <= steps; j++)
            {
                for (var i = 0; i <= steps; i++)
                {
                    double x = plan.Min.X + plan.Size.X * i / steps, y = plan.Min.Y + plan.Size.Y * j / steps;
                    points.Add(new Vec3(x, y, side == 0 ? low(x, y) : high(x, y)));
                }
            }
        }
        int At(int side, int i, int j) => side * (steps + 1) * (steps + 1) + j * (steps + 1) + i;
        var triangles = new List<int>();
        void Quad(int a, int b, int c, int d) => triangles.AddRange([a, b, c, a, c, d]);
        for (var j = 0; j < steps; j++)
        {
            for (var i = 0; i < steps; i++)
            {
                Quad(At(0, i, j), At(0, i, j + 1), At(0, i + 1, j + 1), At(0, i + 1, j));
                Quad(At(1, i, j), At(1, i + 1, j), At(1, i + 1, j + 1), At(1, i, j + 1));
            }
        }
        for (var i = 0; i < steps; i++)
        {
            Quad(At(0, i, 0), At(0, i + 1, 0), At(1, i + 1, 0), At(1, i, 0));
            Quad(At(0, i + 1, steps), At(0, i, steps), At(1, i, steps), At(1, i + 1, steps));
            Quad(At(0, 0, i + 1), At(0, 0, i), At(1, 0, i), At(1, 0, i + 1));
            Quad(At(0, steps, i), At(0, steps, i + 1), At(1, steps, i + 1), At(1, steps, i));
        }
        return TriMesh.Create(points, triangles);
    }

    /// <summary>A solid between a circle on the bed and as many points above it.</summary>
    public static TriMesh Loft(Vec3[] low, Vec3[] high)
    {
        var n = low.Length;
        var points = new List<Vec3>(low);
        points.AddRange(high);
        points.Add(low.Aggregate(Vec3.Zero, (s, p) => s + p / n));
        points.Add(high.Aggregate(Vec3.Zero, (s, p) => s + p / n));
        var triangles = new List<int>();
        for (var i = 0; i < n; i++)
        {
            var k = (i + 1) % n;
            triangles.AddRange([i, k, n + k, i, n + k, n + i, 2 * n, k, i, 2 * n + 1, n + i, n + k]);
        }
        return TriMesh.Create(points, triangles);
    }

    /// <summary>A solid of revolution about the Z axis: its outline from the axis at the bottom to the axis at the top.</summary>
    public static TriMesh Lathe(int sides, params (double Radius, double Height)[] outline)
    {
        var points = new List<Vec3> { new(0, 0, outline[0].Height), new(0, 0, outline[outline.Length - 1].Height) };
        foreach (var (radius, height) in outline) points.AddRange(Solids.Circle(radius, sides).Select(p => p.WithZ(height)));
        var triangles = new List<int>();
        for (var i = 0; i < sides; i++)
        {
            var k = (i + 1) % sides;
            for (var ring = 0; ring + 1 < outline.Length; ring++)
            {
                int low = 2 + ring * sides, high = low + sides;
                triangles.AddRange([low + i, low + k, high + k, low + i, high + k, high + i]);
            }
            var last = 2 + (outline.Length - 1) * sides;
            triangles.AddRange([0, 2 + k, 2 + i, 1, last + i, last + k]);
        }
        return TriMesh.Create(points, triangles);
    }

    /// <summary>A piece of a tube about the Y axis, between two angles.</summary>
    public static TriMesh Arch(double inner, double outer, double from, double to, double length, int steps)
    {
        var points = new List<Vec3>();
        for (var i = 0; i <= steps; i++)
        {
            var (sin, cos) = Angle.SinCos(to + (from - to) * i / steps);
            foreach (var y in new[] { 0, length })
            {
                points.Add(new Vec3(inner * cos, y, inner * sin));
                points.Add(new Vec3(outer * cos, y, outer * sin));
            }
        }
        var triangles = new List<int>();
        void Quad(int a, int b, int c, int d) => triangles.AddRange([a, b, c, a, c, d]);
        for (var i = 0; i < steps; i++)
        {
            var (a, b) = (4 * i, 4 * (i + 1));
            Quad(a + 1, b + 1, b + 3, a + 3);
            Quad(a, a + 2, b + 2, b);
            Quad(a, b, b + 1, a + 1);
            Quad(a + 2, a + 3, b + 3, b + 2);
        }
        Quad(0, 1, 3, 2);
        Quad(4 * steps, 4 * steps + 2, 4 * steps + 3, 4 * steps + 1);
        return TriMesh.Create(points, triangles);
    }

    /// <summary>A sheet of a cylinder about the Y axis, facing outward, longer than the part on both ends.</summary>
    public static TriMesh Sheet(double radius, double from, double to, double length, int steps)
    {
        var points = new List<Vec3>();
        for (var i = 0; i <= steps; i++)
        {
            var (sin, cos) = Angle.SinCos(to + (from - to) * i / steps);
            points.Add(new Vec3(radius * cos, -1, radius * sin));
            points.Add(new Vec3(radius * cos, length - 1, radius * sin));
        }
        var triangles = new List<int>();
        for (var i = 0; i < steps; i++) triangles.AddRange([2 * i, 2 * i + 2, 2 * i + 3, 2 * i, 2 * i + 3, 2 * i + 1]);
        return TriMesh.Create(points, triangles);
    }

    /// <summary>The volume between two values of a field, inside a part over a rectangle between two surfaces.</summary>
    public static double VolumeBetween(
        LayerField field, Bounds plan, double from, double to, Func<double, double, double> low, Func<double, double, double> high)
    {
        const int Steps = 200;
        var sum = 0.0;
        for (var i = 0; i < Steps; i++)
        {
            for (var j = 0; j < Steps; j++)
            {
                double x = plan.Min.X + plan.Size.X * (i + 0.5) / Steps, y = plan.Min.Y + plan.Size.Y * (j + 0.5) / Steps;
                sum += Math.Max(0, Math.Min(high(x, y), field.Height(x, y, to)) - Math.Max(low(x, y), field.Height(x, y, from)));
            }
        }
        return sum * plan.Size.X * plan.Size.Y / (Steps * Steps);
    }

    public static Bounds Plan(double x0, double y0, double x1, double y1) => new(new Vec3(x0, y0), new Vec3(x1, y1));

    public static Result<CurvedResult> Try(LayerField field, PrintSettings settings, CurvedOptions? options, params TriMesh[] meshes)
        => CurvedSlicer.Slice([new NamedMesh("test", TriMesh.Merge(meshes))], field, new PrintSetup { Settings = settings }, options);

    public static IReadOnlyList<SlicedLayer> Slice(LayerField field, PrintSettings settings, params TriMesh[] meshes)
    {
        var result = Try(field, settings, null, meshes);
        Assert.That(result.Diagnostics.Where(d => d.Severity != Severity.Note), Is.Empty);
        return result.Value!.Layers;
    }

    public static double Volume(SlicedLayer layer) => layer.Steps.Sum(s => s.Path.Volume);

    public static IEnumerable<Vec3> Points(SlicedLayer layer) => layer.Steps.SelectMany(s => s.Path.Points);
}
