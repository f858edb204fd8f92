using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using FsCheck;
using FsCheck.Fluent;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

public class LoopTests
{
    private static readonly Vec3[] Square = [new(0, 0, 1), new(10, 0, 1), new(10, 10, 1), new(0, 10, 1)];

    // An L: the corner at (4, 4) is concave.
    private static readonly Vec3[] Ell = [new(0, 0), new(10, 0), new(10, 4), new(4, 4), new(4, 10), new(0, 10)];

    private static PrintPath Loop(Vec3[] points) => new(points, points.Select((_, i) => new Bead(0.1 + i * 0.01, 0.2)), closed: true);

    [TestCase(5, -3, 5, 0)]
    [TestCase(12, 7, 10, 7)]
    [TestCase(-1, -1, 0, 0)]
    [TestCase(-2, 4, 0, 4)]
    public void The_nearest_place_lies_on_a_side_or_in_a_corner(double x, double y, double atX, double atY)
        => Assert.That(LoopPlace.Nearest(Square, new Vec3(x, y, 50)).Point, Is.EqualTo(new Vec3(atX, atY, 1)));

    [TestCase(0.1, 0)]
    [TestCase(9.9, 10)]
    [TestCase(0.3, 0.3)]
    public void A_place_close_to_a_corner_becomes_the_corner(double x, double atX)
        => Assert.That(LoopPlace.Nearest(Square, new Vec3(x, -1, 1)).Snapped(Square, 0.2).Point, Is.EqualTo(new Vec3(atX, 0, 1)));

    [Test]
    public void A_loop_that_starts_elsewhere_is_the_same_loop()
        => Prop.ForAll(Gen.Choose(-200, 1200).Two().ToArbitrary(), t =>
        {
            var loop = Loop(Square);
            var place = LoopPlace.Nearest(Square, new Vec3(t.Item1 / 100.0, t.Item2 / 100.0, 1));
            var started = place.Start(loop);
            return started.IsClosed && started.Start.DistanceTo(place.Point) <= 0.02 && Math.Abs(started.Length - 40) < 1e-9
                && Math.Abs(started.Volume - loop.Volume) < 1e-9 && Square.All(p => started.Points.Contains(p));
        }).Check(Config.QuickThrowOnFailure);

    [Test]
    public void A_place_at_a_length_is_counted_from_the_first_vertex()
    {
        Assert.That(LoopPlace.AtLength(Square, 13).Point, Is.EqualTo(new Vec3(10, 3, 1)));
        Assert.That(LoopPlace.AtLength(Square, 40).Point, Is.EqualTo(Square[0]));
    }

    [Test]
    public void Concave_corners_hide_a_seam_best_and_smooth_places_not_at_all()
    {
        Assert.That(Enumerable.Range(0, 6).Select(i => LoopCorner.Score(Ell, i, 0.9)), Is.EqualTo(new[] { 0.5, 0.5, 0.5, 1, 0.5, 0.5 }).Within(1e-12));
        var circle = Solids.Circle(10, 96);
        Assert.That(Enumerable.Range(0, 96).Select(i => LoopCorner.Score(circle, i, 0.9)), Is.All.Zero);
        // A hole runs the other way around: its corners are concave.
        Assert.That(LoopCorner.Score(Enumerable.Reverse(Square).ToArray(), 1, 0.9), Is.EqualTo(1).Within(1e-12));
    }

    [Test]
    public void A_rounded_corner_counts_as_a_corner()
    {
        // A square of 10 mm with corners of radius 0.3 mm in steps of 10°: the arms reach across the curve.
        var points = Enumerable.Range(0, 4).SelectMany(k => Enumerable.Range(0, 10).Select(i =>
        {
            var (sin, cos) = Angle.SinCos(90 * k + 10 * i);
            var center = new Vec3(k is 0 or 3 ? 4.7 : -4.7, k is 0 or 1 ? 4.7 : -4.7);
            return center + new Vec3(0.3 * cos, 0.3 * sin);
        })).ToArray();
        Assert.That(LoopCorner.Score(points, 5, 0.9), Is.GreaterThan(0.3));
    }

    [Test]
    public void A_scarf_holds_the_volume_of_the_loop_and_rises_from_the_layer_below()
    {
        var settings = new PrintSettings { ScarfSeamLength = 8, ScarfSeamSteps = 4 };
        var loop = new PrintPath(Square, new Bead(0.08, 0.2, 30), closed: true);
        var scarf = ScarfSeam.Apply(loop, 0.2, settings);
        Assert.That(scarf.IsClosed, Is.False);
        Assert.That(scarf.Volume, Is.EqualTo(loop.Volume).Within(1e-4), "as long as the loop, but for the rise");
        // 0.18 mm below at the start, in four equal steps up to the height of the layer.
        Assert.That(scarf.Points.Take(5).Select(p => p.Z), Is.EqualTo(new[] { 0.82, 0.865, 0.91, 0.955, 1 }).Within(1e-12));
        Assert.That(scarf.Points.Skip(4).Select(p => p.Z), Is.All.EqualTo(1));
        Assert.That(scarf.Points.Take(5).Select(p => p.X), Is.EqualTo(new[] { 0.0, 2, 4, 6, 8 }).Within(1e-12));
        Assert.That(scarf.End.WithZ(0).DistanceTo(new Vec3(8, 0)), Is.LessThan(1e-12));
        // Where start and end lie over each other, their shares make one.
        for (var i = 0; i < 4; i++) Assert.That(scarf.BeadOf(i).Area + scarf.BeadOf(scarf.SegmentCount - 4 + i).Area, Is.EqualTo(0.08).Within(1e-12));
        Assert.That(scarf.BeadOf(0).Area, Is.EqualTo(0.08 * (0.1 + 0.9 / 8)).Within(1e-12));
        Assert.That(Enumerable.Range(0, scarf.SegmentCount).Select(i => scarf.BeadOf(i).Speed), Is.All.EqualTo(30));
    }

    [Test]
    public void A_scarf_goes_around_corners_and_is_left_out_where_the_loop_is_short()
    {
        var loop = new PrintPath(Square, new Bead(0.08, 0.2), closed: true);
        var around = ScarfSeam.Apply(loop, 0.2, new PrintSettings { ScarfSeamLength = 14, ScarfSeamSteps = 7 });
        Assert.That(around.End.WithZ(0).DistanceTo(new Vec3(10, 4)), Is.LessThan(1e-9));
        Assert.That(around.Volume, Is.EqualTo(loop.Volume).Within(1e-4));
        Assert.That(ScarfSeam.Apply(loop, 0.2, new PrintSettings { ScarfSeamLength = 21 }), Is.SameAs(loop));
        Assert.That(ScarfSeam.Apply(loop, 0.2, new PrintSettings()), Is.SameAs(loop));
    }
}
