using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Tests.Geometry.Meshes;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

[TestFixture]
public class ModelArrangerTests
{
    private static readonly PrintSettings Plain = new()
    {
        LayerHeight = 0.5, FirstLayerHeight = 0.5, InfillDensityPercent = 0, WallCount = 1, TopLayers = 0, BottomLayers = 0, MinLayerTime = 0,
        BeadShape = BeadShape.Rectangle,
    };

    [Test]
    public void One_model_stands_in_the_middle_of_the_bed()
    {
        var placed = ModelArranger.Arrange([Block("a", 30, 20, 10)], new Printer()).Value!;
        Assert.That(placed[0].Mesh.Bounds, Is.EqualTo(new Bounds(new Vec3(95, 100, 0), new Vec3(125, 120, 10))));
    }

    [Test]
    public void Rows_are_tried_where_the_bed_is_nearly_full()
    {
        // Four of 100 mm: one in the middle would leave no place for another.
        var four = new[] { Block("a", 100, 100, 5) }.Copies(4);
        Inside(ModelArranger.Arrange(four, new Printer()).Value!, new Printer(), 5, 2);
        var five = ModelArranger.Arrange(new[] { Block("a", 100, 100, 5) }.Copies(5), new Printer { Title = "Small" });
        Assert.That(five.Value, Is.Null);
        Assert.That(five.Diagnostics.Single().ToString(), Is.EqualTo(
            "error models.no_space: No room on the bed of Small for a (5): 4 of 5 models fit. Print fewer at once or reduce their spacing."));
    }

    [Test]
    public void Arranged_models_never_overlap_and_stay_on_the_bed([Range(1, 12)] int seed)
    {
        var random = new Random(seed);
        var printer = new Printer
        {
            BedShape = seed % 2 == 0 ? BedShape.Round : BedShape.Rectangle,
            Origin = seed % 3 == 0 ? BedOrigin.Center : BedOrigin.Corner,
            BuildVolume = new Vec3(150 + random.Next(100), 200, 200),
        };
        var corner = printer.BuildBounds.Min;
        if (seed > 6)
        {
            var center = printer.BuildBounds.Center;
            printer = printer with
            {
                ExcludedAreas = new ValueList<Bounds>(
                    new Bounds(center.WithZ(0), (center + new Vec3(20, 30)).WithZ(0)), new Bounds(corner, corner + new Vec3(40, 15))),
            };
        }
        var models = Enumerable.Range(0, 8).Select(i => i % 2 == 0
            ? Block($"m{i}", 5 + random.Next(30), 5 + random.Next(30), 5 + random.Next(30))
            : new NamedMesh($"m{i}", MeshMaker.BumpySphere(24, 12).Scaled(0.1 + 0.3 * random.NextDouble()))).ToArray();
        var options = new ArrangeOptions { Spacing = random.Next(8), Margin = random.Next(5), OneAfterTheOther = seed % 4 == 0 };
        var placed = ModelArranger.Arrange(models, printer, options).Value!;
        Inside(placed, printer, options.Spacing, options.Margin);
        if (options.OneAfterTheOther) Assert.That(ModelCheck.Clearance(placed, printer), Is.Empty);
        var again = ModelArranger.Arrange(models, printer, options).Value!;
        Assert.That(again.Select(m => m.Mesh.Bounds), Is.EqualTo(placed.Select(m => m.Mesh.Bounds)), "the same every time");
        Assert.That(placed.Select(m => m.Name), Is.EqualTo(models.Select(m => m.Name)));
    }

    [Test]
    public void Many_copies_are_placed_as_if_each_looked_for_a_place_of_its_own()
    {
        var (box, tower) = (MeshMaker.Box(0, 0, 0, 9, 14, 5), MeshMaker.Box(0, 0, 0, 12, 12, 30));
        var printer = new Printer();
        // The same shapes, but none is known to be a copy.
        IReadOnlyList<NamedMesh> Models(bool areCopies)
            => Enumerable.Range(0, 120).Select(i => i % 3 == 0 ? tower : box)
                .Select((mesh, i) => new NamedMesh("m" + i, areCopies ? mesh : mesh.Moved(Vec3.Zero))).ToArray();
        var (copies, single) = (ModelArranger.Arrange(Models(true), printer).Value!, ModelArranger.Arrange(Models(false), printer).Value!);
        Assert.That(copies.Select(m => m.Mesh.Bounds), Is.EqualTo(single.Select(m => m.Mesh.Bounds)));
        Assert.That(ModelCheck.Fit(copies, printer), Is.Empty);
    }

    [Test]
    public void Arranging_can_be_canceled()
    {
        using var source = new CancellationTokenSource();
        source.Cancel();
        Assert.That(() => ModelArranger.Arrange([Block("a", 1, 1, 1)], new Printer(), null, source.Token), Throws.InstanceOf<OperationCanceledException>());
        Assert.That(ModelArranger.Arrange([], new Printer()).Value, Is.Empty);
    }

    [Test]
    public void Overlapping_models_are_one_solid_unless_it_is_not_wanted()
    {
        NamedMesh[] models =
        [
            new("a", MeshMaker.Box(0, 0, 0, 10, 10, 2)), new("b", MeshMaker.Box(6, 2, 0, 16, 8, 2)), new("c", MeshMaker.Box(16, 0, 0, 20, 10, 2)),
        ];
        var merged = PlanarSlicer.Slice(models, Plain);
        Assert.That(merged.Diagnostics.Select(d => d.ToString()), Is.EqualTo(new[]
        {
            "note models.merged: a + b overlap and are printed as one solid. merge_overlapping_models=false prints each.",
        }));
        Assert.That(merged.Value!.Layers.Take(2).Select(l => Math.Round(l.Region.Area, 4)), Is.EqualTo(new[] { 136.0, 40 }), "c touches b and stays apart");
        var apart = PlanarSlicer.Slice(models, Plain with { MergeOverlappingModels = false });
        Assert.That((apart.Diagnostics.Count, apart.Value!.Layers.Count), Is.EqualTo((0, 12)));
        var different = PlanarSlicer.SliceEach(
            [new SliceModel(models[0], Plain), new SliceModel(models[1], Plain with { WallCount = 2 })], Plain);
        Assert.That(different.Diagnostics.Single().Code, Is.EqualTo("models.overlap"));
    }

    [Test]
    public void Each_model_has_settings_of_its_own()
    {
        NamedMesh a = new("a", MeshMaker.Box(0, 0, 0, 10, 10, 1)), b = new("b", MeshMaker.Box(20, 0, 0, 30, 10, 1));
        var fine = Plain with { WallCount = 3, LayerHeight = 0.25, FirstLayerHeight = 0.25 };
        var sliced = PlanarSlicer.SliceEach([new SliceModel(a, Plain), new SliceModel(b, fine)], Plain);
        Assert.That(sliced.Value!.Layers.GroupBy(l => l.Layer.Object).Select(g => (g.Key, g.Count(), g.First().Steps.Count)),
            Is.EquivalentTo(new[] { ("a", 2, 1), ("b", 4, 3) }));
    }

    [Test]
    public void Settings_of_one_model_that_hold_for_the_whole_print_are_named()
    {
        NamedMesh a = new("a", MeshMaker.Box(0, 0, 0, 10, 10, 1)), b = new("b", MeshMaker.Box(20, 0, 0, 30, 10, 1));
        var own = Plain with { TravelSpeed = 77, RaftLayers = 2, WallCount = 2 };
        var sliced = PlanarSlicer.SliceEach([new SliceModel(a, Plain), new SliceModel(b, own)], Plain);
        Assert.That(sliced.Diagnostics.Select(d => d.ToString()), Is.EqualTo(new[]
        {
            "b: warning slice.whole_print: travel_speed_mm_s, raft_layers apply to the whole print. Values for one model are ignored.",
        }));
        Assert.That(sliced.Value!.Layers.Select(l => l.Layer.Z).Min(), Is.EqualTo(Plain.FirstLayerHeight), "no raft, so no model is raised");
        Assert.That(sliced.Value.Layers.Where(l => l.Layer.Object == "b").Min(l => l.Layer.Z), Is.EqualTo(Plain.FirstLayerHeight));
        // The settings of another profile that leave the usual value alone are no wish of the model.
        var common = Plain with { TravelSpeed = 99 };
        Assert.That(PlanarSlicer.SliceEach([new SliceModel(a, Plain)], common).Diagnostics, Is.Empty);
    }

    [Test]
    public void One_after_the_other_the_lowest_is_first()
    {
        NamedMesh high = new("high", MeshMaker.Box(0, 0, 0, 10, 10, 2)), low = new("low", MeshMaker.Box(50, 0, 0, 60, 10, 1));
        var byObject = PlanarSlicer.Slice([high, low], Plain with { PrintSequence = PrintSequence.ByObject }).Value!;
        Assert.That(byObject.Layers.Select(l => l.Layer.Object), Is.EqualTo(new[] { "low", "low", "high", "high", "high", "high" }));
        var byLayer = PlanarSlicer.Slice([high, low], Plain).Value!;
        Assert.That(byLayer.Layers.Select(l => l.Layer.Object), Is.EqualTo(new[] { "high", "low", "high", "low", "high", "high" }));
    }

    private static NamedMesh Block(string name, double x, double y, double z) => new(name, MeshMaker.Box(7, 8, 9, 7 + x, 8 + y, 9 + z));

    // Held against the outlines at many heights, not against the footprints that arranging works with.
    private static void Inside(IReadOnlyList<NamedMesh> placed, Printer printer, double spacing, double margin)
    {
        var outlines = placed.Select(Outline).ToArray();
        for (var i = 0; i < outlines.Length; i++)
        {
            Assert.That(placed[i].Mesh.Bounds.Min.Z, Is.Zero.Within(1e-9));
            var grown = outlines[i].Offset(Math.Max(0, spacing - 0.01), JoinStyle.Round);
            for (var j = 0; j < outlines.Length; j++)
            {
                if (j != i) Assert.That(grown.Intersect(outlines[j]).Area, Is.LessThan(1e-6), $"{placed[i].Name} and {placed[j].Name}");
            }
            foreach (var p in placed[i].Mesh.Vertices)
            {
                Assert.That(printer.CanReach(p, 1e-9), Is.True, $"{placed[i].Name} {p}");
                foreach (var area in printer.ExcludedAreas) Assert.That(area.Contains(p.WithZ(0), -1e-6), Is.False, $"{placed[i].Name} {p}");
            }
            if (printer.BedShape == BedShape.Rectangle)
                Assert.That(printer.BuildBounds.Contains(placed[i].Mesh.Bounds.Grow(margin - 1e-6).Min.WithZ(0)), Is.True);
        }
    }

    private static Region Outline(NamedMesh model)
    {
        var heights = Enumerable.Range(1, 9).Select(i => model.Mesh.Bounds.Max.Z * i / 10).ToArray();
        return Region.Union(MeshSections.At(model.Mesh, heights).Value!.Select(s => Region.From(s.Loops)));
    }
}
