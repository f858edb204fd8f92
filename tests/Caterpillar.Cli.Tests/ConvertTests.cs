using System.IO;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

public class ConvertTests : CliFixture
{
    private const string File1 = "; head\nG21\nG90\nM82\nG92 E0\n;LAYER:0\nG1 X0 Y0 Z0.2 F1800\nG1 X10 E1\n;LAYER:1\nG1 Z0.4\nG1 X0 E2 ; back\n";

    [Test]
    public void Without_wishes_the_file_stays_as_it_is()
    {
        File.WriteAllText("a.gcode", File1);
        Assert.That(Run("convert", "a.gcode", "-o", "b.gcode").Code, Is.Zero);
        Assert.That(File.ReadAllText("b.gcode"), Is.EqualTo(File1));
    }

    [Test]
    public void Absolute_E_becomes_relative()
    {
        File.WriteAllText("a.gcode", File1);
        Assert.That(Run("convert", "a.gcode", "-o", "-", "--e", "relative").Text, Is.EqualTo(
            File1.Replace("M82\n", "").Replace("G1 X10 E1", "M83\nG1 X10 E1").Replace("G1 X0 E2", "G1 X0 E1")));
    }

    [Test]
    public void A_layer_is_printed_slower_and_a_pause_put_before_it()
    {
        File.WriteAllText("a.gcode", File1);
        Assert.That(Run("convert", "a.gcode", "-o", "-", "--speed", "0.5", "--first-layer", "1", "--pause-at-layer", "1").Text, Is.EqualTo(
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

    [TestCase("--speed", "-1")]
    [TestCase("--role", "Nose")]
    [TestCase("--move", "a,b")]
    [TestCase("--dialect", "basic")]
    [TestCase("--remove", "--mm")]
    [TestCase("--e", "sideways")]
    public void Wrong_wishes_are_wrong_usage(string option, string value)
    {
        File.WriteAllText("a.gcode", File1);
        Assert.That(Run("convert", "a.gcode", "-o", "b.gcode", option, value).Code, Is.EqualTo(2));
        Assert.That(File.Exists("b.gcode"), Is.False);
    }

    private static string Number(double value) => Caterpillar.Basics.NumberFormatter.Format(value, 3);
}
