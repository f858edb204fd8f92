using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

/// <summary>What to lay down: vertices, beads and arcs of a path, steps and joined paths.</summary>
public class PrintPathTests
{
    private static readonly Bead[] Beads = [new(0.1), new(0.2), new(0.3), new(0.4)];
    private static readonly Vec3[] Square = [new(0, 0), new(2, 0), new(2, 3), new(0, 3)];

    [Test]
    public void Vertices_beads_and_arcs_must_fit_together()
    {
        Assert.That(() => new PrintPath([Vec3.Zero], Beads[0]), Throws.ArgumentException);
        Assert.That(() => new PrintPath([Vec3.Zero, Vec3.UnitX], Beads[0], closed: true), Throws.ArgumentException);
        Assert.That(() => new PrintPath([Vec3.Zero, new Vec3(double.NaN, 0)], Beads[0]), Throws.ArgumentException);
        Assert.That(() => new PrintPath(Square, Beads), Throws.ArgumentException.With.Message.Contains("3 segments needs 3 beads, not 4"));
        Assert.That(() => new PrintPath(Square, Beads.Take(1)), Throws.ArgumentException);
        Assert.That(() => new PrintPath(Square, Beads, true, [new Arc(Vec3.Zero, 90)]), Throws.ArgumentException.With.Message.Contains("4 segments"));
        Assert.That(() => new PrintPath(Square.Take(2), Beads.Take(1), false, [new Arc(Vec3.Zero, 90, ArcPlane.YZ)]), Throws.ArgumentException);
        Assert.That(new PrintPath(Square, Beads, true).SegmentCount, Is.EqualTo(4));
        Assert.That(new PrintPath(Square.Take(2), Beads.Take(1)).SegmentCount, Is.EqualTo(1));
        Assert.That(new PrintPath(Square.Take(2), Beads.Take(1), false, [null]).HasArcs, Is.False);
        Assert.That(new PrintPath(Square.Take(2), Beads.Take(2), true, [new Arc(Vec3.UnitX, 180), null]).HasArcs, Is.True,
            "two vertices and an arc enclose an area");
    }

    [Test]
    public void Lengths_volumes_and_boxes_are_those_of_the_segments()
    {
        // Along x, half a circle around (2, 1.5) to the right, and back along y = 3.
        var path = new PrintPath(Square, Beads, true, [null, new Arc(new Vec3(2, 1.5), 180), null, null]);
        Assert.That(path.Length, Is.EqualTo(2 + 1.5 * Math.PI + 2 + 3).Within(1e-12));
        Assert.That(path.Volume, Is.EqualTo(0.1 * 2 + 0.2 * 1.5 * Math.PI + 0.3 * 2 + 0.4 * 3).Within(1e-12));
        Assert.That(path.Bounds, Is.EqualTo(new Bounds(Vec3.Zero, new Vec3(3.5, 3, 0))));
        Assert.That((path.Start, path.End, path.EndOf(2), path.EndOf(3)), Is.EqualTo((Square[0], Square[0], Square[3], Square[0])));
        Assert.That(new PrintPath(Square, Beads[0]).End, Is.EqualTo(Square[3]));
    }

    [Test]
    public void A_reversed_path_runs_back_with_its_beads_and_arcs()
    {
        var arc = new Arc(new Vec3(2, 1.5), 180);
        var closed = new PrintPath(Square, Beads, true, [null, arc, null, null]) { Role = Role.Infill, Tool = 2, Name = "n", Color = 7 }.Reversed();
        Assert.That(closed.Points, Is.EqualTo(new[] { Square[0], Square[3], Square[2], Square[1] }));
        Assert.That(Enumerable.Range(0, 4).Select(closed.BeadOf), Is.EqualTo(Enumerable.Reverse(Beads)));
        Assert.That(closed.ArcOf(2), Is.EqualTo(arc.Reversed()));
        Assert.That((closed.Role, closed.Tool, closed.Name, closed.Color), Is.EqualTo((Role.Infill, 2, "n", (int?)7)));
        var open = new PrintPath(Square, Beads.Take(3)).Reversed();
        Assert.That(open.Points, Is.EqualTo(Enumerable.Reverse(Square)));
        Assert.That(Enumerable.Range(0, 3).Select(open.BeadOf), Is.EqualTo(Enumerable.Reverse(Beads.Take(3))));
    }

    [Test]
    public void A_closed_path_starts_at_any_vertex()
    {
        var arc = new Arc(new Vec3(2, 1.5), 180);
        var path = new PrintPath(Square, Beads, true, [null, arc, null, null]);
        Assert.That(path.StartingAt(0), Is.SameAs(path));
        var turned = path.StartingAt(3);
        Assert.That(turned.Points, Is.EqualTo(new[] { Square[3], Square[0], Square[1], Square[2] }));
        Assert.That(Enumerable.Range(0, 4).Select(turned.BeadOf), Is.EqualTo(new[] { Beads[3], Beads[0], Beads[1], Beads[2] }));
        Assert.That((turned.ArcOf(1), turned.ArcOf(2)), Is.EqualTo(((Arc?)null, (Arc?)arc)));
        Assert.That(new PrintPath(Square, Beads[0], true).StartingAt(2).OnlyBead, Is.EqualTo(Beads[0]));
        Assert.That(() => new PrintPath(Square, Beads[0]).StartingAt(1), Throws.InvalidOperationException);
    }

    [Test]
    public void What_is_not_given_stays()
    {
        var layer = new Layer(1, 2);
        var path = new PrintPath(Square, Beads[0]) { Role = Role.Brim, Layer = layer, Tool = 3, Name = "a", Color = 5, Overrides = new(200) };
        var other = path with { Name = "b" };
        Assert.That((other.Role, other.Layer, other.Tool, other.Name, other.Color, other.Overrides),
            Is.EqualTo((Role.Brim, layer, 3, "b", (int?)5, new PathOverrides(200))));
        Assert.That(path with { Role = Role.Raft, Layer = new Layer(2, 3), Tool = 4, Overrides = new PathOverrides(210), Color = null },
            Has.Property("Role").EqualTo(Role.Raft).And.Property("Tool").EqualTo(4).And.Property("Name").EqualTo("a").And.Property("Color").Null);
        Assert.That(path.WithBeads(i => Beads[i]).BeadOf(2), Is.EqualTo(Beads[2]));
    }

    [TestCase(0.01, 1)]
    [TestCase(0.011, 2)]
    public void Ends_are_joined_within_the_tolerance(double gap, int paths)
        => Assert.That(PathMerging.Merge([Line(0, 1), Line(1 + gap - (gap > 0.0105 ? 0 : 1e-9), 2)], 0.01), Has.Count.EqualTo(paths));

    [TestCase(0, 1, 1, 2, "0 1 2")]
    [TestCase(0, 1, 2, 1, "0 1 2")]
    [TestCase(1, 0, 1, 2, "0 1 2")]
    [TestCase(1, 0, 2, 1, "0 1 2")]
    public void Paths_that_touch_at_any_end_are_joined_when_they_may_be_reversed(double a, double b, double c, double d, string x)
        => Assert.That(string.Join(" ", PathMerging.Merge([Line(a, b), Line(c, d)], reverse: true).Single().Points.Select(p => (int)p.X)), Is.EqualTo(x));

    [Test]
    public void Only_the_first_path_of_a_chain_is_turned_around()
    {
        Assert.That(PathMerging.Merge([Line(1, 2), Line(2, 3), Line(0, 1)], reverse: true), Has.Count.EqualTo(2));
        Assert.That(PathMerging.Merge([Line(0, 1), Line(1, 2), Line(1, 5)], reverse: true), Has.Count.EqualTo(2), "the second has its place");
        var named = Line(1, 2) with { Name = "x", Overrides = new PathOverrides(200) };
        Assert.That(PathMerging.Merge([Line(0, 1), named]), Has.Count.EqualTo(2));
        Assert.That(PathMerging.Merge([Line(0, 1) with { Layer = new Layer(1, 1) }, Line(1, 2) with { Layer = new Layer(2, 1) }]), Has.Count.EqualTo(2));
        // There and back is no loop; three segments are.
        Assert.That(PathMerging.Merge([Line(0, 1), Line(1, 0)]).Single().IsClosed, Is.False);
        PrintPath Corner(params Vec3[] points) => new(points, Beads[0]);
        Assert.That(PathMerging.Merge([Corner(new(0, 0), new(1, 0), new(1, 1)), Corner(new(1, 1), new(0, 0.009))]).Single().Points, Has.Count.EqualTo(3));
        Assert.That(PathMerging.Merge([Corner(new(0, 0), new(1, 0), new(1, 1)), Corner(new(1, 1), new(0, 0.011))]).Single().IsClosed, Is.False);
        Assert.That(() => PathMerging.Merge([Line(0, 1)], -1), Throws.ArgumentException);
        Assert.That(() => PathMerging.Merge([null!]), Throws.ArgumentException);
    }

    [Test]
    public void A_step_keeps_what_belongs_to_it_with_another_path()
    {
        var path = new PrintPath(Square, Beads[0]);
        var step = new PathStep(path, new StepGroup(1, 2, 3)) { KeepStart = true, Joined = true, Source = new SourceLocation("f"), Lines = [1, 2, 3] };
        var same = step with { Path = path.Reversed() };
        Assert.That((same.Group, same.KeepStart, same.Joined, same.Source, same.Lines), Is.EqualTo((step.Group, true, true, step.Source, step.Lines)));
        Assert.That((step with { Path = new PrintPath(Square.Take(3), Beads[0]) }).Lines, Is.Null, "lines are those of its segments");
        Assert.That(() => new TravelStep([]), Throws.ArgumentException);
        Assert.That(() => new TravelStep(new Vec3(double.NaN, 0)), Throws.ArgumentException);
        Assert.That(() => new TravelStep([Vec3.Zero, new Vec3(double.NaN, 0)]), Throws.ArgumentException);
    }

    // 10 mm at 10 mm/s and 30 mm at 30 mm/s take 2 s.
    [TestCase(1.9, 1, 10, 30, true)]
    [TestCase(2, 1, 10, 30, true)]
    [TestCase(4, 1, 5, 15, true)]
    [TestCase(4, 8, 8, 30 / 2.75, true)]
    [TestCase(5, 8, 8, 8, true)]
    [TestCase(5.01, 8, 8, 8, false)]
    [TestCase(4, 12, 10, 12, false)]
    public void Speeds_drop_by_one_factor_but_not_below_the_least(double wanted, double least, double first, double second, bool reached)
    {
        PrintPath[] paths = [Line(0, 10), Line(0, 30)];
        double SpeedOf(PrintPath path, int segment) => path.BeadOf(segment).Speed > 0 ? path.BeadOf(segment).Speed : path.Length;
        var slowed = SlowDown.To(paths, SpeedOf, wanted, least, out var enough);
        Assert.That((SpeedOf(slowed[0], 0), SpeedOf(slowed[1], 0)), Is.EqualTo((first, second)).Within(1e-9));
        Assert.That(enough, Is.EqualTo(reached));
        Assert.That(slowed[0].BeadOf(0).Area, Is.EqualTo(0.1));
        Assert.That(SlowDown.To([], SpeedOf, wanted, least, out enough), Is.Empty);
        Assert.That(enough, Is.True);
    }

    private static PrintPath Line(double from, double to) => new([new Vec3(from, 0), new Vec3(to, 0)], Beads[0]);
}
