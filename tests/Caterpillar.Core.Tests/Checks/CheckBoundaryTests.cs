using System;
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

/// <summary>Rules of the checks at their boundary: exactly there, just below and just above, and for the first and the last.</summary>
public class CheckBoundaryTests
{
    private static readonly PrintSetup Setup = SmallPrint.Setup();

    // Around a place 40 mm aside in both directions: 96.6 and 106.6 mm from the middle at most; the box around it is within 90.
    [TestCase(40, 0)]
    [TestCase(50, 1)]
    public void An_arc_stays_in_the_circle_and_not_in_the_box_of_a_round_bed(double radius, int found)
    {
        var setup = SmallPrint.Setup(p => p with { BuildVolume = new Vec3(200, 200, 250), Origin = BedOrigin.Center, BedShape = BedShape.Round });
        var print = new SmallPrint(40 + radius, 40, 1).Arc(40, 40 + radius, 1, new Vec3(40, 40, 1), 90, SmallPrint.Area);
        Assert.That(Count(print, CheckCodes.Outside, setup), Is.EqualTo(found));
    }

    // So short that it is one chord.
    [TestCase(99, 0)]
    [TestCase(105, 1)]
    public void The_shortest_arc_keeps_off_excluded_areas(double x, int found)
    {
        var setup = SmallPrint.Setup(p => p with { ExcludedAreas = new(new Bounds(new Vec3(100, 50), new Vec3(120, 70))) });
        var (sin, cos) = Angle.SinCos(5);
        var print = new SmallPrint(x, 60, 0.2).Arc(x - 5 + 5 * cos, 60 + 5 * sin, 0.2, new Vec3(x - 5, 60, 0.2), 5, SmallPrint.Area);
        Assert.That(Count(print, CheckCodes.ExcludedArea, setup), Is.EqualTo(found));
    }

    // F in a file is whole mm/min.
    [Test]
    public void A_speed_at_the_limit_and_its_last_digit_is_fine()
    {
        var setup = SmallPrint.Setup(p => p with { MaxSpeed = new(40, 40, 40, 40) });
        var most = 40 + Math.Pow(10, -setup.Printer.DecimalsF) / 60;
        Assert.That(Count(new SmallPrint().Print(30, 10, 0.2, speed: most), CheckCodes.Speed, setup), Is.Zero);
        Assert.That(Count(new SmallPrint().Event(new LimitEvent(MotionLimit.SpeedX, 90)).Print(30, 10, 0.2, speed: most), CheckCodes.Speed, setup), Is.Zero);
        Assert.That(Count(new SmallPrint().Event(new LimitEvent(MotionLimit.SpeedX, 90)).Print(30, 10, 0.2, speed: 40.02), CheckCodes.Speed, setup),
            Is.EqualTo(1));
    }

    // 200 mm at 50 mm/s; a thousandth above the limit is rounding.
    [TestCase(1.0005, 0)]
    [TestCase(1.003, 1)]
    public void A_flow_may_be_above_the_limit_by_a_thousandth(double flow, int found)
    {
        var setup = SmallPrint.Setup(p => p with { MaxFlow = 4 });
        Assert.That(Count(new SmallPrint().Print(210, 10, 0.2, 0.08 * flow), CheckCodes.Flow, setup), Is.EqualTo(found));
    }

    [Test]
    public void Material_in_place_has_no_flow_along_a_extrusion()
    {
        var setup = SmallPrint.Setup(p => p with { MaxFlow = 1 });
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(10, 10, 0.2));
        builder.Add(new Vec3(10, 10, 0.2), 1, 1, 50, MoveKind.Print, Role.Unspecified, -1, 0, 0);
        Assert.That(SmallPrint.Find(builder.Build([new ToolpathTool(SmallPrint.FilamentArea)]), setup, CheckCodes.Flow), Is.Empty);
    }

    // 1 mm of E a millimeter at 50 mm/s; the second tool has E in mm³, of which 2.4 are a millimeter of filament.
    [TestCase(0, 1)]
    [TestCase(1, 0)]
    public void The_extruder_is_as_fast_as_the_filament_of_its_tool(int tool, int found)
    {
        var setup = SmallPrint.Setup(p => p with { MaxSpeed = new(500, 500, 500, 30), ToolOffsets = new(Vec3.Zero, Vec3.Zero) });
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(10, 10, 0.2));
        builder.Add(new Vec3(20, 10, 0.2), 10, 10, 50, MoveKind.Print, Role.Unspecified, -1, tool, 0);
        var toolpath = builder.Build([new ToolpathTool(SmallPrint.FilamentArea), new ToolpathTool(1)]);
        Assert.That(SmallPrint.Find(toolpath, setup, CheckCodes.Speed).Length, Is.EqualTo(found));
    }

    [TestCase(Cornering.Jerk, 1)]
    [TestCase(Cornering.SquareCornerVelocity, 0)]
    public void Klipper_does_not_slow_down_a_extrusion_for_its_extruder(Cornering rule, int found)
    {
        var setup = SmallPrint.Setup(p => p with { Cornering = rule, MaxSpeed = new(500, 500, 500, 0.1) });
        Assert.That(Count(new SmallPrint().Print(20, 10, 0.2), CheckCodes.Speed, setup), Is.EqualTo(found));
    }

    // 15 units of the last decimal of E, of which one may be rounding: 0.01 mm/s for 0.00014 mm over 10 mm are 714 mm/s.
    [TestCase(690, 0)]
    [TestCase(720, 1)]
    public void An_extruder_that_turns_by_few_decimals_limits_no_speed(double speed, int found)
    {
        var setup = SmallPrint.Setup(p => p with { MaxSpeed = new(5000, 5000, 5000, 0.01) });
        Assert.That(Count(new SmallPrint().Print(20, 10, 0.2, 0.00015 * SmallPrint.FilamentArea / 10, speed: speed), CheckCodes.Speed, setup),
            Is.EqualTo(found));
    }

    // At 50 mm/s.
    [TestCase(60, 60, 0)]
    [TestCase(40, 60, 1)]
    [TestCase(60, 40, 1)]
    public void A_full_circle_is_as_fast_as_the_slower_of_its_axes(double x, double y, int found)
    {
        var setup = SmallPrint.Setup(p => p with { MaxSpeed = new(x, y, 500, 500) });
        Assert.That(Count(new SmallPrint(60, 50, 1).Arc(60, 50, 1, new Vec3(50, 50, 1), 360), CheckCodes.TravelSpeed, setup), Is.EqualTo(found));
    }

    [Test]
    public void Only_moves_of_the_head_end_a_blob()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(10, 10, 0.2));
        void Push(MoveKind kind, double volume)
            => builder.Add(new Vec3(10, 10, 0.2), volume, volume, 5, kind, Role.Unspecified, -1, 0, builder.Count);
        Push(MoveKind.Prime, 300);
        Push(MoveKind.Travel, 0);
        Push(MoveKind.Prime, 300);
        Assert.That(SmallPrint.Find(builder.Build([new ToolpathTool(1)]), Setup, CheckCodes.Stationary).Single().Source!.Move, Is.EqualTo(2));
    }

    // Where it is not known where the head is, its kind says whether it moves.
    [TestCase("G1 E130 F100\nG1 E130", 1)]
    [TestCase("G1 E130 F100\nG28\nG1 E130", 0)]
    [TestCase("G1 E130 F100\nG1 X10\nG1 E130", 0)]
    public void A_head_at_an_unknown_place_may_stand_still(string text, int found)
        => Assert.That(Count("M83\nM109 S200\n" + text + "\nM104 S0\n", CheckCodes.Stationary), Is.EqualTo(found));

    // Of 40 moves with E, each before one that makes up for it.
    [TestCase(10, 0)]
    [TestCase(11, 1)]
    public void A_quarter_of_the_moves_may_pull_back(int wipes, int found)
    {
        var text = new StringBuilder("G28\nM109 S200\nG90\nM83\nG1 X10 Y10 Z0.2\n");
        for (var i = 1; i <= 40; i++) text.Append("G1 X").Append(10 + 3 * i).Append(i <= 40 - 2 * wipes || i % 2 == 0 ? " E0.1\n" : " E-0.1\n");
        Assert.That(Count(text + "M104 S0\n", CheckCodes.ExtrusionMode), Is.EqualTo(found));
    }

    [TestCase(10, 0)]
    [TestCase(11, 1)]
    public void Half_of_the_extrusions_may_be_thick(int thick, int found)
    {
        var text = new StringBuilder("G28\nM109 S200\nG90\nM83\nG1 X10 Y10 Z5\n");
        for (var i = 1; i <= 20; i++) text.Append("G1 X").Append(10 + i).Append(i <= thick ? " E1.2\n" : " E0.1\n");
        Assert.That(Count(text + "M104 S0\n", CheckCodes.ExtrusionMode), Is.EqualTo(found));
    }

    [Test]
    public void Blobs_are_not_extrusions_that_no_nozzle_prints()
    {
        var text = "G28\nM109 S200\nM83\nG1 X10 Y10 Z5\n" + string.Concat(Enumerable.Repeat("G1 E1\n", 30)) + "M104 S0\n";
        Assert.That(Count(text, CheckCodes.ExtrusionMode), Is.Zero);
    }

    [Test]
    public void What_is_planned_says_itself_what_its_E_means()
    {
        var print = new SmallPrint(10, 10, 5);
        for (var i = 1; i <= 25; i++) print.Print(10 + i, 10, 5, 3);
        Assert.That(SafeWriter.ToDocument(print.Build(), Setup).Diagnostics.Select(d => d.Code), Has.No.Member(CheckCodes.ExtrusionMode));
    }

    // The start code is one line, and does not home.
    [TestCase("M109 S200", CheckCodes.NoHoming)]
    [TestCase("G28", CheckCodes.NoHeating)]
    [TestCase("", null)]
    public void A_file_with_any_start_code_must_home_and_heat(string start, string? code)
    {
        var setup = SmallPrint.Setup(p => p with { StartGCode = start.Length == 0 ? ValueList<string>.Empty : new(start) });
        var found = SafeWriter.ToDocument(new SmallPrint().Print(30, 10, 0.2).Build(), setup, "a test").Diagnostics.Select(d => d.Code).ToArray();
        if (code is null) Assert.That(found, Has.No.Member(CheckCodes.NoHoming).And.No.Member(CheckCodes.NoHeating));
        else Assert.That(found, Has.Member(code));
    }

    [TestCase("G28\nM109 S200\nG1 X10\nG1 X20 E0.1\n", 0, null)]
    [TestCase("M109 S200\nG1 X10\nG1 X20 E0.1\nG1 X30 E0.1\n", 1, "The file prints before the position in Y, Z is known. Home first, or move in Y, Z.")]
    [TestCase("G28 X\nM109 S200\nG1 Y10\nG1 Y20 E0.1\nG1 Y30 E0.1\n", 0, "The file prints before the position in Z is known. Home first, or move in Z.")]
    [TestCase("G28 Y\nM109 S200\nG1 X10\nG1 X20 E0.1\nG1 X30 E0.1\n", 0, "The file prints before the position in Z is known. Home first, or move in Z.")]
    [TestCase("G28 Z\nM109 S200\nG1 X10\nG1 X20 E0.1\nG1 X30 E0.1\n", 0, "The file prints before the position in Y is known. Home first, or move in Y.")]
    public void Homing_an_axis_makes_its_position_known(string text, int homing, string? message)
    {
        var found = PrintCheck.Run(SmallPrint.Decode(Encoding.ASCII.GetBytes("M83\n" + text + "M104 S0\n"), Setup), Setup);
        Assert.That(found.Where(d => d.Code == CheckCodes.NoHoming).Sum(d => d.Count), Is.EqualTo(homing), "told once");
        Assert.That(found.Where(d => d.Code == CheckCodes.UnknownPosition).Select(d => d.Message), Is.EqualTo(message is null ? [] : new[] { message }));
    }

    [TestCase(";START_OF_HEADER\n;HEADER_VERSION:0.1\n;FLAVOR:Griffin\n;END_OF_HEADER\n", 0)]
    [TestCase(";FLAVOR:Marlin\n", 1)]
    public void Some_firmware_homes_before_the_file_begins(string header, int found)
        => Assert.That(CountAsDetected(header + "M83\nM109 S200\nG1 X10 Y10 Z0.2\nG1 X20 E0.5\nM104 S0\n", CheckCodes.NoHoming), Is.EqualTo(found));

    [Test]
    public void A_file_that_heats_too_late_extrudes_at_0_degrees()
    {
        var file = SmallPrint.Decode(Encoding.ASCII.GetBytes("G28\nM83\nG1 X10 Y10 Z0.2\nG1 X20 E0.5\nM109 S200\nM104 S0\n"), Setup);
        Assert.That(PrintCheck.Run(file, Setup).Single(d => d.Code == CheckCodes.ColdExtrusion).Message, Does.StartWith("A move extrudes at 0 °C, but "));
    }

    [Test]
    public void Some_firmware_heats_before_the_file_begins()
    {
        const string Code = ";FLAVOR:Griffin\nG28\nM83\nG1 X10 Y10 Z0.2\nG1 X20 E0.5\nM109 S200\nM104 S0\n";
        Assert.That(CountAsDetected(Code, CheckCodes.ColdExtrusion), Is.Zero);
        Assert.That(CountAsDetected(Code.Replace("Griffin", "Marlin"), CheckCodes.ColdExtrusion), Is.EqualTo(1));
        var never = Code.Replace("M109 S200\nM104 S0\n", "");
        Assert.That(CountAsDetected(never, CheckCodes.NoHeating), Is.Zero);
        Assert.That(CountAsDetected(never.Replace("Griffin", "Marlin"), CheckCodes.NoHeating), Is.EqualTo(1));
    }

    // A gap of 0.5 mm, and extrusions that go on after it without one.
    [TestCase(SmallPrint.Area, 1)]
    [TestCase(0, 0)]
    public void A_gap_between_extrusions_is_one_finding(double area, int found)
    {
        var print = new SmallPrint(50, 50, 0.2).Print(60, 50, 0.2, area).Go(60.5, 50, 0.2).Print(70, 50, 0.2, area).Print(80, 50, 0.2, area);
        Assert.That(Count(print, CheckCodes.Gap, Setup), Is.EqualTo(found), "strokes of a pen have no extrusions");
    }

    [Test]
    public void What_is_set_after_the_last_move_is_found_too()
    {
        var print = new SmallPrint().Print(30, 10, 0.2).Event(new AccelerationEvent(90_000)).Build();
        var found = SafeWriter.ToDocument(print, Setup).Diagnostics.Single(d => d.Code == CheckCodes.Acceleration);
        Assert.That((found.Count, found.Source?.Move), Is.EqualTo((1, (int?)null)));
    }

    [Test]
    public void The_first_step_of_a_design_is_named_where_it_is_a_command()
    {
        var print = new SmallPrint().Event(new NozzleTemperatureEvent(500)).Print(30, 10, 0.2).Build();
        var source = SmallPrint.Find(print, Setup, CheckCodes.NozzleTemperature).Single().Source!;
        Assert.That((source.Step, source.Move), Is.EqualTo(((int?)0, (int?)0)));
    }

    // The file has one move where the edit has two: a thousandth of length and material may be lost.
    [TestCase("X200 E199.9", 0, 0)]
    [TestCase("X200 E199.797", 0, 0)]
    [TestCase("X200 E200.203", 0, 0)]
    [TestCase("X200 E199.793", 1, 0)]
    [TestCase("X200 E199.5", 1, 0)]
    [TestCase("X199.9 E200", 0, 0)]
    [TestCase("X199.807 E200", 0, 0)]
    [TestCase("X200.193 E200", 0, 0)]
    [TestCase("X199.801 E200", 0, 1)]
    [TestCase("X199.7 E200", 0, 1)]
    public void An_edit_that_joins_moves_keeps_their_material(string extrusion, int amounts, int lengths)
    {
        const string Start = "G28\nM109 S200\nG90\nM83\nG1 X10 Y10 Z0.2 F3000\n";
        var wanted = SmallPrint.Decode(Encoding.ASCII.GetBytes(Start + "G1 X100 E100 F60\nG1 X200 E100\nM104 S0\n"), Setup);
        var joined = GCodeDocument.FromText(Start + $"G1 {extrusion} F60\nM104 S0\n");
        var findings = EditCheck.Run(wanted, wanted.Toolpath, joined, Setup, null, default);
        Assert.That(findings.Count(d => d.Code == CheckCodes.FileExtrusion), Is.EqualTo(amounts));
        Assert.That(findings.Count(d => d.Code == CheckCodes.FilePosition), Is.EqualTo(lengths));
    }

    [Test]
    public void Progress_of_an_overridden_edit_rises_to_1()
    {
        var file = SmallPrint.Decode(Encoding.ASCII.GetBytes("G28\nM109 S200\nM83\nG1 X10 Y10 Z0.2 F3000\nG1 X300 E0.5\nM104 S0\n"), Setup);
        var seen = new Seen();
        Assert.That(SafeWriter.ToDocument(file, file.Toolpath, Setup, "a test", null, seen).Value, Is.Not.Null);
        Assert.That(seen.All, Is.Ordered);
        Assert.That(seen.All, Is.All.InRange(0, 1).And.Some.EqualTo(1));
    }

    private static int Count(SmallPrint print, string code, PrintSetup setup) => SmallPrint.Find(print.Build(), setup, code).Sum(d => d.Count);

    private static int Count(string text, string code)
        => PrintCheck.Run(SmallPrint.Decode(Encoding.ASCII.GetBytes(text), Setup), Setup).Where(d => d.Code == code).Sum(d => d.Count);

    private static int CountAsDetected(string text, string code)
        => PrintCheck.Run(GCodeDecoder.Decode(Encoding.ASCII.GetBytes(text)).Value!, Setup).Where(d => d.Code == code).Sum(d => d.Count);

    private sealed class Seen : IProgress<double>
    {
        public System.Collections.Generic.List<double> All { get; } = [];

        public void Report(double value)
        {
            lock (All) All.Add(value);
        }
    }
}
