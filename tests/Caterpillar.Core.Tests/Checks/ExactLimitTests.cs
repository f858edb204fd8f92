using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>Limits of extrusions at exactly their value: lengths in halves of a millimeter, which add up without rounding.</summary>
public class ExactLimitTests
{
    private const double Area = 0.0625;
    private static readonly PrintSetup Setup = SmallPrint.Setup();

    // 16 mm of an extrusion 1 mm wide: the root of the area is 4 mm.
    [TestCase(32, 0)]
    [TestCase(32.5, 1)]
    public void A_print_may_be_as_high_as_eight_roots_of_the_area_it_stands_on(double top, int found)
        => Assert.That(Found(CheckCodes.FirstLayer, new Vec3(0, 0, 0.25), 0.25, (new Vec3(16, 0, 0.25), Role.Infill), (new Vec3(16, 0, top), Role.Purge)),
            Is.EqualTo(found));

    // What hangs in the air is no foot.
    [Test]
    public void A_print_does_not_stand_on_what_is_in_the_air()
        => Assert.That(Found(CheckCodes.FirstLayer, new Vec3(0, 0, 0.25), 0.25, (new Vec3(16, 0, 0.25), Role.Infill), (new Vec3(16, 0, 32.5), Role.Purge),
            (new Vec3(176, 0, 32.5), Role.Infill)), Is.EqualTo(1));

    [TestCase(5, 0)]
    [TestCase(5.5, 1)]
    public void The_free_end_of_a_extrusion_may_be_5_mm_long(double length, int found)
    {
        Vec3 start = new(0, 0, 32), end = new(length, 0, 32);
        Assert.That(Found(CheckCodes.Unsupported, start, Area, (end, Role.Infill)), Is.EqualTo(found));
        Assert.That(Found(CheckCodes.Unsupported, start, Area, (end, Role.Infill), (end + Vec3.UnitX, Role.Purge)), Is.EqualTo(found));
    }

    [TestCase(60, 0)]
    [TestCase(60.5, 1)]
    public void A_bridge_may_be_60_mm_long(double length, int found)
        => Assert.That(Found(CheckCodes.Unsupported, new Vec3(0, 0, 32), Area, (new Vec3(1, 0, 32), Role.Purge), (new Vec3(1 + length, 0, 32), Role.Infill),
            (new Vec3(2 + length, 0, 32), Role.Purge)), Is.EqualTo(found));

    // 3 mm wide, with a nozzle of 0.4 mm.
    [TestCase(5, 0)]
    [TestCase(5.5, 1)]
    public void Extrusions_may_be_too_wide_for_5_mm(double length, int found)
        => Assert.That(Found(CheckCodes.Width, new Vec3(0, 0, 0.25), 0.75, (new Vec3(length, 0, 0.25), Role.Infill)), Is.EqualTo(found));

    [TestCase(4, 0)]
    [TestCase(4.5, 1)]
    public void Extrusions_may_lie_in_the_place_of_others_for_20_mm(double length, int found)
        => Assert.That(Found(CheckCodes.Duplicate, new Vec3(0, 0, 0.25), Area, (new Vec3(16, 0, 0.25), Role.Infill),
            (new Vec3(16 + length, 0, 0.25), Role.Infill)), Is.EqualTo(found));

    [TestCase(0, 1)]
    [TestCase(1e-9, 0)]
    public void Extrusions_that_turn_by_ten_degrees_at_a_gap_go_on(double more, int found)
    {
        const double Straight = 0.985;
        var findings = new Findings(Setup.Printer, _ => null, _ => null);
        var check = new GapCheck(findings);
        var end = new Vec3(Straight, Math.Sqrt(1 - Straight * Straight) + more);
        if (more == 0) Assert.That(end.Length, Is.EqualTo(1));
        Vec3[] ends = [new(-0.5, 0), Vec3.Zero, end];
        var at = new Vec3(-1.5, 0);
        for (var i = 0; i < ends.Length; i++)
        {
            var length = at.DistanceTo(ends[i]);
            var kind = i == 1 ? MoveKind.Travel : MoveKind.Print;
            check.Move(new CheckedMove { Start = at, End = ends[i], StartKnown = true, Kind = kind, Length = length, Deposited = i == 1 ? 0 : length });
            at = ends[i];
        }
        Assert.That(findings.ToList(), Has.Count.EqualTo(found));
    }

    // Of 0.1 mm with 3 decimals, both ends rounded: 0.102 mm at most.
    [TestCase(0.999, 0)]
    [TestCase(1.004, 1)]
    public void In_short_moves_the_last_decimals_may_be_the_flow(double share, int found)
    {
        var setup = SmallPrint.Setup(p => p with { MaxFlow = 10, DecimalsXyz = 3, DecimalsE = 5 });
        var volume = share * 10 * 1.001 * 0.102 / 50 + 1e-5 * SmallPrint.FilamentArea;
        var print = new SmallPrint().Print(10.1, 10, 0.2, volume / 0.1);
        Assert.That(SmallPrint.Find(print.Build(), setup, CheckCodes.Flow), Has.Length.EqualTo(found));
    }

    // From ten meters on nothing is looked at in a machine of this size; half as far away it is.
    [TestCase(1e4, 0, 0)]
    [TestCase(0, -1e4, 0)]
    [TestCase(0, 0, 1e4)]
    public void What_is_ten_meters_away_is_outside_the_machine(double x, double y, double z)
    {
        int Count(Vec3 from)
        {
            var findings = new Findings(Setup.Printer, _ => null, _ => null);
            var check = new DepositCheck(Setup, findings);
            var end = new Vec3(0, 0, 32);
            var length = from.DistanceTo(end);
            check.Move(new CheckedMove { Start = from, End = end, StartKnown = true, Kind = MoveKind.Print, Length = length, Deposited = length * Area });
            check.End(new ToolpathBuilder(MoveSource.Steps, null).Build([new ToolpathTool(1)]));
            return findings.ToList().Count(d => d.Code == CheckCodes.Unsupported);
        }

        Vec3 far = new(x, y, z);
        Assert.That((Count(far), Count(0.5 * far + 32 * Vec3.UnitZ)), Is.EqualTo((0, 1)));
    }

    [Test]
    public void Lines_are_places_from_the_first_on()
    {
        var plan = new SmallPrint().Print(20, 10, 0.2).Build();
        var places = new WrittenPlaces(plan, _ => null, SmallPrint.Written(plan, Setup).Lines, Setup.Printer);
        MoveEvent At(int line) => new(0, new FanEvent(1)) { Source = line };
        Assert.That((places.Of(At(1))?.Line, places.Of(At(0))), Is.EqualTo(((int?)1, (SourceLocation?)null)));
    }

    [Test]
    public void Material_in_place_may_be_as_much_as_the_printer_allows()
    {
        int Count(double volume)
        {
            var findings = new Findings(Setup.Printer, _ => null, _ => null);
            new ExtruderCheck(Setup, findings).Move(new CheckedMove { StartKnown = true, Kind = MoveKind.Prime, Pushed = volume });
            return findings.ToList().Count;
        }

        var most = Setup.Printer.MaxStationaryVolume * (1 + 1e-9);
        Assert.That((Count(most), Count(BitConverter.Int64BitsToDouble(BitConverter.DoubleToInt64Bits(most) + 1))), Is.EqualTo((0, 1)));
    }

    // Extrusions 0.25 mm high that follow each other, above one that is printed along the X axis already.
    private static int Found(string code, Vec3 start, double area, params (Vec3 End, Role Role)[] extrusions)
    {
        var findings = new Findings(Setup.Printer, _ => null, _ => null);
        var printed = new PrintedSoFar(Setup);
        if (code == CheckCodes.Duplicate) printed.Deposit.Add(new Vec3(-10, 0, 0.25), new Vec3(50, 0, 0.25), 0.25, 0);
        var check = new ExtrusionCheck(Setup, printed, findings);
        foreach (var (end, role) in extrusions)
        {
            var length = start.DistanceTo(end);
            check.Extrusion(new CheckedMove
            {
                Start = start, End = end, StartKnown = true, Kind = MoveKind.Print, Role = role, Length = length, Deposited = length * area, Thickness = 0.25,
            });
            start = end;
        }
        check.End();
        return findings.ToList().Where(d => d.Code == code).Sum(d => d.Count);
    }
}
