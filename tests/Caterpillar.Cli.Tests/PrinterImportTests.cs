using System;
using System.IO;
using System.Linq;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

public class PrinterImportTests : CliFixture
{
    private const string Header = "G90\nM83\nM190 S60\nM109 S205\nG28\nG1 X0.1 Y200 F1500 E15\nF300 E3\nG1 X100 Y100 Z0.1\nG91\n";

    [Test]
    public void A_header_and_a_footer_become_a_printer_that_prints()
    {
        File.WriteAllText("start.gcode", Header);
        File.WriteAllText("end.gcode", "G1 E-3\nM104 S0\nG1 Z100 F5000\nM84\n");
        var run = Run("printers", "--import", "start.gcode", "end.gcode", "-o", "mine.json");
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(run.Messages, Does.Contain("start.gcode:7:1: warning header.no_command").And.Contain("X 100, Y 100, Z 0.1 mm"));
        File.WriteAllText("line.csv", "60,60,0.2\n140,60,0.2\n");
        var print = Run("curves", "line.csv", "--printer", "mine.json");
        Assert.That(print.Code, Is.Zero, print.Messages);
        var lines = File.ReadAllLines("line.gcode");
        Assert.That(lines, Does.Contain("M109 S205").And.Contain("; invalid: F300 E3").And.Contain("G91 ; as set by the header")
            .And.Contain("G1 Z100 F5000"));
    }

    [Test]
    public void Of_a_whole_print_only_the_start_and_the_end_are_taken_and_its_flavor()
    {
        File.WriteAllText("part.stl", Box(20, 10, 3));
        Assert.That(Run("slice", "part.stl", "--printer", "klipper_256", "-o", "part.gcode").Code, Is.Zero);
        var run = Run("printers", "--import", "part.gcode", "-", "-o", "mine.json");
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(run.Messages, Does.Contain("mine.json: mine, Klipper"));
        var profile = File.ReadAllText("mine.json");
        var whole = File.ReadAllLines("part.gcode");
        Assert.That(profile.Length, Is.LessThan(6000));
        Assert.That(profile, Does.Contain("G28").And.Contain("M104 S0").And.Not.Contain("LAYER_CHANGE").And.Not.Contain("M73"));
        Assert.That(Run("slice", "part.stl", "--printer", "mine.json", "-o", "again.gcode").Code, Is.Zero);
        string[] Prints(string[] lines) => lines.Where(l => l.StartsWith("G1 X", StringComparison.Ordinal) && l.Contains(" E")).ToArray();
        // The bed of the profile is smaller, so the part is elsewhere.
        Assert.That(Prints(File.ReadAllLines("again.gcode")), Has.Length.EqualTo(Prints(whole).Length));
        Assert.That(File.ReadAllLines("again.gcode"), Does.Contain("G1 Y120 E8.31503 F1200 ; prime"));
    }

    [Test]
    public void A_similar_printer_gives_what_the_files_do_not_state()
    {
        File.WriteAllText("start.gcode", "G28\nM83\n");
        var run = Run("printers", "--import", "start.gcode", "-", "--base", "potter_super");
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(run.Text, Does.Contain("\"nozzle_diameter_mm\": 3").And.Contain("\"title\": \"start\""));
    }

    [Test]
    public void Settings_of_another_slicer_become_a_folder_that_prints()
    {
        File.WriteAllText("old.ini", "printer_settings_id = Old One\nprint_settings_id = Fine\nfilament_settings_id = Silver\n"
            + "bed_shape = 0x0,180x0,180x180,0x180\nmax_print_height = 170\ngcode_flavor = marlin2\n"
            + "start_gcode = G28\\nG29\\nMAGIC ON\\nG1 X{unknown}\nlayer_height = 0.3\nperimeters = 3\n"
            + "machine_max_feedrate_x = 200\nmachine_max_feedrate_y = 200\nmachine_max_feedrate_z = 12\n"
            + "machine_max_feedrate_e = 60\nsupport_material_angle = 30\n");
        Assert.That(Run("printers", "--import", "old.ini").Text, Does.Contain("\"title\": \"Old One\""), "the printer alone");
        var run = Run("printers", "--import", "old.ini", "-o", "mine");
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(run.Messages, Does.Contain("import.macro").And.Contain("MAGIC").And.Contain("start_gcode line 4").And.Contain("support_material_angle=30"));
        Assert.That(File.Exists("mine/old_one.json") && File.Exists("mine/materials/silver.json") && File.Exists("mine/settings/fine.json"));
        File.WriteAllText("part.stl", Box(20, 10, 3));
        var slice = Run("slice", "part.stl", "--printer", "mine/old_one.json", "--set", "macros=MAGIC=harmless", "-o", "part.gcode");
        Assert.That(slice.Code, Is.Zero, slice.Messages);
        Assert.That(File.ReadAllLines("part.gcode"), Does.Contain("MAGIC ON").And.Contain("; G1 X{unknown}"));
        Assert.That(Run("printers", "Old Two", "--import", "old.ini", "-o", "mine").Code, Is.EqualTo(1));
    }

    [Test]
    public void Wrong_options_and_missing_files_have_their_codes()
    {
        File.WriteAllText("start.gcode", "G20\n");
        Assert.That(Run("printers", "--import", "start.gcode", "-", "-o", "x.json").Code, Is.EqualTo(1), "inches");
        Assert.That(File.Exists("x.json"), Is.False);
        Assert.That(Run("printers", "--import", "nothing.gcode", "-").Code, Is.EqualTo(1));
        Assert.That(Run("printers", "--import", "a", "b", "c").Code, Is.EqualTo(2));
        Assert.That(Run("printers", "--base", "generic").Code, Is.EqualTo(2));
        Assert.That(Run("printers", "--import", "start.gcode", "-", "--base", "no_such").Code, Is.EqualTo(2));
    }
}
