using Caterpillar.Planning;
using Caterpillar.Machines;
using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using Caterpillar.Turtles;
using NUnit.Framework;

namespace Caterpillar.Tests.Turtles;

internal sealed class TurtleScriptTests
{
    private static Turtle Run(string text, int seed = 0)
    {
        var script = TurtleScript.Compile(text);
        Assert.That(script.Diagnostics, Is.Empty, text);
        var run = script.Value!.Run(seed: seed);
        Assert.That(run.Diagnostics, Is.Empty, text);
        return run.Value!;
    }

    private static double X(string text) => Run(text).X;

    private static Diagnostic Error(string text, TurtleLimits? limits = null)
    {
        var script = TurtleScript.Compile(text, "p.turtle");
        if (script.Value is null) return script.Diagnostics.Single();
        var run = script.Value.Run(limits: limits);
        Assert.That(run.Value, Is.Null, text);
        return run.Diagnostics.Last();
    }

    private static void Near(Vec3 actual, Vec3 expected) => Assert.That(actual.DistanceTo(expected), Is.LessThan(1e-12), $"{actual} is not {expected}");

    [Test]
    public void Commands_are_one_per_line_or_follow_each_other()
    {
        Near(Run("forward 10\nleft 90\nforward 5").Position, new Vec3(10, 5));
        Near(Run("forward 10; left 90; forward 5").Position, new Vec3(10, 5));
        Near(Run("fd 10 lt 90 fd 5").Position, new Vec3(10, 5));
        Near(Run("# a comment\n\r\n  forward 10 // another\r\n").Position, new Vec3(10, 0));
        Near(Run("").Position, Vec3.Zero);
    }

    [Test]
    public void Values_are_separated_by_spaces_or_commas_and_may_be_formulas()
    {
        Near(Run("forward_lift 1 -2").Position, new Vec3(1, 0, -2));
        Near(Run("forward_lift 1, -2").Position, new Vec3(1, 0, -2));
        Near(Run("forward 10 - 2").Position, new Vec3(8, 0));
        Near(Run("forward 10-2").Position, new Vec3(8, 0));
        Near(Run("forward_lift (10 -2) 2*3").Position, new Vec3(8, 0, 6));
        Near(Run("let x = 2\nforward_lift 1 -(x / 4) * 2").Position, new Vec3(1, 0, -1));
        Near(Run("let d = 3; position d 2*d -d").Position, new Vec3(3, 6, -3));
        Near(Run("start 1 2 3\nposition keep 5 keep").Position, new Vec3(1, 5, 3));
        Near(Run("jump 1 2 3 90\nforward 1").Position, new Vec3(1, 3, 3));
        Near(Run("forward 3 0.5").Position, new Vec3(3, 0, 0.5));
    }

    [Test]
    public void Loops_count()
    {
        Near(Run("repeat 4 [ forward 10\n left 90 ]").Position, Vec3.Zero);
        Assert.That(X("for i = 1 to 4 [ forward i ]"), Is.EqualTo(10));
        Assert.That(X("for i = 4 to 1 step -1 [ forward i ]"), Is.EqualTo(10));
        Assert.That(X("for i = 0 to 1 step 0.1 [ forward 1 ]"), Is.EqualTo(11));
        Assert.That(X("for i = 1 to 0 [ forward 1 ]"), Is.Zero);
        Assert.That(X("repeat 0 [ forward 1 ]"), Is.Zero);
        Assert.That(X("repeat 2 [ repeat 3 [ for i = 1 to 2 [ forward 1 ] ] ]"), Is.EqualTo(12));
        Assert.That(X("let n = 5\nwhile n > 0 [ forward n; n -= 1 ]"), Is.EqualTo(15));
        Assert.That(X("for i = 1 to 9 [ if i > 3 [ break ]\n forward 1 ]"), Is.EqualTo(3));
        Assert.That(X("repeat 9 [ for i = 1 to 9 [ break ]\n forward 1 ]"), Is.EqualTo(9));
        Assert.That(X("for i = 1 to 3 [ ]\nforward i"), Is.EqualTo(3), "the variable keeps its last value");
    }

    [Test]
    public void Conditions_choose()
    {
        const string Program = "param x = 0\nif x > 2 [ forward 3 ]\nelse\nif x > 1 [ forward 2 ] else\n[ forward 1 ]\nforward 10";
        var script = TurtleScript.Compile(Program).Value!;
        double At(double x) => script.Run(variables: new Dictionary<string, double> { ["x"] = x }).Value!.X;
        Assert.That(new[] { At(3), At(2), At(0) }, Is.EqualTo(new[] { 13.0, 12, 11 }));
        Assert.That(X("if 1 > 2 and 1/0 > 1 [ forward 1 ]"), Is.Zero);
    }

    [Test]
    public void Variables_are_global_outside_and_local_inside_of_procedures()
    {
        Assert.That(X("x = 3\ndef go [ let x = 5\n forward x ]\ngo\nforward x"), Is.EqualTo(8));
        Assert.That(X("x = 3\ndef go [ x = 5 ]\ngo\nforward x"), Is.EqualTo(5));
        Assert.That(X("def go n [ y = n * 2\n forward y ]\ngo 4"), Is.EqualTo(8));
        Assert.That(X("size = 7\ngo 2\ndef go n [ forward n * size ]"), Is.EqualTo(14), "names are known before their line");
        Assert.That(Error("go 2\ndef go n [ forward n * size ]\nsize = 7").Code, Is.EqualTo("turtle.no_value"), "but not their values");
    }

    [Test]
    public void Procedures_have_parameters_and_call_each_other()
    {
        Near(Run("def square s [ repeat 4 [ forward s; left 90 ] ]\nsquare 10\nforward 1").Position, new Vec3(1, 0));
        Assert.That(X("def down n [ if n == 0 [ return ]\n forward n\n down n - 1 ]\ndown 4"), Is.EqualTo(10));
        Assert.That(X("def even n [ if n > 0 [ forward 1; odd n-1 ] ]\ndef odd n [ if n > 0 [ forward 10; even n-1 ] ]\neven 4"), Is.EqualTo(22));
        // Each call has its own variables, also after a deeper one has returned.
        Assert.That(X("def tree n [ if n > 0 [ let d = n\n for i = 1 to 2 [ tree n-1 ]\n forward d ] ]\ntree 3"), Is.EqualTo(3 + (2 * 2) + (4 * 1)));
        Assert.That(X("def f [ forward 1; stop ]\nrepeat 3 [ f ]\nforward 5"), Is.EqualTo(1), "stop ends the program");
        Assert.That(X("forward 1; return; forward 5"), Is.EqualTo(1));
        Assert.That(X("def two a, b [ forward a * 10 + b ]\ntwo 1 2\ntwo 3, 4"), Is.EqualTo(46));
        Assert.That(X("def two a, b [ forward a * 10 + b ]\ntwo((1 + 2) * 2, max(3, 4))\ntwo (1 + 1) 1"), Is.EqualTo(64 + 21));
    }

    [Test]
    public void Arrays_hold_numbers()
    {
        Assert.That(X("array cells 5\nfor i = 0 to 4 [ cells[i] = i * i ]\nfor i = 0 to 4 [ forward cells[i] ]"), Is.EqualTo(30));
        Assert.That(X("array a 3\na[1] = 2\nif a[1] [ forward a[1] + a[a[0] + 1] ]"), Is.EqualTo(4));
    }

    [Test]
    public void Formulas_see_the_turtle() => Near(Run("start 3 4\nleft 90\nforward turtle_x\nleft turtle_yaw\nforward 1").Position, new Vec3(2, 7));

    [Test]
    public void Parameters_are_set_from_outside()
    {
        var script = TurtleScript.Compile("param side = 10\nparam n = 2\nrepeat n [ forward side ]").Value!;
        Assert.That(script.Parameters, Is.EqualTo(new[] { "side", "n" }));
        Assert.That(script.Run(variables: new Dictionary<string, double> { ["side"] = 3 }).Value!.X, Is.EqualTo(6));
        var unknown = script.Run(variables: new Dictionary<string, double> { ["sied"] = 3 });
        Assert.That(unknown.Value!.X, Is.EqualTo(20));
        Assert.That(unknown.Diagnostics.Single().Message, Does.Contain("Did you mean 'side'?"));
        Assert.That(script.Run(variables: new Dictionary<string, double> { ["side"] = double.NaN }).HasErrors, Is.True);
    }

    [Test]
    public void Random_programs_repeat_with_their_seed()
    {
        const string Program = "repeat 20 [ forward random(1, 5) ]";
        Assert.That(Run(Program, 3).X, Is.EqualTo(Run(Program, 3).X).And.Not.EqualTo(Run(Program, 4).X));
        Assert.That(Run("seed 5\n" + Program, 3).X, Is.EqualTo(Run("seed 5\n" + Program, 4).X));
    }

    [Test]
    public void Texts_may_hold_formulas()
    {
        var steps = Run("let n = 3\ncomment \"layer {n + 0.5} of {2*n}\"\nraw \"M117 {n}\"\npause").ToSteps();
        Assert.That(steps.Cast<EventStep>().Select(e => e.Event),
            Is.EqualTo(new PrinterEvent[] { new CommentEvent("layer 3.5 of 6"), new RawEvent("M117 3"), new PauseEvent() }));
    }

    [Test]
    public void Every_command_can_be_written_and_is_understood()
    {
        foreach (var info in TurtleCommands.All)
        {
            foreach (var name in new[] { info.Name }.Concat(info.Aliases))
            {
                var values = info.Action switch
                {
                    TurtleAction.Color => "1 2 3",
                    TurtleAction.Polygon => "5 1",
                    TurtleAction.Mix => "0.5",
                    _ => string.Join(" ", info.Values.Take(info.Required).Select(_ => "1")),
                };
                var text = info.Text is null ? "" : info.Action switch { TurtleAction.Color => "", TurtleAction.Role => " \"skirt\"", _ => " \"x\"" };
                var setup = info.Action == TurtleAction.Pop ? "push\n" : "";
                var end = info.Action == TurtleAction.Push ? "\npop" : "";
                    Run($"{setup}{name}{text} {values}{end}");
            }
        }
    }

    [Test]
    public void Scripts_and_commands_and_calls_draw_the_same()
    {
        var script = Run("start 1 1\nrepeat 3 [ forward 10; right 120 ]\nlift 0.2\ncircle 5 12");
        var commands = TurtleProgram.FromCommands(
        [
            TurtleCommand.Of(TurtleAction.Start, 1, 1),
            TurtleCommand.Repeat(3, [TurtleCommand.Of(TurtleAction.Forward, 10), TurtleCommand.Of(TurtleAction.Right, 120)]),
            TurtleCommand.Of(TurtleAction.Lift, 0.2),
            TurtleCommand.Of(TurtleAction.Circle, 5, 12),
        ]).Run().Value!;
        var calls = new Turtle().StartAt(1, 1);
        for (var i = 0; i < 3; i++) calls.Forward(10).Right(120);
        calls.Lift(0.2).Circle(5, 12);
        Assert.That(TurtleHistory.Of(script.ToSteps()), Is.EqualTo(TurtleHistory.Of(calls.ToSteps())));
        Assert.That(TurtleHistory.Of(commands.ToSteps()), Is.EqualTo(TurtleHistory.Of(calls.ToSteps())));
    }

    [Test]
    public void Commands_print_as_script_lines()
    {
        TurtleCommand[] commands =
        [
            TurtleCommand.Of(TurtleAction.Position, double.NaN, 2.5, -1),
            TurtleCommand.Repeat(2, [TurtleCommand.Of(TurtleAction.Forward, 1), TurtleCommand.Of(TurtleAction.Comment, "hi")]),
        ];
        var text = string.Join("\n", commands.Select(c => c.ToString()));
        Assert.That(text, Is.EqualTo("position keep 2.5 -1\nrepeat 2 [ forward 1; comment \"hi\" ]"));
        Near(Run(text).Position, new Vec3(2, 2.5, -1));
    }

    [TestCase("forwrad 10", 1, 1, "turtle.unknown", "Did you mean 'forward'?")]
    [TestCase("left 90\n  forward", 2, 3, "turtle.values", "needs one value")]
    [TestCase("forward 1 2 3", 1, 13, "turtle.values", "expected the end")]
    [TestCase("forward lenght", 1, 9, "formula.unknown", "Unknown variable")]
    [TestCase("let length = 3\nforward lenght", 2, 9, "formula.unknown", "Did you mean 'length'?")]
    [TestCase("repeat 4 [\n forward 1\n", 1, 10, "turtle.bracket", "'[' has no closing")]
    [TestCase("forward 1 ]", 1, 11, "turtle.bracket", "no matching")]
    [TestCase("repeat 4 forward 1", 1, 10, "turtle.syntax", "expected '['")]
    [TestCase("forward 1 +", 1, 12, "formula.syntax", "end")]
    [TestCase("forward (1 + 2", 1, 9, "formula.bracket", "no closing")]
    [TestCase("x = 1\nforward 10 / (x - 1)", 2, 9, "turtle.not_finite", "division by zero")]
    [TestCase("forward 0 / 0", 1, 9, "turtle.not_finite", "not a number")]
    [TestCase("x = sqrt(-1)", 1, 5, "turtle.not_finite", "not a number")]
    [TestCase("if y > 1 [ ]\ny = 2", 1, 4, "turtle.no_value", "no value yet")]
    [TestCase("rate 0", 1, 1, "turtle.value", "above 0")]
    [TestCase("pop", 1, 1, "turtle.value", "No pushed state")]
    [TestCase("forward 1\nstart 1 1", 2, 1, "turtle.value", "come before the first move")]
    [TestCase("tool 1.5", 1, 1, "turtle.value", "integer")]
    [TestCase("for i = 1 to 10 step 0 [ ]", 1, 22, "turtle.value", "must not be 0")]
    [TestCase("def f x x [ ]", 1, 9, "turtle.name", "twice")]
    [TestCase("def forward x [ ]", 1, 5, "turtle.name", "already a command")]
    [TestCase("def f [ ]\ndef f [ ]", 2, 5, "turtle.name", "defined twice")]
    [TestCase("repeat 2 [ def f [ ] ]", 1, 12, "turtle.syntax", "outside blocks")]
    [TestCase("def f a b [ ]\nf 1", 2, 1, "turtle.values", "needs 2 values")]
    [TestCase("array a 3\na[3] = 1", 2, 1, "turtle.index", "indices are 0 to 2")]
    [TestCase("array a 3\nforward a[-1]", 2, 9, "turtle.index", "indices are 0 to 2")]
    [TestCase("forward a[1]\narray a 3", 1, 9, "turtle.index", "not been created")]
    [TestCase("array a -3", 1, 9, "turtle.value", "integer")]
    [TestCase("break", 1, 1, "turtle.syntax", "only allowed in a loop")]
    [TestCase("comment 3", 1, 9, "turtle.values", "needs a text")]
    [TestCase("comment \"abc", 1, 9, "formula.text", "closing quotation mark")]
    [TestCase("comment \"a {1 +} b\"", 1, 16, "formula.syntax", "end")]
    [TestCase("forward 1 § 2", 1, 11, "formula.character", "Unexpected character")]
    [TestCase("10 20", 1, 1, "turtle.syntax", "expected a command")]
    [TestCase("x 3\nx = 1", 1, 1, "turtle.syntax", "is a variable")]
    [TestCase("keep 3", 1, 1, "turtle.unknown", "Unknown command")]
    [TestCase("forward keep", 1, 9, "turtle.values", "keep")]
    [TestCase("color \"red\"", 1, 1, "turtle.value", "rrggbb")]
    [TestCase("role \"infil\"", 1, 1, "turtle.value", "Did you mean 'infill'?")]
    [TestCase("repeat = 3", 1, 1, "turtle.name", "reserved name")]
    [TestCase("lsystem 3 \"F\" \"F -> F(\"", 1, 22, "lsystem.bracket", "'(' has no closing")]
    [TestCase("lsystem 3 \"F]\" \"F -> FF\"", 1, 1, "lsystem.bracket", "No pushed state")]
    [TestCase("lsystem -1 \"F\"", 1, 9, "turtle.value", "integer")]
    public void Errors_state_what_and_where(string text, int line, int column, string code, string message)
    {
        var error = Error(text);
        Assert.That((error.Source!.Line, error.Source.Column, error.Code), Is.EqualTo(((int?)line, (int?)column, code)), error.Message);
        Assert.That(error.Message, Does.Contain(message));
        Assert.That(error.Source.File, Is.EqualTo("p.turtle"));
    }

    [Test]
    public void Endless_programs_are_stopped_with_line_and_column()
    {
        var few = new TurtleLimits { MaxSteps = 100_000, MaxMoves = 1000, MaxDepth = 500, MaxSymbols = 1000 };
        (string, int, string)[] programs =
        [
            ("forward 1\nrepeat 1000000000 [ left 1 ]", 2, "turtle.too_many_steps"),
            ("for i = 1 to 1000000000 [ ]", 1, "turtle.too_many_steps"),
            ("while 1 [ left 1 ]", 1, "turtle.too_many_steps"),
            ("repeat 1000000000 [ forward 1 ]", 1, "turtle.too_many_moves"),
            ("def f n [\n f n + 1 ]\nf 1", 2, "turtle.recursion"),
            ("lsystem 50 \"F\" \"F -> FF\"", 1, "lsystem.too_large"),
            ("lsystem 9 \"F\" \"F -> FF\"\nleft 3", 1, "none"),
            ("array a 2000", 1, "turtle.value"),
        ];
        foreach (var (text, line, code) in programs)
        {
            if (code == "none")
            {
                Assert.That(TurtleScript.Compile(text).Value!.Run(limits: few).Value!.X, Is.EqualTo(512));
                continue;
            }
            var error = Error(text, few);
            Assert.That((error.Code, error.Source!.Line), Is.EqualTo((code, (int?)line)), text);
            Assert.That(error.Source.Column, Is.GreaterThan(0));
        }
        Assert.That(Error(string.Concat(Enumerable.Repeat("repeat 1 [", 100_000))).Code, Is.EqualTo("turtle.nesting"));
        var nested = TurtleCommand.Of(TurtleAction.Yaw, 1);
        for (var i = 0; i < 100_000; i++) nested = TurtleCommand.Repeat(1, [nested]);
        Assert.That(TurtleProgram.FromCommands([nested]).Run().HasErrors, Is.False, "nesting of commands has no limit");
        var endless = TurtleCommand.Repeat(1_000_000_000, [TurtleCommand.Repeat(1_000_000_000, [TurtleCommand.Of(TurtleAction.Yaw, 1)])]);
        Assert.That(TurtleProgram.FromCommands([endless]).Run(limits: few).Diagnostics.Single().Code, Is.EqualTo("turtle.too_many_steps"));
    }

    [Test]
    public void Running_can_be_canceled()
    {
        using var source = new CancellationTokenSource();
        source.CancelAfter(50);
        var limits = new TurtleLimits { MaxSteps = long.MaxValue };
        Assert.That(() => TurtleScript.Compile("while 1 [ left 1 ]").Value!.Run(limits: limits, cancel: source.Token),
            Throws.InstanceOf<OperationCanceledException>());
        using var done = new CancellationTokenSource();
        done.Cancel();
        Assert.That(() => LSystem.Parse("F", ["F -> FF"]).Value!.Grow(20, cancel: done.Token), Throws.InstanceOf<OperationCanceledException>());
    }

    [Test]
    public void No_text_makes_it_throw()
    {
        var random = new Random(21);
        string[] words = ["forward", "repeat", "[", "]", "4", "x", "=", "for", "i", "to", "if", "else", "def", "f", "(", ")", "+", "-", "\n", ";", "\"F\"",
            "lsystem", "array", "push", "pop", "while", "let", "param", "arc", "{", "break", "return"];
        var limits = new TurtleLimits { MaxSteps = 2000, MaxMoves = 200, MaxDepth = 50, MaxSymbols = 100 };
        for (var i = 0; i < 4000; i++)
        {
            var text = string.Join(" ", Enumerable.Range(0, random.Next(1, 14)).Select(_ => words[random.Next(words.Length)]));
            var script = TurtleScript.Compile(text);
            Assert.That(script.Value is null, Is.EqualTo(script.HasErrors), text);
            var run = script.Value?.Run(limits: limits);
            if (run is not null) Assert.That(run.Value is null, Is.EqualTo(run.HasErrors), text);
        }
    }

    [TestCase(BeadShape.Rectangle, 0.08)]
    [TestCase(BeadShape.Stadium, 0.2 * 0.2 + Math.PI / 4 * 0.2 * 0.2)]
    [TestCase(BeadShape.Circle, Math.PI / 4 * 0.4 * 0.4)]
    public void A_bead_has_the_shape_of_the_settings(BeadShape shape, double area)
    {
        var turtle = TurtleScript.Compile("bead 0.4 0.2\nforward 10").Value!.Run(new TurtleOptions { Shape = shape }).Value!;
        Assert.That(turtle.Bead.Area, Is.EqualTo(area).Within(1e-12));
    }

    [Test]
    public void The_flow_multiplier_scales_extrusions_but_not_what_is_extruded_in_place()
    {
        var setup = new PrintSetup(new Printer(), new Material { FlowRatio = 1.2 }, new PrintSettings());
        var turtle = TurtleScript.Compile("density 0.05\nforward 10\nextrude 2").Value!.Run(new TurtleOptions { Extrusion = setup.Extrusion }).Value!;
        var plan = Planner.Plan(turtle.ToSteps(), setup, new PlanOptions { Policy = PlanPolicy.AsDrawn }).Value!;
        Assert.That(plan.Moves().Where(m => m.E > 0).Select(m => m.E), Is.EqualTo(new[] { 10 * 0.05 * 1.2, 2 }).Within(1e-9));
    }

    [Test]
    public void A_script_names_the_profiles_that_it_is_for()
    {
        Assert.That(TurtleScript.Compile("# clay\nuse \"potter_super\" \"clay\"\nforward 1").Value!.Profiles, Is.EqualTo(new[] { "potter_super", "clay" }));
        Assert.That(TurtleScript.Compile("forward 1").Value!.Profiles, Is.Empty);
    }

    [TestCase("use", "turtle.values")]
    [TestCase("use 3", "turtle.values")]
    [TestCase("use \"a\" \"b\" \"c\" \"d\"", "turtle.values")]
    [TestCase("use \"a\"\nuse \"b\"", "turtle.syntax")]
    [TestCase("repeat 2 [ use \"a\" ]", "turtle.syntax")]
    public void Wrong_uses_are_errors(string script, string code)
        => Assert.That(TurtleScript.Compile(script).Diagnostics.Single().Code, Is.EqualTo(code));

    [Test]
    public void Repeat_counts_its_turns()
    {
        // 1 + 2 + 3 mm, and in each turn 1 + 2 mm more.
        Assert.That(Run("repeat 3 [ forward repcount; repeat 2 [ forward repcount ] ]").X, Is.EqualTo(6 + 3 * 3).Within(1e-12));
        Assert.That(Run("def leg n [ repeat 2 [ forward repcount * n ] ]\nrepeat 2 [ leg repcount ]").X, Is.EqualTo(3 * 1 + 3 * 2).Within(1e-12));
        Assert.That(Run("repcount = 5\nrepeat 2 [ forward repcount ]").X, Is.EqualTo(10).Within(1e-12), "a variable of that name comes first");
        Assert.That(TurtleScript.Compile("forward repcount").Diagnostics.Single().Code, Is.EqualTo("formula.unknown"));
    }

    [Test]
    public void Moves_straight_up_keep_within_the_speed_of_the_axis()
    {
        var turtle = new Turtle(new TurtleOptions { MaxLiftSpeed = 12 }).Forward(10).LiftWorld(0.2).Forward(5).Move(5);
        Assert.That(turtle.ToSteps().OfType<TravelStep>().Select(s => s.Speed), Is.EqualTo(new[] { 12, 1000 / 60.0 }).Within(1e-9));
    }
}
