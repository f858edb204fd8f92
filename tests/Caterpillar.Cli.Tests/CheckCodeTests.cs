using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.Machines;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

/// <summary>A file or a script for each code: refused as an error with exit 3, written with a reason that stays as a comment.</summary>
public class CheckCodeTests : CliFixture
{
    private const string Reason = "the machine stands it";

    // 0.08 mm² of 1.75 mm filament for each mm.
    private const double PerMm = 0.033261;

    private static IEnumerable<string> Codes() => CheckCodes.All.Select(r => r.Code);

    [TestCaseSource(nameof(Codes))]
    public void Each_code_is_refused_as_an_error_and_written_with_a_reason(string code)
    {
        var (name, text, printer) = Case(code);
        File.WriteAllText(name, text);
        File.WriteAllText("own.json", "{ " + (code == CheckCodes.Flow ? "" : "\"max_flow_mm3_s\": 0, ") + "\"start_gcode\": [], \"end_gcode\": [], "
            + (printer.Length > 0 ? printer + ", " : "") + $"\"check_severities\": [{Severities(code)}] }}");
        string[] words = name.EndsWith(".turtle", StringComparison.Ordinal) ? ["turtle", name] : ["convert", name];
        string[] call = [.. words, "-o", "out.gcode", "--printer", "own.json"];
        var refused = Run(call);
        Assert.That(refused.Code, Is.EqualTo(3), refused.Messages);
        Assert.That(refused.Messages, Does.Contain("error " + code).And.Contain("error write.refused"));
        Assert.That(File.Exists("out.gcode"), Is.False);
        var written = Run([.. call, "--override", Reason]);
        Assert.That(written.Code, Is.Zero, written.Messages);
        Assert.That(written.Messages, Does.Contain("warning " + code));
        var lines = File.ReadAllLines("out.gcode");
        var at = Array.FindIndex(lines, l => l.Contains("Reason: " + Reason));
        Assert.That(at, Is.InRange(0, 6));
        Assert.That(lines.Skip(at + 1).Take(8), Has.Some.StartsWith(";").And.Some.Contains("error " + code));
        if (words[0] != "convert") return;
        var check = Run("check", name, "--printer", "own.json", "--json");
        Assert.That(check.Code, Is.EqualTo(3));
        var found = System.Text.Json.JsonDocument.Parse(check.Output).RootElement.EnumerateArray().Single(f => f.GetProperty("code").GetString() == code);
        Assert.That(found.GetProperty("severity").GetString(), Is.EqualTo("error"));
        Assert.That(found.GetProperty("message").GetString(), Has.Length.GreaterThan(20));
        if (found.TryGetProperty("file", out var file)) Assert.That(file.GetString(), Is.EqualTo(name));
    }

    // Only the one code stops the file.
    private static string Severities(string code)
        => string.Join(", ", CheckCodes.All.Select(r => $"\"{r.Code}={(r.Code == code ? "error" : "warning")}\""));

    private static (string Name, string Text, string Printer) Case(string code) => code switch
    {
        CheckCodes.FilePosition => ("a.turtle", "start 10 10 0.2\nforward 20\nraw \"G1 X40\"\nraw \"G92 X30\"\nforward 20\n", ""),
        CheckCodes.FileExtrusion => ("a.turtle", "start 10 10 0.2\nforward 20\nraw \"M221 S50\"\nforward 20\n", ""),
        CheckCodes.FileModes => ("a.turtle", "start 10 10 0.2\nforward 20\nraw \"G91\"\nforward 20\n", ""),
        CheckCodes.UnverifiedCommand => ("a.turtle", "start 10 10 0.2\nforward 20\nraw \"MY_MACRO\"\nforward 20\n", ""),
        CheckCodes.NoHoming => ("a.gcode", Whole("M109 S200\n", Extrusion(30, 10)), ""),
        CheckCodes.NoHeating => ("a.gcode", Whole("G28\n", Extrusion(30, 10)).Replace("M104 S0\n", ""), ""),
        CheckCodes.UnknownPosition => ("a.gcode", "G28 X Y\nM109 S200\nM83\nG1 X10 Y10 F3000\nG1 X20 E0.3\nM104 S0\n", ""),
        CheckCodes.HeatLeftOn => ("a.gcode", Whole("G28\nM109 S200\n", Extrusion(30, 10)).Replace("M104 S0\n", ""), ""),
        _ => ("a.gcode", Whole("G28\nM109 S200\n", Body(code)), Printer(code)),
    };

    private static string Printer(string code) => code switch
    {
        CheckCodes.AxisRange => "\"rotary_axes\": [\"C work z\"], \"slide_range_mm\": [[0, 0, 0, 20, 200, 200]]",
        CheckCodes.ExcludedArea => "\"bed_exclude_areas_mm\": [[100, 50, 120, 70]]",
        CheckCodes.HeadHits => "\"head_boxes_mm\": [[-25, -45, 8, 50, 30, 60]]",
        CheckCodes.GantryHits => "\"gantry_mm\": [[20, 8, 60, 60]]",
        CheckCodes.ClipHit => "\"bed_clips_mm\": [[0, 100, 0, 12, 110, 5]]",
        CheckCodes.Flow => "\"max_flow_mm3_s\": 1",
        CheckCodes.Speed or CheckCodes.TravelSpeed => "\"max_speed_mm_s\": [40, 40, 40, 40]",
        _ => "",
    };

    private static string Body(string code) => code switch
    {
        CheckCodes.Outside => "G1 X230\n",
        CheckCodes.Below => "G1 Z-1\n",
        CheckCodes.ExcludedArea => To(80, 60, 0.2) + Extrusion(130, 60, 50),
        CheckCodes.NozzleHits => Wall(4) + To(70, 30, 3) + Extrusion(70, 70, 40),
        CheckCodes.TravelHits => Wall(4) + To(70, 30, 3) + "G1 Y70\n",
        CheckCodes.HeadHits => Wall(12) + To(70, 30, 1),
        CheckCodes.GantryHits => Wall(12) + To(200, 10, 1),
        CheckCodes.ClipHit => To(50, 105, 3) + "G1 X5\n",
        CheckCodes.Slope => string.Concat(Enumerable.Range(0, 5).Select(k => To(50, 50 + 0.4 * k, 5 - 0.2 * k) + Extrusion(60, 50 + 0.4 * k, 10))),
        CheckCodes.Unsupported => To(50, 50, 0.2) + Extrusion(60, 50, 10) + To(60, 50, 4) + Extrusion(70, 50, 10),
        CheckCodes.InAir => To(50, 50, 4) + Extrusion(60, 50, 10),
        CheckCodes.Duplicate => To(50, 50, 0.2) + Extrusion(100, 50, 50) + To(50, 50, 0.2) + Extrusion(100, 50, 50),
        CheckCodes.TooLow => To(50, 50, 0.01) + Extrusion(70, 50, 20),
        CheckCodes.Blob => To(50, 50, 0.2) + Extrusion(70, 50, 20) + "G1 E6\n",
        CheckCodes.Squeezed => To(50, 50, 0.1) + Extrusion(70, 50, 20),
        CheckCodes.Width => To(50, 50, 0.2) + Extrusion(70, 50, 80),
        CheckCodes.Height => ";LAYER_CHANGE\n;Z:0.6\n;HEIGHT:0.6\n" + To(50, 50, 0.6) + Extrusion(60, 50, 50),
        CheckCodes.Gap => To(50, 50, 0.2) + Extrusion(60, 50, 10) + "G1 X60.5\n" + Extrusion(70, 50, 10),
        CheckCodes.FirstLayer => Wall(25),
        CheckCodes.TravelSpeed => "G1 X40\n",
        CheckCodes.Acceleration => "M204 S90000\n" + Extrusion(30, 10),
        CheckCodes.Raised => "M203 X900\n" + Extrusion(30, 10),
        CheckCodes.Tool => "T3\n" + Extrusion(30, 10),
        CheckCodes.NozzleTemperature => "M104 S500\n",
        CheckCodes.BedTemperature => "M140 S300\nM140 S0\n",
        CheckCodes.ChamberTemperature => "M141 S90\nM141 S0\n",
        CheckCodes.Stationary => "G1 E300\n",
        CheckCodes.Amount => "G1 X60 E-500\n",
        CheckCodes.Starved => Extrusion(30, 10) + "G1 X31 E-0.3\n" + Extrusion(50, 10),
        CheckCodes.ColdExtrusion => "M104 S50\n" + Extrusion(30, 10),
        CheckCodes.ExtrusionMode => string.Concat(Enumerable.Range(1, 20).Select(i => $"G1 X{10 + i} E{(i % 2 == 0 ? "-" : "")}0.1\n")),
        CheckCodes.UnsafeCommand => Extrusion(30, 10) + "M302 S0\n" + Extrusion(50, 10),
        CheckCodes.UnknownCommand => Extrusion(30, 10) + "MY_MACRO\n" + Extrusion(50, 10),
        CheckCodes.PauseCommand => Extrusion(30, 10) + "M600\n" + Extrusion(50, 10),
        CheckCodes.MachineCommand => Extrusion(30, 10) + "M42 P4 S1\n" + Extrusion(50, 10),
        CheckCodes.SettingCommand => Extrusion(30, 10) + "M500\n",
        _ => Extrusion(30, 10),
    };

    private static string Whole(string begin, string body) => begin + "G90\nM83\nG1 X10 Y10 Z0.2 F3000\n" + body + "M104 S0\n";

    private static string Extrusion(double x, double y, double length = 20) => Line($"G1 X{x:0.###} Y{y:0.###} E{length * PerMm:0.#####}\n");

    private static string To(double x, double y, double z) => Line($"G1 Z100\nG1 X{x:0.###} Y{y:0.###}\nG1 Z{z:0.###}\n");

    private static string Wall(double top)
    {
        var text = new StringBuilder(To(60, 50, 0.2));
        for (var k = 1; k <= (int)Math.Round(top / 0.2); k++) text.Append(Line($"G1 Z{0.2 * k:0.###}\n")).Append(Extrusion(k % 2 == 1 ? 80 : 60, 50));
        return text + "G1 Z100\n";
    }

    private static string Line(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
