using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry;

public class ContourMeasureTests
{
    private static Polyline Box(double x, double y, double width, double height, double turn = 0)
    {
        var (sin, cos) = Angle.SinCos(turn);
        return new Polyline(new[] { (-1, -1), (1, -1), (1, 1), (-1, 1) }.Select(c =>
        {
            double u = c.Item1 * width / 2, v = c.Item2 * height / 2;
            return new Vec3(x + u * cos - v * sin, y + u * sin + v * cos, 7);
        }), closed: true);
    }

    [Test]
    public void Contours_that_do_not_cross_are_summed_in_double()
    {
        var (area, perimeter, outer, holes) =
            ContourMeasure.NonZero(new[] { Box(0, 0, 30, 30, 33), Box(1, 2, 1.0 / 3, 1.0 / 7, 12).Reversed(), Box(100, 0, 2, 2) });
        Assert.That(area, Is.EqualTo(900 - 1.0 / 21 + 4).Within(1e-12 * 904));
        Assert.That(perimeter, Is.EqualTo(120 + 20.0 / 21 + 8).Within(1e-12 * 129));
        Assert.That((outer, holes), Is.EqualTo((2, 1)));
    }

    [Test]
    public void A_body_inside_another_one_adds_nothing()
    {
        var (area, _, outer, holes) = ContourMeasure.NonZero(new[] { Box(0, 0, 30, 30), Box(1, 2, 3, 3) });
        Assert.That(area, Is.EqualTo(900).Within(1e-9));
        Assert.That((outer, holes), Is.EqualTo((1, 0)));
        Assert.That(ContourMeasure.NonZero(new[] { Box(0, 0, 30, 30).Reversed() }).Outer, Is.EqualTo(1));
    }

    [Test]
    public void Crossing_boxes_are_measured_as_their_union()
    {
        // Two crossed bars, 10 x 2 each, at 90 degrees: 20 + 20 - 4; and the same turned, far away, small.
        foreach (var (x, turn, scale) in new[] { (0, 0.0, 1), (4000, 27.5, 1), (-300, 81.0, 100) })
        {
            var (area, perimeter, outer, holes) =
                ContourMeasure.NonZero(new[] { Box(x, 5, 10.0 / scale, 2.0 / scale, turn), Box(x, 5, 2.0 / scale, 10.0 / scale, turn) });
            Assert.That(area * scale * scale, Is.EqualTo(36).Within(1e-7));
            Assert.That(perimeter * scale, Is.EqualTo(40).Within(1e-7));
            Assert.That((outer, holes), Is.EqualTo((1, 0)));
        }
    }

    [Test]
    public void A_frame_of_overlapping_bars_has_a_hole()
    {
        var bars = new[] { Box(0, 5, 12, 2), Box(0, -5, 12, 2), Box(5, 0, 2, 12), Box(-5, 0, 2, 12) };
        var (area, perimeter, outer, holes) = ContourMeasure.NonZero(bars);
        Assert.That(area, Is.EqualTo(144 - 64).Within(1e-6));
        Assert.That(perimeter, Is.EqualTo(48 + 32).Within(1e-6));
        Assert.That((outer, holes), Is.EqualTo((1, 1)));
    }

    [Test]
    public void Nothing_and_bad_numbers()
    {
        Assert.That(ContourMeasure.NonZero(Array.Empty<Polyline>()), Is.EqualTo((0.0, 0.0, 0, 0)));
        Assert.That(ContourMeasure.NonZero(new[] { new Polyline(Array.Empty<Vec3>(), true), new Polyline(new[] { Vec3.UnitX }, true) }),
            Is.EqualTo((0.0, 0.0, 0, 0)));
        Assert.That(() => ContourMeasure.NonZero(new[] { new Polyline(new[] { new Vec3(double.NaN, 0), Vec3.UnitX, Vec3.UnitY }, true) }),
            Throws.ArgumentException.With.Property("ParamName").EqualTo("contours"));
    }

    [Test]
    public void It_agrees_with_the_region_of_the_same_contours()
    {
        var random = new Random(21);
        for (var k = 0; k < 50; k++)
        {
            IReadOnlyList<Polyline> contours = new[] { RegionReference.Star(random, 30, 0, 0, 4, 10), RegionReference.Star(random, 20, 6, 0, 3, 8),
                RegionReference.Random(random, 9, 12) };
            var region = Region.From(contours);
            var measure = ContourMeasure.NonZero(contours);
            Assert.That(measure.Area, Is.EqualTo(region.Area).Within(1e-3));
            Assert.That(measure.Perimeter, Is.EqualTo(region.Perimeter).Within(1e-2));
        }
    }
}
