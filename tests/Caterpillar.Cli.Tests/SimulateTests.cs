using System.IO;
using System.Linq;
using System.Text;
using System.Text.Json;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

public class SimulateTests : CliFixture
{
    private const string Program = "M83\nG1 X100 F6000\n;LAYER_CHANGE\n;Z:0.3\n;TYPE:Solid infill\nG1 X200 E5\n;LAYER_CHANGE\n;Z:0.6\nG1 Z0.6\nG1 X100 E5\n";

    // Nothing jumps, 1000 mm/s² everywhere: 100 mm at 100 mm/s take 1.1 s each.
    private static readonly string[] Limits =
    [
        "--set", "cornering=jerk", "--set", "jerk_mm_s=0.01,0.01,0.01,0.01", "--set", "print_acceleration_mm_s2=1000",
        "--set", "max_acceleration_mm_s2=1000,1000,1000,100000",
    ];

    [Test]
    public void A_moment_has_many_names()
    {
        File.WriteAllText("a.gcode", Program);
        string[] moments = ["0%", "0.5", "0m0.5s", "line:6", "move:1", "layer:1", "z:0.6", "1h"];
        var run = Run(["simulate", "a.gcode", "--json", .. moments.SelectMany(m => new[] { "--at", m }), .. Limits]);
        Assert.That(run.Code, Is.Zero, run.Messages);
        var states = JsonDocument.Parse(run.Output).RootElement.EnumerateArray().ToArray();
        Assert.That(states.Select(s => s.GetProperty("move").GetInt32()), Is.EqualTo(new[] { 0, 0, 0, 1, 1, 2, 3, 4 }));
        Assert.That(states[1].GetProperty("position_mm")[0].GetDouble(), Is.EqualTo(45).Within(0.01));
        Assert.That(states[1].GetProperty("speed_mm_s").GetDouble(), Is.EqualTo(100).Within(1e-6));
        Assert.That(states[3].GetProperty("role").GetString(), Is.EqualTo("solid_infill"));
        Assert.That(states[3].GetProperty("line").GetInt32(), Is.EqualTo(6));
        Assert.That(states[5].GetProperty("layer").GetInt32(), Is.EqualTo(1));
        Assert.That(states[7].GetProperty("time_left_s").GetDouble(), Is.Zero);
    }

    [Test]
    public void The_text_says_the_same()
    {
        File.WriteAllText("a.gcode", Program);
        var text = Run(["simulate", "a.gcode", "--at", "move:1", .. Limits]).Text;
        Assert.That(text, Does.Contain("Print, Solid infill").And.Contain("100, 0, 0 mm, tool 0").And.Contain("1 of 4").And.Contain("line 6"));
        var plain = Run(Encoding.ASCII.GetBytes("M83\nG1 X100 F6000\nG1 X200 E5\n"), ["simulate", "-", "--at", "move:1", .. Limits]).Text;
        Assert.That(plain, Does.Match("Action +Print *\n"), "A role that nobody knows is not named.");
        Assert.That(Run(["simulate", "a.gcode", "--at", "0.55", .. Limits]).Text, Does.Contain("0 of 4 (50 % done)"));
        Assert.That(Run(["simulate", "a.gcode", "--at", "100%", .. Limits]).Text, Does.Contain("all 4 done").And.Contain("0 s left"));
    }

    [TestCase("line:0")]
    [TestCase("12x")]
    [TestCase("3s2m")]
    [TestCase("120%")]
    [TestCase("")]
    public void What_is_no_moment_is_wrong_usage(string moment)
    {
        File.WriteAllText("a.gcode", Program);
        Assert.That(Run("simulate", "a.gcode", "--at", moment).Code, Is.EqualTo(ExitCode.Usage));
    }

    [TestCase("layer:9")]
    [TestCase("line:99")]
    [TestCase("move:99")]
    [TestCase("z:9")]
    public void A_place_that_the_print_does_not_have_is_bad_input(string moment)
    {
        File.WriteAllText("a.gcode", Program);
        var run = Run("simulate", "a.gcode", "--at", moment);
        Assert.That(run.Code, Is.EqualTo(ExitCode.BadInput));
        Assert.That(run.Messages, Does.Contain(moment).And.Contain("which has 4 moves and layers 0 to 1."));
        Assert.That(Run("simulate", "a.gcode", "--at", "move:4").Code, Is.Zero, "the end");
        Assert.That(Run("simulate", "a.gcode", "--at", "move:5").Code, Is.EqualTo(ExitCode.BadInput));
        File.WriteAllText("a.gcode", "G28\nG1 X10 Y10 Z9.5 F3000\nG1 X20\n");
        Assert.That(Run("simulate", "a.gcode", "--at", "layer:9").Messages, Does.Contain("moves and no layers."));
    }

    [Test]
    public void Statistics_are_tables_with_a_histogram_or_JSON()
    {
        File.WriteAllText("a.gcode", Program);
        var text = Run(["decode", "a.gcode", "--stats", "--set", "cost_per_kg=20", .. Limits]).Text;
        Assert.That(text, Does.Contain("Printing").And.Contain("Solid infill").And.Contain("2 layers of").And.Contain("█"));
        Assert.That(text, Does.Contain("10 mm of filament").And.Contain("costs"));
        var run = Run(["decode", "a.gcode", "--stats", "--json", "--filament-diameter", "1.75", .. Limits]);
        var s = JsonDocument.Parse(run.Output).RootElement[0];
        Assert.That(s.GetProperty("file").GetString(), Is.EqualTo("a.gcode"));
        Assert.That(s.GetProperty("print_time_s").GetDouble(), Is.EqualTo(2.2).Within(0.001));
        Assert.That(s.GetProperty("print_length_mm").GetDouble(), Is.EqualTo(200));
        Assert.That(s.GetProperty("volume_mm3").GetDouble(), Is.EqualTo(24.052819).Within(1e-6));
        Assert.That(s.GetProperty("layers").GetArrayLength(), Is.EqualTo(2));
        Assert.That(s.GetProperty("cost").ValueKind, Is.EqualTo(JsonValueKind.Null));
    }

    [Test]
    public void A_file_without_amounts_of_E_has_no_material_and_no_flow()
    {
        File.WriteAllText("a.gcode", ";FLAVOR:BFB\n;LAYER:0\n;TYPE:FILL\nG1 X10 Y10 Z0.3 F3000\nM101\nG1 X60\nM103\nG1 X70\n");
        var text = Run("decode", "a.gcode", "--stats").Text;
        Assert.That(text, Does.Contain("50 mm in 1 move, 1 layer").And.Contain("no E").And.Match("Material +none"));
        Assert.That(text, Does.Not.Contain("mm wide").And.Not.Contain("Maximum flow"));
        var s = JsonDocument.Parse(Run("decode", "a.gcode", "--stats", "--json").Output).RootElement[0];
        Assert.That(s.GetProperty("peak_flow_mm3_s").ValueKind, Is.EqualTo(JsonValueKind.Null));
        Assert.That(s.GetProperty("peak_flow_move").ValueKind, Is.EqualTo(JsonValueKind.Null));
    }

    [Test]
    public void Amounts_of_E_have_their_unit()
    {
        File.WriteAllText("a.gcode", "; gcode_flavor = smoothie\nM200 D1.75\nM83\nG1 X10 Y10 Z0.3 F3000\nG1 X60 E12\n");
        Assert.That(Run("decode", "a.gcode").Text, Does.Contain("12 mm³ of E, net 12 mm³"));
        File.WriteAllText("a.gcode", "M83\nG1 X10 Y10 Z0.3 F3000\nG1 X60 E12\nG1 E-1\n");
        Assert.That(Run("decode", "a.gcode").Text, Does.Contain("12 mm of E, net 11 mm").And.Contain("1 retraction").And.Not.Contain("retractions"));
    }

    [Test]
    public void Limits_are_those_of_the_slicer_in_the_file_unless_a_printer_is_named()
    {
        var axes = "xyze".Select(a => $"; machine_max_feedrate_{a} = 50,20\n; machine_max_acceleration_{a} = 400,200\n; machine_max_jerk_{a} = 5\n");
        var settings = string.Concat(axes);
        File.WriteAllText("a.gcode", "; generated by PrusaSlicer 2.5.0\n" + Program + settings + "; machine_max_acceleration_extruding = 300,100\n");
        Assert.That(Run("decode", "a.gcode", "--stats").Text, Does.Contain("the slicer's settings").And.Contain("50 mm/s"));
        Assert.That(Run("decode", "a.gcode", "--stats", "-p", "generic").Text, Does.Contain("printer generic").And.Contain("100 mm/s"));
    }
}
