using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

public class PlanarSlicerTests
{
    private static readonly PrintSettings Plain = new()
    {
        LayerHeight = 0.2, FirstLayerHeight = 0.2, LineWidth = 0.4, BeadShape = BeadShape.Rectangle, WallCount = 2, InfillDensityPercent = 20, InfillAngle = 0,
            InfillOverlapPercent = 15,
        Resolution = 0, SkirtLoops = 0, TopLayers = 0, BottomLayers = 0,
    };

    [Test]
    public void A_block_has_the_layers_walls_and_lines_that_one_computes_by_hand()
    {
        var slices = Slice(Plain, Block(-10, -10, 0, 10, 10, 10));
        Assert.That(slices.Layers, Has.Count.EqualTo(50));
        Assert.That(slices.Layers.Select(l => l.Layer.Z), Is.EqualTo(Enumerable.Range(1, 50).Select(i => 0.2 * i)).Within(1e-12));
        foreach (var layer in slices.Layers)
        {
            var paths = layer.Steps.Select(s => s.Path).ToArray();
            Assert.That(paths.Select(p => p.Points.Max(v => Math.Abs(v.Z - layer.Layer.Z))), Is.All.EqualTo(0));
            // Half a width from the outline: 4 · (20 − 0.4); a pitch further in: 4 · (20 − 1.2).
            Assert.That(paths.Single(p => p.Role == Role.OuterWall).Length, Is.EqualTo(78.4).Within(1e-4));
            Assert.That(paths.Single(p => p.Role == Role.InnerWall).Length, Is.EqualTo(75.2).Within(1e-4));
            // 20 %: every 2 mm. The inside is inset by 0.8 + 0.2 − 0.06 = 0.94, so rows −8 to 8 of 18.12 mm, linked by eight pieces of 2 mm.
            var zigzag = paths.Single(p => p.Role == Role.Infill);
            Assert.That(zigzag.Points, Has.Count.EqualTo(18));
            Assert.That(zigzag.Length, Is.EqualTo(9 * 18.12 + 8 * 2).Within(1e-3));
            var across = zigzag.Points.Select(p => layer.Layer.Index % 2 == 0 ? p.Y : p.X).Distinct(new Nearly()).ToArray();
            Assert.That(across.Select(Math.Abs).Max(), Is.EqualTo(8).Within(1e-6));
            Assert.That(across, Has.Length.EqualTo(9));
        }
    }

    [Test]
    public void Walls_come_before_infill_and_the_outer_wall_after_the_inner_ones()
    {
        var steps = Slice(Plain with { WallCount = 3 }, Block(0, 0, 0, 20, 20, 0.4)).ToSteps().Cast<PathStep>().ToArray();
        var ranks = steps.GroupBy(s => s.Group!.Value.Layer).Select(g => g.OrderBy(s => s.Group!.Value.Rank).Select(s => s.Path.Role).Distinct().ToArray());
        Assert.That(ranks, Is.All.EqualTo(new[] { Role.InnerWall, Role.OuterWall, Role.Infill }));
    }

    [Test]
    public void Full_infill_fills_the_solid()
    {
        var full = Slice(Plain with { InfillDensityPercent = 100, InfillOverlapPercent = 0, BeadShape = BeadShape.Stadium }, Block(0, 0, 0, 30, 20, 2));
        var volume = full.ToSteps().Cast<PathStep>().Sum(s => s.Path.Volume);
        Assert.That(volume, Is.EqualTo(30 * 20 * 2).Within(0.5).Percent);
    }

    [Test]
    public void Holes_get_their_own_walls_in_the_opposite_direction()
    {
        // A block with a shaft: outer walls of 4 · 19.6 and 4 · 10.4, the second clockwise.
        var settings = Plain with { InfillDensityPercent = 0, WallCount = 1, RepairMeshes = false };
        var layer = Slice(settings, Block(-10, -10, 0, 10, 10, 1), Block(-5, -5, -1, 5, 5, 2, inside: true)).Layers[0];
        Assert.That(layer.Steps.Select(s => s.Path.Length).OrderBy(l => l), Is.EqualTo(new[] { 41.6, 78.4 }).Within(1e-4));
        var areas = layer.Steps.Select(s => new Polyline(s.Path.Points, true).SignedAreaXY).OrderBy(a => a).ToArray();
        Assert.That(areas[0], Is.EqualTo(-10.4 * 10.4).Within(1e-3));
        Assert.That(areas[1], Is.EqualTo(19.6 * 19.6).Within(1e-3));
    }

    [Test]
    public void Objects_keep_their_layers_and_are_printed_upward_together()
    {
        var result = PlanarSlicer.Slice([new NamedMesh("low", Block(0, 0, 0, 10, 10, 1)), new NamedMesh("high", Block(20, 0, 0, 30, 10, 2))], Plain);
        var layers = result.Value!.Layers;
        Assert.That(layers.Select(l => l.Layer.Z), Is.Ordered);
        Assert.That(layers.Count(l => l.Layer.Object == "low"), Is.EqualTo(5));
        Assert.That(layers.Count(l => l.Layer.Object == "high"), Is.EqualTo(10));
        Assert.That(layers.Take(2).Select(l => l.Layer.Object), Is.EqualTo(new[] { "low", "high" }));
    }

    [Test]
    public void Where_solids_overlap_their_union_is_printed()
    {
        var layer = Slice(Plain with { InfillDensityPercent = 0, WallCount = 1 }, Block(0, 0, 0, 10, 10, 1), Block(5, 0, 0, 15, 10, 1)).Layers[0];
        Assert.That(layer.Region.Area, Is.EqualTo(150).Within(1e-4));
        Assert.That(layer.Steps.Single().Path.Length, Is.EqualTo(2 * (14.6 + 9.6)).Within(1e-4));
    }

    [Test]
    public void A_skirt_goes_around_the_first_layer_only()
    {
        var slices = Slice(Plain with { SkirtLoops = 2, SkirtDistance = 5 }, Block(0, 0, 0, 10, 10, 1));
        var skirt = slices.ToSteps().Cast<PathStep>().Where(s => s.Path.Role == Role.Skirt).ToArray();
        Assert.That(skirt, Has.Length.EqualTo(2));
        Assert.That(skirt.Select(s => s.Path.Layer!.Index), Is.All.EqualTo(0));
        // Each loop has the next one to lean on.
        Assert.That(skirt[0].Path.Length, Is.GreaterThan(skirt[1].Path.Length + 1));
        // Round corners: 4 · 10 + 2π · 5.2.
        Assert.That(skirt.Min(s => s.Path.Length), Is.EqualTo(40 + 2 * Math.PI * 5.2).Within(0.2));
    }

    [TestCase(1)]
    [TestCase(3)]
    public void The_number_of_threads_changes_nothing(int threads)
    {
        var models = MeshReader.Read(TestData.Shared("meshes/plate_holes.stl")).Value!;
        var settings = Plain with { LayerHeight = 0.5 };
        var sliced = PlanarSlicer.Slice(models, settings, new SliceOptions { Threads = threads }).Value!;
        Assert.That(Describe(sliced), Is.EqualTo(Describe(PlanarSlicer.Slice(models, settings).Value!)));
    }

    [TestCase("spot.obj")]
    [TestCase("plate_holes.stl")]
    [TestCase("overlap_boxes.stl")]
    [TestCase("nested_boxes.obj")]
    [TestCase("fandisk.stl")]
    public void Every_extrusion_stays_inside_its_layer(string mesh)
    {
        var models = MeshReader.Read(TestData.Shared("meshes/" + mesh)).Value!;
        var slices = PlanarSlicer.Slice(models, Plain with { LayerHeight = 1.7, FirstLayerHeight = 0.3, Resolution = 0.0125 }).Value!;
        foreach (var layer in slices.Layers)
        {
            // An extrusion of 0.4 mm keeps 0.2 mm from the outline, less the tolerance of simplified corners; where the layer is thin, beads share it and
            // single extrusions reach its ends.
            var inside = layer.Region.Offset(-0.186);
            var atEnds = layer.Region.Offset(0.001);
            var thin = layer.Region.NarrowerThan(2.5).Offset(0.05);
            foreach (var step in layer.Steps)
            {
                var path = step.Path;
                for (var i = 0; i < path.SegmentCount; i++)
                {
                    var middle = (path.Points[i] + path.EndOf(i)) * 0.5;
                    var allowed = thin.Contains(middle.X, middle.Y) ? atEnds : inside;
                    Assert.That(allowed.Contains(middle.X, middle.Y), Is.True, $"{mesh} Z {layer.Layer.Z} {path.Role} {middle}");
                }
            }
        }
    }

    [Test]
    public void Models_that_give_nothing_are_an_error()
    {
        var thin = PlanarSlicer.Slice([new NamedMesh("thin", Block(0, 0, 0, 10, 0.05, 1))], Plain with { InfillDensityPercent = 0 });
        Assert.That(thin.Value, Is.Null);
        Assert.That(thin.Diagnostics.Select(d => d.Code), Is.EqualTo(new[] { "slice.empty", "slice.too_thin" }));
        Assert.That(PlanarSlicer.Slice([], Plain).Diagnostics.Single().Code, Is.EqualTo("slice.empty"));
        var sunk = PlanarSlicer.Slice([new NamedMesh("sunk", Block(0, 0, -1, 10, 10, 1))], Plain);
        Assert.That(sunk.Diagnostics.Single().Code, Is.EqualTo("slice.below_bed"));
        Assert.That(sunk.Value!.Layers, Has.Count.EqualTo(5));
    }

    [Test]
    public void Slicing_can_be_canceled()
    {
        using var source = new System.Threading.CancellationTokenSource();
        source.Cancel();
        Assert.That(() => PlanarSlicer.Slice([new NamedMesh("a", Block(0, 0, 0, 10, 10, 10))], Plain, cancel: source.Token),
            Throws.InstanceOf<OperationCanceledException>());
    }

    private static SliceResult Slice(PrintSettings settings, params TriMesh[] meshes)
    {
        var result = PlanarSlicer.Slice([new NamedMesh("test", TriMesh.Merge(meshes))], settings);
        Assert.That(result.Diagnostics.Where(d => d.Severity == Severity.Error), Is.Empty);
        return result.Value!;
    }

    private static string Describe(SliceResult slices)
        => string.Join("\n", slices.ToSteps().Cast<PathStep>().Select(s => s.Group + " " + s.Path.Role + " " + string.Join(" ", s.Path.Points)));

    private static TriMesh Block(double x0, double y0, double z0, double x1, double y1, double z1, bool inside = false)
    {
        var corners = Enumerable.Range(0, 8).Select(i => new Vec3((i & 1) == 0 ? x0 : x1, (i & 2) == 0 ? y0 : y1, (i & 4) == 0 ? z0 : z1)).ToArray();
        int[][] quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        var triangles = new List<int>();
        foreach (var q in quads)
        {
            if (inside) Array.Reverse(q);
            triangles.AddRange([q[0], q[1], q[2], q[0], q[2], q[3]]);
        }
        return TriMesh.Create(corners, triangles);
    }

    private sealed class Nearly : IEqualityComparer<double>
    {
        public bool Equals(double a, double b) => Math.Abs(a - b) < 1e-6;

        public int GetHashCode(double value) => 0;
    }
}
