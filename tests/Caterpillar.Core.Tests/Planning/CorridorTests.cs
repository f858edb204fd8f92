using System.Collections.Generic;
using System.Linq;
using System;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Planning;

public class CorridorTests
{
    private static readonly PlanRules Rules = PlanningTests.Rules with
    {
        Head = new HeadCorridor([(0.4, 0)]), Settings = PlanningTests.Rules.Settings with { ZHopType = ZHopType.AbovePath, RetractionMinTravel = 1000 },
    };

    [Test]
    public void What_is_not_under_a_travel_does_not_lift_it()
    {
        // A tower at y = 50, a low wall at x = 12, and travels along y = 0.
        Step[] steps = [Line(0, 50, 5, 50, 20), Line(12, -3, 12, 3, 1), Line(0, 0, 10, 0, 0.2), Line(14, 0, 20, 0, 0.2), Line(22, 0, 30, 0, 0.2)];
        var plan = PlanningTests.Plan(steps, Rules, new PlanOptions { Start = new Vec3(0, 50, 20) });
        Assert.That(PlanningTests.Text(plan.Toolpath), Is.EqualTo(new[]
        {
            "Print 5,50,20 1.25 50", "Travel 12,-3,20 0 150", "Travel 12,-3,1 0 10", "Print 12,3,1 1.5 50",
            "Travel 0,0,1 0 150", "Travel 0,0,0.2 0 10", "Print 10,0,0.2 2.5 50",
            "Travel 10,0,1.5 0 10", "Travel 14,0,1.5 0 150", "Travel 14,0,0.2 0 10", "Print 20,0,0.2 1.5 50",
            "Travel 22,0,0.2 0 150", "Print 30,0,0.2 2 50",
        }));
        Assert.That((plan.Report.LocalZHops, plan.Report.SkippedZHops, plan.Report.ZHops), Is.EqualTo((1, 3, 0)));
    }

    [Test]
    public void The_width_of_the_head_counts_from_its_height()
    {
        // A wall 3 mm beside the travel, 1 mm and then 6 mm higher than it; the head is 5 mm wide from 4 mm above its tip.
        var rules = Rules with { Head = new HeadCorridor([(0.4, 0), (5, 4)]) };
        foreach (var (height, lift) in new[] { (1.0, 0.0), (4.0, 0.0), (6.0, 2.5) })
        {
            Step[] steps = [Line(10, 3, 20, 3, height), Line(0, 0, 5, 0, 0), Line(25, 0, 30, 0, 0)];
            var moves = PlanningTests.Plan(steps, rules).Toolpath.Moves().ToList();
            var travel = moves.Single(m => m.Kind == MoveKind.Travel && m.End.X == 25 && m.Start.X == 5);
            Assert.That(travel.Start.Z, Is.EqualTo(lift).Within(1e-12));
        }
    }

    [Test]
    public void A_detour_is_taken_if_it_is_faster_than_a_lift()
    {
        // A wall 4 mm long and 10 mm high blocks the travel: over it takes 2 s up and down, around it almost nothing.
        Step[] steps = [Line(15, -2, 15, 2, 10), Line(0, 0, 10, 0, 0.2), Line(20, 0, 30, 0, 0.2)];
        var plan = PlanningTests.Plan(steps, Rules with { Settings = Rules.Settings with { Detour = true } });
        Assert.That(plan.Report.Detours, Is.EqualTo(1));
        var moves = plan.Toolpath.Moves().SkipWhile(m => m.End != new Vec3(10, 0, 0.2)).Skip(1).TakeWhile(m => m.Kind == MoveKind.Travel).ToList();
        Assert.That(moves.Select(m => m.End.Z), Is.All.EqualTo(0.2));
        Assert.That(moves[moves.Count - 1].End, Is.EqualTo(new Vec3(20, 0, 0.2)));
        Assert.That(moves.Sum(m => m.Length), Is.LessThan(14));
        AssertClear(plan.Toolpath, 0.45);
        // A wall 24 mm long and 1 mm higher: around it are 17 mm more, over it takes as long as 9 mm, at any height.
        foreach (var z in new[] { 0.2, 60 })
        {
            Step[] small = [Line(15, -12, 15, 12, z + 1), Line(0, 0, 10, 0, z), Line(20, 0, 30, 0, z)];
            var slow = PlanningTests.Plan(small, Rules with { Settings = Rules.Settings with { Detour = true, TravelSpeed = 30 } });
            Assert.That((slow.Report.Detours, slow.Report.LocalZHops), Is.EqualTo((0, 1)), "at " + z);
        }
        // A long low wall is passed over.
        Step[] low = [Line(15, -80, 15, 80, 0.4), Line(0, 0, 10, 0, 0.2), Line(20, 0, 30, 0, 0.2)];
        var over = PlanningTests.Plan(low, Rules with { Settings = Rules.Settings with { Detour = true } });
        Assert.That((over.Report.Detours, over.Report.LocalZHops), Is.EqualTo((0, 1)));
    }

    [Test]
    public void Combing_goes_straight_inside_the_part_and_lifts_over_everything_else()
    {
        // A U of 30 x 20 mm: its arms are 10 mm wide.
        var u = Region.From(new Polyline([new Vec3(0, 0), new Vec3(30, 0), new Vec3(30, 20), new Vec3(20, 20), new Vec3(20, 10), new Vec3(10, 10),
            new Vec3(10, 20), new Vec3(0, 20)], closed: true));
        var rules = Rules with { Settings = Rules.Settings with { ZHopType = ZHopType.AbovePrint, RetractionMinTravel = 2, Comb = true } };
        PathStep In(Region? region, PrintPath path) => new(path) { Region = region };
        Step[] steps =
        [
            In(u, Line(1, 5, 5, 5, 0.2)), In(u, Line(25, 5, 25, 15, 0.2)), In(u, Line(5, 15, 5, 10, 0.2)), In(u, Line(5, 5, 1, 5, 0.4)),
                In(null, Line(4, 2, 8, 2, 0.4)),
        ];
        var plan = PlanningTests.Plan(steps, rules, new PlanOptions { Start = new Vec3(1, 5, 0.2) });
        Assert.That(PlanningTests.Text(plan.Toolpath).Take(4),
            Is.EqualTo(new[] { "Print 5,5,0.2 1 50", "Travel 25,5,0.2 0 150", "Print 25,15,0.2 2.5 50", "Retract 25,15,0.2 -1 40" }));
        Assert.That((plan.Report.Combed, plan.Report.ZHops, plan.Report.Retractions), Is.EqualTo((1, 3, 3)));
        Assert.That(PlanningTests.Plan(steps, rules with { Settings = rules.Settings with { Comb = false } }).Report.Combed, Is.Zero);
    }

    [Test]
    public void No_travel_passes_through_a_printed_extrusion()
    {
        var random = new Random(53);
        int lifts = 0, detours = 0, skipped = 0;
        for (var round = 0; round < 40; round++)
        {
            var steps = new List<Step>();
            for (var i = random.Next(5, 40); i > 0; i--)
            {
                var a = new Vec3(random.NextDouble() * 30, random.NextDouble() * 30, random.Next(1, 15) * 0.3);
                var b = a + new Vec3(random.NextDouble() * 20 - 10, random.NextDouble() * 20 - 10, random.Next(3) == 0 ? random.NextDouble() * 4 : 0);
                steps.Add(new PrintPath([a, b], new Bead(0.04 + random.NextDouble() * 0.2, 0.3)));
            }
            var settings = Rules.Settings with { Detour = round % 2 == 0 };
            var plan = PlanningTests.Plan(steps, Rules with { Head = new HeadCorridor([(0.1 + random.NextDouble(), 0)]), Settings = settings },
                new PlanOptions { Start = new Vec3(0, 0, 50) });
            AssertClear(plan.Toolpath, 0.05);
            lifts += plan.Report.LocalZHops;
            detours += plan.Report.Detours;
            skipped += plan.Report.SkippedZHops;
        }
        Assert.That(lifts, Is.GreaterThan(100));
        Assert.That(skipped, Is.GreaterThan(50));
        Assert.That(detours, Is.GreaterThan(10));
    }

    // Samples every travel that is not straight up or down, and looks at every extrusion printed before: an independent test of what Deposit answers.
    internal static void AssertClear(Toolpath toolpath, double radius)
    {
        var extrusions = new List<(Vec3 A, Vec3 B)>();
        foreach (var move in toolpath.Moves())
        {
            if (move.Kind == MoveKind.Print) extrusions.Add((move.Start, move.End));
            if (move.Kind != MoveKind.Travel || (move.End - move.Start).LengthXY < 1e-9) continue;
            for (var i = 0; i <= 100; i++)
            {
                var p = Vec3.Lerp(move.Start, move.End, i / 100.0);
                foreach (var (a, b) in extrusions)
                {
                    var d = (b - a).WithZ(0);
                    var t = Math.Min(1, Math.Max(0, Vec3.Dot((p - a).WithZ(0), d) / d.LengthSquared));
                    var q = Vec3.Lerp(a, b, t);
                    if ((p - q).LengthXY <= radius && !(p.Z >= q.Z - 1e-5)) Assert.Fail($"{move} is at {p} below {q}");
                }
            }
        }
    }

    private static PrintPath Line(double x0, double y0, double x1, double y1, double z) => PlanningTests.Line(x0, y0, x1, y1, z);
}
