using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Caterpillar.Tests;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

public class ViewTests : CliFixture
{
    private const string Code = "G28\nG90\nM83\nM109 S200\nG1 Z0.2 F600\n;LAYER:0\n;TYPE:WALL-OUTER\nG1 X10 Y10 F6000\nG1 X60 Y10 E2 F1200\nG1 X60 Y60 E2\n"
        + ";LAYER:1\nG1 Z0.4 F600\n;TYPE:FILL\nG1 X10 Y60 E2 F3000\nG1 X10 Y10 E2\n";

    [Test]
    public void What_is_not_GCode_is_refused_as_by_other_verbs()
    {
        File.WriteAllText("part.txt", Box(10, 10, 2));
        var (view, check) = (Run("view", "part.txt", "-o", "v.html"), Run("check", "part.txt"));
        Assert.That((view.Code, view.Messages), Is.EqualTo((1, check.Messages)));
        Assert.That(check.Messages, Does.Contain("gcode.not_gcode"));
        Assert.That(Files(), Is.EqualTo(new[] { "part.txt" }));
    }

    [Test]
    public void A_page_is_named_after_its_input()
    {
        File.WriteAllText("a.gcode", Code);
        Assert.That(Run("view", "a.gcode").Code, Is.Zero);
        Assert.That(File.ReadAllText("a.html"), Does.StartWith("<!DOCTYPE html>").And.Contain("a.gcode"));
    }

    [Test]
    public void Models_turtle_programs_and_curves_are_shown()
    {
        File.WriteAllText("box.stl", Box(20, 10, 2));
        File.WriteAllText("star.turtle", "start 100 100 0.2\nrepeat 5 [ forward 30; left 144 ]\n");
        File.WriteAllText("line.csv", "x,y,z\n10,10,0.2\n50,10,0.2\n");
        foreach (var file in new[] { "box.stl", "star.turtle", "line.csv" })
        {
            var run = Run("view", file);
            Assert.That(run.Code, Is.Zero, file + ": " + run.Messages);
        }
        Assert.That(Part("box.html", "modelData"), Is.Not.Empty);
        Assert.That(Part("star.html", "moveData"), Is.Not.Empty);
        Assert.That(Part("line.html", "gcodeData"), Is.Not.Empty);
    }

    [Test]
    public void The_closing_line_says_what_is_shown_and_designs_have_only_one()
    {
        File.WriteAllText("box.stl", Box(20, 10, 2));
        File.WriteAllText("star.turtle", "start 100 100 0.2\nrepeat 5 [ forward 30; left 144 ]\n");
        Assert.That(Run("view", "box.stl").Messages.Trim(), Does.Match(@"^box\.html: [0-9.]+ KB; box\.stl: 12 triangles$"));
        Assert.That(Run("view", "star.turtle").Messages.Trim(), Does.Match(@"^star\.html: [0-9.]+ KB; star\.turtle: .* mm of filament.*, about .* s$"));
    }

    [Test]
    public void A_packed_file_is_shown_with_its_lines()
    {
        File.WriteAllText("a.gcode", Code);
        using (var packed = new System.IO.Compression.GZipStream(File.Create("b.gcode.gz"), System.IO.Compression.CompressionLevel.Fastest))
            packed.Write(System.Text.Encoding.ASCII.GetBytes(Code));
        Run("view", "a.gcode", "-o", "a.html");
        Run("view", "b.gcode.gz", "-o", "b.html");
        Assert.That(Part("b.html", "gcodeData"), Is.EqualTo(Part("a.html", "gcodeData")).And.Not.Empty);
    }

    [Test]
    public void A_script_brings_the_page_and_its_element()
    {
        File.WriteAllText("a.gcode", Code);
        Run("view", "a.gcode", "-o", "a.html");
        Assert.That(Run("view", "a.gcode", "-o", "a.js").Code, Is.Zero);
        var text = File.ReadAllText("a.js");
        Assert.That(text, Has.All.LessThan('\x80'), "a page in another encoding reads it");
        Assert.That(text, Does.Contain("customElements.define").And.Contain("title = \"a.gcode\""));
        var page = Regex.Match(text, "page = (\"(?:[^\"\\\\]|\\\\.)*\");").Groups[1].Value;
        Assert.That(Newtonsoft.Json.JsonConvert.DeserializeObject<string>(page), Is.EqualTo(File.ReadAllText("a.html")));
        Assert.That(Run("view", "a.gcode", "-o", "a.js", "--open").Code, Is.EqualTo(2));
    }

    [Test]
    public void Findings_are_listed_for_a_named_printer()
    {
        File.WriteAllText("a.gcode", Code.Replace("X60", "X600"));
        Run("view", "a.gcode", "--printer", "generic");
        Assert.That(Part("a.html", "head"), Does.Contain("bed.outside"));
    }

    [Test]
    public void The_text_of_the_file_can_be_left_out()
    {
        File.WriteAllText("a.gcode", Code);
        Run("view", "a.gcode", "--no-gcode");
        Assert.That(Part("a.html", "gcodeData"), Is.Empty);
    }

    [Test]
    public void Wrong_usage_says_so()
    {
        File.WriteAllText("a.gcode", Code);
        Assert.That(Run("view", "a.gcode", "--serve", "--output", "a.html").Code, Is.EqualTo(2));
        Assert.That(Run("view", "-", "--serve").Code, Is.EqualTo(2));
        Assert.That(Run("view", "a.gcode", "--serve", "0").Code, Is.EqualTo(2));
        Assert.That(Run("view", "a.gcode", "-o", "a.png").Code, Is.EqualTo(2));
        Assert.That(Run("view", "none.gcode").Code, Is.EqualTo(1));
        Assert.That(Directory.GetFiles(".", "*.html"), Is.Empty);
    }

    [Test]
    public void The_page_works_in_a_browser_on_phone_and_desktop_by_keyboard_and_for_screen_readers()
    {
        const string Node = "/usr/bin/node";
        if (!File.Exists(Node)) Assert.Ignore("Skipped: no Node is installed, which drives the browser.");
        const string Change = "G0 X10 Y10\nG0 X60 Y60\n;COLOR_CHANGE,T0,#ABCDEF\nM600\n";
        File.WriteAllText("a.gcode", "; filament_colour = #123456\n" + Code.Replace(";LAYER:1\n", ";LAYER:1\n" + Change));
        Run("view", "a.gcode", "--printer", "generic");
        Run("view", "a.gcode", "-o", "a.js");
        var blocks = CodeBlock.OfManual().Where(b => b.Page == "viewer.md" && b.Language == "html").Select(b => b.Text);
        File.WriteAllText("host.html", "<!DOCTYPE html>" + string.Concat(blocks).Replace("bracket.js", "a.js"));
        var script = Path.Combine(TestData.Repository, "tests", "Caterpillar.Cli.Tests", "viewer.mjs");
        var start = new ProcessStartInfo(Node) { RedirectStandardOutput = true };
        string[] words = ["--experimental-websocket", "--no-warnings", script, Browser(), Path.GetFullPath("a.html"), Path.GetFullPath("host.html")];
        foreach (var word in words) start.ArgumentList.Add(word);
        using var process = Process.Start(start)!;
        var faults = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        Assert.That(faults, Is.Empty);
        Assert.That(process.ExitCode, Is.Zero);
    }

    private static string Part(string page, string id)
        => Regex.Match(File.ReadAllText(page), $"id=\"{id}\">(.*?)</script>", RegexOptions.Singleline).Groups[1].Value;

    private static string Browser()
    {
        var browser = new[] { "/usr/bin/chromium", "/usr/bin/google-chrome" }.FirstOrDefault(File.Exists);
        if (browser is null) Assert.Ignore("Skipped: no Chromium is installed, in which the page could be opened.");
        return browser!;
    }
}
