using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Caterpillar.Geometry;
using Caterpillar.Slicing;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry.Meshes;

/// <summary>Meshes that are large enough to be read and joined in pieces, on several threads.</summary>
public class ParallelMeshTests
{
    private static readonly TriMesh Sphere = MeshMaker.BumpySphere(300, 150);

    [TestCase(1, Category = "Arithmetic")]
    [TestCase(2, Category = "Arithmetic")]
    [TestCase(3)]
    [TestCase(8, Category = "Arithmetic")]
    public void Corners_of_a_file_become_the_points_that_they_become_one_by_one(int threads)
    {
        var bytes = StlWriter.ToBytes(Sphere);
        // A coordinate that cannot be used, a negative zero, and a point far out.
        BitConverter.GetBytes(float.NaN).CopyTo(bytes, 84 + 50 * 30_000 + 12);
        BitConverter.GetBytes(-0.0f).CopyTo(bytes, 84 + 50 * 20_000 + 16);
        BitConverter.GetBytes(1e30f).CopyTo(bytes, 84 + 50 * 40_000 + 12);
        var mesh = MeshReader.Read(bytes, "a.stl", new MeshReadOptions { Threads = threads }).Value!.Single().Mesh;
        var (numbers, points, triangles) = (new Dictionary<Vec3, int>(), new List<Vec3>(), new List<int>());
        for (var facet = 0; facet < Sphere.TriangleCount; facet++)
        {
            if (facet is 30_000 or 40_000) continue;
            var corners = Enumerable.Range(0, 3).Select(k => Corner(bytes, facet, k)).Select(p => Number(numbers, points, p)).ToArray();
            if (corners.Distinct().Count() == 3) triangles.AddRange(corners);
        }
        Assert.That(mesh.TriangleCount, Is.EqualTo(triangles.Count / 3).And.GreaterThan(80_000));
        Assert.That(mesh.Indices.Select(i => mesh.Vertices[i]).SequenceEqual(triangles.Select(i => points[i])));
        Assert.That(mesh.Indices.Max(), Is.EqualTo(mesh.VertexCount - 1));
        // Vertices are numbered as they come.
        var next = 0;
        Assert.That(mesh.Indices.All(i => i <= next && (i < next || next++ >= 0)));
    }

    [Test]
    public void Half_edges_of_a_large_mesh_have_the_partners_that_a_table_of_edges_gives_them()
    {
        var mesh = TriMesh.Create(Sphere.Vertices, Sphere.Indices.Skip(3 * 7).ToArray());
        var edges = new Dictionary<(int, int), int>();
        var corners = mesh.Indices;
        for (var h = 0; h < corners.Count; h++) edges[(corners[h], corners[MeshTopology.Next(h)])] = h;
        var expected = corners.Select((c, h) => edges.TryGetValue((corners[MeshTopology.Next(h)], c), out var other) ? other : -1);
        Assert.That(mesh.Topology.Partner.SequenceEqual(expected));
        Assert.That((mesh.NakedEdgeCount, mesh.NonManifoldEdgeCount, mesh.WindingConflictCount), Is.EqualTo((3 * 7 - 2 * 6, 0, 0)));
        Assert.That(mesh.Topology.IsPaired, Is.False);
    }

    [Test]
    public void A_moved_mesh_keeps_its_edges_unless_points_fall_together()
    {
        var box = MeshMaker.Box(0, 0, 0, 1, 2, 1e-9);
        Assert.That(box.IsWatertight);
        var moved = box.Moved(new Vec3(3, 4, 0));
        Assert.That(moved.Topology, Is.SameAs(box.Topology));
        Assert.That((moved.Volume, moved.IsWatertight), Is.EqualTo((box.Volume, true)).Within(1e-20));
        var mirrored = box.Transformed(Affine.Scale(-1, 1, 1));
        Assert.That((mirrored.Topology == box.Topology, mirrored.IsWatertight), Is.EqualTo((false, true)));
        // Upper and lower corners are one.
        var flat = box.Moved(new Vec3(0, 0, 1e8));
        Assert.That((flat.VertexCount, flat.Topology == box.Topology), Is.EqualTo((4, false)));
    }

    [Test]
    public void Reading_in_pieces_hears_a_cancel()
    {
        using var cancel = new CancellationTokenSource();
        cancel.Cancel();
        Assert.That(() => MeshReader.Read(StlWriter.ToBytes(Sphere), "a.stl", cancel: cancel.Token), Throws.InstanceOf<OperationCanceledException>());
    }

    [Test]
    public void The_outline_of_many_points_is_that_of_the_outermost()
    {
        var random = new Random(5);
        for (var round = 0; round < 40; round++)
        {
            // Points on a coarse grid: many lie on one line.
            var cells = round % 2 == 0 ? 12 : 100_000;
            var points = Enumerable.Range(0, 300).Select(_ => new Vec3(random.Next(cells) / 7.0, random.Next(cells) / 7.0, random.Next(3))).ToArray();
            var mesh = TriMesh.Create(points, Enumerable.Range(0, 300).ToArray());
            var hull = Footprint.Of(mesh).Corners;
            for (var i = 0; i < hull.Count; i++)
            {
                Vec3 a = hull[i], b = hull[(i + 1) % hull.Count], c = hull[(i + 2) % hull.Count];
                Assert.That(Turn(a, b, c), Is.GreaterThan(0));
                Assert.That(mesh.Vertices.Min(p => Turn(a, b, p)), Is.GreaterThanOrEqualTo(-1e-9 * (b - a).Length));
                Assert.That(mesh.Vertices.Any(p => p.X == a.X && p.Y == a.Y));
            }
        }
    }

    private static double Turn(Vec3 a, Vec3 b, Vec3 c) => (b.X - a.X) * (c.Y - a.Y) - (b.Y - a.Y) * (c.X - a.X);

    private static Vec3 Corner(byte[] bytes, int facet, int corner)
    {
        var at = 84 + 50 * facet + 12 + 12 * corner;
        return new Vec3(BitConverter.ToSingle(bytes, at) + 0.0, BitConverter.ToSingle(bytes, at + 4) + 0.0, BitConverter.ToSingle(bytes, at + 8) + 0.0);
    }

    private static int Number(Dictionary<Vec3, int> numbers, List<Vec3> points, Vec3 p)
    {
        if (numbers.TryGetValue(p, out var known)) return known;
        points.Add(p);
        return numbers[p] = points.Count - 1;
    }
}
