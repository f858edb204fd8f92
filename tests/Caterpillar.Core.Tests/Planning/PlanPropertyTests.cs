using System.Collections.Generic;
using System.Linq;
using System;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Planning;

/// <summary>What holds for every plan, on random designs and rules.</summary>
public class PlanPropertyTests
{
    [Test]
    public void Deposited_E_is_the_volume_of_the_paths()
    {
        foreach (var (steps, rules, random) in Designs(60))
        {
            var plan = PlanningTests.Plan(steps,
                rules with
                {
                    Settings = rules.Settings with { StartDistance = 0, CoastingDistance = 0 },
                    Tools = Array.ConvertAll(rules.Tools, t => t with { ExtraE = 0 }),
                });
            for (var tool = 0; tool < rules.Tools.Length; tool++)
            {
                var expected = steps.OfType<PathStep>().Where(p => p.Path.Tool == tool).Sum(p => p.Path.Volume) / rules.Tools[tool].VolumePerE!.Value;
                var deposited = plan.Toolpath.Moves().Where(m => m.Tool == tool).Sum(m => m.Deposited);
                Assert.That(deposited, Is.EqualTo(expected).Within(1e-9 * (1 + expected)));
            }
        }
    }

    [Test]
    public void The_balance_of_each_tool_is_never_negative_or_doubled_and_zero_where_it_prints()
    {
        foreach (var (steps, rules, _) in Designs(60))
        {
            var balance = new double[rules.Tools.Length];
            foreach (var move in PlanningTests.Plan(steps, rules).Toolpath.Moves())
            {
                if (move.Kind is MoveKind.Print or MoveKind.Prime)
                {
                    Assert.That(balance[move.Tool], Is.Zero.Within(1e-12));
                    Assert.That(move.Deposited, Is.EqualTo(move.E));
                    continue;
                }
                Assert.That(move.Deposited, Is.Zero);
                balance[move.Tool] -= move.E;
                Assert.That(balance[move.Tool], Is.InRange(-1e-12, rules.Tools[move.Tool].RetractE + 1e-12));
                if (move.Kind is MoveKind.Retract or MoveKind.Wipe) Assert.That(move.E, Is.Negative);
                if (move.Kind is MoveKind.Deretract or MoveKind.MovingDeretract) Assert.That(balance[move.Tool], Is.Zero.Within(1e-12));
            }
        }
    }

    [Test]
    public void As_drawn_has_only_paths_and_straight_travels()
    {
        foreach (var (steps, rules, _) in Designs(40))
        {
            var toolpath = PlanningTests.Plan(steps, rules with { Policy = PlanPolicy.AsDrawn }).Toolpath;
            Assert.That(toolpath.Moves(), Has.All.Matches<Move>(m => m.Kind is MoveKind.Print or MoveKind.Travel));
            var prints = steps.OfType<PathStep>().Sum(p => p.Path.SegmentCount);
            Assert.That(toolpath.Moves().Count(m => m.Kind == MoveKind.Print), Is.EqualTo(prints));
            Assert.That(toolpath.Moves().Count(m => m.Kind == MoveKind.Travel), Is.LessThanOrEqualTo(steps.Count));
            Assert.That(toolpath.Moves().Select(m => m.Source), Is.Ordered);
        }
    }

    [Test]
    public void Every_segment_is_printed_once_and_in_one_piece()
    {
        foreach (var (steps, rules, _) in Designs(40))
        {
            var toolpath = PlanningTests.Plan(steps, rules with { Settings = rules.Settings with { CoastingDistance = 0 } }).Toolpath;
            var printed = toolpath.Moves().Where(m => m.Kind == MoveKind.Print).Select(m => Key(m.Start, m.End)).OrderBy(k => k).ToArray();
            var drawn = steps.OfType<PathStep>().SelectMany(p => Enumerable.Range(0, p.Path.SegmentCount).Select(i => Key(p.Path.Points[i], p.Path.EndOf(i))))
                .OrderBy(k => k).ToArray();
            Assert.That(printed, Is.EqualTo(drawn));
        }

        static (double, double, double, double) Key(Vec3 a, Vec3 b) => a.X < b.X || (a.X == b.X && a.Y < b.Y) ? (a.X, a.Y, b.X, b.Y) : (b.X, b.Y, a.X, a.Y);
    }

    [Test]
    public void Moves_join_and_a_second_run_gives_the_same_plan()
    {
        foreach (var (steps, rules, _) in Designs(40))
        {
            var plan = PlanningTests.Plan(steps, rules);
            var again = PlanningTests.Plan(steps, rules);
            Assert.That(again.Toolpath.Moves(), Is.EqualTo(plan.Toolpath.Moves()));
            Assert.That(again.Toolpath.Events, Is.EqualTo(plan.Toolpath.Events));
            Assert.That(again.Report, Is.EqualTo(plan.Report));
            Assert.That(plan.Report.Retractions, Is.EqualTo(plan.Report.Deretractions).Or.EqualTo(plan.Report.Deretractions
                + 1).Or.EqualTo(plan.Report.Deretractions + 2));
            var totals = ToolpathTotals.Of(plan.Toolpath);
            Assert.That(plan.Report.TravelLength, Is.LessThanOrEqualTo(totals.TravelLength + 1e-6));
        }
    }

    [Test]
    public void Travels_with_a_lift_stay_above_everything_printed()
    {
        foreach (var (steps, rules, _) in Designs(40))
        {
            var top = double.NegativeInfinity;
            foreach (var move in PlanningTests.Plan(steps.Where(s => s is PathStep).ToList(),
                rules with { Settings = rules.Settings with { ZHopType = ZHopType.AbovePrint, ZHopMinTravel = 0, CoastingDistance = 0 } }).Toolpath.Moves())
            {
                if (move.Kind == MoveKind.Print) top = Math.Max(top, Math.Max(move.Start.Z, move.End.Z));
                if (move.Kind == MoveKind.Travel && (move.End - move.Start).LengthXY > 1e-9)
                    Assert.That(Math.Min(move.Start.Z, move.End.Z), Is.GreaterThanOrEqualTo(top + rules.Clearance - 1e-12));
            }
        }

    }

    [Test]
    public void What_is_written_decodes_to_the_same_kinds_and_amounts()
    {
        foreach (var (steps, rules, _) in Designs(40))
        {
            var oneTool = steps.Where(s => s is not PathStep { Path.Tool: 1 }).ToList();
            var planned = PlanningTests.Plan(oneTool, rules with { Tools = [rules.Tools[0]] }).Toolpath;
            var decoded = GCodeDecoder.Decode(NewFile.Of(planned)).Value!.Toolpath;
            // The first travel starts at an unknown position.
            var before = planned.Moves().SkipWhile(m => m.Kind == MoveKind.Travel).ToArray();
            var after = decoded.Moves().SkipWhile(m => m.Kind == MoveKind.Travel).ToArray();
            Assert.That(after.Select(m => m.Kind), Is.EqualTo(before.Select(m => m.Kind)));
            Assert.That(after.Select(m => m.E), Is.EqualTo(before.Select(m => m.E)).Within(1.1e-5));
            Assert.That(after.Select(m => m.Deposited), Is.EqualTo(before.Select(m => m.Deposited)).Within(2e-5));
        }
    }

    [Test]
    public void Planning_can_be_canceled()
    {
        using var cancel = new System.Threading.CancellationTokenSource();
        cancel.Cancel();
        var (steps, rules, _) = Designs(1).Single();
        Assert.That(() => PlanRun.Run(steps, rules, new PlanOptions(), null, cancel.Token), Throws.InstanceOf<OperationCanceledException>());
    }

    private static IEnumerable<(List<Step> Steps, PlanRules Rules, Random Random)> Designs(int count)
    {
        var random = new Random(31);
        for (var round = 0; round < count; round++)
        {
            var steps = new List<Step>();
            foreach (var path in SortingTests.Random(random.Next(1, 40), random))
            {
                var settled = (path with { Role = random.Next(2) == 0 ? Role.OuterWall : Role.Infill, Tool = random.Next(10) == 0 ? 1 : 0 })
                    .WithBeads(_ => new Bead(0.05 + random.NextDouble(), 0.2));
                if (random.Next(15) == 0) steps.Add(new TravelStep(new Vec3(random.Next(100), random.Next(100), 5)));
                if (random.Next(15) == 0) steps.Add(new FanEvent(random.NextDouble()));
                steps.Add(new PathStep(settled, random.Next(4) == 0 ? null : new StepGroup(random.Next(2), random.Next(2), random.Next(2))));
            }
            var rules = PlanningTests.Rules with
            {
                Tools = [new ToolRules(2.405, 0.8, 40, 30, random.Next(2) * 0.1), new ToolRules(1, 2, 20, 10, 0)],
                WipeDistance = random.Next(2) * 2,
                Settings = PlanningTests.Rules.Settings with
                {
                    ZHopType = random.Next(2) == 0 ? ZHopType.None : ZHopType.AbovePrint,
                    StartDistance = random.Next(2), CoastingDistance = random.Next(2), DeretractDuringDescent = random.Next(2) == 0,
                },
            };
            yield return (steps, rules, random);
        }
    }
}
