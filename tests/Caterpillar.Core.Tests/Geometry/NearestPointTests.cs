using System;
using System.Linq;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry;

/// <summary>Nearest points of triangles, winding numbers along vertical rays, and parameters beyond the ends of arcs.</summary>
public class NearestPointTests
{
    private static readonly Vec3 A = new(0, 0, 0), B = new(4, 0, 0), C = new(0, 8, 0);

    // In the plane of the triangle and 3 mm above it: beyond each corner and edge, and over the face.
    [TestCase(-1, -1, 0, 0)]
    [TestCase(6, -1, 4, 0)]
    [TestCase(-1, 10, 0, 8)]
    [TestCase(1, -2, 1, 0)]
    [TestCase(3, -2, 3, 0)]
    [TestCase(-5, 2, 0, 2)]
    [TestCase(-5, 6, 0, 6)]
    [TestCase(4, 5, 2, 4)]
    [TestCase(1, 1, 1, 1)]
    public void The_nearest_point_of_a_triangle_is_on_the_side_that_faces_the_point(double x, double y, double nearX, double nearY)
    {
        foreach (var z in new[] { 0.0, 3 })
        {
            var (point, u, v, w) = TriangleDistance.Nearest(new Vec3(x, y, z), A, B, C);
            Assert.That(point.DistanceTo(new Vec3(nearX, nearY, 0)), Is.LessThan(1e-12));
            Assert.That((A * u + B * v + C * w).DistanceTo(point), Is.LessThan(1e-12), "barycentric coordinates");
            Assert.That(u + v + w, Is.EqualTo(1).Within(1e-12));
        }
    }

    [Test]
    public void No_point_of_a_triangle_is_nearer()
    {
        var random = new Random(5);
        Vec3 Any() => new(random.NextDouble() * 10 - 5, random.NextDouble() * 10 - 5, random.NextDouble() * 10 - 5);
        for (var n = 0; n < 300; n++)
        {
            Vec3 p = Any(), a = Any(), b = Any(), c = Any();
            var near = TriangleDistance.Nearest(p, a, b, c).Point.DistanceTo(p);
            for (var i = 0; i <= 12; i++)
            {
                for (var k = 0; k <= 12 - i; k++) Assert.That((a * (i / 12.0) + b * (k / 12.0) + c * ((12 - i - k) / 12.0)).DistanceTo(p),
                    Is.GreaterThan(near - 1e-9));
            }
        }
    }

    [Test]
    public void Vertical_rays_tell_inside_from_outside_also_where_they_lean_on_long_edges()
    {
        // A tetrahedron with edges of very different lengths: inside are the points below the slanted face.
        var mesh = TriMesh.Create([new Vec3(0, 0, 0), new Vec3(30, 0, 0), new Vec3(0, 0.5, 0), new Vec3(0, 0, 7)], [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]);
        var rays = new MeshHeights(mesh);
        var turned = new MeshHeights(TriMesh.Create(mesh.Vertices.ToArray(), mesh.Indices.Reverse().ToArray()));
        var random = new Random(8);
        var inside = 0;
        for (var n = 0; n < 2000; n++)
        {
            var p = new Vec3(random.NextDouble() * 32 - 1, random.NextDouble() * 0.6 - 0.05, random.NextDouble() * 8 - 0.5);
            var within = p.X > 0 && p.Y > 0 && p.Z > 0 && p.X / 30 + p.Y / 0.5 + p.Z / 7 < 1;
            if (within) inside++;
            Assert.That(rays.Winding(p, _ => true), Is.EqualTo(within ? 1 : 0), p.ToString());
            Assert.That(turned.Winding(p, _ => true), Is.EqualTo(within ? -1 : 0), p.ToString());
        }
        Assert.That(inside, Is.GreaterThan(100));
    }

    [Test]
    public void Parameters_beyond_the_ends_of_an_arc_are_its_ends()
    {
        var arc = new ArcCurve(Frame.At(new Vec3(1, 2, 3)), 5, 90);
        Assert.That(arc.PointAt(-0.5), Is.EqualTo(arc.PointAt(0)));
        Assert.That(arc.PointAt(1.5), Is.EqualTo(arc.PointAt(1)));
        Assert.That(arc.PointAt(1).DistanceTo(new Vec3(1, 7, 3)), Is.LessThan(1e-12));
    }
}
