using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

public class DepositTests
{
    private static readonly Vec3 Far = new(50, 50);

    [Test]
    public void Nothing_is_below_at_first()
    {
        var deposit = new Deposit();
        Assert.That(deposit.Highest, Is.EqualTo(double.NegativeInfinity));
        Assert.That(deposit.TopAlong(Vec3.Zero, Far, 1), Is.EqualTo(double.NegativeInfinity));
        Assert.That(deposit.TopUnder(Vec3.Zero, 10), Is.EqualTo(double.NegativeInfinity));
    }

    [Test]
    public void An_extrusion_counts_within_its_width_and_the_corridor()
    {
        var deposit = new Deposit();
        deposit.Add(new Vec3(0, 0, 2), new Vec3(10, 0, 2), 0.3);
        // Along y = 1 with a radius of 0.7 the above_path just touches the extrusion.
        Assert.That(deposit.TopAlong(new Vec3(3, 1), new Vec3(8, 1), 0.7001), Is.EqualTo(2));
        Assert.That(deposit.TopAlong(new Vec3(3, 1), new Vec3(8, 1), 0.6999), Is.EqualTo(double.NegativeInfinity));
        Assert.That(deposit.TopAlong(new Vec3(11, -5), new Vec3(11, 5), 0.7001), Is.EqualTo(2));
        Assert.That(deposit.TopAlong(new Vec3(11, -5), new Vec3(11, 5), 0.6999), Is.EqualTo(double.NegativeInfinity));
        Assert.That(deposit.TopUnder(new Vec3(5, 0.29), 9), Is.EqualTo(2));
        Assert.That(deposit.TopUnder(new Vec3(5, 0.31), 9), Is.EqualTo(double.NegativeInfinity));
        Assert.That(deposit.TopUnder(new Vec3(5, 0), 1.99), Is.EqualTo(double.NegativeInfinity));
        Assert.That(deposit.Highest, Is.EqualTo(2));
    }

    [Test]
    public void Only_the_part_of_a_slope_in_reach_counts()
    {
        var deposit = new Deposit();
        deposit.Add(new Vec3(0, 0, 0), new Vec3(10, 0, 10), 0.25);
        // A crossing at x = 4 with 0.75 + 0.25 of reach sees the slope from x = 3 to 5.
        Assert.That(deposit.TopAlong(new Vec3(4, -3), new Vec3(4, 3), 0.75), Is.EqualTo(5).Within(1e-12));
        Assert.That(deposit.TopUnder(new Vec3(4, 0.1), 20), Is.EqualTo(4).Within(1e-12));
    }

    [Test]
    public void Beads_add_the_extrusions_of_segments_and_arcs()
    {
        var deposit = new Deposit();
        deposit.Add(new Vec3(10, 0, 1), new Vec3(-10, 0, 1), new Bead(0.1, 0.2), new Arc(Vec3.Zero, 180));
        deposit.Add(new Vec3(-10, 0, 1), new Vec3(-10, -20, 1), new Bead(0));
        Assert.That(deposit.TopUnder(new Vec3(0, 10), 5), Is.EqualTo(1));
        Assert.That(deposit.TopUnder(new Vec3(0, 9.7), 5), Is.EqualTo(double.NegativeInfinity));
        Assert.That(deposit.TopUnder(new Vec3(-10, -10), 5), Is.EqualTo(double.NegativeInfinity), "a stroke without material");
    }

    [TestCase(0.25)]
    [TestCase(1.0)]
    public void Answers_equal_those_of_sampling_every_extrusion(double cell)
    {
        var random = new Random(41);
        for (var round = 0; round < 4; round++)
        {
            var deposit = new Deposit(cell, 1000);
            var extrusions = Extrusions(random, 60);
            foreach (var s in extrusions) deposit.Add(s.A, s.B, s.Half);
            for (var query = 0; query < 40; query++)
            {
                var a = Point(random);
                var b = random.Next(5) == 0 ? a : Point(random);
                var radius = random.NextDouble() * 2;
                var top = deposit.TopAlong(a, b, radius);
                // Sampling misses at most one step and a small part of the radius.
                Assert.That(top, Is.GreaterThanOrEqualTo(Brute(extrusions, a, b, radius - 1e-9) - 1e-9));
                Assert.That(top, Is.LessThanOrEqualTo(Brute(extrusions, a, b, radius + 0.05) + 1.0));
                Assert.That(top <= Brute(extrusions, a, b, radius + 0.05) + 0.05 || extrusions.Any(s => s.A.Z != s.B.Z));
                var under = deposit.TopUnder(a, 3, radius / 4);
                var expected = extrusions.Select(s => (Near(s, a), s)).Where(n => n.Item1.Distance <= radius / 4 + n.s.Half && n.Item1.Top <= 3)
                    .Select(n => n.Item1.Top).DefaultIfEmpty(double.NegativeInfinity).Max();
                Assert.That(under, Is.EqualTo(expected).Within(1e-9).Or.EqualTo(expected));
            }
        }
    }

    [Test]
    public void Dropped_extrusions_are_never_answered_too_low()
    {
        var random = new Random(43);
        var exact = new Deposit(0.25, 1000);
        var lean = new Deposit(0.25, 0.5);
        var bare = new Deposit(0.25, 1000, hasCells: false);
        for (var layer = 0; layer < 60; layer++)
        {
            var z = 0.2 * (layer + 1);
            for (var i = 0; i < 60; i++)
            {
                // Smaller and smaller, so that low extrusions stay visible beside the high ones.
                var a = new Vec3(random.NextDouble() * (40 - layer * 0.6), random.NextDouble() * 10, z);
                var b = a + new Vec3(random.NextDouble() * 4 - 2, random.NextDouble() * 4 - 2);
                exact.Add(a, b, 0.2);
                lean.Add(a, b, 0.2);
                bare.Add(a, b, 0.2);
            }
        }
        Assert.That(lean.ExtrusionCount, Is.LessThan(exact.ExtrusionCount / 2));
        for (var query = 0; query < 500; query++)
        {
            var a = Point(random);
            var b = Point(random);
            Assert.That(lean.TopAlong(a, b, 0.4), Is.GreaterThanOrEqualTo(exact.TopAlong(a, b, 0.4)));
            // Where something was dropped, all of its bin counts: a square of 2 mm.
            Assert.That(lean.TopAlong(a, b, 0.4), Is.LessThanOrEqualTo(exact.TopAlong(a, b, 0.4 + 2 * 1.4143)));
            Assert.That(bare.TopAlong(a, b, 0.4), Is.EqualTo(exact.TopAlong(a, b, 0.4)), "cells do not change what was not dropped");
            Assert.That(lean.TopUnder(a, 100), Is.GreaterThanOrEqualTo(exact.TopUnder(a, 100)));
        }
    }

    [Test]
    public void Far_away_extrusions_keep_memory_bounded_and_are_not_forgotten()
    {
        var deposit = new Deposit();
        deposit.Add(new Vec3(-1e9, 5, 3), new Vec3(1e9, 5, 3), 0.2);
        deposit.Add(new Vec3(1e7, 1e7, 9), new Vec3(1e7, 1e7 + 5, 9), 0.2);
        Assert.That(deposit.TopAlong(new Vec3(100, 0), new Vec3(100, 10), 0.1), Is.EqualTo(3));
        Assert.That(deposit.TopAlong(new Vec3(100, 0), new Vec3(100, 4), 0.1), Is.EqualTo(double.NegativeInfinity));
        Assert.That(deposit.TopAlong(new Vec3(1e6, 0), new Vec3(1e6, 4), 0.1), Is.EqualTo(9));
        Assert.That(deposit.TopAlong(new Vec3(0, 0), new Vec3(1e8, 0), 0.1), Is.EqualTo(9));
        Assert.That(() => deposit.Add(new Vec3(double.NaN, 0), Vec3.Zero, 1), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => new Deposit(0), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    private static double Brute(List<(Vec3 A, Vec3 B, double Half)> extrusions, Vec3 a, Vec3 b, double radius)
    {
        var best = double.NegativeInfinity;
        foreach (var s in extrusions)
        {
            for (var i = 0; i <= 60; i++)
            {
                var p = Vec3.Lerp(s.A, s.B, i / 60.0);
                if (p.Z > best && Distance(p, a, b) <= radius + s.Half) best = p.Z;
            }
        }
        return best;
    }

    private static (double Distance, double Top) Near((Vec3 A, Vec3 B, double Half) s, Vec3 p)
    {
        var t = FlatSegment.Parameter(p, s.A, s.B);
        if (s.A.WithZ(0) == s.B.WithZ(0)) return ((p - s.A).LengthXY, Math.Max(s.A.Z, s.B.Z));
        return ((p - Vec3.Lerp(s.A, s.B, t)).LengthXY, Vec3.Lerp(s.A, s.B, t).Z);
    }

    private static double Distance(Vec3 p, Vec3 a, Vec3 b)
    {
        var d = (b - a).WithZ(0);
        var t = d.LengthSquared > 0 ? Math.Min(1, Math.Max(0, Vec3.Dot((p - a).WithZ(0), d) / d.LengthSquared)) : 0;
        return (p - a - d * t).LengthXY;
    }

    private static Vec3 Point(Random random) => new(random.NextDouble() * 40 - 20, random.NextDouble() * 40 - 20, random.NextDouble() * 5);

    private static List<(Vec3 A, Vec3 B, double Half)> Extrusions(Random random, int count)
    {
        var extrusions = new List<(Vec3, Vec3, double)>();
        for (var i = 0; i < count; i++)
        {
            var a = Point(random);
            var b = random.Next(10) == 0 ? a.WithZ(random.Next(4)) : random.Next(3) == 0 ? Point(random)
                : a + new Vec3(random.NextDouble() * 6 - 3, random.NextDouble() * 6 - 3);
            extrusions.Add((a, b, random.NextDouble()));
        }
        return extrusions;
    }
}
