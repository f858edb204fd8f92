using System;
using System.IO;
using System.Linq;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

/// <summary>Messages name what was meant, in the words of the user.</summary>
public class MessageTests : CliFixture
{
    [SetUp]
    public void WriteInputs()
    {
        File.WriteAllText("a.stl", Box(6, 5, 1));
        File.WriteAllText("l.gcode", "G28\nM83\n;LAYER_CHANGE\n;TYPE:External perimeter\nG1 X10 Y10 Z0.2 F3000\nG1 X20 E1 F1200\n");
        File.WriteAllText("s.turtle", "param side = 5\nforward side\n");
        File.WriteAllText("c.csv", "x,y,z\n10,10,0.2\n30,10,0.2\n30,50,0.2\n");
    }

    [TestCase("Unknown command slcie. Did you mean 'slice'?", "slcie", "a.stl")]
    [TestCase("Unknown option --matrial. Did you mean --material?", "slice", "a.stl", "--matrial", "pla")]
    [TestCase("Unknown option --quite. Did you mean --quiet?", "slice", "a.stl", "--quite")]
    [TestCase("Unknown option --pne. Did you mean --pen?", "curves", "c.csv", "--pne")]
    [TestCase("Unknown option --bogus-thing. If it is a file, write ./--bogus-thing", "slice", "a.stl", "--bogus-thing")]
    [TestCase("Unknown option --supports. Set the key: --set support=tree", "slice", "a.stl", "--supports")]
    [TestCase("Unknown option --brim. Set the key: --set brim_width_mm=8", "slice", "a.stl", "--brim", "8")]
    [TestCase("Unknown option --fill-density. Set the key: --set infill_density_percent=15", "slice", "a.stl", "--fill-density=15%")]
    [TestCase("Unknown option --material-flow. Set the key: --set flow_ratio=0.95", "slice", "a.stl", "--material-flow", "95")]
    [TestCase("Unknown option --xy-offset-layer-0. Set the key: --set elephant_foot_compensation_mm=0.2", "slice", "a.stl", "--xy-offset-layer-0=-0.2")]
    [TestCase("Unknown option --wall-loops. Set the key: --set wall_count=3", "slice", "a.stl", "--wall-loops")]
    [TestCase("Unknown option --spiral. Set the key: --set spiral_vase=true", "slice", "a.stl", "--spiral")]
    [TestCase("Unknown option --infill. Set the key: --set infill_density_percent=20", "slice", "--each", "a.stl", "--infill")]
    [TestCase("Unknown option --layer-height. Set the key for slicing: caterpillar slice MODEL --set layer_height_mm=0.3", "convert", "l.gcode",
        "--layer-height", "0.3")]
    [TestCase("Unknown option --support-angle. Set the key: --set support_angle_deg=50", "slice", "a.stl", "--support-angle", "50")]
    [TestCase("Unknown option --wall-order. Set the key: --set wall_order=VALUE", "slice", "a.stl", "--wall-order", "outside_in")]
    [TestCase("Unknown option --temperature-at-height. Use: caterpillar convert FILE --gcode-at-layer \"N=M104 S210\"", "slice", "a.stl",
        "--temperature-at-height", "5")]
    [TestCase("Unknown option --pause-at-height. Use --pause-at-layer N", "convert", "l.gcode", "--pause-at-height", "5")]
    [TestCase("Unknown option --pause-at-layer. It is an option of convert.", "slice", "a.stl", "--pause-at-layer", "3")]
    [TestCase("Unknown option --duplicate. Use --copies N", "slice", "a.stl", "--duplicate", "3")]
    [TestCase("Unknown option -g. Use --output FILE", "slice", "-g", "a.stl")]
    [TestCase("Unknown option --layer. Use --at layer:N", "simulate", "l.gcode", "--layer", "5")]
    [TestCase("Unknown option --layer. Set the key: --set layer_height_mm=5", "slice", "a.stl", "--layer", "5")]
    [TestCase("Unknown option --layer. Use --first-layer N", "convert", "l.gcode", "--layer", "5")]
    [TestCase("Unknown option --layer. It is an option of image.", "check", "l.gcode", "--layer", "5")]
    [TestCase("Unknown option --line. If it is a file, write ./--line", "decode", "l.gcode", "--line", "5")]
    [TestCase("The MODEL is missing.", "slice")]
    [TestCase("Did you mean layer_height_mm?", "slice", "a.stl", "--set", "layer_hieght_mm=0.2")]
    [TestCase("Did you mean 'gyroid'?", "slice", "a.stl", "--set", "infill_pattern=gyrod")]
    [TestCase("Did you mean ender3?", "slice", "a.stl", "--printer", "ender4")]
    [TestCase("Did you mean 'marlin2'?", "decode", "l.gcode", "--flavor", "marln2")]
    [TestCase("Did you mean 'Outer wall'?", "convert", "l.gcode", "-o", "o.gcode", "--role", "outr-wall", "--speed", "2")]
    [TestCase("--color needs height, layer, progress, role or speed, not \"Rol\". Did you mean 'role'?", "image", "l.gcode", "--color", "Rol")]
    [TestCase("--threads needs a whole number, not \"abc\".", "slice", "a.stl", "--threads", "abc")]
    [TestCase("--rotate needs a number, not \"abc\".", "convert", "l.gcode", "-o", "o.gcode", "--rotate", "abc")]
    [TestCase("--seed needs a whole number, not \"1.5\".", "turtle", "s.turtle", "--seed", "1.5")]
    public void A_misspelled_word_gets_a_hint(string hint, params string[] words)
    {
        var before = Files();
        var run = Run(words);
        Assert.That((run.Code, run.Text, Files()), Is.EqualTo((2, "", before)), run.Messages);
        Assert.That(run.Messages, Does.Contain(hint).And.Not.Contain("System."));
    }

    [TestCase("outer wall")]
    [TestCase("Outer wall")]
    [TestCase("OuterWall")]
    [TestCase("outer_wall")]
    [TestCase("OUTER-WALL")]
    public void Roles_have_their_shown_names_and_their_identifiers(string role)
    {
        var run = Run("convert", "l.gcode", "-o", "o.gcode", "--role", role, "--speed", "50%");
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(File.ReadAllText("o.gcode"), Does.Contain("F600"));
    }

    [TestCase("There is no 'sidee'", "forward sidee", "Did you mean 'side'?")]
    [TestCase("misspelled command", "forwad 5", "Did you mean 'forward'?")]
    [TestCase("empty range", "forward randint(5,1)", "randint(from, to) without an integer in between")]
    [TestCase("negative count", "circle 5 -3", "The number of segments must be 1 to 1000000, or 0 (automatic), not -3.")]
    public void Scripts_say_what_is_wrong(string what, string line, string message)
    {
        File.WriteAllText("s.turtle", "param side = 5\n" + line + "\n");
        var run = Run("turtle", "s.turtle");
        Assert.That(run.Code, Is.EqualTo(1), what);
        Assert.That(run.Messages, Does.StartWith("s.turtle:2:").And.Contain(message));
    }

    [TestCase("dwell 1e300", "0 to 1000000000 ms")]
    [TestCase("acceleration 1e300", "at most 1000000 mm/s²")]
    public void Amounts_beyond_any_machine_are_refused_where_they_stand(string line, string message)
    {
        File.WriteAllText("s.turtle", line + "\nforward 5\n");
        var run = Run("turtle", "s.turtle");
        Assert.That(run.Code, Is.EqualTo(1), run.Messages);
        Assert.That(run.Messages, Does.StartWith("s.turtle:1:").And.Contain(message));
    }

    [TestCase("generic")]
    [TestCase("pen_plotter")]
    public void Drawings_of_a_pen_are_seen_from_above(string printer)
    {
        Assert.That(Run("curves", "c.csv", "--pen", "--printer", printer, "-o", "pen.gcode").Code, Is.Zero);
        Run("image", "pen.gcode", "-o", "a.png", "--width", "64");
        Run("image", "pen.gcode", "-o", "b.png", "--width", "64", "--view", "top");
        Run("image", "pen.gcode", "-o", "c.png", "--width", "64", "--view", "-60,28");
        Assert.That(File.ReadAllBytes("a.png"), Is.EqualTo(File.ReadAllBytes("b.png")).And.Not.EqualTo(File.ReadAllBytes("c.png")));
        Run("image", "l.gcode", "-o", "d.png", "--width", "64");
        Run("image", "l.gcode", "-o", "e.png", "--width", "64", "--view", "-60,28");
        Assert.That(File.ReadAllBytes("d.png"), Is.EqualTo(File.ReadAllBytes("e.png")));
    }

    [Test]
    public void Control_characters_of_names_never_reach_the_terminal()
    {
        var name = "a\u001B[31m.stl";
        File.WriteAllText(name, Box(10, 10, 2).Replace("solid box", "solid \u001B]0;title\u0007"));
        File.WriteAllText("b\u001B[2J.turtle", "print 1\nforward \u001B[1m");
        File.WriteAllText("c.gcode", "G28\nM117 \u001B[5m\n\u001B[6n X1\nEXCLUDE_OBJECT_DEFINE NAME=\u001B[5m\nG1 X1 E1\n");
        string[][] calls = [["slice", name, "-o", "x.gcode"], ["slice", name, "-o", "x/\u001B[2J"], ["sections", name, "--heights", "1"],
            ["sections", name, "--heights", "1", "--json"], ["turtle", "b\u001B[2J.turtle"], ["check", "c.gcode"], ["check", "c.gcode", "--json"],
            ["decode", "c.gcode"], ["slice", "\u001B[2J"], ["slice", name, "--printer", "\u001B[2J"], ["\u001B[2J"], ["slice", name, "--set", "\u001B[2J=1"]];
        foreach (var call in calls)
        {
            var run = Run(call);
            var controls = (run.Messages + run.Text).Where(c => char.IsControl(c) && c is not ('\n' or '\r' or '\t'));
            Assert.That(controls, Is.Empty, call[0] + ": " + run.Messages);
        }
    }

    [Test]
    public void Numbers_of_hundreds_of_digits_are_told_as_powers_of_ten()
    {
        File.WriteAllText("s.turtle", "forward 5" + new string('0', 300) + "\n");
        var run = Run("turtle", "s.turtle");
        Assert.That(run.Code, Is.EqualTo(3));
        Assert.That(run.Messages,
            Does.Contain("s.turtle:1 -> step 0, move 1: error write.invalid_number: The end point of a move cannot be written: it is 5e300"));
    }

    [Test]
    public void Small_limits_are_not_told_as_zero()
    {
        var run = Run("check", "l.gcode", "--set", "max_flow_mm3_s=0.0001");
        Assert.That(run.Code, Is.EqualTo(3), run.Messages);
        Assert.That(run.Text, Does.Contain("the maximum is 0.0001 mm³/s"));
    }

    [Test]
    public void Folders_that_do_not_exist_are_told_by_the_names_that_were_typed()
    {
        Assert.That(Run("slice", "a.stl", "-o", "none/x.gcode").Messages, Does.Match("^none/x.gcode: .*folder"));
        Assert.That(Run("slice", "none/x.stl").Messages, Does.StartWith("none/x.stl: folder not found."));
        Assert.That(Run("slice", "/nonexistent/x.stl").Messages, Does.StartWith("/nonexistent/x.stl: folder not found."));
    }

    [Test]
    public void Settings_that_print_nothing_are_named()
    {
        string[] nothing = ["--set", "wall_count=0", "--set", "infill_density_percent=0", "--set", "top_layers=0", "--set", "bottom_layers=0"];
        Assert.That(Run(["slice", "a.stl", .. nothing]).Messages, Does.Contain("the settings have no walls, no infill and no top or bottom layers"));
        File.WriteAllText("thin.stl", Box(6, 0.03, 1));
        Assert.That(Run("slice", "thin.stl").Messages, Does.Contain("all contours are narrower than a line (0.45 mm)"));
        Assert.That(Files(), Does.Not.Contain("a.gcode").And.Not.Contain("thin.gcode"));
    }

    [TestCase("print_speed_mm_s=50%", "print_speed_mm_s=30", "print_speed_mm_s=60")]
    [TestCase("flow_ratio=95%", "flow_ratio=0.95")]
    [TestCase("infill_density_percent=35%", "infill_density_percent=35")]
    [TestCase("line_width_mm=125%", "line_width_mm=0.5")]
    [TestCase("bridge_flow_ratio=90%", "bridge_flow_ratio=0.9")]
    public void Percent_is_taken_where_a_speed_a_flow_or_a_width_is_asked(string percent, string value, string? first = null)
    {
        string[] Words(string set, string file)
            => ["slice", "a.stl", "-o", file, .. first is null ? Enumerable.Empty<string>() : ["--set", first], "--set", set];
        var run = Run(Words(percent, "a.gcode"));
        Assert.That(run.Code, Is.Zero, run.Messages);
        Run(Words(value, "b.gcode"));
        // The setup in the comments keeps percents of widths, so that they follow another nozzle.
        string[] Code(string file) => File.ReadAllLines(file).Where(l => !l.StartsWith("; ", StringComparison.Ordinal)).ToArray();
        Assert.That(Code("a.gcode"), Is.EqualTo(Code("b.gcode")));
    }

    [Test]
    public void Percent_elsewhere_is_wrong_usage()
        => Assert.That(Run("slice", "a.stl", "--set", "bed_temperature_c=50%").Messages, Does.Contain("needs a number, not the text \"50%\""));
}
