using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Simulation;

/// <summary>Slow moves, directions close to the vertical, and when a long run is divided.</summary>
public class MotionDetailTests
{
    [Test]
    public void A_move_slower_than_1_mm_per_second_cruises()
    {
        // Half a second up and half a second down at 1 mm/s², which are 0.25 mm; the rest at 0.5 mm/s.
        var t = Trapezoid.Over(10, 0, 0.25, 0, 1);
        Assert.That(t, Is.EqualTo(new Trapezoid(0, 0.5, 0, 1, 1 + 9.75 / 0.5)));
    }

    [Test]
    public void A_move_without_length_and_speed_takes_no_time() => Assert.That(Trapezoid.Over(0, 0, 0, 0, 1).Duration, Is.Zero);

    [TestCase(1.2e-9, true)]
    [TestCase(1e-9, false)]
    [TestCase(0.9e-9, false)]
    public void A_motion_straight_up_has_the_axes_of_the_world(double y, bool turned)
        => Assert.That(new MachineState { Head = Frame.World, Direction = new Vec3(0, y, 1) }.Frame.X, Is.EqualTo(turned ? Vec3.UnitY : Vec3.UnitX));

    [Test]
    public void Firmware_retracts_once_and_restores_at_a_speed_of_its_own()
    {
        var printer = new Printer { RetractionLength = 2, RetractionSpeed = 40, DeretractionSpeed = 0.5, DeretractionExtra = 0.25 };
        var retraction = new FirmwareRetraction(printer);
        MoveKind[] kinds = [MoveKind.Deretract, MoveKind.Retract, MoveKind.Retract, MoveKind.Deretract, MoveKind.Deretract];
        Assert.That(kinds.Select(retraction.Move), Is.EqualTo(new[] { (0.0, 0.0), (-2, 40), (0, 0), (2.25, 0.5), (0, 0) }));
    }

    // The settings of a slicer: usual and silent; older Marlin travels with the acceleration of extrusions.
    [TestCase("marlin", false, 1500)]
    [TestCase("marlin2", false, 3000)]
    [TestCase("marlin2", true, 2000)]
    [TestCase(null, false, 3000)]
    public void Limits_of_a_slicer_depend_on_the_flavor_of_its_code(string? flavor, bool silent, double travel)
    {
        var settings = new Dictionary<string, string>
        {
            ["machine_max_acceleration_extruding"] = "1500,1000", ["machine_max_acceleration_travel"] = "3000,2000",
            ["machine_max_acceleration_retracting"] = "800",
        };
        foreach (var (name, value) in new[] { ("feedrate", "200, 100"), ("acceleration", "5000"), ("jerk", "8,4") })
        {
            foreach (var axis in "xyze") settings[$"machine_max_{name}_{axis}"] = value;
        }
        if (flavor is not null) settings["gcode_flavor"] = flavor;
        var printer = SlicerLimits.Of(settings, new Printer(), silent)!;
        Assert.That((printer.TravelAcceleration, printer.PrintAcceleration, printer.RetractionAcceleration),
            Is.EqualTo((travel, silent ? 1000.0 : 1500, 800.0)));
        Assert.That((printer.MaxSpeed.X, printer.MaxAcceleration.Y, printer.Jerk.E), Is.EqualTo((silent ? 100.0 : 200, 5000.0, silent ? 4.0 : 8)));
    }

    // All segments enter at the same square of the speed. From the end on the slower profile gains slowGain with each, the faster one twice the acceleration:
    // nothing changes any more where the faster one reaches the entry and the slower one more than that.
    [TestCase(95, 10, 10, 10)]
    [TestCase(100, 10, 10, 11)]
    [TestCase(90, 5, 20, 9)]
    [TestCase(91, 5, 20, 10)]
    public void A_run_is_divided_as_close_to_its_end_as_it_can_be_braked(double speed2, double acceleration, double slowGain, int kept)
    {
        var segment = new MotionSegment { Length = 1, Acceleration = acceleration, Speed2 = speed2, Entry2 = speed2, SlowGain = slowGain };
        Assert.That(new CruiseLookAhead().Plan(Enumerable.Repeat(segment, 2000).ToArray(), 2000, ends: false), Is.EqualTo(2000 - kept));
    }
}
