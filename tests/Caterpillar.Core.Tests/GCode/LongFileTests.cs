using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;
using Newtonsoft.Json;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>Moves and text that do not fit into memory are kept in a file. Nothing else changes.</summary>
public class LongFileTests
{
    // So little that almost nothing stays in memory.
    private static readonly MemoryLimit Least = new(1);

    private static readonly Dictionary<string, FileEdits> Edits = new()
    {
        ["speed"] = new FileEdits { Speed = 0.9 },
        ["flow"] = new FileEdits { Flow = 1.1 },
        ["move"] = new FileEdits { Move = new Vec3(1, 2) },
        ["scale"] = new FileEdits { Scale = new Vec3(0.5, 0.5, 0.5) },
        ["pause"] = new FileEdits { PauseAtLayers = [2] },
        ["remove"] = new FileEdits { Remove = true, Filter = new MoveFilter { FirstLayer = 3, LastLayer = 4 } },
    };

    private static readonly FileEdits[] Followable =
    [
        new() { Speed = 0.9 }, new() { Move = new Vec3(10, -5.25) }, new() { Speed = 1.5, Move = new Vec3(0.125, 300) }, new() { Flow = 1.1, Speed = 2 },
        new() { Scale = new Vec3(0.5, 0.5, 0.5) }, new() { Rotate = 30, Move = new Vec3(3, 4) },
        new() { Scale = new Vec3(2, 0.75, 1.5), Flow = 0.9, Rotate = 90 },
    ];

    [TestCaseSource(typeof(GCodeFiles), nameof(GCodeFiles.Chosen))]
    public void A_file_has_the_same_moves(string file)
    {
        var bytes = GCodeFiles.Bytes(file);
        var (whole, parts) = (GCodeDecoder.Decode(bytes).Value!, InParts(bytes));
        AssertSame(whole.Toolpath, parts.Toolpath);
        Assert.That(parts.Report.ToJson(), Is.EqualTo(whole.Report.ToJson()));
        Assert.That(parts.Document!.ToBytes().SequenceEqual(whole.Document!.ToBytes()), Is.True);
    }

    [Test]
    public void Random_programs_have_the_same_moves()
    {
        FlavorRules[] flavors = [.. FlavorTable.All.Where(f => f.ExtruderLetters.Length > 0)];
        for (var seed = 0; seed < 200; seed++)
        {
            var random = new Random(seed);
            var bytes = Encoding.UTF8.GetBytes(RandomProgram.Text(random, flavors[random.Next(flavors.Length)]));
            AssertSame(GCodeDecoder.Decode(bytes).Value!.Toolpath, InParts(bytes).Toolpath);
        }
    }

    [TestCase("hand_arcs_helix_planes.gcode")]
    [TestCase("cu_tube_spiralize.gcode", Category = "Arithmetic")]
    [TestCase("ps_overlap_two_tools.gcode", Category = "Arithmetic")]
    public void Edits_and_conversions_write_the_same_bytes(string file)
    {
        var bytes = GCodeFiles.Bytes(file);
        var (whole, parts) = (GCodeDecoder.Decode(bytes).Value!, InParts(bytes));
        foreach (var edit in Edits)
        {
            var expected = new FileJob(whole).Edit(edit.Value).Value;
            Assert.That(Written(new FileJob(parts).Edit(edit.Value).Value), Is.EqualTo(Written(expected)), edit.Key);
        }
        ConvertOptions[] targets = [new() { RelativeE = true }, new() { DecimalsXyz = 2 }, new() { ExpandArcs = true }];
        foreach (var target in targets)
            Assert.That(Written(new FileJob(parts) { Target = target }), Is.EqualTo(Written(new FileJob(whole) { Target = target })), target.ToString());
    }

    [TestCaseSource(typeof(GCodeFiles), nameof(GCodeFiles.Chosen))]
    public void A_notation_changes_while_a_file_is_decoded_as_it_does_afterwards(string file)
    {
        var bytes = GCodeFiles.Bytes(file);
        ConvertOptions[] targets = [new() { RelativeE = true }, new() { DecimalsXyz = 2, DecimalsE = 3 }, new() { RelativeE = false, ExpandArcs = true }];
        var target = targets[GCodeFiles.NumberOf(file) % targets.Length];
        using var stream = new MemoryStream();
        var converted = GCodeConverter.WhileDecoding(
            options => GCodeDecoder.DecodeStream(new MemoryStream(bytes), options).Value!, new DecodeOptions(), target, stream);
        var expected = Written(new FileJob(GCodeDecoder.Decode(bytes).Value!) { Target = target });
        Assert.That(converted.Value is null, Is.EqualTo(expected is null));
        if (expected is not null) Assert.That(stream.ToArray().SequenceEqual(expected), Is.True);
    }

    [TestCaseSource(typeof(GCodeFiles), nameof(GCodeFiles.Chosen))]
    public void Speeds_and_places_change_while_a_file_is_decoded_as_they_do_afterwards(string file)
        => AssertFollowed(GCodeFiles.Bytes(file), Followable[GCodeFiles.NumberOf(file) % Followable.Length]);

    [Test]
    [Category("Arithmetic")]
    public void The_same_holds_for_random_programs_of_many_blocks()
    {
        FlavorRules[] flavors = [.. FlavorTable.All.Where(f => f.ExtruderLetters.Length > 0)];
        for (var seed = 0; seed < 6; seed++)
        {
            var random = new Random(seed);
            var text = RandomProgram.Text(random, flavors[random.Next(flavors.Length)], 1500);
            AssertFollowed(Encoding.UTF8.GetBytes(text), Followable[seed % Followable.Length]);
        }
    }

    [TestCase("G28\nG1 X5 Y5\nG1 E2\n;LAYER:0\nG1 X9 Y9 F600\nG1 E1\nG1 X1 E1\nG1 E-1\nG28 X Y\nG1 X2\nG1 E1\nG1 X9 E1\nG1 E-1\nG1 Z9\nG1 X0\n")]
    [TestCase("G1 X1 Y1 E1\n;LAYER:0\nG1 X9 E1\nG2 X5 Y5 I1 J1\nG3 X9 Y1 I1 J1 E1\nG0 X3 A90\nG1 X7 E1\nG1 E-1\nG1 E1\nG2 X1 Y1 I-3 J0\nM84\n")]
    [TestCase("G1 X1 Y1 Z0.2\n;LAYER:0\nG1 X9\nG1 X1\n;LAYER:1\nG1 Y9 F900\nG4 P1\n")]
    public void The_same_holds_for_travels_at_both_ends(string text)
    {
        foreach (var edits in Followable) AssertFollowed(Encoding.ASCII.GetBytes(text), edits);
    }

    [Test]
    public void Comments_about_heights_and_widths_are_scaled_while_a_file_is_decoded_as_they_are_afterwards()
    {
        // Two blocks of moves: before the first layer more than one, so that its layers by height are forgotten, then two layers, the second without height.
        var text = new StringBuilder("M83\nG1 X1 Y1 Z0.3 F900\n");
        void Print(int count)
        {
            for (var i = 0; i < count; i++) text.Append("G1 X").Append(i % 2 * 30 + count % 10).Append(" E1\n");
        }
        Print(4200);
        text.Append(";LAYER:0\n;Z:0.2\n;HEIGHT:0.2\n;WIDTH:0.4\nG1 X100 Y80 Z0.2\n");
        Print(3989);
        text.Append(";LAYER:1\nG1 X150 Z0 E1\n;Z:5\n");
        // More than a chunk between the blocks.
        text.Append(string.Concat(Enumerable.Repeat("; " + new string('-', 98) + "\n", 2 * GCodeChunk.Target / 100))).Append(";WIDTH:0.4\n");
        Print(5);
        var bytes = Encoding.ASCII.GetBytes(text.ToString());
        Assert.That(GCodeDecoder.Decode(bytes).Value!.Toolpath.Count, Is.EqualTo(2 * ToolpathBlock.FollowedSize + 5));
        foreach (var edits in Followable) AssertFollowed(bytes, edits);
    }

    [TestCase("G1 X1 Y1 E1\n", false)]
    [TestCase(";LAYER:0\nG1 X1 Y1 E1\n", true)]
    [TestCase("EXCLUDE_OBJECT_DEFINE NAME=a CENTER=1,1\n;LAYER:0\nG1 X1 Y1 E1\n", false)]
    [TestCase("; continues_at_z_mm = 5\n;LAYER:0\nG1 X1 Y1 E1\n", false)]
    public void A_print_is_moved_while_it_is_decoded_where_its_beginning_says_all_that_must_be_known(string text, bool can)
    {
        var head = GCodeDecoder.Decode(Encoding.ASCII.GetBytes(text)).Value!;
        Assert.That(new FileEdits { Move = new Vec3(1, 2) }.CanFollow(head), Is.EqualTo(can));
        Assert.That(new FileEdits { Move = new Vec3(1, 2, 3) }.CanFollow(head), Is.False);
        Assert.That(new FileEdits { Scale = new Vec3(2, 2, 2) }.CanFollow(head), Is.EqualTo(can));
        Assert.That(new FileEdits { Scale = new Vec3(2, 2, 2), Move = new Vec3(1, 2) }.CanFollow(head), Is.False);
        Assert.That(new FileEdits { Speed = 2 }.CanFollow(head), Is.EqualTo(text[0] != 'G'));
        Assert.That(new FileEdits { Speed = 2, Filter = new MoveFilter { Tool = 0 } }.CanFollow(head), Is.False);
    }

    [TestCase("cu_overlap_bfb_M101.gcode")]
    [TestCase("s3r_nested_smoothie_volE_fwr.gcode")]
    public void Checks_find_the_same(string file)
    {
        var bytes = GCodeFiles.Bytes(file);
        var setup = new PrintSetup();
        Assert.That(PrintCheck.Run(InParts(bytes), setup).Select(d => d.ToString()),
            Is.EqualTo(PrintCheck.Run(GCodeDecoder.Decode(bytes).Value!, setup).Select(d => d.ToString())));
    }

    [TestCase("ps_plate_smoothie_volE_fwr.gcode")]
    [TestCase("hand_arcs_ij_r.gcode")]
    [TestCase("ps_overlap_two_tools.gcode")]
    public void Statistics_of_blocks_of_any_size_are_those_of_the_timeline(string file)
    {
        var toolpath = GCodeDecoder.Decode(GCodeFiles.Bytes(file)).Value!.Toolpath;
        foreach (var cornering in (Cornering[])Enum.GetValues(typeof(Cornering)))
        {
            var setup = new PrintSetup { Printer = new Printer { Cornering = cornering, NozzleHeating = 2, BedHeating = 0.5 } };
            var expected = JsonConvert.SerializeObject(PrintStatistics.Of(Timeline.Of(toolpath, setup)));
            foreach (var size in new[] { 1, 7, 1000, ToolpathBlock.Capacity })
                Assert.That(JsonConvert.SerializeObject(PrintStatistics.Of(Cut(toolpath, size), setup)), Is.EqualTo(expected), $"{cornering} {size}");
        }
    }

    private static void AssertFollowed(byte[] bytes, FileEdits edits)
    {
        var whole = GCodeDecoder.Decode(bytes).Value!;
        if (!edits.CanFollow(whole)) return;
        var edited = edits.Apply(whole.Toolpath).Value!;
        DecodedGCode? before = null;
        DecodedGCode Decoded(DecodeOptions options) => GCodeDecoder.DecodeStream(new MemoryStream(bytes), options).Value!;
        if (edits.IsCentered)
        {
            var sums = new ToolpathSums { OnlyLayers = true };
            before = Decoded(new DecodeOptions { KeepsMoves = false, Take = _ => { }, Sums = sums });
            // Only a file that prints nothing in its layers is left to the other way of editing.
            var prints = whole.Toolpath.Moves().Any(m => m.Kind == MoveKind.Print && m.Layer >= 0);
            Assert.That(before.LayerNumbers is not null, Is.EqualTo(prints));
            if (!prints) return;
            edits = edits with { Center = FileEdits.Foot(sums.ToTotals(before.Toolpath.Tools).PrintBounds) };
        }
        var after = before is null ? null : edits.Apply(before.Toolpath).Value;
        using var stream = new MemoryStream();
        var (parts, atOnce) = (PrintCheck.OnBedInParts(whole, before?.Toolpath ?? edited, default), PrintCheck.OnBedInParts(whole, edited, default));
        var editor = new FollowingEditor((part, position) => parts.Take(edits.ApplyTo(part, position).With(layers: edited.Layers)), before, after);
        var followed = GCodeConverter.WhileDecoding(Decoded, new DecodeOptions(), null, stream, editor);
        Assert.That(followed.Value!.Toolpath.Count, Is.Zero);
        Assert.That(Encoding.UTF8.GetString(stream.ToArray()), Is.EqualTo(Encoding.UTF8.GetString(GCodeEditor.ToDocument(whole, edited).Value!.ToBytes())));
        Assert.That(editor.Difference, Is.EqualTo(ToolpathDifference.Of(whole.Toolpath, edited)));
        if (before is not null)
        {
            atOnce.Take(edited);
            Assert.That(parts.End().Select(d => (d.Code, d.Count)), Is.EqualTo(atOnce.End().Select(d => (d.Code, d.Count))));
            Assert.That(after!.Layers, Is.EqualTo(edited.Layers));
        }
        var (totals, expected) = (editor.Sums.ToTotals(edited.Tools), ToolpathTotals.Of(edited));
        Assert.That((totals.PrintMoves, totals.TravelMoves, totals.PrintBounds), Is.EqualTo((expected.PrintMoves, expected.TravelMoves, expected.PrintBounds)));
        Assert.That(totals.PrintLength, Is.EqualTo(expected.PrintLength).Within(1e-9).Percent);
        Assert.That(totals.DepositedE, Is.EqualTo(expected.DepositedE).Within(1e-9).Percent);
    }

    private static DecodedGCode InParts(byte[] bytes)
    {
        using var stream = new MemoryStream(bytes);
        var document = GCodeDocument.Read(stream, "", Least).Value!;
        // In small blocks, as for others who follow.
        return GCodeDecoder.Decode(document, new DecodeOptions { Memory = Least, Take = _ => { } }).Value!;
    }

    private static Toolpath Cut(Toolpath toolpath, int size)
    {
        var builder = new ToolpathBuilder(toolpath.Source, toolpath.Start) { Moves = new BlockCollector(size, size) };
        foreach (var block in toolpath.Blocks) builder.Add(block.Columns, 0, block.Count);
        return toolpath.With(builder.Build(toolpath.Tools).Blocks);
    }

    private static byte[]? Written(FileJob? job)
    {
        if (job is null) return null;
        using var stream = new MemoryStream();
        return job.Write(stream, "a.gcode", null, "a test").Value is null ? null : stream.ToArray();
    }

    private static void AssertSame(Toolpath a, Toolpath b)
    {
        Assert.That((b.Count, b.HasTurns, b.Start), Is.EqualTo((a.Count, a.HasTurns, a.Start)));
        Func<ToolpathColumns, double[]?>[] numbers = [c => c.X, c => c.Y, c => c.Z, c => c.E, c => c.Deposited, c => c.Speed];
        foreach (var column in numbers) AssertSame(a, b, (c, i) => column(c) is { } values ? BitConverter.DoubleToInt64Bits(values[i]) : 0);
        AssertSame(a, b, (c, i) => c.Turns?[i]);
        AssertSame(a, b, (c, i) => c.Kind[i]);
        AssertSame(a, b, (c, i) => c.Role[i]);
        AssertSame(a, b, (c, i) => c.Tool[i]);
        AssertSame(a, b, (c, i) => c.Layer[i]);
        AssertSame(a, b, (c, i) => c.Source[i]);
        AssertSame(a, b, (c, i) => c.TryGetArc(i, out var arc) ? arc : default);
    }

    private static void AssertSame<T>(Toolpath a, Toolpath b, Func<ToolpathColumns, int, T> value)
        => Assert.That(All(b, value).SequenceEqual(All(a, value)), Is.True);

    private static IEnumerable<T> All<T>(Toolpath toolpath, Func<ToolpathColumns, int, T> value)
    {
        foreach (var block in toolpath.Blocks)
        {
            var columns = block.Columns;
            for (var i = 0; i < columns.Count; i++) yield return value(columns, i);
        }
    }
}
