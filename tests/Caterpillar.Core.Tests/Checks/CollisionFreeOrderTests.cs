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
            Assert.That(found.Diagnostics, Is.Not.Empty);
        }
        Assert.That((orders, blocked), Is.GreaterThan((5, 0)));
    }

    // Every order of up to six paths, each in the direction in which it was found or given, checked as a whole.
    [Test]
    public void An_order_is_found_where_brute_force_finds_one()
    {
        var random = new Random(11);
        var (free, blocked) = (0, 0);
        for (var n = 0; n < 24; n++)
        {
            var paths = Enumerable.Range(0, 2 + n % 3 + (n % 8 == 0 ? 2 : 0))
                .Select(_ => new PrintPath([Point(random), Point(random)], new Bead(0.08, 0.2))).ToArray();
            var top = paths.Max(p => p.Bounds.Max.Z) + Math.Max(Setup.Printer.LiftClearance, 1);
            var trial = new OrderTrial(Setup, top);
            var turned = paths.Select(p => trial.Collides(p) ? p.Reversed() : p).ToArray();
            var exists = Orders(turned.Length).Any(o => IsFree(trial.Steps(o.Select(i => turned[i]))));
            var found = CollisionFreeOrder.Find(paths, Setup);
            Assert.That(found.Value is not null, Is.EqualTo(exists), $"case {n}: {string.Join("; ", found.Diagnostics)}");
            if (exists) free++;
            else blocked++;
        }
        Assert.That((free, blocked), Is.GreaterThan((3, 0)));
        Assert.That(blocked, Is.Positive);
    }

    [Test]
    public void Progress_rises_to_1_and_a_cancel_is_heard()
    {
        var paths = Enumerable.Range(1, 6).Select(k => Line(20 * k, 50, 20 * k + 10, 50, 3)).ToArray();
        var seen = new Progress();
        CollisionFreeOrder.Find(paths, Setup, seen);
        Assert.That(seen.All, Is.EqualTo(new[] { 0, 1 / 6.0, 2 / 6.0, 3 / 6.0, 4 / 6.0, 5 / 6.0, 1 }));
        using var cancel = new System.Threading.CancellationTokenSource();
        cancel.Cancel();
        Assert.That(() => CollisionFreeOrder.Find(paths, Setup, null, cancel.Token), Throws.InstanceOf<OperationCanceledException>());
        Assert.That(() => CollisionFreeOrder.Find(null!, Setup), Throws.ArgumentNullException);
        Assert.That(() => CollisionFreeOrder.Find(paths, null!), Throws.ArgumentNullException);
        Assert.That(() => CollisionFreeOrder.Find([null!], Setup), Throws.InstanceOf<Exception>());
    }

    // The head is 20 mm wide at each side, 12 mm above the tip.
    [TestCase(15, true)]
    [TestCase(25, false)]
    public void The_whole_head_decides_which_is_first(double aside, bool turned)
    {
        var paths = new[] { Line(50, 50, 70, 50, 30), Line(50, 50 + aside, 70, 50 + aside, 3) };
        var found = CollisionFreeOrder.Find(paths, Setup).OrThrow().OfType<PathStep>().Select(s => s.Path.Start.Z);
        Assert.That(found, Is.EqualTo(turned ? new[] { 3.0, 30 } : new[] { 30.0, 3 }));
    }

    // Paths that rise from 1 to 9 mm; the head is 20 mm wide at each side.
    [TestCase(130, 0)]
    [TestCase(0, 130)]
    [TestCase(-30, 0)]
    [TestCase(0, -30)]
    public void Paths_that_are_far_from_each_other_keep_their_order(double x, double y)
    {
        PrintPath Rising(double dx, double dy) => new([new Vec3(60 + dx, 60 + dy, 1), new Vec3(70 + dx, 60 + dy, 9)], new Bead(0.08, 0.2));
        var paths = new[] { Rising(0, 0), Rising(x, y) };
        Assert.That(CollisionFreeOrder.Find(paths, Setup).OrThrow().OfType<PathStep>().Select(s => s.Path), Is.EqualTo(paths));
    }

    // A box that reaches 60 mm to one side, 2 mm above the tip: what is high there comes later.
    [TestCase(50, 0, true)]
    [TestCase(70, 0, false)]
    [TestCase(-50, 0, false)]
    [TestCase(0, 50, false)]
    public void A_long_box_of_the_head_decides_which_is_first(double x, double y, bool turned)
    {
        var setup = SmallPrint.Setup(p => p with
        {
            HeadOutline = new(new HeadPoint(0.5, 0)), HeadBoxes = new(new Bounds(new Vec3(-5, -5, 2), new Vec3(60, 5, 20))),
        });
        var paths = new[] { Line(80 + x, 80 + y, 82 + x, 80 + y, 10), Line(80, 80, 82, 80, 1) };
        var found = CollisionFreeOrder.Find(paths, setup).OrThrow().OfType<PathStep>().Select(s => s.Path.Start.Z);
        Assert.That(found, Is.EqualTo(turned ? new[] { 1.0, 10 } : new[] { 10.0, 1 }));
        // The same along Y, by a gantry over the whole bed.
        var gantry = SmallPrint.Setup(p => p with
        {
            HeadOutline = new(new HeadPoint(0.5, 0)), Gantry = new(new Bounds(new Vec3(0, -5, 2), new Vec3(0, 60, 20))),
        });
        var beam = new[] { Line(180, 80 + x, 182, 80 + x, 10), Line(20, 80, 22, 80, 1) };
        if (y == 0) Assert.That(CollisionFreeOrder.Find(beam, gantry).OrThrow().OfType<PathStep>().First().Path.Start.Z, Is.EqualTo(turned ? 1 : 10));
    }

    [Test]
    public void Paths_that_each_come_before_the_next_in_a_circle_are_named()
    {
        // Three lines, each of which passes over the end of the next.
        var paths = new[] { (0, 120), (120, 240), (240, 360) }.Select(t =>
        {
            var (s0, c0) = Angle.SinCos(t.Item1 - 15);
            var (s1, c1) = Angle.SinCos(t.Item2 + 15);
            return new PrintPath([new Vec3(100 + 8 * c0, 100 + 8 * s0, 1), new Vec3(100 + 8 * c1, 100 + 8 * s1, 7)], new Bead(0.08, 0.2));
        }).ToArray();
        var problem = CollisionFreeOrder.Find(paths, Setup).Diagnostics;
        Assert.That(problem.Select(d => d.Code), Is.All.EqualTo(CollisionFreeOrder.Blocked).And.Not.Empty);
        Assert.That(problem.Select(d => d.Message), Is.EqualTo(new[] { "Each of these paths must be printed before another of them: 0, 1, 2." }));
        Assert.That(problem.Single().Source!.Step, Is.Zero);
    }

    // 2 mm² in 1 mm are 2.2 mm wide and the tip is 1 mm wide: they touch up to 1.6 mm aside.
    [TestCase(1.4, true)]
    [TestCase(2.2, false)]
    public void Strands_are_as_wide_as_their_material(double aside, bool turned)
    {
        var setup = SmallPrint.Setup(p => p with { HeadOutline = new(new HeadPoint(0.5, 0)) });
        PrintPath Wide(double y, double z, double area) => new([new Vec3(50, y, z), new Vec3(70, y, z)], new Bead(area, z));
        var paths = new[] { Wide(50, 1, 2), Wide(50 + aside, 0.2, 0.08) };
        var found = CollisionFreeOrder.Find(paths, setup).OrThrow().OfType<PathStep>().Select(s => s.Path.Start.Z);
        Assert.That(found, Is.EqualTo(turned ? new[] { 0.2, 1 } : new[] { 1, 0.2 }));
    }

    // Travels are 1 mm above all paths and above the object that is printed on.
    [TestCase(0, 1.2)]
    [TestCase(12, 13)]
    public void Travels_are_above_everything(double onto, double height)
    {
        var plate = TriMesh.Create([new(150, 150, onto), new(160, 150, onto), new(160, 160, onto)], [0, 1, 2]);
        var setup = onto > 0 ? Setup with { PrintedOn = plate } : Setup;
        var steps = CollisionFreeOrder.Find([Line(50, 50, 70, 50, 0.2)], setup).OrThrow();
        Assert.That(((TravelStep)steps[0]).Points, Is.EqualTo(new[] { new Vec3(50, 50, height), new Vec3(50, 50, 0.2) }));
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
        var blocked = CollisionFreeOrder.Find([both], Setup).Diagnostics.Single();
        Assert.That((blocked.Code, blocked.Source!.Step), Is.EqualTo((CollisionFreeOrder.BlocksItself, (int?)0)));
        Assert.That(blocked.Message, Does.StartWith("Path 0 cannot be printed in either direction"));
        Assert.That(CollisionFreeOrder.Find([], Setup).OrThrow(), Is.Empty);
        // What blocks itself seems to block all others.
        var named = CollisionFreeOrder.Find([new PrintPath(both.Points, new Bead(0.08, 0.2)) { Name = "V" }, Line(50, 50, 54, 50, 2)], Setup).Diagnostics;
        Assert.That(named.Single().Message, Does.StartWith("Path 0 (V) cannot be printed in either direction"));
    }

    private static Vec3 Point(Random random) => new(100 + 12 * random.NextDouble(), 100 + 12 * random.NextDouble(), 0.2 + 5 * random.NextDouble());

    private static PrintPath Line(double x0, double y0, double x1, double y1, double z)
        => new([new Vec3(x0, y0, z), new Vec3(x1, y1, z)], new Bead(0.08, 0.2));

    private static void Free(IReadOnlyList<Step> steps) => Assert.That(Collisions(steps), Is.Empty);

    private static bool IsFree(IReadOnlyList<Step> steps) => !Collisions(steps).Any();

    private static IEnumerable<Diagnostic> Collisions(IReadOnlyList<Step> steps)
    {
        var plan = Planner.Plan(steps, Setup, new PlanOptions { Policy = PlanPolicy.AsDrawn }).OrThrow();
        return PrintCheck.Run(plan, Setup).Where(d => d.Code.StartsWith("collision.", StringComparison.Ordinal));
    }

    private static IEnumerable<int[]> Orders(int count)
        => count == 0 ? [[]] : Orders(count - 1)
            .SelectMany(o => Enumerable.Range(0, count).Select(at => o.Take(at).Append(count - 1).Concat(o.Skip(at)).ToArray()));

    private sealed class Progress : IProgress<double>
    {
        public List<double> All { get; } = [];

        public void Report(double value) => All.Add(value);
    }
}
