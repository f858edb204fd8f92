using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

public class CollisionFreeOrderTests
{
    private static readonly PrintSetup Setup = SmallPrint.Setup();

    [Test]
    public void Layers_in_any_order_are_printed_from_below()
    {
        var random = new Random(4);
        var paths = Enumerable.Range(1, 12).Select(k => Line(50, 50, 70, 50, 0.2 * k)).OrderBy(_ => random.Next()).ToArray();
        var found = CollisionFreeOrder.Find(paths, Setup).OrThrow();
        Assert.That(found.OfType<PathStep>().Select(s => s.Path.Start.Z), Is.Ordered.And.Exactly(12).Items);
        Free(found);
    }

    [Test]
    public void Paths_that_are_free_keep_their_order_and_are_joined_over_the_top()
    {
        var paths = new[] { Line(100, 50, 120, 50, 3), Line(50, 50, 70, 50, 3), Line(150, 50, 170, 50, 3) };
        var found = CollisionFreeOrder.Find(paths, Setup).OrThrow();
        Assert.That(found.OfType<PathStep>().Select(s => s.Path), Is.EqualTo(paths));
        Assert.That(found.OfType<TravelStep>().Last().Points, Is.EqualTo(new[] { new Vec3(70, 50, 4), new Vec3(150, 50, 4), new Vec3(150, 50, 3) }));
        Free(found);
    }

    [Test]
    public void Random_paths_in_space_have_an_order_that_passes_the_checks_or_a_pair_that_blocks()
    {
        var random = new Random(7);
        var (orders, blocked) = (0, 0);
        for (var n = 0; n < 60; n++)
        {
            var paths = Enumerable.Range(0, 6).Select(_ => new PrintPath([Point(random), Point(random)], new Bead(0.08, 0.2))).ToArray();
            var found = CollisionFreeOrder.Find(paths, Setup);
            if (found.Value is { } steps)
            {
                orders++;
                Free(steps);
                continue;
            }
            blocked++;
            Assert.That(found.Diagnostics.Select(d => d.Code), Is.All.EqualTo(CollisionFreeOrder.Blocked).Or.EqualTo(CollisionFreeOrder.BlocksItself));
            Assert.That(found.Diagnostics.Select(d => d.Source!.Step), Is.All.InRange(0, 5));
        }
        Assert.That((orders, blocked), Is.GreaterThan((5, 0)));
    }

    [Test]
    public void Two_that_block_each_other_are_named()
    {
        // Two steep hooks, each under the top of the other.
        var a = new PrintPath([new Vec3(50, 50, 1), new Vec3(60, 50, 12)], new Bead(0.08, 0.2)) { Name = "left" };
        var b = new PrintPath([new Vec3(60, 50.3, 1), new Vec3(50, 50.3, 12)], new Bead(0.08, 0.2)) { Name = "right" };
        var found = CollisionFreeOrder.Find([a, b], Setup);
        Assert.That(found.Value, Is.Null);
        var problem = found.Diagnostics.Single();
        Assert.That((problem.Code, problem.Severity, problem.Source!.Step), Is.EqualTo((CollisionFreeOrder.Blocked, Severity.Error, 1)));
        Assert.That(problem.Message, Does.StartWith("Paths 0 (left) and 1 (right) block each other"));
    }

    [Test]
    public void A_path_down_its_own_side_is_reversed_or_named()
    {
        // Up a steep line is free; down it would not be past the first millimeters.
        var down = new PrintPath([new Vec3(52, 50, 15), new Vec3(50, 50, 1)], new Bead(0.08, 0.2));
        Assert.That(CollisionFreeOrder.Find([down], Setup).OrThrow().OfType<PathStep>().Single().Path.Start.Z, Is.EqualTo(1));
        var both = new PrintPath([new Vec3(52, 50, 15), new Vec3(50, 50, 1), new Vec3(48, 50, 15)], new Bead(0.08, 0.2));
        Assert.That(CollisionFreeOrder.Find([both], Setup).Diagnostics.Single().Code, Is.EqualTo(CollisionFreeOrder.BlocksItself));
        Assert.That(CollisionFreeOrder.Find([], Setup).OrThrow(), Is.Empty);
    }

    private static Vec3 Point(Random random) => new(100 + 12 * random.NextDouble(), 100 + 12 * random.NextDouble(), 0.2 + 5 * random.NextDouble());

    private static PrintPath Line(double x0, double y0, double x1, double y1, double z)
        => new([new Vec3(x0, y0, z), new Vec3(x1, y1, z)], new Bead(0.08, 0.2));

    private static void Free(IReadOnlyList<Step> steps)
    {
        var plan = Planner.Plan(steps, Setup, new PlanOptions { Policy = PlanPolicy.AsDrawn }).OrThrow();
        Assert.That(PrintCheck.Run(plan, Setup).Where(d => d.Code.StartsWith("collision.", StringComparison.Ordinal)), Is.Empty);
    }
}
