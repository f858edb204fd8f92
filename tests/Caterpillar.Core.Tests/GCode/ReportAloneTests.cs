using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.GCode;
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
    public void An_empty_file_has_an_empty_report()
        => Assert.That(Decode("", new DecodeOptions { KeepsMoves = false }).Report.ToJson(""), Is.EqualTo(Decode("", new DecodeOptions()).Report.ToJson("")));

    private static DecodedGCode Decode(string text, DecodeOptions options)
    {
        using var stream = new MemoryStream(Encoding.ASCII.GetBytes(text));
        return GCodeDecoder.DecodeStream(stream, options).Value!;
    }
}
