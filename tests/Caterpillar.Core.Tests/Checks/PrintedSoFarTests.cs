using System;
using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>What counts as printed while the head goes on: extrusions 1 mm high along X, 0.1 mm² unless they say otherwise.</summary>
public class PrintedSoFarTests
{
    [TestCase(0.4, 0.25)]
    [TestCase(1, 0.25)]
    [TestCase(2, 0.5)]
    public void Cells_are_a_quarter_of_a_wide_nozzle(double nozzle, double cell)
        => Assert.That(PrintedSoFar.CellOf(new Printer { NozzleDiameter = nozzle }), Is.EqualTo(cell));

    // The tip of 0.5 mm, a nozzle of 0.4 and two cells of 0.25 stay fresh, in two pieces of 0.7 mm.
    [TestCase(0, 8.5, 9)]
    [TestCase(0.7, 9.2, 9.7)]
    [TestCase(1.4, 9.9, 10.3)]
    public void The_end_of_a_extrusion_is_fresh_and_goes_piece_by_piece(double ahead, double covered, double free)
    {
        var printed = Printed(10);
        Assert.That((printed.Lag, printed.FreshPiece), Is.EqualTo((1.4, 0.7)));
        printed.Advance(ahead);
        Assert.That(Top(printed, covered), Is.EqualTo(1));
        Assert.That(Top(printed, free), Is.Zero);
    }

    [Test]
    public void An_extrusion_as_short_as_its_fresh_end_is_fresh_from_its_start()
    {
        var printed = Printed(1.4);
        printed.Advance(0);
        Assert.That(Top(printed, 0), Is.Zero);
        printed.Advance(0.7);
        Assert.That((Top(printed, 0.3), Top(printed, 1.2)), Is.EqualTo((1, 0)));
    }

    // As many as fit into the fresh end, and several times as many; now and then it is asked for.
    [TestCase(1)]
    [TestCase(7)]
    [TestCase(100_000)]
    public void Tiny_extrusions_are_fresh_as_long_as_one(int often)
    {
        var printed = new PrintedSoFar(SmallPrint.Setup());
        for (var i = 0; i < 1000; i++)
        {
            printed.Add(Move(new Vec3(0.01 * i, 0, 1), new Vec3(0.01 * (i + 1), 0, 1), 0.1), 1);
            if (i % often == 0) printed.Advance(0);
        }
        printed.Advance(0);
        foreach (var x in new[] { 0.0, 0.5, 2, 4, 8.5 }) Assert.That(Top(printed, x), Is.EqualTo(1), $"{x}");
        Assert.That(Top(printed, 9), Is.Zero);
        printed.Advance(2);
        Assert.That(Top(printed, 9.9), Is.EqualTo(1));
    }

    [Test]
    public void Motion_without_material_makes_a_extrusion_old()
    {
        var printed = Printed(1);
        printed.Add(Move(new Vec3(1, 0, 1), new Vec3(1, 5, 1), 0), 1);
        printed.Advance(0);
        Assert.That((Top(printed, 0.5), Top(printed, 1, 3)), Is.EqualTo((1, 0)));
        Assert.That(printed.Highest, Is.EqualTo(1));
    }

    // An extrusion that rises or falls by 1 mm; its last 0.7 mm and the 0.7 mm before stop to be fresh one after the other.
    [TestCase(1, 2)]
    [TestCase(2, 1)]
    public void What_has_just_stopped_to_be_fresh_can_be_asked_for(double from, double to)
    {
        var printed = new PrintedSoFar(SmallPrint.Setup());
        Vec3 start = new(0, 0, from), end = new(10, 0, to);
        printed.Add(Move(start, end, 0.1) with { Index = 7 }, 1);
        double Height(double rest) => to + (from - to) * rest / start.DistanceTo(end);
        Assert.That((printed.Advance(0), printed.Advance(0.6), printed.TopOfLast(0)), Is.EqualTo((1, 0, double.NegativeInfinity)));
        Assert.That(printed.Advance(0.7), Is.EqualTo(1));
        Assert.That(printed.TopOfLast(1), Is.EqualTo(Math.Max(Height(0.7), Height(1.4))).Within(1e-9));
        Assert.That(printed.TopOfLast(2), Is.EqualTo(Math.Max(Height(0.7), from)).Within(1e-9));
        // Across the path, at the middle of the piece and of what went before.
        foreach (var (x, contact, tag) in new[] { (8.9, HeadContact.Hits, 7), (5.0, HeadContact.None, -1), (14.0, HeadContact.None, -1) })
        {
            Vec3 a = new(x, -2, 0.2), b = new(x, 2, 0.2);
            Assert.That((printed.MeetsLast(1, a, b, 0, true, out var move), move), Is.EqualTo((contact, tag)), $"{x}");
        }
        Assert.That(printed.MeetsLast(2, new Vec3(5, 0, 0.2), new Vec3(5, 1, 0.2), 0, true, out _), Is.EqualTo(HeadContact.Hits));
        Assert.That(printed.MeetsLast(1, new Vec3(8.9, 0, 2.1), new Vec3(8.9, 1, 2.1), 0, true, out _), Is.EqualTo(HeadContact.None));
        Assert.That(printed.Advance(1.4), Is.EqualTo(1));
        Assert.That(printed.Deposit.ExtrusionCount, Is.EqualTo(1), "one extrusion in the end");
    }

    [Test]
    public void A_printing_move_without_material_leaves_nothing()
    {
        var printed = new PrintedSoFar(SmallPrint.Setup());
        printed.Add(Move(new Vec3(0, 0, 1), new Vec3(10, 0, 1), 0) with { Kind = MoveKind.Print }, 1);
        Assert.That((printed.Advance(2), printed.Highest), Is.EqualTo((0, double.NegativeInfinity)));
    }

    // 10 mm² in 1 mm would be 10 mm wide.
    [Test]
    public void No_extrusion_is_wider_than_twelve_nozzles()
    {
        var printed = Printed(10, 10);
        printed.Advance(2);
        Assert.That((Top(printed, 5, 2.3), Top(printed, 5, 2.5)), Is.EqualTo((1, 0)));
    }

    // A plate 5 mm high; extrusions may be pressed 0.05 mm into it.
    [TestCase(5, 6, 5)]
    [TestCase(5, 5, 5)]
    [TestCase(5, 4.97, 4.97)]
    [TestCase(5, 4.94, 0)]
    [TestCase(50, 6, 0)]
    public void The_floor_is_the_object_or_the_bed(double x, double z, double floor)
    {
        var plate = TriMesh.Create([new(0, 0, 5), new(10, 0, 5), new(10, 10, 5), new(0, 10, 5)], [0, 1, 2, 0, 2, 3]);
        var setup = SmallPrint.Setup() with { PrintedOn = plate };
        Assert.That(new PrintedSoFar(setup).FloorUnder(new Vec3(x, 5, z)), Is.EqualTo(floor).Within(1e-9));
        Assert.That(new PrintedSoFar(SmallPrint.Setup()).FloorUnder(new Vec3(x, 5, z)), Is.Zero);
    }

    // 1 mm above the extrusion, at most 1.5 mm beside it.
    [Test]
    public void A_mean_gap_is_exact_unless_it_is_clearly_below_the_least_that_is_asked_for()
    {
        var printed = Printed(10, 0.4);
        printed.Advance(0);
        double Mean(double least) => printed.GapAcross(new Vec3(5, 0, 2), new Vec3(0, 0.8), 1.5, 2, int.MaxValue, least);
        var exact = Mean(0);
        Assert.That(exact, Is.GreaterThan(1).And.LessThan(1.5));
        Assert.That((Mean(exact), Mean(1.0005 * exact)), Is.EqualTo((exact, exact)));
        Assert.That(Mean(1.4), Is.LessThan(exact));
    }

    // Crossing extrusions on a slope, of which some are too high to lie below the point.
    [Test]
    public void What_is_known_to_lie_below_a_point_does_not_change_the_gap()
    {
        var random = new Random(7);
        for (var round = 0; round < 200; round++)
        {
            var printed = new PrintedSoFar(SmallPrint.Setup());
            for (var i = 0; i < 12; i++) printed.Deposit.Add(Place(), Place(), 0.1 + 0.5 * random.NextDouble(), i);
            var (p, half) = (new Vec3(1, 1, 1.2), new Vec3(random.NextDouble() - 0.5, 0.6));
            var top = printed.Deposit.TopUnder(p, 0.9, out var known);
            Assert.That(known?.TopAt(p, 0) ?? double.NegativeInfinity, Is.EqualTo(top));
            var exact = Mean(0, null);
            Assert.That((Mean(0, known), Mean(exact, known)), Is.EqualTo((exact, exact)));
            Assert.That(Mean(1.01 * exact, known), Is.LessThan(1.01 * exact));

            Vec3 Place() => new(2 * random.NextDouble(), 2 * random.NextDouble(), 0.6 + random.NextDouble());
            double Mean(double least, Extrusion? below) => printed.GapAcross(p, half, 0.8, 0.9, int.MaxValue, least, below);
        }
    }

    private static PrintedSoFar Printed(double length, double area = 0.1)
    {
        var printed = new PrintedSoFar(SmallPrint.Setup());
        printed.Add(Move(new Vec3(0, 0, 1), new Vec3(length, 0, 1), area), 1);
        return printed;
    }

    private static CheckedMove Move(Vec3 from, Vec3 to, double area) => new()
    {
        Start = from, End = to, StartKnown = true, Kind = area > 0 ? MoveKind.Print : MoveKind.Travel, Length = from.DistanceTo(to),
        Deposited = from.DistanceTo(to) * area,
    };

    private static double Top(PrintedSoFar printed, double x, double y = 0) => Math.Max(printed.Deposit.TopUnder(new Vec3(x, y), 10), 0);
}
