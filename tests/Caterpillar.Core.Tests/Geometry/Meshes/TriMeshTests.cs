using System;
using System.Linq;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry.Meshes;

[TestFixture]
public class TriMeshTests
{
    // Coordinates as coarse as those of files, finer than rounding leaves them, and some that fall together.
    [TestCase(1e-3, 7.3)]
    [TestCase(1e-3, 1e8)]
    [TestCase(1e-15, 7.3)]
    [TestCase(1e-15, 0)]
    public void A_moved_mesh_is_its_image_under_the_translation(double step, double shift)
    {
        var random = new Random(3);
        var points = Enumerable.Range(0, 300)
            .Select(_ => new Vec3(step * (float)random.NextDouble(), step * random.Next(9), (float)random.NextDouble())).ToArray();
        var mesh = TriMesh.Create(points, Enumerable.Range(0, 300).ToArray());
        var (moved, image) = (mesh.Moved(new Vec3(shift, -shift, shift)), mesh.Transformed(Affine.Move(new Vec3(shift, -shift, shift))));
        Assert.That(moved.Vertices, Is.EqualTo(image.Vertices));
        Assert.That(moved.Indices, Is.EqualTo(image.Indices));
        Assert.That(moved.NakedEdgeCount, Is.EqualTo(image.NakedEdgeCount));
    }

    [Test]
    public void Box_has_its_measures()
    {
        var box = MeshMaker.Box(100, 0, 0, 101, 2, 3);
        Assert.That((box.VertexCount, box.TriangleCount, box.NakedEdgeCount, box.NonManifoldEdgeCount, box.WindingConflictCount), Is.EqualTo((8, 12, 0, 0, 0)));
        Assert.That((box.IsWatertight, box.BodyCount()), Is.EqualTo((true, 1)));
        Assert.That(box.Volume, Is.EqualTo(6).Within(1e-12));
        Assert.That(box.Area, Is.EqualTo(22).Within(1e-12));
        Assert.That(box.Normal(0), Is.EqualTo(new Vec3(0, 0, -1)));
        Assert.That(MeshMaker.InsideOut(box).Volume, Is.EqualTo(-6).Within(1e-12));
    }

    [Test]
    public void Equal_points_become_one_vertex_and_unused_ones_are_dropped()
    {
        var mesh = TriMesh.Create(
            [new(9, 9, 9), new(0.0, 0, 0), new(1, -0.0, 0), new(0, 1, 0), new(-0.0, 0, -0.0), new(1, 0, 0), new(1, 1, 0)],
            [1, 2, 3, 5, 6, 3, 1, 4, 2]);
        Assert.That(mesh.Vertices, Is.EqualTo(new Vec3[] { new(0, 0), new(1, 0), new(0, 1), new(1, 1) }));
        Assert.That(mesh.Indices, Is.EqualTo(new[] { 0, 1, 2, 1, 3, 2 }));
        Assert.That((mesh.NakedEdgeCount, mesh.BodyCount()), Is.EqualTo((4, 1)));
        Assert.That(1 / mesh.Vertices[0].X, Is.EqualTo(double.PositiveInfinity), "no negative zero is left");
    }

    [Test]
    public void Many_points_are_welded_exactly()
    {
        var random = new Random(3);
        var points = Enumerable.Range(0, 3000).Select(_ => new Vec3(random.Next(10) / 3.0, random.Next(10) / 3.0, random.Next(10) / 3.0)).ToArray();
        var mesh = TriMesh.Create(points, Enumerable.Range(0, 3000).ToArray());
        for (var t = 0; t < mesh.TriangleCount; t++)
        {
            var (a, b, c) = mesh.Triangle(t);
            Assert.That(a != b && b != c && c != a);
        }
        var used = Enumerable.Range(0, 1000)
            .Where(t => points[3 * t] != points[3 * t + 1] && points[3 * t + 1] != points[3 * t + 2] && points[3 * t + 2] != points[3 * t]).ToArray();
        Assert.That(mesh.TriangleCount, Is.EqualTo(used.Length));
        Assert.That(mesh.VertexCount, Is.EqualTo(used.SelectMany(t => points.Skip(3 * t).Take(3)).Distinct().Count()));
        Assert.That(mesh.Indices.Select(i => mesh.Vertices[i]), Is.EqualTo(used.SelectMany(t => points.Skip(3 * t).Take(3))));
    }

    [Test]
    public void Misuse_is_rejected()
    {
        Assert.That(() => TriMesh.Create([Vec3.Zero], [0, 0]), Throws.ArgumentException);
        Assert.That(() => TriMesh.Create([Vec3.Zero], [0, 0, 1]), Throws.ArgumentException);
        Assert.That(() => TriMesh.Create([new Vec3(double.NaN, 0)], [0, 0, 0]), Throws.ArgumentException);
        Assert.That(() => MeshBytes.Box.Scaled(0), Throws.ArgumentException);
        Assert.That(() => MeshBytes.Box.Scaled(double.NaN), Throws.ArgumentException);
        Assert.That(() => MeshBytes.Box.Moved(new Vec3(1e10, 0)), Throws.ArgumentException);
        Assert.That(() => MeshBytes.Box.Rotated(Vec3.Zero, 5), Throws.ArgumentException);
        Assert.That(TriMesh.Create([], []).IsWatertight, Is.False);
        Assert.That(TriMesh.Create([], []).Bounds.IsEmpty);
    }

    [Test]
    public void Meshes_are_moved_scaled_turned_and_mirrored()
    {
        var box = MeshBytes.Box;
        Assert.That(box.Moved(new Vec3(1, 2, 3)).Bounds, Is.EqualTo(new Bounds(new Vec3(1, 2, 3), new Vec3(2, 4, 6))));
        Assert.That(box.Scaled(2).Volume, Is.EqualTo(48).Within(1e-12));
        Assert.That(box.Rotated(Vec3.UnitZ, 90).Bounds, Is.EqualTo(new Bounds(new Vec3(-2, 0, 0), new Vec3(0, 1, 3))));
        var mirrored = box.Transformed(Affine.Scale(-1, 1, 1));
        Assert.That(mirrored.Volume, Is.EqualTo(6).Within(1e-12), "still faces outward");
        var turned = box.Rotated(new Vec3(1, 2, 3), 77.7);
        Assert.That(turned.Volume, Is.EqualTo(6).Within(1e-12));
        Assert.That(turned.Area, Is.EqualTo(22).Within(1e-12));
        var both = Affine.Rotate(Vec3.UnitX, 90).Then(Affine.Move(new Vec3(0, 5)));
        Assert.That(both.Apply(new Vec3(1, 2, 3)), Is.EqualTo(new Vec3(1, 2, 2)));
    }

    [Test]
    public void Merging_joins_patches_and_keeps_bodies()
    {
        var box = MeshBytes.Box;
        var halves = new[] { 0, 18 }.Select(from => TriMesh.Create(box.Vertices, box.Indices.Skip(from).Take(18).ToArray())).ToArray();
        Assert.That(halves.All(h => h.NakedEdgeCount > 0));
        Assert.That(TriMesh.Merge(halves).IsWatertight);
        var two = TriMesh.Merge([box, box.Moved(new Vec3(5, 0))]);
        Assert.That((two.BodyCount(), two.IsWatertight, two.TriangleCount), Is.EqualTo((2, true, 24)));
    }

    [Test]
    public void A_turned_triangle_is_a_winding_conflict()
    {
        var box = MeshBytes.Box;
        var indices = box.Indices.ToArray();
        (indices[0], indices[1]) = (indices[1], indices[0]);
        var mesh = TriMesh.Create(box.Vertices, indices);
        Assert.That((mesh.NakedEdgeCount, mesh.WindingConflictCount, mesh.IsWatertight), Is.EqualTo((0, 3, false)));
    }

    [Test]
    public void Boxes_that_touch_along_an_edge_stay_apart()
    {
        var mesh = TriMesh.Merge([MeshMaker.Box(0, 0, 0, 1, 1, 1), MeshMaker.Box(1, 1, 0, 2, 2, 1), MeshMaker.Box(-1, 0, 0, 0, 1, 1).Moved(new Vec3(0, -5))]);
        Assert.That((mesh.NonManifoldEdgeCount, mesh.NakedEdgeCount), Is.EqualTo((1, 0)));
        var section = MeshSections.At(mesh, [0.5]).Value![0];
        Assert.That(section.Loops.Select(l => l.SignedAreaXY), Is.EqualTo(new[] { 1.0, 1.0, 1.0 }));
        Assert.That(section.OpenLines, Is.Empty);
    }

    [Test]
    public void Written_stl_comes_back()
    {
        var mesh = MeshBytes.Box.Rotated(new Vec3(1, 1, 0), 30);
        var read = MeshReader.Read(StlWriter.ToBytes(mesh, "box"), "x.stl").Value!.Single().Mesh;
        Assert.That(read.TriangleCount, Is.EqualTo(12));
        for (var v = 0; v < 8; v++) Assert.That(read.Vertices.Min(p => p.DistanceTo(mesh.Vertices[v])), Is.LessThan(2e-7));
        Assert.That(() => StlWriter.ToBytes(mesh, "Solid box"), Throws.ArgumentException);
    }

    [TestCase(0)]
    [TestCase(1)]
    [TestCase(2)]
    public void Coordinates_up_to_the_largest_are_taken_and_no_larger_ones(int axis)
    {
        int Added(double value)
        {
            var at = new double[3];
            at[axis] = value;
            return new MeshBuilder(1, 1).AddVertex(at[0], at[1], at[2]);
        }
        Assert.That(new[] { TriMesh.MaxCoordinate, -TriMesh.MaxCoordinate }.Select(Added), Is.All.Zero);
        Assert.That(new[] { 1.001 * TriMesh.MaxCoordinate, double.NaN }.Select(Added), Is.All.EqualTo(-1));
    }
}
