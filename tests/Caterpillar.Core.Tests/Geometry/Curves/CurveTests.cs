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
        var line = new LineCurve(new Vec3(1, 2, 3), new Vec3(4, 6, 3));
        Assert.That(line.Length, Is.EqualTo(5));
        Assert.That(line.PointAt(0.5), Is.EqualTo(new Vec3(2.5, 4, 3)));
        Assert.That(line.End, Is.EqualTo(new Vec3(4, 6, 3)));
        Assert.That(line.TangentAt(0.3), Is.EqualTo(new Vec3(0.6, 0.8)));
        Assert.That(line.ParameterAtLength(2), Is.EqualTo(0.4).Within(1e-15));
        Assert.That(() => new LineCurve(Vec3.Zero, Vec3.Zero), Throws.ArgumentException);
        Assert.That(() => new LineCurve(Vec3.Zero, new Vec3(double.NaN, 0)), Throws.ArgumentException);
    }

    [Test]
    public void A_closed_polyline_comes_back_to_its_first_point()
    {
        var square = new PolylineCurve([new(0, 0), new(2, 0), new(2, 2), new(0, 2)], closed: true);
        Assert.That(square.DomainEnd, Is.EqualTo(4));
        Assert.That(square.Length, Is.EqualTo(8));
        Assert.That(square.PointAt(3.5), Is.EqualTo(new Vec3(0, 1)));
        Assert.That(square.End, Is.EqualTo(square.Start));
        Assert.That(square.Kinks(), Is.EqualTo(new[] { 0.0, 1, 2, 3 }));
        Assert.That(square.ParameterAtLength(5), Is.EqualTo(2.5).Within(1e-12));
    }

    [Test]
    public void An_arc_through_three_points_lies_on_them()
    {
        var arc = ArcCurve.Through(new Vec3(1, 0), new Vec3(0, 1), new Vec3(-1, 0));
        Assert.That(arc.Radius, Is.EqualTo(1).Within(1e-15));
        Assert.That(arc.Sweep, Is.EqualTo(180).Within(1e-12));
        Assert.That(arc.Length, Is.EqualTo(Math.PI).Within(1e-14));
        var other = ArcCurve.Through(new Vec3(1, 0), new Vec3(0, -1), new Vec3(0, 1));
        Assert.That(other.Sweep, Is.EqualTo(270).Within(1e-12));
        Assert.That(other.PointAt(1).DistanceTo(new Vec3(0, 1)), Is.LessThan(1e-14));
        Assert.That(() => ArcCurve.Through(new Vec3(0, 0), new Vec3(1, 1), new Vec3(2, 2)), Throws.ArgumentException);
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
            var h = (curve.DomainEnd - curve.DomainStart) * 1e-6;
            var t = CurveMaker.Next(random, curve.DomainStart + h, curve.DomainEnd - h);
            if (curve.Spans().Any(s => Math.Abs(s.From - t) <= h)) continue;
            var difference = (curve.PointAt(t + h) - curve.PointAt(t - h)) / (2 * h);
            Assert.That(curve.DerivativeAt(t).DistanceTo(difference), Is.LessThan(1e-5 * (1 + difference.Length)));
        }
    }

    [Test]
    public void Lengths_agree_with_an_independent_quadrature()
    {
        var random = new Random(13);
        for (var n = 0; n < 60; n++)
        {
            var curve = CurveMaker.Nurbs(random);
            var sum = 0.0;
            foreach (var span in curve.Spans()) sum += CurveMaker.LengthByChords(curve.SubCurve(span.From, span.To), 1500);
            var length = ArcLength.Of(curve);
            Assert.That(length.Total, Is.EqualTo(sum).Within(2e-5 * (1 + sum)));
            Assert.That(length.ErrorBound, Is.LessThan(1e-7));
        }
        // A parabola from (-1, 1) to (1, 1): √5 + asinh(2)/2.
        var parabola = NurbsCurve.Clamped(2, [new(-1, 1), new(0, -1), new(1, 1)]);
        Assert.That(parabola.Length, Is.EqualTo(Math.Sqrt(5) + Math.Log(2 + Math.Sqrt(5)) / 2).Within(1e-12));
    }

    [Test]
    public void Length_and_parameter_are_inverse_to_each_other()
    {
        var random = new Random(14);
        for (var n = 0; n < 60; n++)
        {
            Curve curve = n == 0 ? CurveMaker.LineArcLineNurbsLine() : CurveMaker.Nurbs(random);
            var length = ArcLength.Of(curve);
            for (var i = 0; i <= 20; i++)
            {
                var s = length.Total * i / 20;
                Assert.That(length.LengthAt(length.ParameterAt(s)), Is.EqualTo(s).Within(1e-9));
            }
            Assert.That(length.ParameterAt(length.Total + 1), Is.EqualTo(curve.DomainEnd).Within(1e-12));
            Assert.That(length.ParameterAt(-1), Is.EqualTo(curve.DomainStart));
        }
    }

    [Test]
    public void The_closest_point_is_nearer_than_any_sample()
    {
        var random = new Random(15);
        for (var n = 0; n < 60; n++)
        {
            Curve curve = (n % 4) switch
            {
                0 => CurveMaker.LineArcLineNurbsLine(),
                1 => new ArcCurve(Frame.At(CurveMaker.Point(random)).Pitch(n), 5, CurveMaker.Next(random, -360, 360)),
                _ => CurveMaker.Nurbs(random),
            };
            var point = CurveMaker.Point(random, 30);
            var found = curve.ClosestPoint(point);
            Assert.That(found.Point.DistanceTo(curve.PointAt(found.Parameter)), Is.LessThan(1e-9));
            Assert.That(found.Distance, Is.EqualTo(found.Point.DistanceTo(point)).Within(1e-12));
            for (var i = 0; i <= 500; i++)
            {
                var t = curve.DomainStart + (curve.DomainEnd - curve.DomainStart) * i / 500;
                Assert.That(found.Distance, Is.LessThan(curve.PointAt(t).DistanceTo(point) + 1e-9));
            }
        }
    }

    [Test]
    public void Parts_and_reversed_curves_go_through_the_same_points()
    {
        var random = new Random(16);
        for (var n = 0; n < 200; n++)
        {
            Curve curve = (n % 4) switch
            {
                0 => CurveMaker.LineArcLineNurbsLine(),
                1 => new PolylineCurve(Enumerable.Range(0, 6).Select(_ => CurveMaker.Point(random)), closed: true),
                _ => CurveMaker.Nurbs(random),
            };
            var (start, end) = (curve.DomainStart, curve.DomainEnd);
            var cut = CurveMaker.Next(random, start + 0.01 * (end - start), start + 0.99 * (end - start));
            var (before, after) = curve.Split(cut);
            Assert.That(before.Start.DistanceTo(curve.Start), Is.LessThan(1e-9));
            Assert.That(before.End.DistanceTo(curve.PointAt(cut)), Is.LessThan(1e-9));
            Assert.That(after.Start.DistanceTo(curve.PointAt(cut)), Is.LessThan(1e-9));
            Assert.That(after.End.DistanceTo(curve.End), Is.LessThan(1e-9));
            Assert.That(before.Length + after.Length, Is.EqualTo(curve.Length).Within(1e-7));
            var reversed = curve.Reversed();
            for (var i = 0; i <= 10; i++)
            {
                var t = start + (end - start) * i / 10;
                Assert.That(reversed.PointAt(start + end - t).DistanceTo(curve.PointAt(t)), Is.LessThan(1e-9));
            }
            Assert.That(reversed.Length, Is.EqualTo(curve.Length).Within(1e-7));
        }
    }

    [Test]
    public void A_part_of_a_nurbs_curve_keeps_its_parameters()
    {
        var random = new Random(17);
        for (var n = 0; n < 200; n++)
        {
            var curve = CurveMaker.Nurbs(random);
            var a = CurveMaker.Next(random, curve.DomainStart, curve.DomainEnd);
            var b = CurveMaker.Next(random, curve.DomainStart, curve.DomainEnd);
            if (Math.Abs(a - b) < 1e-3) continue;
            var part = curve.SubCurve(Math.Min(a, b), Math.Max(a, b));
            for (var i = 0; i <= 10; i++)
            {
                var t = part.DomainStart + (part.DomainEnd - part.DomainStart) * i / 10;
                Assert.That(part.PointAt(t).DistanceTo(curve.PointAt(t)), Is.LessThan(1e-8));
            }
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
            foreach (var span in curve.Spans())
                Assert.That(mapped.PointAt(span.From).DistanceTo(map.Apply(curve.PointAt(span.From))), Is.LessThan(1e-9));
            Assert.That(mapped.End.DistanceTo(map.Apply(curve.End)), Is.LessThan(1e-9));
        }
    }

    [Test]
    public void Kinks_are_found_where_the_direction_jumps()
    {
        // The last line leaves the NURBS curve at a right angle; the other joints are tangent.
        Assert.That(CurveMaker.LineArcLineNurbsLine().Kinks(), Is.EqualTo(new[] { 4.0 }));
        Assert.That(NurbsCurve.Periodic(3, [new(0, 0), new(4, 0), new(4, 4), new(0, 4)]).Kinks(), Is.Empty);
        // A double knot of degree 2 is a corner.
        var corner = new NurbsCurve(2, [new(0, 0), new(1, 0), new(2, 0), new(2, 1), new(2, 2)], [0, 0, 0, 1, 1, 2, 2, 2]);
        Assert.That(corner.Kinks(), Is.EqualTo(new[] { 1.0 }));
    }

    [Test]
    public void A_periodic_curve_closes_smoothly()
    {
        var curve = NurbsCurve.Periodic(3, [new(0, 0), new(4, 0), new(4, 4), new(0, 4, 2), new(-1, 2)]);
        Assert.That(curve.IsClosed, Is.True);
        Assert.That(curve.TangentAt(curve.DomainStart).DistanceTo(curve.TangentAt(curve.DomainEnd)), Is.LessThan(1e-12));
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
        var line = new LineCurve(new Vec3(0, 0), new Vec3(1, 0));
        Assert.That(() => new PolyCurve([line, new LineCurve(new Vec3(1.1, 0), new Vec3(2, 0))]), Throws.ArgumentException);
        Assert.That(() => new PolyCurve([]), Throws.ArgumentException);
        var joined = new PolyCurve([line, new PolyCurve([new LineCurve(new Vec3(1, 0), new Vec3(2, 0))])]);
        Assert.That(joined.Pieces, Has.Count.EqualTo(2));
        Assert.That(joined.PointAt(1.5), Is.EqualTo(new Vec3(1.5, 0)));
    }
}
