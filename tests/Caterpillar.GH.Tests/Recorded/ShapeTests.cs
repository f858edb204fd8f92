using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.GH.Conversion;
using Caterpillar.GH.Preview;
using Caterpillar.Machines;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Recorded;

/// <summary>What is drawn of a head, of prints that are not finished, and of lines that come back.</summary>
public sealed class ShapeTests
{
    private static readonly Bounds Box = new(new Vec3(-10, -5, 20), new Vec3(10, 5, 30));

    private static HeadOutline Head() => new(new Printer { HeadOutline = new([new(1, 0), new(5, 10)]), HeadBoxes = new([Box]) }, DocumentUnits.Current);

    [Test]
    public void A_head_is_drawn_with_rings_the_edges_of_its_boxes_and_a_triangle()
    {
        var lines = Head().At(Frame.World, Frame.World);
        Assert.That(lines, Has.Length.EqualTo(2 * 24 + 4 + 12 + 3));
        bool OnRing(Rg.Point3d p, double radius, double z) => System.Math.Abs(p.Z - z) + System.Math.Abs(p.DistanceTo(new Rg.Point3d(0, 0, z)) - radius) < 1e-9;
        Assert.That(lines.Count(l => OnRing(l.From, 1, 0) && OnRing(l.To, 1, 0)), Is.EqualTo(24));
        Assert.That(lines.Count(l => OnRing(l.From, 5, 10) && OnRing(l.To, 5, 10)), Is.EqualTo(24));
        Assert.That(lines.Count(l => OnRing(l.From, 1, 0) && OnRing(l.To, 5, 10)), Is.EqualTo(4));
        var edges = lines.Where(l => l.From.Z >= 20 && l.To.Z >= 20).ToArray();
        Assert.That(edges.Select(e => e.Length).OrderBy(l => l), Is.EqualTo(new[] { 10.0, 10, 10, 10, 10, 10, 10, 10, 20, 20, 20, 20 }).Within(1e-9));
        var ends = edges.SelectMany(e => new[] { e.From, e.To }).GroupBy(p => p.ToString());
        Assert.That(ends.Select(g => g.Count()), Is.EqualTo(Enumerable.Repeat(3, 8)), "Three edges meet in each of eight corners.");
        var triangle = lines.Skip(lines.Length - 3).ToArray();
        for (var i = 0; i < 3; i++) Assert.That(triangle[i].To.DistanceTo(triangle[(i + 1) % 3].From), Is.Zero);
        Assert.That(triangle.Max(l => l.From.X), Is.EqualTo(5), "2.5 times as long as half its width.");
    }

    [Test]
    public void It_moves_with_the_machine_and_has_a_profile_and_a_mesh()
    {
        var frame = Frame.World.WithOrigin(new Vec3(100, 50, 7));
        var lines = Head().At(frame, Frame.World);
        Assert.That(lines.Take(64).SelectMany(l => new[] { l.From, l.To }).Min(p => p.Z), Is.EqualTo(7));
        Assert.That(lines.Take(64).SelectMany(l => new[] { l.From, l.To }).Max(p => p.X), Is.EqualTo(110));
        var profile = Head().ProfileAt(frame)!.GetBoundingBox(true);
        Assert.That((profile.Min.X, profile.Max.X, profile.Min.Y, profile.Max.Y, profile.Max.Z), Is.EqualTo((95.0, 105.0, 50.0, 50.0, 17.0)));
        var mesh = Head().MeshAt(frame)!.GetBoundingBox(true);
        Assert.That((mesh.Min.X, mesh.Max.Z), Is.EqualTo((90.0, 37.0)));
    }

    [Test]
    public void Rings_close_and_the_profile_runs_up_one_side_and_down_the_other()
    {
        var lines = Head().At(Frame.World, Frame.World);
        // Each ring is walked in steps of 15 degrees, from X on: its last line ends where its first one begins.
        var ring = lines.Where(l => l.From.Z == 0 && l.To.Z == 0).Take(24).ToArray();
        for (var k = 0; k < 24; k++)
        {
            Assert.That(ring[k].To.DistanceTo(ring[(k + 1) % 24].From), Is.LessThan(1e-12));
            Assert.That(ring[k].Length, Is.EqualTo(2 * System.Math.Sin(System.Math.PI / 24)).Within(1e-9));
        }
        Assert.That(ring[0].From, Is.EqualTo(new Rg.Point3d(1, 0, 0)));
        Assert.That(ring[0].To.Y, Is.GreaterThan(0));
        var profile = (Rg.PolylineCurve)Head().ProfileAt(Frame.World)!;
        Assert.That(Enumerable.Range(0, profile.PointCount).Select(i => (profile.Point(i).X, profile.Point(i).Z)),
            Is.EqualTo(new[] { (0.0, 0.0), (1, 0), (5, 10), (-5, 10), (-1, 0), (0, 0) }));
    }

    private static PrintedLines Lines(int count)
        => new(count, (i, lines) =>
        {
            if (i % 2 == 0) lines.Add(new Rg.Line(new Rg.Point3d(i, 0, 0), new Rg.Point3d(i + 2, 0, 0)));
        });

    [TestCase(0, 0, 0, 0)]
    [TestCase(0, 0.5, 0, 1)]
    [TestCase(1, 0.5, 0, 2)]
    [TestCase(2, 0.25, 0, 2.5)]
    [TestCase(2048, 0, 1, 2048)]
    [TestCase(2050, 0.5, 1, 2051)]
    [TestCase(5000, 0, 2, 5000)]
    [TestCase(9999, 1, 2, 5000)]
    public void A_print_is_shown_until_a_part_of_a_move(int move, double done, int blocks, double x)
    {
        var printed = Lines(5000);
        printed.ShowUntil(move, done);
        Assert.That((printed.Count, printed.Blocks, printed.End.Length), Is.EqualTo((2500, blocks, 1024)));
        Assert.That(printed.End[1023].To.X, Is.EqualTo(x));
        Assert.That(printed.End.Where(l => l.Length > 0).Sum(l => l.Length), Is.EqualTo(x - blocks * 2048).Within(1e-9));
        Assert.That((printed.Box.Min.X, printed.Box.Max.X), Is.EqualTo((0.0, 5000.0)));
    }

    [Test]
    public void Nothing_printed_is_nothing_shown()
    {
        var none = new PrintedLines(3, (_, _) => { });
        none.ShowUntil(3, 1);
        Assert.That((none.Count, none.Blocks, none.End.All(l => l.Length == 0)), Is.EqualTo((0, 0, true)));
    }

    [TestCase(null, null, int.MinValue, true)]
    [TestCase(null, null, 7, true)]
    [TestCase(2, 4, 1, false)]
    [TestCase(2, 4, 2, true)]
    [TestCase(2, 4, 4, true)]
    [TestCase(2, 4, 5, false)]
    [TestCase(2, null, 99, true)]
    [TestCase(2, null, int.MinValue, false)]
    [TestCase(null, 4, int.MinValue, false)]
    [TestCase(null, 4, -3, true)]
    public void Layers_are_shown_between_their_limits(int? first, int? last, int layer, bool isShown)
        => Assert.That(new ShownLayers(first, last).Has(layer), Is.EqualTo(isShown));

    [Test]
    public void Polylines_have_no_points_twice_and_one_more_there_and_back()
    {
        static Rg.Point3d P(double x, double y = 0) => new(x, y, 0);
        static double[] X(Rg.PolylineCurve? curve) => Enumerable.Range(0, curve!.PointCount).Select(i => curve.Point(i).X).ToArray();
        Assert.That(X(PolylineMaker.Of(new List<Rg.Point3d> { P(0), P(0), P(4), P(4), P(6, 1) })), Is.EqualTo(new[] { 0.0, 4, 6 }));
        Assert.That(X(PolylineMaker.Of(new List<Rg.Point3d> { P(0), P(4), P(0) })), Is.EqualTo(new[] { 0.0, 4, 2, 0 }));
        Assert.That(PolylineMaker.Of(new List<Rg.Point3d> { P(3), P(3) }), Is.Null);
        Assert.That(X(PolylineMaker.Of([new Rg.Line(P(0), P(1)), new Rg.Line(P(1), P(5))])), Is.EqualTo(new[] { 0.0, 1, 5 }));
        Assert.That(PolylineMaker.Of(new List<Rg.Line>()), Is.Null);
    }

    [Test]
    public void The_turtle_is_a_triangle_with_its_sharp_corner_forward()
    {
        var outline = TurtleShape.Outline(Frame.World, 2, DocumentUnits.Current);
        Assert.That((outline.PointCount, outline.Point(0).DistanceTo(outline.Point(3))), Is.EqualTo((4, 0.0)));
        var face = TurtleShape.Face(Frame.World, 2, DocumentUnits.Current);
        Assert.That((face.Vertices.Count, face.Faces.Count, face.GetBoundingBox(true).Max.X), Is.EqualTo((3, 1, 5.0)));
    }
}
