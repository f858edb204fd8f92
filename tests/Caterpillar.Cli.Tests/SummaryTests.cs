using System;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Machines;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

/// <summary>The lines that close the work: on standard error, and quiet when told.</summary>
public class SummaryTests : CliFixture
{
    // 20 mm of an extrusion of 0.45 × 0.2 mm, E in mm of filament.
    private const string Code = "; filament_diameter = 1.75\n; filament_density = 1.24\nG28\nG90\nM83\nM84\n;LAYER_CHANGE\n;Z:0.2\n;HEIGHT:0.2\n"
        + "G1 X10 Y10 Z0.2 F3000\nG1 X20 E0.37 F1200\nG1 Y20 E0.37\nM84\n";

    [SetUp]
    public void WriteInputs()
    {
        File.WriteAllText("part.stl", Box(20, 10, 2));
        File.WriteAllText("l.gcode", Code);
        File.WriteAllText("s.turtle", "start 100 100 0.2\nforward 10\nleft 90\nforward 5\n");
        File.WriteAllText("c.csv", "x,y,z\n10,10,0.2\n30,10,0.2\n30,50,0.2\n");
    }

    [TestCase("part.gcode: 10 layers, 20 × 10 × 2 mm, 164 mm of filament (0.49 g), about", "slice", "part.stl")]
    [TestCase("part.gcode: 10 layers, 20 × 10 × 2 mm, 0.4 cm³ (0.49 g), about", "slice", "part.stl", "--set", "filament_diameter_mm=10")]
    [TestCase("s.gcode: ", "turtle", "s.turtle")]
    [TestCase("c.gcode: ", "curves", "c.csv")]
    [TestCase("o.gcode: speed of 2 moves changed; 1 layer, 10.5 × 10.5 × 0.2 mm, 0.7 mm of filament (0.00221 g)", "convert", "l.gcode", "-o", "o.gcode",
        "--speed", "2")]
    [TestCase("o.gcode: flow of 2 moves changed; 1 layer, 10.9 × 10.9 × 0.2 mm, 1.5 mm of filament", "convert", "l.gcode", "-o", "o.gcode", "--flow",
        "200%")]
    [TestCase("o.gcode: position of 3 moves changed; 1 layer", "convert", "l.gcode", "-o", "o.gcode", "--move", "1,1")]
    [TestCase("o.gcode: 1 command inserted; ", "convert", "l.gcode", "-o", "o.gcode", "--gcode-at-layer", "0=M300")]
    [TestCase("o.gcode: converted from Marlin 2 to Klipper; ", "convert", "l.gcode", "-o", "o.gcode", "--flavor", "klipper")]
    [TestCase("o.gcode: notation converted; ", "convert", "l.gcode", "-o", "o.gcode", "--e-mode", "absolute")]
    [TestCase("o.gcode: nothing changed; 1 layer", "convert", "l.gcode", "-o", "o.gcode")]
    [TestCase("l.png: 64 × 48 pixels; l.gcode: 1 layer, 10.5 × 10.5 × 0.2 mm", "image", "l.gcode", "--width", "64")]
    [TestCase("l.html: ", "view", "l.gcode")]
    [TestCase("part.html: ", "view", "part.stl")]
    [TestCase("s.html: ", "view", "s.turtle")]
    [TestCase("mine.json: Creality Ender 3", "printers", "ender3", "-o", "mine.json")]
    public void Work_closes_with_what_was_made(string summary, params string[] words)
    {
        var run = Run(words);
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(run.Messages.TrimEnd().Split('\n').Last(), Does.StartWith(summary));
        var quiet = Run([.. words, "--quiet"]);
        Assert.That((quiet.Code, quiet.Messages), Is.EqualTo((0, "")));
        Assert.That(quiet.Output, Is.EqualTo(run.Output));
    }

    [Test]
    public void It_tells_time_and_size_of_the_file()
    {
        var line = Run("slice", "part.stl", "--printer", "ender3").Messages.TrimEnd().Split('\n').Last();
        Assert.That(line, Does.Match(@", about \d+ min \d+ s; \d+ lines, \d+ KB$"));
        Assert.That(PrintSummary.Duration(59.4), Is.EqualTo("59 s"));
        Assert.That(PrintSummary.Duration(3599), Is.EqualTo("59 min 59 s"));
        Assert.That(PrintSummary.Duration(7259), Is.EqualTo("2 h 1 min"));
        Assert.That(PrintSummary.Duration(double.PositiveInfinity), Is.EqualTo("more than 30 years"));
    }

    [Test]
    public void Several_kinds_of_findings_are_counted_and_six_of_them_named()
    {
        static Diagnostic Found(int kind, int count = 1, Severity severity = Severity.Warning)
            => new(severity, CheckCodes.All[kind].Code, "It is.", Count: count) { Share = count / 8.0 };
        string Name(int kind) => CheckCodes.All[kind].Code;
        Assert.That(FindingSummary.Of([]), Is.Null);
        Assert.That(FindingSummary.Of([Found(0, 9)]), Is.Null);
        Assert.That(FindingSummary.Of([Found(0), Found(1, 9, Severity.Note), new(Severity.Error, "file.other", "It is.")]), Is.Null);
        Assert.That(FindingSummary.Of([Found(0, 2), Found(1, 3), Found(2, 1, Severity.Error)]),
            Is.EqualTo($"6 findings of 3 kinds: {Name(2)} 1, {Name(1)} 3, {Name(0)} 2."));
        Assert.That(FindingSummary.Of([Found(0), Found(1)]), Is.EqualTo($"2 findings of 2 kinds: {Name(0)} 1, {Name(1)} 1."));
        Assert.That(FindingSummary.Of(Enumerable.Range(0, 6).Select(i => Found(i))), Does.EndWith($"{Name(5)} 1."));
        Assert.That(FindingSummary.Of(Enumerable.Range(0, 8).Select(i => Found(i, 8 - i))),
            Does.StartWith("36 findings of 8 kinds").And.EndsWith("and 2 more kinds."));
        var json = FindingSummary.ToJson([Found(0, 3), Found(1) with { Share = 0 }]);
        Assert.That((double?)json[0]["share"], Is.EqualTo(0.375));
        Assert.That((double?)json[1]["share"], Is.Null);
    }

    [Test]
    public void Quiet_keeps_what_is_wrong()
    {
        var run = Run("slice", "none.stl", "-q");
        Assert.That((run.Code, run.Messages), Is.EqualTo((1, "none.stl: file not found." + Environment.NewLine)));
        File.WriteAllText("big.stl", Box(900, 10, 2));
        run = Run("slice", "big.stl", "-q");
        Assert.That((run.Code, run.Messages.Contains("models.too_large", StringComparison.Ordinal)), Is.EqualTo((3, true)));
    }

    [TestCase("image", "l.gcode")]
    [TestCase("convert", "l.gcode", "-o", "o.gcode")]
    [TestCase("decode", "l.gcode")]
    [TestCase("simulate", "l.gcode")]
    public void Harmless_words_are_no_topic_where_nobody_asked(params string[] words) => Assert.That(Run(words).Messages, Does.Not.Contain("M84"));

    [Test]
    public void Checks_name_harmless_words_once_at_the_end()
    {
        var run = Run("check", "l.gcode");
        Assert.That(run.Messages.TrimEnd().Split('\n').Last(), Does.Contain("M84 (2)"));
        Assert.That(run.Messages.Split("M84"), Has.Length.EqualTo(2));
        Assert.That(Run("check", "l.gcode", "--quiet").Messages, Is.Empty);
        Assert.That(Run("decode", "l.gcode").Text, Does.Contain("Ignored: M84"));
    }
}
