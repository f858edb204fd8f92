using System;
using System.IO;
using System.Linq;
using Caterpillar.GCode;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Slice;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Components;

public sealed class GCodeTests
{
    private const string Small = "M83\nG1 X10 Y10 Z0.2 F3000\nG1 X20 Y10 E0.5 F1200\nG1 X20 Y20 E0.5\n";

    private static PrintPath Line(double x, double length = 10) => new([new Vec3(x, 50, 0.2), new Vec3(x + length, 50, 0.2)], new Bead(0.08, 0.2, 40));

    private static Toolpath Planned(double x = 50)
        => new Canvas<PlanToolpathComponent>().Feed("Steps", Line(x)).Feed("Setup", "generic").Solve().One<Toolpath>("Toolpath");

    [Test]
    public void From_a_solid_to_G_code_and_back()
    {
        var document = new GH_Document();
        var slice = new Canvas<PlanarSlicerComponent>(document).Feed("Geometry", Shapes.Box(height: 1));
        var plan = new Canvas<PlanToolpathComponent>(document).Feed("Setup", "ender3");
        var write = new Canvas<GenerateGCodeComponent>(document);
        var text = new Canvas<GCodeTextComponent>(document);
        var decode = new Canvas<DecodeGCodeComponent>(document);
        plan.Input("Steps").AddSource(slice.Output("Print Paths"));
        write.Input("Toolpath").AddSource(plan.Output("Toolpath"));
        text.Input("G-code").AddSource(write.Output("G-code"));
        decode.Input("G-code").AddSource(write.Output("G-code"));
        document.NewSolution(false);
        Assert.That(document.Objects.OfType<IGH_ActiveObject>().SelectMany(o => o.RuntimeMessages(GH_RuntimeMessageLevel.Error)), Is.Empty);
        Assert.That(text.All("Lines"), Has.Member("M82").And.Some.StartsWith("G1 "));
        Assert.That(write.Output("G-code").VolatileData.get_Branch(0)[0]!.ToString(), Does.Contain("lines").And.Contain("bytes of G-code"));
        var (planned, decoded) = (ToolpathTotals.Of(plan.One<Toolpath>("Toolpath")), decode.One<Toolpath>("Toolpath"));
        var walls = decoded.Moves().Where(m => m.Kind == MoveKind.Print && m.Role == Role.OuterWall).Sum(m => m.Length);
        Assert.That(walls, Is.EqualTo(plan.One<Toolpath>("Toolpath").Moves().Where(m => m.Role == Role.OuterWall && m.Kind == MoveKind.Print)
            .Sum(m => m.Length)).Within(0.05));
        Assert.That(decoded.Moves().Where(m => m.Kind == MoveKind.Print && m.Role is not (Role.Unspecified or Role.Purge)).Sum(m => m.Deposited),
            Is.EqualTo(planned.DepositedE).Within(1e-3));
    }

    [TestCase("de-DE")]
    [TestCase("tr-TR")]
    [TestCase("ar-SA")]
    public void The_culture_of_the_user_changes_nothing(string culture)
    {
        string[] Lines()
        {
            var plan = new Canvas<PlanToolpathComponent>().Feed("Steps", Line(20.125), Line(40)).Feed("Setup", "ender3").Feed("Mode", "PRINTER").Solve();
            Assert.That(plan.Errors, Is.Empty);
            var write = new Canvas<GenerateGCodeComponent>().Feed("Toolpath", plan.Output("Toolpath").VolatileData.get_Branch(0)[0]).Solve();
            return write.One<GCodeDocument>("G-code").Lines(1, 10000).Concat(plan.All("Toolpath").Select(t => t!.ToString()!)).ToArray();
        }
        var expected = Lines();
        var before = System.Threading.Thread.CurrentThread.CurrentCulture;
        try
        {
            System.Threading.Thread.CurrentThread.CurrentCulture = new System.Globalization.CultureInfo(culture);
            Assert.That(Lines(), Is.EqualTo(expected));
        }
        finally
        {
            System.Threading.Thread.CurrentThread.CurrentCulture = before;
        }
    }

    [Test]
    public void Steps_of_several_branches_follow_each_other()
    {
        var canvas = new Canvas<PlanToolpathComponent>().FeedTree("Steps", [Line(20)], [Line(40), new StepGoo(new DwellEvent(2))], [Line(60)])
            .Feed("Setup", "generic").Solve();
        Assert.That(canvas.Errors, Is.Empty);
        var toolpath = canvas.One<Toolpath>("Toolpath");
        Assert.That(toolpath.Moves().Where(m => m.Kind == MoveKind.Print).Select(m => m.Start.X), Is.EqualTo(new[] { 20.0, 40, 60 }));
        Assert.That(toolpath.Events.Any(e => e.Event is DwellEvent), Is.True);
        Assert.That(canvas.Output("Toolpath").VolatileData.get_Branch(0)[0]!.ToString(), Does.StartWith("Toolpath (").And.Contain(" m printed)"));
    }

    [Test]
    public void A_plan_as_drawn_adds_nothing_and_choices_take_their_names()
    {
        var canvas = new Canvas<PlanToolpathComponent>().Feed("Steps", Line(20), Line(40)).Feed("Setup", "generic").Feed("Mode", "as drawn")
            .Feed("Sort", "none").Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(canvas.One<Toolpath>("Toolpath").Moves().Select(m => m.Kind), Has.None.EqualTo(MoveKind.Retract));
        Assert.That(canvas.Feed("Mode", "sideways").Solve().Errors, Has.Member("Mode has no choice \"sideways\". Choose one of: Printer, As Drawn."));
        Assert.That(canvas.Feed("Mode", 7).Solve().Errors, Is.EqualTo(new[] { "{0}[0]: Mode has no choice 7. Choose one of: Printer, As Drawn." }));
    }

    [Test]
    public void A_plan_for_each_printer_of_a_list_and_null_for_the_bad_one()
    {
        var canvas = new Canvas<PlanToolpathComponent>().Feed("Steps", Line(20), null).Feed("Setup", "generic", null, "ender3", "nothing").Solve();
        Assert.That(canvas.All("Toolpath").Select(t => t is null), Is.EqualTo(new[] { false, true, false, true }));
        Assert.That(canvas.Warnings, Has.Member("{0}[0]: Steps: 1 null item is ignored."));
        Assert.That(canvas.Errors, Has.Member("{0}[1]: Setup: the connected source gives no valid data.").And.One.Contains("\"nothing\""));
    }

    [Test]
    public void A_plan_needs_steps()
    {
        Assert.That(new Canvas<PlanToolpathComponent>().Feed("Setup", "generic").Solve().Warnings,
            Is.EqualTo(new[] { "Input parameter S failed to collect data" }));
        Assert.That(new Canvas<PlanToolpathComponent>().Feed("Setup", "generic").Feed("Steps", null).Solve().Errors,
            Has.Member("{0}[0]: Steps: the connected source gives no valid data."));
    }

    [Test]
    public void What_could_damage_the_machine_is_refused_and_only_a_reason_overrides_it()
    {
        var canvas = new Canvas<GenerateGCodeComponent>().Feed("Toolpath", new ToolpathGoo(Planned(215), new PrintSetup())).Solve();
        Assert.That(canvas.All("G-code"), Is.EqualTo(new object?[] { null }));
        Assert.That(canvas.Errors, Has.Some.Contains("bed.outside").And.Some.Contains("write.refused"));
        Assert.That(canvas.Component.Message, Is.EqualTo("refused"));
        canvas.Feed("Override Reason", "the bed is larger than the profile says").Solve();
        Assert.That(canvas.One<GCodeDocument>("G-code").Lines(1, 100), Has.Some.Contains("the bed is larger than the profile says"));
    }

    [Test]
    public void A_toolpath_that_was_not_planned_needs_a_setup()
    {
        var canvas = new Canvas<GenerateGCodeComponent>().Feed("Toolpath", Planned(), null).Solve();
        Assert.That(canvas.All("G-code"), Is.EqualTo(new object?[] { null, null }));
        Assert.That(canvas.Warnings, Is.EqualTo(new[]
        {
            "{0}[0]: Setup is missing. The toolpath was not planned with one: connect Print Setup.", "{0}[1]: Toolpath is missing.",
        }));
        canvas.Feed("Setup", "generic").Solve();
        Assert.That(canvas.All("G-code").Select(g => g is null), Is.EqualTo(new[] { false, true }));
    }

    [Test]
    public void G_code_for_a_list_and_a_tree()
    {
        var goo = new ToolpathGoo(Planned(), new PrintSetup());
        Assert.That(new Canvas<GenerateGCodeComponent>().Feed("Toolpath", goo, goo).Solve().All("G-code"), Has.Count.EqualTo(2));
        Assert.That(new Canvas<GenerateGCodeComponent>().FeedTree("Toolpath", [goo], [goo]).Solve().Paths("G-code"), Is.EqualTo(new[] { "{0}", "{1}" }));
    }

    [TestCase(1, 2, new[] { "M83", "G1 X10 Y10 Z0.2 F3000" })]
    [TestCase(3, 100, new[] { "G1 X20 Y10 E0.5 F1200", "G1 X20 Y20 E0.5" })]
    [TestCase(-1, 5, new[] { "G1 X20 Y20 E0.5" })]
    [TestCase(50, 5, new string[0])]
    [TestCase(1, 0, new string[0])]
    public void Some_lines_of_a_file(int start, int count, string[] lines)
    {
        var canvas = new Canvas<GCodeTextComponent>().Feed("G-code", Small).Feed("Start", start).Feed("Count", count).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(canvas.All("Lines").Where(l => !Equals(l, "")), Is.EqualTo(lines));
    }

    [Test]
    public void An_invalid_range_of_lines_is_an_error_and_trees_keep_their_branches()
    {
        var canvas = new Canvas<GCodeTextComponent>().FeedTree("G-code", [Small], [Small, null]).Feed("Start", 1).Feed("Count", 1).Solve();
        Assert.That(canvas.Paths("Lines"), Is.EqualTo(new[] { "{0;0}", "{1;0}", "{1;1}" }));
        Assert.That(canvas.Warnings, Is.EqualTo(new[] { "{1}[1]: G-code is missing." }));
        Assert.That(canvas.Feed("Start", 0).Solve().Errors, Has.Some.Contains("Start must be 1 or more"));
        Assert.That(canvas.Feed("Start", 1).Feed("Count", -1).Solve().Errors, Has.Some.Contains("Count must be from 0 to 100000."));
    }

    [Test]
    public void Text_and_files_are_decoded()
    {
        var canvas = new Canvas<DecodeGCodeComponent>().Feed("G-code", Small).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(ToolpathTotals.Of(canvas.One<Toolpath>("Toolpath")).PrintLength, Is.EqualTo(20).Within(1e-9));
        var folder = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N"));
        Directory.CreateDirectory(folder);
        try
        {
            var file = Path.Combine(folder, "small.gcode");
            File.WriteAllText(file, Small);
            var files = new Canvas<DecodeGCodeComponent>();
            files.Document.FilePath = Path.Combine(folder, "definition.gh");
            files.Feed("File", "small.gcode", "none.gcode", null).Feed("Flavor", "klipper").Feed("Rule", "rising").Solve();
            Assert.That(files.All("Toolpath").Select(t => t is null), Is.EqualTo(new[] { false, true, true }));
            Assert.That(files.All("Flavor")[0], Is.EqualTo("klipper"));
            Assert.That(files.Errors, Has.One.Contains("{0}[1]: File not found: ").And.One.Contains("none.gcode"));
            Assert.That(files.Errors, Has.Member("{0}[2]: File: the connected source gives no valid data."));
            File.WriteAllText(file, Small + "G1 X30 E1\n");
            files.Component.ExpireSolution(false);
            files.Solve();
            Assert.That(((Toolpath)files.All("Toolpath")[0]!).Count, Is.EqualTo(canvas.One<Toolpath>("Toolpath").Count + 1), "A changed file is read again.");
            File.WriteAllBytes(file, [0x1F, 0x8B, 8, 0, 1, 2]);
            files.Component.ExpireSolution(false);
            files.Solve();
            Assert.That(files.Errors, Has.One.EndsWith("small.gcode: The file cannot be read. It is cut off."));
        }
        finally
        {
            Directory.Delete(folder, true);
        }
    }

    [Test]
    public void A_file_next_to_connected_G_code_is_ignored_with_a_warning()
    {
        var canvas = new Canvas<DecodeGCodeComponent>().Feed("G-code", Small).Feed("File", "other.gcode").Solve();
        Assert.That(canvas.Warnings, Is.EqualTo(new[] { "{0}[0]: File is ignored because G-code is connected." }));
        Assert.That(canvas.All("Toolpath"), Has.Count.EqualTo(1).And.None.Null);
    }

    [Test]
    public void What_is_no_G_code_is_refused_and_the_rest_continues()
    {
        var canvas = new Canvas<DecodeGCodeComponent>().FeedTree("G-code", [Small], ["\u0001 what? G1 X1e999 %%", ""]).Solve();
        Assert.That(canvas.All("Toolpath").Select(t => t is null), Is.EqualTo(new[] { false, true, true }));
        Assert.That(canvas.Errors, Has.Some.StartsWith("{1}[0]: ").And.Some.StartsWith("{1}[1]: "));
        Assert.That(canvas.Feed("Flavor", "cobol").Solve().Errors, Has.Some.Contains("G-code flavor \"cobol\" not found. Use detect, slicer, "));
    }
}
