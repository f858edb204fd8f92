using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.GCode;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>Decoding for the report alone keeps no moves and counts the same.</summary>
public class ReportAloneTests
{
    [Test]
    [Category("Arithmetic")]
    public void It_counts_the_same_in_a_file_of_many_blocks()
    {
        var text = new StringBuilder("M83\nM104 S200\n");
        for (var i = 0; i < 40_000; i++)
        {
            if (i % 5000 == 0) text.Append(";LAYER_CHANGE\nG1 Z").Append(i / 5000 * 2 + 2).Append(" F600\n");
            if (i % 700 == 0) text.Append("G1 E-0.8 F2100\nG0 X5 Y5 F9000\nG1 E0.8 F2100\n");
            if (i % 900 == 0) text.Append("G2 X5 Y5 I3 J0 E0.4\nG91\nG1 X1\nG90\n");
            text.Append("G1 X").Append(i % 90).Append(" Y").Append(i % 7).Append(" E0.031 F1800\n");
        }
        var whole = Decode(text.ToString(), new DecodeOptions());
        var alone = Decode(text.ToString(), new DecodeOptions { KeepsMoves = false });
        Assert.That(whole.Toolpath.Count, Is.GreaterThan(40_000));
        Assert.That(alone.Toolpath.Count, Is.Zero);
        Assert.That(alone.Report.ToJson(""), Is.EqualTo(whole.Report.ToJson("")));
        Assert.That(alone.Problems.Select(p => p.ToString()), Is.EqualTo(whole.Problems.Select(p => p.ToString())));
    }

    [Test]
    public void Moves_that_are_not_kept_are_added_up()
    {
        var text = new StringBuilder("M83\nG28\n;TYPE:Skirt\nG1 X1 Y1 Z0.2 E1 F600\nG0 X50 Y50\n");
        for (var i = 0; i < 12_000; i++)
        {
            if (i % 3000 == 0) text.Append(";LAYER_CHANGE\n;TYPE:Perimeter\nT").Append(i / 3000 % 2).Append("\nG1 Z").Append(i / 3000 + 1).Append('\n');
            if (i % 700 == 0) text.Append("G1 E-0.8 F2100\nG0 X5 Y5 F9000\nG1 E1 F2100\n");
            if (i % 900 == 0) text.Append("G2 X5 Y5 I3 J0 E0.4\n");
            text.Append("G1 X").Append(i % 90).Append(" Y").Append(i % 7).Append(" E0.031 F1800\n");
        }
        text.Append(";LAYER_CHANGE\nG0 Z90\n");
        var whole = Decode(text.ToString(), new DecodeOptions { FilamentDiameter = 1.75 });
        var sums = new ToolpathSums();
        var alone = Decode(text.ToString(), new DecodeOptions { FilamentDiameter = 1.75, KeepsMoves = false, Sums = sums });
        Assert.That(sums.ToTotals(alone.Toolpath.Tools), Is.EqualTo(ToolpathTotals.Of(whole.Toolpath)));
        Assert.That(ToolpathTotals.Of(whole.Toolpath).PrintMoves, Is.GreaterThan(2 * 4096));
        Assert.That((alone.Report.PrintedLayers, whole.Report.PrintedLayers, whole.Toolpath.CountLayers()), Is.EqualTo((4, 4, 4)));
    }

    [TestCase("G1 Z0.2\nG1 X1 E1\nG1 X9 Z0.4\nG1 X1 E1\nG1 Z0.2\nG1 X2 E1\n", 2)]
    [TestCase(";LAYER:0\nG1 X1\n;LAYER:1\nG1 X2\n", 2)]
    [TestCase(";LAYER:0\n;MESH:a\nG1 X1 E1\n;MESH:b\nG1 X2 E1\n", 1)]
    [TestCase("G28\n", 0)]
    public void Layers_are_counted_without_moves(string text, int layers)
    {
        var file = Decode("M83\n" + text, new DecodeOptions());
        Assert.That((file.Report.PrintedLayers, file.Toolpath.CountLayers()), Is.EqualTo((layers, layers)));
    }

    [Test]
    public void An_empty_file_has_an_empty_report()
        => Assert.That(Decode("", new DecodeOptions { KeepsMoves = false }).Report.ToJson(""), Is.EqualTo(Decode("", new DecodeOptions()).Report.ToJson("")));

    private static DecodedGCode Decode(string text, DecodeOptions options)
    {
        using var stream = new MemoryStream(Encoding.ASCII.GetBytes(text));
        return GCodeDecoder.DecodeStream(stream, options).Value!;
    }
}
