using System.Linq;
using Caterpillar.GH.Components.Design;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Plugin;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using Caterpillar.Turtles;
using Grasshopper;
using Grasshopper.Kernel;
using NUnit.Framework;
using Rhino;

namespace Caterpillar.GH.Tests.Components;

[Category("Host")]
public sealed class TurtleComponentsTests
{
    private static TurtleProgram Program(string text) => TurtleProgram.FromScript(TurtleScript.Compile(text).Value!);

    private static PrintPath[] Paths(TurtleProgram program) => program.Run().Value!.ToSteps().OfType<PathStep>().Select(s => s.Path).ToArray();

    private static string Line<T>(Canvas<T> canvas)
        where T : GH_Component, new()
    {
        Assert.That(canvas.Solve().Errors, Is.Empty);
        return canvas.One<TurtleCommand>("Command").ToString();
    }

    [Test]
    public void A_script_in_lines_becomes_a_program_with_its_variables()
    {
        var canvas = new Canvas<TurtleProgramComponent>().Feed("Script", "param side = 10", "repeat 4 [ forward side; left 90 ]").Feed("Variables", "side=20")
            .Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(Paths(canvas.One<TurtleProgram>("Program")).Single().Length, Is.EqualTo(80).Within(1e-9));
        Assert.That(new Canvas<TurtleProgramComponent>().Feed("Script", "forward 1").Feed("Variables", "size=20").Solve().Warnings.Single(),
            Does.Contain("no parameter 'size'"));
        Assert.That(new Canvas<TurtleProgramComponent>().Feed("Script", "forward 1").Feed("Variables", "size").Solve().Errors.Single(),
            Does.Contain("name=value"));
    }

    [Test]
    public void Errors_of_scripts_have_line_and_column()
    {
        var canvas = new Canvas<TurtleProgramComponent>().Feed("Script", "forward 1", "forwrd 2").Solve();
        Assert.That(canvas.All("Program"), Is.EqualTo(new object?[] { null }));
        Assert.That(canvas.Errors.Single(), Does.Contain("line 2:1").And.Contain("Did you mean 'forward'?"));
        Assert.That(canvas.All("Diagnostics").Single(), Does.Contain("turtle.unknown"));
        Assert.That(new Canvas<TurtleProgramComponent>().Solve().Warnings.Single(), Does.Contain("Script or Commands is missing"));
    }

    [Test]
    public void Commands_make_a_program()
    {
        var canvas = new Canvas<TurtleProgramComponent>()
            .Feed("Commands", TurtleCommand.Of(TurtleAction.Forward, 5), TurtleCommand.Of(TurtleAction.Forward, 7)).Solve();
        Assert.That(Paths(canvas.One<TurtleProgram>("Program")).Single().Length, Is.EqualTo(12).Within(1e-12));
        var gap = new Canvas<TurtleProgramComponent>().Feed("Commands", TurtleCommand.Of(TurtleAction.Forward, 5), null).Solve();
        Assert.That(gap.Errors.Single(), Does.Contain("Commands: the connected source gives no valid data"),
            "A command that failed is not left out in silence.");
        var both = new Canvas<TurtleProgramComponent>().Feed("Script", "forward 1").Feed("Commands", TurtleCommand.Of(TurtleAction.Forward, 5)).Solve();
        Assert.That(Paths(both.One<TurtleProgram>("Program")).Single().Length, Is.EqualTo(6).Within(1e-12));
    }

    [Test]
    public void Moves_turns_and_others_give_their_commands()
    {
        Assert.That(Line(new Canvas<TurtleMoveComponent>()), Is.EqualTo("forward 10"));
        Assert.That(Line(new Canvas<TurtleMoveComponent>().Feed("Kind", "Forward And Up").Feed("Distance", 2.0).Feed("Height", 3.0)),
            Is.EqualTo("forward_lift 2 3"));
        Assert.That(Line(new Canvas<TurtleMoveComponent>().Feed("Kind", "go to").Feed("Point", new Rg.Point3d(1, 2, 3))), Is.EqualTo("position 1 2 3"));
        Assert.That(Line(new Canvas<TurtleMoveComponent>().Feed("Kind", "Polygon").Feed("Side Count", 6)), Is.EqualTo("polygon 6 10"));
        Assert.That(Line(new Canvas<TurtleMoveComponent>().Feed("Kind", "Arc").Feed("Angle", -45.0)), Is.EqualTo("arc 10 -45 0 0"));
        Assert.That(Line(new Canvas<TurtleRotateComponent>().Feed("Yaw", 30.0)), Is.EqualTo("yaw 30"));
        Assert.That(Line(new Canvas<TurtleRotateComponent>().Feed("Yaw", 30.0).Feed("Roll", 5.0)), Is.EqualTo("repeat 1 [ yaw 30; roll 5 ]"));
        Assert.That(Line(new Canvas<TurtleRotateComponent>().Feed("Pitch", 30.0)), Is.EqualTo("pitch 30"));
        Assert.That(Line(new Canvas<TurtleRotateComponent>().Feed("Pitch", 30.0).Feed("Kind", 1)), Is.EqualTo("heading 0 30 0"));
        Assert.That(Line(new Canvas<TurtlePenComponent>().Feed("Down", false)), Is.EqualTo("penup"));
        Assert.That(Line(new Canvas<TurtleExtrusionComponent>()), Is.EqualTo("density 0.05"));
        Assert.That(Line(new Canvas<TurtleExtrusionComponent>().Feed("Kind", "Width And Height").Feed("Value", 0.5).Feed("Height", 0.2).Feed("Speed", 20.0)),
            Is.EqualTo("repeat 1 [ bead 0.5 0.2; speed 20 ]"));
        Assert.That(Line(new Canvas<TurtleEventComponent>().Feed("Value", 250.0)), Is.EqualTo("dwell 250"));
        Assert.That(Line(new Canvas<TurtleEventComponent>().Feed("Kind", "Color").Feed("Text", "#ff8800")), Is.EqualTo("color \"#ff8800\""));
        Assert.That(Line(new Canvas<TurtleRepeatComponent>()
            .Feed("Commands", TurtleCommand.Of(TurtleAction.Forward, 1), TurtleCommand.Of(TurtleAction.Yaw, 90))),
            Is.EqualTo("repeat 4 [ forward 1; yaw 90 ]"));
    }

    [Test]
    public void Angle_ports_take_radians_where_they_are_switched()
    {
        var canvas = new Canvas<TurtleRotateComponent>().Feed("Yaw", System.Math.PI / 2);
        var port = (Grasshopper.Kernel.Parameters.Param_Number)canvas.Component.Params.Input[0];
        Assert.That((port.AngleParameter, port.UseDegrees), Is.EqualTo((true, true)));
        port.UseDegrees = false;
        Assert.That(Line(canvas), Is.EqualTo("yaw 90"));
    }

    [Test]
    public void Ports_of_an_older_file_have_the_descriptions_of_today()
    {
        Instances.ComponentServer.Load(typeof(PluginInfo).Assembly);
        var (old, read) = (new Canvas<TurtleRotateComponent>().Component, new Canvas<TurtleRotateComponent>().Component);
        var today = old.Params.Input[0].Description;
        old.Params.Input[0].Description = "Of an older version.";
        var archive = new GH_IO.Serialization.GH_LooseChunk("test");
        old.Write(archive);
        read.Read(archive);
        Assert.That(read.Params.Input[0].Description, Is.EqualTo(today));
    }

    [Test]
    public void Bad_values_are_named_and_the_rest_continues()
    {
        var canvas = new Canvas<TurtleMoveComponent>().Feed("Distance", 1.0, double.NaN, null, 3.0).Solve();
        Assert.That(canvas.All("Command").Select(c => c?.ToString()), Is.EqualTo(new[] { "forward 1", null, null, "forward 3" }));
        Assert.That(canvas.Errors, Has.Count.EqualTo(2).And.One.StartsWith("{0}[1]: Distance must be a finite number")
            .And.One.StartsWith("{0}[2]: Distance: "));
        var jump = new Canvas<TurtleMoveComponent>().Feed("Kind", "Jump");
        Chosen.Follow(jump.Component);
        Assert.That(jump.Solve().Warnings, Has.Some.Contains("Pt failed to collect data"));
        Assert.That(new Canvas<TurtleExtrusionComponent>().Feed("Kind", 2).Solve().Errors.Single(), Does.Contain("Height must be greater than zero"));
        Assert.That(new Canvas<TurtleRepeatComponent>().Feed("Commands", TurtleCommand.Of(TurtleAction.Push)).Feed("Count", -1).Solve().Errors.Single(),
            Does.Contain("Count must be 0 or more"));
        Assert.That(new Canvas<TurtleMoveComponent>().FeedTree("Distance", [1.0], [2.0, 3.0]).Solve().Paths("Command"), Is.EqualTo(new[] { "{0}", "{1}" }));
    }

    [Test]
    public void The_turtle_draws_from_its_plane_in_document_units()
    {
        using var _ = new InDocument(UnitSystem.Centimeters);
        var start = new Rg.Plane(new Rg.Point3d(1, 0, 0), Rg.Vector3d.YAxis, -Rg.Vector3d.XAxis);
        var canvas = new Canvas<TurtleComponent>().Feed("Program", Program("forward 10\nlift 1\nforward 10\npause")).Feed("Start Plane", start).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        var paths = canvas.All("Print Paths").Cast<PrintPath>().ToArray();
        Assert.That(paths.Select(p => p.End.ToString()), Is.EqualTo(new[] { "(10, 10, 0)", "(10, 20, 1)" }));
        Assert.That(canvas.All("Steps").Select(s => s!.GetType().Name), Is.EqualTo(new[] { "PathStep", "TravelStep", "PathStep", "EventStep" }));
        var pose = (Rg.Plane)canvas.All("Planes").Single()!;
        Assert.That(pose.Origin.DistanceTo(new Rg.Point3d(1, 2, 0.1)), Is.LessThan(1e-12));
        Assert.That(canvas.Notes.Single(), Does.Contain("centimeters"));
        Assert.That(canvas.Output("Steps").VolatileData.get_Branch(0)[1]!.ToString(), Is.EqualTo("Travel (1 points)"));
    }

    [Test]
    public void A_bead_is_the_initial_one_of_the_turtle()
    {
        var canvas = new Canvas<TurtleComponent>().Feed("Program", "forward 10\narea 0.5\nforward 5").Feed("Bead", new BeadGoo(new Bead(0.2, 0.3, 25))).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        var path = (PrintPath)canvas.All("Print Paths").Single()!;
        Assert.That((path.BeadOf(0), path.BeadOf(1)), Is.EqualTo((new Bead(0.2, 0.3, 25), new Bead(0.5, 0, 25))));
    }

    [Test]
    public void Text_on_the_program_port_is_a_script_and_all_poses_come_on_demand()
    {
        var canvas = new Canvas<TurtleComponent>().Feed("Program", "repeat 4 [ forward 10; left 90 ]").Feed("Every Pose", true).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(canvas.All("Planes"), Has.Count.EqualTo(9));
        Assert.That(canvas.All("Triangles"), Has.Count.EqualTo(9));
        Assert.That(((Rg.Curve)canvas.All("Triangles")[0]!).GetBoundingBox(true).Max.DistanceTo(new Rg.Point3d(5, 2, 0)), Is.LessThan(1e-12));
        Assert.That(new Canvas<TurtleComponent>().Feed("Program", "forwrd 10").Solve().Errors.Single(),
            Does.StartWith("Program: line 1:1: ").And.Contain("Did you mean 'forward'?"));
        var failed = new Canvas<TurtleComponent>().Feed("Program", Program("forward 1\nforward 1 / 0"), Program("forward 2")).Solve();
        Assert.That(failed.Errors.Single(), Does.Contain("line 2:9").And.Contain("division by zero"));
        Assert.That(failed.All("Print Paths"), Has.Count.EqualTo(1), "the second item is solved");
    }

    [Test]
    public void An_l_system_grows_and_draws()
    {
        var canvas = new Canvas<LSystemComponent>().Feed("Axiom", "F").Feed("Rules", "F -> F[+F]F").Feed("Generations", 3).Feed("Angle", 30.0).Feed("Step", 2.0)
            .Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(Paths(canvas.One<TurtleProgram>("Program")).Sum(p => p.Length), Is.EqualTo(27 * 2).Within(1e-9));
        Assert.That(canvas.One<string>("Text").Count(c => c == 'F'), Is.EqualTo(27));
        Assert.That(new Canvas<LSystemComponent>().Feed("Axiom", "F").Feed("Rules", "F -> F(").Feed("Generations", 3).Solve().Errors.Single(),
            Does.Contain("rule 1"));
        var tooMuch = "F -> " + new string('F', 4000);
        Assert.That(new Canvas<LSystemComponent>().Feed("Axiom", "F").Feed("Rules", tooMuch).Feed("Generations", 9).Solve().Errors.Single(),
            Does.Contain("lsystem.too_large"));
        Assert.That(new Canvas<LSystemComponent>().Feed("Axiom", "F").Feed("Rules", "F -> FF").Feed("Generations", -1).Solve().Errors.Single(),
            Does.Contain("0 or more"));
    }

    [Test]
    public void The_triangle_stands_on_the_path_and_points_forward()
    {
        var steps = Program("forward 10\nleft 90\nforward 10").Run().Value!.ToSteps();
        var canvas = new Canvas<TurtlePreviewComponent>().Feed("Steps", steps.Cast<object?>().ToArray()).Feed("Position", 0.75).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        var plane = canvas.One<Rg.Plane>("Plane");
        Assert.That(plane.Origin.DistanceTo(new Rg.Point3d(10, 5, 0)), Is.LessThan(1e-12));
        Assert.That((plane.XAxis - Rg.Vector3d.YAxis).Length, Is.LessThan(1e-12));
        // The tip is 2.5 times as far ahead as the other corners are to the sides.
        var corners = canvas.One<Rg.Curve>("Triangle");
        Assert.That(corners.GetBoundingBox(true).Max.DistanceTo(new Rg.Point3d(12, 10, 0)), Is.LessThan(1e-12));
        Assert.That(canvas.Component.ClippingBox.Max.DistanceTo(new Rg.Point3d(12, 10, 0)), Is.LessThan(1e-12));
        Assert.That(new Canvas<TurtlePreviewComponent>().Feed("Steps", steps[0]).Feed("Position", 2.0).Solve().Errors.Single(), Does.Contain("0 to 1"));
    }

    [Test]
    public void Beads_lifts_and_profiles_are_those_of_the_terminal()
    {
        // A stadium of the standard settings, and a lift at the 10 mm/s of the Z axis.
        const string Script = "bead 0.5 0.2\nrate 6000\nforward 10\nlift 5\nforward 10";
        var canvas = new Canvas<TurtleComponent>().Feed("Program", Script).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        var setup = new ProfileLibrary().Setup().OrThrow();
        Assert.That(canvas.All("Print Paths").OfType<PrintPath>().First().BeadOf(0).Area,
            Is.EqualTo(Bead.FromWidth(0.5, 0.2, 1, 100, setup.Settings.BeadShape).Area).Within(1e-12));
        Assert.That(canvas.All("Steps").OfType<TravelStep>().Single().Speed, Is.EqualTo(setup.Printer.MaxSpeed.Z));
        var circle = new Canvas<TurtleComponent>().Feed("Program", Script)
            .Feed("Setup", new SettingsGoo { Value = new PrintSettings { BeadShape = BeadShape.Circle } })
            .Solve();
        Assert.That(circle.All("Print Paths").OfType<PrintPath>().First().BeadOf(0).Area, Is.EqualTo(System.Math.PI / 16).Within(1e-12));
    }

    [Test]
    public void A_script_names_its_profiles_and_ports_name_others()
    {
        var used = new Canvas<TurtleComponent>().Feed("Program", "use \"potter_super\"\nforward 1").Solve();
        Assert.That(used.Errors, Is.Empty);
        var named = new ProfileLibrary().Setup("potter_super").OrThrow();
        PrintSetup? Made(Canvas<TurtleComponent> canvas) => canvas.Output("Steps").VolatileData.AllGoos().Cast<StepGoo>().First().Setup;
        Assert.That(Made(used), Is.EqualTo(named));
        var other = new Canvas<TurtleComponent>().Feed("Program", "use \"potter_super\"\nforward 1").Feed("Setup", "ender3").Solve();
        Assert.That(Made(other), Is.EqualTo(new ProfileLibrary().Setup("ender3").OrThrow()));
        var unknown = new Canvas<TurtleComponent>().Feed("Program", "use \"poter_super\"\nforward 1").Solve();
        Assert.That(unknown.Errors.Single(), Does.Contain("potter_super"));
        Assert.That(unknown.All("Steps"), Is.Empty);
        var thin = new Canvas<TurtleComponent>().Feed("Program", "density 0.1\nforward 1").Feed("Setup", new Material { FilamentDiameter = 1 }).Solve();
        Assert.That(thin.One<PrintPath>("Print Paths").BeadOf(0).Area, Is.EqualTo(0.1 * System.Math.PI * 0.25).Within(1e-12));
    }
}
