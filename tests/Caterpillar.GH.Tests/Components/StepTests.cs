using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.GH.Base;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Path;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;
using Rhino;

namespace Caterpillar.GH.Tests.Components;

[Category("Host")]
public sealed class StepTests
{
    private static Canvas<StepComponent> Of(string kind, string? port = null, object? value = null)
    {
        var canvas = new Canvas<StepComponent>().Feed("Kind", kind);
        return port is null ? canvas : canvas.Feed(port, value);
    }

    private static PrinterEvent EventOf(Canvas<StepComponent> canvas)
    {
        Assert.That(canvas.Solve().Errors, Is.Empty);
        return ((EventStep)canvas.One<Step>("Step")).Event;
    }

    [Test]
    public void Each_kind_gives_its_event()
    {
        Assert.That(EventOf(Of("Nozzle Temperature", "Temperature", 215.0)), Is.EqualTo(new NozzleTemperatureEvent(215, Wait: true)));
        Assert.That(EventOf(Of("Bed Temperature", "Temperature", 60.0).Feed("Wait", false)), Is.EqualTo(new BedTemperatureEvent(60)));
        Assert.That(EventOf(Of("Fan", "Fan Speed", 0.5)), Is.EqualTo(new FanEvent(0.5)));
        Assert.That(EventOf(Of("Tool", "Tool", 1)), Is.EqualTo(new ToolEvent(1)));
        Assert.That(EventOf(Of("Dwell", "Duration", 2.5)), Is.EqualTo(new DwellEvent(2.5)));
        Assert.That(EventOf(Of("Pause", "Text", "Add beads")), Is.EqualTo(new PauseEvent("Add beads")));
        Assert.That(EventOf(Of("Comment", "Text", "half")), Is.EqualTo(new CommentEvent("half")));
        Assert.That(EventOf(Of("Raw Line", "Text", "M300 S440")), Is.EqualTo(new RawEvent("M300 S440")));
    }

    [Test]
    public void A_travel_goes_through_its_points_in_document_units()
    {
        using var _ = new InDocument(UnitSystem.Centimeters);
        var canvas = new Canvas<StepComponent>().Feed("Points", new Rg.Point3d(1, 2, 3), null, new Rg.Point3d(4, 5, 6)).Feed("Speed", 30.0).Solve();
        var travel = (TravelStep)canvas.One<Step>("Step");
        Assert.That(travel.Points, Is.EqualTo(new[] { new Vec3(10, 20, 30), new Vec3(40, 50, 60) }));
        Assert.That((travel.Speed, travel.Intent), Is.EqualTo((30.0, TravelIntent.AsDrawn)));
        Assert.That(canvas.Warnings, Has.One.Contains("1 null item"));
    }

    [TestCase("Nozzle Temperature", "Temperature", 700.0, "Temperature must be a temperature from 0 to 600 °C, not 700.")]
    [TestCase("Fan", "Fan Speed", 2.0, "Fan Speed must be a fan speed from 0 to 1, not 2.")]
    [TestCase("Tool", "Tool", -1, "Tool must be a tool number from 0 to 99, not -1.")]
    [TestCase("Dwell", "Duration", -1.0, "Duration must be a number of seconds")]
    [TestCase("Travel", "Speed", -1.0, "Speed must be 0 or more.")]
    public void What_no_machine_takes_is_an_error(string kind, string port, object value, string message)
    {
        var canvas = Of(kind, port, value);
        if (kind == "Travel") canvas.Feed("Points", new Rg.Point3d(1, 2, 3));
        Assert.That(canvas.Solve().Errors, Has.One.Contains(message));
        Assert.That(canvas.All("Step"), Is.EqualTo(new object?[] { null }));
    }

    [Test]
    public void A_line_without_text_is_missing_and_a_wrong_kind_is_refused()
    {
        Assert.That(Of("Raw Line", "Text", " ").Solve().Warnings, Has.One.Contains("Text is missing."));
        Assert.That(Of("Twirl").Solve().Errors, Has.Some.Contains("Kind has no choice"));
        Assert.That(Of("Fan").FeedTree("Fan Speed", [0.1, 0.2], [0.3]).Solve().Paths("Step"), Is.EqualTo(new[] { "{0}", "{1}" }));
    }

    // As the rings of a chain, which are cut and printed part by part, each over the ones before it.
    [Test]
    public void Parts_of_a_print_are_printed_in_the_order_of_their_branches_if_nothing_is_sorted()
    {
        PrintPathGoo Part(double x, int layer)
        {
            var z = 0.2 * (layer + 1);
            var path = new PrintPath([new Vec3(x, 50, z), new Vec3(x + 10, 50, z)], new Bead(0.08, 0.2, 40)) { Layer = new Layer(layer, z, 0.2) };
            return new PrintPathGoo(new PathStep(path, new StepGroup(layer)));
        }
        var canvas = new Canvas<PlanToolpathComponent>().FeedTree("Steps", [Part(50, 0), Part(50, 1)], [Part(100, 0), Part(100, 1)]);
        double[] Order() => canvas.Solve().One<Toolpath>("Toolpath").Moves().Where(m => m.Kind == MoveKind.Print).Select(m => m.Start.X).ToArray();
        Assert.That(Order().Select(x => x < 90), Is.Not.EqualTo(new[] { true, true, false, false }), "Layer by layer.");
        canvas.Feed("Sort", "None");
        Assert.That(Order(), Is.EqualTo(new[] { 50.0, 50, 100, 100 }));
    }

    [Test]
    public void A_list_of_steps_is_the_same_while_planning_sees_no_difference()
    {
        var path = new PrintPath([new Vec3(1, 2, 0.2), new Vec3(9, 2, 0.2)], new Bead(0.08, 0.2, 40));
        var (a, b) = (new StepGroup(1), new StepGroup(2));
        PathStep Made(PrintPath? other = null, StepGroup? group = null) => new(other ?? path, group ?? a);
        var step = Made();
        Assert.That(step, Is.EqualTo(Made()));
        Step[] others =
        [
            Made(group: b), new PathStep(path), new PathStep(path, a) { KeepStart = true }, new PathStep(path, a) { Joined = true },
            new PathStep(path, a) { Region = Region.Rectangle(0, 0, 1, 1) }, new PathStep(path, a) { Source = new SourceLocation(Line: 3) },
            Made(new PrintPath(path.Points, new Bead(0.08, 0.2, 40))), new EventStep(new PauseEvent()),
        ];
        foreach (var other in others) Assert.That(other, Is.Not.EqualTo(step), other.ToString());
        var list = new StepList([new StepGoo(step)], new PrintSetup());
        Assert.That(list.Has([new StepGoo(Made())]), Is.True);
        Assert.That(list.Has([]), Is.False);
        Assert.That(list.Has([new StepGoo(step), new StepGoo(step)]), Is.False);
        Assert.That(list.Has([new StepGoo(others[0])]), Is.False);
    }

    [Test]
    public void Steps_happen_between_the_curves_in_the_order_of_the_wires()
    {
        PrintPath Line(double y) => new([new Vec3(50, y, 0.2), new Vec3(80, y, 0.2)], new Bead(0.08, 0.2, 40));
        var heat = Of("Nozzle Temperature", "Temperature", 190.0).Solve();
        var travel = new Canvas<StepComponent>(heat.Document).Feed("Points", new Rg.Point3d(90, 90, 20)).Solve();
        var plan = new Canvas<PlanToolpathComponent>(heat.Document);
        plan.Feed("Steps", Line(50));
        plan.Input("Steps").AddSource(heat.Output("Step"));
        plan.Input("Steps").AddSource(travel.Output("Step"));
        Recipes.Add(heat.Document, plan.Input("Steps"), Line(60));
        plan.Solve();
        Assert.That(plan.Errors, Is.Empty);
        var toolpath = plan.One<Toolpath>("Toolpath");
        var prints = toolpath.Moves().Where(m => m.Kind == MoveKind.Print).ToArray();
        var heats = toolpath.Events.Single(e => e.Event is NozzleTemperatureEvent { Celsius: 190 });
        Assert.That(heats.Move, Is.GreaterThan(prints[0].Index).And.LessThanOrEqualTo(prints[1].Index));
        var away = toolpath.Moves().Single(m => m.End == new Vec3(90, 90, 20));
        Assert.That(away.Index, Is.GreaterThanOrEqualTo(heats.Move).And.LessThan(prints[1].Index));
    }
}
