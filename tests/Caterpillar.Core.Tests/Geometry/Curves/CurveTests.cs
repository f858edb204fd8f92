using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry.Curves;

public class CurveTests
{
    [Test]
    public void A_line_has_its_length_and_ends()
    {
        var line = new PolylineCurve([new Vec3(1, 2, 3), new Vec3(4, 6, 3)]);
        Assert.That(line.Length, Is.EqualTo(5));
        Assert.That(line.PointAt(0.5), Is.EqualTo(new Vec3(2.5, 4, 3)));
        Assert.That(line.End, Is.EqualTo(new Vec3(4, 6, 3)));
        Assert.That(line.Spans()[0].StartTangent, Is.EqualTo(new Vec3(0.6, 0.8)));
        Assert.That(() => new PolylineCurve([Vec3.Zero, new Vec3(double.NaN, 0)]), Throws.ArgumentException);
    }

    [Test]
    public void A_closed_polyline_comes_back_to_its_first_point()
    {
        var square = new PolylineCurve([new(0, 0), new(2, 0), new(2, 2), new(0, 2)], closed: true);
        Assert.That(square.DomainEnd, Is.EqualTo(4));
        Assert.That(square.Length, Is.EqualTo(8));
        Assert.That(square.PointAt(3.5), Is.EqualTo(new Vec3(0, 1)));
        Assert.That(square.End, Is.EqualTo(square.Start));
        Assert.That(CurveMaker.Kinks(square), Is.EqualTo(square.Polyline.Points));
        Assert.That(CurveMaker.Middle(square), Is.EqualTo(new Vec3(2, 2)));
    }

    [Test]
    public void The_box_of_an_arc_holds_its_extremes()
    {
        var circle = ArcCurve.Circle(new Vec3(5, 5, 1), 2);
        Assert.That(circle.Bounds.Min.DistanceTo(new Vec3(3, 3, 1)), Is.LessThan(1e-12));
        Assert.That(circle.Bounds.Max.DistanceTo(new Vec3(7, 7, 1)), Is.LessThan(1e-12));
        Assert.That(circle.IsClosed, Is.True);
        var tilted = new ArcCurve(Frame.World.Pitch(30).Yaw(20), 3, -200);
        var box = tilted.Bounds;
        for (var i = 0; i <= 1000; i++) Assert.That(box.Contains(tilted.PointAt(i / 1000.0), 1e-9), Is.True);
        Assert.That(Enumerable.Range(0, 1001).Max(i => tilted.PointAt(i / 1000.0).Z), Is.EqualTo(box.Max.Z).Within(1e-4));
    }

    [Test]
    public void An_arc_is_a_rational_curve_of_degree_two()
    {
        var arc = new ArcCurve(Frame.At(new Vec3(1, 2, 3)).Roll(40), 7, 300);
        var nurbs = arc.ToNurbs();
        Assert.That(nurbs.Length, Is.EqualTo(arc.Length).Within(1e-9));
        for (var i = 0; i <= 100; i++)
            Assert.That(nurbs.PointAt(i / 100.0).DistanceTo(arc.Center), Is.EqualTo(7).Within(1e-12));
        var ellipse = arc.Transformed(Affine.Scale(2, 1, 1));
        Assert.That(ellipse, Is.InstanceOf<NurbsCurve>());
        Assert.That(arc.Transformed(Affine.Rotate(new Vec3(1, 2, 3), 50).Then(Affine.Scale(-2))), Is.InstanceOf<ArcCurve>());
    }

    [Test]
    public void Nurbs_curves_follow_the_definition()
    {
        var random = new Random(11);
        for (var n = 0; n < 300; n++)
        {
            var curve = CurveMaker.Nurbs(random);
            for (var i = 0; i <= 10; i++)
            {
                var t = curve.DomainStart + (curve.DomainEnd - curve.DomainStart) * i / 10;
                Assert.That(curve.PointAt(t).DistanceTo(CurveMaker.ByDefinition(curve, t)), Is.LessThan(1e-10));
            }
        }
    }

    [Test]
    public void Derivatives_agree_with_differences()
    {
        var random = new Random(12);
        for (var n = 0; n < 200; n++)
        {
            Curve curve = n % 3 == 0 ? CurveMaker.LineArcLineNurbsLine() : CurveMaker.Nurbs(random);
            const double H = 1e-6;
            foreach (var span in curve.Spans())
            {
                var u = CurveMaker.Next(random, H, 1 - H);
                var (first, second) = span.Derivatives(u);
                var difference = (span.Point(u + H) - span.Point(u - H)) / (2 * H);
                Assert.That(first.DistanceTo(difference), Is.LessThan(1e-5 * (1 + difference.Length)));
                difference = (span.Derivatives(u + H).First - span.Derivatives(u - H).First) / (2 * H);
                Assert.That(second.DistanceTo(difference), Is.LessThan(1e-4 * (1 + difference.Length)));
            }
        }
    }

    [Test]
    public void Lengths_agree_with_an_independent_quadrature()
    {
        var random = new Random(13);
        for (var n = 0; n < 60; n++)
        {
            var curve = CurveMaker.Nurbs(random);
            var sum = curve.Spans().Sum(span => CurveMaker.LengthByChords(span, 0, 1, 1500));
            Assert.That(curve.Length, Is.EqualTo(sum).Within(2e-5 * (1 + sum)));
        }
        // A parabola from (-1, 1) to (1, 1): √5 + asinh(2)/2.
        var parabola = NurbsCurve.Clamped(2, [new(-1, 1), new(0, -1), new(1, 1)]);
        Assert.That(parabola.Length, Is.EqualTo(Math.Sqrt(5) + Math.Log(2 + Math.Sqrt(5)) / 2).Within(1e-12));
    }

    [Test]
    public void A_place_at_a_length_is_that_far_from_the_start()
    {
        var random = new Random(14);
        for (var n = 0; n < 60; n++)
        {
            Curve curve = n == 0 ? CurveMaker.LineArcLineNurbsLine() : CurveMaker.Nurbs(random);
            var length = new ArcLength(curve.Spans());
            for (var i = 0; i <= 20; i++)
            {
                var s = length.Total * i / 20;
                var (leaf, u) = length.Locate(s);
                var (span, from, _, start, _) = length.LeafAt(leaf);
                Assert.That(start + CurveMaker.LengthByChords(length.Spans[span], from, u, 300), Is.EqualTo(s).Within(2e-5 * (1 + s)));
            }
            Assert.That(length.Locate(length.Total + 1), Is.EqualTo((length.LeafCount - 1, 1.0)));
            Assert.That(length.Locate(-1), Is.EqualTo((0, 0.0)));
        }
    }

    [Test]
    public void Affine_maps_commute_with_evaluation()
    {
        var random = new Random(18);
        var map = Affine.Rotate(new Vec3(1, -2, 0.5), 33).Then(Affine.Scale(1, 2, -0.5)).Then(Affine.Move(new Vec3(3, 4, 5)));
        for (var n = 0; n < 100; n++)
        {
            Curve curve = n % 3 == 0 ? CurveMaker.LineArcLineNurbsLine() : CurveMaker.Nurbs(random);
            var mapped = curve.Transformed(map);
            var joints = curve.Spans().Select(s => map.Apply(s.Start)).ToList();
            var images = mapped.Spans().Select(s => s.Start).ToList();
            Assert.That(joints.Max(j => images.Min(i => i.DistanceTo(j))), Is.LessThan(1e-9));
            Assert.That(mapped.End.DistanceTo(map.Apply(curve.End)), Is.LessThan(1e-9));
        }
    }

    [Test]
    public void Kinks_are_found_where_the_direction_jumps()
    {
        // The last line leaves the NURBS curve at a right angle; the other joints are tangent.
        Assert.That(CurveMaker.Kinks(CurveMaker.LineArcLineNurbsLine()), Is.EqualTo(new[] { new Vec3(30, 20, 4) }));
        Assert.That(CurveMaker.Kinks(NurbsCurve.Periodic(3, [new(0, 0), new(4, 0), new(4, 4), new(0, 4)])), Is.Empty);
        // A double knot of degree 2 is a corner.
        var corner = new NurbsCurve(2, [new(0, 0), new(1, 0), new(2, 0), new(2, 1), new(2, 2)], [0, 0, 0, 1, 1, 2, 2, 2]);
        Assert.That(CurveMaker.Kinks(corner), Is.EqualTo(new[] { new Vec3(2, 0) }));
    }

    [Test]
    public void A_periodic_curve_closes_smoothly()
    {
        var curve = NurbsCurve.Periodic(3, [new(0, 0), new(4, 0), new(4, 4), new(0, 4, 2), new(-1, 2)]);
        Assert.That(curve.IsClosed, Is.True);
        Assert.That(CurveMaker.Kinks(curve, 1e-9), Is.Empty);
    }

    [Test]
    public void Nurbs_data_that_do_not_fit_are_refused()
    {
        Vec3[] points = [new(0, 0), new(1, 0), new(2, 1)];
        Assert.That(() => new NurbsCurve(2, points, [0, 0, 0, 1, 1]), Throws.ArgumentException.With.Message.Contains("need 6 knots"));
        Assert.That(() => new NurbsCurve(3, points, [0, 0, 0, 0, 1, 1, 1]), Throws.ArgumentException);
        Assert.That(() => new NurbsCurve(2, points, [0, 0, 0, 1, 1, 0.5]), Throws.ArgumentException);
        Assert.That(() => new NurbsCurve(2, points, [0, 0, 0, 0, 0, 0]), Throws.ArgumentException);
        Assert.That(() => new NurbsCurve(2, points, [0, 0, 0, 1, 1, 1], [1, 0, 1]), Throws.ArgumentException);
        Assert.That(() => new NurbsCurve(2, [new(0, 0), new(double.NaN, 0), new(2, 1)], [0, 0, 0, 1, 1, 1]), Throws.ArgumentException);
        Assert.That(() => new NurbsCurve(1, [.. points, new(3, 3)], [0, 0, 1, 1, 2, 2]), Throws.ArgumentException.With.Message.Contains("breaks"));
    }

    [Test]
    public void Pieces_must_meet()
    {
        var line = new PolylineCurve([new Vec3(0, 0), new Vec3(1, 0)]);
        Assert.That(() => new PolyCurve([line, new PolylineCurve([new Vec3(1.1, 0), new Vec3(2, 0)])]), Throws.ArgumentException);
        Assert.That(() => new PolyCurve([]), Throws.ArgumentException);
        var joined = new PolyCurve([line, new PolyCurve([new PolylineCurve([new Vec3(1, 0), new Vec3(2, 0)])])]);
        Assert.That(joined.Pieces, Has.Count.EqualTo(2));
        Assert.That(joined.PointAt(1.5), Is.EqualTo(new Vec3(1.5, 0)));
    }
}
