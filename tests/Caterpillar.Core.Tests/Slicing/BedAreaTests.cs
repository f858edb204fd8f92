using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

/// <summary>Where models may stand.</summary>
public class BedAreaTests
{
    private static Footprint Square(double x, double y) => Footprint.Of(new Bounds(new Vec3(x - 5, y - 5, 0), new Vec3(x + 5, y + 5, 3)));

    // A bed of 200 × 100 mm with its corner at the origin and a margin of 2 mm.
    [TestCase(7, 7, true)]
    [TestCase(6.9, 7, false)]
    [TestCase(193, 93, true)]
    [TestCase(193.1, 93, false)]
    [TestCase(100, 93.1, false)]
    public void A_rectangle_is_used_up_to_its_margin(double x, double y, bool fits)
        => Assert.That(new BedArea(new Printer { BuildVolume = new Vec3(200, 100, 50) }, new ArrangeOptions()).Holds(Square(x, y)), Is.EqualTo(fits));

    // A round bed of 200 mm: the far corner is at (x + 5, y + 5) from the middle, at most 98 mm away.
    [TestCase(0, 92.8, true)]
    [TestCase(0, 93, false)]
    [TestCase(64, 64, true)]
    [TestCase(65, 65, false)]
    [TestCase(-64, 64, true)]
    [TestCase(-64, -65, false)]
    public void A_round_bed_has_no_corners(double x, double y, bool fits)
    {
        var printer = new Printer { BuildVolume = new Vec3(200, 200, 50), BedShape = BedShape.Round, Origin = BedOrigin.Center };
        Assert.That(new BedArea(printer, new ArrangeOptions()).Holds(Square(x, y)), Is.EqualTo(fits));
    }

    // A prime line along the left edge, 2 mm away from its end.
    [TestCase(12.9, 50, false)]
    [TestCase(13.1, 50, true)]
    [TestCase(8, 96.9, false)]
    [TestCase(8, 97.1, true)]
    public void An_area_stays_free(double x, double y, bool fits)
    {
        string[] start = ["G28", "G1 Z0.3", "G1 X5.8 Y10.2", "G1 Y89.8 E9"];
        var printer = new Printer { BuildVolume = new Vec3(200, 200, 50), StartGCode = new ValueList<string>(start) };
        var bed = PrimedArea.Excluded(new PrintSetup { Printer = printer });
        Assert.That(new BedArea(bed, new ArrangeOptions()).Holds(Square(x, y)), Is.EqualTo(fits));
    }

    [Test]
    public void The_prime_line_of_the_start_code_stays_free()
    {
        var printer = new Printer { StartGCode = new ValueList<string>("G28", "G1 Z0.3", "G1 X5 Y20", "G1 X5 Y120 E9", "G1 Z2") };
        var area = PrimedArea.Of(new PrintSetup { Printer = printer });
        Assert.That((area.Min.X, area.Max.X, area.Min.Y, area.Max.Y), Is.EqualTo((4.8, 5.2, 19.8, 120.2)).Within(1e-9));
        Assert.That(PrimedArea.Of(new PrintSetup { Printer = printer with { StartGCode = new ValueList<string>("G28") } }).IsEmpty, Is.True);
    }
}
