using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.Tests;
using Caterpillar.Tests.GCode;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

/// <summary>Files packed with gzip and binary G-code, intact and damaged.</summary>
public class PackedFileTests : CliFixture
{
    private const string Code = "G28\nG90\nM82\nG1 X10 Y10 Z0.2 F3000\nG1 X30 Y10 E1\nG1 X30 Y25 E2\n";

    [Test]
    public void Binary_files_are_read_by_every_verb()
    {
        File.WriteAllBytes("a.bgcode", Binary());
        var summary = Run("decode", "a.bgcode");
        Assert.That(summary.Code, Is.Zero, summary.Messages);
        Assert.That(summary.Text, Does.Contain("16x8 PNG, 2x4 QOI"));
        Assert.That(Run("decode", "a.bgcode", "--json").Text, Does.Contain("{\"width\": 2, \"height\": 4, \"format\": \"QOI\"}"));
        Assert.That(Run(Binary(), ["decode", "-", "--csv"]).Text, Is.EqualTo(Run("decode", "a.bgcode", "--csv").Text));
        Assert.That(Run("convert", "a.bgcode", "-o", "a.gcode").Code, Is.Zero);
        Assert.That(File.ReadAllText("a.gcode"), Does.StartWith("; printer_model = MK4\n\n;\n; thumbnail begin 16x8 4\n; AQID\n").And.Contain(Code));
        foreach (var verb in new[] { "check", "image" }) Assert.That(Run(verb, "a.bgcode").Code, Is.Zero, verb);
    }

    [Test]
    public void Files_that_are_cut_off_are_errors_in_every_verb()
    {
        File.WriteAllText("part.stl", Box(20, 10, 2));
        var files = new (string Name, byte[] Bytes)[]
        {
            ("a.gcode.gz", Gzip.Packed(Encoding.ASCII.GetBytes(Code))),
            ("a.bgcode", Binary()),
            ("b.bgcode.gz", Gzip.Packed(Binary())),
            ("part.stl.gz", Gzip.Packed(File.ReadAllBytes("part.stl"))),
        };
        foreach (var (name, bytes) in files)
        {
            foreach (var missing in new[] { 1, 8, 9, 20, bytes.Length - 12 })
            {
                File.WriteAllBytes(name, bytes.Take(bytes.Length - missing).ToArray());
                var verbs = name.StartsWith('p') ? ["slice", "sections"] : new[] { "decode", "check", "convert", "image" };
                foreach (var verb in verbs)
                {
                    var run = Run(verb == "sections" ? [verb, name, "--heights", "1", "--json"] : verb is "convert" or "slice" ? [verb, name, "-o", "out"]
                        : [verb, name]);
                    Assert.That(run.Code, Is.EqualTo(1), $"{verb} {name} -{missing}");
                    Assert.That(run.Messages, Does.Contain(name).And.Contain("cut off"), verb);
                    Assert.That(run.Output, Is.Empty);
                    Assert.That(File.Exists("out"), Is.False);
                }
            }
        }
    }

    [Test]
    public void Bytes_after_the_end_are_reported_and_ignored()
    {
        File.WriteAllBytes("a.gcode.gz", [.. Gzip.Packed(Encoding.ASCII.GetBytes(Code)), 1, 2, 3]);
        foreach (var words in new[] { ["decode", "a.gcode.gz"], ["check", "a.gcode.gz"], new[] { "convert", "a.gcode.gz", "-o", "b.gcode" } })
        {
            var run = Run(words);
            Assert.That(run.Code, Is.Zero, run.Messages);
            Assert.That(run.Messages, Does.Contain("followed by other bytes"), words[0]);
        }
        Assert.That(File.ReadAllText("b.gcode"), Is.EqualTo(Code));
    }

    [Test]
    public void A_name_that_ends_in_bgcode_requests_binary_code()
    {
        File.WriteAllText("a.gcode", Code);
        Assert.That(Run("convert", "a.gcode", "-o", "a.bgcode").Code, Is.Zero);
        Assert.That(File.ReadAllText("a.bgcode"), Does.StartWith("GCDE"));
        Assert.That(Run("decode", "a.bgcode", "--csv").Text.Split('\n').Select(l => l.Split(',').Skip(2)),
            Is.EqualTo(Run("decode", "a.gcode", "--csv").Text.Split('\n').Select(l => l.Split(',').Skip(2))));
        Assert.That(Run("convert", "a.bgcode", "-o", "b.gcode").Code, Is.Zero);
        Assert.That(File.ReadAllText("b.gcode"), Is.EqualTo("\n" + Code));
        File.WriteAllText("part.stl", Box(20, 10, 2));
        Assert.That(Run("slice", "part.stl", "-o", "part.gcode").Code, Is.Zero);
        Assert.That(Run("slice", "part.stl", "-o", "part.bgcode").Code, Is.Zero);
        Assert.That(new FileInfo("part.bgcode").Length, Is.LessThan(new FileInfo("part.gcode").Length / 2));
        Assert.That(Run("decode", "part.bgcode", "--csv").Text.Split('\n').Select(l => l.Split(',').Skip(2)),
            Is.EqualTo(Run("decode", "part.gcode", "--csv").Text.Split('\n').Select(l => l.Split(',').Skip(2))));
        Assert.That(Files(), Is.EquivalentTo(new[] { "a.gcode", "a.bgcode", "b.gcode", "part.stl", "part.gcode", "part.bgcode" }));
    }

    private static byte[] Binary()
        => new BinaryFile().Table(BinaryFile.Printer, 0, "printer_model=MK4\n").ToolpathImage(0, 16, 8, [1, 2, 3]).ToolpathImage(2, 2, 4, [1]).Code(1, 0,
            Code).ToArray();
}
