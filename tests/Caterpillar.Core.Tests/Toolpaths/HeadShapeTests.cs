using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

public class HeadShapeTests
{
    // A flat tip of 0.5 mm, a cone to 3 mm at 5 mm, a block of 20 mm from 8 mm on.
    private static readonly HeadShape Head = new([(0.5, 0), (3, 5), (20, 8)]);

    [TestCase(0, -1)]
    [TestCase(-1, -1)]
    [TestCase(1, 1)]
    [TestCase(5, 3)]
    [TestCase(6.5, 11.5)]
    [TestCase(8, 20)]
    [TestCase(100, 20)]
    [TestCase(double.PositiveInfinity, 20)]
    public void The_reach_follows_the_outline_and_ends_with_it(double excess, double reach)
        => Assert.That(Head.Reach(excess), Is.EqualTo(reach).Within(1e-12));

    [TestCase(0, 0)]
    [TestCase(0.5, 0)]
    [TestCase(1, 1)]
    [TestCase(3, 5)]
    [TestCase(11.5, 6.5)]
    [TestCase(20, 8)]
    [TestCase(20.1, double.PositiveInfinity)]
    public void What_lies_lower_than_the_underside_at_its_distance_is_out_of_reach(double distance, double height)
    {
        Assert.That(Head.HeightAt(distance), Is.EqualTo(height).Within(1e-8));
        if (double.IsInfinity(height)) return;
        Assert.That(Head.Reach(height - 1e-6), height > 0 ? Is.LessThan(distance) : Is.EqualTo(-1));
        Assert.That(Head.Reach(height + 1e-6), Is.GreaterThanOrEqualTo(distance));
    }
}
