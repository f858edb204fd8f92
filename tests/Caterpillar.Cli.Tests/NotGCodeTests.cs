using System.IO;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

/// <summary>What is no G-code is bad input wherever G-code is read.</summary>
public class NotGCodeTests : CliFixture
{
    [TestCase("decode", "m.stl")]
    [TestCase("image", "m.stl", "-o", "m.png")]
    [TestCase("check", "m.stl")]
    [TestCase("simulate", "m.stl")]
    [TestCase("convert", "m.stl", "-o", "m.gcode", "--e-mode", "relative")]
    [TestCase("printers", "--import", "m.stl", "-", "-o", "p.json")]
    public void A_mesh_is_refused_and_named(params string[] arguments)
    {
        File.WriteAllText("m.stl", "solid m\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid m\n");
        var run = Run(arguments);
        Assert.That(run.Code, Is.EqualTo(1), run.Messages);
        Assert.That(run.Messages, Does.Contain("m.stl").And.Contain("gcode.not_gcode").And.Contain("ASCII STL").And.Length.LessThan(400));
        Assert.That(File.Exists("m.png") || File.Exists("m.gcode") || File.Exists("p.json"), Is.False);
    }

    [Test]
    public void An_empty_file_is_refused()
    {
        File.WriteAllText("e.gcode", "");
        var run = Run("decode", "e.gcode");
        Assert.That((run.Code, run.Output), Is.EqualTo((1, "")));
        Assert.That(run.Messages, Does.Contain("is empty"));
    }
}
