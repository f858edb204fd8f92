using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

/// <summary>What a head, and a box, meets of what is printed.</summary>
public class DepositContactTests
{
    // A flat tip of 0.5 mm, a cone to 3 mm at 5 mm, a block of 20 mm from 8 mm on.
    private static readonly HeadShape Head = new([(0.5, 0), (3, 5), (20, 8)]);

    // 1 mm below the top of an extrusion of half a width of 0.2 mm the head is 1 mm wide; its flat alone digs farther off than 1 mm, which is 45 degrees.
    [TestCase(0.999, 2, 0, nameof(HeadContact.Hits))]
    [TestCase(1.001, 2, 0, nameof(HeadContact.Digs))]
    [TestCase(1.199, 2, 0, nameof(HeadContact.Digs))]
    [TestCase(1.201, 2, 0, nameof(HeadContact.None))]
    [TestCase(0.999, 1.5, 0.5, nameof(HeadContact.Hits))]
    [TestCase(1.201, 1.5, 0.5, nameof(HeadContact.None))]
    // 3 mm below it is 2 mm wide: no longer the flat alone.
    [TestCase(2.199, 0, 0, nameof(HeadContact.Hits))]
    [TestCase(2.201, 0, 0, nameof(HeadContact.None))]
    [TestCase(-2.199, 0, 0, nameof(HeadContact.Hits))]
    [TestCase(0, 3, 0, nameof(HeadContact.None))]
    [TestCase(0, 2.999, 0, nameof(HeadContact.Hits))]
    public void A_head_beside_a_extrusion_meets_it_by_its_outline(double beside, double z, double tolerance, string contact)
    {
        var deposit = new Deposit();
        deposit.Add(new Vec3(0, 0, 3), new Vec3(10, 0, 3), 0.2, 5);
        var (a, b) = (new Vec3(2, beside, z), new Vec3(6, beside, z));
        var (tag, hitTag) = (0, 0);
        Assert.That(deposit.Contacts.Meets(a, b, tolerance, Head, false, out tag).ToString(), Is.EqualTo(contact));
        Assert.That(tag, Is.EqualTo(contact == nameof(HeadContact.None) ? -1 : 5));
        var hit = contact == nameof(HeadContact.Digs) ? "None" : contact;
        Assert.That(deposit.Contacts.Meets(b, a, tolerance, Head, true, out hitTag).ToString(), Is.EqualTo(hit));
    }

    // excess, half a width, reach, reach leniently.
    [TestCase(0, 0.2, -1, -1)]
    [TestCase(1, 0.2, 1.2, 1)]
    [TestCase(0.4, 0.2, 0.9, 0.4)]
    [TestCase(0.6, 0.2, 1.0, 0.75)]
    [TestCase(2, 0.2, 1.7, 1.7)]
    [TestCase(2.1, 0.2, 1.75, 1.75)]
    public void The_reach_of_the_axis_adds_half_the_extrusion_and_leniently_less(double excess, double half, double reach, double lenient)
    {
        Assert.That(Head.AxisReach(excess, half, false), Is.EqualTo(reach).Within(1e-12));
        Assert.That(Head.AxisReach(excess, half, true), Is.EqualTo(lenient).Within(1e-12));
    }

    [Test]
    public void Outlines_begin_at_the_tip_and_ascend()
    {
        Assert.That(Head.FlatRadius, Is.EqualTo(0.5));
        Assert.That(new HeadShape([(0.5, 0), (0.9, 0), (2, 1)]).FlatRadius, Is.EqualTo(0.9));
        Assert.That(new HeadShape([(0.5, 0), (0.9, 0), (2, 1)]).Reach(0.5), Is.EqualTo(1.45).Within(1e-12));
        Assert.That(() => new HeadShape([]), Throws.ArgumentException);
        Assert.That(() => new HeadShape([(0.5, 1)]), Throws.ArgumentException);
        Assert.That(() => new HeadShape([(0.5, 0), (0.5, 1)]), Throws.ArgumentException);
        Assert.That(() => new HeadShape([(0.5, 0), (0.6, 1), (0.7, 0.9)]), Throws.ArgumentException);
        Assert.That(() => new HeadShape([(0.5, 0), (0.6, 1), (0.7, 1)]), Throws.Nothing);
    }

    [Test]
    public void Contacts_of_random_moves_agree_with_sampling()
    {
        var random = new Random(7);
        var found = new int[2];
        for (var round = 0; round < 100; round++)
        {
            var deposit = new Deposit();
            var extrusions = new List<(Vec3 A, Vec3 B, double Half)>();
            for (var i = 0; i < 3; i++)
            {
                var a = Point(random, 25, 6);
                extrusions.Add((a, i == 0 ? a + new Vec3(6, 3, 0) : a + new Vec3(random.Next(-9, 9), random.Next(-9, 9), random.Next(-2, 3)), 0.3));
                deposit.Add(extrusions[i].A, extrusions[i].B, extrusions[i].Half, i);
            }
            var from = Point(random, 25, 2);
            var to = random.Next(4) == 0 ? from + new Vec3(0, 0, random.Next(-3, 4)) : Point(random, 25, 2);
            var contact = deposit.Contacts.Meets(from, to, 0.05, Head, true, out var tag);
            if (contact == HeadContact.None)
            {
                Assert.That(extrusions.Any(s => Sampled(s, from, to, 0.05, -0.02)), Is.False, $"round {round}");
                found[0]++;
            }
            else
            {
                Assert.That(Sampled(extrusions[tag], from, to, 0.05 - 0.05, 0.1), Is.True, $"round {round}");
                found[1]++;
            }
        }
        Assert.That(found, Is.All.GreaterThan(12));
    }

    // An extrusion in the cells from (0, 5) to (10, 5.25), 3 mm high; a box from 2 mm left to 2 mm right, 1 mm before and after, from 0.5 mm above its origin.
    [TestCase(20, 3.99, 2, -20, 3.99, 2, 0, false)]
    [TestCase(20, 4.01, 2, -20, 4.01, 2, 0, true)]
    [TestCase(20, 6.24, 2, -20, 6.24, 2, 0, true)]
    [TestCase(20, 6.26, 2, -20, 6.26, 2, 0, false)]
    [TestCase(15, 5, 2, 12.01, 5, 2, 0, false)]
    [TestCase(15, 5, 2, 11.99, 5, 2, 0, true)]
    [TestCase(-5, 5, 2, -2.01, 5, 2, 0, false)]
    [TestCase(-5, 5, 2, -1.99, 5, 2, 0, true)]
    [TestCase(5, -9, 2, 5, 3.99, 2, 0, false)]
    [TestCase(5, -9, 2, 5, 4.01, 2, 0, true)]
    [TestCase(20, 5, 2.49, -20, 5, 2.49, 0, true)]
    [TestCase(20, 5, 2.5, -20, 5, 2.5, 0, false)]
    [TestCase(20, 5, 2.39, -20, 5, 2.39, 0.1, true)]
    [TestCase(20, 5, 2.41, -20, 5, 2.41, 0.1, false)]
    [TestCase(20, 5, 5, 11, 5, 2.6, 0, false)]
    [TestCase(20, 5, 5, 11, 5, 2.4, 0, true)]
    [TestCase(5, 5, 9, 5, 5, 2.51, 0, false)]
    [TestCase(5, 5, 9, 5, 5, 2.49, 0, true)]
    [TestCase(30, 30, 0, -30, 40, 0, 0, false)]
    public void A_box_meets_cells_that_it_passes_lower_than_their_tops(
        double ax, double ay, double az, double bx, double by, double bz, double tolerance, bool meets)
    {
        var deposit = new Deposit();
        deposit.Add(new Vec3(0.125, 5.125, 3), new Vec3(9.875, 5.125, 3), 0.1, 7);
        deposit.Add(new Vec3(0.125, 5.125, 1.5), new Vec3(9.875, 5.125, 1.5), 0.1, 8);
        var box = new Bounds(new Vec3(-2, -1, 0.5), new Vec3(2, 1, 10));
        Assert.That(deposit.Contacts.MeetsBox(new Vec3(ax, ay, az), new Vec3(bx, by, bz), tolerance, box, out var tag), Is.EqualTo(meets));
        Assert.That(tag, Is.EqualTo(meets ? 7 : -1), "the last extrusion that is high enough");
        Assert.That(deposit.Contacts.MeetsBox(new Vec3(bx, by, bz), new Vec3(ax, ay, az), tolerance, box, out _), Is.EqualTo(meets), "the other way around");
        Assert.That(new Deposit().Contacts.MeetsBox(new Vec3(ax, ay, az), new Vec3(bx, by, bz), tolerance, box, out tag), Is.False);
    }

    [Test]
    public void Boxes_on_random_slopes_agree_with_sampling()
    {
        var random = new Random(11);
        var box = new Bounds(new Vec3(-4, -2, 1), new Vec3(3, 5, 9));
        var found = new int[2];
        for (var round = 0; round < 200; round++)
        {
            var deposit = new Deposit();
            var at = Point(random, 9, 4);
            deposit.Add(at, at, 0.1, 3);
            var (a, b) = (Point(random, 20, 6) - Vec3.UnitZ * 3, Point(random, 20, 6) - Vec3.UnitZ * 3);
            var (near, far) = (false, false);
            for (var i = 0; i <= 400; i++)
            {
                var p = Vec3.Lerp(a, b, i / 400.0);
                var d = at - p;
                near |= d.Z > 1.1 && d.X > -3.7 && d.X < 2.7 && d.Y > -1.7 && d.Y < 4.7;
                far |= d.Z > 0.9 && d.X > -4.5 && d.X < 3.5 && d.Y > -2.5 && d.Y < 5.5;
            }
            var meets = deposit.Contacts.MeetsBox(a, b, 0, box, out var tag);
            if (near) Assert.That(meets, Is.True, $"round {round}");
            if (!far) Assert.That(meets, Is.False, $"round {round}");
            if (near) Assert.That(tag, Is.EqualTo(3));
            found[meets ? 1 : 0]++;
        }
        Assert.That(found, Is.All.GreaterThan(15));
    }

    private static bool Sampled((Vec3 A, Vec3 B, double Half) extrusion, Vec3 from, Vec3 to, double tolerance, double wider)
    {
        for (var i = 0; i <= 100; i++)
        {
            var p = Vec3.Lerp(from, to, i / 100.0);
            // As discs around its axis, and as a strip that is level across itself.
            if (SampledExtrusion.Top(extrusion.A, extrusion.B, 0, 30).Any(q => Within(p, q, extrusion.Half))
                && SampledExtrusion.Top(extrusion.A, extrusion.B, extrusion.Half, 30).Any(q => Within(p, q, 0))) return true;

        }
        return false;

        bool Within(Vec3 p, Vec3 q, double half)
        {
            var reach = Head.AxisReach(q.Z - p.Z - tolerance, half, true);
            return reach >= 0 && (q - p).LengthXY <= reach + wider * (1 + 2 * Math.Abs(extrusion.B.Z - extrusion.A.Z + to.Z - from.Z) / 10);
        }
    }

    private static Vec3 Point(Random random, double size, double high)
        => new(random.NextDouble() * 2 * size - size, random.NextDouble() * 2 * size - size, random.NextDouble() * high);
}
