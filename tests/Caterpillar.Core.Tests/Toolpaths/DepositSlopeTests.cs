using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

/// <summary>What a head meets that goes up or down, and extrusions that are added piece by piece.</summary>
public class DepositSlopeTests
{
    // A flat tip of 0.5 mm, a cone to 3 mm at 5 mm, a block of 20 mm from 8 mm on.
    private static readonly HeadShape Head = new([(0.5, 0), (3, 5), (20, 8)]);

    private static readonly HeadShape Cone = new([(0.5, 0), (10.5, 20)]);

    [TestCase(10, 0)]
    [TestCase(0, 10)]
    [TestCase(6, -8)]
    public void Extrusions_that_rise_or_fall_by_more_than_0_03_mm_for_each_mm_are_sloped(double x, double y)
        => Assert.That(new[] { 0.31, -0.31, 0.29, -0.29 }.Select(z => Extrusion.Of(Vec3.Zero, new Vec3(x, y, z), 0.2).IsSloped),
            Is.EqualTo(new[] { true, true, false, false }));

    // Beside an extrusion that rises as the tip does, by 1 in 2, and is 1 mm higher: d·√(1 − ¼²) = 0.5 + 0.2 + ½·1; 0.1 lower: 0.5 + 0.2 + ½·0.9.
    [TestCase(1.2393, 0, 1, true)]
    [TestCase(1.2395, 0, 1, false)]
    [TestCase(-1.2393, 0, 1, true)]
    [TestCase(-1.2395, 0, 1, false)]
    [TestCase(1.1876, 0.1, 1, true)]
    [TestCase(1.1878, 0.1, 1, false)]
    // As high as the tip beside it, and higher farther on: 0.1 mm within 0.2 mm along the path; there d² + 0.2² = 0.7².
    [TestCase(0.67, 0.1, 0, true)]
    [TestCase(0.68, 0.1, 0, false)]
    public void An_extrusion_beside_a_slope_is_met_by_its_height_above_it(double beside, double tolerance, double above, bool meets)
    {
        var deposit = new Deposit();
        deposit.Add(new Vec3(0, 0, above), new Vec3(20, 0, 10 + above), 0.2, 3);
        var (a, b) = (new Vec3(5, beside, 2.5), new Vec3(15, beside, 7.5));
        Assert.That(deposit.Contacts.Meets(a, b, tolerance, Cone, false, out var tag) != HeadContact.None, Is.EqualTo(meets));
        Assert.That(deposit.Contacts.Meets(b, a, tolerance, Cone, false, out _) != HeadContact.None, Is.EqualTo(meets), "the other way around");
        Assert.That(tag, Is.EqualTo(meets ? 3 : -1));
    }

    // The tip comes down over the extrusion, and rises from there; over the extrusion it is lowest.
    [TestCase(3.1, 0, false)]
    [TestCase(3.0001, 0, false)]
    [TestCase(2.9999, 0, true)]
    [TestCase(2.9999, 0.001, false)]
    public void A_slope_that_ends_over_a_extrusion_is_judged_by_its_end(double z, double tolerance, bool meets)
    {
        var deposit = new Deposit();
        deposit.Add(new Vec3(5, -5, 3), new Vec3(5, 5, 3), 0.2, 3);
        Assert.That(deposit.Contacts.Meets(new Vec3(0, 0, 6), new Vec3(5, 0, z), tolerance, Head, true, out _) == HeadContact.Hits, Is.EqualTo(meets));
        Assert.That(deposit.Contacts.Meets(new Vec3(5, 0, z), new Vec3(10, 0, 6), tolerance, Head, true, out _) == HeadContact.Hits, Is.EqualTo(meets));
    }

    [Test]
    public void Contacts_of_random_slopes_are_exact([Values(true, false)] bool hitsOnly)
    {
        var random = new Random(3);
        var found = new int[2];
        for (var round = Rounds.Of(400, 1500); round > 0; round--)
        {
            Vec3 p = Point(random, 2, 2), q = Point(random, 2, 2), a = Point(random, 2, 2), b = Point(random, 2, 2);
            var half = 0.1 + 0.3 * random.NextDouble();
            var deposit = new Deposit();
            deposit.Add(p, q, half, 0);
            var contact = deposit.Contacts.Meets(a, b, 0.05, Head, hitsOnly, out _);
            var depth = Depth(p, q, half, a, b, 0.05, hitsOnly, hitsOnly ? 0 : 1e-9);
            // What is sampled is off by a few hundredths, and the reach jumps where an extrusion begins to be higher.
            if (depth > 0.002) Assert.That(contact, Is.Not.EqualTo(HeadContact.None), $"round {round}: {depth}");
            if (Depth(p, q, half, a, b, 0.02, hitsOnly, 0) < -0.05) Assert.That(contact, Is.EqualTo(HeadContact.None), $"round {round}: {depth}");
            found[contact == HeadContact.None ? 0 : 1]++;
        }
        Assert.That(found, Is.All.GreaterThan(50));
    }

    // Extrusions 3 mm wide up a slope of 50°, and a tip that follows 0.5 mm above them: the round end of one must not lie on the one below it.
    [TestCase(true)]
    [TestCase(false)]
    public void An_extrusion_that_goes_on_downward_has_no_round_end_there(bool joined)
    {
        var deposit = new Deposit(0.75, 18);
        for (var i = 0; i < 10; i++) deposit.Add(new Vec3(5 * i, 0, 6 * i), new Vec3(5 * i + 5, 0, 6 * i + 6), 1.5, i, joined && i > 0);
        var tip = new HeadShape([(0.5, 0), (14, 30)]);
        var contact = deposit.Contacts.Meets(new Vec3(10, 0, 12.5), new Vec3(40, 0, 48.5), 0.25, tip, true, out _);
        Assert.That(contact, Is.EqualTo(joined ? HeadContact.None : HeadContact.Hits));
        Assert.That(deposit.TopUnder(new Vec3(14, 0), 100), Is.EqualTo(joined ? 16.8 : 18).Within(1e-9));
        // Its lowest end is free, and is round; beside it lies the edge.
        Assert.That(deposit.Contacts.Meets(new Vec3(-1.9, 0, -1), new Vec3(-1.9, 0.1, -1), 0, tip, true, out var tag), Is.EqualTo(HeadContact.Hits));
        Assert.That(tag, Is.Zero);
        Assert.That(deposit.Contacts.Meets(new Vec3(-2.6, 0, -1), new Vec3(-2.6, 0.1, -1), 0, tip, true, out _), Is.EqualTo(HeadContact.None));
        Assert.That(deposit.Contacts.Meets(new Vec3(20, 1.9, 23), new Vec3(20.1, 1.9, 23.1), 0, tip, true, out _), Is.EqualTo(HeadContact.Hits));
    }

    [Test]
    public void No_reach_up_to_a_height_is_longer_than_its_bound_or_deeper_below_a_plane([Values(true, false)] bool lenient)
    {
        var random = new Random(5);
        for (var round = 0; round < 300; round++)
        {
            double r = 0.2 + random.NextDouble(), h = 0;
            var count = random.Next(1, 5);
            var head = new HeadShape(Enumerable.Range(0, count).Select(i => (r += 0.1 + 3 * random.NextDouble(), i == 0 ? 0 : h += random.Next(4))).ToArray());
            var excess = 0.01 + 12 * random.NextDouble() * random.NextDouble();
            double half = 0.4 * random.NextDouble(), rise = 3 * random.NextDouble(), longest = 0, deepest = double.NegativeInfinity;
            for (var i = 1; i <= 2000; i++)
            {
                var e = excess * i / 2000;
                var reach = head.AxisReach(e, half, lenient);
                (longest, deepest) = (Math.Max(longest, reach), Math.Max(deepest, rise * reach - e));
            }
            Assert.That(head.Reach(excess, half, lenient), Is.GreaterThan(longest - 1e-9), $"round {round}");
            Assert.That(head.Depth(rise, half, excess, lenient), Is.GreaterThan(deepest - 1e-9), $"round {round}");
            if (lenient) continue;
            Assert.That(head.Reach(excess, half, lenient), Is.EqualTo(longest).Within(1e-9), $"round {round}: as long as the longest");
            Assert.That(head.Depth(rise, half, excess, lenient), Is.EqualTo(deepest).Within(0.2), $"round {round}: as deep as the deepest");
        }
    }

    // The rise of a plane, how high an extrusion is above the tip at most, and how high the tip may be above the plane.
    [TestCase(0.5, 5, false, 0.35)]
    [TestCase(4, 5, false, 7.8)]
    [TestCase(4, 8, false, 72.8)]
    [TestCase(0.5, 5, true, 0)]
    [TestCase(2, 2, true, 2)]
    [TestCase(4, 5, true, 7.8)]
    public void The_head_reaches_a_plane_from_as_high_as_its_outline_lies_below_it(double rise, double most, bool lenient, double depth)
        => Assert.That(new HeadShape([(0.5, 0), (3, 5), (20, 8)]).Depth(rise, 0.2, most, lenient), Is.EqualTo(depth).Within(1e-8));

    // Down from 10 to 0 mm in 10 mm; the square has sides of 1 mm.
    [TestCase(5, 3, 1, 3.5)]
    [TestCase(5, 0, 2, 2.5)]
    [TestCase(9, 0, 2, 0)]
    [TestCase(-5, 0, 2, 10)]
    [TestCase(5, 0, 10, 0)]
    public void The_lowest_height_near_a_square_is_that_of_the_path_within_reach(double x, double y, double distance, double lowest)
    {
        var (a, b) = (new Vec3(0, 0, 10), new Vec3(10, 0, 0));
        Assert.That(Lowest(a, b), Is.EqualTo(lowest).Within(1e-12));
        Assert.That(Lowest(b, a), Is.EqualTo(lowest).Within(1e-12));
        Assert.That(Lowest(b, b), Is.Zero);
        Assert.That(Lowest(a, new Vec3(0, 0.02, 7)), Is.EqualTo(7), "straight up");

        double Lowest(Vec3 from, Vec3 to)
        {
            var near = new HeadQuery(from, to, 0, Head, false).Near(x, y, 0.5, distance, out _);
            return Math.Min(near.From.Z, near.To.Z);
        }
    }

    // Along X from 0 to 10, and along a diagonal.
    [TestCase(5, 3, 10, 0, 2.5)]
    [TestCase(5, -3, 10, 0, 2.5)]
    [TestCase(-2, 0, 10, 0, 1.5)]
    [TestCase(13, 1, 10, 0, 2.5)]
    [TestCase(5, 0.2, 10, 0, -0.3)]
    [TestCase(5, 9, 10, 10, 2.1213203435596424)]
    [TestCase(12, 12, 10, 10, 2.1213203435596424)]
    [TestCase(0, 3, 0, 0, 2.5)]
    public void Squares_are_at_least_so_far_from_a_path(double x, double y, double endX, double endY, double distance)
    {
        var (a, b) = (new Vec3(0, 0, 10), new Vec3(endX, endY, 0));
        new HeadQuery(a, b, 0, Head, false).Near(x, y, 0.5, 1, out var away);
        Assert.That(away, Is.EqualTo(distance).Within(1e-12));
        new HeadQuery(b, a, 0, Head, false).Near(x, y, 0.5, 1, out away);
        Assert.That(away, Is.EqualTo(distance).Within(1e-12));
    }

    [Test]
    public void An_extrusion_that_goes_on_is_one_and_lies_where_its_pieces_would()
    {
        var random = new Random(9);
        for (var round = 0; round < 100; round++)
        {
            Vec3 a = Point(random, 6, 4), b = Point(random, 6, 4);
            Vec3 first = Vec3.Lerp(a, b, 0.1 + 0.4 * random.NextDouble()), second = Vec3.Lerp(first, b, 0.1 + 0.8 * random.NextDouble());
            var (whole, pieces) = (new Deposit(), new Deposit());
            whole.Add(a, first, 0.3, 5);
            whole.GoOn(first, second, 0.3, 5);
            whole.GoOn(second, b, 0.3, 5);
            pieces.Add(a, first, 0.3, 5, isJoined: a.Z > b.Z);
            pieces.Add(first, second, 0.3, 5, isJoined: true);
            pieces.Add(second, b, 0.3, 5, isJoined: a.Z < b.Z);
            Assert.That((whole.ExtrusionCount, pieces.ExtrusionCount), Is.EqualTo((1, 3)));
            Assert.That(whole.Highest, Is.EqualTo(pieces.Highest));
            for (var i = 0; i < 200; i++)
            {
                Vec3 p = Point(random, 7, 5), q = Point(random, 7, 5);
                if (whole.CellAt(p.X, p.Y) != pieces.CellAt(p.X, p.Y)) Assert.Fail($"round {round}: another cell at {p}");
                double top = whole.TopAlong(p, q, 0.4), expected = pieces.TopAlong(p, q, 0.4);
                if (top != expected && !(Math.Abs(top - expected) <= 1e-9)) Assert.Fail($"round {round}: {top} instead of {expected} from {p} to {q}");
                // What rises by less than 0.02 mm counts as level.
                if (whole.Contacts.Meets(p, q, 0.02, Head, false, out _) > pieces.Contacts.Meets(p, q, 0, Head, false, out _)
                    || pieces.Contacts.Meets(p, q, 0.02, Head, false, out _) > whole.Contacts.Meets(p, q, 0, Head, false, out _))
                    Assert.Fail($"round {round}: the head meets more or less from {p} to {q}");
            }
        }
    }

    // Forty extrusions at the foot of a slope of 27° that ends 20 mm higher: its upper end drops none of them, and the flat of a tip beside them only digs.
    [Test]
    public void A_long_slope_drops_nothing_at_its_foot()
    {
        var deposit = new Deposit(0.25, 6);
        deposit.Add(new Vec3(0.2, 1.6, 0.3), new Vec3(40, 1.6, 20), 0.2, 0);
        for (var i = 1; i <= 40; i++) deposit.Add(new Vec3(0.2, 1, 0.5), new Vec3(1.8, 1, 0.5), 0.2, i);
        Assert.That(deposit.ExtrusionCount, Is.EqualTo(41));
        Assert.That(deposit.Contacts.Meets(new Vec3(0.3, 0.7, 0.3), new Vec3(1.7, 0.7, 0.3), 0.05, Cone, false, out var tag), Is.EqualTo(HeadContact.Digs));
        Assert.That(tag, Is.EqualTo(40));
        // At the upper end of the slope the head finds it.
        Assert.That(deposit.Contacts.Meets(new Vec3(39, 1.6, 19), new Vec3(39.9, 1.6, 19), 0.05, Cone, false, out tag), Is.EqualTo(HeadContact.Hits));
        Assert.That(tag, Is.Zero);
    }

    // One bin holds it twice as high as it began; twenty others in the same place fill a block of extrusions.
    [Test]
    public void An_extrusion_that_rises_as_it_goes_on_is_met_where_it_is_high([Values(0, 15, 20)] int before)
    {
        var deposit = new Deposit();
        for (var i = 0; i < before; i++) deposit.Add(new Vec3(0.2, 1, 0.1), new Vec3(0.4, 1, 0.1), 0.1, i);
        deposit.Add(new Vec3(0.2, 1, 0.1), new Vec3(0.4, 1, 0.1), 0.1, 50);
        deposit.GoOn(new Vec3(0.4, 1, 0.1), new Vec3(1.4, 1, 3), 0.1, 50);
        Assert.That(deposit.Highest, Is.EqualTo(3));
        Assert.That(deposit.Contacts.Meets(new Vec3(1.4, 1, 2.5), new Vec3(1.5, 1, 2.5), 0, Head, false, out var tag), Is.EqualTo(HeadContact.Hits));
        Assert.That(tag, Is.EqualTo(50));
    }

    // 2 m from the origin cells end: all that is beyond has one height.
    [Test]
    public void An_extrusion_that_goes_on_to_far_outside_is_there_up_to_the_end_of_the_cells()
    {
        var deposit = new Deposit();
        deposit.Add(new Vec3(2000, 0, 1), new Vec3(2010, 0, 1), 0.2, 5);
        deposit.GoOn(new Vec3(2010, 0, 1), new Vec3(3000, 0, 1), 0.2, 5);
        deposit.GoOn(new Vec3(3000, 0, 1), new Vec3(3001, 0, 7), 0.2, 5);
        Assert.That(deposit.TopAlong(new Vec3(2020, 0), new Vec3(2021, 0), 0.1), Is.EqualTo(1));
        Assert.That(deposit.TopAlong(new Vec3(2900, 0), new Vec3(2901, 0), 0.1), Is.EqualTo(7));
        Assert.That(deposit.Highest, Is.EqualTo(7));
    }

    // The most by which some point of the extrusion is nearer than its reach.
    private static double Depth(Vec3 p, Vec3 q, double half, Vec3 a, Vec3 b, double tolerance, bool lenient, double least)
    {
        const int Steps = 60;
        var best = double.NegativeInfinity;
        for (var i = 0; i <= Steps; i++)
        {
            var tip = Vec3.Lerp(a, b, (double)i / Steps);
            // What is more than dug into is so both as discs around its axis and as a strip that is level across itself.
            var depth = Nearest(SampledExtrusion.Top(p, q, 0, Steps), half);
            if (lenient) depth = Math.Min(depth, Nearest(SampledExtrusion.Top(p, q, half, Steps), 0));
            best = Math.Max(best, depth);

            double Nearest(IEnumerable<Vec3> tops, double around)
            {
                var nearest = double.NegativeInfinity;
                foreach (var top in tops)
                {
                    var excess = top.Z - tip.Z - tolerance;
                    if (excess > least) nearest = Math.Max(nearest, Head.AxisReach(excess, around, lenient) - (top - tip).LengthXY);
                }
                return nearest;
            }
        }
        return best;
    }

    private static Vec3 Point(Random random, double size, double high)
        => new(random.NextDouble() * 2 * size - size, random.NextDouble() * 2 * size - size, random.NextDouble() * high);
}
