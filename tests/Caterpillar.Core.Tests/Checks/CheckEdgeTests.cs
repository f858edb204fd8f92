using System;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>Edges of the checks: first and last moves, single digits, arcs, what begins and ends at the same place.</summary>
public class CheckEdgeTests
{
    private static readonly PrintSetup Setup = SmallPrint.Setup();

    private static readonly PrintSetup Clipped = SmallPrint.Setup(p => p with
    {
        Clips = new(new Bounds(new Vec3(0, 100, 0), new Vec3(12, 110, 5))), HeadOutline = new(new HeadPoint(0.5, 0), new(4, 6)),
    });

    // F in a file is whole mm/min.
    [TestCase(40 + 0.9 / 60, 0)]
    [TestCase(40 + 0.993 / 60, 0)]
    [TestCase(40 + 1.005 / 60, 1)]
    public void A_speed_may_be_above_the_limit_by_its_last_digit(double speed, int found)
    {
        var setup = SmallPrint.Setup(p => p with { MaxSpeed = new(40, 40, 40, 40) });
        Assert.That(SmallPrint.Find(new SmallPrint().Print(30, 10, 0.2, speed: speed).Build(), setup, CheckCodes.Speed).Length, Is.EqualTo(found));
    }

    // Looked at each millimeter: pieces of 2 mm over a line with a gap of 0.3 mm at each centimeter.
    [TestCase(0.3, 1)]
    [TestCase(1.8, 0)]
    public void Extrusions_in_each_others_place_may_have_small_gaps(double gap, int found)
    {
        var print = new SmallPrint(50, 50, 0.2);
        for (var x = 50; x < 80; x += 10) print.Go(x + gap / 2, 50, 0.2).Print(x + 10 - gap / 2, 50, 0.2).Go(print.At.X, 50, 5);
        print.Go(50, 50, 5).Go(50, 50, 0.2);
        for (var x = 52; x <= 80; x += 2) print.Print(x, 50, 0.2);
        Assert.That(SmallPrint.Find(print.Go(20, 20, 5).Build(), Setup, CheckCodes.Duplicate).Length, Is.EqualTo(found));
    }

    [TestCase(0.6, "3")]
    [TestCase(0.47, "2.35")]
    public void An_extrusion_is_as_wide_as_its_gap_says_whatever_its_layer(double area, string width)
    {
        // In a layer of 0.1 mm, 0.2 above the bed.
        var setup = new PrintSetup(SmallPrint.Generic, new Material(), new PrintSettings { BeadShape = BeadShape.Rectangle });
        var print = new SmallPrint(50, 50, 0.2).InLayer(new Layer(0, 0.2, 0.1)).Print(70, 50, 0.2, area).Build();
        Assert.That(SmallPrint.Find(print, setup, CheckCodes.Width).Single().Message, Does.StartWith($"Extrusions are {width} mm wide"));
    }

    [Test]
    public void The_extrusion_of_an_arc_lies_along_the_arc()
    {
        // Half a ring of 10 mm, 1 mm above the bed on nothing; through its middle and through its extrusion.
        var ring = new SmallPrint(110, 100, 20).Go(110, 100, 5).Arc(90, 100, 5, new Vec3(100, 100, 5), 180, SmallPrint.Area).Go(90, 100, 50);
        var inside = ring.Go(100, 95, 50).Go(100, 95, 4.5).Go(100, 106, 4.5);
        Assert.That(SmallPrint.Find(inside.Build(), Setup, "collision."), Is.Empty);
        var through = inside.Go(100, 115, 4.5);
        Assert.That(SmallPrint.Find(through.Build(), Setup, "collision.").Single().Source!.Move, Is.EqualTo(through.Count - 1));
    }

    [TestCase(103.8)]
    [TestCase(106.2)]
    [TestCase(101.4)]
    public void A_clip_has_no_holes(double y)
        => Assert.That(SmallPrint.Find(new SmallPrint(6, y, 20).Go(6, y, 4.9).Build(), Clipped, CheckCodes.ClipHit), Has.Exactly(1).Items);

    [TestCase(0.4)]
    [TestCase(30)]
    public void Extrusions_of_any_length_keep_off_excluded_areas(double length)
    {
        var setup = SmallPrint.Setup(p => p with { ExcludedAreas = new(new Bounds(new Vec3(100, 50), new Vec3(140, 70))) });
        var found = SmallPrint.Find(new SmallPrint(105, 60, 0.2).Print(105 + length, 60, 0.2).Build(), setup, CheckCodes.ExcludedArea);
        Assert.That(found, Has.Exactly(1).Items);
        Assert.That(SmallPrint.Find(new SmallPrint(105, 60, 0.2).Prime(0.1).Build(), setup, CheckCodes.ExcludedArea), Is.Empty, "a blob is no extrusion");
    }

    [Test]
    public void Places_of_collisions_have_two_decimals()
    {
        var print = new SmallPrint().Wall(60, 80, 50, 4).Go(66.123, 30.377, 200).Go(66.123, 30.377, 3.4137).Go(71.777, 71.313, 3.1719);
        var message = SmallPrint.Find(print.Build(), Setup, "collision.travel").Single().Message;
        Assert.That(message, Does.Match(@"at \(\d+\.\d\d?, \d+\.\d\d?, \d\.\d\d?\)\. Raise the travel move\.$"));
        var place = Regex.Matches(message, @"[\d.]+\d").Cast<Match>()
            .Select(m => NumberReader.TryParse(m.Value, out var number) ? number : double.NaN).ToArray();
        // Where the flat of the tip comes to the wall, 0.7 mm before its middle, and the path there.
        var at = place.Skip(place.Length - 3).ToArray();
        Assert.That(at[1], Is.InRange(45, 50));
        var t = (at[1] - 30.377) / (71.313 - 30.377);
        Assert.That(at[0], Is.EqualTo(66.123 + t * (71.777 - 66.123)).Within(0.01));
        Assert.That(at[2], Is.EqualTo(3.4137 + t * (3.1719 - 3.4137)).Within(0.01));
    }

    [Test]
    public void The_first_step_and_files_without_lines_have_places()
    {
        Assert.That(SmallPrint.Find(new SmallPrint().Go(500, 10, 0.2).Build(), Setup, CheckCodes.Outside).Single().Source!.Step, Is.Zero);
        foreach (var (line, expected) in new[] { (0, (int?)null), (1, 1) })
        {
            var builder = new ToolpathBuilder(MoveSource.Lines, Vec3.Zero);
            builder.Add(new Vec3(500, 10, 0.2), 0, 0, 10, MoveKind.Travel, Role.Unspecified, -1, 0, line);
            Assert.That(SmallPrint.Find(builder.Build([new ToolpathTool(1)]), Setup, CheckCodes.Outside).Single().Source!.Line, Is.EqualTo(expected));
        }
    }

    [TestCase("G1 X10 Y10 Z0.2 F3000", "G1 X10.007 Y10 Z0.2 F3000")]
    [TestCase("G1 Z5", "G1 Z5.007")]
    public void The_first_and_the_last_move_of_an_edit_are_compared(string text, string instead)
    {
        const string File = "G28\nM109 S200\nG90\nM83\nG1 X10 Y10 Z0.2 F3000\nG1 X30 E0.5\nG1 Y40 E0.8\nG1 Z5\nM104 S0\n";
        var wanted = SmallPrint.Decode(Encoding.ASCII.GetBytes(File), Setup);
        var found = EditCheck.Run(wanted, wanted.Toolpath, GCodeDocument.FromText(File.Replace(text, instead)), Setup, null, CancellationToken.None);
        Assert.That(found.Count(d => d.Code == CheckCodes.FilePosition), Is.EqualTo(1));
    }

    [Test]
    public void What_no_file_can_state_is_named_wherever_it_is()
    {
        var last = new SmallPrint().Print(30, 10, 0.2).Event(new NozzleTemperatureEvent(1e9)).Build();
        var found = PrintableNumbers.Check(last)!;
        Assert.That((found.Code, found.Source!.Step, found.Source.Move), Is.EqualTo((SafeWriter.InvalidNumber, (int?)null, (int?)1)));
        var arc = new SmallPrint().Go(30, 10, 0.2).Go(40, 10, 0.2).Arc(50, 10, 0.2, new Vec3(45, 2e7, 0.2), 1).Build();
        Assert.That(PrintableNumbers.Check(arc)!.Source!.Move, Is.EqualTo(2));
        Assert.That(PrintableNumbers.Check(arc)!.Message, Does.StartWith("The center of an arc cannot be written"));
        foreach (var (value, fine) in new[] { (9_999_999.0, true), (1e7, false), (-1e7, false), (-9_999_999.0, true) })
        {
            Assert.That(PrintableNumbers.Check(new SmallPrint().Go(value, 10, 0.2).Build()) is null, Is.EqualTo(fine), $"{value}");
            Assert.That(PrintableNumbers.Check(new SmallPrint().Go(10, value, 0.2).Build()) is null, Is.EqualTo(fine), $"{value}");
            Assert.That(PrintableNumbers.Check(new SmallPrint().Go(10, 10, value).Build()) is null, Is.EqualTo(fine), $"{value}");
            Assert.That(PrintableNumbers.Check(new SmallPrint().Print(10, 20, 0.2, speed: value).Build()) is null, Is.EqualTo(fine), $"{value}");
            Assert.That(PrintableNumbers.Check(new SmallPrint().Prime(value * SmallPrint.FilamentArea).Build()) is null, Is.EqualTo(fine), $"{value}");
        }
        Assert.That(PrintableNumbers.Check(new SmallPrint().Event(new DwellEvent(1e7)).Go(20, 10, 0.2).Build()), Is.Not.Null);
        Assert.That(PrintableNumbers.Check(new SmallPrint().Event(new DwellEvent(9_999_999)).Go(20, 10, 0.2).Build()), Is.Null);
        Assert.That(PrintableNumbers.Check(new SmallPrint().Go(12_345_678.12345, 10, 0.2).Build())!.Message, Does.EndWith("it is 12345678.123, beyond 10⁷."));
        foreach (var what in new PrinterEvent[]
        {
            new BedTemperatureEvent(1e9), new FanEvent(double.NaN), new AccelerationEvent(1e9), new LimitEvent(MotionLimit.JerkX, 1e9), new DwellEvent(1e9),
        })
            Assert.That(PrintableNumbers.Check(new SmallPrint().Event(what).Go(20, 10, 0.2).Build())!.Source!.Move, Is.Zero, what.ToString());
    }

    [Test]
    public void Lines_of_warnings_are_those_of_the_written_file([Values] bool overridden)
    {
        var print = new SmallPrint(50, 50, 20).Go(50, 50, 0.2).Print(55, 50, 0.2).Go(50, 50, 4).Print(61.5, 50, 4);
        if (overridden) print.Go(250, 50, 4);
        var result = SafeWriter.ToDocument(print.Build(), Setup, overridden ? "the bed is longer" : null);
        var lines = Encoding.ASCII.GetString(result.Value!.ToBytes()).Split('\n');
        var found = result.Diagnostics.Single(d => d.Code == CheckCodes.Unsupported);
        Assert.That(lines[found.Source!.Line!.Value - 1], Does.StartWith("G1 X61.5 "));
    }

    [Test]
    public void Firmware_retraction_is_what_the_plan_asks_for()
    {
        var setup = SmallPrint.Setup(p => p with { FirmwareRetraction = true });
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(10, 10, 0.2));
        void Add(double x, double e, double deposited, MoveKind kind)
            => builder.Add(new Vec3(x, 10, 0.2), e, deposited, 30, kind, Role.Unspecified, -1, 0, builder.Count);
        Add(30, 0.6, 0.6, MoveKind.Print);
        Add(30, -0.8, 0, MoveKind.Retract);
        Add(50, 0, 0, MoveKind.Travel);
        Add(50, 0.8, 0, MoveKind.Deretract);
        Add(70, 0.6, 0.6, MoveKind.Print);
        var result = SafeWriter.ToDocument(builder.Build([new ToolpathTool(SmallPrint.FilamentArea)]), setup);
        Assert.That(result.Diagnostics.Where(d => d.Code.StartsWith("file.", StringComparison.Ordinal)), Is.Empty);
        Assert.That(Encoding.ASCII.GetString(result.Value!.ToBytes()), Does.Contain("\nG10").And.Contain("\nG11"));
    }

    [Test]
    public void An_arc_that_is_missing_from_the_file_is_one_finding()
    {
        var plan = new SmallPrint().Print(30, 10, 0.2).Arc(50, 10, 0.2, new Vec3(40, 10, 0.2), 180, SmallPrint.Area).Build();
        var (_, lines, text) = SmallPrint.Written(plan, Setup);
        var all = text.Split('\n');
        all[lines.OfMove(1).Last - 1] = "; nothing";
        var read = SmallPrint.Decode(Encoding.ASCII.GetBytes(string.Join("\n", all)), Setup).Toolpath;
        var findings = new Findings(Setup.Printer, read);
        new PlanComparison(plan, SetupFormat.Of(Setup, plan).Value!, lines, findings).End(read, 0);
        Assert.That(findings.ToList().Select(d => (d.Code, d.Count)), Is.EqualTo(new[] { (CheckCodes.FilePosition, 1), (CheckCodes.FileExtrusion, 1) }));
    }
}
