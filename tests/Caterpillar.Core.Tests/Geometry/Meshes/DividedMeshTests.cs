using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry.Meshes;

/// <summary>Meshes whose edges are divided.</summary>
public class DividedMeshTests
{
    private static double Area(TriMesh mesh, int t)
    {
        var (a, b, c) = mesh.Triangle(t);
        return Vec3.Cross(mesh.RawVertices[b] - mesh.RawVertices[a], mesh.RawVertices[c] - mesh.RawVertices[a]).Length / 2;
    }

    private static double Area(TriMesh mesh) => Enumerable.Range(0, mesh.TriangleCount).Sum(t => Area(mesh, t));

    private static double SmallestAngle(TriMesh mesh)
    {
        var least = 180.0;
        for (var t = 0; t < mesh.TriangleCount; t++)
        {
            var (a, b, c) = mesh.Triangle(t);
            foreach (var (p, q, r) in new[] { (a, b, c), (b, c, a), (c, a, b) })
            {
                Vec3 u = mesh.RawVertices[q] - mesh.RawVertices[p], v = mesh.RawVertices[r] - mesh.RawVertices[p];
                least = Math.Min(least, Angle.Atan2(Vec3.Cross(u, v).Length, Vec3.Dot(u, v)));
            }
        }
        return least;
    }

    // A triangle with sides of 3, 4 and 5 mm; its edges by the numbers of their ends: 0-1 (4), 0-2 (3), 1-2 (5).
    private static readonly Vec3[] Corners = [new(0, 0), new(4, 0), new(0, 3)];

    [TestCase(new[] { 2 }, 2)]
    [TestCase(new[] { 0 }, 3)]
    [TestCase(new[] { 1, 2 }, 3)]
    [TestCase(new[] { 0, 1 }, 4)]
    [TestCase(new[] { 0, 1, 2 }, 4)]
    public void A_triangle_is_divided_across_its_longest_edge_too(int[] edges, int triangles)
    {
        var mesh = new DividedMesh(TriMesh.Create(Corners, [0, 1, 2]));
        foreach (var edge in edges) mesh.Divide(edge);
        Assert.That(mesh.IsWhole(0), Is.False);
        Assert.That(mesh.Split(), Is.True);
        Assert.That(mesh.Split(), Is.False, "Nothing more to do.");
        var result = mesh.ToMesh(mesh.Points);
        Assert.That((result.TriangleCount, mesh.Count), Is.EqualTo((triangles, triangles)));
        Assert.That(Area(result), Is.EqualTo(6).Within(1e-12));
        Assert.That(mesh.Middle(2), Is.Not.Negative, "The longest edge.");
        Assert.That(mesh.Points[mesh.Middle(2)], Is.EqualTo(new Vec3(2, 1.5)));
        Assert.That(mesh.Ends(2), Is.EqualTo((1, 2)));
        for (var t = 0; t < triangles; t++) Assert.That(Area(result, t), Is.EqualTo(6.0 / triangles).Or.EqualTo(3).Or.EqualTo(1.5).Within(1e-12));
        var normals = Enumerable.Range(0, triangles).Select(result.Triangle)
            .Select(t => Vec3.Cross(mesh.Points[t.B] - mesh.Points[t.A], mesh.Points[t.C] - mesh.Points[t.A]).Z);
        Assert.That(normals, Has.All.Positive, "The winding stays.");
    }

    [TestCase(1)]
    [TestCase(2)]
    [TestCase(3)]
    public void Divided_at_random_a_mesh_stays_closed_and_its_triangles_wide(int seed)
    {
        var random = new Random(seed);
        var box = MeshMaker.Box(0, 0, 0, 10, 7, 3);
        var mesh = new DividedMesh(box);
        var numbers = new HashSet<int>();
        for (var round = 0; round < 7; round++)
        {
            var edges = mesh.EdgeCount;
            for (var edge = 0; edge < edges; edge++)
            {
                if (random.Next(12) == 0 && mesh.Middle(edge) < 0) mesh.Divide(edge);
            }
            mesh.Split();
            var now = mesh.ToMesh(mesh.Points);
            Assert.That(now.IsWatertight, Is.True);
            Assert.That(now.TriangleCount, Is.EqualTo(mesh.Count));
            Assert.That(Area(now), Is.EqualTo(Area(box)).Within(1e-9));
            Assert.That(now.Volume, Is.EqualTo(210).Within(1e-9));
            // Rivara: at least half of the smallest angle there was.
            Assert.That(SmallestAngle(now), Is.GreaterThan(SmallestAngle(box) / 2));
            numbers.Add(now.TriangleCount);
        }
        Assert.That(numbers, Has.Count.GreaterThan(4), "Some edges are divided in most rounds.");
    }

    [Test]
    public void An_edge_is_divided_where_it_is_asked_for()
    {
        var mesh = new DividedMesh(TriMesh.Create(Corners, [0, 1, 2]), edge => new Vec3(1, edge, 7));
        mesh.Divide(0, new Vec3(3, 0));
        mesh.Divide(0);
        mesh.Split();
        Assert.That(mesh.Points.Skip(3), Is.EqualTo(new[] { new Vec3(3, 0), new Vec3(1, 2, 7) }));
    }
}
