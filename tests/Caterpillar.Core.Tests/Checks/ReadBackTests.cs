using System;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using Caterpillar.Turtles;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>The file is what is checked: what is read back is compared with the plan, line by line.</summary>
public class ReadBackTests
{
    private static readonly PrintSetup Setup = SmallPrint.Setup();

    [TestCase("G91", "file.modes", 3)]
    [TestCase("G20", "file.modes", 3)]
    [TestCase("M82", "file.modes", 3)]
    [TestCase("G1 X500", "bed.outside", 3)]
    [TestCase("G1 Z-1", "bed.below", 3)]
    [TestCase("M104 S0", "limit.cold_extrusion", 3)]
    [TestCase("M104 S400", "limit.nozzle_temperature", 3)]
    [TestCase("M140 S400", "limit.bed_temperature", 3)]
    [TestCase("G1 E300 F300", "limit.stationary", 3)]
    public void Raw_lines_of_a_turtle_that_hurt_are_refused_with_the_line_of_the_script(string raw, string code, int line)
    {
        var (result, _) = Turtle($"start 60 60 0.2\nforward 20\nraw \"{raw}\"\nforward 20\n");
        Assert.That(result.Value, Is.Null);
        var found = result.Diagnostics.First(d => d.Code == code);
        Assert.That((found.Severity, found.Source!.Origin?.File, found.Source.Origin?.Line), Is.EqualTo((Severity.Error, "art.turtle", line)),
            found.ToString());
        Assert.That(result.Diagnostics.Last().Code, Is.EqualTo(SafeWriter.Refused));
        var (overridden, text) = Turtle($"start 60 60 0.2\nforward 20\nraw \"{raw}\"\nforward 20\n", "a test of the firmware");
        Assert.That(overridden.Value, Is.Not.Null);
        Assert.That(overridden.Diagnostics.First(d => d.Code == code).Severity, Is.EqualTo(Severity.Warning));
        Assert.That(text.Split('\n').Take(10),
            Has.Some.EqualTo("; Written despite these findings. Reason: a test of the firmware").And.Some.Contains(code));
        var at = overridden.Diagnostics.First(d => d.Code == code).Source!.Line;
        if (code is "bed.outside" or "bed.below" or "file.modes") Assert.That(text.Split('\n')[at!.Value - 1], Is.EqualTo(raw),
            "the line of the file that is written");
    }

    [TestCase("M117 hello")]
    [TestCase("G91\\nG1 Z5\\nG90")]
    [TestCase("G4 P100")]
    public void Harmless_raw_lines_are_written(string raw)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(60, 60, 5));
        builder.Add(new Vec3(60, 60, 0.2), 0, 0, 30, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        Extrusion(builder, 80);
        builder.AddEvent(new RawEvent(raw.Replace("\\n", "\n")), 1);
        Extrusion(builder, 100);
        using var memory = new MemoryStream();
        var result = SafeWriter.Write(builder.Build([new ToolpathTool(SmallPrint.FilamentArea)]), new ProfileLibrary().Setup("generic").OrThrow(), memory);
        Assert.That(result.Diagnostics.Where(d => d.Severity == Severity.Error), Is.Empty);
    }

    [TestCase("start_gcode", 0)]
    [TestCase("end_gcode", 1)]
    public void Templates_are_checked_too(string key, int which)
    {
        var lines = new ValueList<string>("G1 X500");
        var setup = SmallPrint.Setup(p => which == 0 ? p with { StartGCode = lines } : p with { EndGCode = lines });
        var refused = SafeWriter.ToDocument(new SmallPrint().Print(30, 10, 0.2).Build(), setup);
        var found = refused.Diagnostics.Single(d => d.Code == "bed.outside");
        Assert.That((found.Source!.Origin!.File, found.Source.Origin.Key), Is.EqualTo(("generic", key)));
    }

    [Test]
    public void Layer_and_tool_templates_are_checked_too()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(60, 60, 0.2));
        for (var k = 1; k <= 2; k++)
            builder.Add(new Vec3(60 + 5 * k, 60, 0.2 * k), 0.2, 0.2, 20, MoveKind.Print, Role.OuterWall, builder.AddLayer(new Layer(k, 0.2 * k, 0.2)), 0, k);
        var setup = SmallPrint.Setup(p => p with { LayerChangeGCode = new("G1 Y300") });
        var found = SafeWriter.ToDocument(builder.Build([new ToolpathTool(SmallPrint.FilamentArea)]), setup).Diagnostics.Single(d => d.Code == "bed.outside");
        Assert.That(found.Source!.Origin!.Key, Is.EqualTo("layer_change_gcode"));
    }

    // Each changes a number of line 9 by one unit of print, half of one, and a little more.
    [TestCase("X15", "X15.001", true)]
    [TestCase("X15", "X15.0004", false)]
    [TestCase("X15", "X15.0006", true)]
    [TestCase("X15", "X14", true)]
    [TestCase("E0.16630", "E0.16632", true)]
    [TestCase("E0.16630", "E0.16631", false)]
    [TestCase("G1 X15", "G92 X0\nG1 X15", true)]
    [TestCase("Z0.2", "Z1", true)]
    public void A_line_that_does_not_what_was_planned_is_named(string text, string instead, bool found)
    {
        var toolpath = new SmallPrint().Print(15, 10, 0.2).Print(20, 10, 0.2).Print(25, 10, 0.2).Build();
        var (_, lines, written) = SmallPrint.Written(toolpath, Setup);
        var line = lines.OfMove(0).Last;
        var all = written.Split('\n');
        Assert.That(all[line - 1], Does.Contain("X15"));
        if (text[0] == 'E') text = all[line - 1].Split(' ').Single(w => w[0] == 'E');
        if (text[0] == 'E') instead = "E"
            + NumberFormatter.Format(double.Parse(text.Substring(1), System.Globalization.CultureInfo.InvariantCulture) + (found ? 2e-5 : 1e-5), 5);
        all[line - 1] = all[line - 1].Replace(text, instead.Replace('\n', ' '));
        if (instead.StartsWith("G92", StringComparison.Ordinal)) all[line - 2] = "G92 X0";
        var read = SmallPrint.Decode(Encoding.ASCII.GetBytes(string.Join("\n", all)), Setup).Toolpath;
        var findings = new Findings(Setup.Printer, read);
        new PlanComparison(toolpath, SetupFormat.Of(Setup, toolpath).Value!, lines, findings).End(read, 0);
        var list = findings.ToList();
        Assert.That(list.Count > 0, Is.EqualTo(found), string.Join("\n", list));
        if (!found) return;
        Assert.That((list[0].Source!.Move, list[0].Source!.Line, list[0].Severity), Is.EqualTo((0, line, Severity.Error)));
        Assert.That(list[0].Code, Is.EqualTo(text[0] == 'E' ? "file.extrusion" : "file.position"));
        Assert.That(list[0].Message, Does.Contain("the plan has"));
    }

    [TestCase(180, 180, false)]
    [TestCase(180, -90, true)]
    [TestCase(90, -270, true)]
    public void An_arc_that_goes_the_other_direction_is_named(double planned, double written, bool found)
    {
        static SmallPrint Arc(double sweep)
        {
            var (sin, cos) = Angle.SinCos(sweep);
            return new SmallPrint(110, 100, 0.2).Arc(100 + 10 * cos, 100 + 10 * sin, 0.2, new Vec3(100, 100), sweep, SmallPrint.Area);
        }
        var toolpath = Arc(planned).Build();
        var (_, lines, _) = SmallPrint.Written(toolpath, Setup);
        var read = SmallPrint.Written(Arc(written).Build(), Setup).File.Toolpath;
        var findings = new Findings(Setup.Printer, read);
        new PlanComparison(toolpath, SetupFormat.Of(Setup, toolpath).Value!, lines, findings).End(read, 0);
        Assert.That(findings.ToList().Any(d => d.Code == "file.position"), Is.EqualTo(found));
    }

    [Test]
    public void Every_flavor_and_both_modes_of_E_are_read_back_as_planned([Values] bool relative)
    {
        foreach (var flavor in FlavorTable.All.Where(d => d.Name != "bfb"))
        {
            var setup = SmallPrint.Setup(p => p with { Flavor = flavor, ExtrusionMode = NewFile.Mode(relative) });
            var print = new SmallPrint().Print(30, 10, 0.2).Print(30, 30, 0.2).Go(30, 30, 5).Go(60, 60, 0.2)
                .Arc(80, 60, 0.2, new Vec3(70, 60), 180, SmallPrint.Area)
                .Event(new FanEvent(1)).Print(100, 60, 0.2).Event(new CommentEvent("on")).Prime(0.1).Print(100, 100.12345, 0.3);
            var result = SafeWriter.ToDocument(print.Build(), setup);
            Assert.That(result.Diagnostics.Where(d => d.Code.StartsWith("file.", StringComparison.Ordinal)), Is.Empty, flavor.Name);
        }
    }

    // Extrusions of 0.08 mm² at 50 mm/s are 4 mm³/s; as filament of 2.85 mm they would be 10.6.
    [TestCase(5, false)]
    [TestCase(3, true)]
    public void Filament_is_as_thick_as_the_tools_of_the_plan_say(double most, bool found)
    {
        var setup = SmallPrint.Setup(p => p with { MaxFlow = most }) with { Material = new Material { FilamentDiameter = 2.85 } };
        var plan = new SmallPrint(20, 20, 0.2).Print(60, 20, 0.2).Print(60, 60, 0.2).Build();
        var written = SafeWriter.Write(plan, setup, new MemoryStream(), "a test", isDraft: true);
        Assert.That(written.Diagnostics.Any(d => d.Code == CheckCodes.Flow), Is.EqualTo(found));
    }

    [Test]
    public void To_a_stream_nothing_is_written_before_all_is_checked()
    {
        using var memory = new MemoryStream();
        Assert.That(SafeWriter.Write(new SmallPrint().Print(500, 10, 0.2).Build(), Setup, memory).Value, Is.Null);
        Assert.That(memory.Length, Is.Zero);
        Assert.That(SafeWriter.Write(new SmallPrint().Print(50, 10, 0.2).Build(), Setup, memory).Value!.Bytes, Is.EqualTo(memory.Length));
        using var draft = new MemoryStream();
        Assert.That(SafeWriter.Write(new SmallPrint().Print(50, 10, 0.2).Build(), Setup, draft, isDraft: true).Value, Is.Not.Null);
        Assert.That(draft.ToArray(), SameBytes.As(memory.ToArray()), "the same bytes in one pass and in two");
    }

    [Test]
    public void A_stream_that_breaks_breaks_the_writing()
    {
        using var full = new MemoryStream(new byte[64], true);
        Assert.That(() => SafeWriter.Write(new SmallPrint().Print(50, 10, 0.2).Build(), Setup, full, isDraft: true),
            Throws.InstanceOf<NotSupportedException>());
    }

    [Test]
    public void Numbers_that_cannot_be_printed_are_outside_the_bed()
        => Assert.That(SafeWriter.ToDocument(new SmallPrint().Print(1e30, 10, 0.2).Build(), Setup).Diagnostics.Select(d => d.Code),
            Has.Member("bed.outside").And.Member(SafeWriter.Refused));

    [Test]
    public void An_edited_file_is_read_again_and_checked_with_its_own_lines()
    {
        var file = SmallPrint.Written(new SmallPrint(10, 10, 5).Go(10, 10, 0.2).Print(30, 10, 0.2).Print(50, 10, 0.2).Build(), Setup).File;
        var edited = file.Toolpath.Transform(Affine.Move(new Vec3(185, 0)));
        var refused = SafeWriter.ToDocument(file, edited, Setup);
        Assert.That(refused.Value, Is.Null);
        var found = refused.Diagnostics.Single(d => d.Code == "bed.outside");
        Assert.That((found.Count, found.Source!.Line), Is.EqualTo((1, file.Toolpath[file.Toolpath.Count - 1].Source)));
        var written = SafeWriter.ToDocument(file, edited, Setup, "the bed is longer").Value!;
        Assert.That(Encoding.ASCII.GetString(written.ToBytes()), Does.Contain("Reason: the bed is longer").And.Contain("X235"));
    }

    private static (Result<WrittenGCode> Result, string Text) Turtle(string script, string? reason = null)
    {
        var setup = new ProfileLibrary().Setup("generic").OrThrow();
        var turtle = TurtleScript.Compile(script, "art.turtle").OrThrow().Run(new TurtleOptions { Extrusion = setup.Extrusion }).OrThrow();
        var plan = Planner.Plan(turtle.ToSteps(), setup, new PlanOptions { Policy = PlanPolicy.AsDrawn }).OrThrow();
        using var memory = new MemoryStream();
        var result = SafeWriter.Write(plan, setup, memory, reason, isDraft: true);
        return (result, Encoding.ASCII.GetString(memory.ToArray()));
    }

    private static void Extrusion(ToolpathBuilder builder, double x)
    {
        var e = (x - builder.Position.X) * SmallPrint.Area / SmallPrint.FilamentArea;
        builder.Add(new Vec3(x, 60, 0.2), e, e, 30, MoveKind.Print, Role.Unspecified, -1, 0, 0);
    }
}
