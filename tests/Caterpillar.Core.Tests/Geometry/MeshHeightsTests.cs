using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry;

public class MeshHeightsTests
{
    [Test]
    public void A_box_has_its_top_and_below_it_its_bottom()
    {
        var heights = new MeshHeights(Box());
        Assert.That(heights.TopUnder(1, 1), Is.EqualTo(3));
        Assert.That(heights.TopUnder(1, 1, 2.9), Is.EqualTo(1));
        Assert.That(heights.TopUnder(1, 1, 0.9), Is.EqualTo(double.NegativeInfinity));
        Assert.That(heights.TopUnder(0, 0), Is.EqualTo(3), "the corner belongs to it");
        Assert.That(heights.TopUnder(2, 2), Is.EqualTo(3));
        Assert.That(heights.TopUnder(2.01, 1), Is.EqualTo(double.NegativeInfinity));
        Assert.That(heights.TopUnder(double.NaN, 1), Is.EqualTo(double.NegativeInfinity));
        Assert.That(new MeshHeights(TriMesh.Empty).TopUnder(0, 0), Is.EqualTo(double.NegativeInfinity));
    }

    [Test]
    public void Without_faces_that_face_down_a_box_has_its_top_alone()
    {
        var heights = new MeshHeights(Box(), onlyUp: true);
        Assert.That(heights.TopUnder(1, 1), Is.EqualTo(3));
        Assert.That(heights.TopUnder(1, 1, 2.9), Is.EqualTo(double.NegativeInfinity));
    }

    [Test]
    public void Heights_equal_a_look_at_every_triangle()
    {
        var random = new Random(61);
        for (var round = 0; round < 20; round++)
        {
            var points = Enumerable.Range(0, 60)
                .Select(_ => new Vec3(random.NextDouble() * 20, random.NextDouble() * (round % 2 == 0 ? 20 : 0.1), random.NextDouble() * 5)).ToArray();
            var mesh = TriMesh.Create(points, Enumerable.Range(0, 90).Select(_ => random.Next(60)).ToArray());
            var heights = new MeshHeights(mesh);
            for (var i = 0; i < 100; i++)
            {
                var p = new Vec3(random.NextDouble() * 20, random.NextDouble() * 20);
                var limit = random.NextDouble() * 6;
                Assert.That(heights.TopUnder(p.X, p.Y, limit), Is.EqualTo(Brute(mesh, p, limit)).Within(1e-9).Or.EqualTo(Brute(mesh, p, limit)));
            }
        }
    }

    private static double Brute(TriMesh mesh, Vec3 p, double limit)
    {
        var best = double.NegativeInfinity;
        for (var t = 0; t < mesh.TriangleCount; t++)
        {
            var (i, j, k) = mesh.Triangle(t);
            Vec3 a = mesh.Vertices[i], b = mesh.Vertices[j], c = mesh.Vertices[k];
            var n = Vec3.Cross(b - a, c - a);
            bool Left(Vec3 u, Vec3 v) => ((v.X - u.X) * (p.Y - u.Y) - (v.Y - u.Y) * (p.X - u.X)) * n.Z >= 0;
            if (n.Z == 0 || !Left(a, b) || !Left(b, c) || !Left(c, a)) continue;
            var z = a.Z - (n.X * (p.X - a.X) + n.Y * (p.Y - a.Y)) / n.Z;
            if (z <= limit) best = Math.Max(best, z);
        }
        return best;
    }

    private static TriMesh Box()
    {
        var points = new List<Vec3>();
        for (var i = 0; i < 8; i++) points.Add(new Vec3(2 * (i & 1), i & 2, (i & 4) / 2 + 1));
        return TriMesh.Create(points, [0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5]);
    }
}
