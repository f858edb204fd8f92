using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Caterpillar.Geometry;
using Caterpillar.Tests.Slicing;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry.Meshes;

[TestFixture]
public class MeshRepairTests
{
    private static readonly TriMesh Box = MeshMaker.Box(0, 0, 0, 10, 10, 10);

    [Test]
    public void A_closed_mesh_that_faces_outwards_is_returned_as_it_is()
    {
        var repaired = MeshRepair.ToSolid(Box);
        Assert.That(repaired, Is.EqualTo(RepairedMesh.Unchanged(Box)));
        Assert.That(MeshRepair.ToSolid(TriMesh.Empty).Mesh, Is.SameAs(TriMesh.Empty));
    }

    [Test]
    public void A_missing_triangle_comes_back_as_it_was([Range(0, 11)] int missing)
    {
        var repaired = MeshRepair.ToSolid(Without(Box, missing));
        Assert.That((repaired.Mesh.IsWatertight, repaired.Mesh.TriangleCount, repaired.Holes.Count), Is.EqualTo((true, 12, 1)));
        Assert.That(repaired.Mesh.Volume, Is.EqualTo(1000).Within(1e-9));
        Assert.That(repaired.Holes[0].Area, Is.EqualTo(50).Within(1e-12));
    }

    [Test]
    public void Two_holes_that_touch_in_a_vertex_are_filled_each_for_itself()
    {
        // Triangles 0 (bottom) and 6 (wall at x = 10) share one vertex only.
        var repaired = MeshRepair.ToSolid(Without(Box, 0, 7));
        Assert.That((repaired.Mesh.IsWatertight, repaired.Holes.Count), Is.EqualTo((true, 2)));
        Assert.That(repaired.Mesh.Volume, Is.EqualTo(1000).Within(1e-9));
    }

    [Test]
    public void A_whole_missing_face_is_filled_flat()
    {
        var repaired = MeshRepair.ToSolid(Without(Box, 4, 5));
        Assert.That((repaired.Mesh.IsWatertight, repaired.Holes.Count), Is.EqualTo((true, 1)));
        Assert.That(repaired.Mesh.Volume, Is.EqualTo(1000).Within(1e-9));
        Assert.That(repaired.Holes[0].Width, Is.EqualTo(Math.Sqrt(200)).Within(1e-12));
    }

    [Test]
    public void A_hole_in_the_shape_of_a_star_is_filled_flat()
    {
        var star = Solids.Circle(10, 14).Select((p, i) => i % 2 == 0 ? p : 0.5 * p).ToArray();
        var prism = Solids.Loft(0, star, 4, star);
        var top = Enumerable.Range(0, prism.TriangleCount).Where(t => prism.Normal(t).Z > 0.5).ToArray();
        var repaired = MeshRepair.ToSolid(Without(prism, top));
        Assert.That((repaired.Mesh.IsWatertight, repaired.Holes.Count), Is.EqualTo((true, 1)));
        Assert.That(repaired.Holes[0].Area, Is.EqualTo(prism.Volume / 4).Within(1e-9));
    }

    [Test]
    public void An_edge_that_a_hole_runs_across_comes_back()
    {
        // A roof: its ridge from y = 0 to 9 has a piece without triangles on both sides, so the smallest area would cut it off.
        var points = new List<Vec3>();
        for (var y = 0; y <= 9; y += 3) points.AddRange([new(0, y, 0), new(5, y, 4), new(10, y, 0)]);
        var triangles = new List<int> { 0, 2, 1, 9, 10, 11 };
        for (var row = 0; row < 9; row += 3)
        {
            foreach (var (a, b) in new[] { (0, 1), (1, 2), (2, 0) }) triangles.AddRange([row + a, row + b, row + b + 3, row + a, row + b + 3, row + a + 3]);
        }
        var roof = TriMesh.Create(points.ToArray(), triangles.ToArray());
        Assert.That((roof.IsWatertight, roof.Volume), Is.EqualTo((true, 180.0)));
        // The four triangles beside the ridge in the middle.
        var repaired = MeshRepair.ToSolid(Without(roof, 8, 9, 10, 11));
        Assert.That((repaired.Mesh.IsWatertight, repaired.Holes.Count), Is.EqualTo((true, 1)));
        Assert.That(repaired.Mesh.Volume, Is.EqualTo(180).Within(1e-9));
    }

    [Test]
    public void The_rim_of_a_sheet_stays_open()
    {
        var sheet = TriMesh.Create([new(0, 0, 0), new(10, 0, 1), new(10, 10, 0), new(0, 10, 1)], [0, 1, 2, 0, 2, 3]);
        var repaired = MeshRepair.ToSolid(sheet);
        Assert.That(repaired, Is.EqualTo(RepairedMesh.Unchanged(sheet)));
    }

    [Test]
    public void Triangles_that_were_flipped_are_turned_back([Range(0, 11)] int flipped)
    {
        var repaired = MeshRepair.ToSolid(With(Without(Box, flipped), Flipped(Box, flipped)));
        Assert.That((repaired.Mesh.IsWatertight, repaired.FlippedFaces), Is.EqualTo((true, 1)));
        Assert.That(repaired.Mesh.Volume, Is.EqualTo(1000).Within(1e-9));
    }

    [Test]
    public void Triangles_that_are_there_twice_are_taken_once_whichever_direction_the_copy_has([Range(0, 11)] int doubled, [Values] bool flip)
    {
        var copy = flip ? Flipped(Box, doubled) : Triangle(Box, doubled);
        foreach (var mesh in new[] { With(Box, copy), TriMesh.Create([.. copy, .. Soup(Box)], Enumerable.Range(0, 39).ToArray()) })
        {
            var repaired = MeshRepair.ToSolid(mesh);
            Assert.That((repaired.Mesh.IsWatertight, repaired.DuplicateFaces, repaired.Mesh.TriangleCount), Is.EqualTo((true, 1, 12)));
            Assert.That(repaired.Mesh.Volume, Is.EqualTo(1000).Within(1e-9));
        }
    }

    [Test]
    public void A_shell_that_is_there_twice_inside_out_is_one_solid()
    {
        var same = MeshRepair.ToSolid(TriMesh.Merge([Box, MeshMaker.InsideOut(Box)]));
        Assert.That((same.Mesh.IsWatertight, same.Mesh.TriangleCount, same.DuplicateFaces), Is.EqualTo((true, 12, 12)));
        Assert.That(same.Mesh.Volume, Is.EqualTo(1000).Within(1e-9));
        // Not quite the same: no wall of 0.01 mm is meant.
        var near = MeshRepair.ToSolid(TriMesh.Merge([Box, MeshMaker.InsideOut(MeshMaker.Box(0.01, 0.01, 0.01, 9.99, 9.99, 9.99))]));
        Assert.That(near.FlippedBodies, Is.EqualTo(1));
        Assert.That(AreaAt(near.Mesh, 5), Is.EqualTo(100).Within(1e-6));
    }

    [Test]
    public void Cavities_stay_cavities_even_where_a_triangle_of_them_was_flipped([Range(-1, 11)] int flipped)
    {
        var cavity = MeshMaker.InsideOut(MeshMaker.Box(3, 3, 3, 7, 7, 7));
        if (flipped >= 0) cavity = With(Without(cavity, flipped), Flipped(cavity, flipped));
        var repaired = MeshRepair.ToSolid(TriMesh.Merge([Box, cavity]));
        Assert.That((repaired.FlippedBodies, repaired.FlippedFaces), Is.EqualTo((0, flipped < 0 ? 0 : 1)));
        Assert.That(AreaAt(repaired.Mesh, 5), Is.EqualTo(84).Within(1e-6));
    }

    [Test]
    public void A_body_that_is_inside_out_neither_vanishes_nor_hollows_out_another()
    {
        var other = MeshMaker.InsideOut(MeshMaker.Box(5, 2, 0, 15, 8, 10));
        Assert.That(AreaAt(TriMesh.Merge([Box, other]), 5), Is.EqualTo(100).Within(1e-6), "as it is: 70 left, 30 beside");
        var repaired = MeshRepair.ToSolid(TriMesh.Merge([Box, other]));
        Assert.That(repaired.FlippedBodies, Is.EqualTo(1));
        Assert.That(AreaAt(repaired.Mesh, 5), Is.EqualTo(130).Within(1e-6));
        var alone = MeshRepair.ToSolid(TriMesh.Merge([Box, MeshMaker.InsideOut(MeshMaker.Box(20, 0, 0, 25, 10, 10))]));
        Assert.That(alone.Mesh.Volume, Is.EqualTo(1500).Within(1e-9));
        var whole = MeshRepair.ToSolid(MeshMaker.InsideOut(Box));
        Assert.That(whole.Mesh.Volume, Is.EqualTo(1000).Within(1e-9));
    }

    [Test]
    public void Rims_that_nearly_meet_are_joined_by_moving_the_smaller_piece()
    {
        var shift = new Vec3(0.3, -0.2, 0.1);
        var mesh = With(Without(Box, 6), Triangle(Box, 6).Select(p => p + shift).ToArray());
        var smallFirst = TriMesh.Create([.. Enumerable.Reverse(Soup(mesh))], Enumerable.Range(0, 36).Select(i => i / 3 * 3 + 2 - i % 3).ToArray());
        foreach (var apart in new[] { mesh, smallFirst })
        {
            var repaired = MeshRepair.ToSolid(apart);
            Assert.That((repaired.Mesh.IsWatertight, repaired.MovedVertices), Is.EqualTo((true, 3)));
            Assert.That(repaired.FarthestMove, Is.EqualTo(shift.Length).Within(1e-12));
            Assert.That(repaired.Mesh.Volume, Is.EqualTo(1000).Within(1e-9));
        }
    }

    [Test]
    public void A_triangle_that_has_come_off_is_left_out_where_its_hole_is_filled()
    {
        var sphere = MeshMaker.BumpySphere(24, 12);
        var mesh = With(Without(sphere, 100), Triangle(sphere, 100).Select(p => p + new Vec3(1.5, 1.5, 1.5)).ToArray());
        var repaired = MeshRepair.ToSolid(mesh);
        Assert.That((repaired.Mesh.IsWatertight, repaired.Holes.Count, repaired.LooseFaces), Is.EqualTo((true, 1, 1)));
        Assert.That(repaired.Mesh.Volume, Is.EqualTo(sphere.Volume).Within(1e-6));
    }

    [Test]
    public void Repair_can_be_canceled()
    {
        using var source = new CancellationTokenSource();
        source.Cancel();
        Assert.That(() => MeshRepair.ToSolid(Box, source.Token), Throws.InstanceOf<OperationCanceledException>());
        Assert.That(() => MeshRepair.ToSolid(null!), Throws.ArgumentNullException);
    }

    private static double AreaAt(TriMesh mesh, double z) => ContourMeasure.NonZero(MeshSections.At(mesh, [z]).Value![0].Loops).Area;

    private static Vec3[] Triangle(TriMesh mesh, int t) => [.. mesh.Indices.Skip(3 * t).Take(3).Select(i => mesh.Vertices[i])];

    private static Vec3[] Flipped(TriMesh mesh, int t) => [.. Enumerable.Reverse(Triangle(mesh, t))];

    private static IEnumerable<Vec3> Soup(TriMesh mesh) => mesh.Indices.Select(i => mesh.Vertices[i]);

    private static TriMesh Without(TriMesh mesh, params int[] triangles)
        => TriMesh.Create(mesh.Vertices, mesh.Indices.Where((_, i) => !triangles.Contains(i / 3)).ToArray());

    private static TriMesh With(TriMesh mesh, Vec3[] triangle)
    {
        Vec3[] points = [.. Soup(mesh), .. triangle];
        return TriMesh.Create(points, Enumerable.Range(0, points.Length).ToArray());
    }
}
