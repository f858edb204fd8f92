using System;
using System.Linq;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry;

public class RegionLineTests
{
    private static readonly Region Ring = Region.Rectangle(0, 0, 30, 30).Subtract(Region.Rectangle(10, 10, 20, 20));

    private static Polyline Line(params double[] xyz)
        => new(Enumerable.Range(0, xyz.Length / 3).Select(i => new Vec3(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2])));

    [Test]
    public void A_line_through_a_hole_gives_its_parts_with_their_heights()
    {
        var inside = Ring.ClipLines(new[] { Line(-10, 15, 0, 40, 15, 50) });
        Assert.That(inside, Has.Count.EqualTo(2));
        Assert.That(inside[0].Points, Is.EqualTo(new[] { new Vec3(0, 15, 10), new Vec3(10, 15, 20) }).Using<Vec3, Vec3>((p, q) => p.DistanceTo(q) < 1e-9));
        Assert.That(inside[1].Length, Is.EqualTo(Math.Sqrt(200)).Within(1e-9));
        var outside = Ring.ClipLines(new[] { Line(-10, 15, 0, 40, 15, 50) }, outside: true);
        Assert.That(outside.Select(p => p.Points.Last().X - p[0].X), Is.EqualTo(new[] { 10.0, 10, 10 }).Within(1e-9));
    }

    [Test]
    public void A_line_along_the_boundary_is_inside()
    {
        var pieces = Ring.ClipLines(new[] { Line(-5, 0, 0, 35, 0, 0), Line(0, 20, 1, 30, 20, 1) });
        Assert.That(pieces, Has.Count.EqualTo(2));
        Assert.That(pieces.Select(p => p.Length), Is.EqualTo(new[] { 30.0, 30 }).Within(1e-9));
        Assert.That(pieces[1].Count, Is.EqualTo(2));
    }

    [Test]
    public void A_line_is_contained_when_all_of_it_is()
    {
        Assert.That(Ring.ContainsLine(new Vec3(1, 1), new Vec3(29, 1)));
        Assert.That(Ring.ContainsLine(new Vec3(0, 0), new Vec3(30, 0)), "along the boundary");
        Assert.That(Ring.ContainsLine(new Vec3(10, 0), new Vec3(10, 30)), "along a hole");
        Assert.That(Ring.ContainsLine(new Vec3(1, 15), new Vec3(29, 15)), Is.False, "through the hole");
        Assert.That(Ring.ContainsLine(new Vec3(12, 12), new Vec3(18, 18)), Is.False, "in the hole");
        Assert.That(Ring.ContainsLine(new Vec3(-1, 5), new Vec3(5, 5)), Is.False, "from outside");
        Assert.That(Ring.ContainsLine(new Vec3(5, 5), new Vec3(5, 5)) && !Region.Empty.ContainsLine(Vec3.Zero, Vec3.UnitX));
    }

    [Test]
    public void Closed_lines_stay_closed_or_are_joined_across_their_start()
    {
        var whole = new Polyline(new[] { new Vec3(1, 1), new Vec3(9, 1), new Vec3(9, 9), new Vec3(1, 9) }, closed: true);
        Assert.That(Ring.ClipLines(new[] { whole }).Single(), Is.SameAs(whole));
        var cut = new Polyline(new[] { new Vec3(5, 5), new Vec3(15, 5), new Vec3(15, 15), new Vec3(5, 15) }, closed: true);
        var piece = Ring.ClipLines(new[] { cut }).Single();
        Assert.That(piece.IsClosed, Is.False);
        Assert.That(piece.Length, Is.EqualTo(30).Within(1e-9));
        Assert.That(Ring.ClipLines(new[] { cut }, outside: true).Single().Length, Is.EqualTo(10).Within(1e-9));
    }

    [Test]
    public void Inside_and_outside_make_the_whole_and_lie_where_they_should()
    {
        var random = new Random(8);
        for (var k = 0; k < 60; k++)
        {
            var region = Region.From(RegionReference.Star(random, 50, 0, 0, 3, 10));
            var lines = Enumerable.Range(0, 20).Select(_ => RegionReference.Random(random, 6, 22))
                .Select(p => new Polyline(p.Points.Select(q => q - new Vec3(11, 11)))).ToArray();
            var inside = region.ClipLines(lines);
            var outside = region.ClipLines(lines, outside: true);
            Assert.That(inside.Sum(p => p.Length) + outside.Sum(p => p.Length), Is.EqualTo(lines.Sum(p => p.Length)).Within(1e-6));
            foreach (var p in inside.Where(p => p.Length > 1e-3)) Assert.That(region.Contains(Vec3.Lerp(p[0], p[1], 0.5).X, Vec3.Lerp(p[0], p[1], 0.5).Y));
            foreach (var p in outside.Where(p => p.Length > 1e-3)) Assert.That(region.Contains(Vec3.Lerp(p[0], p[1], 0.5).X, Vec3.Lerp(p[0], p[1], 0.5).Y),
                Is.False);
        }
    }

    [Test]
    public void Hatch_lines_of_a_ring_are_where_the_formula_puts_them()
    {
        var lines = Ring.HatchLines(0, 5, 2.5);
        Assert.That(lines, Has.Count.EqualTo(8));
        Assert.That(lines[0].From, Is.EqualTo(new Vec3(0, 2.5)));
        Assert.That(lines[0].To, Is.EqualTo(new Vec3(30, 2.5)));
        Assert.That(lines[0].Row, Is.Zero);
        Assert.That(lines.Where(l => l.Row == 2).Select(l => l.To.X - l.From.X), Is.EqualTo(new[] { 10.0, 10 }));
        // At 90 degrees "left" is -X.
        Assert.That(Ring.HatchLines(90, 5, -2.5)[0].From.X, Is.EqualTo(27.5).Or.EqualTo(2.5));
        Assert.That(Ring.HatchLines(90, 5).All(l => l.From.X == l.To.X && l.From.Y < l.To.Y));
        Assert.That(Region.Empty.HatchLines(0, 1), Is.Empty);
    }

    [TestCase(0)]
    [TestCase(30)]
    [TestCase(45)]
    [TestCase(90)]
    [TestCase(137.3)]
    public void Hatch_length_times_spacing_is_the_area(double angle)
    {
        var random = new Random(2);
        for (var k = 0; k < 10; k++)
        {
            var region = Region.From(new[] { RegionReference.Star(random, 40, 3, -2, 4, 10), RegionReference.Star(random, 10, 1, 1, 1, 3) }, FillRule.EvenOdd);
            var sum = region.HatchLines(angle, 0.01, 0.003).Sum(l => l.From.DistanceTo(l.To)) * 0.01;
            Assert.That(sum, Is.EqualTo(region.Area).Within(1e-3 * region.Area));
            foreach (var line in region.HatchLines(angle, 0.5, 0.1))
            {
                var middle = Vec3.Lerp(line.From, line.To, 0.5);
                Assert.That(region.Contains(middle.X, middle.Y));
            }
        }
    }
}
