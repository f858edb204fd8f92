using System.IO;
using System.Text;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

public class CheckTests : CliFixture
{
    [Test]
    public void What_was_written_for_a_printer_passes_its_check()
    {
        File.WriteAllText("part.stl", Box(20, 10, 2));
        foreach (var printer in new[] { "generic", "ender3", "prusa_mk3s", "klipper_256", "rrf_delta", "potter_super", "lutum", "wasp_2040_clay",
            "pen_plotter" })
        {
            Assert.That(Run("slice", "part.stl", "-p", printer).Code, Is.Zero, printer);
            var check = Run("check", "part.gcode", "-p", printer);
            Assert.That(check.Code, Is.Zero, printer + ": " + check.Text + check.Messages);
            Assert.That(check.Text, Does.Not.Contain("error"), printer);
        }
    }

    [Test]
    public void Findings_name_file_and_line_and_refuse()
    {
        File.WriteAllText("a.gcode", "G28\nM109 S200\nG90\nM83\nG1 X10 Y10 Z0.2 F3000\nG1 X300 Y10 E1\n");
        var run = Run("check", "a.gcode", "--printer", "generic");
        Assert.That(run.Code, Is.EqualTo(3));
        Assert.That(run.Text, Does.Contain("a.gcode:6").And.Contain("error bed.outside"));
        Assert.That(Run(Encoding.ASCII.GetBytes("G28\nG1 X300\n"), ["check", "-"]).Text, Does.Contain("standard input:2"));
    }

    [Test]
    public void Without_a_printer_a_file_is_checked_for_the_setup_that_it_states()
    {
        File.WriteAllText("part.stl", Box(20, 10, 2));
        Assert.That(Run("slice", "part.stl", "-p", "klipper_256", "--center", "230,230").Code, Is.Zero);
        var own = Run("check", "part.gcode");
        Assert.That((own.Code, own.Text), Is.EqualTo((0, "")), own.Text);
        Assert.That(own.Messages, Does.Contain("Nothing found. Checked for klipper_256, the printer of the setup in the file."));
        var smaller = Run("check", "part.gcode", "--set", "build_volume_mm=[200, 200, 200]");
        Assert.That(smaller.Text, Does.Contain("error bed.outside").And.Contain("(200, 200, 200)"));
        Assert.That(smaller.Messages, Does.Contain("Checked for klipper_256").And.Not.Contain("Nothing found"));
        Assert.That(Run("check", "part.gcode", "--printer", "generic").Text, Does.Contain("bed.outside").And.Contain("(220, 220, 250)"));
    }

    [Test]
    public void A_file_that_heats_too_late_extrudes_cold()
    {
        File.WriteAllText("a.gcode", "G28\nM83\nG1 X10 Y10 Z0.2 F600\nG1 X20 E1\nM109 S200\nG1 X30 E1\n");
        Assert.That(Run("check", "a.gcode").Text, Does.Contain("a.gcode:4").And.Contain("limit.cold_extrusion"));
        File.WriteAllText("a.gcode", "START_PRINT\nG28\nM83\nG1 X10 Y10 Z0.2 F600\nG1 X20 E1\n");
        Assert.That(Run("check", "a.gcode").Code, Is.Zero);
    }

    [Test]
    public void A_missing_file_is_bad_input() => Assert.That(Run("check", "none.gcode").Code, Is.EqualTo(1));
}
