using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

/// <summary>Walls that are fewer or more than wall_count says, and small ones that are slower.</summary>
[TestFixture]
public class IslandWallsTests
{
    private static readonly PrintSettings Plain = new()
    {
        LineWidth = 0.4, BeadShape = BeadShape.Rectangle, Resolution = 0, WallCount = 3, MinLayerTime = 0, LayerHeight = 0.2, InfillDensityPercent = 20,
    };

    // A plate of 20 mm with a boss of 8 mm on it: five layers each.
    private static readonly TriMesh[] Boss = [Solids.Block(0, 0, 0, 20, 20, 1), Solids.Block(6, 6, 1, 14, 14, 2)];

    // A shelf that hangs over by 6 mm on a block of 10 mm.
    private static readonly TriMesh[] Shelf = [Solids.Block(0, 0, 0, 10, 12, 1), Solids.Block(0, 0, 1, 16, 12, 2)];

    private static PrintPath[] Walls(SlicedLayer layer) => Solids.Paths(layer, Role.OuterWall, Role.InnerWall, Role.OverhangWall);

    // Paths of walls in each layer.
    private static int[] Counts(PrintSettings settings, params TriMesh[] meshes)
        => [.. Solids.Slice(settings, meshes).Select(l => Walls(l).Length)];

    [Test]
    public void The_first_layer_alone_has_one_wall()
        => Assert.That(Counts(Plain with { OnlyOneWallFirstLayer = true }, Solids.Block(0, 0, 0, 20, 20, 1)), Is.EqualTo(new[] { 1, 3, 3, 3, 3 }));

    [Test]
    public void Every_other_layer_has_one_wall_more()
    {
        Assert.That(Counts(Plain with { AlternateExtraWall = true }, Solids.Block(0, 0, 0, 20, 20, 1)), Is.EqualTo(new[] { 3, 4, 3, 4, 3 }));
        Assert.That(Counts(Plain with { AlternateExtraWall = true, WallCount = 0 }, Solids.Block(0, 0, 0, 20, 20, 1)), Is.All.Zero);
    }

    [Test]
    public void A_top_surface_has_one_wall_and_the_others_go_around_what_stands_on_it([Values] bool variable)
    {
        var layers = Solids.Slice(Plain with { OnlyOneWallTop = true, VariableWallWidth = variable }, Boss);
        double[] Lengths(int layer) => [.. Walls(layers[layer]).Select(w => w.Length).OrderByDescending(l => l)];

        Assert.That(layers.Select(l => Walls(l).Length), Is.EqualTo(new[] { 3, 3, 3, 3, 3, 3, 3, 3, 3, 1 }));
        // Around the plate, 0.2 mm inside it; then 0.2 and 0.6 mm inside the boss.
        Assert.That(Lengths(4), Is.EqualTo(new[] { 4 * 19.6, 4 * 7.6, 4 * 6.8 }).Within(0.01));
        Assert.That(Lengths(3), Is.EqualTo(new[] { 4 * 19.6, 4 * 18.8, 4 * 18.0 }).Within(0.01));
        Assert.That(Lengths(9), Is.EqualTo(new[] { 4 * 7.6 }).Within(0.01));
    }

    [Test]
    public void Layers_with_one_wall_on_top_hold_the_volume_of_the_part()
    {
        var solid = Plain with { InfillDensityPercent = 100 };
        var (usual, one) = (Solids.Slice(solid, Boss), Solids.Slice(solid with { OnlyOneWallTop = true }, Boss));
        for (var i = 0; i < usual.Count; i++)
            Assert.That(Solids.Volume([one[i]]), Is.EqualTo(Solids.Volume([usual[i]])).Within(0.6).Percent, $"layer {i}");
    }

    [Test]
    public void Slopes_keep_their_walls()
    {
        // Each layer is smaller by 0.4 mm all around: a step, no surface.
        var cone = Solids.Cone(0, 12, 4, 4);
        var (usual, one) = (Solids.Slice(Plain, cone), Solids.Slice(Plain with { OnlyOneWallTop = true }, cone));
        for (var i = 0; i < usual.Count - 1; i++)
            Assert.That(one[i].Steps.Select(s => s.Path.Volume), Is.EqualTo(usual[i].Steps.Select(s => s.Path.Volume)), $"layer {i}");
    }

    [Test]
    public void Overhangs_are_filled_with_walls_from_the_supported_side_outwards()
    {
        var layer = Solids.Slice(Plain with { ExtraWallsOnOverhangs = true }, Shelf)[5];
        // 6 mm hang over: three walls and, with 0.4 mm each, twelve more.
        var extra = layer.Steps.Where(s => s.Group!.Value.Rank < 0).ToArray();
        Assert.That(extra.Select(s => s.Group!.Value.Rank), Is.Ordered);
        Assert.That(extra.Select(s => s.Group!.Value.Rank).Distinct(), Is.EqualTo(Enumerable.Range(3, 12).Reverse().Select(k => -k)));
        // A wall k is 0.4 · k + 0.2 mm from the edges.
        var outermost = extra.Last().Path;
        Assert.That(outermost.Points.Max(p => p.X), Is.EqualTo(16 - 1.4).Within(1e-3));
        Assert.That(outermost.Points.Min(p => p.X), Is.EqualTo(10 - Plain.BridgeAnchor).Within(1e-3), "both ends are anchored");
        Assert.That(extra.First().Path.Points.Max(p => p.X), Is.EqualTo(16 - 5.8).Within(1e-3), "the first is only just over air");
        Assert.That(Solids.Paths(layer, Role.BottomSurface, Role.Bridge), Is.Empty, "nothing else is laid over air");
    }

    [Test]
    public void Walls_over_air_lie_inside_the_part_and_keep_its_volume([Values(1, 2, 3, 4)] int seed)
    {
        var random = new Random(seed);
        // A block of 20 mm with a larger star on it.
        var star = Enumerable.Range(0, 14).Select(i => (Angle: 360.0 / 14 * i, R: 11 + 9 * random.NextDouble()))
            .Select(p => (p.R, SinCos: Caterpillar.Basics.Angle.SinCos(p.Angle))).Select(p => new Vec3(p.R * p.SinCos.Cos, p.R * p.SinCos.Sin)).ToArray();
        TriMesh[] meshes = [Solids.Block(-7, -7, 0, 7, 7, 1), Solids.Loft(1, star, 2, star)];
        var settings = Plain with { InfillDensityPercent = 100, Bridges = false };
        var layer = Solids.Slice(settings with { ExtraWallsOnOverhangs = true }, meshes)[5];
        var usual = Solids.Slice(settings, meshes)[5];

        Assert.That(layer.Steps.Count(s => s.Group!.Value.Rank < 0), Is.GreaterThan(5));
        Assert.That(Solids.Volume([layer]), Is.EqualTo(Solids.Volume([usual])).Within(3).Percent);
        var grown = layer.Region.Offset(0.01);
        foreach (var path in Solids.Paths(layer))
        {
            for (var i = 0; i < path.SegmentCount; i++) Assert.That(grown.ContainsLine(path.Points[i], path.EndOf(i)), $"{path.Role} {path.Points[i]}");
        }
    }

    [Test]
    public void Bridges_and_what_nothing_carries_get_no_walls()
    {
        var settings = Plain with { ExtraWallsOnOverhangs = true };
        TriMesh[] bridge = [Solids.Block(0, 0, 0, 5, 12, 1), Solids.Block(15, 0, 0, 20, 12, 1), Solids.Block(0, 0, 1, 20, 12, 2)];
        TriMesh[] apart = [Solids.Block(0, 0, 0, 5, 12, 1), Solids.Block(15, 0, 0.8, 20, 12, 2)];
        foreach (var meshes in new[] { bridge, apart })
            Assert.That(Solids.Slice(settings, meshes).SelectMany(l => l.Steps).Count(s => s.Group!.Value.Rank < 0), Is.Zero);
    }

    [Test]
    public void Walls_of_small_holes_are_slower_and_never_faster()
    {
        var hole = new Polyline(Solids.Circle(3, 48).Select(p => p + new Vec3(20, 20)), closed: true);
        var plate = Prism.On(Region.Rectangle(0, 0, 40, 40).Subtract(Region.From(hole)), 0.4);
        var settings = Plain with { SmallLoopSpeed = 15, SmallLoopRadius = 3, OuterWallSpeed = 30, PrintSpeed = 50, FirstLayerSpeed = 10 };
        (double Length, double Speed)[] Speeds(PrintSettings s, int layer)
            => [.. Walls(Solids.Slice(s, plate)[layer]).Select(w => (w.Length, w.BeadOf(0).Speed)).OrderBy(w => w.Length)];

        // The walls have radii of 3.2, 3.6 and 4 mm.
        Assert.That(Speeds(settings, 1).Select(w => w.Speed), Is.All.Zero);
        Assert.That(Speeds(settings with { SmallLoopRadius = 3.7 }, 1).Select(w => w.Speed), Is.EqualTo(new[] { 15, 15, 0, 0, 0, 0.0 }));
        Assert.That(Speeds(settings with { SmallLoopRadius = 3.7 }, 0).Select(w => w.Speed), Is.All.Zero, "the first layer is slower");
        Assert.That(Speeds(settings with { SmallLoopRadius = 3.7, SmallLoopSpeed = 80 }, 1).Select(w => w.Speed), Is.All.Zero);
    }

    [Test]
    public void Modifiers_have_their_own_number_of_walls()
    {
        var part = new SliceModel(new NamedMesh("part", Solids.Block(0, 0, 0, 40, 20, 0.4)), Plain);
        var half = new SliceModel(
            new NamedMesh("half", Solids.Block(20, -1, -1, 41, 21, 2)), Plain with { ModelType = ModelType.Modifier, OnlyOneWallFirstLayer = true });
        var layers = PlanarSlicer.SliceEach([part, half], Plain).Value!.Layers;

        Assert.That(layers.Select(l => Walls(l).Length), Is.EqualTo(new[] { 4, 6 }));
    }

    [Test]
    public void The_number_of_threads_changes_nothing()
    {
        var settings = Plain with { OnlyOneWallTop = true, ExtraWallsOnOverhangs = true, AlternateExtraWall = true };
        NamedMesh[] models = [new("boss", TriMesh.Merge(Boss)), new("shelf", TriMesh.Merge(Shelf))];
        string Describe(int threads) => string.Join("\n", PlanarSlicer.Slice(models, settings, new SliceOptions { Threads = threads })
            .Value!.Layers.SelectMany(l => l.Steps).Select(s => $"{s.Group} {s.Path.Role} {string.Join(" ", s.Path.Points)}"));
        Assert.That(Describe(1), Is.EqualTo(Describe(4)));
    }
}
