using System;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

/// <summary>Rules of widths, extrusions and short moves, worked out by hand.</summary>
public class WallPartTests
{
    // 0.2 mm thick: a stadium of 0.5 mm lacks (1 - π/4) 0.04 mm² of its rectangle.
    [TestCase(BeadShape.Rectangle, 0.5, 0.1)]
    [TestCase(BeadShape.Stadium, 0.5, 0.1 - (1 - Math.PI / 4) * 0.04)]
    [TestCase(BeadShape.Stadium, 0.2, Math.PI / 4 * 0.04)]
    [TestCase(BeadShape.Stadium, 0.1, Math.PI / 4 * 0.01)]
    [TestCase(BeadShape.Circle, 0.5, Math.PI / 4 * 0.25)]
    public void Areas_spacings_and_widths_belong_together(BeadShape shape, double width, double area)
    {
        var rules = new WallRules { Shape = shape, Thickness = 0.2, OuterWidth = width };
        Assert.That(rules.Area(width), Is.EqualTo(area).Within(1e-12));
        Assert.That(rules.Spacing(width), Is.EqualTo(area / 0.2).Within(1e-12));
        Assert.That(rules.Width(rules.Spacing(width)), Is.EqualTo(width).Within(1e-12));
        Assert.That(rules.Edge, Is.EqualTo((width - area / 0.2) / 2).Within(1e-12));
    }

    [TestCase(0, 0, 0.45 * 0.45, 0.45 * 1.8)]
    [TestCase(0.3, 0.6, 0.3, 0.6)]
    [TestCase(0.5, 0.4, 0.45, 0.45)]
    public void Limits_of_widths_are_stated_or_shares_of_the_line(double least, double most, double min, double max)
    {
        var rules = WallRules.Of(new PrintSettings { LineWidth = 0.45, MinWallWidth = least, MaxWallWidth = most, WallCount = 3, Resolution = 0.01 },
            0.3);
        Assert.That((rules.MinWidth, rules.MaxWidth), Is.EqualTo((min, max)).Within(1e-12));
        Assert.That((rules.Count, rules.OuterWidth, rules.InnerWidth, rules.Thickness, rules.InnerTolerance), Is.EqualTo((3, 0.45, 0.45, 0.3, 0.01)));
        Assert.That(new WallRules(), Is.EqualTo(new WallRules { Count = 2, OuterWidth = 0.45, InnerWidth = 0.45, Thickness = 0.2, MinWidth = 0.2,
            MaxWidth = 0.8,
            Tolerance = 0.002, InnerTolerance = 0.0125, VariableWidth = true, Shape = BeadShape.Stadium }));
    }

    [Test]
    public void An_extrusion_has_a_length_a_heading_and_two_ends()
    {
        var extrusion = Line((0, 0, 1), (3, 4, 1), (3, 10, 1));
        (extrusion.Start, extrusion.End) = (ExtrusionEnd.Outline, ExtrusionEnd.Thin);
        Assert.That(extrusion.Length, Is.EqualTo(11));
        Assert.That(extrusion.Heading(5), Is.EqualTo(Vec3.UnitY));
        // Farther than the last segment: from the point before.
        Assert.That(extrusion.Heading(6), Is.EqualTo(Vec3.UnitY));
        Assert.That(extrusion.Heading(6.1).DistanceTo(new Vec3(3, 10) / Math.Sqrt(109)), Is.LessThan(1e-12));
        Assert.That(Line((1, 1, 1)).Heading(1), Is.EqualTo(Vec3.Zero));
        extrusion.Reverse();
        Assert.That((extrusion.Points[0], extrusion.Start, extrusion.End), Is.EqualTo((new Vec3(3, 10), ExtrusionEnd.Thin, ExtrusionEnd.Outline)));
    }

    [TestCase(5, 3, 2)]
    [TestCase(5, 0.5, -0.5)]
    [TestCase(-3, 4, 4)]
    [TestCase(13, 4, 3)]
    [TestCase(2.5, 1, -0.25)]
    public void The_clearance_of_a_extrusion_is_the_distance_beyond_its_radius(double x, double y, double clearance)
    {
        // From a radius of 1 to one of 2; where the point is level with the extrusion its radius there counts.
        var extrusion = Line((0, 0, 1), (10, 0, x == 2.5 || x == 13 ? 2 : 1));
        Assert.That(extrusion.Clearance(new Vec3(x, y)), Is.EqualTo(clearance).Within(1e-12));
    }

    [Test]
    public void A_closed_extrusion_ends_where_it_begins()
    {
        var extrusion = Line((0, 0, 1), (10, 0, 1), (10, 10, 1));
        // 6 mm to the nearest of two sides; the third, once there is one, is 1.41 mm off.
        Assert.That(extrusion.Clearance(new Vec3(4, 6)), Is.EqualTo(5).Within(1e-12));
        extrusion.Closed = true;
        Assert.That(extrusion.Clearance(new Vec3(4, 6)), Is.EqualTo(Math.Sqrt(2) - 1).Within(1e-12));
    }

    [Test]
    public void An_extrusion_is_cut_off_where_another_passes()
    {
        var other = Line((0, 5, 0.5), (20, 5, 0.5));
        var extrusion = Line((10, 0, 0.4), (10, 4, 0.8), (10, 5, 0.8));
        extrusion.TrimEnd(other);
        // The other covers y from 4.5 to 5.5: between the last two points.
        Assert.That(extrusion.Count, Is.EqualTo(3));
        Assert.That(extrusion.Points[2].Y, Is.EqualTo(4.5).Within(1e-5));
        var across = Line((10, 0, 0.4), (10, 4.6, 0.8), (10, 5, 0.8));
        across.TrimEnd(other);
        Assert.That((across.Count, across.Points[1].Y), Is.EqualTo((2, 4.5)).Within(1e-5));
        Assert.That(across.Radii[1], Is.EqualTo(0.4 + 0.4 * 4.5 / 4.6).Within(1e-5));
        var free = Line((10, 0, 0.4), (10, 4.4, 0.8));
        free.TrimEnd(other);
        Assert.That(free.Points[1].Y, Is.EqualTo(4.4));
        var inside = Line((3, 5, 0.4), (4, 5, 0.4), (5, 5, 0.4));
        inside.TrimEnd(other);
        Assert.That(inside.Count, Is.EqualTo(1));
    }

    [Test]
    public void Short_moves_of_infill_are_left_out_with_their_flow()
    {
        static Vec3[] Along(params double[] x) => Array.ConvertAll(x, v => new Vec3(v, 0));
        var open = new InfillLine(Along(0, 1, 1.05, 3, 3.01), false, [1, 2, 3, 4]).WithoutShort(0.1, 0.05, 0.01)!;
        Assert.That(open.Points, Is.EqualTo(Along(0, 1, 3.01)));
        // The volume stays: 0.05 · 2 + 1.95 · 3 + 0.01 · 4.
        Assert.That(open.Flow, Is.EqualTo(new[] { 1, 5.99 / 2.01 }).Within(1e-12));
        var closed = new InfillLine([new(0, 0), new(4, 0), new(4, 3), new(4, 3.05), new(0, 3.05)], true, [1, 2, 3, 4, 5]).WithoutShort(0.1, 0.05, 0.2)!;
        Assert.That(closed.Points, Is.EqualTo(new Vec3[] { new(0, 0), new(4, 0), new(4, 3.05), new(0, 3.05) }));
        Assert.That(closed.Flow, Is.EqualTo(new[] { 1, (3 * 2 + 0.05 * 3) / 3.05, 4, 5 }).Within(1e-12));
        Assert.That(new InfillLine(Along(0, 0.005, 0.009), false).WithoutShort(0.1, 0.05, 0.01), Is.Null);
        var whole = new InfillLine(Along(0, 0.1), false);
        Assert.That(whole.WithoutShort(0.1, 0.05, 0.01), Is.SameAs(whole));
        Assert.That(new InfillLine([new(0, 0), new(4, 0), new(4, 3)], true, [1, 2, 3]).Length, Is.EqualTo(4 + 6 + 15));
        Assert.That(new InfillLine([new(0, 0), new(4, 0), new(4, 3)], false, [1, 2]).Length, Is.EqualTo(4 + 6));
        Assert.That(new InfillLine([new(0, 0), new(4, 0), new(4, 3)], true).Length, Is.EqualTo(12));
    }

    private static MedialExtrusion Line(params (double X, double Y, double Radius)[] points)
    {
        var extrusion = new MedialExtrusion();
        foreach (var (x, y, radius) in points) extrusion.Add(new Vec3(x, y), radius);
        return extrusion;
    }
}
