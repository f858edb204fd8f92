using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

/// <summary>Corners, supported places and scarfs of loops, worked out by hand.</summary>
public class SeamPartTests
{
    // 40 mm around.
    private static readonly Vec3[] Square = [new(0, 0, 1), new(10, 0, 1), new(10, 10, 1), new(0, 10, 1)];

    // Nothing below 25 degrees, everything from 90 on; convex corners count half.
    [TestCase(24, 0)]
    [TestCase(26, 1 / 65.0)]
    [TestCase(57.5, 0.5)]
    [TestCase(90, 1)]
    [TestCase(120, 1)]
    public void A_corner_hides_a_seam_by_its_angle(double turn, double score)
    {
        var (sin, cos) = Angle.SinCos(turn);
        Vec3[] loop = [new(-10, 0), Vec3.Zero, new(10 * cos, -10 * sin), new(-10, -20)];
        Assert.That(LoopCorner.Score(loop, 1, 0.9), Is.EqualTo(score).Within(1e-12));
        var mirrored = Array.ConvertAll(loop, p => new Vec3(p.X, -p.Y));
        Assert.That(LoopCorner.Score(mirrored, 1, 0.9), Is.EqualTo(score / 2).Within(1e-12));
        // Many short segments beside the corner are seen as one.
        Vec3[] fine = [new(-10, 0), new(-0.5, 0), new(-0.2, 0), Vec3.Zero, new(0.3 * cos, -0.3 * sin), new(10 * cos, -10 * sin), new(-10, -20)];
        Assert.That(LoopCorner.Score(fine, 3, 0.9), Is.EqualTo(score).Within(1e-12));
    }

    [TestCase(0.019, 4, 0)]
    [TestCase(0.021, 5, 0.021)]
    [TestCase(9.979, 5, 9.979)]
    [TestCase(9.981, 4, 10)]
    public void A_seam_close_to_a_vertex_lies_at_it(double x, int points, double start)
    {
        var loop = new PrintPath(Square, Enumerable.Range(0, 4).Select(i => new Bead(0.1 + i)), closed: true);
        var begun = LoopPlace.AtLength(Square, x).Start(loop);
        Assert.That((begun.Points.Count, begun.Start.X, begun.Start.Y), Is.EqualTo((points, start, 0.0)).Within(1e-12));
        Assert.That(begun.Volume, Is.EqualTo(loop.Volume).Within(1e-12));
        var last = LoopPlace.AtLength(Square, 35).Start(loop);
        Assert.That(last.Points, Is.EqualTo(new[] { new Vec3(0, 5, 1), Square[0], Square[1], Square[2], Square[3] }));
        Assert.That(Enumerable.Range(0, 5).Select(i => last.BeadOf(i).Area), Is.EqualTo(new[] { 3.1, 0.1, 1.1, 2.1, 3.1 }));
    }

    // Supported from 4 to 14 and from 24 to 34 mm: a seam keeps a millimeter from the air.
    [TestCase(8, 8)]
    [TestCase(5.1, 5.1)]
    [TestCase(4.5, 5)]
    [TestCase(2, 5)]
    [TestCase(0.5, 5)]
    [TestCase(38.9, 33)]
    [TestCase(13.5, 13)]
    [TestCase(18.9, 13)]
    [TestCase(19.1, 25)]
    [TestCase(33.5, 33)]
    [TestCase(39.5, 5)]
    public void A_seam_over_air_moves_to_the_nearest_supported_place(double wanted, double at)
    {
        var below = Region.Union([Region.Rectangle(4, -1, 11, 4), Region.Rectangle(-1, 6, 6, 11)]);
        var support = LoopSupport.Of(Square, new LineClipper(below.Index, outside: true))!;
        var place = support.Near(Square, LoopPlace.AtLength(Square, wanted));
        Assert.That(place.Point.DistanceTo(LoopPlace.AtLength(Square, at).Point), Is.LessThan(1e-3));
    }

    [Test]
    public void Places_narrower_than_two_margins_are_used_in_their_middle_only_where_there_is_no_wider_one()
    {
        // Supported from 4 to 5 alone: its middle.
        var narrow = Region.Rectangle(4, -1, 5, 1);
        var support = LoopSupport.Of(Square, new LineClipper(narrow.Index, outside: true))!;
        Assert.That(support.Near(Square, LoopPlace.AtLength(Square, 20)).Point.X, Is.EqualTo(4.5).Within(1e-3));
        // The wider place is farther off and yet taken.
        var both = Region.Union([narrow, Region.Rectangle(-1, 6, 6, 11)]);
        support = LoopSupport.Of(Square, new LineClipper(both.Index, outside: true))!;
        Assert.That(support.Near(Square, LoopPlace.AtLength(Square, 6)).Point.DistanceTo(new Vec3(0, 7, 1)), Is.LessThan(1e-3));
        Assert.That(LoopSupport.Of(Square, new LineClipper(Region.Rectangle(-1, -1, 11, 11).Index, outside: true)), Is.Null, "all is supported");
        var nothing = LoopSupport.Of(Square, new LineClipper(Region.Rectangle(50, 50, 51, 51).Index, outside: true))!;
        Assert.That((nothing.IsNowhere, nothing.Share), Is.EqualTo((true, 0.0)), "nothing is");
        Assert.That(nothing.Near(Square, LoopPlace.AtLength(Square, 6)), Is.EqualTo(LoopPlace.AtLength(Square, 6)));
        Assert.That((support.IsNowhere, support.Share), Is.EqualTo((false, (10 + 1) / 40.0)));
    }

    [Test]
    public void A_scarf_rises_in_steps_from_a_tenth_of_the_layer_and_is_covered_at_the_end()
    {
        var settings = new PrintSettings { ScarfSeamLength = 4, ScarfSeamSteps = 4 };
        var loop = new PrintPath(Square, new Bead(0.1, 0.2, 30), closed: true);
        var scarf = ScarfSeam.Apply(loop, 0.2, settings);
        Assert.That(scarf.IsClosed, Is.False);
        // z = 1 - 0.2 (1 - share): shares of 0.1, 0.325, 0.55, 0.775 and 1.
        Assert.That(scarf.Points.Take(5).Select(p => p.Z), Is.EqualTo(new[] { 0.82, 0.865, 0.91, 0.955, 1 }).Within(1e-12));
        Assert.That(scarf.Points.Take(5).Select(p => p.X), Is.EqualTo(new[] { 0.0, 1, 2, 3, 4 }).Within(1e-12));
        var shares = new[] { 0.2125, 0.4375, 0.6625, 0.8875 };
        Assert.That(Enumerable.Range(0, 4).Select(i => scarf.BeadOf(i).Area), Is.EqualTo(shares.Select(s => 0.1 * s)).Within(1e-12));
        Assert.That(Enumerable.Range(0, 4).Select(i => scarf.BeadOf(i).Height), Is.EqualTo(shares.Select(s => 0.2 * s)).Within(1e-12));
        Assert.That(scarf.BeadOf(0).Speed, Is.EqualTo(30));
        // The rest of the first side, three sides, and the same steps once more on top.
        Assert.That(scarf.Points.Skip(5).Select(p => (p.X, p.Y, p.Z)), Is.EqualTo(new[]
        {
            (10.0, 0.0, 1.0), (10, 10, 1), (0, 10, 1), (0, 0, 1), (1, 0, 1), (2, 0, 1), (3, 0, 1), (4, 0, 1),
        }));
        Assert.That(Enumerable.Range(8, 4).Select(i => scarf.BeadOf(i).Area), Is.EqualTo(shares.Select(s => 0.1 * (1 - s))).Within(1e-12));
        Assert.That(scarf.BeadOf(4), Is.EqualTo(new Bead(0.1, 0.2, 30)));
    }

    [TestCase(0.0, false)]
    [TestCase(20.0, true)]
    [TestCase(20.1, false)]
    public void A_scarf_needs_a_loop_twice_as_long(double length, bool applied)
    {
        var loop = new PrintPath(Square, new Bead(0.1, 0.2), closed: true);
        Assert.That(ScarfSeam.Apply(loop, 0.2, new PrintSettings { ScarfSeamLength = length }), applied ? Is.Not.SameAs(loop) : Is.SameAs(loop));
        var open = new PrintPath(Square, new Bead(0.1, 0.2));
        Assert.That(ScarfSeam.Apply(open, 0.2, new PrintSettings { ScarfSeamLength = 2 }), Is.SameAs(open));
    }
}
