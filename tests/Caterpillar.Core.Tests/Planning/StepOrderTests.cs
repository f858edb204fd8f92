using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Planning;

public class StepOrderTests
{
    private static readonly Bead Bead = new(0.08, 0.2);

    [Test]
    public void Groups_are_sorted_inside_and_ranks_keep_their_order()
    {
        Step[] steps =
        [
            Path(0, 1, new StepGroup(0, 0, 0)), Path(20, 21, new StepGroup(0, 0, 0)), Path(10, 11, new StepGroup(0, 0, 0)),
            Path(3, 4, new StepGroup(0, 0, 1)), Path(22, 23, new StepGroup(0, 0, 1)),
        ];
        Assert.That(Order(steps), Is.EqualTo(new[] { 0, 2, 1, 4, 3 }));
    }

    [Test]
    public void The_nearest_island_comes_next_and_is_finished_before_another()
    {
        Step[] steps =
        [
            Path(0, 1, new StepGroup(0, 0, 0)), Path(50, 51, new StepGroup(0, 1, 0)), Path(20, 21, new StepGroup(0, 2, 0)),
            Path(2, 3, new StepGroup(0, 0, 1)), Path(48, 49, new StepGroup(0, 1, 1)), Path(22, 23, new StepGroup(0, 2, 1)),
            Path(0, 1, new StepGroup(1, 0, 0)),
        ];
        Assert.That(Order(steps), Is.EqualTo(new[] { 0, 3, 2, 5, 1, 4, 6 }));
    }

    [Test]
    public void Islands_below_zero_come_first()
    {
        Step[] steps = [Path(0, 1, new StepGroup(0, 0)), Path(90, 91, new StepGroup(0, -1)), Path(99, 100, new StepGroup(0, -2)),
            Path(80, 81, new StepGroup(0, 1))];
        Assert.That(StepOrder.Find(steps, new SortOptions(Start: Vec3.Zero), null, default).Select(o => o.Source), Is.EqualTo(new[] { 2, 1, 3, 0 }));
    }

    [Test]
    public void Events_travels_and_paths_without_a_group_are_barriers()
    {
        var g = new StepGroup(0);
        Step[] steps =
        [
            Path(0, 1, g), Path(9, 8, g), Path(2, 3, g), new FanEvent(1), Path(7, 8, g), Path(4, 5, g),
            new TravelStep(new Vec3(30, 0)), Path(0, 1, g), Path(29, 28, g), Path(100, 101, null), Path(0, 1, g), Path(99, 98, g),
        ];
        Assert.That(Order(steps), Is.EqualTo(new[] { 0, 2, 1, 3, 4, 5, 6, 8, 7, 9, 11, 10 }));
    }

    [Test]
    public void A_chosen_seam_is_kept()
    {
        var loop = new PrintPath([new Vec3(10, 0), new Vec3(20, 0), new Vec3(2, 1)], Bead, closed: true);
        Step[] Steps(bool keep) => [Path(0, 1, new StepGroup(0)), new PathStep(loop, new StepGroup(0)) { KeepStart = keep }];
        Assert.That(StepOrder.Find(Steps(true), new SortOptions(), null, default)[1].Path, Is.SameAs(loop));
        Assert.That(StepOrder.Find(Steps(false), new SortOptions(), null, default)[1].Path!.Start, Is.EqualTo(new Vec3(2, 1)));
    }

    [Test]
    public void Every_step_stays_and_no_path_leaves_its_group_or_crosses_a_barrier()
    {
        var random = new Random(23);
        for (var round = 0; round < 100; round++)
        {
            var steps = Random(random.Next(1, 60), random);
            foreach (var rule in new[] { SortRule.Nearest, SortRule.Tour, SortRule.Orient, SortRule.None })
            {
                var order = StepOrder.Find(steps, new SortOptions(rule), null, default);
                Assert.That(order.Select(o => o.Source).OrderBy(i => i), Is.EqualTo(Enumerable.Range(0, steps.Count)));
                var done = new List<StepGroup>();
                for (var i = 0; i < order.Length; i++)
                {
                    Assert.That(order[i].Step, Is.SameAs(steps[order[i].Source]));
                    if (steps[i] is not PathStep { Group: { } })
                    {
                        Assert.That(order[i].Source, Is.EqualTo(i));
                        done.Clear();
                        continue;
                    }
                    if (rule == SortRule.None) continue;
                    var group = ((PathStep)order[i].Step).Group!.Value;
                    if (done.Count > 0 && done[done.Count - 1] == group) continue;
                    Assert.That(done, Has.No.Member(group), "a group is printed without interruption");
                    if (done.Count > 0)
                    {
                        var last = done[done.Count - 1];
                        Assert.That(group.Layer, Is.GreaterThanOrEqualTo(last.Layer));
                        if (group.Layer == last.Layer && group.Island == last.Island) Assert.That(group.Rank, Is.GreaterThan(last.Rank));
                    }
                    done.Add(group);
                }
            }
        }
    }

    private static List<Step> Random(int count, Random random)
    {
        var paths = SortingTests.Random(count, random);
        var steps = new List<Step>();
        foreach (var path in paths)
        {
            switch (random.Next(20))
            {
                case 0: steps.Add(new DwellEvent(1)); break;
                case 1: steps.Add(new TravelStep(new Vec3(random.Next(100), 0))); break;
                case 2: steps.Add(path); break;
                default: steps.Add(new PathStep(path, new StepGroup(random.Next(3), random.Next(3), random.Next(3)))); break;
            }
        }
        return steps;
    }

    private static int[] Order(IReadOnlyList<Step> steps) => StepOrder.Find(steps, new SortOptions(), null, default).Select(o => o.Source).ToArray();

    private static PathStep Path(double from, double to, StepGroup? group) => new(new PrintPath([new Vec3(from, 0), new Vec3(to, 0)], Bead), group);
}
