using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using NetTopologySuite.Operation.Overlay;
using NetTopologySuite.Operation.OverlayNG;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry;

public class RegionTests
{
    private static Region Square(double x, double y, double size) => Region.Rectangle(x, y, x + size, y + size);

    private static Polyline Loop(params double[] xy) => new(Enumerable.Range(0, xy.Length / 2).Select(i => new Vec3(xy[2 * i], xy[2 * i + 1])), closed: true);

    [Test]
    public void Overlapping_squares_have_the_areas_of_the_textbook()
    {
        var a = Square(0, 0, 10);
        var b = Square(5, 5, 10);
        Assert.That(a.Union(b).Area, Is.EqualTo(175));
        Assert.That(a.Intersect(b).Area, Is.EqualTo(25));
        Assert.That(a.Subtract(b).Area, Is.EqualTo(75));
        Assert.That(a.Xor(b).Area, Is.EqualTo(150));
        Assert.That(a.Union(b).Perimeter, Is.EqualTo(60));
        Assert.That(a.Intersect(b).Bounds, Is.EqualTo(new Bounds(new Vec3(5, 5), new Vec3(10, 10))));
        RegionReference.AssertValid(a.Union(b));
        RegionReference.AssertValid(a.Xor(b));
    }

    [Test]
    public void Squares_with_a_common_side_join_without_the_side()
    {
        var both = Square(0, 0, 10).Union(Square(10, 0, 10));
        Assert.That(both.Contours, Has.Count.EqualTo(1));
        Assert.That(both.VertexCount(), Is.EqualTo(4));
        Assert.That(both.Area, Is.EqualTo(200));
        Assert.That(Square(0, 0, 10).Intersect(Square(10, 0, 10)).IsEmpty);
        Assert.That(Square(0, 0, 10).Subtract(Square(0, 0, 10)).IsEmpty);
        Assert.That(Square(0, 0, 10).Xor(Square(0, 0, 10)).IsEmpty);
    }

    [Test]
    public void Squares_that_touch_at_a_corner_stay_two_rings()
    {
        var both = Square(0, 0, 10).Union(Square(10, 10, 10));
        Assert.That(both.Contours, Has.Count.EqualTo(2));
        Assert.That(both.Islands, Has.Count.EqualTo(2));
        RegionReference.AssertValid(both);
    }

    [Test]
    public void A_hole_is_clockwise_and_an_island_in_it_is_its_own_piece()
    {
        var ring = Square(0, 0, 30).Subtract(Square(5, 5, 20)).Union(Square(10, 10, 10));
        Assert.That(ring.Area, Is.EqualTo(900 - 400 + 100));
        Assert.That(ring.Contours.Count(c => c.SignedAreaXY > 0), Is.EqualTo(2));
        Assert.That(ring.Contours.Count(c => c.SignedAreaXY < 0), Is.EqualTo(1));
        Assert.That(ring.Islands.Select(i => i.Area), Is.EquivalentTo(new[] { 500.0, 100.0 }));
        Assert.That(ring.Contains(2, 2) && !ring.Contains(7, 7) && ring.Contains(15, 15) && ring.Contains(5, 10) && !ring.Contains(-1, 3));
    }

    [Test]
    public void Fill_rules_read_a_double_loop_differently()
    {
        var twice = new[] { Loop(0, 0, 10, 0, 10, 10, 0, 10), Loop(2, 2, 8, 2, 8, 8, 2, 8) };
        Assert.That(Region.From(twice).Area, Is.EqualTo(100));
        Assert.That(Region.From(twice, FillRule.EvenOdd).Area, Is.EqualTo(64));
        var clockwise = twice[0].Reversed();
        Assert.That(Region.From(clockwise).Area, Is.EqualTo(100));
        Assert.That(Region.From(clockwise, FillRule.Positive).IsEmpty);
        var holed = new[] { twice[0], twice[1].Reversed() };
        Assert.That(Region.From(holed).Area, Is.EqualTo(64));
        Assert.That(Region.From(holed, closeHoles: true).Area, Is.EqualTo(100));
    }

    [Test]
    public void A_figure_eight_and_a_spike_are_resolved()
    {
        var eight = Region.From(Loop(0, 0, 10, 10, 10, 0, 0, 10));
        Assert.That(eight.Area, Is.EqualTo(50));
        Assert.That(eight.Contours, Has.Count.EqualTo(2));
        var spike = Region.From(Loop(0, 0, 10, 0, 20, 0, 10, 0, 10, 10, 0, 10));
        Assert.That(spike.VertexCount(), Is.EqualTo(4));
        Assert.That(spike.Area, Is.EqualTo(100));
    }

    [Test]
    public void Contours_without_area_give_nothing()
    {
        Assert.That(Region.From(Array.Empty<Polyline>()).IsEmpty);
        Assert.That(Region.From(Loop()).IsEmpty);
        Assert.That(Region.From(Loop(1, 1)).IsEmpty);
        Assert.That(Region.From(Loop(1, 1, 2, 2)).IsEmpty);
        Assert.That(Region.From(Loop(1, 1, 2, 2, 3, 3)).IsEmpty);
        Assert.That(Region.From(Loop(1, 1, 1, 1, 1, 1, 1, 1)).IsEmpty);
        Assert.That(Region.Empty.Offset(1).IsEmpty && Region.Empty.Area == 0 && Region.Empty.Bounds.IsEmpty && Region.Empty.Islands.Count == 0);
        Assert.That(Region.Empty.Contains(0, 0), Is.False);
    }

    [Test]
    public void Small_contours_are_dropped()
    {
        var region = Square(0, 0, 30).Subtract(Square(5, 5, 20)).Union(Square(10, 10, 1)).Subtract(Square(1, 1, 0.5));
        Assert.That(region.Contours, Has.Count.EqualTo(4));
        Assert.That(region.WithoutSmallContours(0).Contours, Has.Count.EqualTo(4));
        Assert.That(region.WithoutSmallContours(0.5).Area, Is.EqualTo(900 - 400 + 1));
        Assert.That(region.WithoutSmallContours(500).Area, Is.EqualTo(900));
        Assert.That(() => region.WithoutSmallContours(-1), Throws.ArgumentException.With.Property("ParamName").EqualTo("area"));
    }

    [Test]
    public void Touching_turned_boxes_leave_no_slit_between_them()
    {
        for (var k = 1; k < 60; k++)
        {
            var (sin, cos) = Angle.SinCos(k * 5.77);
            Vec3 At(double x, double y) => new(x * cos - y * sin, x * sin + y * cos);
            Polyline Box(double x0, double y0, double x1, double y1) => new(new[] { At(x0, y0), At(x1, y0), At(x1, y1), At(x0, y1) }, closed: true);
            var region = Region.From(new[] { Box(0, 0, 30, 10), Box(3, 10, 7, 20), Box(11, 10, 29, 13), Box(30, 2, 35, 8) });
            Assert.That(region.Contours, Has.Count.EqualTo(1), $"turn {k}");
            Assert.That(region.Offset(-0.4).Islands, Has.Count.EqualTo(1));
            RegionReference.AssertValid(region);
        }
    }

    [TestCase(double.NaN)]
    [TestCase(double.PositiveInfinity)]
    [TestCase(6000)]
    public void Coordinates_off_the_grid_are_refused(double bad)
        => Assert.That(() => Region.From(new[] { Loop(0, 0, bad, 0, 1, 1) }), Throws.ArgumentException.With.Property("ParamName").EqualTo("contours"));

    [Test]
    public void Parameters_out_of_range_are_named()
    {
        var square = Square(0, 0, 10);
        Assert.That(() => square.Offset(double.NaN), Throws.ArgumentException.With.Property("ParamName").EqualTo("distance"));
        Assert.That(() => square.Offset(5365), Throws.ArgumentException.With.Property("ParamName").EqualTo("distance"));
        Assert.That(() => square.Offset(1, JoinStyle.Miter, 0.5), Throws.ArgumentException.With.Property("ParamName").EqualTo("miterLimit"));
        Assert.That(() => square.Offset(1, JoinStyle.Round, 2, 0), Throws.ArgumentException.With.Property("ParamName").EqualTo("arcTolerance"));
        Assert.That(() => square.HatchLines(0, 0), Throws.ArgumentException.With.Property("ParamName").EqualTo("spacing"));
        Assert.That(() => square.HatchLines(0, 1e-12), Throws.ArgumentException.With.Property("ParamName").EqualTo("spacing"));
        Assert.That(() => square.Simplified(-1), Throws.ArgumentException.With.Property("ParamName").EqualTo("tolerance"));
    }

    [Test]
    public void Coordinates_at_the_edge_of_the_grid_are_exact()
    {
        const double m = 5368.709;
        var all = Region.Rectangle(-m, -m, m, m);
        var cross = Region.From(new[] { Loop(-m, -m, m, m, m, m - 1, -m, -m - 0.0001 + 0.0001), Loop(-m, m, m, -m, m, -m + 1) });
        Assert.That(all.Area, Is.EqualTo(4 * m * m).Within(1e-3));
        Assert.That(all.Intersect(cross).Area, Is.EqualTo(cross.Area).Within(1e-3));
        Assert.That(all.Subtract(cross).Area, Is.EqualTo(all.Area - cross.Area).Within(1e-2));
        RegionReference.AssertValid(all.Subtract(cross));
    }

    [TestCase(4, 4, 3000)]
    [TestCase(8, 5, 1500)]
    [TestCase(16, 8, 500)]
    [TestCase(40, 12, 100)]
    public void Self_crossing_polygons_on_a_tiny_grid_have_the_area_of_their_faces(int points, int size, int times)
    {
        var random = new Random(points);
        // In grid units of 10 nm the crossings are rounded hard; in mm they are not. The reference works in mm.
        for (var k = 0; k < Rounds.Of(times / 3, times, times / 20); k++)
        {
            var contour = RegionReference.Random(random, points, size);
            var region = Region.From(contour, FillRule.EvenOdd);
            RegionReference.AssertValid(region);
            Assert.That(region.Area, Is.EqualTo(RegionReference.EvenOddArea(contour, w => (w & 1) != 0)).Within(1e-4), $"even-odd {k}");
            region = Region.From(contour);
            RegionReference.AssertValid(region);
            Assert.That(region.Area, Is.EqualTo(RegionReference.EvenOddArea(contour, w => w != 0)).Within(1e-4), $"non-zero {k}");
            region = Region.From(contour, FillRule.Positive);
            Assert.That(region.Area, Is.EqualTo(RegionReference.EvenOddArea(contour, w => w > 0)).Within(1e-4), $"positive {k}");
        }
    }

    [TestCase(5, 4)]
    [TestCase(10, 6)]
    [TestCase(30, 10)]
    [TestCase(60, 30)]
        public void Rounding_hard_on_the_finest_grid_leaves_no_crossings(int points, int size)
    {
        var random = new Random(points * 7 + size);
        for (var k = 0; k < (Fast ? 20000 : 2000) / points / points; k++)
        {
            var a = Region.From(RegionReference.Random(random, points, size, 1e-5));
            var b = Region.From(RegionReference.Random(random, points, size, 1e-5), FillRule.EvenOdd);
            RegionReference.AssertValid(a);
            RegionReference.AssertValid(b);
            foreach (var result in new[] { a.Union(b), a.Intersect(b), a.Subtract(b), a.Xor(b) }) RegionReference.AssertValid(result);
            Assert.That(a.Union(a).Area, Is.EqualTo(a.Area));
            Assert.That(a.Subtract(a).IsEmpty);
        }
    }

    [Test]
    public void Union_and_intersection_add_up()
    {
        var random = new Random(5);
        for (var k = 0; k < (Fast ? 400 : 40); k++)
        {
            var a = Region.From(new[] { RegionReference.Star(random, 30, 0, 0, 2, 10), RegionReference.Star(random, 20, 5, 3, 2, 10) }, FillRule.EvenOdd);
            var b = Region.From(RegionReference.Star(random, 40, 3, 1, 3, 9));
            Assert.That(a.Union(b).Area + a.Intersect(b).Area, Is.EqualTo(a.Area + b.Area).Within(1e-3));
            Assert.That(a.Subtract(b).Area + a.Intersect(b).Area, Is.EqualTo(a.Area).Within(1e-3));
            Assert.That(a.Xor(b).Area, Is.EqualTo(a.Union(b).Area - a.Intersect(b).Area).Within(1e-3));
            Assert.That(Region.Union(new[] { a, b, a }).Area, Is.EqualTo(a.Union(b).Area).Within(1e-4));
            Assert.That(a.Intersect([b, a], new RegionEngine()).Area, Is.EqualTo(a.Area).Within(1e-4));
        }
    }

    [Test]
    public void Booleans_agree_with_NetTopologySuite()
    {
        var random = new Random(11);
        for (var k = 0; k < Rounds.Of(100, 300, 30); k++)
        {
            var a = Region.From(new[] { RegionReference.Star(random, 60, 0, 0, 2, 10), RegionReference.Star(random, 20, 5, 3, 2, 10) }, FillRule.EvenOdd);
            var b = Region.From(RegionReference.Random(random, 9, 12), FillRule.EvenOdd);
            var (na, nb) = (RegionReference.ToNts(a), RegionReference.ToNts(b));
            Assert.That(a.Union(b).Area, Is.EqualTo(OverlayNGRobust.Overlay(na, nb, SpatialFunction.Union).Area).Within(1e-3));
            Assert.That(a.Intersect(b).Area, Is.EqualTo(OverlayNGRobust.Overlay(na, nb, SpatialFunction.Intersection).Area).Within(1e-3));
            Assert.That(a.Subtract(b).Area, Is.EqualTo(OverlayNGRobust.Overlay(na, nb, SpatialFunction.Difference).Area).Within(1e-3));
            Assert.That(a.Xor(b).Area, Is.EqualTo(OverlayNGRobust.Overlay(na, nb, SpatialFunction.SymDifference).Area).Within(1e-3));
        }
    }

    private static bool Fast => !Rounds.OnMono;

    [TestCase(0.5, true)]
    [TestCase(0.51, false)]
    public void What_is_within_half_a_unit_of_the_grid_from_a_boundary_lies_on_it(double units, bool isOn)
    {
        var square = Region.Rectangle(0, 0, 10, 10);
        var beside = units / 100_000;
        Assert.That(new[] { square.Contains(5, -beside), square.Contains(-beside, 5) }, Is.All.EqualTo(isOn));
    }
}
