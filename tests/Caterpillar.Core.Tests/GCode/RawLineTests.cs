using System.Linq;
using System.Text;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>After raw lines and templates what follows does what it would have done without them.</summary>
public class RawLineTests
{
    private static readonly string[] Extrusions = ["G1 X30 E1", "G1 X40 E1"];

    [TestCase("; hello")]
    [TestCase("M117 G91 X5")]
    [TestCase("M106 S100")]
    [TestCase("M104 S200 ; G91")]
    [TestCase("G4 P100")]
    [TestCase("not a command of this firmware")]
    public void A_harmless_line_adds_nothing(string raw)
        => Assert.That(After(raw, new GCodeFormat(NewFile.Machine)), Is.EqualTo(Extrusions));

    [TestCase("G91", "G90|M83|G1 X30 E1|G1 X40 E1")]
    [TestCase("M82", "G90|M83|G1 X30 E1|G1 X40 E1")]
    [TestCase("G0 X0 Y0", "G0 X20 Y0 Z0.2 F6000|G1 X30 E1 F1200|G1 X40 E1")]
    [TestCase("G1 E-5", "G90|M83|G0 X20 Y0 Z0.2 F6000|G1 X30 E1 F1200|G1 X40 E1")]
    [TestCase("G20", "G21|G0 X20 Y0 Z0.2 F6000|G1 X30 E1 F1200|G1 X40 E1")]
    [TestCase("G18", "G17|G1 X30 E1|G1 X40 E1")]
    [TestCase("T1", "T0|G0 X20 Y0 Z0.2 F6000|G1 X30 E1 F1200|G1 X40 E1")]
    [TestCase("T0", "G0 X20 Y0 Z0.2 F6000|G1 X30 E1 F1200|G1 X40 E1")]
    public void The_state_that_a_line_may_change_is_stated_again(string raw, string expected)
        => Assert.That(string.Join("|", After(raw, new GCodeFormat(NewFile.Machine))), Is.EqualTo(expected));

    [TestCase("SET_FAN_SPEED FAN=a SPEED=1", "G1 X30 E1|G1 X40 E1")]
    [TestCase("PARK", "G17|G90|M83|G0 X20 Y0 Z0.2 F6000|G1 X30 E1 F1200|G1 X40 E1")]
    public void A_macro_of_Klipper_may_do_anything(string raw, string expected)
        => Assert.That(string.Join("|", After(raw, new GCodeFormat(NewFile.Machine with { Flavor = FlavorTable.Klipper }))).Replace("G21|", ""),
            Is.EqualTo(expected));

    [TestCase("G91\nG1 Z5\nG90")]
    [TestCase("G20\nG1 X1")]
    [TestCase("G92 E7")]
    [TestCase("M83\nG1 X3 E9 F77")]
    [TestCase("G28")]
    [TestCase("T1\nM82")]
    [TestCase("M117 hello")]
    public void Whatever_it_is_the_extrusions_are_the_same(string raw)
    {
        foreach (var relative in new[] { true, false })
        {
            var plain = Decode(Path(null), new GCodeFormat(NewFile.Machine with { ExtrusionMode = NewFile.Mode(relative) }));
            var mixed = Decode(Path(raw), new GCodeFormat(NewFile.Machine with { ExtrusionMode = NewFile.Mode(relative) }));
            (Vec3, Vec3, double, int)[] Printed(Toolpath t) => t.Moves().Where(m => m.Kind == MoveKind.Print && m.Role == Role.OuterWall)
                .Select(m => (m.Start, m.End, System.Math.Round(m.E, 6), m.Tool)).ToArray();
            // What the raw line itself extrudes is the only addition.
            Assert.That(Printed(mixed).Where(m => m.Item1.X >= 10 && m.Item3 == 1), Is.EqualTo(Printed(plain)), raw);
        }
    }

    [Test]
    public void After_start_code_in_inches_and_with_another_tool_the_print_is_in_mm_with_its_own()
    {
        var text = Encoding.ASCII.GetString(NewFile.Of(Path(null), new GCodeFormat(NewFile.Machine) { Start = ["G20", "T1"] }));
        Assert.That(text, Does.Contain("T1\nG21\nG90\nM83\nT0\n"));
    }

    [Test]
    public void Lines_of_layers_follow_the_same_rules()
    {
        var format = new GCodeFormat(NewFile.Machine) { LayerLines = _ => ["G91", "G1 Z1", "G90", "M117 layer"] };
        var text = NewFile.Plain(Path(null), format);
        Assert.That(text, Does.EndWith("M117 layer\nG90\nM83\nG0 X20 Y0 Z0.2 F6000\nG1 X30 E1 F1200\nG1 X40 E1\n"));
    }

    private static string[] After(string raw, GCodeFormat format)
    {
        var text = Encoding.ASCII.GetString(NewFile.Of(Path(raw), format));
        var lines = text.Substring(text.IndexOf(raw, System.StringComparison.Ordinal) + raw.Length).Trim().Split('\n');
        return lines.Where(l => l[0] != ';').ToArray();
    }

    private static Toolpath Decode(Toolpath toolpath, GCodeFormat format)
        => GCodeDecoder.Decode(NewFile.Of(toolpath, format), new DecodeOptions { Flavor = format.Flavor }).Value!.Toolpath;

    private static Toolpath Path(string? raw)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        var first = builder.AddLayer(new Layer(0, 0.2, 0.2));
        var second = builder.AddLayer(new Layer(1, 0.2, 0.2));
        builder.Add(new Vec3(10, 0, 0.2), 0, 0, 100, MoveKind.Travel, Role.Unspecified, first, 0, 0);
        builder.Add(new Vec3(20, 0, 0.2), 1, 1, 20, MoveKind.Print, Role.OuterWall, first, 0, 0);
        if (raw is not null) builder.AddEvent(new RawEvent(raw));
        builder.Add(new Vec3(30, 0, 0.2), 1, 1, 20, MoveKind.Print, Role.OuterWall, raw is null ? second : first, 0, 0);
        builder.Add(new Vec3(40, 0, 0.2), 1, 1, 20, MoveKind.Print, Role.OuterWall, raw is null ? second : first, 0, 0);
        return builder.Build([new ToolpathTool(2.4)]);
    }
}
