using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>The fast path of the splicer writes byte for byte what the general path does.</summary>
public class PlainMovesTests
{
    [Category("Arithmetic")]
    [TestCaseSource(typeof(GCodeFiles), nameof(GCodeFiles.Chosen))]
    public void Files_are_converted_alike(string file)
    {
        var decoded = GCodeDecoder.Decode(GCodeFiles.Document(file)).Value!;
        foreach (var options in Rounds.InTurn(Conversions(), GCodeFiles.NumberOf(file), 1)) Compare(decoded, options);
    }

    [Category("Arithmetic")]
    [TestCaseSource(typeof(GCodeFiles), nameof(GCodeFiles.Chosen))]
    public void Files_are_edited_alike(string file)
    {
        var decoded = GCodeDecoder.Decode(GCodeFiles.Document(file)).Value!;
        foreach (var edit in Rounds.InTurn(Edits, GCodeFiles.NumberOf(file), 1)) Compare(decoded, edit(decoded.Toolpath));
    }

    [Test]
    public void Random_programs_are_written_alike()
    {
        for (var seed = 0; seed < Rounds.Of(quick: 300, full: 300, onMono: 100); seed++)
        {
            var random = new Random(seed);
            var decoded = GCodeDecoder.Decode(Encoding.ASCII.GetBytes(Program(random)), new DecodeOptions { Flavor = Flavor(random) }).Value!;
            Compare(decoded, Conversions().ElementAt(random.Next(8)));
            Compare(decoded, Edits[random.Next(6)](decoded.Toolpath));
        }
    }

    [Test]
    public void Most_lines_of_a_print_take_the_fast_path()
    {
        var text = "G90\nM82\nG92 E0\nG28\nG1 X0 Y0 Z0.2 F3000\n" + string.Concat(Enumerable.Range(1, 50).Select(i => $"G1 X{i} Y{i % 7} E{i * 3}\n"));
        var decoded = GCodeDecoder.Decode(Encoding.ASCII.GetBytes(text)).Value!;
        var relative = Text(GCodeConverter.ToDocument(decoded, new ConvertOptions { RelativeE = true }).Value!);
        Assert.That(relative, Does.EndWith("G1 X49 Y0 E3\nG1 X50 Y1 E3\n"));
        Assert.That(Text(GCodeEditor.ToDocument(decoded, decoded.Toolpath.Transform(Affine.Move(new Vec3(0.5, 0, 0)))).Value!),
            Does.EndWith("G1 X50.5 Y1 E150\n"));
    }

    [Test]
    [Category("Arithmetic")]
    public void The_number_of_threads_changes_no_byte()
    {
        var random = new Random(8);
        var text = new StringBuilder();
        while (text.Length < Rounds.Of(quick: 900_000, full: 2_000_000)) text.Append(Program(random));
        var decoded = GCodeDecoder.Decode(Encoding.ASCII.GetBytes(text.ToString())).Value!;
        var edits = new[] { decoded.Toolpath.Transform(Affine.Move(new Vec3(10, 5, 0))), decoded.Toolpath.ScaleSpeed(new MoveFilter { Tool = 1 }, 0.5) };
        foreach (var threads in new[] { 2, 5 })
        {
            Same(GCodeConverter.ToDocument(decoded, new ConvertOptions { RelativeE = true, Threads = 1 }).Value,
                GCodeConverter.ToDocument(decoded, new ConvertOptions { RelativeE = true, Threads = threads }).Value, "relative");
            foreach (var edited in edits) Same(GCodeEditor.ToDocument(decoded, edited, new EditOptions { Threads = 1 }).Value,
                GCodeEditor.ToDocument(decoded, edited, new EditOptions { Threads = threads }).Value, "edit");
        }
    }

    private static IEnumerable<ConvertOptions> Conversions() =>
    [
        new() { RelativeE = true }, new() { RelativeE = false }, new() { Flavor = FlavorTable.Klipper, FilamentDiameter = 1.75 },
        new() { Flavor = FlavorTable.Find("reprapfirmware")!, RelativeE = true, FilamentDiameter = 1.75 }, new() { ExpandArcs = true, RelativeE = false },
        new() { DecimalsXyz = 3, DecimalsE = 4 }, new() { DecimalsXyz = 2, DecimalsE = 3, DecimalsF = 0 }, new() { DecimalsF = 1, RelativeE = true },
    ];

    private static readonly Func<Toolpath, Toolpath>[] Edits =
    [
        t => t.Transform(Affine.Move(new Vec3(10, 5, 0))),
        t => t.Transform(Affine.Scale(1.01)),
        t => t.ScaleSpeed(MoveFilter.Prints, 0.9),
        t => t.ScaleFlow(MoveFilter.Prints, 1.07),
        t => t.Remove(new MoveFilter { FirstLayer = 1, LastLayer = 2 }),
        t => t.Insert(t.Count / 2, new PauseEvent()).ScaleFlow(new MoveFilter { Tool = 0 }, 0.5),
    ];

    private static void Compare(DecodedGCode decoded, ConvertOptions options)
        => Same(GCodeConverter.ToDocument(decoded, options, new EditOptions { GeneralPath = true }).Value, GCodeConverter.ToDocument(decoded, options).Value,
            options.ToString());

    private static void Compare(DecodedGCode decoded, Toolpath edited)
        => Same(GCodeEditor.ToDocument(decoded, edited, new EditOptions { GeneralPath = true }).Value,
            GCodeEditor.ToDocument(decoded, edited, new EditOptions()).Value,
            "edit");

    private static void Same(GCodeDocument? expected, GCodeDocument? actual, string what)
    {
        Assert.That(actual is null, Is.EqualTo(expected is null), what);
        if (expected is null) return;
        byte[] a = expected.ToBytes(), b = actual!.ToBytes();
        var at = 0;
        while (at < a.Length && at < b.Length && a[at] == b[at]) at++;
        if (at == a.Length && at == b.Length) return;
        string Near(byte[] bytes) => Encoding.ASCII.GetString(bytes, Math.Max(0, at - 80), Math.Min(bytes.Length, at + 80) - Math.Max(0, at - 80));
        Assert.Fail(what + ": expected …" + Near(a) + "… but was …" + Near(b) + "…");
    }

    private static string Text(GCodeDocument document) => Encoding.ASCII.GetString(document.ToBytes());

    private static FlavorRules Flavor(Random random)
        => new[] { FlavorTable.Marlin2, FlavorTable.Klipper, FlavorTable.Slicer, FlavorTable.Find("reprapfirmware")!, FlavorTable.Prusa }[random.Next(5)];

    private static string Program(Random random)
    {
        var text = new StringBuilder(random.Next(2) == 0 ? "G90\nM82\nG92 E0\n" : "G90\nM83\n");
        string[] others = ["G92 E0", "G92 X5", "M83", "M82", "G91", "G90", "T1", "T0", "M220 S50", "M220 S100", "M221 S90", "M221 S100", "; text", ";LAYER:1",
            ";Z:0.4", "G28", "M106 S9", "G20", "G21", "X5", "G1", "G1 F900", "G1 X1 X2", "G0 X+3", "G1 X1. Y.5", "G1 X-.5 E-1", "G1  X1", "G1 X1 ", "g1 x3 y4",
            "G1 X123456789", "G1 X1.1234567891 Y2", "G1 E3", "G1 E3", "G1 F0", "G1 X5;a", "G1 X6 E9 ; b", "G1 X1 (c) Y5", "G2 X5 Y5 I1 J1", "G1 X0.0000000001",
            "G1 X1e3", "N5 G1 X7", "G1 X5*7", "G10", "G11", "G4 P5"];
        var e = 0.0;
        for (var i = random.Next(5, 120); i > 0; i--)
        {
            if (random.Next(6) == 0)
            {
                text.Append(others[random.Next(others.Length)]);
            }
            else
            {
                text.Append(random.Next(4) == 0 ? "G0" : "G1");
                if (random.Next(3) > 0) text.Append(" X").Append(Number(random, 100));
                if (random.Next(3) > 0) text.Append(" Y").Append(Number(random, 100));
                if (random.Next(9) == 0) text.Append(" Z").Append(Number(random, 10));
                if (random.Next(3) > 0) text.Append(" E")
                    .Append((e += random.NextDouble()).ToString("0.#####", System.Globalization.CultureInfo.InvariantCulture));
                if (random.Next(6) == 0) text.Append(" F").Append(Number(random, 9000));
            }
            text.Append(random.Next(20) == 0 ? "\r\n" : "\n");
        }
        return text.ToString();
    }

    private static string Number(Random random, double limit)
        => ((random.NextDouble() - 0.1) * limit).ToString(new[] { "0", "0.#", "0.###", "0.000", ".##" }[random.Next(5)],
            System.Globalization.CultureInfo.InvariantCulture) is { Length: > 0 } and not "-" and var number ? number : "0";
}
