using System;
using System.IO;
using System.Linq;
using System.Text;
using System.Threading;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

public class SliceTests : CliFixture
{
    [Test]
    public void A_model_becomes_one_file_and_nothing_else()
    {
        File.WriteAllText("part.stl", Box(20, 10, 2));
        var run = Run("slice", "part.stl");
        Assert.That((run.Code, run.Text), Is.EqualTo((0, "")));
        Assert.That(run.Messages, Does.StartWith("part.gcode: "));
        Assert.That(Files(), Is.EqualTo(new[] { "part.gcode", "part.stl" }));
        // The middle of the bed of the generic printer, 220 × 220 mm.
        var decoded = Run("decode", "part.gcode").Text;
        Assert.That(File.ReadAllText("part.gcode"), Does.Contain("G28").And.Contain(";TYPE:"));
        Assert.That(decoded, Does.Contain(" in ").And.Contain("layers"));
    }

    [Test]
    public void Standard_input_and_output_give_the_same_bytes_as_files()
    {
        File.WriteAllText("part.stl", Box(20, 10, 2));
        Run("slice", "part.stl", "-o", "a.gcode", "--threads", "1");
        var piped = Run(File.ReadAllBytes("part.stl"), ["slice", "-", "-o", "-"]);
        Assert.That(piped.Code, Is.Zero, piped.Messages);
        Assert.That(Encoding.UTF8.GetString(piped.Output).Replace("standard input", "part"), Is.EqualTo(File.ReadAllText("a.gcode")));
        Assert.That(piped.Messages, Does.StartWith("standard output: 10 layers, 20 × 10 × 2 mm"));
        Assert.That(Run(File.ReadAllBytes("part.stl"), ["slice", "-", "-o", "-", "--quiet"]).Messages, Is.Empty);
    }

    [Test]
    public void Without_an_output_standard_input_goes_to_standard_output()
        => Assert.That(Run(Encoding.ASCII.GetBytes(Box(20, 10, 2)), ["slice", "-"]).Text, Does.Contain("G1 X"));

    [Test]
    public void Settings_and_values_reach_the_file()
    {
        File.WriteAllText("part.stl", Box(20, 10, 2));
        Run("slice", "part.stl", "--printer", "ender3", "--material", "petg", "--set", "nozzle_temperature_c=233", "--set",
            "first_layer_nozzle_temperature_c=0", "--set", "layer_height_mm=0.4");
        var text = File.ReadAllText("part.gcode");
        Assert.That(text, Does.Contain("M109 S233").And.Contain("M190 S80").And.Contain("M82"));
        Assert.That(text.Split('\n').Count(l => l.StartsWith(";LAYER_CHANGE", StringComparison.Ordinal)), Is.InRange(5, 6));
    }

    [Test]
    public void A_missing_file_is_named()
    {
        var run = Run("slice", "none.stl");
        Assert.That(run.Code, Is.EqualTo(1));
        Assert.That(run.Messages, Is.EqualTo("none.stl: file not found." + Environment.NewLine));
    }

    [Test]
    public void A_broken_model_is_named_with_its_line()
    {
        File.WriteAllText("part.stl", Box(20, 10, 2).Replace("vertex 20 10 2", "vertex 20 ten 2"));
        var run = Run("slice", "part.stl");
        Assert.That(run.Code, Is.EqualTo(1));
        Assert.That(run.Messages, Does.Match(@"part\.stl:\d+:\d+: error mesh\."));
        Assert.That(Files(), Is.EqualTo(new[] { "part.stl" }));
    }

    [Test]
    public void A_folder_is_neither_a_model_nor_an_output()
    {
        Directory.CreateDirectory("folder");
        File.WriteAllText("part.stl", Box(20, 10, 2));
        Assert.That(Run("slice", "folder").Code, Is.EqualTo(1));
        Assert.That(Run("slice", "part.stl", "-o", "folder").Code, Is.EqualTo(1));
        Assert.That(Run("slice", "part.stl", "-o", "none/part.gcode").Code, Is.EqualTo(1));
    }

    [Test]
    public void A_model_larger_than_the_bed_is_refused_and_an_older_file_stays()
    {
        File.WriteAllText("part.stl", Box(300, 10, 1));
        File.WriteAllText("part.gcode", "old");
        var run = Run("slice", "part.stl");
        Assert.That(run.Code, Is.EqualTo(3), run.Messages);
        Assert.That(run.Messages, Does.Contain("models.too_large").And.Contain("80 mm too long in X").And.Contain("error write.refused"));
        Assert.That(run.Messages, Does.Not.Contain("bed.outside").And.Not.Contain("--scale"), "nothing is sliced");
        Assert.That(Run("slice", "part.stl", "--scale", "60").Messages, Does.Contain("use --scale 60mm."));
        // Where it stands outside, but would fit, the finished print is looked at.
        File.WriteAllText("part.stl", Box(30, 10, 1));
        run = Run("slice", "part.stl", "--center", "0,0");
        Assert.That((run.Code, run.Messages.Contains("error bed.outside", System.StringComparison.Ordinal)), Is.EqualTo((3, true)));
        Assert.That(File.ReadAllText("part.gcode"), Is.EqualTo("old"));
        Assert.That(Files(), Is.EqualTo(new[] { "part.gcode", "part.stl" }));
    }

    [TestCase("m", 0.02)]
    [TestCase("cm", 2)]
    [TestCase("in", 20 / 25.4)]
    [TestCase("10", 2)]
    public void A_model_in_another_unit_is_read_in_it(string unit, double side)
    {
        File.WriteAllText("part.stl", Box(side, side, side / 4));
        var run = Run("slice", "part.stl", "--unit", unit, "--set", "skirt_loops=0");
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(File.ReadAllText("part.gcode"), Does.Contain("Z5").And.Not.Contain("Z5.2"), "20 mm wide, 5 mm high");
        Assert.That(run.Messages, Does.Not.Contain("models.unit"));
    }

    [Test]
    public void A_unit_is_a_name_or_a_length()
    {
        File.WriteAllText("part.stl", Box(0.02, 0.02, 0.005));
        Assert.That(Run("slice", "part.stl").Messages, Does.Contain("models.unit").And.Contain("In meters it would be 20 × 20 × 5 mm"));
        foreach (var wrong in new[] { "parsec", "0", "-1" }) Assert.That(Run("slice", "part.stl", "--unit", wrong).Code, Is.EqualTo(2), wrong);
    }

    [Test]
    public void A_reason_overrides_the_refusal_and_stays_in_the_file()
    {
        File.WriteAllText("part.stl", Box(300, 10, 1));
        Assert.That(Run("slice", "part.stl", "--override", "42").Code, Is.EqualTo(3));
        Assert.That(Run("slice", "part.stl", "--override", "the bed was extended").Code, Is.Zero);
        Assert.That(File.ReadAllText("part.gcode"), Does.Contain("; ").And.Contain("the bed was extended"));
    }

    [Test]
    public void The_position_of_the_file_can_be_kept()
    {
        File.WriteAllText("part.stl", Box(20, 10, 1));
        Run("slice", "part.stl", "--set", "start_gcode=", "--set", "end_gcode=", "--set", "wall_count=1", "--set", "infill_density_percent=0");
        Assert.That(Run("decode", "part.gcode").Text, Does.Match(@"Printed box +100\."));
        Run("slice", "part.stl", "--keep-position", "--set", "start_gcode=", "--set", "end_gcode=", "--set", "wall_count=1", "--set",
            "infill_density_percent=0");
        Assert.That(Run("decode", "part.gcode").Text, Does.Match(@"Printed box +0\."));
    }

    [Test]
    public void What_was_planned_can_be_read_by_programs()
    {
        File.WriteAllText("part.stl", Box(20, 10, 2));
        var run = Run("slice", "part.stl", "--json");
        var report = System.Text.Json.JsonDocument.Parse(run.Output).RootElement;
        Assert.That(report.GetProperty("layers").GetInt32(), Is.EqualTo(10));
        Assert.That(report.GetProperty("bytes").GetInt64(), Is.EqualTo(new FileInfo("part.gcode").Length));
        Assert.That(report.GetProperty("output").GetString(), Is.EqualTo("part.gcode"));
        Assert.That(Run("slice", "part.stl", "--json", "-o", "-").Code, Is.EqualTo(2));
    }

    [Test]
    public void Findings_name_object_and_layer_in_messages_and_as_data()
    {
        File.WriteAllText("part.stl", Box(20, 10, 2));
        var run = Run("slice", "part.stl", "--json", "--set", "print_speed_mm_s=90", "--set", "max_speed_mm_s=60,60,60,60");
        Assert.That(run.Messages, Does.Match(@"box, layer 1 -> line \d+, step \d+, move \d+: warning limit\.speed: "));
        var finding = System.Text.Json.JsonDocument.Parse(run.Output).RootElement.GetProperty("findings").EnumerateArray()
            .Single(f => f.GetProperty("code").GetString() == "limit.speed");
        var origin = finding.GetProperty("origin");
        Assert.That((origin.GetProperty("file").GetString(), origin.GetProperty("layer").GetInt32()), Is.EqualTo(("box", 1)));
        Assert.That(finding.GetProperty("line").GetInt32(), Is.GreaterThan(10));
        Assert.That(finding.GetProperty("count").GetInt32(), Is.GreaterThan(10));
        var check = Run("check", "part.gcode", "--set", "max_speed_mm_s=60,60,60,60");
        Assert.That(check.Text, Does.Match(@"layer 1 -> part\.gcode:\d+, move \d+: warning limit\.speed"));
    }

    [Test]
    public void Several_kinds_of_findings_are_summed_up_in_a_line()
    {
        File.WriteAllText("a.turtle", "start 10 10 8\nspeed 900\nforward 80\nforward 80\n");
        var run = Run("turtle", "a.turtle");
        Assert.That(run.Messages, Does.Contain("6 findings of 4 kinds: limit.flow 2, first_layer.in_air 1, limit.speed 2, extrusion.unsupported 1."));
        File.WriteAllText("b.turtle", "start 10 10 0.2\nforward 80\n");
        Assert.That(Run("turtle", "b.turtle").Messages, Does.Not.Contain("kinds"));
    }

    [Test]
    public void Interrupted_work_leaves_nothing()
    {
        File.WriteAllText("part.stl", Box(20, 10, 2));
        using var stop = new CancellationTokenSource();
        stop.Cancel();
        var run = Run([], ["slice", "part.stl"], stop.Token);
        Assert.That(run.Code, Is.EqualTo(130));
        Assert.That(Files(), Is.EqualTo(new[] { "part.stl" }));
    }

    [Test]
    public void A_terminal_gets_a_bar_and_a_pipe_does_not()
    {
        File.WriteAllText("part.stl", Box(20, 10, 2));
        Assert.That(Run([], ["slice", "part.stl"]).Messages, Does.Not.Contain("%"));
        Assert.That(Run([], ["slice", "part.stl"], terminal: true).Code, Is.Zero);
    }

    [Test]
    public void Devices_are_written_and_not_replaced()
    {
        if (!OperatingSystem.IsLinux()) Assert.Ignore("There are no such devices here.");
        File.WriteAllText("part.stl", Box(20, 10, 2));
        Assert.That(Run("slice", "part.stl", "-o", "/dev/null").Code, Is.Zero);
        Assert.That(new FileInfo("/dev/null").Length, Is.Zero);
        Assert.That(Run("slice", "part.stl", "-o", "/dev/full").Code, Is.EqualTo(1));
    }

    [Test]
    [System.Runtime.Versioning.UnsupportedOSPlatform("windows")]
    public void A_link_stays_a_link_and_a_file_keeps_its_permissions()
    {
        if (OperatingSystem.IsWindows()) Assert.Ignore("Links need permissions here.");
        File.WriteAllText("part.stl", Box(20, 10, 2));
        File.WriteAllText("real.gcode", "old");
        File.SetUnixFileMode("real.gcode", UnixFileMode.UserRead | UnixFileMode.UserWrite);
        File.CreateSymbolicLink("part.gcode", "real.gcode");
        Assert.That(Run("slice", "part.stl").Code, Is.Zero);
        Assert.That(new FileInfo("part.gcode").LinkTarget, Is.EqualTo("real.gcode"));
        Assert.That(new FileInfo("real.gcode").Length, Is.GreaterThan(1000));
        Assert.That(File.GetUnixFileMode("real.gcode"), Is.EqualTo(UnixFileMode.UserRead | UnixFileMode.UserWrite));
    }
}
