using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Planning;

/// <summary>What depends on the time of layers, and on the flow.</summary>
public class LayerCoolingTests
{
    // One line per layer; 50 mm/s, so that a line of 100 mm takes 2 s.
    private static Step[] Lines(params double[] lengths) => lengths.Select((length, i) =>
    {
        var layer = new Layer(i, 0.2 * (i + 1), 0.2);
        var path = new PrintPath([new(20, 50, layer.Z), new(20 + length, 50, layer.Z)], new Bead(0.08, 0.2)) with { Role = Role.InnerWall, Layer = layer };
        return (Step)new PathStep(path, new StepGroup(i));
    }).ToArray();

    private static readonly PrintSetup Setup = new()
    {
        Material = new Material { MinFanSpeedPercent = 40, MaxFanSpeedPercent = 100, FanLayerTime = 8, FanOffLayers = 1 },
        Settings = new PrintSettings { PrintSpeed = 50, FirstLayerSpeed = 0, MinLayerTime = 2 },
    };

    private static Result<Toolpath> Plan(Step[] steps, PrintSetup setup, PlanPolicy policy = PlanPolicy.Printer)
        => Planner.Plan(steps, setup, new PlanOptions { Policy = policy, Start = new Vec3(0, 0, 5) });

    private static double[] Fans(Toolpath toolpath) => toolpath.Events.Select(e => e.Event).OfType<FanEvent>().Select(e => e.Speed).ToArray();

    [Test]
    public void Quick_layers_get_more_of_the_fan()
    {
        // Off in the first layer; 8 s and more: 40 %; 5 s: halfway; 2 s and less: 100 %.
        var toolpath = Plan(Lines(100, 400, 250, 100, 50), Setup).Value!;
        Assert.That(Fans(toolpath), Is.EqualTo(new[] { 0.4, 0.7, 1 }));
        Assert.That(Fans(Plan(Lines(100, 400, 250, 100), Setup with { Material = Setup.Material with { FanLayerTime = 0 } }).Value!),
            Is.EqualTo(new[] { 0.4 }));
    }

    [Test]
    public void The_head_waits_where_a_layer_lacks_time()
    {
        var pause = Setup with { Settings = Setup.Settings with { LayerTimeWait = LayerTimeWait.Above } };
        // 1 s and 0.5 s of printing: waits of 1 s and 1.5 s after them, none after the last layer.
        var toolpath = Plan(Lines(50, 25, 200, 10), pause).Value!;
        var waits = toolpath.Events.Select(e => e.Event).OfType<DwellEvent>().Select(e => e.Seconds).ToArray();
        Assert.That(waits, Is.EqualTo(new[] { 1, 1.5 }).Within(1e-9));
        var dwells = toolpath.Moves().Where(m => m.Kind == MoveKind.Dwell).ToArray();
        Assert.That(dwells.Select(m => m.Start.Z), Is.EqualTo(new[] { 0.6, 0.8 }).Within(1e-9), "above the print, by the clearance of 0.4 mm");
        foreach (var dwell in dwells)
            Assert.That(toolpath.Moves().Last(m => m.Index < dwell.Index && m.Kind is MoveKind.Print or MoveKind.Retract).Kind, Is.EqualTo(MoveKind.Retract));
        Assert.That(Plan(Lines(50, 25), Setup).Value!.Moves().Any(m => m.Kind == MoveKind.Dwell), Is.False);
    }

    [TestCase(0.8, 1)]
    [TestCase(0.81, 0.2)]
    public void The_head_waits_on_the_layer_where_the_build_volume_ends_below_the_clearance(double clearance, double expected)
    {
        var printer = new Printer { BuildVolume = new Vec3(220, 220, 1), ZHop = clearance };
        var setup = Setup with { Printer = printer, Settings = Setup.Settings with { LayerTimeWait = LayerTimeWait.Above } };
        var dwell = Plan(Lines(50, 200), setup).Value!.Moves().Single(m => m.Kind == MoveKind.Dwell);
        Assert.That(dwell.Start.Z, Is.EqualTo(expected).Within(1e-9));
    }

    [Test]
    public void The_head_waits_beside_the_part_if_asked_to()
    {
        var away = Setup with { Settings = Setup.Settings with { LayerTimeWait = LayerTimeWait.NextTo } };
        double[] X(PrintSetup setup) => Plan(Lines(50, 25, 200), setup).Value!.Moves().Where(m => m.Kind == MoveKind.Dwell).Select(m => m.Start.X).ToArray();
        Assert.That(X(away), Is.EqualTo(new[] { 10.0, 10 }));
        // Where the bed ends on the left, to the right of the layer.
        Step[] Left() => [.. Lines(50, 200).Select(s => (Step)new PathStep(Moved(((PathStep)s).Path), ((PathStep)s).Group))];
        PrintPath Moved(PrintPath path) => path.WithGeometry(path.Points.Select(p => p - new Vec3(15, 0)), [path.BeadOf(0)], false);
        Assert.That(Plan(Left(), away).Value!.Moves().Single(m => m.Kind == MoveKind.Dwell).Start.X, Is.EqualTo(65));
    }

    [Test]
    public void Too_much_flow_slows_down_and_says_so()
    {
        var setup = Setup with { Printer = new Printer { MaxFlow = 2 }, Material = Setup.Material with { MaxFlow = 0 } };
        var result = Plan(Lines(100, 400), setup);
        var speeds = result.Value!.Moves().Where(m => m.Kind == MoveKind.Print).Select(m => m.Speed);
        Assert.That(speeds, Is.All.EqualTo(25).Within(1e-9), "2 mm³/s over 0.08 mm²");
        var note = result.Diagnostics.Single(d => d.Code == "plan.flow_slowed");
        Assert.That((note.Severity, note.Count), Is.EqualTo((Severity.Note, 2)));
        Assert.That(note.Message, Does.Contain("inner wall from 50 to 25 mm/s").And.Contain("2 mm³/s"));
        Assert.That(Plan(Lines(100), Setup).Diagnostics.Select(d => d.Code), Has.None.EqualTo("plan.flow_slowed"));
    }

    [Test]
    public void Moves_that_rise_are_as_fast_as_the_Z_axis_holds_and_one_note_says_so()
    {
        var setup = Setup with { Printer = new Printer { MaxSpeed = new(300, 300, 12, 60), MaxFlow = 0 }, Material = Setup.Material with { MaxFlow = 0 } };
        var layer = new Layer(1, 9, 0.2);
        // Slopes of 3 in 5, nearly the same, 3 in 5 again, 1 in 10 and level.
        Vec3[] points = [new(20, 50), new(24, 50, 3), new(28, 50, 5.99), new(32, 50, 8.99), new(42, 50, 9.99), new(62, 50, 9.99)];
        var path = new PrintPath(points, new Bead(0.08, 0.2)) with { Role = Role.InnerWall, Layer = layer };
        Step[] Steps() => [new PathStep(path, new StepGroup(1))];
        var result = Plan(Steps(), setup);
        var speeds = result.Value!.Moves().Where(m => m.Kind == MoveKind.Print).Select(m => m.Speed).ToArray();
        Assert.That(speeds, Is.EqualTo(new[] { 20, 20, 20, 50, 50 }).Within(0.01));
        Assert.That(speeds[1], Is.EqualTo(speeds[0]), "about the same slope, the same flow");
        var note = result.Diagnostics.Single(d => d.Code == "plan.axis_slowed");
        Assert.That((note.Severity, note.Count), Is.EqualTo((Severity.Note, 3)));
        // 15 mm at 20 instead of 50 mm/s.
        Assert.That(note.Message, Does.Contain("Z 12 mm/s").And.Contain("20 mm/s").And.Contain("takes 1 s"));
        Assert.That(Plan(Steps(), setup, PlanPolicy.AsDrawn).Value!.Moves().Last().Speed, Is.EqualTo(50));
    }

    [Test]
    public void The_least_speed_of_rising_moves_is_that_of_moves_that_the_file_can_show()
    {
        var setup = Setup with { Printer = new Printer { MaxSpeed = new(300, 300, 12, 60), MaxFlow = 0 }, Material = Setup.Material with { MaxFlow = 0 } };
        // The second move is shorter than the last decimal of the file, 0.001 mm.
        Vec3[] points = [new(20, 50), new(24, 50, 3), new(24.0002, 50, 3.0002), new(44, 50, 3.0002)];
        var path = new PrintPath(points, new Bead(0.08, 0.2)) with { Role = Role.InnerWall, Layer = new Layer(1, 9, 0.2) };
        var note = Plan([new PathStep(path, new StepGroup(1))], setup).Diagnostics.Single(d => d.Code == "plan.axis_slowed");
        Assert.That(note.Count, Is.EqualTo(1), "of two moves, one can be seen");
        Assert.That(note.Message, Does.Contain("at least 20 mm/s"));
        var level = new PrintPath(points.Skip(1).ToArray(), new Bead(0.08, 0.2)) with { Role = Role.InnerWall, Layer = new Layer(1, 9, 0.2) };
        Assert.That(Plan([new PathStep(level, new StepGroup(1))], setup).Diagnostics.Select(d => d.Code), Has.None.EqualTo("plan.axis_slowed"));
    }

    [Test]
    public void As_drawn_the_speed_stays()
    {
        var setup = Setup with { Printer = new Printer { MaxFlow = 2 } };
        Assert.That(Plan(Lines(100), setup, PlanPolicy.AsDrawn).Value!.Moves().Last().Speed, Is.EqualTo(50));
    }

    [TestCase("avoid_crossing_max_detour_mm=-1", "avoid_crossing_max_detour_mm")]
    [TestCase("layer_time_wait=long", "layer_time_wait")]
    [TestCase("max_fan_speed_percent=101", "max_fan_speed_percent")]
    [TestCase("fan_layer_time_s=-1", "fan_layer_time_s")]
    public void Bad_values_name_their_key(string set, string key)
        => Assert.That(new PrintSetup().With(set).Diagnostics.Single().ToString(), Does.Contain(key));
}
