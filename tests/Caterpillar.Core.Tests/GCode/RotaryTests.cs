using System;
using System.Linq;
using System.Text;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using Caterpillar.Tests.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>A, B and C as rotary axes.</summary>
public class RotaryTests
{
    [Test]
    public void Words_turn_axes_where_E_extrudes()
    {
        var toolpath = Decode("M83\nG1 X1 Y1 E1 F600\nG1 X5 E1 A30\nG1 X9 E1\nG1 A45 C-10\nG91\nG1 X1 E1 A5\nG90\nG92 A0\nG1 X3 E1 A1\n", "marlin2").Toolpath;
        Assert.That(Turns(toolpath), Is.EqualTo(new[] { (0.0, 0.0, 0.0), (30, 0, 0), (30, 0, 0), (45, 0, -10), (50, 0, -10), (51, 0, -10) }));
        var turning = toolpath[3];
        Assert.That((turning.Kind, turning.Length, turning.E), Is.EqualTo((MoveKind.Travel, 0.0, 0.0)));
    }

    [Test]
    public void Words_that_extrude_turn_nothing()
    {
        var decoding = Decode("G1 X1 Y1 A1 F600\nG1 X5 A2 C7\n", "cnc");
        Assert.That(decoding.Report.ExtrusionAxis, Is.EqualTo("A"));
        Assert.That(decoding.Toolpath.Blocks[0].Columns.Turns, Is.Null);
        var pen = Decode("G1 X1 Y1 A1 F600\nG1 X5 A2 C7\n", "grbl");
        Assert.That(pen.Report.ExtrusionAxis, Is.EqualTo("none"));
        Assert.That(Turns(pen.Toolpath), Is.EqualTo(new[] { (1.0, 0.0, 0.0), (2, 0, 7) }));
    }

    [Test]
    public void Files_without_such_words_have_no_columns()
        => Assert.That(Decode("M83\nG1 X1 Y1 E1 F600\nG1 X5 E1\n", "marlin2").Toolpath.Blocks[0].Columns.Turns, Is.Null);

    [Test]
    public void What_the_writer_turns_comes_back()
    {
        var random = new Random(5);
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        double a = 0, c = 0;
        // More than a block.
        for (var i = 0; i < 70_000; i++)
        {
            if (i > 10 && random.Next(3) == 0) a = Math.Floor(random.NextDouble() * 360_000) / 1000;
            if (i > 10 && random.Next(9) == 0) c -= 90;
            builder.Add(new Vec3(1 + i % 100, i / 1000, 0.3), random.Next(5) == 0 ? 0 : 0.1, 0.1, 30, MoveKind.Print, Role.Unspecified, -1, 0, i);
            builder.SetRotary(new Vec3(a, 0, c));
        }
        var toolpath = builder.Build([new ToolpathTool(null)]);
        var back = Decode(NewFile.Of(toolpath), "marlin2").Toolpath;
        Assert.That(back.Count, Is.EqualTo(toolpath.Count));
        Assert.That(Turns(back).SequenceEqual(Turns(toolpath)), Is.True);
    }

    [TestCase(true)]
    [TestCase(false)]
    public void Arcs_turn_axes_too(bool arcs)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(new Vec3(10, 0, 0), 0, 0, 30, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.SetRotary(Vec3.Zero);
        builder.Add(new Vec3(-10, 0, 0), 1, 1, 30, MoveKind.Print, Role.Unspecified, -1, 0, 0, new Arc(Vec3.Zero, 180));
        builder.SetRotary(new Vec3(90, 0, 0));
        var format = new GCodeFormat(NewFile.Machine with { Flavor = arcs ? FlavorTable.Marlin2 : NewFile.WithoutArcs(FlavorTable.Marlin2) });
        var back = Decode(NewFile.Of(builder.Build([new ToolpathTool(null)]), format), "marlin2").Toolpath;
        var turns = Turns(back).Select(t => t.A).ToArray();
        Assert.That(turns[turns.Length - 1], Is.EqualTo(90));
        if (!arcs) Assert.That(turns[turns.Length / 2], Is.EqualTo(45).Within(3), "chords share the turn");
    }

    [Test]
    public void Edits_and_conversions_keep_the_turns()
    {
        const string Text = "M83\nG90\nG1 X1 Y1 E1 F600\nG1 X5 E1 A30\nG91\nG1 X2 E1 A5\nG1 X2 E1 A5\nG90\nG1 X11 E1\nG1 X15 E1 A50\n";
        var decoding = Decode(Text, "marlin2");
        var cut = new MoveRemover(decoding.Toolpath, decoding.Toolpath.Moves().Select(m => m.Source == 6).ToMoveSet()).Run();
        var written = GCodeEditor.ToDocument(decoding, cut).Value!;
        var back = Decode(written.ToBytes(), "marlin2").Toolpath;
        var kept = cut.Moves().Where(m => m.Source >= 0).Select(m => Turns(cut)[m.Index].A);
        Assert.That(kept, Is.EqualTo(new[] { 0.0, 30, 40, 40, 50 }));
        Assert.That(Turns(back), Is.EqualTo(Turns(cut)), Encoding.ASCII.GetString(written.ToBytes()));
        var converted = GCodeConverter.ToDocument(decoding, new ConvertOptions { Flavor = FlavorTable.Find("cnc")!, RelativeE = false }).Value!;
        Assert.That(Turns(Decode(converted.ToBytes(), "cnc").Toolpath), Is.EqualTo(Turns(decoding.Toolpath)), "E stays E where A turns");
    }

    private static (double A, double B, double C)[] Turns(Toolpath toolpath)
        => toolpath.Blocks.SelectMany(b => Enumerable.Range(0, b.Count)
            .Select(i => { var (x, y, z) = b.Columns.TurnsAt(i, Vec3.Zero); return (x, y, z); })).ToArray();

    private static DecodedGCode Decode(string text, string flavor) => Decode(Encoding.ASCII.GetBytes(text), flavor);

    private static DecodedGCode Decode(byte[] bytes, string flavor)
        => GCodeDecoder.Decode(GCodeDocument.FromBytes(bytes), new DecodeOptions { Flavor = FlavorTable.Find(flavor) }).Value!;
}
