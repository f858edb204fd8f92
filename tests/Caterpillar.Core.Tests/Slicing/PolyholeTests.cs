using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

/// <summary>Round holes that become polygons.</summary>
[TestFixture]
public class PolyholeTests
{
    private static readonly PrintSettings Plain = new()
    {
        LineWidth = 0.4, BeadShape = BeadShape.Rectangle, WallCount = 1, MinLayerTime = 0, HoleToPolyhole = true, LayerHeight = 0.2,
    };

    private static Region Plate(params Vec3[][] holes)
        => holes.Aggregate(Region.Rectangle(-20, -20, 20, 20), (plate, hole) => plate.Subtract(Region.From(new Polyline(hole, closed: true))));

    private static Vec3[] Circle(double diameter, int sides = 48, double x = 0, double y = 0)
        => [.. Solids.Circle(diameter / 2, sides).Select(p => p + new Vec3(x, y))];

    private static Region[] Regions(Region plate, PrintSettings settings) => [.. Solids.Slice(settings, Prism.On(plate, 0.6)).Select(l => l.Region)];

    // The area of a polygon around a circle.
    private static double Around(double diameter, int sides) => sides * diameter * diameter / 4 * Math.Tan(Math.PI / sides);

    [TestCase(1.0, 3)]
    [TestCase(1.5, 3)]
    [TestCase(2.0, 4)]
    [TestCase(3.0, 6)]
    [TestCase(4.2, 8)]
    [TestCase(10.0, 20)]
    public void A_hole_has_two_sides_for_each_mm_that_touch_its_circle(double diameter, int sides)
    {
        var region = Regions(Plate(Circle(diameter)), Plain)[0];
        var hole = region.Contours.Single(c => c.SignedAreaXY < 0);

        Assert.That(hole.Count, Is.EqualTo(sides));
        Assert.That(region.Area, Is.EqualTo(1600 - Around(diameter, sides)).Within(0.01));
        Assert.That(hole.Points.Select(p => p.LengthXY), Is.All.EqualTo(diameter / 2 / Math.Cos(Math.PI / sides)).Within(0.002));
    }

    [Test]
    public void Every_other_layer_is_turned_by_half_a_side_unless_that_is_off()
    {
        double[] Angles(PrintSettings settings) => [.. Regions(Plate(Circle(3)), settings).Select(r => r.Contours.Single(c => c.SignedAreaXY < 0).Points
            .Min(p => (Angle.Atan2(p.Y, p.X) + 360.01) % 60 - 0.01))];

        Assert.That(Angles(Plain), Is.EqualTo(new[] { 0, 30, 0.0 }).Within(0.01));
        Assert.That(Angles(Plain with { HoleToPolyholeTwisted = false }), Is.EqualTo(new[] { 0, 0, 0.0 }).Within(0.01));
    }

    [Test]
    public void The_wall_leaves_the_whole_circle_open()
    {
        var walls = Solids.Slice(Plain, Prism.On(Plate(Circle(3, x: 5)), 0.6)).SelectMany(l => Solids.Paths(l, Role.OuterWall));
        var hole = walls.Where(w => w.Length < 20).ToArray();
        Assert.That(hole, Has.Length.EqualTo(3));
        foreach (var wall in hole)
        {
            var nearest = Enumerable.Range(0, wall.SegmentCount).Min(i => ((wall.Points[i] + wall.EndOf(i)) / 2 - new Vec3(5, 0)).LengthXY);
            Assert.That(nearest, Is.EqualTo(1.5 + 0.2).Within(0.003));
        }
    }

    [Test]
    public void Holes_that_are_not_round_stay_and_so_do_outlines()
    {
        var nut = Circle(8, 6);
        var octagon = Circle(5, 8);
        // A shaft with a flat, and a slot.
        var flat = Circle(6).Where(p => p.X < 2).ToArray();
        var circle = Circle(4);
        Vec3[] slot = [.. circle.Take(25).Select(p => p + new Vec3(0, 2)), .. circle.Skip(24), circle[0]];
        var ellipse = Circle(6).Select(p => new Vec3(p.X * 1.1, p.Y)).ToArray();
        foreach (var hole in new[] { nut, octagon, flat, slot, ellipse })
        {
            var (with, without) = (Regions(Plate(hole), Plain), Regions(Plate(hole), Plain with { HoleToPolyhole = false }));
            Assert.That(with.Select(r => r.Area), Is.EqualTo(without.Select(r => r.Area)));
        }
        // Beside a round one too.
        var both = Regions(Plate(Circle(4, x: 8), Circle(8, 6)), Plain)[0];
        Assert.That(both.Contours.Where(c => c.SignedAreaXY < 0).Select(c => c.Count), Is.EquivalentTo(new[] { 8, 6 }));
        var disk = Region.From(new Polyline(Circle(20), closed: true));
        Assert.That(Regions(disk, Plain)[0].Area, Is.EqualTo(disk.Area).Within(0.5));
    }

    // A hole of 48 corners, some of which are missing: a side of 37.5 degrees belongs to a circle, one of 52.5 degrees is a flat, wherever it begins.
    [Test]
    public void A_long_side_is_a_flat_wherever_the_hole_begins()
    {
        for (var first = 0; first < 48; first += 5)
        {
            int Corners(int missing)
            {
                var kept = Enumerable.Range(missing, 48 - missing).Select(i => Circle(6)[(i + first) % 48]).ToArray();
                return Regions(Plate(kept), Plain with { HoleToPolyholeTwisted = false })[0].Contours.Single(c => c.SignedAreaXY < 0).Count;
            }
            Assert.That((Corners(4), Corners(6)), Is.EqualTo((12, 42)), $"from corner {first}");
        }
    }

    [TestCase(8, 8)]
    [TestCase(9, 10)]
    public void A_hole_of_eight_corners_is_meant_to_have_them(int corners, int sides)
        => Assert.That(Regions(Plate(Circle(5, corners)), Plain)[0].Contours.Single(c => c.SignedAreaXY < 0).Count, Is.EqualTo(sides));

    [Test]
    public void A_pin_inside_a_hole_stays_and_a_hole_near_an_edge_opens_it()
    {
        var pin = Region.From(new Polyline(Circle(4), closed: true));
        Assert.That(Regions(Plate(Circle(8)).Union(pin), Plain)[0].Area, Is.EqualTo(1600 - Around(8, 16) + pin.Area).Within(0.1));
        // The corner of a triangle reaches 0.5 mm farther out than the hole of 1 mm.
        var open = Regions(Plate(Circle(1, x: 19.2)), Plain)[0];
        Assert.That(open.Contours, Has.Count.EqualTo(1));
        Assert.That(open.Area, Is.LessThan(1600 - Around(1, 3) * 0.9));
    }

    [Test]
    public void Corners_off_the_circle_need_a_greater_threshold()
    {
        var rough = Circle(6, 24).Select((p, i) => i % 2 == 0 ? p : p * 1.02).ToArray();
        int Corners(double threshold)
            => Regions(Plate(rough), Plain with { HoleToPolyholeThreshold = threshold })[0].Contours.Single(c => c.SignedAreaXY < 0).Count;
        Assert.That((Corners(0.02), Corners(0.1)), Is.EqualTo((24, 12)));
        Assert.That(() => Plain with { HoleToPolyholeThreshold = -1 }, Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [Test]
    public void Compensation_of_holes_comes_on_top()
    {
        var region = Regions(Plate(Circle(3)), Plain with { XyHoleCompensation = 0.1 })[0];
        Assert.That(region.Area, Is.EqualTo(1600 - Around(3.2, 6)).Within(0.01));
    }
}
