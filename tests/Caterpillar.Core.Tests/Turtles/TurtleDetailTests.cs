using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using Caterpillar.Turtles;
using NUnit.Framework;

namespace Caterpillar.Tests.Turtles;

/// <summary>Defaults and limits that only one test looks at.</summary>
internal sealed class TurtleDetailTests
{
    private static Turtle Run(string text) => TurtleScript.Compile(text, "p").OrThrow().Run().OrThrow();

    private static int Segments(string text) => Run(text).ToSteps().OfType<PathStep>().Sum(p => p.Path.SegmentCount);

    private static Diagnostic Error(string text)
    {
        var script = TurtleScript.Compile(text, "p");
        return (script.Value is null ? script.Diagnostics : script.Value.Run().Diagnostics).Single(d => d.Severity == Severity.Error);
    }

    [TestCase("speed 1000001", "The speed must be at most 1000000 mm/s.")]
    [TestCase("rate 1e300", "The speed must be at most 1000000 mm/s.")]
    [TestCase("travel_speed 1e300", "The travel speed must be 0 to 1000000 mm/s.")]
    [TestCase("hotend 10001", "The temperature must be 0 to 10000 °C.")]
    [TestCase("bed_nowait 1e300", "The temperature must be 0 to 10000 °C.")]
    public void Speeds_and_temperatures_that_no_machine_knows_are_refused(string text, string message)
        => Assert.That(Error(text).Message, Does.Contain(message));

    [Test]
    public void A_color_is_three_numbers_or_a_text_and_ends_without_a_value()
    {
        var paths = Run("forward 1\ncolor 255 0 16\nforward 1\ncolor \"#0000ff\"\nforward 1\ncolor\nforward 1").ToSteps().OfType<PathStep>();
        Assert.That(paths.Select(p => p.Path.Color), Is.EqualTo(new int?[] { null, 0xFF0010, 0x0000FF, null }));
        Assert.That(Error("color 1 2").Message, Does.EndWith("A color needs three numbers."));
    }

    [Test]
    public void A_bead_without_a_speed_keeps_the_speed()
    {
        var turtle = new Turtle().SetSpeed(30).SetBead(new Bead(0.1)).Forward(5).SetBead(new Bead(0.2, speed: 7)).Forward(5).SetBead(new Bead(0.3)).Forward(5);
        var beads = turtle.ToSteps().OfType<PathStep>().SelectMany(p => Enumerable.Range(0, p.Path.SegmentCount).Select(p.Path.BeadOf));
        Assert.That(beads.Select(b => (b.Area, b.Speed)), Is.EqualTo(new[] { (0.1, 30.0), (0.2, 7), (0.3, 7) }));
    }

    [Test]
    public void Repeated_no_times_commands_do_nothing()
    {
        TurtleCommand Forward(double length) => TurtleCommand.Of(TurtleAction.Forward, length);
        var (never, once) = (TurtleCommand.Repeat(0, [Forward(10)]), TurtleCommand.Repeat(1, [Forward(5)]));
        var program = TurtleProgram.FromCommands([Forward(1), never, TurtleCommand.Repeat(2, []), once]);
        Assert.That(program.Run().OrThrow().Position, Is.EqualTo(new Vec3(6, 0)));
    }

    [Test]
    public void The_greatest_speed_and_temperature_are_taken()
        => Assert.That(Run("speed 1000000; travel_rate 60000000; hotend 10000").TravelSpeed, Is.EqualTo(1e6));

    // Chords deviate by 0.01 mm: at 10 mm a chord turns by 2 acos(1 - 0.001) = 5.125 degrees, at 40 mm by 2.5621, at 1 mm by 16.22.
    [TestCase("circle 10", 71)]
    [TestCase("circle 40", 141)]
    [TestCase("circle 1", 23)]
    [TestCase("circle 10 8", 8)]
    [TestCase("circle 10 0", 71)]
    [TestCase("circle_around 10", 71)]
    [TestCase("circle_around 10 5", 5)]
    [TestCase("arc 10 90", 18)]
    [TestCase("arc 10 90 1 4", 4)]
    [TestCase("circle_trace 10", 72)]
    [TestCase("polygon 5 3", 5)]
    public void Circles_have_as_many_chords_as_the_tolerance_needs_or_as_stated(string text, int segments) => Assert.That(Segments(text), Is.EqualTo(segments));

    [Test]
    public void Commands_as_values_turn_as_the_methods_do()
    {
        void Same(Turtle expected, TurtleAction action, params double[] values)
        {
            var pose = TurtleProgram.FromCommands([TurtleCommand.Of(action, values)]).Run().OrThrow().Pose;
            Assert.That((pose.X.DistanceTo(expected.Pose.X), pose.Y.DistanceTo(expected.Pose.Y)), Is.EqualTo((0.0, 0.0)), action.ToString());
        }
        Same(new Turtle().Left(30), TurtleAction.Yaw, 30);
        Same(new Turtle().Right(30), TurtleAction.Right, 30);
        Same(new Turtle().PitchUp(30), TurtleAction.Pitch, 30);
        Same(new Turtle().PitchDown(30), TurtleAction.PitchDown, 30);
        Same(new Turtle().RollRight(30), TurtleAction.Roll, 30);
        Same(new Turtle().RollLeft(30), TurtleAction.RollLeft, 30);
        Same(new Turtle().SetHeading(10), TurtleAction.Heading, 10);
        Same(new Turtle().SetHeading(10, 20, 30), TurtleAction.Heading, 10, 20, 30);
        Same(new Turtle().ChangeHeading(10), TurtleAction.ChangeHeading, 10);
        Same(new Turtle().ChangeHeading(10, 20, 30), TurtleAction.ChangeHeading, 10, 20, 30);
    }

    [Test]
    public void Commands_as_values_have_the_same_defaults()
    {
        foreach (var action in new[] { TurtleAction.Circle, TurtleAction.CircleAround })
        {
            var turtle = TurtleProgram.FromCommands([TurtleCommand.Of(action, 10)]).Run().OrThrow();
            Assert.That(turtle.ToSteps().OfType<PathStep>().Sum(p => p.Path.SegmentCount), Is.EqualTo(71));
        }
    }

    [TestCase("lsystem 1 \"F(1,2)\" \"F(a,b)->F(a+b,b)\"\n", 3)]
    [TestCase("lsystem 2 \"F(1,2)F(2,1)\" \"F(a,b) -> F(a + b, b)\"\n", 9)]
    [TestCase("lsystem 1 \"F(1,2)\" \"F(a,b):a<b->F(b,a)\"\n", 2)]
    [TestCase("def f a b [ forward a + 10 * b ]\nf(1,2)", 21)]
    [TestCase("def f a b [ forward a + 10 * b ]\nf(1, (2 + 1))", 31)]
    [TestCase("def f a b [ forward a + 10 * b ]\nf (1) (2)", 21)]
    [TestCase("def f a b [ forward a + 10 * b ]\nf (1), 2", 21)]
    [TestCase("def f a [ forward a ]\nf(1)", 1)]
    [TestCase("def f a [ forward a ]\nf(1) + 2", 3)]
    [TestCase("def f [ forward 5 ]\nf()\nf", 10)]
    public void Values_in_brackets_need_no_spaces(string text, double x) => Assert.That(Run(text).X, Is.EqualTo(x).Within(1e-12));

    [TestCase("def f a b [ forward a ]\nf(1, 2, 3)", "turtle.values")]
    [TestCase("def f a b [ forward a ]\nf(1, 2", "formula.bracket")]
    [TestCase("def f a b [ forward a ]\nf()", "turtle.values")]
    [TestCase("def f a b [ forward a ]\nf(1, )", "formula.syntax")]
    public void Wrong_brackets_are_errors(string text, string code)
    {
        var error = Error(text);
        Assert.That((error.Code, error.Source!.Line), Is.EqualTo((code, (int?)2)), error.ToString());
    }

    [Test]
    public void Temperatures_wait_unless_they_say_otherwise()
    {
        var events = Run("hotend 200; hotend_nowait 210; bed 60; bed_nowait 50").ToSteps().Cast<EventStep>().Select(e => e.Event).ToArray();
        Assert.That(events, Is.EqualTo(new PrinterEvent[]
        {
            new NozzleTemperatureEvent(200, true), new NozzleTemperatureEvent(210, false),
            new BedTemperatureEvent(60, true), new BedTemperatureEvent(50, false),
        }));
        Assert.That(new Turtle().NozzleTemperature(200).BedTemperature(60).ToSteps().Cast<EventStep>().Select(e => e.Event),
            Is.EqualTo(new PrinterEvent[] { new NozzleTemperatureEvent(200, true), new BedTemperatureEvent(60, true) }));
    }

    [Test]
    public void Beads_that_change_and_change_back_are_kept_for_each_extrusion()
    {
        var path = ((PathStep)Run("area 1; forward 1; forward 1; forward 1; area 2; forward 1; area 1; forward 1; forward 1").ToSteps().Single()).Path;
        Assert.That(Enumerable.Range(0, 6).Select(i => path.BeadOf(i).Area), Is.EqualTo(new[] { 1.0, 1, 1, 2, 1, 1 }));
        Assert.That(((PathStep)Run("area 1; forward 1; area 2; forward 1").ToSteps().Single()).Path.BeadOf(1).Area, Is.EqualTo(2));
    }

    [Test]
    public void A_kanada_step_follows_the_azimuth_of_a_tilted_turtle()
    {
        Assert.That(Run("left 30; pitch 40; forward 2 5").Position.DistanceTo(new Vec3(Math.Sqrt(3), 1, 5)), Is.LessThan(1e-12));
        Assert.That(Run("left 30; forward 2 5").Position.DistanceTo(new Vec3(Math.Sqrt(3), 1, 5)), Is.LessThan(1e-12));
    }

    [Test]
    public void Programs_describe_themselves_and_keep_the_profiles_of_their_script()
    {
        var script = TurtleProgram.FromScript(TurtleScript.Compile("use \"ender3\" \"pla\"\nforward 1\nforward 2", "p").OrThrow());
        var commands = TurtleProgram.FromCommands([TurtleCommand.Of(TurtleAction.Forward, 5), TurtleCommand.Of(TurtleAction.Yaw, 90)]);
        var both = TurtleProgram.Sequence([commands, script]);
        Assert.That((script.Description, commands.Description), Is.EqualTo(("Script of 3 lines", "2 commands")));
        Assert.That(both.Description, Is.EqualTo("2 commands, Script of 3 lines"));
        Assert.That(script.Profiles, Is.EqualTo(new[] { "ender3", "pla" }));
        Assert.That(both.Profiles, Is.EqualTo(script.Profiles));
        Assert.That(commands.Profiles, Is.Empty);
        Assert.That(both.Run().OrThrow().Position.DistanceTo(new Vec3(5, 3)), Is.LessThan(1e-12));
        var scaled = TurtleProgram.FromScript(TurtleScript.Compile("param x = 1\nforward x").OrThrow(),
            new System.Collections.Generic.Dictionary<string, double> { ["x"] = 7 });
        Assert.That(scaled.Run().OrThrow().X, Is.EqualTo(7));
    }

    [Test]
    public void Facing_a_point_looks_there_from_where_the_turtle_stands()
    {
        var turtle = new Turtle().StartAt(10, 20, 5).Face(new Vec3(10, 50, 5));
        Assert.That(turtle.Forward(7).Position.DistanceTo(new Vec3(10, 27, 5)), Is.LessThan(1e-9));
        Assert.That(turtle.Face(new Vec3(40, 27, 45)).Forward(50).Position.DistanceTo(new Vec3(40, 27, 45)), Is.LessThan(1e-9));
        Assert.That(() => turtle.Face(turtle.Position), Throws.ArgumentException);
    }

    [Test]
    public void A_drawn_travel_names_the_line_where_it_begins()
    {
        var run = TurtleScript.Compile("forward 1\npenup\nforward 5\nforward 2\npendown\nforward 1").OrThrow().Run().OrThrow();
        Assert.That(run.ToSteps().OfType<TravelStep>().Single().Source!.Line, Is.EqualTo(3));
    }

    [TestCase(double.NaN)]
    [TestCase(3.7e6)]
    public void An_arc_turns_by_a_number_of_degrees(double angle)
        => Assert.That(() => new Turtle().Arc(10, angle), Throws.InstanceOf<ArgumentOutOfRangeException>().With.Property("ParamName").EqualTo("angle"));
}
