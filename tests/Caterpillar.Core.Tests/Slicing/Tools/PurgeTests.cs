using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing.Tools;

/// <summary>Purging after tool changes: the tower, its place, and infill that takes the purged material.</summary>
public class PurgeTests
{
    private static readonly PrintSettings Settings = new()
    {
        TopLayers = 1, BottomLayers = 1, PurgeTower = true, PurgeVolume = 20, SkirtLoops = 1, LayerHeight = 0.2, FirstLayerHeight = 0.3,
    };

    private static readonly SliceOptions OnBed = new() { Printer = ToolTests.TwoNozzles };

    [TestCase(20)]
    [TestCase(140)]
    [TestCase(3)]
    public void Each_tool_purges_its_volume_before_it_prints_anything_else(double volume)
    {
        var layers = Slice(Settings with { PurgeVolume = volume }, Part(100, 1.1, 0), Part(120, 1.1, 1));
        var toolpath = Plan(layers);
        var changes = toolpath.Events.Where(e => e.Event is ToolEvent).Select(e => e.Move).ToArray();
        Assert.That(changes, Has.Length.EqualTo(5));
        foreach (var change in changes)
        {
            var next = toolpath.Moves().Skip(change).Where(m => m.Kind == MoveKind.Print).ToArray();
            var purged = next.TakeWhile(m => m.Role == Role.PrimeTower).Sum(m => m.Deposited * toolpath.VolumePerE(m.Tool)!.Value);
            Assert.That(purged, Is.GreaterThanOrEqualTo(volume));
            // A row more at most, and the wall and sparse lines of the layer. The first layer is closed.
            if (next[0].End.Z > 0.31) Assert.That(purged, Is.LessThan(volume + 30));
        }
    }

    [Test]
    public void The_tower_grows_on_each_layer_up_to_the_last_change_and_never_hangs_over()
    {
        // Two tools up to 1.1 mm, then one: tool 1, which ends at 1.1 mm, changes back above.
        var layers = Slice(Settings, Part(100, 2.3, 0), Part(120, 1.1, 1));
        var tower = layers.Where(IsTower).ToArray();
        Assert.That(tower.Select(l => Math.Round(l.Layer.Z, 3)), Is.EqualTo(new[] { 0.3, 0.5, 0.7, 0.9, 1.1, 1.3 }));
        Assert.That(tower.Select(l => Math.Round(l.Layer.Thickness, 3)), Is.EqualTo(new[] { 0.3, 0.2, 0.2, 0.2, 0.2, 0.2 }));
        for (var i = 1; i < tower.Length; i++)
            Assert.That(tower[i].Region.Subtract(tower[i - 1].Region).Area, Is.LessThan(1e-6));
        Assert.That(layers.Select(l => Math.Round(l.Layer.Z, 6)), Is.Ordered);
    }

    [Test]
    public void Layers_without_a_change_keep_the_tower_growing()
    {
        var settings = Settings with { ToolChanges = new(new ToolChange(1.6, 1)) };
        var layers = Slice(settings, new SliceModel(new NamedMesh("part", Solids.Block(100, 100, 0, 110, 110, 3)), settings));
        var tower = layers.Where(IsTower).ToArray();
        Assert.That(tower.Select(l => Math.Round(l.Layer.Z, 3)), Is.EqualTo(new[] { 0.3, 0.5, 0.7, 0.9, 1.1, 1.3, 1.5, 1.7 }));
        Assert.That(tower.Select(l => l.Steps[0].Path.Tool), Is.EqualTo(new[] { 0, 0, 0, 0, 0, 0, 0, 1 }));
        // A wall and sparse lines below, dense rows on top.
        double Filled(SlicedLayer layer) => layer.Steps.Sum(s => s.Path.Length) * 0.45 / layer.Region.Area;
        Assert.That(tower.Skip(1).Take(6).Select(Filled), Has.All.LessThan(0.4));
        Assert.That(Filled(tower[0]), Is.GreaterThan(0.9), "closed, with a brim");
        Assert.That(tower[7].Steps[0].Path.Length * new Bead(0.0814, 0.2).Area, Is.GreaterThanOrEqualTo(20));
    }

    [TestCase(0, 0)]
    [TestCase(2, 0.2)]
    [TestCase(1, 0)]
    public void The_tower_stands_on_the_bed_beside_a_raft(int raft, double gap)
    {
        var settings = Settings with { RaftLayers = raft, RaftGap = gap, SupportTool = 1 };
        var layers = Slice(settings, Part(100, 1.1, 0, settings), Part(120, 1.1, 1, settings));
        var tower = layers.Where(IsTower).GroupBy(l => l.Layer.Z).Select(g => g.First()).ToArray();
        var z = 0.0;
        foreach (var layer in tower.OrderBy(l => l.Layer.Z))
        {
            Assert.That(layer.Layer.Z - layer.Layer.Thickness, Is.EqualTo(z).Within(1e-6));
            Assert.That(layer.Layer.Thickness, Is.LessThan(0.31));
            z = layer.Layer.Z;
        }
        Assert.That(z, Is.EqualTo(layers[layers.Count - 1].Layer.Z).Within(1e-6));
    }

    [Test]
    public void Models_with_other_layer_heights_share_a_tower()
    {
        var thick = Settings with { LayerHeight = 0.3 };
        var layers = Slice(Settings, Part(100, 1.5, 0), Part(120, 1.5, 1, thick));
        var z = 0.0;
        foreach (var layer in layers.Where(IsTower).GroupBy(l => l.Layer.Z).Select(g => g.First()))
        {
            Assert.That(layer.Layer.Z - layer.Layer.Thickness, Is.EqualTo(z).Within(1e-6));
            z = layer.Layer.Z;
        }
        var odd = PlanarSlicer.SliceEach([Part(100, 1.5, 0), Part(120, 1.5, 1, Settings with { LayerHeight = 0.21 })], Settings, OnBed);
        Assert.That(odd.Value, Is.Null);
        Assert.That(odd.Diagnostics.Single().Message,
            Is.EqualTo("Tools change at z = 0.51 mm, only 0.01 mm above the purge tower. Print all models with the same layer heights."));
    }

    [TestCase("generic", 0, 0)]
    [TestCase("prusa_mk3s", 5, 10)]
    [TestCase("rrf_delta", 3, 0)]
    public void The_tower_is_on_the_bed_and_clear_of_everything(string printer, int skirt, double brim)
    {
        var setup = new ProfileLibrary().Setup(printer).Value!;
        var settings = Settings with { SkirtLoops = skirt, BrimWidth = brim };
        var middle = setup.Printer.BuildBounds.Center;
        var keepFree = new Bounds(new Vec3(-300, middle.Y - 30, 0), new Vec3(middle.X, middle.Y + 30, 1));
        var options = new SliceOptions { Printer = setup.Printer with { ExcludedAreas = new(keepFree) } };
        SliceModel Block(double x, int tool)
            => new(new NamedMesh("part", Solids.Block(middle.X + x, middle.Y - 5, 0, middle.X + x + 8, middle.Y + 5, 0.5)), settings with { PartTool = tool });
        var layers = PlanarSlicer.SliceEach([Block(-10, 0), Block(2, 1)], settings, options).Value!.Layers;
        var tower = layers.First(IsTower);
        var printed = new Bounds();
        printed = tower.Steps.Aggregate(Bounds.Empty, (box, s) => box.Include(s.Path.Bounds));
        foreach (var x in new[] { printed.Min.X, printed.Max.X })
        {
            foreach (var y in new[] { printed.Min.Y, printed.Max.Y }) Assert.That(setup.Printer.CanReach(new Vec3(x, y, 0.3)), $"{x} {y}");
        }
        Assert.That(printed.Max.X <= keepFree.Min.X || printed.Min.X >= keepFree.Max.X || printed.Max.Y <= keepFree.Min.Y || printed.Min.Y >= keepFree.Max.Y);
        foreach (var path in layers.Where(l => !IsTower(l)).SelectMany(l => l.Steps).Select(s => s.Path))
        {
            var gap = Math.Max(
                Math.Max(path.Bounds.Min.X - printed.Max.X, printed.Min.X - path.Bounds.Max.X),
                Math.Max(path.Bounds.Min.Y - printed.Max.Y, printed.Min.Y - path.Bounds.Max.Y));
            Assert.That(gap, Is.GreaterThan(2), path.Role.ToString());
        }
    }

    [Test]
    public void The_brim_of_the_tower_is_printed_once()
    {
        var options = OnBed with { Printer = ToolTests.TwoNozzles with { ToolOffsets = new(default, default, default) } };
        int Loops(double brim)
            => PlanarSlicer.SliceEach([Part(100, 0.5, 0), Part(120, 0.5, 1), Part(140, 0.5, 2)], Settings with { PurgeTowerBrimWidth = brim }, options).Value!
                .Layers.Where(IsTower).Sum(l => l.Steps.Count(s => s.Path.IsClosed));
        // Two changes to other tools on the first layer, which is 0.3 mm high; extrusions are 0.45 mm wide.
        Assert.That(Loops(1.2) - Loops(0), Is.EqualTo(3));
    }

    [Test]
    public void The_tower_stands_where_the_settings_place_it_if_there_is_room()
    {
        var layers = Slice(Settings with { PurgeTowerPlace = new(new Vec3(20, 150)) }, Part(100, 0.5, 0), Part(120, 0.5, 1));
        foreach (var tower in layers.Where(IsTower))
            Assert.That((tower.Region.Bounds.Min - new Vec3(20, 150)).LengthXY, Is.LessThan(1e-6));
        foreach (var place in new[] { new Vec3(110, 100), new Vec3(-5, 50) })
        {
            var result = PlanarSlicer.SliceEach([Part(100, 0.5, 0), Part(120, 0.5, 1)], Settings with { PurgeTowerPlace = new(place) }, OnBed);
            Assert.That(result.Value, Is.Null);
            Assert.That(result.Diagnostics.Single().Message, Does.Contain("at purge_tower_place_mm. Move it, or the models."));
        }
        // Models are arranged beside it, wherever it is.
        var setup = new PrintSetup { Printer = ToolTests.TwoNozzles, Settings = Settings with { PurgeTowerPlace = new(new Vec3(100, 100)) } };
        var model = ModelArranger.Arrange([new NamedMesh("part", Solids.Block(0, 0, 0, 45, 45, 0.5))], PrimedArea.Excluded(setup)).Value!.Single();
        var box = model.Mesh.Bounds;
        Assert.That(box.Max.X < 97 || box.Min.X > 138 || box.Max.Y < 97 || box.Min.Y > 128, $"{box.Min} {box.Max}");
    }

    [Test]
    public void Without_room_for_the_tower_nothing_is_printed()
    {
        SliceModel Wide(double y, int tool) => new(new NamedMesh("part", Solids.Block(5, y, 0, 215, y + 100, 0.5)), Settings with { PartTool = tool });
        var result = PlanarSlicer.SliceEach([Wide(5, 0), Wide(110, 1)], Settings, OnBed);
        Assert.That(result.Value, Is.Null);
        Assert.That(result.Diagnostics.Single().ToString(), Is.EqualTo("error slice.purge_tower: There is no room for the purge tower of 35 × 5 mm "
            + "beside the models. Move them, or change purge_tower_width_mm."));
    }

    [Test]
    public void The_nozzle_is_wiped_on_the_tower_when_it_leaves()
    {
        var toolpath = Plan(Slice(Settings, Part(100, 0.7, 0), Part(120, 0.7, 1)));
        var moves = toolpath.Moves().ToArray();
        var left = 0;
        for (var i = 1; i < moves.Length; i++)
        {
            if (moves[i - 1].Role != Role.PrimeTower || moves[i].Role == Role.PrimeTower) continue;
            if (moves[i].Kind is MoveKind.Travel) continue;
            Assert.That(moves[i].Kind, Is.EqualTo(MoveKind.Wipe));
            left++;
        }
        Assert.That(left, Is.EqualTo(3));
        // Each tool waits retracted, and the tower restores it.
        foreach (var change in toolpath.Events.Where(e => e.Event is ToolEvent))
            Assert.That(moves.Take(change.Move).Reverse().First(m => m.E != 0).E, Is.LessThan(0));
    }

    [Test]
    public void Infill_of_parts_that_are_printed_takes_the_purged_material()
    {
        var settings = Settings with { PurgeTower = false, PurgeIntoInfill = true, PurgeVolume = 4, TopLayers = 0, BottomLayers = 0 };
        var layers = Slice(settings, Part(100, 1.1, 0, settings), Part(120, 1.1, 1, settings));
        Assert.That(layers.Where(IsTower), Is.Empty);
        var first = layers.Where(l => l.Layer.Index == 0).SelectMany(l => l.Steps).ToArray();
        var change = Array.FindIndex(first, s => s.Path.Tool == 1);
        // The first thing tool 1 prints is infill of the part of tool 0, whose walls it does not touch.
        Assert.That(first[change].Path.Role, Is.EqualTo(Role.Infill));
        Assert.That(first[change].Path.Bounds.Max.X, Is.LessThan(112));
        var purged = first.Skip(change).TakeWhile(s => s.Path.Role == Role.Infill).Sum(s => s.Path.Length * s.Path.BeadOf(0).Area);
        Assert.That(purged, Is.GreaterThanOrEqualTo(4));
        foreach (var step in layers.SelectMany(l => l.Steps).Where(s => s.Path.Role is Role.OuterWall or Role.InnerWall))
            Assert.That(step.Path.Tool, Is.EqualTo(step.Path.Bounds.Max.X < 115 ? 0 : 1));
    }

    [Test]
    public void Infill_with_a_tool_of_its_own_keeps_it()
    {
        var settings = Settings with { PurgeTower = false, PurgeIntoInfill = true, PurgeVolume = 4, TopLayers = 0, BottomLayers = 0, InfillTool = 0 };
        var layers = Slice(settings, Part(100, 1.1, 0, settings), Part(120, 1.1, 1, settings));
        var infill = layers.SelectMany(l => l.Steps).Where(s => s.Path.Role == Role.Infill && s.Path.Bounds.Min.X > 115);
        Assert.That(infill.Select(s => s.Path.Tool).Distinct(), Is.EqualTo(new[] { 0 }));
    }

    [Test]
    public void What_the_infill_cannot_take_goes_to_the_tower_or_is_reported()
    {
        var settings = Settings with { PurgeTower = false, PurgeIntoInfill = true, PurgeVolume = 500 };
        var result = PlanarSlicer.SliceEach([Part(100, 0.5, 0, settings), Part(120, 0.5, 1, settings)], settings, OnBed);
        Assert.That(result.Diagnostics.Select(d => d.ToString()), Is.EqualTo(new[]
        {
            "warning slice.purge: The infill after a tool change is less than purge_volume_mm3. Set purge_tower=true. (2 times)",
        }));
        var both = Slice(settings with { PurgeTower = true, PurgeTowerWidth = 60 }, Part(100, 0.5, 0, settings), Part(120, 0.5, 1, settings));
        Assert.That(both.Count(IsTower), Is.EqualTo(2));
    }

    [Test]
    public void One_by_one_there_is_no_tower()
    {
        var settings = Settings with { PrintSequence = PrintSequence.ByObject };
        var result = PlanarSlicer.SliceEach([Part(100, 0.5, 0, settings), Part(160, 0.5, 1, settings)], settings, OnBed);
        Assert.That(result.Value!.Layers.Where(IsTower), Is.Empty);
        Assert.That(result.Diagnostics.Select(d => d.Message), Does.Contain(
            "purge_tower has no effect with print_sequence=by_object. The head would hit a tower beside the models."));
    }

    [Test]
    public void The_result_does_not_depend_on_threads_or_on_who_takes_the_layers()
    {
        SliceModel[] models = [Part(100, 1.1, 0), Part(120, 1.1, 1)];
        var taken = new List<SlicedLayer>();
        string[] Text(IEnumerable<SlicedLayer> layers)
            => [.. layers.SelectMany(l => l.Steps).Select(s => $"{s.Path.Tool} {s.Path.Role} {s.Group} {string.Join(" ", s.Path.Points)}")];
        var one = PlanarSlicer.SliceEach(models, Settings, OnBed with { Threads = 1 }).Value!.Layers;
        PlanarSlicer.SliceEach(models, Settings, OnBed with { Threads = 2, Take = taken.AddRange });
        Assert.That(Text(taken), Is.EqualTo(Text(one)));
    }

    [Test]
    public void Arranged_models_leave_room_for_the_tower()
    {
        // Sixteen fit on the bed, and with a tower fewer.
        NamedMesh[] part = [new NamedMesh("part", Solids.Block(0, 0, 0, 45, 45, 0.5))];
        var (setup, plain) = (new PrintSetup { Printer = ToolTests.TwoNozzles, Settings = Settings }, new PrintSetup());
        Assert.That(ModelArranger.Arrange(part.Copies(16), PrimedArea.Excluded(plain)).Value, Is.Not.Null);
        Assert.That(ModelArranger.Arrange(part.Copies(16), PrimedArea.Excluded(setup)).Diagnostics.Single().Code, Is.EqualTo("models.no_space"));
        var arranged = ModelArranger.Arrange(part.Copies(13), PrimedArea.Excluded(setup)).Value!;
        var parts = arranged.Select((m, i) => new SliceModel(m, Settings with { PartTool = i % 2, InfillDensityPercent = 0 })).ToArray();
        Assert.That(PlanarSlicer.SliceEach(parts, Settings, OnBed).Value!.Layers.Count(IsTower), Is.EqualTo(2));
    }

    private static bool IsTower(SlicedLayer layer) => layer.Steps[0].Path.Role == Role.PrimeTower;

    private static SliceModel Part(double x, double height, int tool, PrintSettings? settings = null)
        => new(new NamedMesh("part " + tool, Solids.Block(x, 100, 0, x + 12, 112, height)), (settings ?? Settings) with { PartTool = tool });

    private static IReadOnlyList<SlicedLayer> Slice(PrintSettings settings, params SliceModel[] models)
    {
        var result = PlanarSlicer.SliceEach(models, settings, OnBed);
        Assert.That(result.Value, Is.Not.Null, string.Join("\n", result.Diagnostics));
        return result.Value!.Layers;
    }

    private static Toolpath Plan(IReadOnlyList<SlicedLayer> layers)
        => Planner.Plan([.. layers.SelectMany(l => l.Steps)], new PrintSetup { Printer = ToolTests.TwoNozzles, Settings = Settings }).Value!;
}
