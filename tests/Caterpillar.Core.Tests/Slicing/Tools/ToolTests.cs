using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing.Tools;

/// <summary>Which tool prints what, in which order, with which material and temperature.</summary>
public class ToolTests
{
    internal static readonly Printer TwoNozzles = new() { ToolOffsets = new(Vec3.Zero, new Vec3(18, 0, 0)) };

    private static readonly PrintSettings Settings = new() { TopLayers = 2, BottomLayers = 2, InfillDensityPercent = 20 };

    private static readonly TriMesh Block = Solids.Block(0, 0, 0, 12, 12, 2);

    [Test]
    public void Each_role_is_printed_by_its_tool()
    {
        var layers = Slice(Settings with { PartTool = 3, WallTool = 1, SolidInfillTool = 2 }, Block);
        var tools = layers.SelectMany(l => l.Steps).GroupBy(s => s.Path.Role).ToDictionary(g => g.Key, g => g.Select(s => s.Path.Tool).Distinct().ToArray());
        Assert.That(tools[Role.OuterWall], Is.EqualTo(new[] { 1 }));
        Assert.That(tools[Role.InnerWall], Is.EqualTo(new[] { 1 }));
        Assert.That(tools[Role.Infill], Is.EqualTo(new[] { 3 }));
        Assert.That(tools[Role.BottomSurface], Is.EqualTo(new[] { 2 }));
        Assert.That(tools[Role.TopSurface], Is.EqualTo(new[] { 2 }));
        Assert.That(tools[Role.Bridge], Is.EqualTo(new[] { 2 }));
    }

    [TestCase(1, -1, 1, 1)]
    [TestCase(1, 2, 1, 2)]
    [TestCase(-1, 2, 0, 2)]
    [TestCase(-1, -1, 0, 0)]
    public void Supports_and_their_interface_have_their_tools(int support, int touching, int expected, int expectedTouching)
    {
        var table = TriMesh.Merge([Solids.Block(0, 0, 0, 4, 10, 6), Solids.Block(0, 0, 6, 20, 10, 7)]);
        var layers = Slice(Settings with { Support = SupportKind.Grid, SupportTool = support, SupportInterfaceTool = touching }, table);
        int[] Tools(Role role) => layers.SelectMany(l => l.Steps).Where(s => s.Path.Role == role).Select(s => s.Path.Tool).Distinct().ToArray();
        Assert.That(Tools(Role.Support), Is.EqualTo(new[] { expected }));
        Assert.That(Tools(Role.SupportInterface), Is.EqualTo(new[] { expectedTouching }));
        Assert.That(Tools(Role.OuterWall), Is.EqualTo(new[] { 0 }));
    }

    [TestCase(0)]
    [TestCase(2)]
    public void From_a_height_on_another_tool_prints_the_part(int raft)
    {
        var settings = Settings with { ToolChanges = new(new ToolChange(0.8, 1), new ToolChange(1.6, 0)), SolidInfillTool = 2, RaftLayers = raft };
        var layers = Slice(settings, Block).Where(l => l.Steps[0].Path.Role != Role.Raft).ToArray();
        var bottom = layers[0].Layer.Z - 0.2;
        foreach (var layer in layers)
        {
            var top = layer.Layer.Z - bottom;
            var expected = top > 0.81 && top < 1.61 ? 1 : 0;
            foreach (var (role, tool) in layer.Steps.Select(s => (s.Path.Role, s.Path.Tool)))
                Assert.That(tool, Is.EqualTo(role is Role.OuterWall or Role.InnerWall or Role.Infill ? expected : 2), $"{top} {role}");
        }
    }

    [Test]
    public void Each_part_has_its_tool_and_walls_end_at_a_modifier_with_another_one()
    {
        SliceModel Model(double x, PrintSettings settings) => new(new NamedMesh("part", Solids.Block(x, 0, 0, x + 12, 12, 2)), settings);
        var modifier = Settings with { ModelType = ModelType.Modifier, PartTool = 1 };
        var half = new SliceModel(new NamedMesh("half", Solids.Block(0, 0, -1, 6, 20, 5)), modifier);
        var result = PlanarSlicer.SliceEach([Model(0, Settings), Model(20, Settings with { PartTool = 1 }), half], Settings);
        Assert.That(result.Diagnostics, Is.Empty);
        foreach (var step in result.Value!.Layers.SelectMany(l => l.Steps))
        {
            var box = step.Path.Bounds;
            Assert.That(step.Path.Tool, Is.EqualTo(box.Min.X > 6 && box.Max.X < 13 ? 0 : 1), $"{box}");
            Assert.That(box.Max.X < 6 || box.Min.X > 6, $"{box}");
        }
    }

    [Test]
    public void Infill_of_a_modifier_with_another_tool_leaves_the_walls_as_they_are()
    {
        var modifier = new SliceModel(
            new NamedMesh("half", Solids.Block(0, 0, -1, 6, 20, 5)), Settings with { ModelType = ModelType.Modifier, InfillTool = 1 });
        var layers = PlanarSlicer.SliceEach([new SliceModel(new NamedMesh("part", Block), Settings), modifier], Settings).Value!.Layers;
        var plain = Slice(Settings, Block);
        string[] Walls(IEnumerable<SlicedLayer> all) => [.. all.SelectMany(l => l.Steps).Where(s => s.Path.Role == Role.OuterWall)
            .Select(s => $"{s.Path.Tool} {s.Path.Bounds}")];
        Assert.That(Walls(layers), Is.EqualTo(Walls(plain)));
        Assert.That(layers.SelectMany(l => l.Steps).Where(s => s.Path.Tool == 1).Select(s => s.Path.Role).Distinct(), Is.EqualTo(new[] { Role.Infill }));
    }

    [TestCase(true)]
    [TestCase(false)]
    public void The_last_tool_of_a_layer_begins_the_next(bool sorts)
    {
        SliceModel[] models =
        [
            new(new NamedMesh("a", Solids.Block(0, 0, 0, 8, 8, 1)), Settings),
            new(new NamedMesh("b", Solids.Block(20, 0, 0, 28, 8, 1)), Settings with { PartTool = 1 }),
            new(new NamedMesh("c", Solids.Block(40, 0, 0, 48, 8, 1)), Settings),
        ];
        var result = PlanarSlicer.SliceEach(models, Settings with { SkirtLoops = 1 });
        var setup = new PrintSetup { Printer = TwoNozzles, Settings = Settings with { SortPaths = sorts } };
        var plan = Planner.PlanWithReport(result.Value!.ToSteps(), setup).Value!;
        // Five layers of both tools.
        Assert.That(plan.Report.ToolChanges, Is.EqualTo(5));
        var order = plan.Toolpath.Moves().Where(m => m.Kind == MoveKind.Print).Select(m => (m.Tool, m.End.Z)).Distinct().ToArray();
        Assert.That(order.Select(o => o.Tool), Is.EqualTo(new[] { 0, 1, 1, 0, 0, 1, 1, 0, 0, 1 }));
        Assert.That(order.Select(o => Math.Round(o.Z, 3)), Is.Ordered);
    }

    [Test]
    public void A_tool_that_the_next_layer_needs_comes_last()
    {
        // 0, 1 and 2 below, 1 and 2 above: with 0 1 2 and 2 1 there are three changes.
        SliceModel Model(double x, double height, int tool)
            => new(new NamedMesh("part", Solids.Block(x, 0, 0, x + 8, 8, height)), Settings with { PartTool = tool });
        var layers = PlanarSlicer.SliceEach([Model(0, 0.2, 2), Model(20, 0.4, 1), Model(40, 0.2, 0)], Settings).Value!.Layers;
        Assert.That(layers.Select(l => l.Steps[0].Path.Tool), Is.EqualTo(new[] { 0, 2, 1, 1 }));
    }

    [Test]
    public void One_by_one_parts_with_two_tools_keep_their_order()
    {
        SliceModel Model(double x, int tool) => new(new NamedMesh("part" + tool, Solids.Block(x, 0, 0, x + 8, 8, 0.6)), Settings with { WallTool = tool });
        var common = Settings with { PrintSequence = PrintSequence.ByObject };
        var layers = PlanarSlicer.SliceEach([Model(0, 1), Model(50, 0)], common).Value!.Layers;
        Assert.That(layers.Select(l => l.Layer.Object).Distinct(), Is.EqualTo(new[] { "part1", "part0" }));
        Assert.That(layers.Where(l => l.Layer.Object == "part1").Select(l => l.Steps[0].Path.Tool), Is.EqualTo(new[] { 0, 1, 1, 0, 0, 1 }));
    }

    [Test]
    public void Each_tool_has_the_flow_and_the_diameter_of_its_material()
    {
        var setup = new PrintSetup
        {
            Printer = TwoNozzles, Material = new Material { FilamentDiameter = 1.75, MaxFlow = 4 },
            ToolMaterials = new(new Material { FilamentDiameter = 2.85, FlowRatio = 0.9 }),
        };
        var path = new PrintPath([Vec3.Zero, new Vec3(100, 0, 0.2)], new Bead(0.08, 0.2));
        var toolpath = Planner.Plan([path, path with { Tool = 1 }], setup).Value!;
        var e = toolpath.Moves().Where(m => m.Kind == MoveKind.Print).Select(m => m.E).ToArray();
        var volume = 0.08 * path.Length;
        Assert.That(e[0], Is.EqualTo(volume / (Math.PI / 4 * 1.75 * 1.75)).Within(1e-9));
        Assert.That(e[1], Is.EqualTo(volume * 0.9 / (Math.PI / 4 * 2.85 * 2.85)).Within(1e-9));
        Assert.That(setup.MaxFlow, Is.EqualTo(4));
        Assert.That(setup.OfTool(1).MaxFlow, Is.EqualTo(12));
        Assert.That(setup.OfTool(7), Is.SameAs(setup));
    }

    [Test]
    public void A_nozzle_is_heated_before_it_prints_and_cools_down_in_between()
    {
        var setup = new PrintSetup
        {
            Printer = TwoNozzles, Material = new Material { NozzleTemperature = 200, FirstLayerNozzleTemperature = 205, StandbyTemperature = 150 },
            ToolMaterials = new(new Material { NozzleTemperature = 240, FanOffLayers = 1000 }),
        };
        PrintPath Path(int layer, int tool)
            => new PrintPath([new Vec3(0, 0, 1), new Vec3(10, 0, 1)], new Bead(0.08, 0.2)) with { Layer = new Layer(layer, 1, 0.2, ""), Tool = tool };
        var toolpath = Planner.Plan([Path(0, 0), Path(0, 1), Path(1, 1), Path(1, 0)], setup).Value!;
        PrinterEvent[] expected =
        [
            new NozzleTemperatureEvent(150, false, 0), new ToolEvent(1), new NozzleTemperatureEvent(240, true, 1),
            new ToolEvent(0), new NozzleTemperatureEvent(200, true, 0), new FanEvent(1), new NozzleTemperatureEvent(0, false, 1),
        ];
        Assert.That(toolpath.Events.Select(e => e.Event), Is.EqualTo(expected));
    }

    [Test]
    public void A_shared_nozzle_changes_its_temperature_with_the_material()
    {
        var setup = new PrintSetup
        {
            Printer = TwoNozzles with { SharedNozzle = true },
            Material = new Material { NozzleTemperature = 200, StandbyTemperature = 150, FanOffLayers = 1000 },
            ToolMaterials = new(new Material { NozzleTemperature = 240, FanOffLayers = 1000 }),
        };
        var path = new PrintPath([new Vec3(0, 0, 1), new Vec3(10, 0, 1)], new Bead(0.08, 0.2));
        var toolpath = Planner.Plan([path, path with { Tool = 1 }, path with { Tool = 1 }, path], setup).Value!;
        PrinterEvent[] expected = [new ToolEvent(1), new NozzleTemperatureEvent(240, true), new ToolEvent(0), new NozzleTemperatureEvent(200, true)];
        Assert.That(toolpath.Events.Select(e => e.Event), Is.EqualTo(expected));
    }

    [Test]
    public void Values_of_materials_apply_to_those_of_all_tools()
    {
        var setup = new ProfileLibrary().Setup("generic", "pla", null, ["tool_offsets_mm=0,0,0; 20,0,0", "bed_temperature_c=70"], ["petg"]).Value!;
        Assert.That(setup.ToolMaterials.Select(m => m.Name), Is.EqualTo(new[] { "petg" }));
        Assert.That(setup.ToolMaterials[0].BedTemperature, Is.EqualTo(70));
        Assert.That(setup.ToolMaterials[0].NozzleTemperature, Is.Not.EqualTo(setup.Material.NozzleTemperature));
    }

    [Test]
    public void More_materials_than_tools_are_an_error_that_says_what_to_do()
    {
        var found = new ProfileLibrary().Setup("generic", "pla", null, null, ["petg"]);
        Assert.That(found.Value, Is.Null);
        Assert.That(found.Diagnostics.Single().Code, Is.EqualTo("setup.materials"));
        Assert.That(found.Diagnostics.Single().Message,
            Is.EqualTo("2 materials need as many tools: set tool_offsets_mm of Generic 220 to a list with a row for each."));
    }

    [TestCase("wall_tool=-2", "wall_tool must be -1 to 63, not -2.")]
    [TestCase("part_tool=-1", "part_tool must be 0 to 63, not -1.")]
    [TestCase("part_tool=0.5", "part_tool needs an integer, not 0.5.")]
    [TestCase("tool_changes_mm=5,1; 5,0", "tool_changes_mm must have ascending heights.")]
    [TestCase("tool_changes_mm=5,0.5", "tool_changes_mm needs a list of lists [from, tool], not a list of 1 value.")]
    public void Wrong_values_are_refused(string value, string message)
        => Assert.That(new PrintSetup().With(value).Diagnostics.Select(d => d.Message), Is.EqualTo(new[] { message }));

    [Test]
    public void Changes_of_tools_are_heights_with_tools()
    {
        var settings = new PrintSetup().With("tool_changes_mm=0.5,1; 7.25,0").OrThrow().Settings;
        Assert.That(settings.ToolChanges, Is.EqualTo(new[] { new ToolChange(0.5, 1), new ToolChange(7.25, 0) }));
        Assert.That(new PrintSetup().With("tool_changes_mm=5,0.5; 6,1").Diagnostics, Is.Not.Empty);
        Assert.That(new PrintSetup().With("tool_changes_mm=5,1; 5,2").Diagnostics, Is.Not.Empty);
    }

    [Test]
    public void A_tool_that_the_printer_lacks_is_an_error()
    {
        var steps = Slice(Settings with { WallTool = 1 }, Block).SelectMany(l => l.Steps).ToArray<Step>();
        var plan = Planner.Plan(steps, new PrintSetup());
        Assert.That(plan.Value, Is.Null);
        Assert.That(plan.Diagnostics[0].Code, Is.EqualTo("plan.unknown_tool"));
    }

    private static IReadOnlyList<SlicedLayer> Slice(PrintSettings settings, TriMesh mesh)
    {
        var result = PlanarSlicer.Slice([new NamedMesh("part", mesh)], settings);
        Assert.That(result.Diagnostics.Where(d => d.Severity == Severity.Error), Is.Empty);
        return result.Value!.Layers;
    }
}
