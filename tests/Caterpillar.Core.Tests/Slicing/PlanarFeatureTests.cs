using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

public class PlanarFeatureTests
{
    private static readonly PrintSettings Bare = new()
    {
        LineWidth = 0.4, BeadShape = BeadShape.Rectangle, Resolution = 0, TopLayers = 0, BottomLayers = 0, InfillDensityPercent = 0,
        WallCount = 1, MinLayerTime = 0,
    };

    // A square frame of 30 mm with a hole of 10 mm.
    private static TriMesh[] Ring =>
        [Solids.Block(0, 0, 0, 30, 10, 1), Solids.Block(0, 20, 0, 30, 30, 1), Solids.Block(0, 0, 0, 10, 30, 1), Solids.Block(20, 0, 0, 30, 30, 1)];

    [Test]
    public void A_cube_has_bottom_and_top_surfaces_and_infill_between()
    {
        var layers = Solids.Slice(new PrintSettings { MinLayerTime = 0 }, Solids.Block(0, 0, 0, 20, 20, 10));
        Role[] Inner(int i) => Solids.Paths(layers[i]).Select(p => p.Role).Where(r => r is not (Role.OuterWall or Role.InnerWall)).Distinct().ToArray();
        Assert.That(layers, Has.Count.EqualTo(50));
        Assert.That(Inner(0), Is.EqualTo(new[] { Role.BottomSurface }));
        Assert.That(new[] { 1, 2, 3, 47, 48 }.Select(Inner), Is.All.EqualTo(new[] { Role.SolidInfill }));
        Assert.That(Inner(46), Is.EqualTo(new[] { Role.Bridge }), "over infill");
        Assert.That(Enumerable.Range(4, 42).Select(Inner), Is.All.EqualTo(new[] { Role.Infill }));
        Assert.That(Inner(49), Is.EqualTo(new[] { Role.TopSurface }));
    }

    [TestCase(BeadShape.Rectangle)]
    [TestCase(BeadShape.Stadium)]
    public void A_solid_cube_is_printed_with_its_volume(BeadShape shape)
    {
        var layers = Solids.Slice(new PrintSettings { InfillDensityPercent = 100, BeadShape = shape }, Solids.Block(0, 0, 0, 20, 20, 4));
        Assert.That(Solids.Volume(layers), Is.EqualTo(20 * 20 * 4).Within(1).Percent);
    }

    [Test]
    public void Narrow_closed_areas_are_filled_along_their_outline()
    {
        // A cone: in each layer a ring of some millimeters is closed because the surface is near.
        var settings = Bare with { TopLayers = 6, BottomLayers = 2, WallCount = 2, InfillDensityPercent = 20 };
        PrintPath[] Solid(double narrow)
            => Solids.Paths(Solids.Slice(settings with { NarrowSolidInfill = narrow }, Solids.Cone(0, 20, 10, 2))[15], Role.SolidInfill);
        var (loops, lines) = (Solid(4), Solid(0));
        Assert.That(loops.Sum(p => p.Volume), Is.EqualTo(lines.Sum(p => p.Volume)).Within(4).Percent);
        Assert.That(loops.Count(p => p.IsClosed), Is.GreaterThan(0));
        Assert.That(lines.Count(p => p.IsClosed), Is.Zero);
    }

    [Test]
    public void Walls_that_hang_over_are_slower_from_where_they_do()
    {
        // The upper block reaches 5 mm beyond the lower one: the wall's long sides lie on it up to x = 10.
        var settings = Bare with { OverhangClasses = new ValueList<OverhangClass>(new OverhangClass(50, 12, 100, 1.1)), PrintSpeed = 50, OuterWallSpeed = 40 };
        var layers = Solids.Slice(settings, Solids.Block(0, 0, 0, 10, 10, 1), Solids.Block(0, 0, 1, 15, 10, 2));
        var wall = Solids.Paths(layers[5]).Single();
        Assert.That(wall.Length, Is.EqualTo(2 * (14.6 + 9.6)).Within(1e-3));
        var slow = Enumerable.Range(0, wall.SegmentCount).Where(i => wall.BeadOf(i).Speed == 12).ToArray();
        Assert.That(slow.Sum(wall.LengthOf), Is.EqualTo(2 * 4.8 + 9.6).Within(1e-3));
        Assert.That(slow.Select(i => wall.BeadOf(i).Area), Is.All.EqualTo(0.4 * 0.2 * 1.1).Within(1e-9));
        Assert.That(wall.Overrides!.Fan, Is.EqualTo(1));
        Assert.That(wall.Role, Is.EqualTo(Role.OuterWall));
        var supported = Solids.Paths(layers[6]).Single();
        Assert.That((supported.IsUniform, supported.Overrides), Is.EqualTo((true, (PathOverrides?)null)));
    }

    [Test]
    public void Classes_of_overhang_follow_each_other()
    {
        var classes = new ValueList<OverhangClass>(new OverhangClass(25, 30, 0, 1), new OverhangClass(75, 20, 0, 1), new OverhangClass(100, 10, 0, 1));
        // Sides that lean out by 0.1, 0.3 and 0.5 mm a layer: 25, 75 and more than 100 % of an extrusion of 0.4 mm hang over.
        foreach (var (lean, speed) in new[] { (0.05, 0.0), (0.15, 30.0), (0.35, 20.0), (0.5, 10.0) })
        {
            TriMesh[] step = [Solids.Block(0, 0, 0, 10, 10, 0.2), Solids.Block(-lean, -lean, 0.2, 10 + lean, 10 + lean, 0.4)];
            var wall = Solids.Paths(Solids.Slice(Bare with { OverhangClasses = classes }, step)[1]).Single();
            Assert.That(Enumerable.Range(0, wall.SegmentCount).Select(i => wall.BeadOf(i).Speed), Is.All.EqualTo(speed), $"{lean}");
        }
    }

    [Test]
    public void A_brim_lies_around_the_part_or_in_its_holes()
    {
        PrintPath[] Brim(BrimType side) => Solids.Paths(Solids.Slice(Bare with { BrimWidth = 2, BrimType = side }, Ring)[0], Role.Brim);
        // Five loops of 0.4 mm; those in the hole of 10 mm by 10 mm have sharp corners: 4 · (10 − 2 · (0.2 + 0.4 k)).
        Assert.That(Brim(BrimType.OuterOnly), Has.Length.EqualTo(5));
        Assert.That(Brim(BrimType.InnerOnly).Select(p => p.Length), Is.EqualTo(Enumerable.Range(0, 5).Reverse().Select(k => 4 * (9.6 - 0.8 * k))).Within(1e-3));
        Assert.That(Brim(BrimType.OuterAndInner), Has.Length.EqualTo(10));
        Assert.That(Brim(BrimType.OuterOnly)[0].Length, Is.GreaterThan(Brim(BrimType.OuterOnly)[4].Length));
        // A skirt goes around the brim where that is outside.
        double Skirt(double brim, BrimType side)
            => Solids.Paths(Solids.Slice(Bare with { BrimWidth = brim, BrimType = side, SkirtLoops = 1 }, Ring)[0], Role.Skirt).Single().Bounds.Size.X;
        Assert.That(Skirt(2, BrimType.InnerOnly), Is.EqualTo(Skirt(0, BrimType.OuterOnly)).Within(1e-9));
        Assert.That(Skirt(2, BrimType.OuterOnly), Is.EqualTo(Skirt(0, BrimType.OuterOnly) + 4).Within(1e-9));
    }

    [Test]
    public void A_raft_lifts_the_part_and_reaches_beyond_it()
    {
        var settings = Bare with { RaftLayers = 3, RaftLayerHeight = 0.3, RaftGap = 0.15, RaftExpansion = 4, SkirtLoops = 1 };
        var layers = Solids.Slice(settings, Solids.Block(0, 0, 0, 10, 10, 1));
        Assert.That(layers.Select(l => l.Layer.Z), Is.EqualTo(new[] { 0.3, 0.6, 0.9, 1.25, 1.45, 1.65, 1.85, 2.05 }).Within(1e-9));
        Assert.That(Solids.Paths(layers[0]).Select(p => p.Role).Distinct(), Is.EqualTo(new[] { Role.Skirt, Role.Raft }));
        Assert.That(layers[2].Region.Area, Is.EqualTo(100 + 4 * 10 * 4 + Math.PI * 16).Within(1).Percent);
        var numbers = layers.SelectMany(l => l.Steps).Select(s => s.Group!.Value.Layer).ToArray();
        Assert.That(numbers, Is.Ordered);
        Assert.That(numbers.Distinct(), Is.EqualTo(Enumerable.Range(0, 8)));
        // The open layers have 40 % of the extrusions of the closed one.
        double Length(int i) => Solids.Paths(layers[i], Role.Raft).Sum(p => p.Length);
        Assert.That(Length(1) / Length(2), Is.EqualTo(0.4).Within(0.05));
        // Each layer crosses the one below.
        double Along(int i, Vec3 axis)
            => Solids.Paths(layers[i], Role.Raft).Sum(p => Enumerable.Range(0, p.SegmentCount).Sum(k => Math.Abs(Vec3.Dot(p.EndOf(k) - p.Points[k], axis))));
        Assert.That(Enumerable.Range(0, 3).Select(i => Along(i, Vec3.UnitX) > Along(i, Vec3.UnitY)), Is.EqualTo(new[] { true, false, true }));
    }

    [Test]
    public void What_is_too_thin_for_the_turn_of_a_vase_has_walls()
    {
        var settings = Bare with { SpiralVase = true, BottomLayers = 1, BottomThickness = 0, LayerHeight = 0.2 };
        var layers = Solids.Slice(settings, Solids.Block(0, 0, 0, 10, 10, 1), Solids.Block(0, 4, 1, 10, 4.35, 1.4));
        Assert.That(layers[layers.Count - 1].Layer.Z, Is.EqualTo(1.4).Within(1e-9));
    }

    [Test]
    public void A_vase_is_one_line_from_the_bottom_to_the_rim()
    {
        var settings = Bare with { SpiralVase = true, BottomLayers = 2, BottomThickness = 0, LayerHeight = 0.2, SpiralVaseMinFlowPercent = 20 };
        var layers = Solids.Slice(settings, Solids.Cone(0, 10, 6, 14));
        Assert.That(Solids.Paths(layers[0], Role.BottomSurface), Is.Not.Empty);
        var turns = layers.Skip(2).SelectMany(l => Solids.Paths(l)).ToArray();
        Assert.That(turns, Has.Length.EqualTo(30 - 2 + 1));
        for (var i = 1; i < turns.Length; i++) Assert.That(turns[i].Start.DistanceTo(turns[i - 1].End), Is.LessThan(1e-6), $"turn {i}");
        var points = turns.SelectMany(t => t.Points).ToArray();
        Assert.That(points[0].Z, Is.EqualTo(0.4).Within(1e-9));
        Assert.That(points.Last().Z, Is.EqualTo(6).Within(1e-9));
        for (var i = 1; i < points.Length; i++) Assert.That(points[i].Z, Is.GreaterThanOrEqualTo(points[i - 1].Z - 1e-12));
        // The radius grows as evenly as the cone's, less half an extrusion.
        foreach (var p in points) Assert.That(p.LengthXY, Is.EqualTo(10 + 4 * (p.Z - 0.1) / 6 - 0.2).Within(0.14));
        var flow = 0.4 * 0.2;
        Assert.That(turns[0].BeadOf(0).Area / flow, Is.EqualTo(0.2).Within(0.03));
        Assert.That(turns[0].BeadOf(turns[0].SegmentCount - 1).Area / flow, Is.EqualTo(1).Within(0.03));
        Assert.That(turns[1].IsUniform, Is.True);
        var last = turns.Last();
        Assert.That((last.BeadOf(0).Area / flow, last.BeadOf(last.SegmentCount - 1).Area / flow), Is.EqualTo((1.0, 0.2)).Within(0.03));
    }

    [Test]
    public void Rough_walls_stay_within_their_depth_and_depend_on_the_seed_alone()
    {
        var block = Solids.Block(0, 0, 0, 20, 20, 1);
        PrintPath Wall(int seed) => Solids.Paths(Solids.Slice(Bare with { FuzzySkinThickness = 0.3, FuzzySkinSeed = seed }, block)[2]).Single();
        var wall = Wall(1);
        Assert.That(wall.Points.Count, Is.EqualTo(4 * 19.6 / 0.5).Within(15).Percent);
        var course = Region.Rectangle(0.2, 0.2, 19.8, 19.8);
        var (outer, inner) = (course.Offset(0.301), course.Offset(-0.301));
        Assert.That(wall.Points.All(p => outer.Contains(p.X, p.Y) && !inner.Contains(p.X, p.Y)), Is.True);
        Assert.That(wall.Points.Max(p => Math.Abs(p.X - 10)), Is.GreaterThan(9.95));
        Assert.That(Wall(1).Points, Is.EqualTo(wall.Points));
        Assert.That(Wall(2).Points, Is.Not.EqualTo(wall.Points));
    }

    [Test]
    public void Open_contours_are_single_walls_where_wanted()
    {
        var sheet = TriMesh.Create([new(0, 0, 0), new(10, 0, 0), new(10, 0, 2), new(0, 0, 2)], [0, 1, 2, 0, 2, 3]);
        Assert.That(Solids.Try(Bare, sheet).Diagnostics.Select(d => d.Code), Has.Some.EqualTo("slice.broken_mesh").And.Some.EqualTo("slice.empty"));
        var layers = Solids.Slice(Bare with { OpenContours = OpenContours.Walls }, sheet);
        Assert.That(layers.Select(l => Solids.Paths(l).Single().Length), Is.All.EqualTo(10).Within(1e-9));
    }

    [Test]
    public void The_surface_alone_is_one_wall_on_all_contours()
    {
        var layers = Solids.Slice(Bare with { OpenContours = OpenContours.Surface }, Solids.Block(0, 0, 0, 20, 10, 2));
        Assert.That(layers, Has.Count.EqualTo(10));
        foreach (var layer in layers)
        {
            var wall = Solids.Paths(layer).Single();
            Assert.That((wall.IsClosed, wall.Length), Is.EqualTo((true, 60.0)).Within(1e-9));
            Assert.That(wall.Bounds.Size.X, Is.EqualTo(20).Within(1e-9), "Along the contour, not inside of it.");
        }
    }

    [Test]
    public void Infill_of_three_layers_is_printed_at_once()
    {
        var settings = new PrintSettings { CombineInfillLayers = 3, MinLayerTime = 0, TopLayers = 0, BottomLayers = 0 };
        var every = Solids.Slice(settings, Solids.Block(0, 0, 0, 20, 20, 3));
        var single = Solids.Slice(settings with { CombineInfillLayers = 1 }, Solids.Block(0, 0, 0, 20, 20, 3));
        for (var i = 0; i < 15; i++) Assert.That(Solids.Paths(every[i], Role.Infill).Length > 0, Is.EqualTo(i % 3 == 2), $"layer {i}");
        Assert.That(Solids.Paths(every[2], Role.Infill)[0].BeadOf(0).Height, Is.EqualTo(0.6).Within(1e-9));
        double Length(System.Collections.Generic.IEnumerable<SlicedLayer> layers) => layers.Sum(l => Solids.Paths(l, Role.Infill).Sum(p => p.Length));
        Assert.That(Length(every) / Length(single), Is.EqualTo(1.0 / 3).Within(0.02));
    }

    [TestCase(0.5, 1)]
    [TestCase(0, 0)]
    public void Ironing_needs_some_flow(double percent, int ironed)
    {
        var settings = new PrintSettings { Ironing = true, IroningFlowPercent = percent, MinLayerTime = 0 };
        Assert.That(Solids.Slice(settings, Solids.Block(0, 0, 0, 8, 8, 1)).Count(l => Solids.Paths(l, Role.Ironing).Length > 0), Is.EqualTo(ironed));
    }

    [Test]
    public void Ironing_goes_over_the_top_with_little_material()
    {
        var layers = Solids.Slice(new PrintSettings { Ironing = true, MinLayerTime = 0 }, Solids.Block(0, 0, 0, 20, 20, 2));
        Assert.That(layers.Count(l => Solids.Paths(l, Role.Ironing).Length > 0), Is.EqualTo(1));
        var ironing = Solids.Paths(layers[9], Role.Ironing);
        var top = Solids.Paths(layers[9], Role.TopSurface);
        Assert.That(ironing.Sum(p => p.Volume) / top.Sum(p => p.Volume), Is.EqualTo(0.1).Within(0.01));
        Assert.That(layers[9].Steps.Last().Path.Role, Is.EqualTo(Role.Ironing));
    }

    [Test]
    public void Small_layers_are_slowed_down_to_their_least_time_and_no_further_than_the_least_speed()
    {
        // 38.4 mm of wall at 40 mm/s: 0.96 s.
        var settings = Bare with { OuterWallSpeed = 40, FirstLayerSpeed = 0, MinLayerTime = 2, MinPrintSpeed = 10 };
        var block = Solids.Block(0, 0, 0, 10, 10, 1);
        var walls = Solids.Slice(settings, block).Select(l => Solids.Paths(l).Single()).ToArray();
        Assert.That(walls.Select(w => w.BeadOf(0).Speed), Is.All.EqualTo(38.4 / 2).Within(1e-3));
        var quick = Solids.Try(settings with { MinLayerTime = 6 }, block);
        Assert.That(quick.Value!.Layers.Select(l => Solids.Paths(l).Single().BeadOf(0).Speed), Is.All.EqualTo(10).Within(1e-9));
        var note = quick.Diagnostics.Single(d => d.Code == "slice.layer_time");
        Assert.That(note.Count, Is.EqualTo(5));
    }

    [TestCase(1, true)]
    [TestCase(1.5, false)]
    public void The_least_speed_holds_where_the_layer_time_asks_for_1_mm_per_s(double least, bool reached)
    {
        // 10 mm at an own speed of 1 mm/s and 20 mm at 40 mm/s: 30 s are 1 mm/s for all.
        var layer = new Layer(1, 0.4, 0.2);
        Step Line(double length, double speed) => new PathStep(
            new PrintPath([Vec3.Zero, new Vec3(length, 0)], new Bead(0.08, 0.2, speed)) with { Role = Role.InnerWall, Layer = layer }, new StepGroup(1));
        SlicedLayer[] layers = [new(layer, Region.Empty, [(PathStep)Line(10, 1), (PathStep)Line(20, 40)])];
        var cooling = new LayerCooling(Bare with { MinLayerTime = 30, MinPrintSpeed = least });
        cooling.Apply(layers);
        var problems = new DiagnosticList();
        cooling.Report(problems);
        Assert.That(problems.ToList(), Has.Count.EqualTo(reached ? 0 : 1));
        Assert.That(Solids.Paths(layers[0]).Select(p => p.BeadOf(0).Speed), Is.EqualTo(new[] { 1, least }).Within(1e-9), "never faster than before");
    }

    [Test]
    public void Outlines_and_holes_are_compensated_apart()
    {
        double Area(PrintSettings settings, int layer) => Solids.Slice(settings, Ring)[layer].Region.Area;
        Assert.That(Area(Bare with { XySizeCompensation = -0.1 }, 1), Is.EqualTo(29.8 * 29.8 - 10.2 * 10.2).Within(1e-3));
        Assert.That(Area(Bare with { XyHoleCompensation = 0.2 }, 1), Is.EqualTo(900 - 10.4 * 10.4).Within(1e-3));
        var foot = Bare with { ElephantFootCompensation = 0.15 };
        Assert.That((Area(foot, 0), Area(foot, 1)), Is.EqualTo((29.7 * 29.7 - 10.3 * 10.3, 800.0)).Within(1e-3));
    }

    [TestCase("vase")]
    [TestCase("combine_infill_layers")]
    [TestCase("surfaces")]
    public void The_number_of_threads_changes_nothing(string what)
    {
        var every = what == "combine_infill_layers" ? 3 : 1;
        var settings = new PrintSettings { LayerHeight = 0.4, SpiralVase = what == "vase", CombineInfillLayers = every, FuzzySkinThickness = 0.1,
            Ironing = true };
        TriMesh[] meshes = [Solids.Cone(0, 10, 8, 20), Solids.Cone(8, 20, 14, 4), Solids.Block(30, 0, 0, 40, 10, 6)];
        NamedMesh[] models = [new("a", TriMesh.Merge(meshes)), new("b", meshes[2])];
        string Describe(int threads) => string.Join("\n", PlanarSlicer.Slice(models, settings, new SliceOptions { Threads = threads })
            .Value!.Layers.SelectMany(l => l.Steps).Select(s => $"{s.Group} {s.Path.Role} {s.Path.Volume:R} {string.Join(" ", s.Path.Points)}"));
        Assert.That(Describe(1), Is.EqualTo(Describe(4)));
    }
}
