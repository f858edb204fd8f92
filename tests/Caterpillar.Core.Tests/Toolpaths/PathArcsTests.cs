using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

public class PathArcsTests
{
    private static readonly Bead Thin = new(0.1, 0.2, 20);
    private static readonly Bead Thick = new(0.2, 0.2, 20);

    [Test]
    public void A_polygon_on_a_circle_becomes_arcs()
    {
        var path = new PrintPath(OnCircle(new Vec3(10, 20, 1), 5, 0, 360, 72).Take(72), Thin, closed: true);
        var fitted = PathArcs.Fit(path);
        Assert.That(fitted.IsClosed, Is.True);
        Assert.That(fitted.SegmentCount, Is.EqualTo(2));
        Assert.That(fitted.ArcOf(0)!.Value.Center.DistanceTo(new Vec3(10, 20)), Is.LessThan(1e-9));
        Assert.That(fitted.ArcOf(0)!.Value.Sweep + fitted.ArcOf(1)!.Value.Sweep, Is.EqualTo(360).Within(1e-9));
        Assert.That(fitted.Length, Is.EqualTo(10 * Math.PI).Within(1e-9));
        Assert.That(fitted.BeadOf(1), Is.EqualTo(Thin));
    }

    [Test]
    public void A_helix_becomes_helical_arcs()
    {
        var points = Enumerable.Range(0, 145).Select(i =>
        {
            var (sin, cos) = Angle.SinCos(-5 * i);
            return new Vec3(8 * cos, 8 * sin, i * 0.01);
        });
        var fitted = PathArcs.Fit(new PrintPath(points, Thin));
        Assert.That(fitted.SegmentCount, Is.EqualTo(3));
        Assert.That(Enumerable.Range(0, 3).Sum(i => fitted.ArcOf(i)!.Value.Sweep), Is.EqualTo(-720).Within(1e-9));
        Assert.That(fitted.End.Z, Is.EqualTo(1.44).Within(1e-12));
    }

    [Test]
    public void A_change_of_the_bead_ends_an_arc()
    {
        var points = OnCircle(Vec3.Zero, 5, 0, 180, 36);
        var fitted = PathArcs.Fit(new PrintPath(points, Thin).WithBeads(i => i < 20 ? Thin : Thick));
        Assert.That(fitted.SegmentCount, Is.EqualTo(2));
        Assert.That(fitted.EndOf(0), Is.EqualTo(points[20]));
        Assert.That(fitted.BeadOf(0), Is.EqualTo(Thin));
        Assert.That(fitted.BeadOf(1), Is.EqualTo(Thick));
    }

    [Test]
    public void Corners_and_straight_lines_stay()
    {
        var path = new PrintPath([new(0, 0), new(10, 0), new(10, 10), new(0, 10)], Thin, closed: true);
        Assert.That(PathArcs.Fit(path), Is.SameAs(path));
        var line = new PrintPath(Enumerable.Range(0, 50).Select(i => new Vec3(i, 0)), Thin);
        Assert.That(PathArcs.Fit(line).HasArcs, Is.False);
        // A regular hexagon is not a circle unless the tolerance allows it.
        var hexagon = new PrintPath(OnCircle(Vec3.Zero, 5, 0, 360, 6).Take(6), Thin, closed: true);
        Assert.That(PathArcs.Fit(hexagon).HasArcs, Is.False);
        Assert.That(PathArcs.Fit(hexagon, 0.7).HasArcs, Is.True);
    }

    [Test]
    public void Fitted_arcs_keep_within_the_tolerance_on_a_thousand_random_polylines()
    {
        var random = new Random(31);
        var arcs = 0;
        for (var n = 0; n < 1000; n++)
        {
            var tolerance = 0.005 + 0.05 * random.NextDouble();
            var path = RandomPath(random, tolerance);
            var fitted = PathArcs.Fit(path, tolerance);
            Assert.That(fitted.Start, Is.EqualTo(path.Start));
            Assert.That(fitted.End, Is.EqualTo(path.End));
            var at = 0;
            for (var i = 0; i < fitted.SegmentCount; i++)
            {
                var from = at;
                do at++;
                while (path.EndOf(at - 1) != fitted.EndOf(i));
                if (fitted.ArcOf(i) is not { } arc) continue;
                arcs++;
                var radius = arc.Radius(fitted.Points[i]);
                var turned = 0.0;
                for (var k = from; k < at; k++)
                {
                    if (path.BeadOf(k) != fitted.BeadOf(i)) Assert.Fail($"path {n}, segment {k}: another bead");
                    var (p, q) = (path.Points[k] - arc.Center, path.EndOf(k) - arc.Center);
                    // At the vertices and the middles, where it is tested, the tolerance holds; between them the flat of a chord may lie a little nearer to the
                    // center.
                    var off = Math.Max(Math.Abs(q.LengthXY - radius), Math.Abs((0.5 * (p + q)).LengthXY - radius));
                    var between = 0.0;
                    for (var share = 0.125; share < 1; share += 0.125) between = Math.Max(between, Math.Abs((p + (q - p) * share).LengthXY - radius));
                    if (!(off < tolerance + 1e-9 && between < tolerance * 1.2)) Assert.Fail($"path {n}, segment {k}: {off} and {between} mm off the arc");
                    turned += Angle.Atan2(p.X * q.Y - p.Y * q.X, p.X * q.X + p.Y * q.Y);
                    var height = fitted.Points[i].Z + (fitted.EndOf(i).Z - fitted.Points[i].Z) * turned / arc.Sweep;
                    if (!(Math.Abs(height - path.EndOf(k).Z) < tolerance + 1e-9)) Assert.Fail($"path {n}, segment {k}: {height} is another height");
                }
                Assert.That(turned, Is.EqualTo(arc.Sweep).Within(1e-9));
            }
            Assert.That(at, Is.EqualTo(path.SegmentCount));
        }
        Assert.That(arcs, Is.GreaterThan(500));
    }

    [Test]
    public void Arcs_become_chords_within_the_tolerance()
    {
        var path = new PrintPath([new(5, 0), new(-5, 0, 2), new(-5, 10, 2)], [Thin, Thick], arcs: [new Arc(Vec3.Zero, 180), null]);
        var chords = PathArcs.Expand(path, 0.01);
        Assert.That(chords.HasArcs, Is.False);
        Assert.That(chords.SegmentCount, Is.EqualTo(path.ArcOf(0)!.Value.ChordCount(path.Start, 0.01) + 1));
        for (var i = 0; i + 1 < chords.SegmentCount; i++)
        {
            Assert.That(chords.BeadOf(i), Is.EqualTo(Thin));
            Assert.That(Math.Abs(Vec3.Lerp(chords.Points[i], chords.EndOf(i), 0.5).LengthXY - 5), Is.LessThan(0.01));
        }
        Assert.That(chords.BeadOf(chords.SegmentCount - 1), Is.EqualTo(Thick));
        Assert.That(chords.Bounds.Max.Z, Is.EqualTo(2));
    }

    [Test]
    public void A_circle_of_two_arcs_survives_expansion_to_chords_and_refitting()
    {
        var circle = new PrintPath([new(5, 0, 1), new(-5, 0, 1)], [Thin, Thin], true, [new Arc(Vec3.Zero, 180), new Arc(Vec3.Zero, 180)]);
        var chords = PathArcs.Expand(circle, 0.002);
        Assert.That(chords.IsClosed, Is.True);
        var back = PathArcs.Fit(chords, 0.01);
        Assert.That(back.SegmentCount, Is.EqualTo(2));
        Assert.That(back.Length, Is.EqualTo(circle.Length).Within(1e-3));
        Assert.That(PathArcs.Expand(circle, 100).SegmentCount, Is.GreaterThanOrEqualTo(3));
    }

    [Test]
    public void Options_out_of_range_are_refused()
    {
        var path = new PrintPath([new(0, 0), new(1, 0)], Thin);
        Assert.That(() => PathArcs.Fit(path, 0), Throws.ArgumentException);
        Assert.That(() => PathArcs.Expand(path, double.NaN), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    private static List<Vec3> OnCircle(Vec3 center, double radius, double from, double to, int parts)
        => [.. Enumerable.Range(0, parts + 1).Select(i =>
        {
            var (sin, cos) = Angle.SinCos(from + (to - from) * i / parts);
            return center + new Vec3(radius * cos, radius * sin);
        })];

    // Arcs, helices, lines and random walks joined, with some noise and some changes of the bead.
    private static PrintPath RandomPath(Random random, double tolerance)
    {
        var points = new List<Vec3> { new(0, 0, 1) };
        for (var piece = random.Next(1, 4); piece > 0; piece--)
        {
            var start = points[points.Count - 1];
            var noise = random.Next(3) == 0 ? 0 : tolerance * random.NextDouble();
            if (random.Next(3) == 0)
            {
                for (var i = 0; i < 6; i++) points.Add(start += new Vec3(random.NextDouble() * 4 - 2, random.NextDouble() * 4 - 2));
                continue;
            }
            var radius = 1 + 20 * random.NextDouble();
            var rise = random.Next(2) == 0 ? 0 : random.NextDouble() * 3;
            var sweep = (random.NextDouble() - 0.5) * 700;
            var parts = random.Next(3, 80);
            var from = random.NextDouble() * 360;
            var (sin, cos) = Angle.SinCos(from);
            var center = start - new Vec3(radius * cos, radius * sin);
            for (var i = 1; i <= parts; i++)
            {
                (sin, cos) = Angle.SinCos(from + sweep * i / parts);
                var r = radius + noise * (2 * random.NextDouble() - 1);
                points.Add(center + new Vec3(r * cos, r * sin, rise * i / parts));
            }
        }
        var change = random.Next(points.Count * 2);
        return new PrintPath(points, Thin).WithBeads(i => i < change ? Thin : Thick);
    }
}
