using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>A file that was changed by hand after it was written, held against its plan.</summary>
public class PlanComparisonTests
{
    private static readonly PrintSetup Setup = SmallPrint.Setup(
        p => p with { ToolOffsets = new(Vec3.Zero, Vec3.Zero), ExtrusionMode = ExtrusionMode.Relative });

    // A unit of the last decimal of E may be missing for each tool; two of one tool may not.
    [TestCase(1, 0, 0)]
    [TestCase(2, 0, 1)]
    [TestCase(1, 1, 0)]
    [TestCase(0, 2, 1)]
    public void E_of_each_tool_may_stray_by_one_unit_of_its_last_decimal(int first, int second, int found)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(10, 10, 0.2));
        for (var i = 0; i < 4; i++) builder.Add(new Vec3(20 + 10 * i, 10, 0.2), 0.5, 0.5, 20, MoveKind.Print, Role.Unspecified, -1, i % 2, i);
        var plan = builder.Build([new ToolpathTool(SmallPrint.FilamentArea), new ToolpathTool(SmallPrint.FilamentArea)]);
        var list = Compare(plan, text =>
        {
            var lines = text.Split('\n');
            var extrusions = Enumerable.Range(0, lines.Length).Where(i => lines[i].Contains(" E0.5")).ToArray();
            for (var k = 0; k < 4; k++)
                if ((k % 2 == 0 ? first : second) > k / 2) lines[extrusions[k]] = lines[extrusions[k]].Replace("E0.5", "E0.50001");
            return string.Join("\n", lines);
        });
        Assert.That(list.Select(d => d.Code), Is.EqualTo(Enumerable.Repeat(CheckCodes.FileExtrusion, found)));
    }

    // A quarter circle the other way round ends at the same place, three quarters later.
    [TestCase(1)]
    [TestCase(2)]
    [TestCase(3)]
    public void An_arc_that_turns_the_other_way_is_found(int before)
    {
        var print = new SmallPrint(100, 100, 0.2);
        for (var i = 0; i < before; i++) print.Print(100 + 10 * (i + 1), 100, 0.2);
        var at = print.At;
        var plan = print.Arc(at.X + 10, at.Y + 10, 0.2, at + new Vec3(0, 10), 90, SmallPrint.Area).Build();
        Assert.That(Compare(plan, text => text), Is.Empty);
        var found = Compare(plan, text => text.Replace("G3 ", "G2 ")).Single();
        Assert.That((found.Code, found.Source!.Move), Is.EqualTo((CheckCodes.FilePosition, (int?)before)));
        Assert.That(found.Message, Is.EqualTo("The arc of this line is 47.12 mm long, but the plan has 15.71 mm."));
    }

    [Test]
    public void A_whole_circle_that_is_missing_is_found()
    {
        var plan = new SmallPrint(100, 100, 0.2).Print(110, 100, 0.2).Arc(110, 100, 0.2, new Vec3(110, 110, 0.2), 360, SmallPrint.Area).Build();
        var found = Compare(plan, text => string.Join("\n", text.Split('\n').Where(l => !l.StartsWith("G3", StringComparison.Ordinal)
            && !l.StartsWith("G2 ", StringComparison.Ordinal))));
        Assert.That(found.Select(d => d.Code), Has.Member(CheckCodes.FilePosition));
    }

    // The head stands in the wrong place while it primes.
    [Test]
    public void A_raw_line_that_moves_the_head_before_material_in_place_is_found()
    {
        var plan = new SmallPrint(10, 10, 0.2).Print(30, 10, 0.2).Event(new RawEvent("; mark")).Prime(1).Print(60, 10, 0.2).Build();
        Assert.That(Compare(plan, text => text), Is.Empty);
        var found = Compare(plan, text => text.Replace("; mark", "G1 X99 F6000"));
        Assert.That(found.Where(d => d.Code == CheckCodes.FilePosition).Select(d => d.Source!.Move), Is.EqualTo(new int?[] { 1 }));
    }

    [Test]
    public void Every_move_of_a_long_file_is_compared()
    {
        var print = new SmallPrint(10, 10, 0.2);
        for (var i = 1; i <= 70_000; i++) print.Print(i % 2 == 0 ? 10 : 11, 10, 0.2);
        var plan = print.Go(10, 10, 7.125).Build();
        Assert.That(plan.Blocks.Count, Is.GreaterThan(1));
        Assert.That(Compare(plan, text => text), Is.Empty);
        Assert.That(Compare(plan, text => text.Replace("Z7.125", "Z7.2")).Select(d => d.Source!.Move), Is.EqualTo(new int?[] { 70_000 }));
    }

    // The plan has more decimals than the file: it may stray by a unit and what rounding takes, not by 1.3 units.
    [TestCase(0.5, 0)]
    [TestCase(0.499997, 1)]
    public void E_may_not_stray_by_more_than_one_unit(double e, int found)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(10, 10, 0.2));
        builder.Add(new Vec3(20, 10, 0.2), e, e, 20, MoveKind.Print, Role.Unspecified, -1, 0, 0);
        var plan = builder.Build([new ToolpathTool(SmallPrint.FilamentArea)]);
        Assert.That(Compare(plan, text => text), Is.Empty);
        Assert.That(Compare(plan, text => text.Replace(" E0.5", " E0.50001")).Select(d => d.Code),
            Is.EqualTo(Enumerable.Repeat(CheckCodes.FileExtrusion, found)));
    }

    [Test]
    public void Material_that_is_missing_once_is_told_once()
    {
        var plan = new SmallPrint(10, 10, 0.2).Print(30, 10, 0.2).Print(60, 10, 0.2, 0.1).Print(90, 10, 0.2).Print(120, 10, 0.2).Build();
        var found = Compare(plan, text => System.Text.RegularExpressions.Regex.Replace(text, "(G1 X60[^\n]*?) E[0-9.]+", "$1")).Single();
        Assert.That((found.Code, found.Count, found.Source!.Move), Is.EqualTo((CheckCodes.FileExtrusion, 1, (int?)1)));
    }

    [TestCase("E-0.8", "E-0.5", "E changes by -0.5 in this line, but the plan has -0.8.")]
    [TestCase("E-0.8", "E-0.1234567", "E changes by -0.12346 in this line, but the plan has -0.8.")]
    [TestCase("E-0.8", "E-0.8", null)]
    public void A_retraction_of_another_length_is_found(string text, string instead, string? message)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(10, 10, 0.2));
        builder.Add(new Vec3(20, 10, 0.2), 0.5, 0.5, 20, MoveKind.Print, Role.Unspecified, -1, 0, 0);
        builder.Add(new Vec3(20, 10, 0.2), -0.8, 0, 20, MoveKind.Retract, Role.Unspecified, -1, 0, 1);
        builder.Add(new Vec3(40, 10, 0.2), 0, 0, 20, MoveKind.Travel, Role.Unspecified, -1, 0, 2);
        var found = Compare(builder.Build([new ToolpathTool(SmallPrint.FilamentArea)]), all => all.Replace(text, instead));
        Assert.That(found.Select(d => d.Message), Is.EqualTo(message is null ? Array.Empty<string>() : [message]));
    }

    // Whatever is changed by hand, in files with templates, arcs, events and retractions: pieces find what the whole file does, which Compare holds.
    [Test]
    public void Any_change_is_found_in_pieces_too()
    {
        var random = new Random(5);
        for (var run = 0; run < 60; run++)
        {
            var print = new SmallPrint(20, 20, 0.2);
            for (var i = 0; i < 30; i++) Add(print, random);
            Compare(print.Build(), text => Changed(text, random));
        }
    }

    private static void Add(SmallPrint print, Random random)
    {
        var at = print.At;
        switch (random.Next(8))
        {
            case 0:
                print.Event(new RawEvent(random.Next(2) == 0 ? "; nothing" : "G1 X50 Y50 F3000"));
                break;
            case 1:
                print.Prime(0.5);
                break;
            case 2:
                print.Arc(at.X + 10, at.Y + 10, at.Z, at + new Vec3(0, 10), 90, SmallPrint.Area);
                break;
            case 3:
                print.Go(random.Next(20, 100), random.Next(20, 100), at.Z + 0.2);
                break;
            default:
                print.Print(random.Next(20, 100), random.Next(20, 100), at.Z);
                break;
        }
    }

    private static string Changed(string text, Random random)
    {
        var lines = text.Split('\n');
        for (var n = random.Next(4); n > 0; n--)
        {
            var at = random.Next(lines.Length);
            lines[at] = random.Next(4) switch
            {
                0 => "",
                1 => lines[at].Replace('1', '2'),
                2 => "G92 X0 E0",
                _ => lines[random.Next(lines.Length)],
            };
        }
        return string.Join("\n", lines);
    }

    // The whole file at once, and piece by piece as it is read while it is written: the same is found.
    private static Diagnostic[] Compare(Toolpath plan, Func<string, string> change)
    {
        var (_, lines, text) = SmallPrint.Written(plan, Setup);
        var read = SmallPrint.Decode(Encoding.ASCII.GetBytes(change(text)), Setup).Toolpath;
        var format = SetupFormat.Of(Setup, plan).Value!;
        var findings = new Findings(Setup.Printer, read);
        new PlanComparison(plan, format, lines, findings).End(read, 0);
        var found = findings.ToList().ToArray();
        foreach (var size in plan.Count > 1000 ? new[] { 997 } : [1, 2, 3, 7])
        {
            var (pieces, growing) = (new Findings(Setup.Printer, read), new WrittenLines());
            var comparison = new PlanComparison(plan, format, growing, pieces);
            var written = 0;
            foreach (var piece in read.Blocks.SelectMany(b => Pieces(b.Columns, size)))
            {
                // The lines of moves are taken down as far as the piece goes, and not a move farther.
                for (; written < plan.Count && lines.OfMove(written).First <= piece.Source[piece.Count - 1]; written++)
                {
                    growing.BeginMove(written, lines.OfMove(written).First - 1);
                    growing.EndMove(written, lines.OfMove(written).Last);
                }
                comparison.Take(piece, read.Start);
            }
            for (; written < plan.Count; written++)
            {
                growing.BeginMove(written, lines.OfMove(written).First - 1);
                growing.EndMove(written, lines.OfMove(written).Last);
            }
            comparison.End(read, read.Blocks.Count);
            Assert.That(pieces.ToList(), Is.EqualTo(found), $"in pieces of {size} moves");
        }
        return found;
    }

    private static IEnumerable<ToolpathColumns> Pieces(ToolpathColumns columns, int size)
    {
        for (var at = 0; at < columns.Count; at += size)
        {
            var piece = new ToolpathColumns(Math.Min(size, columns.Count - at));
            piece.Count = piece.Capacity;
            Array.Copy(columns.X, at, piece.X, 0, piece.Count);
            Array.Copy(columns.Y, at, piece.Y, 0, piece.Count);
            Array.Copy(columns.Z, at, piece.Z, 0, piece.Count);
            Array.Copy(columns.E, at, piece.E, 0, piece.Count);
            Array.Copy(columns.Kind, at, piece.Kind, 0, piece.Count);
            Array.Copy(columns.Source, at, piece.Source, 0, piece.Count);
            var arcs = Enumerable.Range(0, columns.Arcs.Length).Where(k => columns.ArcMoves[k] >= at && columns.ArcMoves[k] < at + piece.Count).ToArray();
            piece.ArcMoves = arcs.Select(k => columns.ArcMoves[k] - at).ToArray();
            piece.Arcs = arcs.Select(k => columns.Arcs[k]).ToArray();
            yield return piece;
        }
    }
}
