using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry.Curves;

public class SubdivisionTests
{
    [Test]
    public void Linear_parts_keep_only_their_end_points()
    {
        var curve = CurveMaker.LineArcLineNurbsLine();
        var divided = CurveSubdivider.Subdivide(curve, SubdivisionOptions.ByDistance(1));
        var linear = Enumerable.Range(0, divided.SegmentCount).Where(divided.IsLinear).Select(i => (divided.Points[i], divided.EndOf(i))).ToArray();
        Assert.That(linear, Is.EqualTo(new[]
        {
            (new Vec3(0, 0), new Vec3(10, 0)),
            (curve.PointAt(2), new Vec3(15, 15)),
            (curve.PointAt(4), new Vec3(30, 0, 4)),
        }));
        // The arc of 7.854 mm has 8 equal parts, the NURBS curve as many as its length asks for.
        var nurbs = curve.Pieces[3].Length;
        Assert.That(divided.SegmentCount, Is.EqualTo(3 + 8 + Math.Ceiling(nurbs)));
        Assert.That(divided.IsClosed, Is.False);
        Assert.That(divided.Points[divided.Points.Count - 1], Is.EqualTo(curve.End));
    }

    [Test]
    public void Kept_arcs_stay_one_segment()
    {
        var options = SubdivisionOptions.ByDistance(1) with { KeepArcs = true };
        var divided = CurveSubdivider.Subdivide(CurveMaker.LineArcLineNurbsLine(), options);
        Assert.That(divided.RawArcs![0], Is.Null);
        var arc = divided.RawArcs![1]!.Value;
        Assert.That(arc.Center, Is.EqualTo(new Vec3(10, 5)));
        Assert.That(arc.Sweep, Is.EqualTo(90));
        Assert.That(arc.Radius(divided.Points[1]), Is.EqualTo(5).Within(1e-12));

        var circle = CurveSubdivider.Subdivide(ArcCurve.Circle(new Vec3(0, 0, 1), 2), options);
        Assert.That(circle.IsClosed, Is.True);
        Assert.That(circle.SegmentCount, Is.EqualTo(2));
        Assert.That(circle.RawArcs![1]!.Value.Sweep, Is.EqualTo(180));

        var below = new ArcCurve(Frame.World.Roll(180), 2, 90);
        Assert.That(CurveSubdivider.Subdivide(below, options).RawArcs![0]!.Value.Sweep, Is.EqualTo(-90));
        var upright = new ArcCurve(Frame.World.Roll(90), 2, 90);
        Assert.That(CurveSubdivider.Subdivide(upright, options).RawArcs, Is.Null);
    }

    [Test]
    public void Collinear_runs_of_a_polyline_keep_their_ends()
    {
        var points = new List<Vec3>();
        for (var i = 0; i <= 1000; i++) points.Add(new Vec3(i * 0.1, 0));
        for (var i = 1; i <= 777; i++) points.Add(new Vec3(100, i * 0.3, i * 0.01));
        var divided = CurveSubdivider.Subdivide(new PolylineCurve(points), SubdivisionOptions.ByDistance(1));
        Assert.That(divided.Points, Is.EqualTo(new[] { points[0], points[1000], points[points.Count - 1] }));
    }

    [Test]
    public void A_polyline_that_turns_back_keeps_the_turn()
    {
        var divided = CurveSubdivider.Subdivide(new PolylineCurve([new(0, 0), new(5, 0), new(5, 0), new(3, 0), new(8, 0)]), SubdivisionOptions.ByDistance(1));
        Assert.That(divided.Points, Is.EqualTo(new Vec3[] { new(0, 0), new(5, 0), new(3, 0), new(8, 0) }));
    }

    [Test]
    public void Long_straight_runs_are_found_completely_on_random_polylines()
    {
        var random = new Random(21);
        for (var n = 0; n < 200; n++)
        {
            var corners = Enumerable.Range(0, random.Next(2, 8)).Select(_ => CurveMaker.Point(random)).ToArray();
            var points = new List<Vec3> { corners[0] };
            for (var i = 1; i < corners.Length; i++)
            {
                var parts = random.Next(1, 40);
                for (var k = 1; k < parts; k++) points.Add(Vec3.Lerp(corners[i - 1], corners[i], (double)k / parts));
                points.Add(corners[i]);
            }
            Assert.That(CurveSubdivider.Subdivide(new PolylineCurve(points), SubdivisionOptions.ByDistance(1)).Points, Is.EqualTo(corners));
        }
    }

    [Test]
    public void Straight_spans_of_a_nurbs_curve_are_linear()
    {
        // Degree 3 with five collinear control points at each end.
        var curve = NurbsCurve.Clamped(3,
            [new(0, 0), new(2, 0), new(4, 0), new(6, 0), new(8, 0), new(10, 3), new(10, 6), new(10, 8), new(10, 10), new(10, 12)]);
        var divided = CurveSubdivider.Subdivide(curve, SubdivisionOptions.ByDistance(0.5));
        Assert.That(divided.IsLinear(0), Is.True);
        Assert.That(divided.IsLinear(divided.SegmentCount - 1), Is.True);
        Assert.That(Enumerable.Range(0, divided.SegmentCount).Count(divided.IsLinear), Is.EqualTo(2));
        // The spans that only the first four, and the first five, control points shape.
        Assert.That(divided.Points[1].DistanceTo(curve.PointAt(2)), Is.LessThan(1e-9));
        var polyline = NurbsCurve.Clamped(1, [new(0, 0), new(1, 0), new(2, 0), new(2, 5)]);
        Assert.That(CurveSubdivider.Subdivide(polyline, SubdivisionOptions.ByDistance(0.1)).Points, Is.EqualTo(new Vec3[] { new(0, 0), new(2, 0), new(2, 5) }));
    }

    [Test]
    public void Spacing_and_chord_error_hold_on_a_thousand_random_curves()
    {
        var random = new Random(22);
        for (var n = 0; n < 1000; n++)
        {
            var curve = CurveMaker.Nurbs(random);
            var distance = CurveMaker.Next(random, 0.5, 5);
            var tolerance = CurveMaker.Next(random, 0.01, 0.2);
            var options = (n % 3) switch
            {
                0 => SubdivisionOptions.ByDistance(distance),
                1 => SubdivisionOptions.ByTolerance(tolerance),
                _ => SubdivisionOptions.ByTolerance(tolerance) with { MaxLength = distance },
            };
            if (random.Next(4) == 0) options = options with { EqualDivision = false };
            var divided = CurveSubdivider.Subdivide(curve, options);
            Check(curve, divided, options);
        }
    }

    [Test]
    public void Extreme_weights_and_coincident_points_keep_the_chord_error()
    {
        var random = new Random(25);
        for (var n = 0; n < 150; n++)
        {
            var degree = random.Next(1, 6);
            var size = Math.Pow(10, random.Next(-1, 3));
            var points = new List<Vec3>();
            for (var i = random.Next(degree + 1, degree + 7); i > 0; i--) points.Add(points.Count > 0
                && random.Next(4) == 0 ? points[points.Count - 1] : CurveMaker.Point(random, size));
            var curve = NurbsCurve.Clamped(degree, points, points.ConvertAll(_ => Math.Pow(10, 4 * random.NextDouble() - 2)));
            var options = SubdivisionOptions.ByTolerance(size * 0.004) with { EqualDivision = n % 2 == 0 };
            Check(curve, CurveSubdivider.Subdivide(curve, options), options);
        }
    }

    [Test]
    public void Every_kink_is_a_point()
    {
        var random = new Random(23);
        for (var n = 0; n < 40; n++)
        {
            var pieces = new List<Curve>();
            var at = CurveMaker.Point(random);
            for (var i = 0; i < 4; i++)
            {
                Curve piece = random.Next(2) == 0 ? CurveMaker.Nurbs(random) : new ArcCurve(Frame.At(at), 3, 108);
                piece = piece.Transformed(Affine.Move(at - piece.Start));
                pieces.Add(piece);
                at = piece.End;
            }
            var curve = new PolyCurve(pieces);
            var divided = CurveSubdivider.Subdivide(curve, SubdivisionOptions.ByDistance(2.5));
            foreach (var kink in CurveMaker.Kinks(curve, 1)) Assert.That(divided.Points.Min(p => p.DistanceTo(kink)), Is.LessThan(1e-8));
        }
    }

    [Test]
    public void Equal_division_leaves_no_remainder_and_full_steps_do()
    {
        var arc = new ArcCurve(Frame.World, 10, 90);
        var equal = CurveSubdivider.Subdivide(arc, SubdivisionOptions.ByDistance(2));
        Assert.That(equal.SegmentCount, Is.EqualTo(8));
        for (var i = 0; i < 8; i++) Assert.That(equal.Points[i].DistanceTo(equal.EndOf(i)),
            Is.EqualTo(equal.Points[0].DistanceTo(equal.Points[1])).Within(1e-9));
        var walk = CurveSubdivider.Subdivide(arc, SubdivisionOptions.ByDistance(2) with { EqualDivision = false });
        Assert.That(walk.SegmentCount, Is.EqualTo(8));
        // Seven steps of 2 mm on 15.708 mm.
        Assert.That(10 * Math.Atan2(walk.Points[7].Y, walk.Points[7].X), Is.EqualTo(14).Within(1e-9));
    }

    [Test]
    public void By_angle_every_segment_turns_as_much()
    {
        var divided = CurveSubdivider.Subdivide(new ArcCurve(Frame.World, 10, 90), new SubdivisionOptions { Angle = 10 });
        Assert.That(divided.SegmentCount, Is.EqualTo(10));
        var ellipse = ArcCurve.Circle(Vec3.Zero, 10).Transformed(Affine.Scale(3, 1, 1));
        var turned = CurveSubdivider.Subdivide(ellipse, new SubdivisionOptions { Angle = 5 });
        Assert.That(turned.IsClosed, Is.True);
        Assert.That(turned.SegmentCount, Is.InRange(72, 80));
    }

    [Test]
    public void No_segment_is_shorter_than_the_minimum()
    {
        var random = new Random(24);
        for (var n = 0; n < 12; n++)
        {
            var curve = NurbsCurve.Periodic(3, [.. Enumerable.Range(0, 6).Select(_ => CurveMaker.Point(random))]);
            var options = SubdivisionOptions.ByTolerance(0.001) with { MinLength = 0.8, EqualDivision = n % 2 == 0 };
            var divided = CurveSubdivider.Subdivide(curve, options);
            var step = (curve.DomainEnd - curve.DomainStart) / 20_000;
            var samples = Enumerable.Range(0, 20_001).Select(i => curve.PointAt(curve.DomainStart + step * i)).ToList();
            var places = divided.Points.Select(p => PlaceOf(p, samples)).ToList();
            for (var i = 1; i < places.Count - 1; i++)
            {
                if (divided.Points[i].DistanceTo(divided.Points[i + 1]) < 0.3) Assert.That(places[i + 1] - places[i], Is.GreaterThan(0.79));
            }
        }
    }

    [Test]
    public void A_closed_curve_keeps_its_seam_and_is_at_least_a_triangle()
    {
        var circle = ArcCurve.Circle(new Vec3(3, 3), 0.1);
        var divided = CurveSubdivider.Subdivide(circle, SubdivisionOptions.ByDistance(5));
        Assert.That(divided.IsClosed, Is.True);
        Assert.That(divided.SegmentCount, Is.EqualTo(3));
        Assert.That(divided.Points[0], Is.EqualTo(circle.Start));
        // The seam in the middle of a side stays.
        var square = new PolylineCurve([new(1, 0), new(2, 0), new(2, 2), new(0, 2), new(0, 0)], closed: true);
        Assert.That(CurveSubdivider.Subdivide(square, SubdivisionOptions.ByDistance(1)).Points, Has.Count.EqualTo(5));
        // A point on the segment back to it is dropped.
        var five = new PolylineCurve([new(0, 0), new(2, 0), new(2, 2), new(0, 2), new(0, 1)], closed: true);
        Assert.That(CurveSubdivider.Subdivide(five, SubdivisionOptions.ByDistance(1)).Points, Has.Count.EqualTo(4));
    }

    [Test]
    public void Requests_out_of_range_are_refused()
    {
        var line = new PolylineCurve([Vec3.Zero, Vec3.UnitX]);
        Assert.That(() => CurveSubdivider.Subdivide(line, new SubdivisionOptions()), Throws.ArgumentException);
        Assert.That(() => CurveSubdivider.Subdivide(line, SubdivisionOptions.ByDistance(-1)), Throws.ArgumentException);
        Assert.That(() => CurveSubdivider.Subdivide(line, SubdivisionOptions.ByDistance(double.NaN)), Throws.ArgumentException);
        Assert.That(() => CurveSubdivider.Subdivide(line, new SubdivisionOptions { MaxLength = 1, MinLength = 2 }), Throws.ArgumentException);
    }

    // Walks over the curve in small steps and along with it over the segments.
    internal static void Check(NurbsCurve curve, Subdivision divided, SubdivisionOptions options)
    {
        var limit = options.Distance > 0 ? options.Distance : options.MaxLength;
        for (var i = 0; i < divided.SegmentCount && limit > 0; i++)
        {
            if (divided.IsLinear(i)) continue;
            var step = divided.Points[i].DistanceTo(divided.EndOf(i));
            if (!(step < limit * (1 + 1e-9))) Assert.Fail($"segment {i} is {step} mm long, the limit is {limit}");
        }
        var length = curve.Length;
        if (options.Distance > 0) Assert.That(divided.SegmentCount, Is.InRange(1, length / limit + curve.Spans().Count));
        if (options.ChordTolerance == 0) return;
        var samples = 8 * (divided.SegmentCount + 2 * curve.Spans().Count);
        var segment = 0;
        for (var k = 0; k <= samples; k++)
        {
            var point = curve.PointAt(curve.DomainStart + (curve.DomainEnd - curve.DomainStart) * k / samples);
            var nearest = double.MaxValue;
            for (var i = segment; i < Math.Min(divided.SegmentCount, segment + 200) && nearest >= options.ChordTolerance; i++)
            {
                nearest = Math.Min(nearest, Distance(point, divided.Points[i], divided.EndOf(i)));
                if (nearest < options.ChordTolerance) segment = i;
            }
            if (!(nearest < options.ChordTolerance)) Assert.Fail($"{point} is {nearest} mm from the chords, the tolerance is {options.ChordTolerance}");
        }
    }

    // Length of the samples up to the one nearest to a point.
    private static double PlaceOf(Vec3 point, List<Vec3> samples)
    {
        double sum = 0, place = 0, best = double.MaxValue;
        for (var i = 0; i < samples.Count; i++)
        {
            if (i > 0) sum += samples[i].DistanceTo(samples[i - 1]);
            var distance = samples[i].DistanceTo(point);
            if (distance < best) (best, place) = (distance, sum);
        }
        return place;
    }

    private static double Distance(Vec3 p, Vec3 a, Vec3 b)
    {
        var d = b - a;
        var t = a == b ? 0 : Vec3.Dot(p - a, d) / d.LengthSquared;
        return p.DistanceTo(a + d * Math.Min(Math.Max(t, 0), 1));
    }

    [TestCase(1e-9, 0, 0)]
    [TestCase(0, 1e-300, 0)]
    [TestCase(0, 0, 1e-9)]
    public void A_division_without_end_is_refused_in_a_sentence(double distance, double tolerance, double angle)
    {
        var options = new SubdivisionOptions { Distance = distance, ChordTolerance = tolerance, Angle = angle };
        foreach (var equal in new[] { true, false })
        {
            Assert.That(
                () => CurveSubdivider.Subdivide(CurveMaker.LineArcLineNurbsLine(), options with { EqualDivision = equal }),
                Throws.TypeOf<SubdivisionLimitException>().With.Message.Contains("more than 5000000 points"));
        }
    }

    [Test]
    public void A_curve_as_long_as_a_continent_is_refused_at_once()
    {
        var far = new NurbsCurve(2, [new(0, 0), new(1e9, 1e9), new(2e9, 0)], [0, 0, 0, 1, 1, 1]);
        Assert.That(() => CurveSubdivider.Subdivide(far, SubdivisionOptions.ByDistance(0.01)), Throws.TypeOf<SubdivisionLimitException>());
    }

    [Test]
    public void A_long_division_hears_a_cancel()
    {
        var arc = new NurbsCurve(2, [new(0, 0), new(1e4, 1e4), new(2e4, 0)], [0, 0, 0, 1, 1, 1]);
        using var stop = new CancellationTokenSource();
        stop.Cancel();
        Assert.That(() => CurveSubdivider.Subdivide(arc, SubdivisionOptions.ByDistance(0.01), stop.Token), Throws.InstanceOf<OperationCanceledException>());
    }
}
