using System;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Curved;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Tests.Slicing;
using NUnit.Framework;

namespace Caterpillar.Tests.Curved;

/// <summary>Layers between boundaries of a mesh: harmonic and by distances along its surface.</summary>
public class BoundaryFieldTests
{
    private static readonly TriMesh Cone = CurvedSolids.Loft(Solids.Circle(12, 64), Solids.Circle(8, 64).Select(p => p.WithZ(10)).ToArray());

    private static MeshBoundaries Ends(TriMesh mesh) => MeshBoundaries.Find(mesh).OrThrow();

    private static TriMesh Branching()
        => TestData.Mesh(Path.Combine(TestData.Repository, "examples", "models", "branching.stl")).Moved(new Vec3(100, 100));

    [Test]
    public void By_distances_the_layers_of_a_cone_are_level_and_equally_thick()
    {
        var layers = CurvedSolids.Slice(LayerField.Geodesic(Ends(Cone)), CurvedSolids.Massive, Cone);
        // Along the slope it is 10.77 mm from rim to rim.
        Assert.That(layers, Has.Count.EqualTo(22));
        for (var i = 0; i < layers.Count; i++)
        {
            var z = 10.0 * (i + 1) / 22;
            foreach (var p in CurvedSolids.Points(layers[i])) Assert.That(p.Z, Is.EqualTo(z).Within(0.01));
            var volume = Volume(z) - Volume(z - 10.0 / 22);
            Assert.That(CurvedSolids.Volume(layers[i]), Is.EqualTo(volume).Within(2).Percent, $"layer {i}");
        }

        static double Volume(double z) => Cone.Volume * (1728 - Math.Pow(12 - 0.4 * z, 3)) / (1728 - 512);
    }

    [Test]
    public void Harmonic_layers_of_a_cone_change_with_the_logarithm_of_its_radius()
    {
        var field = LayerField.Harmonic(Ends(Cone));
        var layers = CurvedSolids.Slice(field, CurvedSolids.Massive, Cone);
        for (var i = 0; i < layers.Count; i++)
        {
            var share = (i + 1.0) / layers.Count;
            var radius = 12 * Math.Pow(8 / 12.0, share);
            foreach (var p in CurvedSolids.Points(layers[i])) Assert.That(p.Z, Is.EqualTo((12 - radius) / 0.4).Within(5e-3));
        }
        Assert.That(layers.Sum(CurvedSolids.Volume), Is.EqualTo(Cone.Volume).Within(1.5).Percent);
    }

    [TestCase(true)]
    [TestCase(false)]
    public void Layers_of_a_prism_with_a_tilted_end_divide_its_height_evenly(bool harmonic)
    {
        static double Roof(double x, double y) => 12 + 0.2 * x;
        var part = CurvedSolids.Between(CurvedSolids.Plan(-10, -6, 10, 6), 10, (_, _) => 0, Roof);
        var field = harmonic ? LayerField.Harmonic(Ends(part)) : LayerField.Geodesic(Ends(part));
        var layers = CurvedSolids.Slice(field, CurvedSolids.Massive, part);
        Assert.That(layers.Sum(CurvedSolids.Volume), Is.EqualTo(part.Volume).Within(1).Percent);
        var last = layers[layers.Count - 1];
        foreach (var p in CurvedSolids.Points(last)) Assert.That(p.Z, Is.EqualTo(Roof(p.X, p.Y)).Within(2e-3), "The last layer is the end.");
        foreach (var p in CurvedSolids.Points(layers[layers.Count / 2 - 1])) Assert.That(p.Z, Is.EqualTo(Roof(p.X, p.Y) / 2).Within(harmonic ? 0.8 : 0.35));
    }

    [Test]
    public void Boundaries_are_the_lowest_open_edges_and_all_others()
    {
        var boundaries = Ends(CurvedSolids.Between(CurvedSolids.Plan(0, 0, 10, 10), 2, (_, _) => 0, (_, _) => 5));
        Assert.That(boundaries.Lower.All(v => boundaries.Mesh.Vertices[v].Z == 0));
        Assert.That(boundaries.Upper.All(v => boundaries.Mesh.Vertices[v].Z == 5));
        var low = Solids.Circle(5, 32);
        var tube = OpenTube(low, low.Select(p => p.WithZ(8 + 0.2 * p.X)).ToArray());
        boundaries = Ends(tube);
        Assert.That(boundaries.Lower.All(v => boundaries.Mesh.Vertices[v].Z == 0));
        Assert.That(boundaries.Upper.Select(v => boundaries.Mesh.Vertices[v]).All(p => Math.Abs(p.Z - 8 - 0.2 * p.X) < 1e-9));
        Assert.That(boundaries.Mesh.NakedEdgeCount, Is.EqualTo(boundaries.Lower.Count + boundaries.Upper.Count));
    }

    [Test]
    public void A_lower_boundary_that_touches_nothing_is_an_error()
    {
        var refused = MeshBoundaries.Near(Solids.Block(0, 0, 0, 10, 10, 5), BoundaryShape.Of([-1]), [BoundaryShape.Of([4, 5, 6, 7])]);
        Assert.That(refused.Value, Is.Null);
        Assert.That(refused.Diagnostics.Single().Message, Is.EqualTo("The boundaries touch no vertex of the part."));
    }

    [Test]
    public void A_ball_goes_on_smoothly_all_around_and_has_no_end()
    {
        var ball = CurvedSolids.Lathe(48, [.. Enumerable.Range(1, 23).Select(i => Angle.SinCos(7.5 * i)).Select(a => (10 * a.Sin, 10 - 10 * a.Cos))]);
        Assert.That(MeshBoundaries.Find(ball).Diagnostics.Single().Code, Is.EqualTo("curved.no_boundary"));
    }

    [Test]
    public void New_vertices_between_two_of_a_boundary_belong_to_it()
    {
        var fine = TriMesh.Create([new(0, 0), new(4, 0), new(0, 4), new(2, 0), new(2, 2)], [0, 3, 2, 3, 4, 2, 3, 1, 4]);
        (int, int)[] parents = [(0, 1), (1, 2)];
        Assert.That(BoundaryFinder.Between(fine, 3, parents, [0, 1]), Is.EqualTo(new[] { 0, 1, 3 }));
        Assert.That(BoundaryFinder.Between(fine, 3, parents, [1, 2]), Is.EqualTo(new[] { 1, 2, 4 }));
    }

    [Test]
    public void Boundaries_are_where_surfaces_and_curves_touch_the_part()
    {
        var block = Solids.Block(0, 0, 0, 20, 20, 10);
        var curve = new Polyline([new(0, 0, 6), new(20, 0, 6), new(20, 20, 6), new(0, 20, 6)], closed: true);
        var boundaries = MeshBoundaries.Near(block, null, [BoundaryShape.Of([curve])]).OrThrow();
        Assert.That(boundaries.Upper, Has.Count.GreaterThan(100));
        Assert.That(boundaries.Upper.All(v => Math.Abs(boundaries.Mesh.Vertices[v].Z - 6) < 0.3));
        Assert.That(boundaries.Lower.All(v => boundaries.Mesh.Vertices[v].Z == 0));
        var top = MeshBoundaries.Near(block, null, [BoundaryShape.Of(Solids.Block(-5, -5, 10, 25, 25, 11))]).OrThrow();
        Assert.That(top.Upper.All(v => top.Mesh.Vertices[v].Z == 10), Is.True, "No vertices beside what the shape runs through.");
    }

    [Test]
    public void Boundaries_are_vertices_or_open_edges_by_size()
    {
        var low = Solids.Circle(5, 32);
        var tube = OpenTube(low, low.Select(p => (p * 0.8).WithZ(8)).ToArray());
        var edges = MeshBoundaries.Near(tube, BoundaryShape.OpenEdge(1), [BoundaryShape.OpenEdge(2)]).OrThrow();
        Assert.That(edges.Lower.All(v => edges.Mesh.Vertices[v].Z == 0) && edges.Upper.All(v => edges.Mesh.Vertices[v].Z == 8));
        Assert.That(MeshBoundaries.Near(tube, null, [BoundaryShape.OpenEdge(3)]).Diagnostics.Single().Message, Does.Contain("boundary 1 touches no vertex"));
        int[] At(double z) => Enumerable.Range(0, tube.VertexCount).Where(v => tube.Vertices[v].Z == z).ToArray();
        var vertices = MeshBoundaries.Near(tube, BoundaryShape.Of(At(0)), [BoundaryShape.Of(At(8))]).OrThrow();
        Assert.That(vertices.Lower, Is.EqualTo(edges.Lower.OrderBy(v => v)));
        Assert.That(vertices.Upper, Is.EqualTo(edges.Upper.OrderBy(v => v)));
        // A list of all open edges as the upper end, as others write it.
        var shared = MeshBoundaries.Of(tube, At(0), [.. At(0), .. At(8)]);
        Assert.That(shared.Value!.Upper, Is.EqualTo(vertices.Upper));
        Assert.That(shared.Diagnostics.Single().Code, Is.EqualTo("curved.shared_boundary"));
    }

    [Test]
    public void Layers_of_a_branching_part_end_at_both_of_its_tilted_ends()
    {
        var part = Branching();
        var setup = new PrintSetup().With("layer_height_mm=1.6", "first_layer_height_mm=1.6", "curved_max_gap_mm=2.4", "line_width_mm=2",
            "curved_max_slope_deg=60",
            "skirt_loops=0", "min_layer_time_s=0", "infill_density_percent=10").OrThrow();
        var field = LayerField.Harmonic(Ends(part));
        var result = CurvedSlicer.Slice([new NamedMesh("branching", part)], field, setup);
        Assert.That(result.Diagnostics.Where(d => d.Severity != Severity.Note), Is.Empty);
        var last = result.Value!.Layers[result.Value.Layers.Count - 1];
        Assert.That(last.Region.Islands, Has.Count.EqualTo(2));
        foreach (var p in CurvedSolids.Points(last)) Assert.That(p.Z,
            Is.EqualTo(64 * (1.05 - 0.0045 * Math.Sqrt((p.X - 100) * (p.X - 100) + 100))).Within(0.1));
        Assert.That(result.Value.Layers.SelectMany(CurvedSolids.Points).All(p => p.Z > 0.1 && p.IsFinite));
    }

    [Test]
    public void Parts_without_boundaries_and_folded_ones_are_refused_with_a_reason()
    {
        // A pyramid has no end at its top.
        var pyramid = TriMesh.Create([new(-5, -5), new(5, -5), new(5, 5), new(-5, 5), new(0, 0, 9)], [0, 2, 1, 0, 3, 2, 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4]);
        Assert.That(MeshBoundaries.Find(pyramid).Diagnostics.Single().Code, Is.EqualTo("curved.no_boundary"));
        var block = Solids.Block(0, 0, 0, 10, 10, 5);
        Assert.That(MeshBoundaries.Of(block, [0], [0]).Diagnostics.Single().Message, Does.Contain("meet"));
        Assert.That(MeshBoundaries.Near(block, null, [BoundaryShape.Of(Solids.Block(50, 0, 0, 60, 10, 5))]).Diagnostics.Single().Message,
            Does.Contain("boundary 1 touches no vertex"));
        var two = TriMesh.Merge([block, pyramid.Moved(new Vec3(30, 0))]);
        Assert.That(MeshBoundaries.Find(two).Diagnostics.Single().Message, Does.Contain("not connected"));
        // A mushroom: below its cap layers would look down.
        var mushroom = CurvedSolids.Lathe(32, (4, 0), (4, 10), (14, 6), (14, 12));
        var folded = CurvedSolids.Try(LayerField.Harmonic(Ends(mushroom)), CurvedSolids.Massive, null, mushroom);
        Assert.That(folded.Diagnostics.Single(d => d.Severity == Severity.Error).Code, Is.EqualTo("curved.overhanging_layers"));
        Assert.That(folded.Diagnostics.Single(d => d.Severity == Severity.Error).Message, Does.Contain("Rotate the model"));
    }

    private static TriMesh OpenTube(Vec3[] low, Vec3[] high)
    {
        var n = low.Length;
        var triangles = Enumerable.Range(0, n).SelectMany(i => new[] { i, (i + 1) % n, n + (i + 1) % n, i, n + (i + 1) % n, n + i }).ToArray();
        return TriMesh.Create([.. low, .. high], triangles);
    }
}
