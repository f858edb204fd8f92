using System;
using System.Collections.Generic;
using Caterpillar.Basics;
using Caterpillar.Geometry;

namespace Caterpillar.Tests.Geometry.Meshes;

/// <summary>Small meshes with known measures.</summary>
internal static class MeshMaker
{
    private static readonly int[] BoxFaces =
        [0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7];

    public static TriMesh Box(double x0, double y0, double z0, double x1, double y1, double z1) => TriMesh.Create(
        [new(x0, y0, z0), new(x1, y0, z0), new(x1, y1, z0), new(x0, y1, z0), new(x0, y0, z1), new(x1, y0, z1), new(x1, y1, z1), new(x0, y1, z1)], BoxFaces);

    /// <summary>The same triangles turned inside out.</summary>
    public static TriMesh InsideOut(TriMesh mesh)
    {
        var turned = new List<int>();
        for (var t = 0; t < mesh.TriangleCount; t++)
        {
            var (a, b, c) = mesh.Triangle(t);
            turned.AddRange([a, c, b]);
        }
        return TriMesh.Create(mesh.Vertices, turned);
    }

    /// <summary>A star-shaped prism between two heights; the polygon runs counterclockwise around the origin.</summary>
    public static TriMesh Prism(IReadOnlyList<Vec3> polygon, double bottom, double top, Vec3 lean)
    {
        var n = polygon.Count;
        var points = new List<Vec3> { new(0, 0, bottom), new Vec3(0, 0, top) + lean };
        foreach (var p in polygon)
        {
            points.Add(p.WithZ(bottom));
            points.Add(p.WithZ(top) + lean);
        }
        var faces = new List<int>();
        for (var i = 0; i < n; i++)
        {
            int a = 2 + 2 * i, b = 2 + 2 * ((i + 1) % n);
            faces.AddRange([0, b, a, 1, a + 1, b + 1, a, b, b + 1, a, b + 1, a + 1]);
        }
        return TriMesh.Create(points, faces);
    }

    /// <summary>The bumpy sphere of the shared test data: 2·nu·(nv − 1) triangles.</summary>
    public static TriMesh BumpySphere(int nu = 708, int nv = 354)
    {
        const double R = 40;
        var points = new Vec3[2 + (nv - 1) * nu];
        points[0] = new Vec3(0, 0, 80);
        for (var t = 1; t < nv; t++)
        {
            var polar = 180.0 * t / nv;
            var (sinT, cosT) = Angle.SinCos(polar);
            var wave = Angle.Sin(10 * polar) * sinT;
            for (var i = 0; i < nu; i++)
            {
                var turn = 360.0 * i / nu;
                var (sinP, cosP) = Angle.SinCos(turn);
                var r = R * (1 + 0.04 * Angle.Sin(8 * turn) * wave);
                points[1 + (t - 1) * nu + i] = new Vec3(r * sinT * cosP, r * sinT * sinP, 40 + r * cosT);
            }
        }
        var last = points.Length - 1;
        var faces = new List<int>(6 * nu * (nv - 1));
        for (var i = 0; i < nu; i++)
        {
            var j = (i + 1) % nu;
            faces.AddRange([0, 1 + i, 1 + j]);
            for (var t = 0; t <= nv - 3; t++)
            {
                int a = 1 + t * nu + i, b = 1 + t * nu + j;
                faces.AddRange([a, a + nu, b + nu, a, b + nu, b]);
            }
            faces.AddRange([1 + (nv - 2) * nu + i, last, 1 + (nv - 2) * nu + j]);
        }
        return TriMesh.Create(points, faces);
    }
}
