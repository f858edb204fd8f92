using System.Collections.Generic;
using Caterpillar.Basics;
using Caterpillar.Geometry;

namespace Caterpillar.Examples;

/// <summary>
/// A twisted vase, 120 mm high, with a belly and a neck. Its six lobes turn by 100° from bottom to top. The wall is 1.6 mm (measured radially), the floor
/// 2 mm.
/// </summary>
internal static class Vase
{
    private const double Height = 120;
    private const double Wall = 1.6;
    private const double Floor = 2;
    private const int Around = 108;
    private const int Rings = 58;

    public static TriMesh Make()
    {
        var points = new List<Vec3>();
        var faces = new List<int>();
        AddWall(points, 0, 0);
        AddWall(points, Floor, Wall);
        const int Inner = (Rings + 1) * Around;
        var bottom = points.Count;
        points.Add(new Vec3(0, 0, 0));
        points.Add(new Vec3(0, 0, Floor));
        for (var i = 0; i < Around; i++)
        {
            var j = (i + 1) % Around;
            for (var ring = 0; ring < Rings; ring++)
            {
                int a = ring * Around + i, b = ring * Around + j;
                faces.AddRange([a, b, b + Around, a, b + Around, a + Around]);
                faces.AddRange([Inner + a, Inner + b + Around, Inner + b, Inner + a, Inner + a + Around, Inner + b + Around]);
            }
            int outerTop = Rings * Around + i, outerNext = Rings * Around + j;
            faces.AddRange([outerTop, outerNext, Inner + outerNext, outerTop, Inner + outerNext, Inner + outerTop]);
            faces.AddRange([bottom, j, i, bottom + 1, Inner + i, Inner + j]);
        }
        return TriMesh.Create(points, faces);
    }

    private static void AddWall(List<Vec3> points, double from, double inset)
    {
        for (var ring = 0; ring <= Rings; ring++)
        {
            var z = from + (Height - from) * ring / Rings;
            var h = z / Height;
            var belly = 31 + 9 * Angle.Sin(270 * h + 20) + 4 * h * h;
            for (var i = 0; i < Around; i++)
            {
                var turn = 360.0 * i / Around + 100 * h;
                var r = belly + 2.2 * Angle.Cos(6 * 360.0 * i / Around) - inset;
                var (sin, cos) = Angle.SinCos(turn);
                points.Add(new Vec3(r * cos, r * sin, z));
            }
        }
    }
}
