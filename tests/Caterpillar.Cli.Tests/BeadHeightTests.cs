using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

/// <summary>Extrusions of 0.2 mm need their height, whoever writes them.</summary>
public class BeadHeightTests : CliFixture
{
    // Parts of the height, and the code that is found.
    private static readonly (double Part, string Found)[] Parts =
        [(0, "error"), (0.05, "error"), (0.25, "error"), (0.5, "warning"), (0.75, ""), (1, "")];

    private static readonly string[] Writers =
        ["turtle", "turtle on a plate", "curves", "curves on a plate", "curves on a layer", "slice on a plate", "convert", "convert in the text", "check"];

    [Test]
    public void An_extrusion_needs_its_height([ValueSource(nameof(Writers))] string writer, [ValueSource(nameof(Parts))] (double Part, string Found) gap)
    {
        File.WriteAllText("plate.stl", BoxAt(60, 60, 5, 80));
        File.WriteAllText("box.stl", BoxAt(20, 20, 3, 100));
        var (height, lower) = (0.2 * gap.Part, Text(0.2 * gap.Part - 0.2));
        var run = writer switch
        {
            "turtle" => Turtle(height),
            "turtle on a plate" => Turtle(height, "--onto", "plate.stl", "--plan", "printer"),
            "curves" => Curves("", height),
            "curves on a plate" => Curves("", height, "--onto", "plate.stl"),
            "curves on a layer" => Curves(Layer(), 0.2 + height),
            "slice on a plate" => Slice("--onto", "plate.stl", "--squeeze", Text(0.2 - height)),
            "convert" => Then("convert", "--printer", "generic", "--move", "0,0," + lower),
            "convert in the text" => Then("convert", "--move", "0,0," + lower),
            _ => Edited(height),
        };
        // Without layers, what is as high as a curve belongs to it, and only its length is in question.
        var expected = (writer, gap.Part) is ("curves on a layer", 0) ? "warning" : gap.Found;
        var text = run.Messages + (writer == "check" ? run.Text : "");
        var found = Regex.Match(text, @"(error|warning) (?:nozzle\.too_low|extrusion\.squeezed|extrusion\.duplicate)").Groups[1].Value;
        Assert.That(found, Is.EqualTo(expected), text);
        Assert.That(run.Code, expected == "error" ? Is.Not.Zero : Is.Zero, text);
    }

    private static string Text(double value) => Math.Round(value, 4).ToString(CultureInfo.InvariantCulture);

    private static CliRun Turtle(double z, params string[] options)
    {
        File.WriteAllText("line.turtle", $"start 100 100 {Text(z)}\nforward 30\nright 90\nforward 5\nright 90\nforward 30\n");
        return Run(["turtle", "line.turtle", "-o", "-", .. options]);
    }

    // A second curve, so that the drawing is not flat.
    private static CliRun Curves(string below, double z, params string[] options)
    {
        File.WriteAllText("lines.csv", $"x,y,z\n{below}100,104,{Text(z)}\n130,104,{Text(z)}\n\n85,130,{Text(z + 0.2)}\n85,130.001,{Text(z + 0.2)}\n");
        return Run(["curves", "lines.csv", "-o", "-", .. options]);
    }

    private static string Layer()
        => string.Concat(Enumerable.Range(0, 20).Select(k => $"100,{Text(100 + 0.4 * k)},0.2\n130,{Text(100 + 0.4 * k)},0.2\n\n"));

    private static CliRun Slice(params string[] options) => Run(["slice", "box.stl", "-o", "box.gcode", "--set", "first_layer_height_mm=0.2", .. options]);

    private static CliRun Then(string verb, params string[] options)
    {
        Assert.That(Slice().Code, Is.Zero);
        return Run([verb, "box.gcode", "-o", "-", .. options]);
    }

    // The height of the first layer, written by hand.
    private static CliRun Edited(double z)
    {
        Assert.That(Slice().Code, Is.Zero);
        File.WriteAllText("box.gcode", Regex.Replace(File.ReadAllText("box.gcode"), @"\bZ0?\.2(?=\s)", "Z" + Text(z)));
        return Run("check", "box.gcode");
    }
}
