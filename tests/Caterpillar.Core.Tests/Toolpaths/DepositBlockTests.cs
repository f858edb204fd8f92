using System;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

/// <summary>Bounds of many extrusions at once, and the pieces of the reach of a head, against each extrusion and each height by itself.</summary>
public class DepositBlockTests
{
    private static readonly HeadShape Head = new([(0.5, 0), (3, 5), (20, 8)]);

    [Test]
    public void Layers_on_slopes_are_met_as_each_of_their_extrusions_is_alone([Values(1, 2, 3)] int seed)
    {
        var random = new Random(seed);
        var found = new int[3];
        for (var round = 0; round < 12; round++)
        {
            var (slope, turn) = (0.3 * (round % 4), 6.28 * random.NextDouble());
            var bulge = round % 3 * 0.02;
            double Surface(double x, double y) => slope * (x * Math.Cos(turn) + y * Math.Sin(turn)) - bulge * (x * x + y * y);
            var whole = new Deposit();
            var alone = Enumerable.Range(0, 90).Select(i =>
            {
                var (layer, along) = (i / 15, i / 15 % 2 == 0);
                double u = -3 + 0.45 * (i % 15), from = -3 + random.NextDouble(), to = 2 + random.NextDouble();
                Vec3 Point(double v) => along ? new Vec3(v, u, Surface(v, u) + 0.2 * layer) : new Vec3(u, v, Surface(u, v) + 0.2 * layer);
                var one = new Deposit();
                whole.Add(Point(from), Point(to), 0.22, i);
                one.Add(Point(from), Point(to), 0.22, i);
                return one;
            }).ToArray();
            for (var n = 0; n < 60; n++)
            {
                Vec3 a = Tip(), b = Tip();
                var each = alone.Max(d => Contact(d, a, b));
                Assert.That(Contact(whole, a, b), Is.EqualTo(each), $"round {round}: {a} to {b}");
                found[(int)each]++;
            }

            Vec3 Tip()
            {
                double x = 8 * random.NextDouble() - 4, y = 8 * random.NextDouble() - 4;
                return new Vec3(x, y, Surface(x, y) + 1 + 0.8 * random.NextDouble() * random.NextDouble());
            }
        }
        Assert.That(found, Is.All.GreaterThan(20), "all kinds of contact");
    }

    [Test]
    public void Pieces_of_the_reach_follow_each_other_and_are_exact([Values(true, false)] bool lenient)
    {
        var random = new Random(7);
        for (var round = 0; round < 300; round++)
        {
            double r = 0.2 + random.NextDouble(), h = 0, half = 0.4 * random.NextDouble();
            var count = random.Next(1, 5);
            var outline = Enumerable.Range(0, count).Select(i => (r += 0.1 + 3 * random.NextDouble(), i == 0 ? 0 : h += 3 * random.NextDouble()));
            var head = new HeadShape(outline.ToArray());
            var pieces = 0;
            for (var excess = 0.0; excess < 12; pieces++)
            {
                var (start, slope, end) = head.PieceAbove(excess, half, lenient);
                foreach (var part in new[] { 0.001, 0.5, 0.999 })
                {
                    var at = excess + (Math.Min(end, 13) - excess) * part;
                    Assert.That(start + slope * at, Is.EqualTo(head.AxisReach(at, half, lenient)).Within(1e-6), $"round {round}: {at} in {excess} to {end}");
                }
                excess = Math.Max(end, excess + 1e-9);
            }
            Assert.That(pieces, Is.InRange(1, 20));
        }
    }

    // A box 4 mm long and 2 mm wide, 3 mm above its origin, climbs from 1 to 11 mm while it goes from X 0 to 10; a square of 1 mm. Its front reaches the square
    // where X is 2.5 mm less than the middle of the square.
    [TestCase(5, 0, 6.5)]
    [TestCase(5, 1.4, 6.5)]
    [TestCase(5, 1.6, double.PositiveInfinity)]
    [TestCase(-1, 0, 4)]
    [TestCase(-3, 0, double.PositiveInfinity)]
    [TestCase(12, 0, 13.5)]
    [TestCase(12.6, 0, double.PositiveInfinity)]
    public void A_box_over_a_square_is_as_low_as_its_path_is_there(double x, double y, double lowest)
    {
        var box = new Bounds(new Vec3(-2, -1, 3), new Vec3(2, 1, 4));
        var (a, b) = (new Vec3(0, 0, 1), new Vec3(10, 0, 11));
        Assert.That(new BoxQuery(a, b, 0.1, box).LowestOver(new Vec3(x, y), 0.5), Is.EqualTo(lowest + 0.1).Within(1e-12));
        Assert.That(new BoxQuery(b, a, 0.1, box).LowestOver(new Vec3(x, y), 0.5), Is.EqualTo(lowest + 0.1).Within(1e-12));
        Assert.That(new BoxQuery(a, b, 0.1, box).Lowest, Is.EqualTo(4.1).Within(1e-12));
    }

    private static HeadContact Contact(Deposit deposit, Vec3 a, Vec3 b) => deposit.Contacts.Meets(a, b, 0.1, Head, false, out _);
}
