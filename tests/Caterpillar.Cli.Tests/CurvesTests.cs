using System;
using System.IO;
using System.Linq;
using System.Text;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

public class CurvesTests : CliFixture
{
    private const string Two = "x,y,z\n100,10,0.2\n140,10,0.2\n\n10,10,0.2\n50,10,0.2\n";

    [TestCase("", "X122.5")]
    [TestCase("--move 20,0", "X50")]
    public void Svg_drawings_are_printed_in_the_center_of_the_bed(string options, string x)
    {
        File.WriteAllText("page.svg", "<svg width='40mm' height='40mm' viewBox='0 0 40 40'><path d='M5 5L30 5L30 30'/></svg>");
        var run = Run(["curves", "page.svg", "-o", "page.gcode", .. options.Split(' ', StringSplitOptions.RemoveEmptyEntries)]);
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(Prints("page.gcode").First().Split(' ')[1], Is.EqualTo(x));
    }

    [Test]
    public void Curves_are_printed_in_their_order_unless_sorting_is_asked_for()
    {
        File.WriteAllText("lines.csv", Two);
        var run = Run("curves", "lines.csv", "--json");
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(Prints("lines.gcode").Select(l => l.Split(' ')[1]), Is.EqualTo(new[] { "X140", "X50" }));
        var report = JObject.Parse(run.Text);
        Assert.That(((double)report["printed_mm"]!, (int)report["curves"]!, (int)report["retractions"]!), Is.EqualTo((80.0, 2, 1)));
        Assert.That((long)report["bytes"]!, Is.EqualTo(new FileInfo("lines.gcode").Length));
        Run("curves", "lines.csv", "-o", "turned.gcode", "--sort", "orient");
        Assert.That(Prints("turned.gcode").Select(l => l.Split(' ')[1]), Is.EqualTo(new[] { "X140", "X10" }));
    }

    [Test]
    public void Percentages_and_shapes_set_the_extrusion()
    {
        File.WriteAllText("line.csv", "0,0,0.4\n100,0,0.4\n");
        Run("curves", "line.csv", "--move", "10,10", "--width", "200%", "--height", "0.4", "--shape", "rectangle", "--flow", "101.7%", "--speed", "20",
            "--set", "nozzle_diameter_mm=0.4");
        // The E per mm of the sample in the Caterpillar paper.
        var e = Prints("line.gcode").Single().Split(' ').Single(w => w[0] == 'E');
        Assert.That(double.Parse(e[1..], System.Globalization.CultureInfo.InvariantCulture) / 100, Is.EqualTo(0.1353).Within(1e-4));
    }

    [Test]
    public void A_coordinate_can_turn_the_platform()
    {
        File.WriteAllText("line.csv", "10,10,0.2\n40,10,0.2\n");
        var run = Run("curves", "line.csv", "--plan", "drawn", "--map", "X=A*2");
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(Prints("line.gcode").Single(), Does.StartWith("G1 A80 E"));
    }

    // Closing line, report, statistics and page say the same of a file: the purge line of the start code and what is extruded in place are material, too.
    [Test]
    public void Time_and_material_are_said_alike_everywhere()
    {
        File.WriteAllText("points.csv", "20,20,0.4\n60,20,0.4\n60,60,0.4\n");
        var made = Run("curves", "points.csv", "--dots", "2", "--printer", "prusa_mk3s", "--json");
        var simulated = JArray.Parse(Run("simulate", "points.gcode", "--printer", "prusa_mk3s", "--at", "100%", "--json").Text)[0];
        var volume = (double)simulated["volume_mm3"]!;
        Assert.That((double)JObject.Parse(made.Text)["deposited_mm3"]!, Is.EqualTo(volume).Within(1e-3).And.GreaterThan(6));
        var seconds = (double)simulated["time_s"]!;
        var viewed = Run("view", "points.gcode", "--printer", "prusa_mk3s").Messages;
        var said = $"{volume / (Math.PI / 4 * 1.75 * 1.75):0.0} mm of filament";
        foreach (var line in new[] { made.Messages, viewed })
        {
            Assert.That(line, Does.Contain(said));
            Assert.That(line, Does.Contain($"about {(int)(Math.Round(seconds) / 60)} min {Math.Round(seconds) % 60} s"));
        }
    }

    [Test]
    public void Points_become_dots_and_widths_step()
    {
        File.WriteAllText("points.csv", "20,20,0.4\n60,20,0.4\n60,60,0.4\n");
        var run = Run("curves", "points.csv", "--dots", "2", "--dot-speed", "1.5");
        Assert.That(run.Code, Is.Zero, run.Messages);
        var dots = File.ReadAllLines("points.gcode").Where(l => l.StartsWith("G1 E0.8315", StringComparison.Ordinal)).ToArray();
        Assert.That(dots.Select(d => d.Split(' ')[2]), Is.EqualTo(new[] { "F90", "F90", "F90" }), "2 mm³ of 1.75 mm filament at 1.5 mm/s");
        File.WriteAllText("wide.csv", "x,y,z,width\n20,20,0.2,0.4\n60,20,0.2,0.8\n60,60,0.2,0.4\n");
        Run("curves", "wide.csv", "--steps");
        Assert.That(Prints("wide.gcode"), Has.Length.EqualTo(2));
    }

    [Test]
    public void Pens_draw_arcs_without_extruding()
    {
        var svg = Encoding.ASCII.GetBytes("<svg width='100mm' height='100mm' viewBox='0 0 100 100'><circle cx='50' cy='50' r='20'/></svg>");
        var run = Run(svg, ["curves", "-", "--printer", "pen_plotter", "--arcs", "--pen"]);
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(run.Text, Does.Contain("G2 X30 I-20 J0").Or.Contain("G3 X30 I-20 J0"));
        Assert.That(run.Text, Does.Not.Contain(" E"));
    }

    // A circle of 20 mm radius has a sagitta of 1.1 mm where a chord turns by 38.2 degrees.
    [TestCase("--tolerance", "1.1", 10)]
    [TestCase("--angle", "42", 9)]
    [TestCase("--distance", "28", 5)]
    public void Curved_parts_are_divided_as_one_option_asks(string option, string value, int segments)
    {
        File.WriteAllText("circle.svg", "<svg width='100mm' height='100mm' viewBox='0 0 100 100'><circle cx='50' cy='50' r='20'/></svg>");
        Run("curves", "circle.svg", option, value);
        Assert.That(Prints("circle.gcode"), Has.Length.EqualTo(segments));
    }

    [TestCase("--map", "X=Y*2")]
    [TestCase("--map", "X*2")]
    [TestCase("--width", "thick")]
    [TestCase("--tolerance", "-1")]
    [TestCase("--sort", "random")]
    [TestCase("--move", "1")]
    [TestCase("--min-length", "2", "--max-length", "1")]
    [TestCase("--json", "-o", "-")]
    public void Wrong_usage_is_reported_and_does_nothing(params string[] words)
    {
        File.WriteAllText("lines.csv", Two);
        var run = Run(["curves", "lines.csv", .. words]);
        Assert.That((run.Code, run.Text), Is.EqualTo((2, "")), run.Messages);
        Assert.That(Files(), Is.EqualTo(new[] { "lines.csv" }));
    }

    [Test]
    public void Bad_curves_are_named_with_line_and_column()
    {
        File.WriteAllText("bad.csv", "x,y\n1,2\n1,nan\n");
        var run = Run("curves", "bad.csv");
        Assert.That(run.Code, Is.EqualTo(1));
        Assert.That(run.Messages, Does.StartWith("bad.csv:3:3: error curves.not_finite"));
        Assert.That(Files(), Is.EqualTo(new[] { "bad.csv" }));
    }

    [Test]
    public void Files_too_large_and_curves_off_the_bed_are_refused()
    {
        File.WriteAllText("lines.csv", Two);
        Assert.That(Run("curves", "lines.csv", "--max-size", "0.0001").Code, Is.EqualTo(3));
        Assert.That(Run("curves", "lines.csv", "--move", "-50,0").Code, Is.EqualTo(3));
        Assert.That(Files(), Is.EqualTo(new[] { "lines.csv" }));
        Assert.That(Run("curves", "lines.csv", "--move", "-50,0", "--override", "the bed is longer").Code, Is.Zero);
    }

    private static string[] Prints(string file) => File.ReadLines(file)
        .SkipWhile(l => !l.StartsWith("M83", StringComparison.Ordinal)).Skip(1).SkipWhile(l => !l.StartsWith("M83", StringComparison.Ordinal))
        .Where(l => l.StartsWith("G1 ", StringComparison.Ordinal) && l.Contains(" E") && !l.StartsWith("G1 E", StringComparison.Ordinal)).ToArray();
}
