using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

public class ToolAimTests
{
    private static readonly Polyline Square = new([new(0, 0), new(10, 0), new(10, 10), new(0, 10)], closed: true);

    [TestCase(-3, 5, 3, 0)]
    [TestCase(4, -2, 0, 2)]
    [TestCase(13, 14, -3, -4)]
    [TestCase(1, 5, -1, 0)]
    public void The_tool_leans_to_the_nearest_place_of_a_loop_on_all_of_its_sides(double x, double y, double toX, double toY)
    {
        Assert.That(ToolAim.Toward([Square]).Direction!(new Vec3(x, y)), Is.EqualTo(new Vec3(toX, toY)));
        Assert.That(ToolAim.Toward([Square], away: true).Direction!(new Vec3(x, y)), Is.EqualTo(-new Vec3(toX, toY)));
    }

    [Test]
    public void A_curve_may_be_a_point()
    {
        var aim = ToolAim.Toward([new Polyline([]), new Polyline([new Vec3(1, 2, 30)])]);
        Assert.That(aim.Direction!(new Vec3(1, 2, 10)), Is.EqualTo(new Vec3(0, 0, 20)));
        Assert.That(() => ToolAim.Toward([new Polyline([])]), Throws.ArgumentException);
    }
}
