using Caterpillar.Geometry;
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
        => Assert.That(new BedArea(new Printer { BuildVolume = new Vec3(200, 100, 50) }, 2).Holds(Square(x, y)), Is.EqualTo(fits));

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
        Assert.That(new BedArea(printer, 2).Holds(Square(x, y)), Is.EqualTo(fits));
    }
}
