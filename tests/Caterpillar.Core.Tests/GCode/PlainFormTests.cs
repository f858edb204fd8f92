using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>
/// Lines in the usual form, <c>G1 X1.5 Y2 E.03</c>, are read by a short cut, and extrusions that follow each other by another one. In lower case, <c>g1</c>,
/// the same lines take neither: bit by bit the moves must be those.
/// </summary>
[Category("Arithmetic")]
public class PlainFormTests
{
    private static readonly string[] Digits = ["", "0", "5", "12", "123", "1234", "99999999", "123456789", "00000012", "123456789012345", "1234567890123456"];

    [TestCaseSource(typeof(GCodeFiles), nameof(GCodeFiles.Affordable))]
    public void Every_file_reads_as_it_does_in_lower_case(string file)
    {
        var document = GCodeFiles.Document(file);
        var flavor = GCodeDecoder.Decode(document).Value!.Flavor;
        foreach (var rule in new[] { ExtrusionRule.Balance, ExtrusionRule.Rising }) HoldAgainstLowerCase(document.ToBytes(), flavor, rule);
    }

    [Test]
    public void Numbers_of_any_form_read_as_they_do_in_lower_case()
    {
        var random = new Random(11);
        for (var run = 0; run < 300; run++) HoldAgainstLowerCase(Encoding.ASCII.GetBytes(Program(random, 40)), FlavorTable.Find("marlin2")!,
            ExtrusionRule.Balance);
    }

    [Test]
    public void Any_bytes_read_as_they_do_in_lower_case()
    {
        var random = new Random(12);
        for (var run = 0; run < 1000; run++)
        {
            var bytes = Encoding.ASCII.GetBytes(Program(random, 12));
            for (var n = random.Next(1, 6); n > 0; n--) bytes[random.Next(bytes.Length)] = (byte)(random.Next(3) == 0 ? random.Next(256)
                : "0.- \n\r;XYE9"[random.Next(11)]);
            HoldAgainstLowerCase(bytes, FlavorTable.Find("marlin2")!, ExtrusionRule.Balance);
        }
    }

    /// <summary>Lines of motions with words in any order and numbers of any form, and now and then a line that changes the modes.</summary>
    internal static string Program(Random random, int lines)
    {
        var text = new StringBuilder(random.Next(2) == 0 ? "M83\n" : "M82\n");
        for (var i = 0; i < lines; i++)
        {
            if (random.Next(12) == 0)
            {
                text.Append(new[] { "G92 E0", "M83", "M82", "G91", "G90", "M221 S95", "G1 E-2", "G1 E2", ";TYPE:FILL", ";LAYER:3", ";LAYER_CHANGE", ";Z:0.4",
                    "M486 S1", "M486 S2", "G92 X5", "T1",
                    "" }[random.Next(17)]);
            }
            else
            {
                text.Append(random.Next(8) == 0 ? "G0" : "G1");
                if (random.Next(3) == 0)
                    foreach (var letter in "XYZEFAX".OrderBy(_ => random.Next()).Take(random.Next(1, 6))) text.Append(' ').Append(letter)
                        .Append(Number(random));
                else
                    text.Append(" X").Append(random.Next(200_000) / 1000m).Append(" Y").Append(random.Next(200_000) / 1000m).Append(" E")
                        .Append(random.Next(100_000) / 100_000m);
                if (random.Next(15) == 0) text.Append(new[] { " ", "  ", " ; end", ";x", "\t", " *5" }[random.Next(6)]);
            }
            text.Append(random.Next(30) == 0 ? "\r\n" : "\n");
        }
        if (random.Next(2) == 0) text.Length--;
        return text.ToString();
    }

    private static string Number(Random random)
    {
        var sign = new[] { "", "", "", "-", "+", "--" }[random.Next(6)];
        return sign + Digits[random.Next(Digits.Length)] + (random.Next(4) > 0 ? "." + Digits[random.Next(Digits.Length)] : "");
    }

    private static void HoldAgainstLowerCase(byte[] text, FlavorRules flavor, ExtrusionRule rule)
    {
        var options = new DecodeOptions { Flavor = flavor, Rule = rule, FilamentDiameter = 1.75, Threads = 1 };
        var fast = GCodeDecoder.Decode(text, options).Value!;
        var slow = GCodeDecoder.Decode(LowerCase(text), options).Value!;
        Assert.That(fast.Toolpath.Count, Is.EqualTo(slow.Toolpath.Count), () => Encoding.ASCII.GetString(text, 0, Math.Min(text.Length, 2000)));
        for (var i = 0; i < fast.Toolpath.Blocks.Count; i++)
            if (FirstDifference(fast.Toolpath.Blocks[i].Columns,
                slow.Toolpath.Blocks[i].Columns) is { } at) Assert.Fail($"Move {fast.Toolpath.FirstOf(i) + at}\n"
                + Encoding.ASCII.GetString(text, 0, Math.Min(text.Length, 2000)));
        Assert.That(fast.Toolpath.Layers, Is.EqualTo(slow.Toolpath.Layers));
        Assert.That(fast.Toolpath.Events, Is.EqualTo(slow.Toolpath.Events));
        Assert.That(Numbers(fast), Is.EqualTo(Numbers(slow)));
    }

    // Lengths of texts and notations differ.
    private static string Numbers(DecodedGCode decoded) => (decoded.Report with { Bytes = 0, Features = [] }).ToJson();

    // Also a line after which a CR alone ends the one before.
    private static byte[] LowerCase(byte[] text)
    {
        var copy = (byte[])text.Clone();
        for (var i = 0; i + 1 < copy.Length; i++)
        {
            if (copy[i] == 'G' && copy[i + 1] is (byte)'0' or (byte)'1' && (i == 0 || copy[i - 1] is (byte)'\n' or (byte)'\r')) copy[i] = (byte)'g';
        }
        return copy;
    }

    private static int? FirstDifference(ToolpathColumns a, ToolpathColumns b)
    {
        static long Bits(double value) => BitConverter.DoubleToInt64Bits(value);
        for (var i = 0; i < a.Count; i++)
        {
            var same = Bits(a.X[i]) == Bits(b.X[i]) && Bits(a.Y[i]) == Bits(b.Y[i]) && Bits(a.Z[i]) == Bits(b.Z[i]) && Bits(a.E[i]) == Bits(b.E[i])
                && Bits(a.Deposited[i]) == Bits(b.Deposited[i]) && Bits(a.Speed[i]) == Bits(b.Speed[i]) && a.Kind[i] == b.Kind[i] && a.Role[i] == b.Role[i]
                && a.Layer[i] == b.Layer[i] && a.Tool[i] == b.Tool[i] && a.Source[i] == b.Source[i];
            if (!same) return i;
        }
        return a.Count == b.Count ? null : a.Count;
    }
}
