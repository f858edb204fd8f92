using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Planning;

/// <summary>The settings of printer, material and print reach the plan.</summary>
public class PlannerTests
{
    private static readonly PlanOptions From0 = new() { Start = Vec3.Zero };

    private static readonly Printer Printer = new()
    {
        RetractionLength = 2, RetractionSpeed = 35, DeretractionSpeed = 25, DeretractionExtra = 0.5, ZHop = 0.6, ZHopSpeed = 8, MaxFlow = 0,
    };

    private static readonly PrintSettings Settings = new()
    {
        PrintSpeed = 50, OuterWallSpeed = 30, FirstLayerSpeed = 20, TravelSpeed = 140, ZHopMinTravel = 1, RetractionMinTravel = 3,
    };

    [Test]
    public void The_moves_follow_the_settings()
    {
        Step[] steps = [Line(0, 0, 0.2, 0), Line(10, 0, 0.2, 0), Line(22, 0, 0.4, 1)];
        var plan = Planner.PlanWithReport(steps, new PrintSetup(Printer, new Material { FilamentDiameter = 2, FlowRatio = 2 }, Settings), From0).Value!;
        // 0.5 mm² over a filament of π mm², twice; 8 mm of path.
        var e = 8 * 0.5 * 2 / Math.PI;
        Assert.That(PlanningTests.Text(plan.Toolpath), Is.EqualTo(new[]
        {
            "Travel 0,0,0.2 0 8", $"Print 8,0,0.2 {E(e)} 20",
            "Travel 8,0,0.8 0 8", "Travel 10,0,0.8 0 140", "Travel 10,0,0.2 0 8", $"Print 18,0,0.2 {E(e)} 20",
            "Retract 18,0,0.2 -2 35", "Travel 18,0,1 0 8", "Travel 22,0,1 0 140", "Travel 22,0,0.4 0 8", "Deretract 22,0,0.4 2 25", "Prime 22,0,0.4 0.5 25",
            $"Print 30,0,0.4 {E(e)} 30",
        }));
        Assert.That(plan.Toolpath.Tools.Single().VolumePerE, Is.EqualTo(Math.PI / 2).Within(1e-12));
        Assert.That(plan.Toolpath.Events, Is.EqualTo(new[] { new MoveEvent(10, new FanEvent(1)) }));
    }

    [Test]
    public void Volumetric_E_and_pens()
    {
        Step[] steps = [Line(0, 0, 0.2, 0), Line(20, 0, 0.2, 0)];
        var volumetric = Planner.Plan(steps,
            new PrintSetup(Printer with { ExtrusionUnit = ExtrusionUnit.Mm3 }, new Material { FilamentDiameter = 2 }, Settings), From0).Value!;
        Assert.That(volumetric.Moves().Where(m => m.Kind == MoveKind.Print).Select(m => m.E), Is.All.EqualTo(4).Within(1e-12));
        Assert.That(volumetric.Moves().Single(m => m.Kind == MoveKind.Retract).E, Is.EqualTo(-2 * Math.PI).Within(1e-12));
        var pen = Planner.Plan(steps, new PrintSetup(Printer with { ExtrusionUnit = ExtrusionUnit.None }, new Material(), Settings), From0).Value!;
        Assert.That(pen.Moves().Select(m => m.E), Is.All.Zero);
        Assert.That(pen.Moves().Select(m => m.Kind).Distinct(), Is.EquivalentTo(new[] { MoveKind.Print, MoveKind.Travel }));
        Assert.That(pen.Tools.Single().VolumePerE, Is.Null);
    }

    [Test]
    public void Fan_and_temperature_change_after_the_first_layers()
    {
        Step[] steps = [Line(0, 0, 0.2, 0), Line(0, 0, 0.4, 1), Line(0, 0, 0.6, 2), Line(0, 0, 0.8, 3)];
        var material = new Material { MinFanSpeedPercent = 50, FanOffLayers = 2, NozzleTemperature = 200, FirstLayerNozzleTemperature = 215 };
        var events = Planner.Plan(steps, new PrintSetup(Printer, material, Settings), From0).Value!.Events;
        Assert.That(events.Select(e => e.Event), Is.EqualTo(new PrinterEvent[] { new NozzleTemperatureEvent(200), new FanEvent(0.5) }));
        var drawn = Planner.Plan(steps, new PrintSetup(Printer, material, Settings), From0 with { Policy = PlanPolicy.AsDrawn }).Value!;
        Assert.That(drawn.Events, Is.Empty);
    }

    [Test]
    public void Paths_without_a_layer_count_by_their_height()
    {
        var helix = new PrintPath([new Vec3(0, 0, 0.1), new Vec3(10, 0, 0.2), new Vec3(10, 10, 0.3)], new Bead(0.1));
        var toolpath = Planner.Plan([helix], new PrintSetup(Printer, new Material(), Settings), From0).Value!;
        Assert.That(toolpath.Moves().Where(m => m.Kind == MoveKind.Print).Select(m => m.Speed), Is.EqualTo(new[] { 20, 50 }));
        Assert.That(toolpath.Events.Single().Event, Is.EqualTo(new FanEvent(1)));
    }

    [Test]
    public void Moves_know_the_place_of_their_step_whether_it_has_a_line_or_not()
    {
        SourceLocation script = new("a.turtle", Line: 7), curves = new("b.csv");
        Step[] steps = [new PathStep(Line(0, 0, 0.2, 0)) { Source = script }, new PathStep(Line(0, 20, 0.2, 0)) { Source = curves }];
        var toolpath = Planner.Plan(steps, new PrintSetup(Printer, new Material(), Settings with { SortPaths = false }), From0).Value!;
        Assert.That(toolpath.Moves().Where(m => m.Kind == MoveKind.Print).Select(m => toolpath.PlaceOf(m.Index)), Is.EqualTo(new[] { script, curves }));
    }

    [Test]
    public void Sorting_can_be_switched_off_in_the_settings()
    {
        Step[] steps = [Grouped(0), Grouped(50), Grouped(10)];
        var setup = new PrintSetup(Printer, new Material(), Settings);
        Assert.That(Order(setup), Is.EqualTo(new[] { 0, 2, 1 }));
        Assert.That(Order(setup with { Settings = Settings with { SortPaths = false } }), Is.EqualTo(new[] { 0, 1, 2 }));

        int[] Order(PrintSetup s) => Planner.Plan(steps, s, From0).Value!.Moves().Where(m => m.Kind == MoveKind.Print).Select(m => m.Source).ToArray();
        static PathStep Grouped(double x) => new(Line(x, 0, 0.2, 0), new StepGroup(0));
    }

    [Test]
    public void The_head_s_outline_becomes_rings_at_the_height_of_their_inner_edge()
    {
        Assert.That(HeadCorridor.Rings([(0.5, 0.0), (4.5, 8.0), (20, 8.0)]),
            Is.EqualTo(new[] { (0.5, 0.0), (1.5, 0.0), (2.5, 2.0), (3.5, 4.0), (4.5, 6.0), (20, 8.0) }));
    }

    [Test]
    public void Every_count_of_the_report_has_a_key()
    {
        var report = new PlanReport { Paths = 3, SortedTravel = 2.5 };
        Assert.That(report.ToValues().Count, Is.EqualTo(typeof(PlanReport).GetProperties().Count(p => p.CanWrite)));
        Assert.That(report.ToValues().Select(v => v.Key), Is.Unique);
        Assert.That(report.ToValues().Where(v => v.Value != 0).Select(v => (v.Key, v.Value)), Is.EqualTo(new[] { ("paths", 3), ("sorted_travel_mm", 2.5) }));
    }

    [Test]
    public void Misuse_throws()
    {
        Assert.That(() => Planner.Plan((IReadOnlyList<Step>)null!, new PrintSetup()), Throws.ArgumentNullException);
        Assert.That(() => Planner.Plan(Array.Empty<Step>(), null!), Throws.ArgumentNullException);
        Assert.That(() => Planner.Plan(new Step[] { null! }, new PrintSetup()), Throws.ArgumentException);
    }

    private static string E(double e) => NumberFormatter.Format(e, 5);

    private static PrintPath Line(double x, double y, double z, int layer) => new([new Vec3(x, y, z), new Vec3(x + 8, y, z)], new Bead(0.5))
    {
        Layer = new Layer(layer, z), Role = layer > 0 ? Role.OuterWall : Role.Infill,
    };

    [Test]
    public void Paths_at_the_heights_of_layers_count_as_these_layers()
    {
        // Layers of 0.2 mm without numbers: the fan starts with the third, at 0.6 mm, rounding errors aside.
        Step[] steps = new[] { 0.2, 0.4, 0.6, 0.8 }.Select(z => (Step)new PathStep(new PrintPath([new Vec3(0, 0, z), new Vec3(10, 0, z)], new Bead(0.1))))
            .ToArray();
        var settings = Settings with { FirstLayerHeight = 0.2, LayerHeight = 0.2 };
        var toolpath = Planner.Plan(steps, new PrintSetup(Printer, new Material { MinFanSpeedPercent = 50, FanOffLayers = 2 }, settings), From0).Value!;
        var fan = toolpath.Events.Single(e => e.Event is FanEvent);
        var first = toolpath.Moves().First(m => m.Kind == MoveKind.Print && m.Index >= fan.Move);
        Assert.That(first.End.Z, Is.EqualTo(0.6).Within(1e-12));
    }
}
