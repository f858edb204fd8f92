using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Planning;

/// <summary>Toolpaths one after the other.</summary>
public sealed class MergeTests
{
    private static readonly PrintSetup Setup = new();
    private static readonly double Unit = Setup.Extrusion.VolumePerE!.Value;

    // A travel and an extrusion of 1 mm of filament.
    private static ToolpathBuilder Line(double x, double z = 0.2)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, null);
        builder.Add(new Vec3(x, 0, z), 0, 0, 100, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.Add(new Vec3(x + 10, 0, z), 1, 1, 40, MoveKind.Print, Role.Infill, -1, 0, 0);
        return builder;
    }

    private static Toolpath Merged(params Toolpath[] toolpaths) => Planner.Merge(toolpaths, Setup).Value!;

    [Test]
    public void The_head_goes_up_over_and_down_without_a_second_retraction()
    {
        var first = Line(0, 5);
        first.Add(new Vec3(10, 0, 5), -0.25, 0, 30, MoveKind.Retract, Role.Unspecified, -1, 0, 0);
        var merged = Merged(first.Build([new ToolpathTool(Unit)]), Line(50).Build([new ToolpathTool(Unit)]));
        var (more, top) = (Setup.Printer.RetractionLength - 0.25, 5 + Setup.Printer.ZHop);
        var expected = new (MoveKind, Vec3, double)[]
        {
            (MoveKind.Travel, new Vec3(0, 0, 5), 0), (MoveKind.Print, new Vec3(10, 0, 5), 1), (MoveKind.Retract, new Vec3(10, 0, 5), -0.25),
            (MoveKind.Retract, new Vec3(10, 0, 5), -more), (MoveKind.Travel, new Vec3(10, 0, top), 0), (MoveKind.Travel, new Vec3(50, 0, top), 0),
            (MoveKind.Travel, new Vec3(50, 0, 0.2), 0), (MoveKind.Deretract, new Vec3(50, 0, 0.2), more + 0.25), (MoveKind.Print, new Vec3(60, 0, 0.2), 1),
        };
        Assert.That(merged.Moves().Select(m => (m.Kind, m.End)), Is.EqualTo(expected.Select(e => (e.Item1, e.Item2))));
        Assert.That(merged.Moves().Select(m => m.E), Is.EqualTo(expected.Select(e => e.Item3)).Within(1e-9));
    }

    [Test]
    public void A_tool_that_the_printer_lacks_is_an_error()
    {
        var builder = Line(0);
        builder.Add(new Vec3(20, 0, 0.2), 1, 1, 40, MoveKind.Print, Role.Infill, -1, 1, 0);
        var merged = Planner.Merge([builder.Build([new ToolpathTool(Unit), new ToolpathTool(Unit)])], Setup);
        Assert.That(merged.Diagnostics.Single().Code, Is.EqualTo("plan.unknown_tool"));
        Assert.That(merged.Diagnostics.Single().Message, Does.StartWith("A toolpath uses tool 1, but the printer has "));
        // Where it begins with that tool, after another one.
        var other = new ToolpathBuilder(MoveSource.Steps, null);
        other.Add(new Vec3(20, 0, 0.2), 1, 1, 40, MoveKind.Print, Role.Infill, -1, 1, 0);
        var two = Planner.Merge([Line(0).Build([new ToolpathTool(Unit)]), other.Build([new ToolpathTool(Unit), new ToolpathTool(Unit)])], Setup);
        Assert.That((two.Value, two.Diagnostics.Single().Code), Is.EqualTo(((Toolpath?)null, "plan.unknown_tool")));
    }

    [Test]
    public void E_of_another_filament_becomes_that_of_the_setup()
    {
        // Twice the volume per mm of filament: half the volume per mm here takes two.
        var merged = Merged(Line(0).Build([new ToolpathTool(2 * Unit)]));
        Assert.That((merged[1].E, merged[1].Deposited, merged.Tools[0].VolumePerE), Is.EqualTo((2.0, 2.0, (double?)Unit)));
        Assert.That(Merged(Line(0).Build([new ToolpathTool(null)]))[1].E, Is.EqualTo(1), "Unknown: as it is.");
    }

    [Test]
    public void Events_layers_turns_and_arcs_stay_with_their_moves()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, null);
        var layer = builder.AddLayer(new Layer(3, 0.8, 0.2));
        builder.AddEvent(new FanEvent(0.5));
        builder.Add(new Vec3(30, 0, 0.8), 0, 0, 100, MoveKind.Travel, Role.Unspecified, layer, 0, 0);
        builder.AddEvent(new DwellEvent(2));
        builder.Add(new Vec3(30, 0, 0.8), 0, 0, 0, MoveKind.Dwell, Role.Unspecified, layer, 0, 0);
        builder.Add(new Vec3(30, 20, 0.8), 1, 1, 40, MoveKind.Print, Role.OuterWall, layer, 0, 0, new Arc(new Vec3(30, 10, 0.8), 180));
        builder.SetRotary(new Vec3(0, 15, 90));
        builder.AddEvent(new PauseEvent("look"));
        var merged = Merged(Line(0).Build([new ToolpathTool(Unit)]), builder.Build([new ToolpathTool(Unit)]));
        var arc = merged[merged.Count - 1];
        Assert.That((arc.Arc!.Value.Sweep, arc.Role, merged.NumberOfLayer(arc), merged.TurnsOf(arc.Index)),
            Is.EqualTo((180.0, Role.OuterWall, (int?)3, (Vec3?)new Vec3(0, 15, 90))));
        var dwell = merged.Moves().Single(m => m.Kind == MoveKind.Dwell);
        Assert.That(dwell.Index, Is.EqualTo(arc.Index - 1));
        Assert.That(merged.Events.Select(e => (e.Move, e.Event)), Is.EqualTo(new (int, PrinterEvent)[]
        {
            (2, new FanEvent(0.5)), (dwell.Index, new DwellEvent(2)), (merged.Count, new PauseEvent("look")),
        }));
    }

    [Test]
    public void One_toolpath_stays_as_it_is_and_none_is_empty()
    {
        var one = Line(0).Build([new ToolpathTool(Unit)]);
        Assert.That(Merged(one).Moves().Select(m => m with { Source = 0 }), Is.EqualTo(one.Moves()));
        Assert.That(Merged().Count, Is.Zero);
        Assert.That(Merged(Merged(), one).Count, Is.EqualTo(2));
    }
}
