using System;
using System.Linq;
using Caterpillar.GCode;
using Caterpillar.Flavors;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using NUnit.Framework;

namespace Caterpillar.Tests.Simulation;

/// <summary>Trapezoids, corners, limits and waits computed by hand.</summary>
public class MotionTests
{
    private const double Exact = 1e-9;

    private static readonly Printer Plain = new()
    {
        Cornering = Cornering.Jerk,
        MaxSpeed = new(500, 500, 10, 50),
        MaxAcceleration = new(5000, 5000, 100, 5000),
        Jerk = new(10, 10, 0.4, 5),
        PrintAcceleration = 1000,
        TravelAcceleration = 2000,
        RetractionAcceleration = 1500,
        LookaheadMoves = 0,
        NozzleHeating = 0,
        BedHeating = 0,
    };

    // Without any jump from rest, so that the numbers stay short.
    private static readonly Printer Rigid = Plain with { Jerk = new(0, 0, 0, 0) };

    [Test]
    public void A_long_travel_speeds_up_runs_and_brakes()
    {
        var t = Trapezoids(Rigid, "G1 X100 F6000").Single();
        Assert.That(t, Is.EqualTo(new Trapezoid(0, 100, 0, 2000, 0.05 + 0.05 + 95.0 / 100)));
        Assert.That(t.SpeedAt(0.025), Is.EqualTo(50).Within(Exact));
        Assert.That(t.DistanceAt(0.025), Is.EqualTo(0.625).Within(Exact));
        Assert.That(t.DistanceAt(0.05), Is.EqualTo(2.5).Within(Exact));
        Assert.That(t.DistanceAt(0.55), Is.EqualTo(52.5).Within(Exact));
        Assert.That(t.SpeedAt(1.025), Is.EqualTo(50).Within(Exact));
        Assert.That(t.DistanceAt(1.025), Is.EqualTo(99.375).Within(Exact));
        Assert.That(t.DistanceAt(9), Is.EqualTo(100).Within(Exact));
        Assert.That(t.SpeedAt(-1), Is.Zero);
    }

    [Test]
    public void A_short_travel_is_a_triangle()
    {
        var t = Trapezoids(Rigid, "G1 X1 F60000").Single();
        Assert.That(t.Peak, Is.EqualTo(Math.Sqrt(2000)).Within(Exact));
        Assert.That(t.Duration, Is.EqualTo(2 * Math.Sqrt(1.0 / 2000)).Within(Exact));
    }

    [TestCase("G1 X100 E4 F6000", 1000, 100, TestName = "printing has its own acceleration")]
    [TestCase("G1 X100 E-4 F6000", 1000, 100, TestName = "so have moves that retract while they move")]
    [TestCase("G1 X100 F6000", 2000, 100, TestName = "travels have another")]
    [TestCase("G1 E-5 F1800", 1500, 30, TestName = "the extruder alone has another")]
    [TestCase("G1 E-5 F6000", 1500, 50, TestName = "the extruder has a highest speed")]
    [TestCase("G1 Z5 F6000", 100, 10, TestName = "so has Z, and less acceleration")]
    [TestCase("G1 X30 Z40 F6000", 125, 12.5, TestName = "the slow axis limits a slanted move by its share")]
    [TestCase("G1 X100 E100 F12000", 1000, 50, TestName = "the extruder limits moves that need much of it")]
    [TestCase("G1 X100", 2000, 25, TestName = "before any F the speed is 25 mm/s")]
    public void The_limits_of_a_move_are_those_of_its_kind_and_axes(string line, double acceleration, double speed)
    {
        var t = Trapezoids(Rigid, line).Single();
        Assert.That(t.Acceleration, Is.EqualTo(acceleration).Within(Exact));
        Assert.That(t.Peak, Is.EqualTo(speed).Within(Exact));
    }

    [Test]
    public void By_jerk_the_machine_starts_and_stops_with_a_jump_of_the_axis_that_allows_least()
    {
        Assert.That(Trapezoids(Plain, "G1 X100 F6000").Single().Start, Is.EqualTo(10).Within(Exact));
        // Both axes jump by 10 at once.
        Assert.That(Trapezoids(Plain, "G1 X100 Y100 F6000").Single().End, Is.EqualTo(10 * Math.Sqrt(2)).Within(Exact));
        Assert.That(Trapezoids(Plain, "G1 Z5 F600").Single().Start, Is.EqualTo(0.4).Within(Exact));
        Assert.That(Trapezoids(Plain, "G1 X100 F300").Single(), Is.EqualTo(new Trapezoid(5, 5, 5, 2000, 20)));
    }

    [TestCase("G1 X100 Y50", 100, TestName = "a gentle turn is taken at full speed where no axis jumps")]
    [TestCase("G1 X50 Y50", 10, TestName = "a right angle at the jerk of an axis")]
    [TestCase("G1 X0 Y0", 10, TestName = "straight back at the jerk on both sides of rest")]
    public void Corners_by_jerk(string second, double speed)
    {
        var first = speed == 100 ? "G1 X50 Y25 F6000" : "G1 X50 Y0 F6000";
        var t = Trapezoids(Plain, first + "\n" + second);
        Assert.That(t[0].End, Is.EqualTo(speed).Within(Exact));
        Assert.That(t[1].Start, Is.EqualTo(speed).Within(Exact));
    }

    [Test]
    public void A_corner_by_jerk_of_45_degrees_is_limited_by_the_axis_that_begins()
    {
        // X falls from v to v/√2, Y rises from 0 to v/√2: that of Y is larger and may be 10.
        var t = Trapezoids(Plain, "G1 X50 F6000\nG1 X85.355339059327378 Y35.355339059327378");
        Assert.That(t[0].End, Is.EqualTo(10 * Math.Sqrt(2)).Within(1e-7));
    }

    // Straight on, 20 mm/s of the extruder more or less: at 100 mm/s it may jump by 5.
    [TestCase(0.1, 0.3, 25)]
    [TestCase(0.3, 0.1, 25)]
    [TestCase(0.1, 0.14, 100)]
    public void A_corner_by_jerk_is_limited_by_the_jump_of_the_extruder(double first, double second, double speed)
    {
        var t = Trapezoids(Plain with { MaxAcceleration = new(5000, 5000, 100, 1e6), MaxSpeed = new(500, 500, 10, 1000) },
            FormattableString.Invariant($"M83\nG1 X50 E{50 * first} F6000\nG1 X100 E{50 * second}"));
        Assert.That(t[0].End, Is.EqualTo(speed).Within(1e-9));
        Assert.That(t[1].Start, Is.EqualTo(speed).Within(1e-9));
    }

    [TestCase("M201 E100", "G1 X100 E50 F3000", 200, 50, TestName = "the acceleration of E by its share of an extrusion")]
    [TestCase("M203 E10", "G1 X100 E50 F3000", 1000, 20, TestName = "the greatest speed of E by its share of an extrusion")]
    [TestCase("M205 E2", "G1 E-5 F1800", 1500, 30, TestName = "the jerk of E does not touch its speed")]
    public void Limits_of_the_extruder_set_in_the_file_hold_for_extrusions(string command, string move, double acceleration, double speed)
    {
        var t = Trapezoids(Rigid, command + "\n" + move).Single();
        Assert.That((t.Acceleration, t.Peak), Is.EqualTo((acceleration, speed)).Within(Exact));
        if (command == "M205 E2") Assert.That((t.Start, t.End), Is.EqualTo((2.0, 2.0)).Within(Exact));
    }

    [TestCase(90)]
    [TestCase(30)]
    [TestCase(150)]
    public void Corners_by_junction_deviation_follow_the_arc_that_touches_both_moves(double turn)
    {
        var printer = Plain with { Cornering = Cornering.JunctionDeviation, JunctionDeviation = 0.02 };
        var radians = turn * Math.PI / 180;
        var line = FormattableString.Invariant($"G1 X{50 + 50 * Math.Cos(radians):F12} Y{50 * Math.Sin(radians):F12}");
        var t = Trapezoids(printer, "G1 X50 F18000\n" + line);
        var half = Math.Cos(radians / 2);
        Assert.That(t[0].End * t[0].End, Is.EqualTo(2000 * 0.02 * half / (1 - half)).Within(1e-7));
        Assert.That(t[0].Start, Is.Zero);
    }

    [Test]
    public void By_junction_deviation_the_acceleration_in_a_corner_is_that_along_the_bisector()
    {
        // X may have 400 only: along (−1, 1)/√2 that is 400 √2.
        var printer = Plain with { Cornering = Cornering.JunctionDeviation, JunctionDeviation = 0.02, MaxAcceleration = new(400, 5000, 100, 5000) };
        var half = Math.Sqrt(0.5);
        var t = Trapezoids(printer, "G1 X50 F18000\nG1 Y50");
        Assert.That(t[0].End * t[0].End, Is.EqualTo(400 * Math.Sqrt(2) * 0.02 * half / (1 - half)).Within(1e-9));
    }

    [Test]
    public void By_junction_deviation_short_pieces_of_a_curve_are_limited_by_its_radius()
    {
        // A 3-4-5 turn in pieces of 0.5 mm: turn = atan2(0.28, 0.96), less than 45°.
        var printer = Plain with { Cornering = Cornering.JunctionDeviation, JunctionDeviation = 5 };
        var t = Trapezoids(printer, "G1 X50 F30000\nG1 X50.48 Y0.14\nG1 X200 Y43.75");
        Assert.That(t[0].End * t[0].End, Is.EqualTo(0.5 * 2000 / Math.Atan2(0.28, 0.96)).Within(1e-6));
    }

    [Test]
    public void Straight_back_by_junction_deviation_is_a_stop_and_E_is_an_axis_of_the_corner()
    {
        var printer = Plain with { Cornering = Cornering.JunctionDeviation, JunctionDeviation = 0.02 };
        Assert.That(Trapezoids(printer, "G1 X50 F6000\nG1 X0")[0].End, Is.Zero);
        // A travel, then the extruder alone: a right angle. Its acceleration of 1500 counts.
        var half = Math.Sqrt(0.5);
        var t = Trapezoids(printer, "G1 X50 F6000\nG1 E5 F1800");
        Assert.That(t[0].End * t[0].End, Is.EqualTo(1500 * 0.02 * half / (1 - half)).Within(Exact));
    }

    [Test]
    public void A_queue_of_two_knows_one_move_ahead_and_must_be_able_to_stop_in_it()
    {
        // Ten pieces of 1 mm in line with 1000 mm/s²: from the second on each may begin with √(2·a·1).
        var lines = string.Join("\n", Enumerable.Range(1, 10).Select(i => $"G1 X{i} E0.1 F60000"));
        var t = Trapezoids(Rigid with { LookaheadMoves = 2 }, "M83\n" + lines);
        Assert.That(t.Skip(1).Select(x => x.Start), Is.All.EqualTo(Math.Sqrt(2000)).Within(Exact));
        Assert.That(t[1].Peak, Is.EqualTo(Math.Sqrt(2000 + 1000)).Within(Exact));
        var whole = Trapezoids(Rigid, "M83\n" + lines);
        Assert.That(whole[4].End, Is.EqualTo(Math.Sqrt(10_000)).Within(Exact));
    }

    [Test]
    public void Dwells_stop_the_machine_and_take_their_time()
    {
        var t = Trapezoids(Rigid, "G1 X10 F6000\nG4 P500\nG1 X20");
        Assert.That(t.Select(x => x.Duration), Is.EqualTo(new[] { 0.15, 0.5, 0.15 }).Within(Exact));
        Assert.That(Trapezoids(Rigid, "G1 X10 F6000\nM400\nG1 X20").Select(x => x.Duration), Is.EqualTo(new[] { 0.15, 0.15 }).Within(Exact));
        Assert.That(Trapezoids(Rigid, "G1 X10 F6000\nG4 P0\nG1 X20")[0].End, Is.Zero);
    }

    [Test]
    public void Waits_for_heat_take_what_is_missing_by_then_at_the_rate_of_the_profile()
    {
        var printer = Rigid with { NozzleHeating = 2, BedHeating = 0.5 };
        // From 20 to 60 °C at 0.5 °C/s; the nozzle heats from the beginning on: 20 + 2·80 = 180 °C by then, 20 more.
        var timeline = Of(printer, "M104 S200\nM190 S60\nM109 S200\nG1 X10 F6000");
        Assert.That(timeline.Trapezoids().Select(x => x.Duration), Is.EqualTo(new[] { 80, 10, 0.15 }).Within(Exact));
        // Nothing waits for cooling, nor for what is hot already.
        Assert.That(Of(printer, "M109 S200\nM109 S150\nM109 S150").Duration, Is.EqualTo(90).Within(Exact));
        Assert.That(Of(printer, "M109 S200\nG4 S20\nM104 S0\nG4 S10\nM109 S200").Duration, Is.EqualTo(90 + 20 + 10 + 10).Within(Exact));
        Assert.That(Of(Rigid, "M109 S200\nM190 S60\nG1 X10 F6000").Duration, Is.EqualTo(0.15).Within(Exact));
    }

    [Test]
    public void Heat_that_is_set_between_moves_begins_when_the_moves_before_it_are_over()
    {
        var timeline = Of(Rigid with { NozzleHeating = 2 }, "G1 X10 F6000\nG1 X20\nM104 S200\nG1 X30\nM109 S200");
        // 0.05 up, 20 mm in all before, then 10 more; the heater has worked for the last move.
        var moves = 0.05 + 0.25;
        Assert.That(timeline.Duration, Is.EqualTo(moves + 0.05 + 90 - (moves + 0.05 - timeline.EndOf(1))).Within(Exact));
    }

    [Test]
    public void Changes_of_the_tool_and_homing_take_the_time_of_the_profile()
    {
        var printer = Rigid with { ToolChangeTime = 7, HomingTime = 12 };
        Assert.That(Of(printer, "G28\nG1 X10 F6000\nT1\nG1 X20\nT1").Duration, Is.EqualTo(12 + 0.15 + 7 + 0.15).Within(Exact));
    }

    [Test]
    public void Firmware_retraction_goes_by_the_numbers_of_the_profile_and_only_once()
    {
        var printer = Rigid with { RetractionLength = 3, RetractionSpeed = 30, DeretractionSpeed = 15, DeretractionExtra = 0.5 };
        var t = Trapezoids(printer, "G1 X10 F6000\nG10\nG10\nG11\nG11");
        double[] expected = [0.15, 2 * 30 / 1500.0 + (3 - 900 / 1500.0) / 30, 2 * 15 / 1500.0 + (3.5 - 225 / 1500.0) / 15];
        Assert.That(t.Select(x => x.Duration), Is.EqualTo(expected).Within(Exact));
    }

    [Test]
    public void Arcs_are_gone_through_in_pieces()
    {
        var t = Trapezoids(Plain with { ArcSegment = 2 }, "G1 X10 F6000\nG2 X10 Y0 I-10 J0");
        Assert.That(t, Has.Length.EqualTo(1 + 31));
        Assert.That(t.Skip(1).Sum(x => x.Length), Is.EqualTo(31 * 2 * 10 * Math.Sin(Math.PI / 31)).Within(1e-9));
    }

    [Test]
    public void E_in_cubic_millimeters_counts_by_the_length_of_the_filament()
    {
        // 10 mm³ of 1.75 mm filament are 4.157… mm.
        var t = Trapezoids(Rigid, "M200 D1.75\nG1 E10 F600").Single();
        Assert.That(t.Length, Is.EqualTo(10 / (Math.PI * 0.875 * 0.875)).Within(Exact));
    }

    [TestCase("M204 S500", "G1 X100 E1 F6000", 500)]
    [TestCase("M204 S500", "G1 X100 F6000", 500)]
    [TestCase("M204 P600", "G1 X100 E1 F6000", 600)]
    [TestCase("M204 P600", "G1 X100 F6000", 2000)]
    [TestCase("M204 T700", "G1 X100 F6000", 700)]
    [TestCase("M204 R800", "G1 E-5 F1800", 800)]
    [TestCase("M201 X300", "G1 X100 F6000", 300)]
    [TestCase("M201 E250", "G1 E-5 F1800", 250)]
    public void Accelerations_set_in_the_file_hold_from_there_on(string command, string move, double acceleration)
    {
        var t = Trapezoids(Rigid, $"G1 Y10 F6000\n{command}\n{move}");
        Assert.That(t[1].Acceleration, Is.EqualTo(acceleration).Within(Exact));
        Assert.That(t[0].Acceleration, Is.EqualTo(2000));
    }

    [Test]
    public void Speeds_jerks_and_deviation_set_in_the_file_hold_from_there_on()
    {
        Assert.That(Trapezoids(Rigid, "M203 X40\nG1 X100 F6000").Single().Peak, Is.EqualTo(40));
        Assert.That(Trapezoids(Plain, "M205 X4\nG1 X100 F6000").Single().Start, Is.EqualTo(4).Within(Exact));
        var printer = Plain with { Cornering = Cornering.JunctionDeviation };
        var half = Math.Sqrt(0.5);
        Assert.That(Trapezoids(printer, "M205 J0.1\nG1 X50 F6000\nG1 Y50")[0].End, Is.EqualTo(Math.Sqrt(2000 * 0.1 * half / (1 - half))).Within(Exact));
    }

    [Test]
    public void RepRapFirmware_states_speeds_by_the_minute()
    {
        Assert.That(Trapezoids(Rigid, "M203 X2400\nG1 X100 F6000", "reprapfirmware").Single().Peak, Is.EqualTo(40).Within(Exact));
        Assert.That(Trapezoids(Rigid, "M566 X240\nG1 X100 F6000", "reprapfirmware").Single().Start, Is.EqualTo(4).Within(Exact));
        Assert.That(Trapezoids(Rigid, "M204 P300 T400\nG1 X100 F6000", "reprapfirmware").Single().Acceleration, Is.EqualTo(400));
    }

    [Test]
    public void Klipper_takes_limits_by_name_and_P_and_T_of_M204_only_together()
    {
        var printer = Plain with { Cornering = Cornering.SquareCornerVelocity, MaxAcceleration = new(3000, 4000, 100, 5000), MinimumCruiseRatio = 0.5 };
        Trapezoid First(string lines) => Trapezoids(printer, lines + "\nG1 X100 F12000\nG1 Y100", "klipper")[0];
        Assert.That(First("").Acceleration, Is.EqualTo(3000));
        Assert.That(First("").End, Is.EqualTo(5).Within(Exact));
        Assert.That(First("M204 S700").Acceleration, Is.EqualTo(700));
        Assert.That(First("M204 P800").Acceleration, Is.EqualTo(3000));
        Assert.That(First("M204 P800 T600").Acceleration, Is.EqualTo(600));
        Assert.That(First("SET_VELOCITY_LIMIT ACCEL=900 VELOCITY=60").Peak, Is.EqualTo(60).Within(Exact));
        Assert.That(First("SET_VELOCITY_LIMIT ACCEL=900").Acceleration, Is.EqualTo(900));
        Assert.That(First("SET_VELOCITY_LIMIT SQUARE_CORNER_VELOCITY=8").End, Is.EqualTo(8).Within(Exact));
        // 1 mm from rest to rest: v² = 3000 without the second profile, 1500 with half of the acceleration.
        Assert.That(Trapezoids(printer, "G1 X1 F60000", "klipper").Single().Peak, Is.EqualTo(Math.Sqrt(1500)).Within(Exact));
        var free = Trapezoids(printer, "SET_VELOCITY_LIMIT MINIMUM_CRUISE_RATIO=0\nG1 X1 F60000", "klipper").Single();
        Assert.That(free.Peak, Is.EqualTo(Math.Sqrt(3000)).Within(Exact));
    }

    [Test]
    public void A_toolpath_without_moves_takes_no_time()
    {
        Assert.That(Of(Plain, "").Duration, Is.Zero);
        Assert.That(Of(Plain, "G92 X5\nG1 F600\nM106 S20").Duration, Is.Zero);
    }

    [Test]
    public void Planning_can_be_cancelled()
    {
        var toolpath = Of(Plain, "G1 X10 F6000").Toolpath;
        var cancelled = new System.Threading.CancellationToken(true);
        Assert.That(() => Timeline.Of(toolpath, new PrintSetup(), null, cancelled), Throws.InstanceOf<OperationCanceledException>());
    }

    [Test]
    public void With_a_short_queue_the_last_pieces_brake_to_the_speed_that_the_jerk_allows()
    {
        // Eight pieces of 1 mm at 2000 mm/s²: v² grows and falls by 4000 in each, from and to 10 mm/s.
        var lines = string.Join("\n", Enumerable.Range(1, 8).Select(x => $"G1 X{x} F6000"));
        var last = Trapezoids(Plain with { LookaheadMoves = 4 }, lines).Last();
        Assert.That(last.Start, Is.EqualTo(Math.Sqrt(100 + 4000)).Within(Exact));
        Assert.That(last.End, Is.EqualTo(10).Within(Exact));
    }

    private static Trapezoid[] Trapezoids(Printer printer, string lines, string flavor = "marlin2") => Of(printer, lines, flavor).Trapezoids().ToArray();

    private static Timeline Of(Printer printer, string lines, string flavor = "marlin2")
    {
        var document = GCodeDocument.FromBytes(System.Text.Encoding.ASCII.GetBytes(lines + "\n"), "program");
        var toolpath = GCodeDecoder.Decode(document, new DecodeOptions { Flavor = FlavorTable.Find(flavor) }).Value!.Toolpath;
        return Timeline.Of(toolpath, new PrintSetup { Printer = printer });
    }
}
