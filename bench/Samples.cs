using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Tests.Geometry.Meshes;
using Caterpillar.Tests.Slicing;
using Caterpillar.Toolpaths;

namespace Caterpillar.Bench;

/// <summary>Input of the benchmarks, made again each time.</summary>
internal static class Samples
{
    /// <summary>A closed contour with waves, counterclockwise.</summary>
    public static Polyline Contour(int vertices)
        => new(Enumerable.Range(0, vertices).Select(i =>
        {
            var angle = 360.0 * i / vertices;
            var (sin, cos) = Angle.SinCos(angle);
            var radius = 40 + 3 * Angle.Sin(9 * angle) + 0.4 * Angle.Sin(71 * angle);
            return new Vec3(100 + radius * cos, 100 + radius * sin);
        }), closed: true);

    /// <summary>The bumpy sphere of 499,848 triangles: radius 40 mm with waves of 4 %, standing on Z = 0.</summary>
    public static TriMesh BumpySphere(int around = 708, int rings = 354)
    {
        const double Radius = 40;
        var points = new List<Vec3> { new(0, 0, 2 * Radius) };
        for (var t = 1; t < rings; t++)
        {
            var (st, ct) = Angle.SinCos(180.0 * t / rings);
            for (var i = 0; i < around; i++)
            {
                var p = 360.0 * i / around;
                var (sp, cp) = Angle.SinCos(p);
                var r = Radius * (1 + 0.04 * Angle.Sin(8 * p) * Angle.Sin(10 * 180.0 * t / rings) * st);
                points.Add(new Vec3(r * st * cp, r * st * sp, Radius + r * ct));
            }
        }
        points.Add(new Vec3(0, 0, 0));
        var triangles = new List<int>();
        for (var i = 0; i < around; i++)
        {
            var j = (i + 1) % around;
            triangles.AddRange([0, 1 + i, 1 + j]);
            for (var t = 0; t + 2 < rings; t++)
            {
                int a = 1 + t * around + i, b = 1 + t * around + j, c = a + around, d = b + around;
                triangles.AddRange([a, c, d, a, d, b]);
            }
            triangles.AddRange([1 + (rings - 2) * around + i, points.Count - 1, 1 + (rings - 2) * around + j]);
        }
        return TriMesh.Create(points, triangles);
    }

    /// <summary>The bumpy sphere with about so many triangles, as a file.</summary>
    public static void WriteSphere(int triangles, string file)
    {
        var rings = (int)Math.Sqrt(triangles / 4.0);
        File.WriteAllBytes(file, StlWriter.ToBytes(BumpySphere(2 * rings, rings)));
    }

    /// <summary>Round pins of 3 mm, 2 mm high, 5 mm apart, as one mesh.</summary>
    public static void WritePins(int count, string file)
    {
        var columns = (int)Math.Ceiling(Math.Sqrt(count));
        var pins = Enumerable.Range(0, count).Select(i => Prism.On(Region.From([Round(i % columns * 5, i / columns * 5, 1.5, 12)]), 2));
        File.WriteAllBytes(file, StlWriter.ToBytes(TriMesh.Merge([.. pins])));
    }

    /// <summary>Plain parts, as people print them.</summary>
    public static void WriteParts(string folder)
    {
        Directory.CreateDirectory(folder);
        Part("box", Rectangle(120, 90), 8);
        Part("disk", Region.From([Round(0, 0, 50, 180)]), 6);
        Part("frame", Turned(Rectangle(100, 100).Subtract(Rectangle(60, 60)), 30), 10);
        Part("angle", Turned(Rectangle(90, 90).Subtract(Region.From([Box(-30, -30, 60, 60)])), 12), 12);
        var holes = from x in Enumerable.Range(-2, 5) from y in Enumerable.Range(-1, 3) select Round(x * 22, y * 25, 4 + (x + y) % 3, 64);
        Part("sieve", Rectangle(120, 90).Subtract(Region.From(holes.ToList())), 6);
        Part("gear", Region.From([Gear(24, 30, 36)]).Subtract(Region.From([Round(0, 0, 8, 96)])), 10);
        var slots = Enumerable.Range(-4, 9).Select(x => Box(x * 10 - 3, -25, x * 10 + 3, 25)).ToList();
        Part("grille", Rectangle(110, 70).Subtract(Region.From(slots)), 5);

        void Part(string name, Region outline, double height)
            => File.WriteAllBytes(Path.Combine(folder, name + ".stl"), StlWriter.ToBytes(Prism.On(outline, height)));
    }

    private static Polyline Polygon(IEnumerable<Vec3> points) => new(points, closed: true);

    private static Polyline Box(double x0, double y0, double x1, double y1) => Polygon([new(x0, y0), new(x1, y0), new(x1, y1), new(x0, y1)]);

    private static Region Rectangle(double x, double y) => Region.From([Box(-x / 2, -y / 2, x / 2, y / 2)]);

    private static Polyline Round(double x, double y, double radius, int sides)
        => Polygon(Enumerable.Range(0, sides).Select(i => Angle.SinCos(360.0 * i / sides)).Select(a => new Vec3(x + radius * a.Cos, y + radius * a.Sin)));

    private static Polyline Gear(int teeth, double low, double high) => Polygon(Enumerable.Range(0, 4 * teeth).Select(i =>
    {
        var (sin, cos) = Angle.SinCos(90.0 / teeth * i);
        var radius = i % 4 < 2 ? low : high;
        return new Vec3(radius * cos, radius * sin);
    }));

    private static Region Turned(Region region, double degrees)
    {
        var (sin, cos) = Angle.SinCos(degrees);
        return Region.From(region.Contours.Select(c => Polygon(c.Raw.Select(p => new Vec3(p.X * cos - p.Y * sin, p.X * sin + p.Y * cos)))).ToList());
    }

    /// <summary>A model of any format as binary STL.</summary>
    public static void WriteStl(string model, string file)
        => File.WriteAllBytes(file, StlWriter.ToBytes(TriMesh.Merge(MeshReader.Read(model).Value!.Select(m => m.Mesh).ToArray())));

    /// <summary>A print of wavy contours with a travel and a retraction after each 300 moves.</summary>
    public static Toolpath Print(int moves)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.AddLayer(new Layer(0, 0.2, 0.2));
        for (var i = 0; i < moves; i++)
        {
            var angle = 1.2 * i;
            var (sin, cos) = Angle.SinCos(angle);
            var radius = 40 + 3 * Angle.Sin(9 * angle) + i / 300 % 20 * 0.45;
            var end = new Vec3(100 + radius * cos, 100 + radius * sin, 0.2 + i / 6000 * 0.2);
            if (i % 300 == 0) builder.Add(builder.Position, -0.8, 0, 35, MoveKind.Retract, Role.Unspecified, 0, 0, i);
            else if (i % 300 == 1) builder.Add(end, 0, 0, 150, MoveKind.Travel, Role.Unspecified, 0, 0, i);
            else if (i % 300 == 2) builder.Add(builder.Position, 0.8, 0, 35, MoveKind.Deretract, Role.Unspecified, 0, 0, i);
            else builder.Add(end, 0.03, 0.03, 60, MoveKind.Print, Role.OuterWall, 0, 0, i);
        }
        return builder.Build([new ToolpathTool(2.405)]);
    }
}
