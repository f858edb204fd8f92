using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Caterpillar.GH.Tests.Examples;

/// <summary>Simple shapes that a user might have drawn in Rhino.</summary>
internal static class Solids
{
    private static readonly int[][] BoxFaces = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];

    /// <summary>A closed tower of rings with corners, around a point on the bed. Each ring is a radius, a height and a twist in degrees.</summary>
    public static byte[] Tower(double x, double y, int sides, params (double Radius, double Height, double Twist)[] rings)
    {
        var points = new List<Rg.Point3d>();
        foreach (var (radius, height, twist) in rings)
        {
            for (var i = 0; i < sides; i++)
            {
                var angle = (360.0 * i / sides + twist) * Math.PI / 180;
                points.Add(new Rg.Point3d(Round(x + radius * Math.Cos(angle)), Round(y + radius * Math.Sin(angle)), height));
            }
        }
        var faces = new List<int[]>();
        for (var ring = 0; ring + 1 < rings.Length; ring++)
        {
            for (var i = 0; i < sides; i++)
            {
                int a = ring * sides + i, b = ring * sides + (i + 1) % sides;
                faces.Add([a, b, b + sides]);
                faces.Add([a, b + sides, a + sides]);
            }
        }
        var last = (rings.Length - 1) * sides;
        for (var i = 1; i + 1 < sides; i++)
        {
            faces.Add([0, i + 1, i]);
            faces.Add([last, last + i, last + i + 1]);
        }
        return RhinoBytes.Mesh(points, faces);
    }

    public static byte[] Box(double x, double y, double z, double width, double depth, double height)
        => RhinoBytes.Mesh(Corners(x, y, z, width, depth, height), BoxFaces);

    /// <summary>A Brep as openNURBS wrote it: the box of 30 × 30 × 8 mm at 95, 95, 0, or the sheet over 80 to 140 that rises along X from 8 to 11 mm.</summary>
    public static byte[] Brep(string name)
        => RhinoBytes.Brep(File.ReadAllBytes(Path.Combine(Caterpillar.Tests.TestData.Repository, "tests/Caterpillar.GH.Tests/Examples/Breps", name + ".brep")));

    /// <summary>A block that was turned about two axes and hangs above the bed.</summary>
    public static byte[] Askew(double x, double y, double width, double depth, double height)
    {
        var turn = Rg.Transform.Translation(x, y, 20) * Rg.Transform.Rotation(0.5, new Rg.Vector3d(1, 0, 0), Rg.Point3d.Origin)
            * Rg.Transform.Rotation(0.3, new Rg.Vector3d(0, 1, 0), Rg.Point3d.Origin);
        return RhinoBytes.Mesh(Corners(0, 0, 0, width, depth, height).Select(p =>
        {
            p.Transform(turn);
            return new Rg.Point3d(Round(p.X), Round(p.Y), Round(p.Z));
        }).ToArray(), BoxFaces);
    }

    /// <summary>A sheet over a square, with heights by a function of -1 to 1 across.</summary>
    public static byte[] Sheet(double x, double y, double size, int cells, Func<double, double, double> height)
    {
        var points = new List<Rg.Point3d>();
        var faces = new List<int[]>();
        for (var j = 0; j <= cells; j++)
        {
            for (var i = 0; i <= cells; i++)
            {
                double u = 2.0 * i / cells - 1, v = 2.0 * j / cells - 1;
                points.Add(new Rg.Point3d(x + u * size / 2, y + v * size / 2, Round(height(u, v))));
                if (i < cells && j < cells) faces.Add([j * (cells + 1) + i, j * (cells + 1) + i + 1, (j + 1) * (cells + 1) + i + 1, (j + 1) * (cells + 1) + i]);
            }
        }
        return RhinoBytes.Mesh(points, faces);
    }

    /// <summary>A closed curve that waves around a circle.</summary>
    public static byte[] Rosette(double x, double y, double radius, double wave, int petals, double height)
    {
        const int PerPetal = 24;
        var count = petals * PerPetal;
        return RhinoBytes.Polyline(Enumerable.Range(0, count + 1).Select(i =>
        {
            double angle = 2 * Math.PI * (i % count) / count, r = radius + wave * Math.Cos(petals * angle);
            return new Rg.Point3d(Round(x + r * Math.Cos(angle)), Round(y + r * Math.Sin(angle)), height);
        }).ToArray());
    }

    /// <summary>A line that goes back and forth over a rectangle.</summary>
    public static byte[] Zigzag(double x, double y, double width, double depth, int strokes)
        => RhinoBytes.Polyline(Enumerable.Range(0, strokes * 2).Select(i =>
            new Rg.Point3d(x + width * (i / 2) / (strokes - 1), y + ((i + 1) / 2 % 2 == 0 ? 0 : depth), 0)).ToArray());

    private static Rg.Point3d[] Corners(double x, double y, double z, double width, double depth, double height)
        => new[] { 0, 1 }.SelectMany(k => new[] { (0, 0), (1, 0), (1, 1), (0, 1) }
            .Select(c => new Rg.Point3d(x + c.Item1 * width, y + c.Item2 * depth, z + k * height))).ToArray();

    // Sines of the runtimes differ in their last digits.
    private static double Round(double value) => Math.Round(value, 3);
}
