using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Planning;

public class IslandOrderTests
{
    private static readonly Bead Bead = new(0.08, 0.2);

    private static PrintPath Loop(double x, double y, double size)
        => new([new(x, y), new(x + size, y), new(x + size, y + size), new(x, y + size)], Bead, closed: true);

    private static double Travel(IReadOnlyList<OrderedStep> ordered, Vec3 at)
    {
        var sum = 0.0;
        foreach (var step in ordered)
        {
            sum += at.DistanceTo(step.Path!.Start);
            at = step.Path.End;
        }
        return sum;
    }

    [Test]
    public void Islands_in_a_row_are_visited_without_going_back()
    {
        // From 0 the nearest is the one at 4, and then those to the right: the one at −5 would come last.
        double[] places = [4, 9, 15, 22, -5];
        var steps = places.Select((x, i) => (Step)new PathStep(new PrintPath([new(x, 0), new(x, 1)], Bead), new StepGroup(0, i))).ToArray();
        int[] Order(SortRule rule) => StepOrder.Find(steps, new SortOptions(rule, Start: Vec3.Zero), null, default).Select(o => o.Source).ToArray();
        Assert.That(Order(SortRule.Nearest), Is.EqualTo(new[] { 0, 1, 2, 3, 4 }));
        Assert.That(Order(SortRule.Tour), Is.EqualTo(new[] { 4, 0, 1, 2, 3 }));
    }

    [Test]
    public void Exchanges_lose_no_path_and_never_make_the_travel_longer()
    {
        var shorter = 0;
        for (var seed = 0; seed < 60; seed++)
        {
            var random = new Random(seed);
            var steps = new List<Step>();
            var islands = random.Next(3, 25);
            for (var i = 0; i < islands; i++)
            {
                double x = random.NextDouble() * 100, y = random.NextDouble() * 100;
                steps.Add(new PathStep(Loop(x, y, 2), new StepGroup(0, i)) { KeepStart = seed % 2 == 0 });
                steps.Add(new PathStep(Loop(x - 0.4, y - 0.4, 2.8), new StepGroup(0, i)) { KeepStart = seed % 2 == 0, Joined = true });
                for (var k = 0; k < 3; k++)
                    steps.Add(new PathStep(new PrintPath([new(x + 0.5 * k, y), new(x + 0.5 * k, y + 2)], Bead), new StepGroup(0, i, 5)));
            }
            OrderedStep[] Order(SortRule rule) => StepOrder.Find(steps, new SortOptions(rule, Start: Vec3.Zero), null, default);
            var (near, tour) = (Order(SortRule.Nearest), Order(SortRule.Tour));
            Assert.That(tour.Select(o => o.Source).OrderBy(s => s), Is.EqualTo(Enumerable.Range(0, steps.Count)), $"{seed}");
            foreach (var i in Enumerable.Range(0, tour.Length).Where(i => tour[i].Step is PathStep { Joined: true }))
                Assert.That(tour[i].Source, Is.EqualTo(tour[i - 1].Source + 1), "joined paths stay together");
            for (var i = 1; i < tour.Length; i++)
            {
                var (a, b) = (((PathStep)tour[i - 1].Step).Group!.Value, ((PathStep)tour[i].Step).Group!.Value);
                if (a.Island == b.Island) Assert.That(b.Rank, Is.GreaterThanOrEqualTo(a.Rank));
            }
            var (before, after) = (Travel(near, Vec3.Zero), Travel(tour, Vec3.Zero));
            if (after < before - 1) shorter++;
        }
        Assert.That(shorter, Is.GreaterThan(40));
    }

    [Test]
    public void Islands_of_which_paths_were_taken_out_are_still_sorted()
    {
        // Only the paths that followed others are left of the second and the third one.
        var steps = Enumerable.Range(0, 4)
            .Select(i => (Step)new PathStep(Loop(20 - 5 * i, 0, 2), new StepGroup(0, i)) { Joined = i is 1 or 2 }).ToArray();
        foreach (var rule in new[] { SortRule.Nearest, SortRule.Tour })
        {
            var order = StepOrder.Find(steps, new SortOptions(rule, Start: Vec3.Zero), null, default).Select(o => o.Source);
            Assert.That(order, Is.EqualTo(new[] { 3, 2, 1, 0 }));
        }
    }
}
