using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Flavors;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Simulation;

/// <summary>The planner against others of the tests, on random programs.</summary>
public class PlannerComparisonTests
{
    [Test]
    public void Classic_jerk_over_the_whole_queue_is_what_brute_force_finds()
    {
        for (var seed = 0; seed < 300; seed++)
        {
            var pieces = Programs.Random(seed, 1 + seed % 60);
            var printer = Programs.JerkPrinter with { LookaheadMoves = 0 };
            var machine = new SlowPlanner.Machine([150, 120, 12, 40], [2000, 1500, 100, 3000], [9, 8, 0.4, 3], 1200, 1000, 900);
            var expected = SlowPlanner.TimesByJerk(pieces, machine);
            var timeline = Timeline.Of(Programs.Toolpath(pieces), new PrintSetup { Printer = printer });
            var total = 0.0;
            for (var i = 0; i < pieces.Count; i++)
            {
                total += expected[i];
                Assert.That(timeline.EndOf(i), Is.EqualTo(total).Within(1e-9 * Math.Max(total, 1)), $"seed {seed}, move {i}");
            }
        }
    }

    [Test]
    public void A_short_queue_gives_the_speeds_of_a_plan_that_is_made_again_for_each_move([Values(2, 3, 5, 16)] int queue)
    {
        for (var seed = 0; seed < 60; seed++)
        {
            var pieces = Programs.Random(seed, 80, longest: 2);
            var printer = Programs.JerkPrinter with { LookaheadMoves = queue, Cornering = Cornering.JunctionDeviation, JunctionDeviation = 0.05 };
            var timeline = Timeline.Of(Programs.Toolpath(pieces), new PrintSetup { Printer = printer });
            var whole = Timeline.Of(Programs.Toolpath(pieces), new PrintSetup { Printer = printer with { LookaheadMoves = 0 } });
            Assert.That(timeline.Duration, Is.GreaterThanOrEqualTo(whole.Duration - 1e-9));
            // Each speed at an end, by looking at the queue from there: all that is in it must be braked to rest, unless the program ends in it.
            var t = timeline.Trapezoids().ToArray();
            var corner = Corners(pieces, printer);
            for (var i = 0; i + 1 < t.Length; i++)
            {
                var last = Math.Min(i + queue - 1, t.Length - 1);
                var v2 = 0.0;
                for (var k = last; k > i; k--) v2 = Math.Min(corner[k], v2 + 2 * t[k].Acceleration * pieces[k].Length);
                v2 = Math.Min(v2, t[i].Start * t[i].Start + 2 * t[i].Acceleration * pieces[i].Length);
                Assert.That(t[i].End * t[i].End, Is.EqualTo(v2).Within(1e-7), $"seed {seed}, move {i}");
                Assert.That(t[i + 1].Start, Is.EqualTo(t[i].End));
            }
        }
    }

    [Test]
    public void A_long_program_without_stops_is_planned_in_parts_as_in_one([Values(2, 16, 64)] int queue)
    {
        var pieces = Programs.Random(7, 40_000, longest: 1);
        var setup = new PrintSetup { Printer = Programs.JerkPrinter with { LookaheadMoves = queue } };
        var timeline = Timeline.Of(Programs.Toolpath(pieces), setup);
        // Any stretch of it gives the same speeds, but for the moves near its ends.
        var stretch = Timeline.Of(Programs.Toolpath(pieces.Skip(15_000).Take(2_000).ToList()), setup).Trapezoids().Skip(300).Take(1_000).ToArray();
        Assert.That(timeline.Trapezoids().Skip(15_300).Take(1_000).Select(t => t.Peak), Is.EqualTo(stretch.Select(t => t.Peak)).Within(1e-9));
        Assert.That(timeline.Trapezoids().Sum(t => t.Duration), Is.EqualTo(timeline.Duration).Within(1e-6));
    }

    [Test]
    public void No_speed_jumps_no_limit_is_passed_and_every_move_is_whole([Values] Cornering rule)
    {
        for (var seed = 0; seed < 50; seed++)
        {
            var pieces = Programs.Random(seed, 200);
            var printer = Programs.JerkPrinter with { Cornering = rule, LookaheadMoves = seed % 3 == 0 ? 0 : 8, MinimumCruiseRatio = 0.5 };
            var timeline = Timeline.Of(Programs.Toolpath(pieces), new PrintSetup { Printer = printer });
            var all = timeline.Trapezoids().ToArray();
            Assert.That(all, Has.Length.EqualTo(pieces.Count));
            for (var i = 0; i < all.Length; i++)
            {
                var (t, p) = (all[i], pieces[i]);
                if (!(Math.Abs(t.Length - p.Length) <= 1e-9 * Math.Max(p.Length, 1))) Assert.Fail($"seed {seed}, move {i}: {t.Length} mm, not {p.Length}");
                Assert.That(t.Peak, Is.LessThanOrEqualTo(p.Speed + 1e-9));
                Assert.That(t.Peak, Is.GreaterThanOrEqualTo(Math.Max(t.Start, t.End)));
                Assert.That(t.Accelerating + t.Decelerating, Is.LessThanOrEqualTo(t.Duration + 1e-9));
                if (i > 0) Assert.That(t.Start, Is.EqualTo(all[i - 1].End).Within(1e-12));
                if (rule == Cornering.SquareCornerVelocity) continue;
                Assert.That(t.Peak * Math.Abs(p.Direction[2]), Is.LessThanOrEqualTo(printer.MaxSpeed.Z + 1e-9));
                Assert.That(t.Acceleration * Math.Abs(p.Direction[3]), Is.LessThanOrEqualTo(printer.MaxAcceleration.E + 1e-6));
            }
        }
    }

    private static double[] Corners(IReadOnlyList<SlowPlanner.Piece> pieces, Printer printer)
    {
        // A program of two moves, long enough to reach the corner speed, shows the corner speed itself.
        var corners = new double[pieces.Count];
        for (var i = 1; i < pieces.Count; i++) corners[i] = JunctionDeviation(pieces[i - 1], pieces[i], printer);
        return corners;
    }

    // By vectors and angles: an arc of the deviation that touches both moves.
    private static double JunctionDeviation(SlowPlanner.Piece a, SlowPlanner.Piece b, Printer p)
    {
        double[] limits = [p.MaxAcceleration.X, p.MaxAcceleration.Y, p.MaxAcceleration.Z, p.MaxAcceleration.E];
        double[] speeds = [p.MaxSpeed.X, p.MaxSpeed.Y, p.MaxSpeed.Z, p.MaxSpeed.E];
        var own = b.InPlace ? p.RetractionAcceleration : b.E != 0 ? p.PrintAcceleration : p.TravelAcceleration;
        own = Math.Min(own, Least(b.Direction, limits));
        var (u, v) = (Unit(a.Direction), Unit(b.Direction));
        var dot = u.Zip(v, (x, y) => x * y).Sum();
        if (-dot > 0.999999) return 0;
        var bisector = Unit(u.Zip(v, (x, y) => y - x).ToArray());
        var acceleration = Math.Min(own, Least(bisector, limits));
        var turn = Math.Acos(Math.Min(Math.Max(dot, -1), 1));
        var half = Math.Cos(turn / 2);
        var limit = half < 1 ? acceleration * p.JunctionDeviation * half / (1 - half) : double.PositiveInfinity;
        if (b.Length < 1 && turn < Math.PI / 4) limit = Math.Min(limit, b.Length * acceleration / turn);
        var slower = Math.Min(Math.Min(a.Speed, Least(a.Direction, speeds)), Math.Min(b.Speed, Least(b.Direction, speeds)));
        return Math.Min(limit, slower * slower);
    }

    private static double[] Unit(double[] v)
    {
        var length = Math.Sqrt(v.Sum(x => x * x));
        return v.Select(x => length > 0 ? x / length : x).ToArray();
    }

    private static double Least(double[] direction, double[] limits)
        => direction.Select((d, axis) => d == 0 ? double.PositiveInfinity : limits[axis] / Math.Abs(d)).Min();
}

/// <summary>Random programs, and toolpaths of them.</summary>
internal static class Programs
{
    public static Printer JerkPrinter { get; } = new()
    {
        Cornering = Cornering.Jerk,
        MaxSpeed = new(150, 120, 12, 40),
        MaxAcceleration = new(2000, 1500, 100, 3000),
        Jerk = new(9, 8, 0.4, 3),
        PrintAcceleration = 1200,
        TravelAcceleration = 1000,
        RetractionAcceleration = 900,
    };

    /// <summary>Printing, travels, retractions, hops and reversals; a curve of short pieces now and then.</summary>
    public static List<SlowPlanner.Piece> Random(int seed, int count, double longest = 40)
    {
        var random = new Random(seed);
        var pieces = new List<SlowPlanner.Piece>();
        double heading = 0, speed = 60, length = 1, e = 0.04;
        while (pieces.Count < count)
        {
            var kind = random.Next(20);
            if (kind == 0) pieces.Add(new(0, 0, 0, random.Next(2) == 0 ? -2 : 1.5, 5 + 60 * random.NextDouble()));
            else if (kind == 1) pieces.Add(new(0, 0, (random.NextDouble() - 0.5) * 2, 0, 5 + 20 * random.NextDouble()));
            else
            {
                if (kind < 6)
                {
                    speed = 5 + 200 * random.NextDouble();
                    length = 0.01 + longest * Math.Pow(random.NextDouble(), 3);
                    e = random.Next(3) == 0 ? 0 : 0.1 * random.NextDouble();
                }
                heading += kind == 6 ? Math.PI : kind < 12 ? 0.1 * random.NextDouble() : kind < 17 ? 0 : 3 * random.NextDouble();
                pieces.Add(new(length * Math.Cos(heading), length * Math.Sin(heading), random.Next(8) == 0 ? 0.2 : 0, length * e, speed));
            }
        }
        return pieces;
    }

    /// <summary>The same moves as a toolpath; the pieces are taken again from its points, so that both see the same numbers.</summary>
    public static Toolpath Toolpath(List<SlowPlanner.Piece> pieces)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        var at = Vec3.Zero;
        for (var i = 0; i < pieces.Count; i++)
        {
            var p = pieces[i];
            var to = p.InPlace ? at : at + new Vec3(p.X, p.Y, p.Z);
            var kind = p.InPlace ? p.E < 0 ? MoveKind.Retract : MoveKind.Deretract : p.E > 0 ? MoveKind.Print : MoveKind.Travel;
            builder.Add(to, p.E, Math.Max(p.E, 0), p.Speed, kind, Role.Unspecified, -1, 0, i);
            pieces[i] = p.InPlace ? p : new(to.X - at.X, to.Y - at.Y, to.Z - at.Z, p.E, p.Speed);
            at = to;
        }
        return builder.Build([new ToolpathTool(null)]);
    }
}
