using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Slicing;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing.Infill;

public class InfillTurnTests
{
    private static readonly double Diagonal = Math.Sqrt(0.5);

    [Test]
    public void Rows_at_a_right_angle_keep_their_corners()
    {
        var points = Join(Region.Rectangle(0, 0, 10, 10), 1, Row(0, 4, 10, 4), Row(0, 5, 10, 5)).Single();
        Assert.That(Corners(points), Is.EquivalentTo(new[] { (0, 4), (10, 4), (10, 5), (0, 5) }));
    }

    [TestCase(1)]
    [TestCase(0.5)]
    public void Slanting_rows_leave_early_and_meet_the_boundary_at_a_right_angle(double width)
    {
        // At 45°, left 0.9 widths before the end, with the foot below; the acute corner at 2 stays.
        var leave = 0.9 * width * Diagonal;
        var line = Join(Region.Rectangle(0, 0, 20, 10), width, Row(2, 0, 12, 10), Row(4, 0, 14, 10)).Single();
        Expect(line, new(12, 10), new(2, 0), new(4 + leave, 0), new(4 + leave, leave), new(14, 10));
        Assert.That(line.Flow, Is.EquivalentTo(new[] { 1, 1, 0.5, 1 }));
        Assert.That(line.Flow![line.Points[0].X < 13 ? 2 : 1], Is.EqualTo(0.5));
    }

    [Test]
    public void Without_a_width_the_corners_stay()
    {
        var points = Join(Region.Rectangle(0, 0, 20, 10), 0, Row(2, 0, 12, 10), Row(4, 0, 14, 10)).Single();
        Expect(points, new(12, 10), new(2, 0), new(4, 0), new(14, 10));
    }

    [Test]
    public void Rows_that_are_not_seen_end_early_where_they_turn_back_sharply()
    {
        var area = Region.Rectangle(0, 0, 20, 10);
        var line = new BoundaryLinks().Join(area, [Row(2, 0, 12, 10), Row(4, 0, 14, 10), Row(6, 0, 16, 10)], 2.1, early: 0.5).Single();
        var early = 0.5 * Diagonal;
        Expect(line, new(12, 10), new(2 + early, early), new(4, 0), new(14, 10), new(16 - early, 10 - early), new(6, 0));
        // They hold as much as they would: three rows and two links.
        Assert.That(line.Length, Is.EqualTo(3 * 10 * Math.Sqrt(2) + 2 * 2).Within(1e-6));
        Assert.That(line.Flow, Is.All.EqualTo(line.Flow![0]).And.All.InRange(1.03, 1.04));
        // At right angles, and where hardly more than both ends would be left, nothing changes.
        line = new BoundaryLinks().Join(area, [Row(4, 0, 4, 10), Row(5, 0, 5, 10)], 2.1, early: 0.5).Single();
        Assert.That(Corners(line), Is.EquivalentTo(new[] { (4, 0), (4, 10), (5, 10), (5, 0) }));
        area = Region.Rectangle(0, 0, 20, 1);
        line = new BoundaryLinks().Join(area, [Row(2, 0, 3, 1), Row(4, 0, 5, 1)], 2.1, early: 0.5).Single();
        Expect(line, new(3, 1), new(2, 0), new(4, 0), new(5, 1));
    }

    [Test]
    public void Short_rows_keep_their_corners()
    {
        // Twice 0.9 widths, less a little.
        var end = 1.79 * Diagonal;
        var points = Join(Region.Rectangle(0, 0, 20, end), 1, Row(2, 0, 2 + end, end), Row(4, 0, 4 + end, end)).Single();
        Assert.That(points.Points, Has.Length.EqualTo(4));
    }

    [Test]
    public void A_turn_keeps_a_extrusion_away_from_the_next()
    {
        // The row at 5.2 ends 1.2 past the one at 4, where 0.2 are left; the one at 6.2 leaves more than is wanted.
        Assert.That(Foot(5.2), Is.EqualTo(4.2).Within(1e-4));
        Assert.That(Foot(6.2), Is.EqualTo(4 + 0.9 * Diagonal).Within(1e-4));
        Assert.That(Foot(4.9), Is.EqualTo(4).Within(1e-4));

        static double Foot(double next)
        {
            var lines = Join(Region.Rectangle(0, 0, 20, 10), 1, Row(2, 0, 12, 10), Row(4, 0, 14, 10), Row(next, 0, next + 10, 10));
            return lines.SelectMany(l => l.Points).Where(p => p.Y == 0 && p.X >= 4 && p.X < 4.8).Min(p => p.X);
        }
    }

    [Test]
    public void A_turn_does_not_cut_a_corner_of_the_area()
    {
        var area = Region.From(new Polyline([Vec3.Zero, new Vec3(20, 0), new Vec3(20, 10), new Vec3(-10, 10)], closed: true));
        var points = Join(area, 1, Row(0.3, 0, -9.7, 10), Row(2.3, 0, -7.7, 10)).Single();
        Assert.That(points.Points, Has.Some.EqualTo(new Vec3(0.3, 0)));
        points = Join(area, 1, Row(0.6, 0, -9.4, 10), Row(2.6, 0, -7.4, 10)).Single();
        Assert.That(points.Points, Has.None.EqualTo(new Vec3(0.6, 0)));
    }

    [TestCase(20)]
    [TestCase(30)]
    [TestCase(45)]
    [TestCase(60)]
    [TestCase(75)]
    public void Turns_leave_less_open_than_corners_and_take_little_more_material(double angle)
    {
        const double Width = 0.4;
        var area = Region.Rectangle(0, 0, 8, 8);
        var rows = area.HatchLines(angle, Width, 0.1).Select(h => new InfillLine([h.From, h.To], false)).ToArray();
        var (open, twice, volume) = Paint(area, new BoundaryLinks().Join(area, rows, 4 * Width), Width);
        var (openBent, twiceBent, volumeBent) = Paint(area, new BoundaryLinks().Join(area, rows, 4 * Width, Width), Width);
        Assert.That(openBent, Is.LessThan(open));
        Assert.That(openBent + twiceBent, Is.LessThan(open + twice));
        Assert.That(volumeBent, Is.EqualTo(volume).Within(1).Percent);
    }

    private static (double Open, double Twice, double Volume) Paint(Region area, List<InfillLine> lines, double width)
    {
        var target = area.Offset(width / 2, JoinStyle.Miter);
        var raster = new BeadRaster(target.Bounds, 0.02);
        foreach (var line in lines) raster.Add(line.Points, Enumerable.Repeat(width, line.Points.Length).ToArray(), false);
        var (_, open, twice, outside) = raster.Measure(target);
        return (open, twice + outside, lines.Sum(l => l.Length) * width);
    }

    private static List<InfillLine> Join(Region area, double width, params InfillLine[] rows) => new BoundaryLinks().Join(area, rows, 2.1, width);

    private static InfillLine Row(double x1, double y1, double x2, double y2) => new([new Vec3(x1, y1), new Vec3(x2, y2)], false);

    private static IEnumerable<(int X, int Y)> Corners(InfillLine line) => line.Points.Select(p => ((int)Math.Round(p.X), (int)Math.Round(p.Y)));

    private static void Expect(InfillLine line, params Vec3[] points)
    {
        Assert.That(line.Points, Has.Length.EqualTo(points.Length));
        if (line.Points[0].DistanceTo(points[0]) > 1) Array.Reverse(points);
        for (var i = 0; i < points.Length; i++) Assert.That(line.Points[i].DistanceTo(points[i]), Is.LessThan(1e-4), $"point {i}: {line.Points[i]}");
    }
}
