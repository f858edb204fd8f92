using System.IO;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

/// <summary>No verb may destroy what it reads, or write one kind of file under the name of another.</summary>
public class FileGuardTests : CliFixture
{
    private const string Program = "G90\nM83\nG1 X10 Y10 Z0.2 F3000\nG1 X20 E1 F1200\n";

    [TestCase("slice", "a.stl", "-o", "a.stl")]
    [TestCase("slice", "a.stl", "-o", "./sub/../a.stl")]
    [TestCase("sections", "a.stl", "--heights", "1", "-o", "a.stl")]
    [TestCase("image", "l.gcode", "-o", "l.gcode")]
    [TestCase("convert", "l.gcode", "-o", "l.gcode")]
    [TestCase("turtle", "s.turtle", "-o", "s.turtle")]
    [TestCase("curves", "c.csv", "-o", "c.csv")]
    [TestCase("slice", "a.stl", "-o", "link.gcode")]
    [TestCase("slice", "a.stl", "-o", "folder/a.gcode", "--printer", "a.gcode")]
    public void An_output_that_is_an_input_is_wrong_usage(params string[] words)
    {
        Directory.CreateDirectory("sub");
        File.WriteAllText("a.stl", Box(10, 10, 2));
        File.WriteAllText("l.gcode", Program);
        File.WriteAllText("a.gcode", Program);
        File.WriteAllText("s.turtle", "forward 10");
        File.WriteAllText("c.csv", "x,y\n0,0\n1,0\n");
        File.CreateSymbolicLink("link.gcode", "a.stl");
        Directory.CreateSymbolicLink("folder", ".");
        var before = File.ReadAllText(words[1]);
        var run = Run(words);
        Assert.That(run.Code, Is.EqualTo(2), run.Messages);
        Assert.That(run.Messages.Length, Is.LessThan(400));
        Assert.That(File.ReadAllText(words[1]), Is.EqualTo(before));
    }

    [TestCase("slice", "broken.stl", "-o", "none/a.gcode", "none/a.gcode: folder not found.")]
    [TestCase("turtle", "broken.turtle", "-o", "none/a.gcode", "none/a.gcode: folder not found.")]
    [TestCase("image", "broken.gcode", "-o", "none/a.png", "none/a.png: folder not found.")]
    [TestCase("view", "broken.gcode", "-o", "sub", "sub is a folder, not a file.")]
    public void A_folder_that_does_not_exist_is_said_before_the_work(string verb, string input, string option, string output, string message)
    {
        Directory.CreateDirectory("sub");
        File.WriteAllText(input, "\0");
        var run = Run(verb, input, option, output);
        Assert.That((run.Code, run.Messages.Trim()), Is.EqualTo((1, message)));
    }

    [TestCase("slice", "c.svg", "c.svg is a drawing. To print it, use \"caterpillar curves\".")]
    [TestCase("curves", "a.STL", "a.STL is a mesh. To print it, use \"caterpillar slice\".")]
    [TestCase("turtle", "a.3mf", "a.3mf is a mesh. To print it, use \"caterpillar slice\".")]
    [TestCase("slice", "s.turtle", "s.turtle is a turtle program. To print it, use \"caterpillar turtle\".")]
    [TestCase("curves", "l.gcode", "l.gcode is G-code. To print it, use \"caterpillar convert\".")]
    public void A_design_of_another_kind_is_wrong_usage_that_names_the_verb(string verb, string input, string message)
    {
        File.WriteAllText(input, "");
        var run = Run(verb, input, "-o", "out.gcode");
        Assert.That((run.Code, run.Messages.Trim()), Is.EqualTo((2, message)));
        Assert.That(Files(), Is.EqualTo(new[] { input }));
    }

    [TestCase("slice", "a.stl", "-o", "a.png")]
    [TestCase("slice", "a.stl", "-o", "b.stl")]
    [TestCase("image", "l.gcode", "-o", "m.gcode")]
    [TestCase("convert", "l.gcode", "-o", "m.gcode.gz")]
    [TestCase("printers", "ender3", "-o", "p.gcode")]
    public void A_name_of_another_kind_of_file_is_wrong_usage(params string[] words)
    {
        File.WriteAllText("a.stl", Box(10, 10, 2));
        File.WriteAllText("l.gcode", Program);
        var run = Run(words);
        Assert.That(run.Code, Is.EqualTo(2), run.Messages);
        Assert.That(run.Messages, Does.Contain(words[3]).And.Contain("extension"));
        Assert.That(File.Exists(words[3]), Is.False);
    }

    [Test]
    public void Convert_replaces_its_input_when_told()
    {
        File.WriteAllText("l.gcode", Program);
        Assert.That(Run("convert", "l.gcode", "--in-place", "--speed", "2").Code, Is.Zero);
        Assert.That(File.ReadAllText("l.gcode"), Does.Contain("F2400"));
    }

    [TestCase("convert", "l.gcode")]
    [TestCase("convert", "l.gcode", "--in-place", "-o", "m.gcode")]
    [TestCase("convert", "-", "--in-place")]
    public void Convert_wants_one_place_to_write(params string[] words)
    {
        File.WriteAllText("l.gcode", Program);
        Assert.That(Run(words).Code, Is.EqualTo(2));
        Assert.That(File.ReadAllText("l.gcode"), Is.EqualTo(Program));
    }
}
