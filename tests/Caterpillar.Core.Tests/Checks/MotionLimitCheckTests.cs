using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>Speeds against the limits in force: of the printer, and as the file has set them.</summary>
public class MotionLimitCheckTests
{
    private static readonly PrintSetup Marlin = SmallPrint.Setup(p => p with { Cornering = Cornering.Jerk, MaxSpeed = new(200, 150, 10, 40) });

    private static readonly PrintSetup Klipper =
        SmallPrint.Setup(p => p with { Cornering = Cornering.SquareCornerVelocity, MaxSpeed = new(200, 150, 10, 40) });

    // Of filament in place.
    [TestCase(40, 0)]
    [TestCase(41, 1)]
    public void The_extruder_alone_has_a_greatest_speed(double speed, int found)
    {
        foreach (var setup in new[] { Marlin, Klipper })
        {
            var list = SmallPrint.Find(InPlace(speed), setup, CheckCodes.TravelSpeed);
            Assert.That(list.Select(d => (d.Severity, d.Message)), Is.EqualTo(Enumerable.Repeat(
                (Severity.Note, "An extruder move has a speed of 41 mm/s, but Generic printer allows only 40 mm/s. The printer will slow down."), found)));
        }
    }

    // Half a millimeter of filament for each of the extrusion: 40 mm/s of the extruder are 80 of the head. Klipper lets the head decide.
    [TestCase(79.5, 0)]
    [TestCase(80.5, 1)]
    public void An_extrusion_is_as_fast_as_the_extruder_can_follow(double speed, int found)
    {
        var print = new SmallPrint().Print(30, 10, 0.2, SmallPrint.FilamentArea / 2, Role.Unspecified, speed).Build();
        Assert.That(SmallPrint.Find(print, Marlin, CheckCodes.Speed).Sum(d => d.Count), Is.EqualTo(found));
        Assert.That(SmallPrint.Find(print, Klipper, CheckCodes.Speed), Is.Empty);
        var wipe = Wipe(-0.5, speed);
        Assert.That(SmallPrint.Find(wipe, Marlin, CheckCodes.TravelSpeed).Sum(d => d.Count), Is.EqualTo(found));
        Assert.That(SmallPrint.Find(wipe, Klipper, CheckCodes.TravelSpeed).Sum(d => d.Count), Is.EqualTo(found));
    }

    [TestCase(0, 79.5, 0)]
    [TestCase(0, 80.5, 1)]
    [TestCase(30, 79.5, 0)]
    [TestCase(30, 80.5, 1)]
    public void A_head_that_may_lean_is_as_fast_as_its_extruder(double lean, double speed, int found)
    {
        var setup = Marlin with { Printer = Marlin.Printer with { RotaryAxes = new(RotaryAxis.Parse("B head y at 0 0 60 from -110 to 110")!) } };
        var print = new SmallPrint().Turns(lean, 0, 0).Go(10, 10, 0.2).Print(30, 10, 0.2, SmallPrint.FilamentArea / 2, Role.Unspecified, speed).Build();
        Assert.That(SmallPrint.Find(print, setup, CheckCodes.Speed), Has.Length.EqualTo(found));
    }

    [Test]
    public void Volumes_of_E_are_held_against_the_length_of_the_filament()
    {
        // 0.5 mm³ for each mm at 150 mm/s are 75 mm³/s, but 31.2 mm/s of filament.
        var builder = new ToolpathBuilder(MoveSource.Steps, new(10, 10, 0.2));
        builder.Add(new(30, 10, 0.2), 10, 10, 150, MoveKind.Print, Role.Unspecified, -1, 0, 0);
        Assert.That(SmallPrint.Find(builder.Build([new ToolpathTool(1)]), Marlin, CheckCodes.Speed), Is.Empty);
        builder.Add(new(10, 10, 0.2), 14, 14, 150, MoveKind.Print, Role.Unspecified, -1, 0, 1);
        Assert.That(SmallPrint.Find(builder.Build([new ToolpathTool(1)]), Marlin, CheckCodes.Speed).Single().Source!.Step, Is.EqualTo(1));
    }

    // Along X, along Y, and by 3 : 4.
    [TestCase(20, 0, 200, 150)]
    [TestCase(0, 20, 150, 150)]
    [TestCase(12, 16, 187.5, 150)]
    public void Axes_share_the_speed_and_in_Klipper_the_head_has_one(double x, double y, double marlin, double klipper)
    {
        foreach (var (setup, most) in new[] { (Marlin, marlin), (Klipper, klipper) })
        {
            Assert.That(SmallPrint.Find(Extrusion(x, y, most), setup, CheckCodes.Speed), Is.Empty);
            Assert.That(SmallPrint.Find(Extrusion(x, y, most + 0.1), setup, CheckCodes.Speed), Has.Exactly(1).Items);
        }
    }

    [Test]
    public void A_limit_that_the_file_lowers_holds_from_there_on()
    {
        var print = new SmallPrint().Print(30, 10, 0.2, speed: 100).Event(new LimitEvent(MotionLimit.SpeedX, 50)).Print(60, 10, 0.2, speed: 100)
            .Print(60, 30, 0.2, speed: 100).Event(new LimitEvent(MotionLimit.SpeedX, 120)).Print(90, 30, 0.2, speed: 100);
        var found = SmallPrint.Find(print.Build(), Marlin, "limit.").Single();
        Assert.That((found.Code, found.Count, found.Source!.Move, found.Message),
            Is.EqualTo((CheckCodes.Speed, 1, (int?)1, "A move has a speed of 100 mm/s, but Generic printer allows only 50 mm/s in this direction. "
                + "The printer will slow down.")));
        var shortest = new SmallPrint().Event(new LimitEvent(MotionLimit.SpeedX, 50)).Print(10.5, 10, 0.2, speed: 100);
        Assert.That(SmallPrint.Find(shortest.Build(), Marlin, CheckCodes.Speed).Single().Message, Does.Contain("in this direction. The printer will"));
        var head = new SmallPrint().Event(new LimitEvent(MotionLimit.Speed, 50)).Print(30, 10, 0.2, speed: 60);
        Assert.That(SmallPrint.Find(head.Build(), Klipper, CheckCodes.Speed).Single().Message, Does.Contain("only 50 mm/s"));
        Assert.That(SmallPrint.Find(head.Build(), Marlin, CheckCodes.Speed), Is.Empty, "Marlin has no limit of the head");
    }

    [Test]
    public void A_limit_that_the_file_raises_is_told_and_so_is_the_first_move_beyond_the_printer()
    {
        var print = new SmallPrint().Event(new LimitEvent(MotionLimit.SpeedX, 400)).Print(30, 10, 0.2, speed: 190).Print(60, 10, 0.2, speed: 300)
            .Print(90, 10, 0.2, speed: 500);
        var found = SmallPrint.Find(print.Build(), Marlin, "limit.");
        Assert.That(found.Select(d => (d.Code, d.Severity, d.Count, d.Source!.Move, d.Message)), Is.EqualTo(new[]
        {
            (CheckCodes.Raised, Severity.Note, 1, (int?)0, "The maximum speed of X is raised to 400 mm/s, but Generic printer has 200 mm/s. Lower it."),
            (CheckCodes.Speed, Severity.Warning, 2, 1, "A move has a speed of 300 mm/s, but Generic printer allows only 200 mm/s in this direction. "
                + "The file has raised this limit."),
        }));
    }

    [Test]
    public void Flow_counts_at_the_speed_that_the_file_allows()
    {
        // 0.08 mm² at 100 mm/s are 8 mm³/s, at 50 they are 4.
        var setup = Marlin with { Printer = Marlin.Printer with { MaxFlow = 6, MaxSpeed = new(50, 50, 50, 50) } };
        Assert.That(SmallPrint.Find(Extrusion(20, 0, 100), setup, CheckCodes.Flow), Is.Empty, "the axis slows it down");
        var raised = new SmallPrint().Event(new LimitEvent(MotionLimit.SpeedX, 200)).Print(30, 10, 0.2, speed: 100).Build();
        Assert.That(SmallPrint.Find(raised, setup, CheckCodes.Flow).Single().Message, Does.StartWith("A move needs a flow of 8 mm³/s"));
    }

    [TestCase(215, 0)]
    [TestCase(190, 1)]
    public void Flow_counts_at_the_temperature_of_the_file(double temperature, int found)
    {
        // 8 mm³/s, where the material flows by 5 at 190 °C and by 9 at 210 °C.
        var setup = Marlin with { Material = Marlin.Material with { NozzleTemperature = 210, FlowLimits = new(new FlowLimit(190, 5), new(210, 9)) } };
        var print = new SmallPrint().Event(new NozzleTemperatureEvent(temperature)).Print(30, 10, 0.2, speed: 100).Build();
        Assert.That(SmallPrint.Find(print, setup, CheckCodes.Flow).Count(), Is.EqualTo(found));
    }

    [TestCase(MotionLimit.SpeedX, 200, "The maximum speed of X", "JKS")]
    [TestCase(MotionLimit.SpeedY, 150, "The maximum speed of Y", "JKS")]
    [TestCase(MotionLimit.SpeedZ, 10, "The maximum speed of Z", "JKS")]
    [TestCase(MotionLimit.SpeedE, 40, "The maximum speed of E", "JKS")]
    [TestCase(MotionLimit.JerkX, 8, "The jerk of X", "J")]
    [TestCase(MotionLimit.JerkY, 7, "The jerk of Y", "J")]
    [TestCase(MotionLimit.JerkZ, 0.5, "The jerk of Z", "J")]
    [TestCase(MotionLimit.JerkE, 4, "The jerk of E", "J")]
    [TestCase(MotionLimit.JunctionDeviation, 0.02, "The junction deviation", "K")]
    [TestCase(MotionLimit.SquareCornerVelocity, 6, "The square corner velocity", "S")]
    [TestCase(MotionLimit.Speed, 150, "The maximum speed of the print head", "S")]
    [TestCase(MotionLimit.MinimumCruiseRatio, 0.3, "", "")]
    public void Each_limit_of_the_own_firmware_may_be_set_to_that_of_the_printer_and_no_higher(Enum named, double most, string name, string rules)
    {
        var limit = (MotionLimit)named;
        foreach (var (rule, letter) in new[] { (Cornering.Jerk, 'J'), (Cornering.JunctionDeviation, 'K'), (Cornering.SquareCornerVelocity, 'S') })
        {
            var setup = SmallPrint.Setup(p => p with
            {
                Cornering = rule, MaxSpeed = new(200, 150, 10, 40), Jerk = new(8, 7, 0.5, 4), JunctionDeviation = 0.02, SquareCornerVelocity = 6,
                MinimumCruiseRatio = 0.3,
            });
            Assert.That(Raised(setup, limit, most), Is.Empty);
            Assert.That(Raised(setup, limit, most * 0.5), Is.Empty);
            var found = Raised(setup, limit, most * 1.5);
            Assert.That(found.Length, Is.EqualTo(rules.Contains(letter) ? 1 : 0), $"{rule}");
            if (found.Length > 0) Assert.That(found[0].Message, Does.StartWith(name + " is raised to "));
        }
    }

    [TestCase(MotionLimit.JunctionDeviation, Cornering.JunctionDeviation, 0.02,
        "The junction deviation is raised to 0.05 mm, but Generic printer has 0.02 mm. Lower it.")]
    [TestCase(MotionLimit.JerkE, Cornering.Jerk, 5, "The jerk of E is raised to 12.5 mm/s, but Generic printer has 5 mm/s. Lower it.")]
    public void What_is_raised_is_told_in_its_unit(Enum named, Cornering rule, double own, string message)
    {
        var limit = (MotionLimit)named;
        var setup = SmallPrint.Setup(p => p with { Cornering = rule, JunctionDeviation = 0.02, Jerk = new(5, 5, 5, 5) });
        Assert.That(Raised(setup, limit, own * 2.5).Single().Message, Is.EqualTo(message));
    }

    // Head: the faster of X and Y. The extruder alone has its own.
    [TestCase(MotionLimit.PrintAcceleration, 3000)]
    [TestCase(MotionLimit.TravelAcceleration, 3000)]
    [TestCase(MotionLimit.RetractionAcceleration, 5000)]
    [TestCase(MotionLimit.AccelerationX, 2000)]
    [TestCase(MotionLimit.AccelerationY, 3000)]
    [TestCase(MotionLimit.AccelerationZ, 100)]
    [TestCase(MotionLimit.AccelerationE, 5000)]
    public void Each_acceleration_has_the_limit_of_its_axes(Enum named, double most)
    {
        var limit = (MotionLimit)named;
        var setup = SmallPrint.Setup(p => p with { MaxAcceleration = new(2000, 3000, 100, 5000) });
        Diagnostic[] Found(double value)
            => SmallPrint.Find(new SmallPrint().Event(new LimitEvent(limit, value)).Go(20, 10, 0.2).Build(), setup, CheckCodes.Acceleration);
        Assert.That(Found(most), Is.Empty);
        Assert.That(Found(most + 1).Single().Message, Does.EndWith($"allows only {Figures.Short(most)} mm/s². Lower it."));
    }

    private static Diagnostic[] Raised(PrintSetup setup, MotionLimit limit, double value)
        => SmallPrint.Find(new SmallPrint().Event(new LimitEvent(limit, value)).Go(12, 10, 0.2).Build(), setup, CheckCodes.Raised);

    private static Toolpath Extrusion(double x, double y, double speed) => new SmallPrint().Print(10 + x, 10 + y, 0.2, speed: speed).Build();

    private static Toolpath InPlace(double speed)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new(10, 10, 0.2));
        builder.Add(new(10, 10, 0.2), -1, 0, speed, MoveKind.Retract, Role.Unspecified, -1, 0, 0);
        // Firmware retraction goes by its own speed.
        builder.Add(new(10, 10, 0.2), 0, 0, 500, MoveKind.Deretract, Role.Unspecified, -1, 0, 1);
        return builder.Build([new ToolpathTool(SmallPrint.FilamentArea)]);
    }

    private static Toolpath Wipe(double share, double speed)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new(10, 10, 0.2));
        builder.Add(new(20, 10, 0.2), 10 * share, 0, speed, MoveKind.Wipe, Role.Unspecified, -1, 0, 0);
        return builder.Build([new ToolpathTool(SmallPrint.FilamentArea)]);
    }
}
