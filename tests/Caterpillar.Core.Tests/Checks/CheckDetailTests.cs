using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>Smaller rules of the checks: what counts, what does not, and from where on.</summary>
public class CheckDetailTests
{
    private static readonly PrintSetup Setup = SmallPrint.Setup();

    [Test]
    public void Of_several_findings_the_first_and_the_worst_are_named()
    {
        var print = new SmallPrint(50, 50, 4);
        foreach (var length in new[] { 8, 6, 20, 20.3, 12 }) print.Go(50, print.At.Y + 5, 4).Print(50 + length, print.At.Y, 4);
        var found = SmallPrint.Find(print.Build(), Setup, CheckCodes.Unsupported).Single();
        Assert.That((found.Count, found.Message, found.Source!.Move), Is.EqualTo(
            (5, "An extrusion is in the air for 8 mm, with a free end. Add supports below it.", 1)));
        Assert.That((found.Worst!.Message, found.Worst.Source!.Move), Is.EqualTo(
                ("An extrusion is in the air for 20 mm, with a free end. Add supports below it.", 5)),
            "20.3 is as bad");
        Assert.That(found.ToString(), Is.EqualTo("step 1, move 1: warning extrusion.unsupported: An extrusion is in the air for 8 mm, with a free end. "
            + "Add supports below it. (5 times, 50 % of the moves, the worst: "
            + "step 5, move 5: An extrusion is in the air for 20 mm, with a free end. Add supports below it.)"));
        var first = new SmallPrint(50, 50, 4).Print(70, 50, 4).Go(50, 60, 4).Print(60, 60, 4).Go(20, 20, 4);
        Assert.That(SmallPrint.Find(first.Build(), Setup, CheckCodes.Unsupported).Single().Worst, Is.Null, "it is the first");
    }

    // A first finding without a size says nothing about which is the worst.
    [TestCase(0, 5, false)]
    [TestCase(1, 5, true)]
    [TestCase(5, 1, false)]
    [TestCase(1, 1.02, false)]
    [TestCase(1, 0, false)]
    public void The_worst_is_told_where_it_is_worse_than_the_first(double first, double second, bool told)
    {
        var findings = new Findings(new Printer(), _ => null, _ => null);
        findings.Add(CheckCodes.Width, 0, () => "first", first);
        findings.Add(CheckCodes.Width, 1, () => "second", second);
        var found = findings.ToList().Single();
        Assert.That((found.Message, found.Count, found.Worst?.Message), Is.EqualTo(("first", 2, told ? "second" : null)));
    }

    [TestCase(1, 1)]
    [TestCase(4, 0.25)]
    public void A_finding_tells_the_share_of_moves_that_have_it(int moves, double share)
    {
        var findings = new Findings(new Printer(), _ => null, _ => null);
        findings.Add(CheckCodes.Width, 0, () => "only");
        Assert.That(findings.ToList(moves).Single().Share, Is.EqualTo(share));
    }

    [Test]
    public void Places_name_object_and_layer_where_the_design_states_no_line()
    {
        var print = new SmallPrint(50, 50, 20).Go(50, 50, 4).InLayer(new Layer(7, 4, 0.2, "cup")).Print(60, 50, 4).Build();
        var place = SmallPrint.Find(print, Setup, CheckCodes.Unsupported).Single().Source!;
        Assert.That(place.Origin, Is.EqualTo(new SourceLocation("cup", Layer: 7)));
        Assert.That(place.ToString(), Is.EqualTo("cup, layer 7 -> step 1, move 1"));
        var written = SafeWriter.ToDocument(print, Setup).Diagnostics.Single(d => d.Code == CheckCodes.Unsupported).Source!;
        Assert.That((written.Origin, written.Line is > 0), Is.EqualTo((place.Origin, true)));
        var (file, _, _) = SmallPrint.Written(print, Setup);
        var read = PrintCheck.Run(file, Setup).Single(d => d.Code == CheckCodes.Unsupported).Source!;
        Assert.That(read.Origin?.Layer, Is.EqualTo(file.Toolpath.Layers.Count > 0 ? file.Toolpath.Layers[0].Index : null));
    }

    [TestCase("G91", ExtrusionMode.Relative, "relative positions (G91)")]
    [TestCase("g91 ; up", ExtrusionMode.Relative, "relative positions (G91)")]
    [TestCase("G 91", ExtrusionMode.Relative, "relative positions (G91)")]
    [TestCase("N5G91", ExtrusionMode.Relative, "relative positions (G91)")]
    [TestCase("(up) G91", ExtrusionMode.Relative, "relative positions (G91)")]
    [TestCase("G90\nG20", ExtrusionMode.Relative, "inches (G20)")]
    [TestCase("M82", ExtrusionMode.Relative, "absolute E (M82)")]
    [TestCase("M83", ExtrusionMode.Absolute, "relative E (M83)")]
    [TestCase("M83", ExtrusionMode.Relative, null)]
    [TestCase("M82", ExtrusionMode.Absolute, null)]
    [TestCase("M83\nM82", ExtrusionMode.Absolute, null)]
    [TestCase("M82\nM83", ExtrusionMode.Relative, null)]
    [TestCase("G91\nG1 Z1\nG90", ExtrusionMode.Relative, null)]
    [TestCase("G20\nG21", ExtrusionMode.Relative, null)]
    [TestCase("; G91", ExtrusionMode.Relative, null)]
    [TestCase("M117 done (G91)", ExtrusionMode.Relative, null)]
    [TestCase("M117 open (G91", ExtrusionMode.Relative, null)]
    [TestCase("G91.1", ExtrusionMode.Relative, null)]
    [TestCase("M117 BG91", ExtrusionMode.Relative, null)]
    [TestCase("M117 G", ExtrusionMode.Relative, null)]
    [TestCase("AG91", ExtrusionMode.Relative, null)]
    [TestCase("G1 (", ExtrusionMode.Relative, null)]
    public void A_raw_line_that_leaves_another_mode_is_named(string raw, ExtrusionMode mode, string? word)
    {
        var setup = SmallPrint.Setup(p => p with { ExtrusionMode = mode });
        var print = new SmallPrint().Print(30, 10, 0.2).Event(new RawEvent(raw)).Print(60, 10, 0.2).Build();
        var found = SafeWriter.ToDocument(print, setup).Diagnostics.Where(d => d.Code == CheckCodes.FileModes).ToArray();
        Assert.That(found.Select(d => d.Message.Substring(0, d.Message.IndexOf(" and does not", StringComparison.Ordinal))),
            Is.EqualTo(word is null ? [] : new[] { "A raw line switches to " + word }));
    }

    [TestCase("M221 S50", 1, "marlin2", "sets the flow to 50 % (M221)")]
    [TestCase("M221 S97.5", 1, "marlin2", "sets the flow to 97.5 % (M221)")]
    [TestCase("M221", 1, "marlin2", null)]
    [TestCase("M221 S", 1, "marlin2", null)]
    [TestCase("M200", 2, "marlin2", null)]
    [TestCase("M200 D0.9 S0.9", 2, "marlin2", "switches to E in mm³ (M200)")]
    [TestCase("M221 S100", 1, "marlin2", null)]
    [TestCase("M221 S50\nG1 X40 E1\nM221 S100", 1, "marlin2", null)]
    [TestCase("M221 S50", 1, "mach3", null)]
    [TestCase("; M221 S50", 1, "marlin2", null)]
    [TestCase("M200 D1.75", 2, "marlin2", "switches to E in mm³ (M200)")]
    [TestCase("M200 S1 D1.75", 2, "marlin2", "switches to E in mm³ (M200)")]
    [TestCase("M200 D0", 2, "marlin2", null)]
    [TestCase("M200 S0 D1.75", 2, "marlin2", null)]
    [TestCase("M200 D1.75", 1, "marlin2", null)]
    [TestCase("M200 D0", 1, "marlin2", "switches to E in mm of filament (M200)")]
    [TestCase("M200 S0", 1, "marlin2", "switches to E in mm of filament (M200)")]
    [TestCase("M200 D1.75", 2, "klipper", null)]
    public void A_raw_line_that_makes_E_another_amount_is_named(string raw, double volumePerE, string flavor, string? word)
    {
        var setup = SmallPrint.Setup(p => p with { Flavor = FlavorTable.Find(flavor)! });
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(10, 10, 0.2));
        builder.Add(new Vec3(30, 10, 0.2), 1, 1, 20, MoveKind.Print, Role.Unspecified, -1, 0, 0);
        builder.AddEvent(new RawEvent(raw), 1);
        builder.Add(new Vec3(60, 10, 0.2), 1, 1, 20, MoveKind.Print, Role.Unspecified, -1, 0, 2);
        var plan = builder.Build([new ToolpathTool(volumePerE)]);
        var findings = new Findings(setup.Printer, plan);
        RawModes.Run(plan, SetupFormat.Of(setup, plan).Value!, findings, i => new SourceLocation(Step: plan.Events[i].Source));
        Assert.That(findings.ToList().Select(d => (d.Code, d.Source!.Step)), Is.EqualTo(word is null ? [] : new[] { (CheckCodes.FileExtrusion, (int?)1) }));
        if (word is not null) Assert.That(findings.ToList()[0].Message, Does.StartWith("A raw line " + word));
    }

    [Test]
    public void After_the_last_move_a_raw_line_may_leave_any_mode()
    {
        var print = new SmallPrint().Print(30, 10, 0.2).Event(new RawEvent("G91")).Build();
        Assert.That(SafeWriter.ToDocument(print, Setup).Diagnostics.Select(d => d.Code), Has.No.Member(CheckCodes.FileModes));
    }

    // 1 mm³/s; of 0.05 mm the last decimals are 4 %.
    [TestCase(0.05, 1.03, 0)]
    [TestCase(0.05, 1.2, 1)]
    [TestCase(10, 0.999, 0)]
    [TestCase(10, 1.01, 1)]
    public void The_last_decimals_of_short_moves_are_not_taken_for_flow(double length, double flow, int found)
    {
        var setup = SmallPrint.Setup(p => p with { MaxFlow = 1 });
        var print = new SmallPrint().Print(10 + length, 10, 0.2, flow / 50);
        Assert.That(SmallPrint.Find(print.Build(), setup, CheckCodes.Flow).Sum(d => d.Count), Is.EqualTo(found));
    }

    // 0.001 mm³ of filament; a unit of the last decimal of E is 2.4 %.
    [TestCase(1.02, 0)]
    [TestCase(1.05, 1)]
    public void The_last_decimal_of_E_is_not_taken_for_flow(double flow, int found)
    {
        var setup = SmallPrint.Setup(p => p with { MaxFlow = 0.05 });
        var print = new SmallPrint().Print(11, 10, 0.2, 0.001 * flow);
        Assert.That(SmallPrint.Find(print.Build(), setup, CheckCodes.Flow).Sum(d => d.Count), Is.EqualTo(found));
    }

    // Z allows 0.1 mm/s: over 10 mm 0.009 mm of 0.01 count, and all of 0.021.
    [TestCase(0.01, 110, 0)]
    [TestCase(0.01, 113, 1)]
    [TestCase(0.021, 47, 0)]
    [TestCase(0.021, 49, 1)]
    [TestCase(0.001, 400, 0)]
    [TestCase(0.02, 49, 0)]
    [TestCase(0.02, 51, 1)]
    public void An_axis_that_moves_by_few_decimals_limits_no_speed(double rise, double speed, int found)
    {
        var setup = SmallPrint.Setup(p => p with { MaxSpeed = new(500, 500, 0.1, 500) });
        var print = new SmallPrint(10, 10, 0).Print(20, 10, rise, SmallPrint.Area, Role.Unspecified, speed);
        Assert.That(SmallPrint.Find(print.Build(), setup, CheckCodes.Speed).Sum(d => d.Count), Is.EqualTo(found));
    }

    [TestCase(19, 0, 0)]
    [TestCase(20, 0, 1)]
    [TestCase(20, 100, 1)]
    public void The_mode_of_E_is_judged_by_twenty_moves_with_E(int moves, int travels, int found)
    {
        var text = new StringBuilder("G28\nM109 S200\nG90\nM83\nG1 X10 Y10 Z0.2 F3000\n");
        for (var i = 1; i <= moves; i++) text.Append("G1 X").Append(10 + i).Append(i % 2 > 0 ? " E-0.1\n" : " E0.1\n");
        for (var i = 1; i <= travels; i++) text.Append("G1 Y").Append(10 + i).Append('\n');
        Assert.That(InFile(text + "M104 S0\n", CheckCodes.ExtrusionMode).Sum(d => d.Count), Is.EqualTo(found));
    }

    [TestCase("M104 S1\n", "The nozzle is still heated to 1 °C at the end. Add M104 S0 to the end G-code.")]
    [TestCase("M104 S0\nM140 S1\n", "The bed is still heated to 1 °C at the end. Add M140 S0 to the end G-code.")]
    [TestCase("M104 S0\nM140 S60\nM140 S0\n", null)]
    [TestCase("M104 T0 S0\nM104 T1 S150\n", "The nozzle is still heated to 150 °C at the end. Add M104 S0 to the end G-code.")]
    [TestCase("M104 T0 S0\nM104 T1 S0\n", null)]
    [TestCase("M104 T1 S210\nM104 S190\nM104 T1 S0\n", "The nozzle is still heated to 190 °C at the end. Add M104 S0 to the end G-code.")]
    [TestCase("M104 T1 S210\nT1\nM104 S0\nM104 T0 S0\n", null)]
    public void Heat_that_is_left_on_is_named(string end, string? message)
        => Assert.That(InFile("G28\nM109 S200\nM83\nG1 X10 Y10 Z0.2 F3000\nG1 X20 E0.3\n" + end, CheckCodes.HeatLeftOn).Select(d => d.Message),
            Is.EqualTo(message is null ? [] : new[] { message }));

    [TestCase(170, 0)]
    [TestCase(169, 1)]
    public void Extrusion_begins_at_the_temperature_of_the_printer(double celsius, int found)
    {
        var list = SmallPrint.Find(new SmallPrint().Event(new NozzleTemperatureEvent(celsius)).Print(20, 10, 0.2).Build(), Setup, CheckCodes.ColdExtrusion);
        Assert.That(list.Select(d => d.Message), Is.EqualTo(Enumerable.Repeat(
            "A move extrudes at 169 °C, but Generic printer needs 170 °C. Heat the nozzle first.", found)));
    }

    [TestCase("PRINT", CheckCodes.NoHoming)]
    [TestCase("START_PRINT", null)]
    public void Only_long_names_are_macros(string first, string? code)
        => Assert.That(InFile(first + "\nM109 S200\nM83\nG1 X10 Y10 Z0.2 F3000\nG1 X20 E0.3\nM104 S0\n", "file.").Select(d => d.Code),
            Is.EqualTo(code is null ? [] : new[] { code }));

    // Of a line along X and a gap of 0.5 mm: turned by an angle, in another role, or with a second travel.
    [TestCase(9, Role.OuterWall, false, 1)]
    [TestCase(11, Role.OuterWall, false, 0)]
    [TestCase(0, Role.InnerWall, false, 0)]
    [TestCase(0, Role.OuterWall, true, 0)]
    public void A_gap_is_one_travel_in_a_line_that_goes_on(double turn, Role role, bool twice, int found)
    {
        var (sin, cos) = Angle.SinCos(turn);
        var print = new SmallPrint(50, 50, 0.2).Print(60, 50, 0.2, SmallPrint.Area, Role.OuterWall).Go(60.5, 50, 0.2);
        if (twice) print.Go(61, 50, 0.2);
        print.Print(print.At.X + 10 * cos, 50 + 10 * sin, 0.2, SmallPrint.Area, role);
        Assert.That(SmallPrint.Find(print.Build(), Setup, CheckCodes.Gap).Sum(d => d.Count), Is.EqualTo(found));
    }

    [TestCase(230, 10, -1, CheckCodes.Outside)]
    [TestCase(20, 10, -1, CheckCodes.Below)]
    public void What_is_beside_the_bed_and_below_it_is_outside(double x, double y, double z, string code)
        => Assert.That(SmallPrint.Find(new SmallPrint().Go(x, y, z).Build(), Setup, "bed.").Single().Code, Is.EqualTo(code));

    // Clips of 12 × 10 mm, 5 high; the tip is 0.5 mm wide at each side and 0.1 below the top.
    [TestCase(6, 105, 1)]
    [TestCase(6, 100.2, 1)]
    [TestCase(6, 109.8, 1)]
    [TestCase(6, 110.4, 1)]
    [TestCase(6, 110.9, 0)]
    [TestCase(6, 99.6, 1)]
    [TestCase(6, 99.1, 0)]
    [TestCase(12.4, 105, 1)]
    [TestCase(12.9, 105, 0)]
    public void A_clip_is_as_large_as_it_is(double x, double y, int found)
    {
        var setup = SmallPrint.Setup(p => p with
        {
            Clips = new(new Bounds(new Vec3(0, 100, 0), new Vec3(12, 110, 5))), HeadOutline = new(new HeadPoint(0.5, 0), new(4, 6)),
        });
        var list = SmallPrint.Find(new SmallPrint(x, y, 20).Go(x, y, 4.9).Build(), setup, CheckCodes.ClipHit);
        Assert.That(list.Sum(d => d.Count), Is.EqualTo(found));
        if (found > 0) Assert.That(list[0].Message, Does.StartWith("The nozzle hits bed clip 1 between ("));
    }

    // The file of two extrusions and a travel, with one line changed.
    [TestCase("X30", "X30.005", null)]
    [TestCase("X30", "X30.007", CheckCodes.FilePosition)]
    [TestCase("Y40", "Y40.007", CheckCodes.FilePosition)]
    [TestCase("Z5", "Z5.007", CheckCodes.FilePosition)]
    [TestCase("X30", "X29.995", null)]
    [TestCase("X30", "X29.993", CheckCodes.FilePosition)]
    [TestCase("Y40", "Y39.993", CheckCodes.FilePosition)]
    [TestCase("Z5", "Z4.993", CheckCodes.FilePosition)]
    [TestCase("E0.5", "E0.494", null)]
    [TestCase("E0.5", "E0.493", CheckCodes.FileExtrusion)]
    [TestCase("E0.5", "E0.506", null)]
    [TestCase("E0.5", "E0.507", CheckCodes.FileExtrusion)]
    [TestCase("G1 X30 E0.5", "G1 X20 E0.25\nG1 X30 E0.25", null)]
    [TestCase("G1 X30 E0.5", "G1 X20 E0.25\nG1 X31 E0.25", CheckCodes.FilePosition)]
    [TestCase("G1 X30 E0.5", "G1 X20 E0.25\nG1 X30 E0.27", CheckCodes.FileExtrusion)]
    [TestCase("G1 X30 E0.5", "G1 X20 E0.25\nG1 X30 E0.255", null)]
    [TestCase("G1 X30 E0.5", "G1 X20 E0.25\nG1 X29 E0.25", CheckCodes.FilePosition)]
    [TestCase("G1 X30 E0.5", "G1 X20 E0.25\nG1 X30 E0.23", CheckCodes.FileExtrusion)]
    public void An_edited_file_that_does_something_else_is_named(string text, string instead, string? code)
    {
        const string File = "G28\nM109 S200\nG90\nM83\nG1 X10 Y10 Z0.2 F3000\nG1 X30 E0.5\nG1 Y40 E0.8\nG1 Z5\nM104 S0\n";
        var wanted = SmallPrint.Decode(Encoding.ASCII.GetBytes(File), Setup);
        var document = GCodeDocument.FromText(File.Replace(text, instead));
        var found = EditCheck.Run(wanted, wanted.Toolpath, document, Setup, null, CancellationToken.None);
        var named = found.Where(d => d.Code is CheckCodes.FilePosition or CheckCodes.FileExtrusion).ToArray();
        Assert.That(named.Select(d => d.Code), Is.EqualTo(code is null ? [] : new[] { code }));
        if (code is not null) Assert.That(named[0].Message, Does.Contain("the edit"));
    }

    // Numbers with more decimals than are told.
    [TestCase("E0.5", "E0.5123456", "E changes by 0.51235 in this line, but the edit has 0.5.")]
    [TestCase("G1 X30 E0.5", "G1 X20.123456 E0.25\nG1 X31.123456 E0.25", "The file prints 51.12 mm, but the edit has 50 mm.")]
    [TestCase("G1 X30 E0.5", "G1 X20 E0.25\nG1 X30 E0.2765432", "The file extrudes 1.327, but the edit has 1.3.")]
    public void What_an_edited_file_does_is_told_in_few_decimals(string text, string instead, string message)
    {
        const string File = "G28\nM109 S200\nG90\nM83\nG1 X10 Y10 Z0.2 F3000\nG1 X30 E0.5\nG1 Y40 E0.8\nG1 Z5\nM104 S0\n";
        var wanted = SmallPrint.Decode(Encoding.ASCII.GetBytes(File), Setup);
        var found = EditCheck.Run(wanted, wanted.Toolpath, GCodeDocument.FromText(File.Replace(text, instead)), Setup, null, CancellationToken.None);
        Assert.That(found.Select(d => d.Message), Has.Member(message));
    }

    [Test]
    public void Progress_of_checks_and_of_writing_rises_from_0_to_1([Values(null, "a reason")] string? reason)
    {
        var print = new SmallPrint();
        for (var i = 0; i < 20_000; i++) print.Print(10 + i % 200, 10 + i / 200, 0.2);
        foreach (var run in new Action<IProgress<double>>[]
        {
            p => PrintCheck.Run(print.Build(), Setup, p), p => SafeWriter.Write(print.Build(), Setup, System.IO.Stream.Null, reason, p),
            p => SafeWriter.Write(print.Build(), Setup, System.IO.Stream.Null, reason, p, isDraft: true),
        })
        {
            var steps = new Steps();
            run(steps);
            Assert.That(steps.All, Is.Ordered);
            Assert.That(steps.All, Is.All.InRange(0, 1));
            Assert.That(steps.All, Has.Some.GreaterThan(0.9));
            Assert.That(steps.All.Count(s => s is > 0.01 and < 0.99), Is.AtLeast(2));
        }
    }

    [Test]
    public void Progress_of_edited_files_ends_at_1([Values(null, "the bed is longer")] string? reason)
    {
        // Of more than one block.
        var moves = string.Concat(Enumerable.Range(0, 70_000).Select(i => i % 2 == 0 ? "G1 X20\n" : "G1 X10\n"));
        var file = SmallPrint.Decode(Encoding.ASCII.GetBytes("G28\nM109 S200\nG90\nM83\nG1 X10 Y10 Z0.2 F3000\n" + moves + "G1 X500\nM104 S0\n"), Setup);
        var steps = new Steps();
        SafeWriter.ToDocument(file, file.Toolpath, Setup, reason, null, steps);
        Assert.That(steps.All, Is.Ordered.And.All.InRange(0, 1));
        if (reason is not null) Assert.That(steps.All.Last(), Is.EqualTo(1));
    }

    [Test]
    public void Checks_stop_when_canceled()
    {
        using var cancel = new CancellationTokenSource();
        cancel.Cancel();
        Assert.That(() => PrintCheck.Run(new SmallPrint().Print(20, 10, 0.2).Build(), Setup, null, cancel.Token),
            Throws.InstanceOf<OperationCanceledException>());
        Assert.That(() => SafeWriter.ToDocument(new SmallPrint().Print(20, 10, 0.2).Build(), Setup, null, null, cancel.Token),
            Throws.InstanceOf<OperationCanceledException>());
    }

    private static Diagnostic[] InFile(string text, string code)
        => PrintCheck.Run(SmallPrint.Decode(Encoding.ASCII.GetBytes(text), Setup), Setup)
            .Where(d => d.Code.StartsWith(code, StringComparison.Ordinal)).ToArray();

    private sealed class Steps : IProgress<double>
    {
        public List<double> All { get; } = [];

        public void Report(double value)
        {
            lock (All) All.Add(value);
        }
    }
}
