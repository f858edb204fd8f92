using System;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

public class AxisMappingTests
{
    [Test]
    public void A_coordinate_turns_the_platform_and_the_time_stays()
    {
        var mapping = new AxisMapping(PathAxis.X, OutputAxis.A, 360 / (Math.PI * 40), 5);
        var drawn = Toolpath();
        var mapped = mapping.Apply(drawn);
        var around = 20 / (40 * Math.PI) * 360;
        Assert.That(mapped.Blocks[0].Columns.Turns, Is.Not.Null);
        Assert.That(mapped.Blocks[0].Columns.Turns![1].X, Is.EqualTo(around).Within(1e-12));
        Assert.That(mapped[1].End, Is.EqualTo(new Vec3(5, 0, 1)));
        // Only the platform turns: degrees per second over the same two seconds.
        Assert.That(mapped[1].Speed, Is.EqualTo(around / 2).Within(1e-12));
        // Along Y and around: the remaining motion is along Y.
        Assert.That(mapped[2].Start.DistanceTo(mapped[2].End) / mapped[2].Speed, Is.EqualTo(5 / 10.0).Within(1e-12));
        Assert.That(mapped.Moves().Sum(m => m.E), Is.EqualTo(drawn.Moves().Sum(m => m.E)).Within(1e-12));
        Assert.That(mapped.Events, Has.Count.EqualTo(2));
        Assert.That(mapped.Events[0].Move, Is.EqualTo(1));
    }

    [TestCase("X=A*2.86", PathAxis.X, OutputAxis.A, 2.86, 0.0, "X=A*2.86")]
    [TestCase("y=c*-3@110.5", PathAxis.Y, OutputAxis.C, -3, 110.5, "Y=C*-3@110.5")]
    [TestCase("Y=Y*0.5", PathAxis.Y, OutputAxis.Y, 0.5, 0.0, "Y=Y*0.5")]
    public void Mappings_are_read_and_written_as_text(string text, PathAxis from, OutputAxis to, double scale, double hold, string written)
    {
        var mapping = AxisMapping.Parse(text)!;
        Assert.That(mapping, Is.EqualTo(new AxisMapping(from, to, scale, hold)));
        Assert.That(mapping.ToString(), Is.EqualTo(written));
    }

    [TestCase("")]
    [TestCase("X=A")]
    [TestCase("X=A*0")]
    [TestCase("X=Y*2")]
    [TestCase("W=A*2")]
    [TestCase("X=A*2@")]
    [TestCase("Y=Y*2@5")]
    [TestCase("X = A * 2")]
    public void Other_texts_are_no_mapping(string text) => Assert.That(AxisMapping.Parse(text), Is.Null);

    // Positions, kinds, amounts and speeds of random toolpaths, mapped and unrolled again.
    [TestCase("X=A*2.86@110")]
    [TestCase("Y=B*-5;X=X*0.5")]
    [TestCase("Z=C*3")]
    public void Unrolling_undoes_mapping(string texts)
    {
        var mappings = texts.Split(';').Select(t => AxisMapping.Parse(t)!).ToArray();
        var random = new Random(5);
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(10, 10, 1));
        var at = builder.Position;
        for (var i = 0; i < 300; i++)
        {
            var next = new Vec3(random.Next(2) * random.Next(200), random.Next(2) * random.Next(200), random.Next(2) * 5);
            if (random.Next(3) == 0) next = at with { X = next.X };
            if (random.Next(3) == 0) next = at with { Y = next.Y };
            var kind = next == at ? MoveKind.Prime : (MoveKind)random.Next(3);
            var e = kind == MoveKind.Travel ? 0 : kind == MoveKind.Wipe ? -0.5 : 1;
            builder.Add(next, e, Math.Max(e, 0), 5 + random.Next(100), kind, Role.Unspecified, -1, 0, i);
            at = next;
        }
        var drawn = builder.Build([new ToolpathTool(2)]);
        var mapped = mappings.Aggregate(drawn, (toolpath, mapping) => mapping.Apply(toolpath));
        var unrolled = AxisMapping.Unroll(mapped, mappings).Moves().ToArray();
        foreach (var move in drawn.Moves())
        {
            var back = unrolled[move.Index];
            Assert.That(back.End.DistanceTo(move.End), Is.LessThan(1e-9));
            Assert.That((back.Kind, back.E, back.Deposited), Is.EqualTo((move.Kind, move.E, move.Deposited)));
            if (move.Index > 0) Assert.That(back.Speed, Is.EqualTo(move.Speed).Within(1e-9 * move.Speed), $"{move}");
        }
        Assert.That(AxisMapping.Unroll(drawn, []), Is.SameAs(drawn));
    }

    // A line along the mapped axis is written, read back and checked on the unrolled surface, with the mapping of the file or of the printer.
    [Test]
    public void A_print_around_a_drum_is_the_print_of_the_unrolled_surface()
    {
        var bead = Bead.FromWidth(0.45, 0.3);
        PrintPath[] lines = [new([new Vec3(10, 50, 0.3), new Vec3(210, 50, 0.3)], bead), new([new Vec3(400, 60, 0.3), new Vec3(10, 70, 0.3)], bead)];
        var steps = lines.ToSteps();
        var flat = new PrintSetup();
        var drum = flat.With("axis_mappings=X=A*2.86@110").OrThrow();
        var job = PrintJob.Draw(steps, drum).OrThrow();
        using var memory = new MemoryStream();
        var written = job.Write(memory, "a.gcode");
        Assert.That(written.Diagnostics, Is.Empty);
        var text = Encoding.ASCII.GetString(memory.ToArray());
        Assert.That(text, Does.Contain("; axis_mappings = X=A*2.86@110\n").And.Contain("G1 A600.6 E"));
        var wide = flat with { Printer = flat.Printer with { BuildVolume = new Vec3(500, 500, 250) } };
        using var other = new MemoryStream();
        var plain = PrintJob.Draw(steps, wide).OrThrow().Write(other, "a.gcode").Value!;
        Assert.That(written.Value!.PrintTime, Is.EqualTo(plain.PrintTime).Within(0.1));
        foreach (var (file, setup) in new[] { (text, flat), (text.Replace("axis_mappings", "other"), drum) })
        {
            var decoded = GCodeDecoder.Decode(Encoding.ASCII.GetBytes(file), new DecodeOptions { FilamentDiameter = 1.75 }).OrThrow();
            Assert.That(PrintCheck.Run(decoded, setup).Where(d => d.Code != CheckCodes.NoHoming && d.Code != CheckCodes.NoHeating), Is.Empty);
            Assert.That(decoded.Unrolled(setup.Printer).Moves().Max(m => m.End.X), Is.EqualTo(400).Within(1e-3));
        }
    }

    [Test]
    public void Rotary_words_are_written_where_they_change()
    {
        var text = NewFile.Plain(new AxisMapping(PathAxis.X, OutputAxis.B, 2).Apply(Toolpath()));
        var lines = text.Split('\n').Where(l => l.StartsWith("G0", StringComparison.Ordinal) || l.StartsWith("G1", StringComparison.Ordinal)).ToArray();
        Assert.That(lines, Is.EqualTo(new[] { "G0 X0 Y0 Z1 F1800", "G1 B40 E1 F1200", "G1 Y4 B46 E.25 F480".Replace(" E.", " E0.") }));
    }

    [Test]
    public void A_linear_word_is_scaled_and_arcs_become_chords()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(5, 0));
        builder.Add(new Vec3(-5, 0), 2, 2, 10, MoveKind.Print, Role.Unspecified, -1, 0, 0, new Arc(Vec3.Zero, 180));
        var mapped = new AxisMapping(PathAxis.Y, OutputAxis.Y, 0.5).Apply(builder.Build([new ToolpathTool(1)]));
        Assert.That(mapped.Count, Is.GreaterThan(10));
        Assert.That(mapped.Moves().Max(m => m.End.Y), Is.EqualTo(2.5).Within(0.01));
        Assert.That(mapped.Moves().Sum(m => m.E), Is.EqualTo(2).Within(1e-12));
        Assert.That(mapped.Blocks[0].Columns.Turns, Is.Null);
    }

    [Test]
    public void Invalid_mappings_are_rejected()
    {
        Assert.That(() => new AxisMapping(PathAxis.X, OutputAxis.A, 0).Apply(Toolpath()), Throws.InvalidOperationException);
        Assert.That(() => new AxisMapping(PathAxis.X, OutputAxis.Y, 1).Apply(Toolpath()), Throws.InvalidOperationException);
    }

    private static Toolpath Toolpath()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, null);
        builder.Add(new Vec3(0, 0, 1), 0, 0, 30, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.AddEvent(new FanEvent(1));
        builder.Add(new Vec3(20, 0, 1), 1, 1, 10, MoveKind.Print, Role.Unspecified, -1, 0, 0);
        builder.Add(new Vec3(23, 4, 1), 0.25, 0.25, 10, MoveKind.Print, Role.Unspecified, -1, 0, 0);
        builder.AddEvent(new FanEvent(0));
        return builder.Build([new ToolpathTool(1)]);
    }
}
