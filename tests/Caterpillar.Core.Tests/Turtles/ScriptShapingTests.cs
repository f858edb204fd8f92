using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Shaping;
using Caterpillar.Toolpaths;
using Caterpillar.Traces;
using Caterpillar.Turtles;
using NUnit.Framework;

namespace Caterpillar.Tests.Turtles;

/// <summary>Kanada's traces, deformation and modulation, gap beads and cooling as statements, against the classes that they use.</summary>
internal sealed class ScriptShapingTests
{
    private static readonly Vec3 Center = new(100, 90, 0.3);

    private static IReadOnlyList<PrintPath> Paths(string text)
    {
        var run = TurtleScript.Compile("start 100 90 0.3\narea 0.196\nspeed 20\n" + text, "p").OrThrow().Run();
        return run.OrThrow().ToSteps().OfType<PathStep>().Select(s => s.Path).ToArray();
    }

    private static IReadOnlyList<PrintPath> Shaped(Func<Trace, Trace> shape, Func<IReadOnlyList<PrintPath>, Result<IReadOnlyList<PrintPath>>>? change = null)
    {
        IReadOnlyList<PrintPath> paths = shape(new Trace(0.196).SetSpeed(20)).ToPaths();
        if (change is not null) paths = change(paths).OrThrow();
        return paths.Select(p => p.Transformed(Affine.Move(Center))).ToArray();
    }

    private static void Same(IReadOnlyList<PrintPath> actual, IReadOnlyList<PrintPath> expected)
    {
        Assert.That(actual.Select(p => p.SegmentCount), Is.EqualTo(expected.Select(p => p.SegmentCount)));
        for (var p = 0; p < actual.Count; p++)
        {
            for (var i = 0; i <= actual[p].SegmentCount; i++)
            {
                var (a, b) = i < actual[p].SegmentCount ? (actual[p].Points[i], expected[p].Points[i]) : (actual[p].End, expected[p].End);
                Assert.That(a.DistanceTo(b), Is.LessThan(1e-9));
                if (i == actual[p].SegmentCount) continue;
                Assert.That(actual[p].BeadOf(i).Area, Is.EqualTo(expected[p].BeadOf(i).Area).Within(1e-9));
                Assert.That(actual[p].BeadOf(i).Speed, Is.EqualTo(expected[p].BeadOf(i).Speed).Within(1e-9));
            }
        }
    }

    [Test]
    public void Traces_are_those_of_the_class_around_the_turtle()
    {
        Same(Paths("circle_trace 10"), Shaped(t => t.Circle(Vec3.Zero, 10)));
        Same(Paths("circle_trace 10 12"), Shaped(t => t.Circle(Vec3.Zero, 10, 12)));
        Same(Paths("spiral_trace 10 0.5 36"), Shaped(t => t.Spiral(Vec3.Zero, 10, 0.5, 36)));
        Same(Paths("helix_trace 10 4 0.4"), Shaped(t => t.Helix(Vec3.Zero, 10, 4, 0.4)));
        Same(Paths("helix_trace 10 4 0.4 60 0.3"), Shaped(t => t.Helix(Vec3.Zero, 10, 4, 0.4, 60, new FlowRamp(0.3))));
        Same(Paths("cone_trace 10 5 4 0.4 60"), Shaped(t => t.Cone(Vec3.Zero, 10, 5, 4, 0.4, 60)));
        Same(Paths("cone_trace 10 5 4 0.4 60 0.2"), Shaped(t => t.Cone(Vec3.Zero, 10, 5, 4, 0.4, 60, new FlowRamp(0.2))));
        Same(Paths("cylinder_trace 5 1 0.25 0.5 24"), Shaped(t => t.Cylinder(Vec3.Zero, 5, 1, 0.25, 0.5, 24)));
        Same(Paths("skirt_trace 20"), Shaped(t => t.Skirt(Vec3.Zero, 20)));
        Same(Paths("skirt_trace 20 3 0.6"), Shaped(t => t.Skirt(Vec3.Zero, 20, 3, 0.6)));
    }

    [Test]
    public void A_trace_follows_the_heading_and_leaves_the_turtle_where_it_is()
    {
        var turtle = TurtleScript.Compile("start 10 20 1\nleft 90\ncircle_trace 5 4\nforward 3\npenup\nhelix_trace 5 5 1").OrThrow().Run().OrThrow();
        Assert.That(turtle.Position.DistanceTo(new Vec3(10, 23, 1)), Is.LessThan(1e-12));
        var paths = turtle.ToSteps().OfType<PathStep>().Select(s => s.Path).ToArray();
        Assert.That(paths, Has.Length.EqualTo(2), "the next move begins where the turtle is; with the pen up nothing is printed");
        Assert.That(paths[0].Start.DistanceTo(new Vec3(10, 25, 1)), Is.LessThan(1e-12));
        Assert.That(paths[1].Start.DistanceTo(new Vec3(10, 20, 1)), Is.LessThan(1e-12));
    }

    [Test]
    public void Traces_are_commands_with_a_height_from_the_bead()
    {
        var command = TurtleCommand.Of(TurtleAction.HelixTrace, 10, 2, 0.5, 36);
        Assert.That(command.ToString(), Is.EqualTo("helix_trace 10 2 0.5 36"));
        var turtle = TurtleProgram.FromCommands([TurtleCommand.Of(TurtleAction.Bead, 0.5, 0.25), command]).Run().OrThrow();
        var path = ((PathStep)turtle.ToSteps().Single()).Path;
        Assert.That((path.SegmentCount, path.BeadOf(3).Height), Is.EqualTo((144, 0.25)));
    }

    [Test]
    public void Deform_maps_position_area_and_speed_in_the_coordinates_of_the_turtle()
    {
        var cup = Deformation.Cylindrical(p => new Vec3(p.X + 1.05 * p.Z, p.Y, 0.3 * p.Z), (c, _) => 0.96 * c);
        Same(Paths("deform r = r + 1.05 * z, z = 0.3 * z, c = 0.96 * c, tolerance = 0 [ helix_trace 10 8 0.4 ]"),
            Shaped(t => t.Helix(Vec3.Zero, 10, 8, 0.4), p => cup.Apply(p)));
        var twist = Deformation.Cylindrical(p => new Vec3(p.X, p.Y + 5 * p.Z, p.Z), null, (v, p) => v * (1 + p.Z / 100));
        Same(Paths("deform\n  theta = theta + 5 * z\n  v = v * (1 + z / 100)\n[ cone_trace 10 8 8 0.4 ]"),
            Shaped(t => t.Cone(Vec3.Zero, 10, 8, 8, 0.4), p => twist.Apply(p, 0.01)));
        var heart = Deformation.Cartesian(p => new Vec3(p.X + 0.6 * p.Z * Math.Sqrt(Math.Abs(p.Y) / 10), p.Y, p.Z));
        Same(Paths("k = 0.6\ndeform x = x + k * z * sqrt(abs(y) / 10), tolerance = 0 [ helix_trace 10 4 0.4 ]"),
            Shaped(t => t.Helix(Vec3.Zero, 10, 4, 0.4), p => heart.Apply(p)));
        // r and theta are read in Cartesian coordinates, x and y in cylindrical ones.
        var wave = Deformation.Cartesian(p => p + new Vec3(0.1 * p.LengthXY, 0, 0));
        Same(Paths("deform x = x + 0.1 * r, tolerance = 0 [ helix_trace 10 2 0.4 ]"), Shaped(t => t.Helix(Vec3.Zero, 10, 2, 0.4), p => wave.Apply(p)));
        var lean = Deformation.Cylindrical(p => new Vec3(p.X + 0.1 * p.X * Angle.SinCos(p.Y).Cos, p.Y, p.Z));
        Same(Paths("deform r = r + 0.1 * x, tolerance = 0 [ helix_trace 10 2 0.4 ]"), Shaped(t => t.Helix(Vec3.Zero, 10, 2, 0.4), p => lean.Apply(p)));
    }

    [Test]
    public void Deformations_nest_and_call_functions()
    {
        var one = Deformation.Cylindrical(p => new Vec3(p.X * 2, p.Y, p.Z));
        var two = Deformation.Cartesian(p => new Vec3(p.X, p.Y, p.Z + 0.01 * p.X * p.X));
        Same(Paths("def square a [ return a * a ]\ndeform z = z + 0.01 * square(x), x = x, tolerance = 0 [\n"
            + "deform r = 2 * r, tolerance = 0 [ circle_trace 5 ] ]"),
            Shaped(t => t.Circle(Vec3.Zero, 5), p => one.Then(two).Apply(p)));
        // In a procedure with local variables, ended by return.
        Same(Paths("def part radius lift [\n deform z = z + lift, tolerance = 0 [ circle_trace radius; return ]\n]\npart 5 3"),
            Shaped(t => t.Circle(new Vec3(0, 0, 3), 5)));
        Same(Paths("repeat 3 [ deform z = z + 3, tolerance = 0 [ circle_trace 5; break ] ]"), Shaped(t => t.Circle(new Vec3(0, 0, 3), 5)));
        Same(Paths("deform z = z + 3, tolerance = 0 [ circle_trace 5; stop ]"), Shaped(t => t.Circle(new Vec3(0, 0, 3), 5)));
    }

    [Test]
    public void Drawn_travels_are_deformed_too_and_events_stay()
    {
        var steps = TurtleScript.Compile("deform z = z + x, y = y [ forward 5; fan 0.5; jump 10 0 1; forward 5 ]").OrThrow().Run().OrThrow().ToSteps();
        Assert.That(((TravelStep)steps[2]).Points[0].DistanceTo(new Vec3(10, 0, 11)), Is.LessThan(1e-12));
        Assert.That(((EventStep)steps[1]).Event, Is.EqualTo(new FanEvent(0.5)));
        Assert.That(((PathStep)steps[3]).Path.End.DistanceTo(new Vec3(15, 0, 16)), Is.LessThan(1e-12));
    }

    [Test]
    public void Modulate_changes_speed_flow_or_position()
    {
        Field field = place => 0.5 + 0.5 * Angle.SinCos(6 * Angle.Atan2(place.Position.Y, place.Position.X)).Sin;
        Same(Paths("modulate speed field = 0.5 + 0.5 * sin(6 * theta), low = 1, high = 0.7 [ helix_trace 10 2 0.4 ]"),
            Shaped(t => t.Helix(Vec3.Zero, 10, 2, 0.4), p => new Modulation(ModulationMode.Speed, field, 1, 0.7).Apply(p)));
        var u = new Field(s => s.Distance / s.Length);
        Same(Paths("modulate flow field = u, high = 1.3, mask = z > 1, resolution = 0.5 [ helix_trace 10 2 0.4 ]"),
            Shaped(t => t.Helix(Vec3.Zero, 10, 2, 0.4), p => new Modulation(ModulationMode.Flow, u, 1, 1.3)
                { Mask = s => s.Position.Z > 1 ? 1 : 0, Resolution = 0.5 }.Apply(p)));
        Same(Paths("modulate left field = u, high = 2 [ circle_trace 10 ]"),
            Shaped(t => t.Circle(Vec3.Zero, 10), p => new Modulation(ModulationMode.DisplaceLeft, u, 0, 2).Apply(p)));
        Same(Paths("modulate up field = s / 100, low = 1, high = 2 [ circle_trace 10 ]"),
            Shaped(t => t.Circle(Vec3.Zero, 10), p => new Modulation(ModulationMode.DisplaceUp, s => s.Distance / 100, 1, 2).Apply(p)));
        Same(Paths("modulate up field = path, high = 5 [ circle_trace 10; name \"second\"; circle_trace 10 ]").Skip(1).ToArray(),
            Shaped(t => t.Circle(new Vec3(0, 0, 5), 10)));
    }

    [Test]
    public void The_modulation_that_fails_in_print_is_a_warning_with_its_line()
    {
        var run = TurtleScript.Compile("area 0.2\n\nmodulate speed field = u, high = 0.3 [ circle_trace 10 ]", "p").OrThrow().Run();
        Assert.That(run.Diagnostics.Single().ToString(), Does.StartWith("p:3:1: warning shape.modulation_ratio"));
    }

    [Test]
    public void Gap_beads_fill_what_is_below()
    {
        // Above the bed of 0.3 mm and a slope of 0.1: each piece has the area of its gap.
        var paths = Paths("bead 0.5 0.2\ngap_bead max_gap = 2 [ forward_lift 5 0.5 ]");
        var path = paths.Single();
        var middle = (path.Points[2] + path.Points[3]) * 0.5;
        var share = 5 / Math.Sqrt(25.25);
        Assert.That(path.BeadOf(2).Area, Is.EqualTo(middle.Z * 0.5 * share).Within(1e-6));
        Assert.That(Paths("bead 0.5 0.2\ngap_bead width = 1 [ forward 1 ]").Single().BeadOf(0).Area, Is.EqualTo(0.3).Within(1e-9));
        Assert.That(Paths("bead 0.5 0.2\ngap_bead min_gap = 0.4, bed = 1 [ forward 1 ]").Single().BeadOf(0).Area, Is.EqualTo(0.2).Within(1e-9));
        Assert.That(Paths("bead 0.5 0.2\ngap_bead bed = 0 [ forward 1 ]").Single().BeadOf(0).Area, Is.EqualTo(0.1).Within(1e-9));
    }

    [Test]
    public void Cool_layers_slows_small_layers_down()
    {
        var slow = Paths("cool_layers min_layer_time = 10, min_speed = 1 [ layer 0; repeat 4 [ forward 10; left 90 ] ]").Single();
        Assert.That(slow.BeadOf(0).Speed, Is.EqualTo(4).Within(1e-9));
        Assert.That(Paths("cool_layers [ layer 0; repeat 4 [ forward 10; left 90 ] ]").Single().BeadOf(0).Speed, Is.EqualTo(8).Within(1e-9));
        Assert.That(Paths("cool_layers min_layer_time = 0, speed_by_length = 1 [ forward 10 ]").Single().BeadOf(0).Speed, Is.EqualTo(11).Within(1e-9));
    }

    [TestCase("deform [ forward 1 ]", 1, 1, "turtle.values", "needs a formula")]
    [TestCase("deform x = x, r = r [ forward 1 ]", 1, 1, "turtle.values", "cannot be combined")]
    [TestCase("deform q = x [ forward 1 ]", 1, 8, "turtle.values", "one of x, y, z, r, theta, c, v, tolerance")]
    [TestCase("deform tolerence = 1 [ forward 1 ]", 1, 8, "turtle.values", "Did you mean 'tolerance'?")]
    [TestCase("deform z = z, z = 1 [ forward 1 ]", 1, 15, "turtle.values", "two formulas")]
    [TestCase("deform z z [ forward 1 ]", 1, 10, "turtle.syntax", "expected '='")]
    [TestCase("\ndeform z = 1 / (x - x), y = y [ forward 1 ]", 2, 1, "shape.position", "not finite")]
    [TestCase("deform c = -1 [ forward 1 ]", 1, 1, "shape.value", "negative")]
    [TestCase("deform z = z, tolerance = -1 [ forward 1 ]", 1, 27, "turtle.value", "'tolerance' must be a number from 0 to 100")]
    [TestCase("modulate field = u [ forward 1 ]", 1, 10, "turtle.values", "speed, flow, left or up")]
    [TestCase("modulate speed [ forward 1 ]", 1, 1, "turtle.values", "needs a field")]
    [TestCase("modulate up field = u [ forward 1 ]", 1, 1, "turtle.values", "need 'high'")]
    [TestCase("modulate flow field = c [ forward 1 ]", 1, 23, "formula.unknown", "Unknown variable 'c'")]
    [TestCase("modulate speed field = u, high = -1 [ forward 1 ]", 1, 1, "shape.modulation", "stay positive")]
    [TestCase("gap_bead [ forward 1 ]", 1, 1, "gap.no_width", "no height")]
    [TestCase("gap_bead min_gap = 2, max_gap = 1 [ forward 1 ]", 1, 1, "turtle.value", "above max_gap")]
    [TestCase("cool_layers min_speed = 0 [ forward 1 ]", 1, 25, "turtle.value", "'min_speed' must be")]
    [TestCase("cool_layers [ forward 1", 1, 13, "turtle.bracket", "has no closing")]
    [TestCase("helix_trace 10 5 0", 1, 1, "turtle.value", "positive")]
    [TestCase("helix_trace 10 5 0.2 2", 1, 1, "turtle.value", "three strings")]
    [TestCase("circle_trace 10 3.5", 1, 1, "turtle.value", "expected an integer")]
    [TestCase("cylinder_trace 10 1e9 0.001 0.001", 1, 1, "turtle.too_many_moves", "moves")]
    [TestCase("skirt_trace 10 0", 1, 1, "turtle.value", "at least one loop")]
    [TestCase("x = 1\ndeform z = z [ forward 1 ]\nforward z", 3, 9, "formula.unknown", "Unknown variable 'z'")]
    public void Errors_state_what_and_where(string text, int line, int column, string code, string message)
    {
        var script = TurtleScript.Compile(text, "p");
        var error = (script.Value is null ? script.Diagnostics : script.Value.Run().Diagnostics).Single(d => d.Severity == Severity.Error);
        Assert.That((error.Source!.File, error.Source.Line, error.Source.Column, error.Code), Is.EqualTo(("p", (int?)line, (int?)column, code)),
            error.ToString());
        Assert.That(error.Message, Does.Contain(message));
    }

    [Test]
    public void Travels_in_a_deformed_block_are_deformed_from_their_first_point_on()
    {
        var steps = TurtleScript.Compile("start 100 90 0.3\nbead 0.5 0.2\ndeform x = x + 7, y = 2 * y [ forward 5; penup; left 90; forward 10; right 90; "
            + "forward 3; pendown; forward 5 ]", "p")
            .OrThrow().Run().OrThrow().ToSteps();
        var travel = steps.OfType<TravelStep>().Single(t => t.Points.Count == 2);
        Assert.That(travel.Points[0].DistanceTo(new Vec3(112, 110, 0.3)), Is.LessThan(1e-9));
        Assert.That(travel.Points[1].DistanceTo(new Vec3(115, 110, 0.3)), Is.LessThan(1e-9));
    }
}
