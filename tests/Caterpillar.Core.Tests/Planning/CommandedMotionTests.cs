using System;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Planning;

/// <summary>Accelerations and jerk by role, as they are planned, written, read back and timed.</summary>
public class CommandedMotionTests
{
    private static readonly Layer Second = new(1, 0.4, 0.2);

    // Every corner is a stop.
    private static readonly Printer Rigid = new()
    {
        Cornering = Cornering.Jerk, Jerk = new(0, 0, 0, 0), MaxSpeed = new(500, 500, 10, 50), MaxAcceleration = new(5000, 5000, 100, 5000),
        PrintAcceleration = 1000, TravelAcceleration = 2000, RetractionAcceleration = 1500, LookaheadMoves = 0, RetractionLength = 0,
    };

    private static readonly PrintSettings Settings = new()
    {
        OuterWallSpeed = 50, PrintSpeed = 60, TravelSpeed = 100, ZHopType = ZHopType.None, SortPaths = false, SeamGap = 0,
        OuterWallAcceleration = 500, InnerWallAcceleration = 2000, TravelMoveAcceleration = 3000,
    };

    private static PathStep Square(Role role, double side, Layer layer, int group)
    {
        Vec3[] corners = [new(50, 50, layer.Z), new(50 + side, 50, layer.Z), new(50 + side, 50 + side, layer.Z), new(50, 50 + side, layer.Z)];
        return new PathStep(new PrintPath(corners, new Bead(0.08, 0.2), closed: true) with { Role = role, Layer = layer }, new StepGroup(group));
    }

    // An inner wall of 18 mm and an outer one of 20 mm, from one corner; then a line elsewhere.
    private static Toolpath TwoRoles(PrintSetup setup)
    {
        var line = new PrintPath([new(100, 50, 0.4), new(140, 50, 0.4)], new Bead(0.08, 0.2)) with { Role = Role.Infill, Layer = Second };
        Step[] steps = [Square(Role.InnerWall, 18, Second, 0), Square(Role.OuterWall, 20, Second, 1), new PathStep(line, new StepGroup(2))];
        return Planner.Plan(steps, setup, new PlanOptions { Start = new Vec3(20, 50, 0.4) }).Value!;
    }

    private static string Text(Toolpath toolpath, FlavorRules flavor)
        => Encoding.ASCII.GetString(NewFile.Of(toolpath, new GCodeFormat(NewFile.Machine with { Flavor = flavor })));

    private static string[] Lines(PrintSetup setup, params string[] commands)
        => Text(TwoRoles(setup), setup.Printer.Flavor).Split('\n').Where(l => commands.Any(c => l.StartsWith(c, StringComparison.Ordinal))).ToArray();

    private static FlavorRules Flavor(string name) => FlavorTable.All.Single(f => f.Name == name);

    [Test]
    public void A_square_of_two_roles_takes_the_time_of_its_accelerations()
    {
        var setup = new PrintSetup(Rigid, new Material(), Settings);
        var times = PrintStatistics.Of(Timeline.Of(TwoRoles(setup), setup)).Roles.ToDictionary(r => r.Role, r => r.Time);
        // A side takes length / speed + speed / acceleration.
        Assert.That(times[Role.InnerWall], Is.EqualTo(4 * (18.0 / 60 + 60.0 / 2000)).Within(1e-9));
        Assert.That(times[Role.OuterWall], Is.EqualTo(4 * (20.0 / 50 + 50.0 / 500)).Within(1e-9));
        Assert.That(times[Role.Infill], Is.EqualTo(40.0 / 60 + 60.0 / 1000).Within(1e-9), "the printer's own");
        // 30 mm to the first wall and 50 mm to the line.
        Assert.That(PrintStatistics.Of(Timeline.Of(TwoRoles(setup), setup)).TravelTime, Is.EqualTo(0.3 + 0.5 + 2 * 100.0 / 3000).Within(1e-9));
    }

    [TestCase("marlin2", "M204 T3000|M204 P2000|M204 P500|M204 P1000")]
    [TestCase("reprapfirmware", "M204 T3000|M204 P2000|M204 P500|M204 P1000")]
    [TestCase("marlin1", "M204 S3000|M204 S2000|M204 S500|M204 S3000|M204 S1000")]
    [TestCase("prusa", "M204 S3000|M204 S2000|M204 S500|M204 S3000|M204 S1000")]
    [TestCase("bambu", "M204 S3000|M204 S2000|M204 S500|M204 S3000|M204 S1000")]
    [TestCase("klipper", "M204 S3000|M204 S2000|M204 S500|M204 S3000|M204 S1000")]
    [TestCase("smoothie", "M204 S3000|M204 S2000|M204 S500|M204 S3000|M204 S1000")]
    [TestCase("ultigcode", "M204 S3000|M204 S2000|M204 S500|M204 S3000|M204 S1000")]
    [TestCase("repetier", "M202 X3000 Y3000|M201 X2000 Y2000|M201 X500 Y500|M201 X1000 Y1000")]
    [TestCase("grbl", "")]
    [TestCase("sailfish", "")]
    [TestCase("bfb", "")]
    [TestCase("cnc", "")]
    public void Each_flavor_has_its_commands_for_accelerations(string flavor, string lines)
    {
        var setup = new PrintSetup(Rigid with { Flavor = Flavor(flavor) }, new Material(), Settings);
        Assert.That(Lines(setup, "M204", "M201", "M202", "SET_"), Is.EqualTo(lines.Split(['|'], StringSplitOptions.RemoveEmptyEntries)));
        var found = setup.Check().Where(d => d.Code == "setup.no_command").ToArray();
        Assert.That(found, Has.Length.EqualTo(lines.Length == 0 ? 1 : 0));
        if (lines.Length == 0) Assert.That(found[0].Message, Does.Contain(": outer_wall_acceleration_mm_s2, inner_wall_acceleration_mm_s2"));
    }

    [TestCase("marlin2", Cornering.Jerk, "M205 X6 Y6|M205 X8 Y8|M205 X4 Y4|M205 X6 Y6|M205 X8 Y8")]
    [TestCase("reprapfirmware", Cornering.Jerk, "M566 X360 Y360|M566 X480 Y480|M566 X240 Y240|M566 X360 Y360|M566 X480 Y480")]
    [TestCase("repetier", Cornering.Jerk, "M207 X6|M207 X8|M207 X4|M207 X6|M207 X8")]
    [TestCase("klipper", Cornering.SquareCornerVelocity, "SET_VELOCITY_LIMIT SQUARE_CORNER_VELOCITY=5|SET_VELOCITY_LIMIT SQUARE_CORNER_VELOCITY=4|"
        + "SET_VELOCITY_LIMIT SQUARE_CORNER_VELOCITY=5")]
    [TestCase("marlin2", Cornering.JunctionDeviation, "")]
    [TestCase("smoothie", Cornering.Jerk, "")]
    [TestCase("grbl", Cornering.Jerk, "")]
    public void Each_flavor_has_its_commands_for_jerk(string flavor, Cornering cornering, string lines)
    {
        var printer = Rigid with { Flavor = Flavor(flavor), Cornering = cornering, Jerk = new(8, 8, 0.4, 5), SquareCornerVelocity = 5 };
        var settings = new PrintSettings { ZHopType = ZHopType.None, SortPaths = false, OuterWallJerk = 4, TravelMoveJerk = 6 };
        var setup = new PrintSetup(printer, new Material(), settings);
        Assert.That(Lines(setup, "M20", "M566", "SET_"), Is.EqualTo(lines.Split(['|'], StringSplitOptions.RemoveEmptyEntries)));
        Assert.That(setup.Check().Count(d => d.Code == "setup.no_command"), Is.EqualTo(lines.Length == 0 ? 1 : 0));
    }

    [Test]
    public void A_decoded_file_takes_as_long_as_its_plan(
        [Values("marlin1", "marlin2", "prusa", "reprapfirmware", "repetier", "klipper", "smoothie")] string flavor,
        [Values(Cornering.Jerk, Cornering.SquareCornerVelocity)] Cornering cornering)
    {
        var printer = Rigid with { Flavor = Flavor(flavor), Cornering = cornering, Jerk = new(8, 8, 0.4, 5), SquareCornerVelocity = 5 };
        var setup = new PrintSetup(printer, new Material(), Settings with { OuterWallJerk = 2.5, TravelMoveJerk = 6, InfillAcceleration = 777.7 });
        var plan = TwoRoles(setup);
        var text = "G92 X20 Y50 Z0.4\n" + Text(plan, printer.Flavor);
        var decoded = GCodeDecoder.Decode(Encoding.ASCII.GetBytes(text), new DecodeOptions { Flavor = printer.Flavor }).Value!;
        Assert.That(Timeline.Of(decoded.Toolpath, setup).Duration, Is.EqualTo(Timeline.Of(plan, setup).Duration).Within(1e-4), text);
    }

    [Test]
    public void Nothing_goes_beyond_the_printer()
    {
        var settings = Settings with { OuterWallAcceleration = 9000, OuterWallJerk = 20, TravelMoveAcceleration = 8000 };
        var setup = new PrintSetup(Rigid with { Jerk = new(8, 8, 0.4, 5) }, new Material(), settings);
        Assert.That(Lines(setup, "M204", "M205"), Does.Contain("M204 P5000").And.Contain("M204 T5000").And.Contain("M205 X8 Y8"));
        Assert.That(setup.Check().Select(d => (d.Severity, d.Message)), Is.EqualTo(new[]
        {
            (Severity.Note, "Generic printer limits outer_wall_acceleration_mm_s2 to 5000 mm/s², travel_move_acceleration_mm_s2 to 5000 mm/s², "
                + "outer_wall_jerk_mm_s to 8 mm/s."),
        }));
    }

    [TestCase(Role.OuterWall, 1)]
    [TestCase(Role.OverhangWall, 1)]
    [TestCase(Role.InnerWall, 2)]
    [TestCase(Role.GapFill, 2)]
    [TestCase(Role.Infill, 3)]
    [TestCase(Role.SolidInfill, 4)]
    [TestCase(Role.BottomSurface, 4)]
    [TestCase(Role.TopSurface, 5)]
    [TestCase(Role.Ironing, 5)]
    [TestCase(Role.Bridge, 6)]
    [TestCase(Role.Support, 7)]
    [TestCase(Role.SupportInterface, 7)]
    [TestCase(Role.Skirt, 1000)]
    [TestCase(Role.Unspecified, 1000)]
    public void Each_role_has_its_acceleration(Role role, double expected)
    {
        var settings = new PrintSettings
        {
            OuterWallAcceleration = 1, InnerWallAcceleration = 2, InfillAcceleration = 3, SolidInfillAcceleration = 4, TopSurfaceAcceleration = 5,
            BridgeAcceleration = 6, SupportAcceleration = 7, FirstLayerAcceleration = 6.5,
        };
        Assert.That(settings.AccelerationOf(role, false, 1000), Is.EqualTo(expected));
        Assert.That(settings.AccelerationOf(role, true, 1000), Is.EqualTo(Math.Min(expected, 6.5)));
    }

    [Test]
    public void The_first_layer_has_a_maximum_of_its_own()
    {
        var first = new Layer(0, 0.2, 0.2);
        Step[] steps = [Square(Role.OuterWall, 20, first, 0), Square(Role.OuterWall, 20, Second, 1)];
        var setup = new PrintSetup(Rigid, new Material(), Settings with { TravelMoveAcceleration = 0, FirstLayerAcceleration = 300, FirstLayerJerk = 0 });
        var limits = Planner.Plan(steps, setup).Value!.Events.Select(e => e.Event).OfType<LimitEvent>();
        Assert.That(limits, Is.EqualTo(new[] { new LimitEvent(MotionLimit.PrintAcceleration, 300), new LimitEvent(MotionLimit.PrintAcceleration, 500) }));
    }

    [Test]
    public void A_design_that_sets_the_acceleration_has_its_way()
    {
        var path = Square(Role.OuterWall, 20, Second, 1).Path;
        Step[] steps =
        [
            new EventStep(new AccelerationEvent(250)), new PathStep(path, new StepGroup(0)),
            new PathStep(path with { Role = Role.OuterWall, Layer = Second, Overrides = new PathOverrides(Acceleration: 150) }, new StepGroup(1)),
        ];
        var setup = new PrintSetup(Rigid, new Material(), Settings);
        var events = Planner.Plan(steps, setup, new PlanOptions { Start = new Vec3(20, 50, 0.4) }).Value!.Events.Select(e => e.Event);
        PrinterEvent[] expected = [new AccelerationEvent(250), new LimitEvent(MotionLimit.PrintAcceleration, 150)];
        Assert.That(events.Where(e => e is not FanEvent), Is.EqualTo(expected));
    }

    [Test]
    public void Without_keys_nothing_is_commanded()
    {
        var setup = new PrintSetup(Rigid, new Material(), new PrintSettings());
        Assert.That(TwoRoles(setup).Events.Select(e => e.Event).Where(e => e is LimitEvent or AccelerationEvent), Is.Empty);
        Assert.That(setup.Check(), Is.Empty);
    }

    [TestCase("outer_wall_acceleration_mm_s2=-5", "profile.out_of_range")]
    [TestCase("outer_wall_jerk_mm_s=fast", "profile.wrong_type")]
    public void Bad_values_name_their_key(string value, string code)
    {
        var problem = new PrintSetup().With(value).Diagnostics.Single();
        Assert.That((problem.Code, problem.Source!.Key), Is.EqualTo((code, value.Split('=')[0])));
    }
}
