using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>Runs of moves that are compared with the plan in one go, and blocks of moves as checks get them.</summary>
public class MoveRunTests
{
    private const int Count = 40;
    private static readonly PrintSetup Setup = SmallPrint.Setup(p => p with { ExtrusionMode = ExtrusionMode.Relative });

    [Test]
    public void Moves_as_planned_are_passed_at_once()
    {
        var (plan, lines, read) = Written(Print(20));
        Assert.That(Passed(plan, lines, read), Is.EqualTo(read.Count - 1), "the last may go on");
    }

    // What differs is left to the comparison of single moves: the number of moves before it.
    [TestCase("X", 0.01)]
    [TestCase("Y", -0.01)]
    [TestCase("Z", 0.01)]
    [TestCase("E", 0.001)]
    [TestCase("X", double.NaN)]
    public void A_run_ends_where_a_move_is_elsewhere(string column, double change)
    {
        var (plan, lines, read) = Written(Print(20));
        var values = column switch { "X" => read.X, "Y" => read.Y, "Z" => read.Z, _ => read.E };
        values[17] += change;
        Assert.That(Passed(plan, lines, read), Is.EqualTo(17));
    }

    // Half of the last decimal, and rounding: exactly as much and the least bit more. The last move of a block is compared by itself.
    [TestCase("X", 17)]
    [TestCase("Y", 17)]
    [TestCase("Z", 17)]
    [TestCase("E", 17)]
    [TestCase("X", Count - 1)]
    [TestCase("Y", Count - 1)]
    [TestCase("Z", Count - 1)]
    [TestCase("E", Count - 1)]
    public void A_move_may_differ_by_as_much_as_is_allowed_and_no_more(string column, int move)
    {
        var (plan, lines, read) = Written(Print(20));
        var format = SetupFormat.Of(Setup, plan).Value!;
        var planned = plan.Blocks.Single().Columns;
        double[] Values(ToolpathColumns of) => column switch { "X" => of.X, "Y" => of.Y, "Z" => of.Z, _ => of.E };
        Array.Copy(read.E, planned.E, Count);
        Values(planned)[move] = 0;
        var allowed = column == "E"
            ? NumberFormatter.FromUnits(1, format.Printer.DecimalsE) * 1.01 + 1e-8 : 0.5 * NumberFormatter.FromUnits(1, format.Printer.DecimalsXyz) + 1e-7;
        foreach (var sign in new[] { 1, -1 })
        {
            Values(read)[move] = sign * allowed;
            Assert.That(Passed(plan, lines, read), Is.EqualTo(Count - 1));
            Assert.That(Compared(plan, lines, read), Is.Empty);
            Values(read)[move] = sign * BitConverter.Int64BitsToDouble(BitConverter.DoubleToInt64Bits(allowed) + 1);
            Assert.That(Passed(plan, lines, read), Is.EqualTo(Math.Min(move, Count - 1)));
            Assert.That(Compared(plan, lines, read), Is.EqualTo(new[] { (column == "E" ? CheckCodes.FileExtrusion : CheckCodes.FilePosition, (int?)move) }));
        }
    }

    [Test]
    public void A_run_ends_at_what_a_single_move_has_to_explain()
    {
        var (plan, lines, read) = Written(Print(20).Print(15, 15, 1.5, tool: 1).Print(25, 35, 1.5, tool: 1));
        Assert.That(Passed(plan, lines, read), Is.EqualTo(Count));

        (plan, lines, read) = Written(Print(20));
        read.Source[18] = read.Source[17];
        Assert.That(Passed(plan, lines, read), Is.EqualTo(17), "two moves of a line");

        (plan, lines, read) = Written(Print(20));
        for (var i = 17; i < read.Count; i++) read.Source[i]++;
        Assert.That(Passed(plan, lines, read), Is.EqualTo(17), "a line after");

        (plan, lines, read) = Written(Print(20));
        (read.Kind[17], read.E[17], plan.Blocks.Single().Columns.E[17]) = (MoveKind.Retract, 0, 0);
        Assert.That(Passed(plan, lines, read), Is.EqualTo(17), "a retraction of the firmware, which may lift");
    }

    [Test]
    public void Blocks_with_arcs_are_compared_move_by_move()
    {
        var (plan, lines, read) = Written(Print(20));
        read.ArcMoves = [5];
        read.Arcs = [new Arc(new Vec3(30, 30, 1), 90)];
        Assert.That(Passed(plan, lines, read), Is.Zero, "in the file");
        var print = Print(20);
        (plan, lines, read) = Written(print.Arc(print.At.X + 10, print.At.Y + 10, 1.5, print.At + new Vec3(0, 10), 90, SmallPrint.Area));
        (read.ArcMoves, read.Arcs) = ([], []);
        Assert.That(Passed(plan, lines, read), Is.Zero, "in the plan");
    }

    // An arc that the file goes straight ends at the same place.
    [Test]
    public void An_arc_that_becomes_a_line_is_found()
    {
        var print = Print(20);
        var (plan, lines, read) = Written(print.Arc(print.At.X + 10, print.At.Y + 10, 1.5, print.At + new Vec3(0, 10), 90, SmallPrint.Area));
        (read.ArcMoves, read.Arcs) = ([], []);
        Assert.That(Compared(plan, lines, read), Is.EqualTo(new[] { (CheckCodes.FilePosition, (int?)Count) }));
    }

    // Each event goes with the block of its move, once.
    [Test]
    public void Blocks_have_their_own_events()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var i = 0; i < 140_000; i++)
        {
            if (i % 1000 == 0 || i is 65_535 or 65_536 or 65_537) builder.AddEvent(new FanEvent(i / 200_000.0));
            builder.Add(new Vec3(i % 2, 0), 0, 0, 50, MoveKind.Travel, Role.Unspecified, -1, 0, i);
        }
        builder.AddEvent(new FanEvent(1));
        var toolpath = builder.Build([new ToolpathTool(1)]);
        Assert.That(toolpath.Blocks.Count, Is.GreaterThan(2));
        var blocks = CheckRun.BlocksOf(toolpath).ToArray();
        Assert.That(blocks.Select(b => b.First), Is.EqualTo(Enumerable.Range(0, toolpath.Blocks.Count).Select(toolpath.FirstOf)));
        foreach (var block in blocks)
        {
            var own = toolpath.Events.Where(e => e.Move >= block.First && e.Move < block.First + block.Columns.Count);
            Assert.That(block.Events, Is.EqualTo(own.ToArray()), $"{block.First}");
        }
    }

    [Test]
    public void A_number_that_no_file_can_state_is_named_by_its_move_in_any_block()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var i = 0; i < 70_000; i++) builder.Add(new Vec3(i == 69_000 ? 1e9 : i % 2, 0), 0, 0, 50, MoveKind.Travel, Role.Unspecified, -1, 0, i);
        Assert.That(PrintableNumbers.Check(builder.Build([new ToolpathTool(1)]))!.Source!.Move, Is.EqualTo(69_000));
    }

    private static (string Code, int? Move)[] Compared(Toolpath plan, WrittenLines lines, ToolpathColumns read)
    {
        var findings = new Findings(Setup.Printer, plan);
        new PlanComparison(plan, SetupFormat.Of(Setup, plan).Value!, lines, findings).End(plan.With([new ToolpathBlock(read)]), 0);
        return findings.ToList().Select(d => (d.Code, d.Source?.Move)).ToArray();
    }

    // How many moves the comparison passes in one go.
    private static int Passed(Toolpath plan, WrittenLines lines, ToolpathColumns read)
    {
        var findings = new Findings(Setup.Printer, plan);
        return new PlanComparison(plan, SetupFormat.Of(Setup, plan).Value!, lines, findings).Equal(read, 0, plan.Count);
    }

    // Zigzags that also climb, so that no coordinate is 0 or stays.
    private static SmallPrint Print(double x)
    {
        var print = new SmallPrint(x, 20, 1);
        for (var i = 1; i <= Count; i++) print.Print(x + i % 2, 20 + 0.5 * i, 1 + 0.01 * i);
        return print;
    }

    private static (Toolpath Plan, WrittenLines Lines, ToolpathColumns Read) Written(SmallPrint print)
    {
        var plan = print.Build().With(tools: [new ToolpathTool(SmallPrint.FilamentArea), new ToolpathTool(SmallPrint.FilamentArea)]);
        var (file, lines, _) = SmallPrint.Written(plan, Setup);
        var all = file.Toolpath.Blocks.Single().Columns;
        // Without the travel to the start, if the file has one.
        Assert.That(all.Source[0], Is.EqualTo(lines.OfMove(0).Last));
        return (plan, lines, all.Copy(all.Count));
    }
}
