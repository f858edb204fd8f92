using System.Collections.Generic;
using System.Linq;
using System;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Planning;

public class ReturnTests
{
    private static readonly PlanRules Rules = PlanningTests.Rules with
    {
        Settings = PlanningTests.Rules.Settings with { ZHopType = ZHopType.AbovePath }, Head = new HeadCorridor([(0.3, 0)]),
    };

    [Test]
    public void A_return_goes_over_the_top_with_retraction()
    {
        var thin = new PrintPath([new Vec3(0, 0, 1), new Vec3(10, 0, 3.5)], new Bead(0.05));
        Step[] steps = [thin, Return(0, 0, 1), Path(0, 0, 1, 0, 10, 5)];
        var plan = PlanningTests.Plan(steps, Rules with { Outline = new HeadShape([(0.1, 0)]) });
        Assert.That(PlanningTests.Text(plan.Toolpath).Skip(2).Take(4),
            Is.EqualTo(new[] { "Retract 10,0,3.5 -1 40", "Travel 0,0,3.5 0 150", "Travel 0,0,1 0 10", "Deretract 0,0,1 1 30" }));
        Assert.That((plan.Report.ReturnsOver, plan.Report.ReturnsAlong, plan.Report.BlockedReturns), Is.EqualTo((1, 0, 0)));
    }

    [Test]
    public void Around_a_tower_the_head_goes_back_along_the_branch()
    {
        var branch = new PrintPath([new Vec3(0, 0), new Vec3(0, 6), new Vec3(8, 6), new Vec3(8, 0)], new Bead(0.5));
        Step[] steps = [Path(4, -2, 30, 4, 2, 30), new TravelStep([new Vec3(0, 0, 30), new Vec3(0, 0, 0)]), branch, Return(0, 0, 0), Path(0, 0, 0, -5, 0, 0)];
        var rules = Rules with { Settings = Rules.Settings with { RetractionMinTravel = 1000 } };
        var plan = PlanningTests.Plan(steps, rules, new PlanOptions { Start = new Vec3(4, -2, 30) });
        Assert.That((plan.Report.ReturnsOver, plan.Report.ReturnsAlong, plan.Report.BlockedReturns), Is.EqualTo((0, 1, 0)));
        Assert.That(PlanningTests.Text(plan.Toolpath).Skip(6),
            Is.EqualTo(new[] { "Travel 8,6,0 0 150", "Travel 0,6,0 0 150", "Travel 0,0,0 0 150", "Print -5,0,0 1.25 50" }));
        // An extrusion across the branch blocks the path along it.
        steps = [.. steps.Take(1), Path(1, 6, 20, 1, 7, 20), .. steps.Skip(1)];
        Assert.That(PlanningTests.Plan(steps, Rules).Report.ReturnsOver, Is.EqualTo(1));
    }

    [Test]
    public void A_return_to_a_point_that_has_been_printed_over_is_reported()
    {
        Step[] steps = [Path(0, 0, 0, 10, 0, 0), new TravelStep(new Vec3(0, -5, 2)), Path(0, -5, 2, 0, 5, 2), Return(0, 0, 0)];
        var result = PlanRun.Run(steps, Rules, new PlanOptions { Start = Vec3.Zero }, null, default);
        Assert.That(result.Value!.Report.BlockedReturns, Is.EqualTo(1));
        Assert.That(result.Diagnostics.Single(),
            Has.Property("Code").EqualTo("plan.blocked_return").And.Property("Source").EqualTo(new SourceLocation(Step: 3)));
    }

    [Test]
    public void As_drawn_returns_go_over_the_top_without_retraction()
    {
        Step[] steps = [Path(0, 0, 0, 10, 0, 5), Return(0, 0, 0)];
        var moves = PlanningTests.Moves(steps, Rules with { Policy = PlanPolicy.AsDrawn });
        Assert.That(moves.Skip(moves.Length - 2), Is.EqualTo(new[] { "Travel 0,0,5 0 150", "Travel 0,0,0 0 10" }));
    }

    [Test]
    public void The_return_follows_the_path_of_the_head()
    {
        var path = new ReturnPath(Rules);
        foreach (var x in new[] { 0, 1, 2, 3, 4 }) path.Visit(new Vec3(x, 0));
        Assert.That(path.BackTo(new Vec3(2, 0)), Is.EqualTo(new[] { new Vec3(3, 0), new Vec3(2, 0) }));
        path.Visit(new Vec3(2, 5));
        Assert.That(path.BackTo(new Vec3(0, 0)), Is.EqualTo(new[] { new Vec3(2, 0), new Vec3(1, 0), new Vec3(0, 0) }));
        Assert.That(path.BackTo(new Vec3(9, 9)), Is.Null);
        path.Visit(new Vec3(9, 8));
        Assert.That(path.BackTo(new Vec3(9, 9)), Is.EqualTo(new[] { new Vec3(9, 9) }));
    }

    // From x = 10 back to 0: the extrusion across covers the start, the middle, the goal, or lies beyond either end.
    [TestCase(10, false)]
    [TestCase(5, false)]
    [TestCase(0, false)]
    [TestCase(-0.06, false)]
    [TestCase(-0.5, true)]
    [TestCase(10.5, true)]
    public void An_extrusion_over_any_point_of_the_path_back_blocks_it(double x, bool open)
    {
        var path = new ReturnPath(Rules with { Outline = new HeadShape([(0.1, 0)]) });
        path.Print(new PrintPath([new Vec3(x, -1, 0.5), new Vec3(x, 1, 0.5)], new Bead(0.04, 0.2)));
        Assert.That(path.Along(new Vec3(10, 0), [new Vec3(7, 0), new Vec3(0, 0)]) == HeadContact.None, Is.EqualTo(open));
    }

    [Test]
    public void A_tree_is_drawn_without_a_travel_through_its_branches()
    {
        foreach (var lift in new[] { ZHopType.AbovePrint, ZHopType.AbovePath, ZHopType.None })
        {
            foreach (var rise in new[] { 0.0, 0.5, 3 })
            {
                var steps = new List<Step>();
                Grow(steps, new Vec3(0, 0, 0), new Vec3(0, 20, rise), 7);
                var plan = PlanningTests.Plan(steps, Rules with { Settings = Rules.Settings with { ZHopType = lift } });
                Assert.That(plan.Report.BlockedReturns, Is.Zero);
                Assert.That(plan.Report.ReturnsOver + plan.Report.ReturnsAlong, Is.EqualTo(steps.Count / 2));
                CorridorTests.AssertClear(plan.Toolpath, 1e-6);
            }
        }
    }

    // Branches that fork left and right and climb.
    private static void Grow(List<Step> steps, Vec3 at, Vec3 d, int depth)
    {
        if (depth == 0) return;
        var end = at + d;
        steps.Add(new PrintPath([at, end], new Bead(0.1)));
        Grow(steps, end, new Vec3(d.X * 0.8 - d.Y * 0.6, d.X * 0.6 + d.Y * 0.8, d.Z) * 0.55, depth - 1);
        Grow(steps, end, new Vec3(d.X * 0.8 + d.Y * 0.6, d.Y * 0.8 - d.X * 0.6, d.Z) * 0.55, depth - 1);
        steps.Add(Return(at.X, at.Y, at.Z));
    }

    private static PrintPath Path(double x0, double y0, double z0, double x1, double y1, double z1)
        => new([new Vec3(x0, y0, z0), new Vec3(x1, y1, z1)], new Bead(0.5));

    private static TravelStep Return(double x, double y, double z) => new(new Vec3(x, y, z), 0, TravelIntent.Return);
}
