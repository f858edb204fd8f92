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

/// <summary>Small allowances of the checks, and what lies at the edge of blocks and lines.</summary>
public class CheckPrecisionTests
{
    private static readonly PrintSetup Setup = SmallPrint.Setup();

    // No firmware reads a word before its command; that line is not understood.
    [TestCase("S50 M221", null)]
    [TestCase("M221 S50", "A raw line sets the flow to 50 %")]
    [TestCase("M221 S100", null)]
    public void The_flow_of_a_raw_line_is_stated_after_its_command(string raw, string? message)
    {
        var plan = new SmallPrint().Print(30, 10, 0.2).Event(new RawEvent(raw)).Print(50, 10, 0.2).Build();
        var findings = new Findings(Setup.Printer, plan);
        RawModes.Run(plan, SetupFormat.Of(Setup, plan).Value!, findings, _ => null);
        Assert.That(findings.ToList().Select(d => d.Code), Is.EqualTo(message is null ? [] : new[] { CheckCodes.FileExtrusion }));
        if (message is not null) Assert.That(findings.ToList()[0].Message, Does.StartWith(message));
    }

    // Material that flows at 1 °C needs heat, material that flows at 0 °C needs none.
    [TestCase(1, 1)]
    [TestCase(0, 0)]
    public void A_printer_that_needs_any_heat_must_be_heated(double needed, int found)
    {
        var setup = SmallPrint.Setup(p => p with { MinExtrusionTemperature = needed });
        var file = SmallPrint.Decode(Encoding.ASCII.GetBytes("G28\nM83\nG1 X10 Y10 Z0.2 F3000\nG1 X20 E0.3\n"), setup);
        Assert.That(PrintCheck.Run(file, setup).Count(d => d.Code == CheckCodes.NoHeating), Is.EqualTo(found));
    }

    // A thin extrusion over one that crosses it 0.05 mm below: there it is 0.2 mm wide, over the bed 0.05 mm.
    [TestCase(55, 0)]
    [TestCase(57.5, 1)]
    [TestCase(52.5, 1)]
    public void A_thin_extrusion_is_as_wide_as_in_the_gap_below_its_middle(double crossing, int found)
    {
        var setup = Setup with { Settings = new PrintSettings { BeadShape = BeadShape.Rectangle } };
        var print = new SmallPrint(crossing, 40, 0.15).Print(crossing, 60, 0.15, 0.06).Go(50, 50, 5).Go(50, 50, 0.2).Print(60, 50, 0.2, 0.01);
        Assert.That(SmallPrint.Find(print.Build(), setup, CheckCodes.Width).Sum(d => d.Count), Is.EqualTo(found));
    }

    // One that crosses at the same height lies beside it.
    [Test]
    public void What_crosses_a_thin_extrusion_at_its_height_is_not_below_it()
    {
        var setup = Setup with { Settings = new PrintSettings { BeadShape = BeadShape.Rectangle } };
        var print = new SmallPrint(55, 40, 0.15).Print(55, 60, 0.15, 0.06).Over(55, 40, 0.2).Print(55, 60, 0.2, 0.06).Over(50, 50, 0.2)
            .Print(60, 50, 0.2, 0.01);
        Assert.That(SmallPrint.Find(print.Build(), setup, CheckCodes.Width), Is.Empty);
    }

    // Five million millimeters of filament in one move: rounding takes a third of the last decimal.
    [TestCase("5000000.00001", 0)]
    [TestCase("5000000.00002", 1)]
    public void Large_numbers_of_E_may_stray_by_their_rounding(string e, int found)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(10, 10, 0.2));
        builder.Add(new Vec3(20, 10, 0.2), 5e6, 5e6, 20, MoveKind.Print, Role.Unspecified, -1, 0, 0);
        var plan = builder.Build([new ToolpathTool(SmallPrint.FilamentArea)]);
        Assert.That(Written(plan), Does.Contain(" E5000000"));
        var text = System.Text.RegularExpressions.Regex.Replace(Written(plan), @" E5000000[.0]*", " E" + e);
        Assert.That(Compare(plan, text).Select(d => d.Code), Is.EqualTo(Enumerable.Repeat(CheckCodes.FileExtrusion, found)));
    }

    [Test]
    public void A_move_that_begins_a_block_after_raw_lines_is_compared()
    {
        // They end where they began, so that nothing has to be stated again.
        static Toolpath Plan(int raw) => new SmallPrint().Print(30, 10, 0.2)
            .Event(new RawEvent(string.Join("\n", Enumerable.Range(0, raw).Select(k => k == raw - 1 ? "G1 X30" : $"G1 X{31 + k % 2}"))))
            .Print(50, 10, 0.2).Build();
        static Toolpath Read(Toolpath plan) => SmallPrint.Written(plan, Setup).File.Toolpath;
        var most = Read(Plan(100_000)).Blocks[0].Columns.Count;
        // Of the moves that are read all but the last are in the first block.
        var other = Read(Plan(10)).Count - 10;
        var plan = Plan(most + 1 - other);
        var blocks = Read(plan).Blocks;
        Assert.That((blocks.Count, blocks[0].Columns.Count, blocks[1].Columns.Count), Is.EqualTo((2, most, 1)));
        Assert.That(Compare(plan, Written(plan)), Is.Empty);
    }

    private static string Written(Toolpath plan) => SmallPrint.Written(plan, Setup).Text;

    private static IReadOnlyList<Diagnostic> Compare(Toolpath plan, string text)
    {
        var read = SmallPrint.Decode(Encoding.ASCII.GetBytes(text), Setup).Toolpath;
        var findings = new Findings(Setup.Printer, read);
        new PlanComparison(plan, SetupFormat.Of(Setup, plan).Value!, SmallPrint.Written(plan, Setup).Lines, findings).End(read, 0);
        return findings.ToList();
    }
}
