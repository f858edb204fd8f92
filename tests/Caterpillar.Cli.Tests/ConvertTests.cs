using System.IO;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

public class ConvertTests : CliFixture
{
    private const string File1 = "; head\nG21\nG90\nM82\nG92 E0\n;LAYER:0\nG1 X0 Y0 Z0.2 F1800\nG1 X10 E1\n;LAYER:1\nG1 Z0.4\nG1 X0 E2 ; back\n";

    [TestCase("--speed", "70")]
    [TestCase("--flow", "95")]
    public void A_factor_that_is_meant_as_a_percentage_is_refused(string option, string value)
    {
        File.WriteAllText("a.gcode", File1);
        var run = Run("convert", "a.gcode", "-o", "b.gcode", option, value);
        Assert.That(run.Code, Is.EqualTo(2));
        Assert.That(run.Messages, Does.Contain($"{option} needs a factor up to 10, or a percentage such as 70%."));
    }

    [Test]
    public void Without_options_the_file_stays_as_it_is()
    {
        File.WriteAllText("a.gcode", File1);
        Assert.That(Run("convert", "a.gcode", "-o", "b.gcode").Code, Is.Zero);
        Assert.That(File.ReadAllText("b.gcode"), Is.EqualTo(File1));
    }

    [Test]
    public void A_scale_may_be_a_percentage()
    {
        File.WriteAllText("a.gcode", File1);
        Assert.That(Run("convert", "a.gcode", "-o", "-", "--scale", "200%").Text, Is.EqualTo(Run("convert", "a.gcode", "-o", "-", "--scale", "2").Text));
    }

    [Test]
    public void Absolute_E_becomes_relative()
    {
        File.WriteAllText("a.gcode", File1);
        Assert.That(Run("convert", "a.gcode", "-o", "-", "--e-mode", "relative").Text, Is.EqualTo(
            File1.Replace("M82\n", "").Replace("G1 X10 E1", "M83\nG1 X10 E1").Replace("G1 X0 E2", "G1 X0 E1")));
    }

    [Test]
    public void Decimals_are_limited()
    {
        File.WriteAllText("a.gcode", File1.Replace("X10 E1", "X10.1234 E1.00006"));
        Assert.That(Run("convert", "a.gcode", "-o", "-", "--decimals", "2,4").Text, Is.EqualTo(File1.Replace("X10 E1", "X10.12 E1.0001")));
    }

    [Test]
    public void A_layer_is_printed_slower_and_a_pause_put_before_it()
    {
        File.WriteAllText("a.gcode", File1);
        Assert.That(Run("convert", "a.gcode", "-o", "-", "--speed", "0.5", "--first-layer", "1", "--pause-at-layer", "1", "--plain-pause").Text, Is.EqualTo(
            File1.Replace("G1 Z0.4", "M0\nG1 Z0.4").Replace("G1 X0 E2 ;", "G1 X0 E2 F900 ;")));
    }

    [Test]
    public void Circles_become_arcs()
    {
        using (var text = new StreamWriter("a.gcode") { NewLine = "\n" })
        {
            text.Write("G21\nG90\nM83\nG1 X10 Y0 Z0.2 F1800\n");
            for (var i = 1; i <= 60; i++)
            {
                var (sin, cos) = Caterpillar.Basics.Angle.SinCos(6 * i);
                text.WriteLine($"G1 X{Number(10 * cos)} Y{Number(10 * sin)} E0.05");
            }
        }
        var run = Run("convert", "a.gcode", "-o", "-", "--arcs", "fit");
        Assert.That(run.Text, Does.Contain("G3 "));
        Assert.That(run.Text.Split('\n').Length, Is.LessThan(12));
        File.WriteAllText("b.gcode", run.Text);
        Assert.That(Run("decode", "b.gcode", "--json").Text, Does.Contain("\"e_used\": 3,"));
    }

    [Test]
    public void Layers_move_turn_and_scale_and_the_start_code_stays()
    {
        const string Square = "G21\nG90\nM83\nG1 X0 Y-3 E5 F600\n;LAYER:0\nG0 X10 Y10 Z0.2 F6000\nG1 X30 E2 F1200\nG1 Y20 E1\n;LAYER:1\nG0 X10 Y10 Z0.4 "
            + "F6000\nG1 X30 E2 F1200\nG1 Y20 E1\n";
        File.WriteAllText("a.gcode", Square);
        Assert.That(Run("convert", "a.gcode", "-o", "-", "--move", "1,2,0.1").Text, Is.EqualTo(
            Square.Replace("X10 Y10 Z0.2", "X11 Y12 Z0.3").Replace("X10 Y10 Z0.4", "X11 Y12 Z0.5").Replace("X30", "X31").Replace("Y20", "Y22")));
        Assert.That(Run("convert", "a.gcode", "-o", "-", "--scale", "2").Text, Is.EqualTo(
            Square.Replace("X10 Y10 Z0.2", "X0 Y5 Z0.4").Replace("X10 Y10 Z0.4", "X0 Y5 Z0.8").Replace("X30 E2", "X40 E16").Replace("Y20 E1", "Y25 E8")));
        Assert.That(Run("convert", "a.gcode", "-o", "-", "--rotate", "180", "--last-layer", "0").Text, Is.EqualTo(
            Square.Replace("X10 Y10 Z0.2 F6000\nG1 X30 E2 F1200\nG1 Y20 E1", "X30 Y20 Z0.2 F6000\nG1 X10 E2 F1200\nG1 Y10 E1")));
    }

    [Test]
    public void Formulas_deform_what_is_printed()
    {
        File.WriteAllText("a.gcode", File1);
        var text = Run("convert", "a.gcode", "-o", "-", "--deform", "x, y, z + x * x / 100", "--last-layer", "0").Text;
        Assert.That(text, Does.Contain("G1 X5 Z0.45 E0.50078\n").And.Contain("G1 X10 Z1.2 E1.00653\n"), "0.1 mm of E per mm of the parabola");
        Assert.That(text, Does.EndWith("G1 Z0.4\nG92 E1\nG1 X0 E2 ; back\n"), "later values are adjusted");
    }

    [Test]
    public void Tools_and_lines_are_put_before_layers()
    {
        File.WriteAllText("a.gcode", File1);
        Assert.That(Run("convert", "a.gcode", "-o", "-", "--gcode-at-layer", "0=M104 S210").Text, Is.EqualTo(
            File1.Replace("G1 X0 Y0 Z0.2", "M104 S210\nG1 X0 Y0 Z0.2")));
        Assert.That(Run("convert", "a.gcode", "-o", "b.gcode", "--tool-at-layer", "1=1").Messages, Does.Contain("limit.tool").And.Contain("--printer"));
        File.WriteAllText("two.gcode", "T1\nT0\n" + File1);
        Assert.That(Run("convert", "two.gcode", "-o", "-", "--tool-at-layer", "1=1").Text, Is.EqualTo("T1\nT0\n" + File1.Replace("G1 Z0.4", "T1\nG1 Z0.4")));
        Assert.That(Run("convert", "a.gcode", "-o", "b.gcode", "--pause-at-layer", "7").Code, Is.EqualTo(2));
    }

    [Test]
    public void Start_and_end_code_are_replaced()
    {
        File.WriteAllText("a.gcode", File1 + "M104 S0\n");
        File.WriteAllText("start.gcode", "; mine\nG28\nM83\n");
        File.WriteAllText("end.gcode", "M84\n");
        var text = Run("convert", "a.gcode", "-o", "-", "--start-gcode", "start.gcode", "--end-gcode", "end.gcode").Text;
        Assert.That(text, Does.StartWith("; mine\nG28\n").And.EndWith("G1 X0 E2 ; back\nM84\n").And.Not.Contain("head"));
    }

    private static string Print(double height) => "G21\nG90\nM83\nG28\n;LAYER:0\nG1 X50 Y50 Z" + Number(height) + " F1800\nG1 X70 E0.75\nG1 Y70 E0.75\n";

    [TestCase("--move", "0,0,-0.2", "nozzle.too_low")]
    [TestCase("--move", "0,0,5", "first_layer.in_air")]
    [TestCase("--deform", "x, y, z - 0.2", "nozzle.too_low")]
    [TestCase("--scale", "1,1,10", "first_layer.in_air")]
    public void A_moved_print_must_fit_on_the_bed_of_any_printer(string option, string value, string code)
    {
        File.WriteAllText("a.gcode", Print(0.2));
        var run = Run("convert", "a.gcode", "-o", "b.gcode", option, value);
        Assert.That((run.Code, File.Exists("b.gcode")), Is.EqualTo((3, false)));
        Assert.That(run.Messages, Does.Contain("a.gcode:7, move 1: error " + code).And.Contain("write.refused"));
        run = Run("convert", "a.gcode", "-o", "b.gcode", option, value, "--override", "onto a plate");
        Assert.That(run.Code, Is.Zero);
        Assert.That(run.Messages, Does.Contain("warning " + code));
        Assert.That(File.ReadAllText("b.gcode"), Does.Contain("\n; Written despite these findings. Reason: onto a plate\n").And.Contain(code));
        // The same is found in the input: nothing gets worse.
        var before = code == "first_layer.in_air" ? 5.2 : 0;
        File.WriteAllText("a.gcode", Print(before));
        Assert.That(Run("convert", "a.gcode", "-o", "b.gcode", "--move", "1,0,0").Code, Is.Zero);
    }

    [TestCase("--move", "5,5,0")]
    [TestCase("--rotate", "30")]
    [TestCase("--scale", "1,1,0.4")]
    [TestCase("--deform", "x, y + 1, z")]
    public void Moves_that_keep_a_print_on_the_bed_are_not_refused(string option, string value)
    {
        File.WriteAllText("a.gcode", Print(0.2) + ";LAYER:1\nG1 Z0.4\nG1 Y50 E0.75\n");
        var run = Run("convert", "a.gcode", "-o", "b.gcode", option, value);
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(run.Messages, Does.Not.Contain("nozzle.").And.Not.Contain("first_layer."));
    }

    [Test]
    public void A_moved_print_stays_on_the_bed_of_the_printer_that_the_file_names()
    {
        File.WriteAllText("box.stl", Box(20, 10, 2));
        Assert.That(Run("slice", "box.stl", "-o", "a.gcode").Code, Is.Zero);
        var refused = Run("convert", "a.gcode", "-o", "b.gcode", "--move", "0,200");
        Assert.That((refused.Code, File.Exists("b.gcode")), Is.EqualTo((3, false)));
        Assert.That(refused.Messages, Does.Contain("error bed.outside: A move goes to").And.Contain("outside the build volume of generic"));
        Assert.That(Run("convert", "a.gcode", "-o", "b.gcode", "--move", "0,50").Code, Is.Zero);
        Assert.That(Run("convert", "a.gcode", "-o", "b.gcode", "--move", "0,200", "--override", "a larger bed").Code, Is.Zero);
    }

    [Test]
    public void A_named_printer_checks_what_is_written()
    {
        File.WriteAllText("a.gcode", File1);
        Assert.That(Run("convert", "a.gcode", "-o", "b.gcode", "--move", "500,0").Code, Is.Zero, "no printer, no check");
        File.Delete("b.gcode");
        var refused = Run("convert", "a.gcode", "-o", "b.gcode", "--move", "500,0", "--printer", "generic");
        Assert.That(refused.Code, Is.EqualTo(3));
        Assert.That(File.Exists("b.gcode"), Is.False);
        Assert.That(Run("convert", "a.gcode", "-o", "b.gcode", "--move", "500,0", "--printer", "generic", "--override", "a longer bed").Code, Is.Zero);
        Assert.That(File.ReadAllText("b.gcode"), Does.Contain("Reason: a longer bed"));
        Assert.That(Run("convert", "a.gcode", "-o", "c.gcode", "--override", "why").Code, Is.EqualTo(2));
    }

    [TestCase("--speed", "-1")]
    [TestCase("--scale", "0")]
    [TestCase("--box", "1,2,3")]
    [TestCase("--object", "nobody")]
    [TestCase("--deform", "x, y")]
    [TestCase("--axis", "center")]
    [TestCase("--tool-at-layer", "1")]
    [TestCase("--role", "Nose")]
    [TestCase("--move", "a,b")]
    [TestCase("--flavor", "basic")]
    [TestCase("--remove", "--mm")]
    [TestCase("--e-mode", "sideways")]
    [TestCase("--decimals", "3,x")]
    [TestCase("--decimals", "1,2,3,4")]
    public void Wrong_options_are_wrong_usage(string option, string value)
    {
        File.WriteAllText("a.gcode", File1);
        Assert.That(Run("convert", "a.gcode", "-o", "b.gcode", option, value).Code, Is.EqualTo(2));
        Assert.That(File.Exists("b.gcode"), Is.False);
    }

    private static string Number(double value) => Caterpillar.Basics.NumberFormatter.Format(value, 3);
}
