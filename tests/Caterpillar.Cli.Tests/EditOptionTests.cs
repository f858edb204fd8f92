using System.IO;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

/// <summary>Options of convert that make no sense are wrong usage; those that select nothing say so.</summary>
public class EditOptionTests : CliFixture
{
    private const string Program =
        "G90\nM83\n;LAYER_CHANGE\n;Z:0.2\n;TYPE:External perimeter\nG1 X10 Y10 Z0.2 F3000\nG1 X20 E1 F1200\n;LAYER_CHANGE\n;Z:0.4\nG1 Z0.4\nG1 X10 E1\n";

    [SetUp]
    public void WriteInput() => File.WriteAllText("l.gcode", Program);

    [TestCase("--first-layer", "10", "--last-layer", "2")]
    [TestCase("--move", "1e12,0")]
    [TestCase("--filament-diameter", "-1")]
    [TestCase("--filament-diameter", "0")]
    [TestCase("--retraction", "-5")]
    [TestCase("--deform", "")]
    [TestCase("--deform", "  ")]
    [TestCase("--gcode-at-layer", "1=M117 a\nG1 X500")]
    [TestCase("--gcode-at-layer", "1=")]
    [TestCase("--tool", "-1")]
    [TestCase("--speed", "-50%")]
    [TestCase("--speed", "fast")]
    [TestCase("--start-gcode", "")]
    public void What_makes_no_sense_is_wrong_usage(params string[] options)
    {
        var run = Run(["convert", "l.gcode", "-o", "m.gcode", .. options]);
        Assert.That(run.Code, Is.EqualTo(2), run.Messages);
        Assert.That(run.Messages, Does.Contain(options[0]).And.Length.LessThan(400));
        Assert.That(File.Exists("m.gcode"), Is.False);
    }

    [TestCase("--first-layer", "500")]
    [TestCase("--role", "Ironing")]
    [TestCase("--box", "100,100,0,110,110,10")]
    [TestCase("--tool", "3")]
    public void What_selects_nothing_is_a_warning(string option, string value)
    {
        var run = Run("convert", "l.gcode", "-o", "m.gcode", "--flow", "2", option, value);
        Assert.That(run.Code, Is.Zero);
        Assert.That(run.Messages, Does.Contain("warning edit.nothing_selected"));
        Assert.That(File.ReadAllText("m.gcode"), Is.EqualTo(Program));
    }

    [Test]
    public void The_first_tool_has_the_number_0()
    {
        var run = Run("convert", "l.gcode", "-o", "m.gcode", "--flow", "2", "--tool", "0");
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(File.ReadAllText("m.gcode"), Is.EqualTo(Program.Replace("E1", "E2")));
    }

    [Test]
    public void A_missing_layer_hides_no_other_problem()
    {
        var run = Run("convert", "l.gcode", "-o", "m.gcode", "--flow", "2", "--role", "Ironing", "--gcode-at-layer", "99=M300");
        Assert.That(run.Code, Is.EqualTo(2));
        Assert.That(run.Messages, Does.Contain("warning edit.nothing_selected").And.Contain("Layer 99 not found."));
    }

    [TestCase("0.5")]
    [TestCase("50%")]
    [TestCase(" 50 %")]
    public void Speed_is_a_factor_or_a_percentage(string speed)
    {
        Assert.That(Run("convert", "l.gcode", "-o", "m.gcode", "--speed", speed).Code, Is.Zero);
        Assert.That(File.ReadAllText("m.gcode"), Does.Contain("G1 X20 E1 F600\n").And.Not.Contain("E1 F1200"));
    }

    [Test]
    public void The_halves_of_a_print_share_its_layers()
    {
        Assert.That(Run("convert", "l.gcode", "-o", "lower.gcode", "--keep-below", "0.2").Code, Is.Zero);
        Assert.That(File.ReadAllText("lower.gcode"), Does.Contain("G1 X20 E1 F1200\n").And.Not.Contain("G1 X10 E1\n"));
        File.WriteAllText("start.txt", "G28 X Y\nM109 S200\n");
        var upper = Run("convert", "l.gcode", "-o", "upper.gcode", "--keep-above", "0.2", "--start-gcode", "start.txt");
        Assert.That(upper.Code, Is.Zero, upper.Messages);
        Assert.That(File.ReadAllText("upper.gcode"), Does.Contain("G1 X10 E1").And.Not.Contain("G1 X20 E1"));
    }

    [Test]
    public void What_is_selected_is_no_warning()
        => Assert.That(Run("convert", "l.gcode", "-o", "m.gcode", "--flow", "2", "--first-layer", "1").Messages, Does.Not.Contain("nothing_selected"));

    [Test]
    public void A_formula_that_throws_points_far_away_is_an_error()
    {
        var run = Run("convert", "l.gcode", "-o", "m.gcode", "--deform", "x*1e300,y,z");
        Assert.That((run.Code, File.Exists("m.gcode")), Is.EqualTo((1, false)), run.Messages);
        Assert.That(run.Messages, Does.Contain("kilometer"));
    }

    [TestCase("OuterWall")]
    [TestCase("outer wall")]
    [TestCase("outer-wall")]
    public void A_role_has_the_name_that_is_shown_too(string role)
    {
        Assert.That(Run("convert", "l.gcode", "-o", "m.gcode", "--speed", "0.5", "--role", role).Code, Is.Zero);
        Assert.That(File.ReadAllText("m.gcode"), Does.Contain("G1 X20 E1 F600\n"));
    }
}
