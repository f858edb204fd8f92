using System;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>Which moves a rule counts and which it leaves out: roles, arcs, unknown places, other axes.</summary>
public class CheckRuleTests
{
    private static readonly PrintSetup Setup = SmallPrint.Setup();

    // F with two decimals: a unit is 0.00017 mm/s.
    [TestCase(2, 40.0001, 0)]
    [TestCase(2, 40.0003, 1)]
    [TestCase(0, 40.0003, 0)]
    public void Decimals_of_F_say_what_is_above_a_speed(int decimals, double speed, int found)
    {
        var setup = SmallPrint.Setup(p => p with { MaxSpeed = new(40, 40, 40, 40), DecimalsF = decimals });
        Assert.That(SmallPrint.Find(new SmallPrint().Print(30, 10, 0.2, speed: speed).Build(), setup, CheckCodes.Speed).Length, Is.EqualTo(found));
    }

    [TestCase(true, 0)]
    [TestCase(false, 1)]
    public void A_gap_needs_a_straight_extrusion_before_it(bool arc, int found)
    {
        var print = new SmallPrint(50, 50, 0.2).Print(60, 50, 0.2);
        if (arc) print.Arc(66, 50, 0.2, new Vec3(63, 46, 0.2), -74, SmallPrint.Area);
        else print.Print(66, 50, 0.2);
        print.Go(66.5, 50, 0.2).Print(80, 50, 0.2);
        Assert.That(SmallPrint.Find(print.Build(), Setup, CheckCodes.Gap).Length, Is.EqualTo(found));
    }

    [TestCase(Role.Infill, 1)]
    [TestCase(Role.Support, 0)]
    [TestCase(Role.SupportInterface, 0)]
    public void Between_pieces_of_supports_there_is_no_gap(Role role, int found)
    {
        var print = new SmallPrint(50, 50, 0.2).Print(60, 50, 0.2, SmallPrint.Area, role).Go(60.5, 50, 0.2).Print(70, 50, 0.2, SmallPrint.Area, role);
        Assert.That(SmallPrint.Find(print.Build(), Setup, CheckCodes.Gap).Length, Is.EqualTo(found));
    }

    [Test]
    public void After_homing_a_extrusion_begins_anew_for_what_hangs()
    {
        // 4 mm at each side of a homing that ends where the extrusion was left; 5 mm may hang.
        var print = new SmallPrint(50, 50, 20).Go(50, 50, 4).Print(54, 50, 4).Event(new HomeEvent()).Go(54, 50, 4).Print(58, 50, 4).Go(80, 80, 4);
        Assert.That(SmallPrint.Find(print.Build(), Setup, CheckCodes.Unsupported), Is.Empty);
        var through = new SmallPrint(50, 50, 20).Go(50, 50, 4).Print(54, 50, 4).Print(58, 50, 4).Go(80, 80, 4);
        Assert.That(SmallPrint.Find(through.Build(), Setup, CheckCodes.Unsupported), Has.Exactly(1).Items);
    }

    [Test]
    public void A_file_that_heats_itself_begins_cold()
    {
        const string Text = "G28\nG90\nM83\nG1 X10 Y10 Z0.2 F3000\nG1 X20 E0.3\nM109 S200\nG1 X30 E0.3\nM104 S0\n";
        var found = PrintCheck.Run(SmallPrint.Decode(Encoding.ASCII.GetBytes(Text), Setup), Setup).Single(d => d.Code == CheckCodes.ColdExtrusion);
        Assert.That((found.Message, found.Count), Is.EqualTo(("A move extrudes at 0 °C, but Generic printer needs 170 °C. Heat the nozzle first.", 1)));
    }

    // An area of 20 × 20 mm; the edges do not belong to it, and a thousandth of a millimeter is not looked at.
    [TestCase(50.0005, 0)]
    [TestCase(50.002, 1)]
    [TestCase(69.998, 1)]
    [TestCase(69.9995, 0)]
    public void An_extrusion_along_the_edge_of_an_excluded_area_is_beside_it(double y, int found)
    {
        var setup = SmallPrint.Setup(p => p with { ExcludedAreas = new(new Bounds(new Vec3(50, 50), new Vec3(70, 70))) });
        foreach (var swap in new[] { false, true })
        {
            var print = swap ? new SmallPrint(y, 40, 0.2).Print(y, 90, 0.2) : new SmallPrint(40, y, 0.2).Print(90, y, 0.2);
            Assert.That(SmallPrint.Find(print.Build(), setup, CheckCodes.ExcludedArea).Length, Is.EqualTo(found), $"{swap}");
            var back = swap ? new SmallPrint(y, 90, 0.2).Print(y, 40, 0.2) : new SmallPrint(90, y, 0.2).Print(40, y, 0.2);
            Assert.That(SmallPrint.Find(back.Build(), setup, CheckCodes.ExcludedArea).Length, Is.EqualTo(found), $"{swap}, back");
        }
        // It ends before the area, or begins after it.
        Assert.That(SmallPrint.Find(new SmallPrint(40, 60, 0.2).Print(49.9, 60, 0.2).Build(), setup, CheckCodes.ExcludedArea), Is.Empty);
        Assert.That(SmallPrint.Find(new SmallPrint(70.1, 60, 0.2).Print(90, 60, 0.2).Build(), setup, CheckCodes.ExcludedArea), Is.Empty);
        Assert.That(SmallPrint.Find(new SmallPrint(40, 72, 0.2).Print(72, 40, 0.2).Build(), setup, CheckCodes.ExcludedArea), Has.Exactly(1).Items, "a corner");
        Assert.That(SmallPrint.Find(new SmallPrint(40, 55, 0.2).Print(55, 40, 0.2).Build(), setup, CheckCodes.ExcludedArea), Is.Empty, "past a corner");
    }

    [TestCase(Role.OuterWall, 1)]
    [TestCase(Role.Purge, 0)]
    public void What_is_purged_may_hang(Role role, int found)
    {
        var print = new SmallPrint(50, 50, 20).Go(50, 50, 4).Print(70, 50, 4, SmallPrint.Area, role).Go(80, 80, 4);
        Assert.That(SmallPrint.Find(print.Build(), Setup, CheckCodes.Unsupported).Length, Is.EqualTo(found));
    }

    // 10 mm of an extrusion of 0.04 mm.
    [TestCase(Role.OuterWall, 1)]
    [TestCase(Role.Infill, 1)]
    [TestCase(Role.Ironing, 0)]
    [TestCase(Role.GapFill, 0)]
    [TestCase(Role.Purge, 0)]
    public void Ironing_and_gap_fill_may_be_thin(Role role, int found)
    {
        var print = new SmallPrint(50, 50, 20).Go(50, 50, 0.2).Print(60, 50, 0.2, 0.001, role);
        Assert.That(SmallPrint.Find(print.Build(), Setup, CheckCodes.Width).Length, Is.EqualTo(found));
    }

    // The same line twice.
    [TestCase(Role.OuterWall, 1)]
    [TestCase(Role.Ironing, 0)]
    [TestCase(Role.GapFill, 0)]
    [TestCase(Role.PrimeTower, 0)]
    public void Ironing_gap_fill_and_prime_towers_may_lie_on_others(Role role, int found)
    {
        var print = new SmallPrint(50, 50, 0.2).Print(100, 50, 0.2).Go(100, 50, 5).Go(50, 50, 0.2).Print(100, 50, 0.2, SmallPrint.Area, role);
        Assert.That(SmallPrint.Find(print.Build(), Setup, CheckCodes.Duplicate).Length, Is.EqualTo(found));
    }

    // A wall of 25 mm on 8 mm² beside a patch of 200 mm².
    [TestCase(Role.Brim, 0)]
    [TestCase(Role.SolidInfill, 0)]
    [TestCase(Role.Skirt, 1)]
    [TestCase(Role.Purge, 1)]
    public void A_skirt_holds_nothing(Role role, int found)
    {
        var print = new SmallPrint(100, 100, 0.2);
        for (var k = 0; k < 20; k++) print.Print(k % 2 == 0 ? 125 : 100, 100 + 0.4 * k, 0.2, SmallPrint.Area, role).Go(print.At.X, print.At.Y + 0.4, 0.2);
        Assert.That(SmallPrint.Find(print.Wall(50, 70, 50, 25).Build(), Setup, CheckCodes.FirstLayer).Length, Is.EqualTo(found));
    }

    [Test]
    public void An_extrusion_that_is_squeezed_onto_the_bed_stands_on_twice_its_width_at_most()
    {
        // 20 mm of 0.08 mm², 0.05 mm above the bed, as if half a layer high: 16 mm².
        var print = new SmallPrint(50, 50, 0.05).Print(70, 50, 0.05);
        for (var k = 1; k <= 200; k++) print.Go(print.At.X, 50, 0.05 + 0.2 * k).Print(k % 2 == 1 ? 50 : 70, 50, 0.05 + 0.2 * k);
        var setup = Setup with { Settings = new PrintSettings { LayerHeight = 0.2, FirstLayerHeight = 0.2 } };
        Assert.That(SmallPrint.Find(print.Build(), setup, CheckCodes.FirstLayer).Single().Message,
            Is.EqualTo("The print is 40.05 mm high, but only 16 mm² of it touch the bed. Add a brim."));
    }

    [Test]
    public void Of_layers_that_are_too_high_the_highest_is_the_worst()
    {
        var print = new SmallPrint(50, 50, 20);
        foreach (var height in new[] { 0.45, 0.6, 0.5 })
            print.Go(50, 50, 20).InLayer(new Layer(0, height, height)).Go(50, 50, height).Print(70, 50, height, 0.9 * height * height).Go(70, 50, 20);
        var found = SmallPrint.Find(print.Build(), Setup, CheckCodes.Height).Single();
        Assert.That((found.Message, found.Worst!.Message), Is.EqualTo(
            ("A layer is 0.45 mm high, more than the nozzle diameter of 0.4 mm. Lower it.",
                "A layer is 0.6 mm high, more than the nozzle diameter of 0.4 mm. Lower it.")));
    }

    [Test]
    public void The_share_of_moves_that_pull_back_is_told()
    {
        var text = new StringBuilder("G28\nM109 S200\nG90\nM83\nG1 X10 Y10 Z0.2\n");
        for (var i = 1; i <= 30; i++) text.Append("G1 X").Append(10 + 3 * i).Append(i <= 6 || i % 2 == 0 ? " E0.1\n" : " E-0.1\n");
        var found = PrintCheck.Run(SmallPrint.Decode(Encoding.ASCII.GetBytes(text + "M104 S0\n"), Setup), Setup);
        Assert.That(found.Single(d => d.Code == CheckCodes.ExtrusionMode).Message,
            Is.EqualTo("40 % of the moves with E retract. E looks relative, but is read as absolute. Add M83 before the first such move."));
    }

    // 10 mm³ in place, 0.3 mm above the bed, are a disc of 6.5 mm.
    [TestCase(0.3, true, 1)]
    [TestCase(0.3, false, 0)]
    [TestCase(0.41, true, 0)]
    public void A_blob_is_squeezed_once_something_is_printed_and_near_the_bed(double z, bool printed, int found)
    {
        var print = new SmallPrint(50, 50, 20).Go(50, 50, 0.2);
        if (printed) print.Print(60, 50, 0.2);
        Assert.That(SmallPrint.Find(print.Go(100, 100, z).Prime(10).Build(), Setup, CheckCodes.Squeezed).Length, Is.EqualTo(found));
    }

    [Test]
    public void A_pen_needs_no_heat_and_a_printer_without_a_bed_cannot_heat_it()
    {
        var pen = SmallPrint.Setup(p => p with { ExtrusionUnit = ExtrusionUnit.None });
        var print = new SmallPrint().Event(new NozzleTemperatureEvent(0)).Print(30, 10, 0.2).Build();
        Assert.That(SmallPrint.Find(print, pen, CheckCodes.ColdExtrusion), Is.Empty);
        Assert.That(SmallPrint.Find(print, Setup, CheckCodes.ColdExtrusion), Has.Exactly(1).Items);
        var cold = SmallPrint.Setup(p => p with { MaxBedTemperature = 0 }) with { Material = new Material { BedTemperature = 0 } };
        var heated = new SmallPrint().Event(new BedTemperatureEvent(40)).Print(30, 10, 0.2).Build();
        Assert.That(SmallPrint.Find(heated, cold, CheckCodes.BedTemperature).Single().Message, Does.EndWith("has no heated bed. Set the temperature to 0."));
        foreach (var (celsius, found) in new[] { (100.0, 0), (100.5, 1) })
        {
            var setup = SmallPrint.Setup(p => p with { MaxBedTemperature = 100 });
            var bed = new SmallPrint().Event(new BedTemperatureEvent(celsius)).Print(30, 10, 0.2).Build();
            Assert.That(SmallPrint.Find(bed, setup, CheckCodes.BedTemperature).Length, Is.EqualTo(found));
        }
    }

    [Test]
    public void What_is_kilometers_away_does_not_stop_the_checks()
    {
        var print = new SmallPrint(50, 50, 0.2).Print(60, 50, 0.2).Print(2e6, 50, 0.2).Print(60, 60, 0.2).Go(60, 60, 4).Print(70, 60, 4).Go(80, 80, 4);
        var codes = PrintCheck.Run(print.Build(), Setup).Select(d => d.Code).ToArray();
        Assert.That(codes, Has.Member(CheckCodes.Outside).And.Member(CheckCodes.Unsupported));
    }
}
