using System;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Slicing;
using FsCheck;
using FsCheck.Fluent;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

public class TrunkTests
{
    private static void ForAll(Action<Random> act)
        => Prop.ForAll(Gen.Choose(0, 1_000_000).ToArbitrary(), seed => act(new Random(seed))).Check(Config.QuickThrowOnFailure.WithReplay(20, 3));

    private static Trunk At(double x, double y, double radius, int branch = 0) => Trunk.Around(new Vec3(x, y), radius, branch, -1);

    private static Trunk Random(Random random, int branch = 0) => At(4 * random.NextDouble(), 4 * random.NextDouble(), 0.3 + 2.5 * random.NextDouble(), branch);

    // The circle within the polygon has the radius less a tolerance: r cos(180° / n).
    [TestCase(0.4, 6)]
    [TestCase(1, 8)]
    [TestCase(2.5, 12)]
    public void It_has_as_few_corners_as_the_tolerance_of_a_twentieth_of_a_millimeter_allows(double radius, int corners)
    {
        var trunk = At(3, 4, radius);
        Assert.That(trunk.Ring(0), Has.Length.EqualTo(corners));
        Assert.That(trunk.Ring(0).Select(p => p.DistanceTo(trunk.Place)), Is.All.EqualTo(radius + 0.05).Within(1e-9));
        Assert.That((radius + 0.05) * Math.Cos(Math.PI / corners), Is.EqualTo(radius).Within(0.05 + 0.01));
    }

    [Test]
    public void Its_region_has_the_area_of_a_regular_polygon()
    {
        // n / 2 · r² · sin(360° / n) with six corners.
        Assert.That(At(1, 2, 0.35).Region.Area, Is.EqualTo(3 * 0.4 * 0.4 * Math.Sqrt(3) / 2).Within(1e-4));
        Assert.That(At(1, 2, 0.35).Region.Contains(1, 2));
    }

    [Test]
    public void A_ring_within_keeps_its_distance_from_all_sides() => ForAll(random =>
    {
        var trunk = Random(random);
        var inner = Region.From(new Polyline(trunk.Ring(0.2), closed: true));
        Assert.That(inner.Xor(trunk.Region.Offset(-0.2)).Area, Is.EqualTo(0).Within(1e-3));
    });

    [TestCase(2.09, false)]
    [TestCase(2.11, true)]
    public void Two_are_apart_where_their_circles_are(double distance, bool apart)
        => Assert.That(At(0, 0, 1).IsApartFrom(At(distance * 0.6, distance * 0.8, 1)), Is.EqualTo(apart));

    [Test]
    public void Those_that_are_apart_have_no_common_point() => ForAll(random =>
    {
        Trunk a = Random(random), b = Random(random);
        if (a.IsApartFrom(b)) Assert.That(a.Region.IsApartFrom(b.Region));
        else if (a.Place.DistanceTo(b.Place) < a.Radius + b.Radius - 0.4) Assert.That(a.Region.IsApartFrom(b.Region), Is.False);
        if (a.IsApartFrom(b.Region)) Assert.That(a.Region.IsApartFrom(b.Region));
    });

    // One of the same size leans out by as much as it is aside; a larger one also by as much as it is larger.
    [TestCase(0.3, 1, 0.31, true)]
    [TestCase(0.3, 1, 0.29, false)]
    [TestCase(0, 0.9, 0, true)]
    [TestCase(0.1, 1.1, 0.31, true)]
    [TestCase(0.1, 1.1, 0.19, false)]
    public void It_rests_on_one_that_it_does_not_lean_out_over_too_far(double aside, double radius, double reach, bool rests)
        => Assert.That(At(aside, 0, radius).RestsOn(At(0, 0, 1), reach), Is.EqualTo(rests));

    [Test]
    public void What_rests_is_within_reach_of_what_carries_it() => ForAll(random =>
    {
        Trunk above = Random(random), below = Random(random);
        var reach = 2 * random.NextDouble();
        if (!above.RestsOn(below, reach)) return;
        Assert.That(above.Region.Subtract(below.Region.Offset(reach + 1e-4, JoinStyle.Round)).Area, Is.EqualTo(0).Within(1e-3));
    });

    [Test]
    public void Those_that_touch_directly_or_through_others_are_a_group()
    {
        Trunk[] trunks = [At(0, 0, 1, 0), At(10, 0, 1, 1), At(3.8, 0, 1, 2), At(1.9, 0, 1, 3), At(10, 1.5, 1, 4), At(20, 0, 1, 5)];
        var groups = TrunkBundle.Groups(trunks).Select(g => g.Select(t => t.Branch).OrderBy(b => b).ToArray()).ToArray();
        Assert.That(groups, Is.EqualTo(new[] { new[] { 0, 2, 3 }, [1, 4], [5] }));
        Assert.That(TrunkBundle.Groups([]), Is.Empty);
    }

    [Test]
    public void Groups_hold_each_trunk_once_and_are_apart_from_each_other() => ForAll(random =>
    {
        Trunk Somewhere(int i) => At(12 * random.NextDouble(), 12 * random.NextDouble(), 0.4 + random.NextDouble(), i);
        var trunks = Enumerable.Range(0, random.Next(20)).Select(Somewhere).ToArray();
        var groups = TrunkBundle.Groups(trunks);
        Assert.That(groups.SelectMany(g => g).Select(t => t.Branch), Is.EquivalentTo(trunks.Select(t => t.Branch)));
        for (var i = 0; i < groups.Count; i++)
        {
            foreach (var other in groups.Skip(i + 1))
                Assert.That(groups[i].All(a => other.TrueForAll(b => a.IsApartFrom(b))));
        }
    });
}
