using System;
using System.Globalization;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry;

public class ShortSegmentTests
{
    private const double Least = 0.1, Tolerance = 0.01, Area = 0.02;

    // The end of the short segment goes that changes less; what is needed stays.
    [TestCase(false, "0,0 5,0 5.05,0 9,0", "0,0 5,0 9,0")]
    [TestCase(false, "0,0 5,0 5.05,0.009 9,0.009", "0,0 5,0 9,0.009")]
    [TestCase(false, "0,0 5,0 5.07,0.07 9,0.07", "0,0 5,0 5.07,0.07 9,0.07")]
    [TestCase(false, "0,0 9,0 9,0.05 0,0.1", "0,0 9,0 9,0.05 0,0.1")]
    [TestCase(false, "0,0 0.05,0 3,0", "0,0 3,0")]
    [TestCase(false, "0,0 3,0 3.05,0", "0,0 3.05,0")]
    [TestCase(false, "0,0 0.05,0", "0,0 0.05,0")]
    [TestCase(true, "0,0 4,0 4,3 0,3 0,0.05", "0,0 4,0 4,3 0,3")]
    // Points that are one, whatever that changes.
    [TestCase(false, "0,0 0.001,0 1,0 1,1 1,1.002", "0,0 1,0 1,1.002")]
    [TestCase(true, "0,0 0.001,0 1,0 1,1 1.002,1 0,0.001", "0,0 1,0 1.002,1")]
    public void The_end_that_matters_less_goes(bool closed, string points, string kept)
    {
        var path = points.Split(' ').Select(Point).ToArray();
        var left = ShortSegments.Keep(path, closed, Least, Tolerance, Area) is { } numbers ? numbers.Select(i => path[i]) : path;
        Assert.That(left, Is.EqualTo(kept.Split(' ').Select(Point)));
    }

    [Test]
    public void A_long_row_is_not_bent_for_a_short_turn()
    {
        // 20 mm of row and a turn of 0.05 mm across: without its first point the row would be 0.5 mm² off, without the second the link is 0.01 mm² off.
        Vec3[] path = [new(0, 0), new(20, 0), new(20, 0.05), new(20.4, 0.05)];
        Assert.That(ShortSegments.Keep(path, closed: false, Least, 0.06, Area), Is.EqualTo(new[] { 0, 1, 3 }));
        Assert.That(ShortSegments.Keep(path, closed: false, Least, 0.06, 0.001), Is.Null);
    }

    [Test]
    public void What_is_left_is_within_the_tolerance_of_every_point([Range(1, 6)] int seed)
    {
        var random = new Random(seed);
        var path = Enumerable.Range(0, 900).Select(i => Angle.SinCos(0.4 * i)).Select(a =>
        {
            var radius = 6 + 0.02 * random.NextDouble();
            return new Vec3(radius * a.Cos, radius * a.Sin);
        }).ToArray();
        var kept = ShortSegments.Keep(path, closed: true, Least, Tolerance, Area)!;
        Assert.That(kept, Has.Length.LessThan(700).And.Ordered);
        for (var k = 0; k < kept.Length; k++)
        {
            var end = k + 1 < kept.Length ? kept[k + 1] : path.Length;
            Vec3 a = path[kept[k]], d = path[end % path.Length] - a;
            for (var i = kept[k]; i < end; i++)
            {
                var t = Math.Min(1, Math.Max(0, Vec3.Dot(path[i] - a, d) / d.LengthSquared));
                Assert.That((path[i] - a - d * t).LengthXY, Is.LessThan(Tolerance * 1.0001));
            }
        }
    }

    private static Vec3 Point(string text)
    {
        var numbers = text.Split(',').Select(t => double.Parse(t, CultureInfo.InvariantCulture)).ToArray();
        return new Vec3(numbers[0], numbers[1]);
    }
}
