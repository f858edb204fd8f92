using System;
using System.Linq;
using Caterpillar.Curved;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Tests.Geometry.Meshes;
using NUnit.Framework;

namespace Caterpillar.Tests.Curved;

/// <summary>How steep layers may be for a head, how steep they are, and heights that keep to it.</summary>
public class LayerSlopeTests
{
    // Nearly straight up from the nozzle for 2 mm, then 45 degrees outward: atan of 8 / 6.6, 5 / 3.6 and 2 / 0.6.
    [TestCase(100, 100, 50.477369)]
    [TestCase(3.6, 100, 54.246113)]
    [TestCase(100, 5, 54.246113)]
    [TestCase(100, 2, 73.300756)]
    [TestCase(0.5, 100, 90)]
    public void A_head_touches_slopes_with_the_end_of_its_outline_or_where_the_part_ends(double span, double rise, double degrees)
    {
        var printer = new Printer { HeadOutline = new([new(0.5, 0), new(0.6, 2), new(6.6, 8)]), HeadBoxes = new([]) };
        Assert.That(HeadSlope.OfHead(printer, span, rise), Is.EqualTo(degrees).Within(1e-6));
    }

    [TestCase(-10, -10, 10, 10, 100, 100, 19.471221)]
    [TestCase(-10, -10, 10, 10, 10, 100, 26.565051)]
    [TestCase(-10, -10, 10, 10, 100, 5, 90)]
    [TestCase(20, 0, 30, 10, 20, 100, 90)]
    [TestCase(20, 0, 30, 10, 25, 100, 11.309932)]
    [TestCase(-30, -10, -20, -5, 20.5, 100, 90)]
    [TestCase(-30, -10, -20, -5, 25, 100, 11.309932)]
    [TestCase(-30, -10, -20, -5, 99, 100, 8.984877)]
    [TestCase(0, -30, 10, -20, 25, 100, 11.309932)]
    public void A_box_of_the_head_touches_slopes_with_its_farthest_corner_over_the_part(
        double x0, double y0, double x1, double y1, double span, double rise, double degrees)
    {
        var box = new Bounds(new Vec3(x0, y0, 5), new Vec3(x1, y1, 30));
        Assert.That(HeadSlope.OfHead(new Printer { HeadOutline = new([new(0.5, 0)]), HeadBoxes = new([box]) }, span, rise), Is.EqualTo(degrees).Within(1e-6));
    }

    [TestCase(0.5, 0, 1, 0)]
    [TestCase(0, 0.5, 0, 1)]
    [TestCase(0.3, 0.3, 0.70710678, 0.70710678)]
    [TestCase(0.3, -0.3, 0.70710678, -0.70710678)]
    public void Slopes_of_layers_are_measured_along_and_across_their_main_direction(double byX, double byY, double cos, double sin)
    {
        var field = LayerField.Vertical(PlanSurface.Of((x, y) => byX * x + byY * y));
        var samples = SlopeSamples.Of(field, PartColumns.Of([MeshMaker.Box(0, 0, 0, 10, 10, 6)]), 5, 3)!;
        Assert.That(new[] { Math.Abs(samples.Cos), samples.Sin * Math.Sign(samples.Cos + 1e-3) }, Is.EqualTo(new[] { cos, sin }).Within(1e-3));
        var most = Math.Sqrt(1 + byX * byX + byY * byY);
        Assert.That(samples.Most, Is.EqualTo(most).Within(1e-6));
        for (var level = 0; level < 3; level++)
        {
            var (u, v) = samples.Axes(level);
            foreach (var at in new[] { -3.0, 0, 4.4, 9, 30 })
                Assert.That((u.At(at + 1) - u.At(at), v.At(at + 1) - v.At(at)), Is.EqualTo((most, 1.0)).Within(1e-6));
        }
        Assert.That(SlopeSamples.Of(LayerField.Of(_ => 1.0), PartColumns.Of([MeshMaker.Box(0, 0, 0, 10, 10, 6)]), 5, 3), Is.Null);
    }

    [Test]
    public void Heights_on_a_grid_rise_no_faster_than_a_slope_in_all_directions()
    {
        var grid = new SlopeGrid(Vec3.Zero, 1, 9, 9);
        var heights = Enumerable.Repeat(double.PositiveInfinity, 81).ToArray();
        heights[4 * 9 + 4] = 7;
        grid.Lower(heights, 0.5);
        var (diagonal, knight) = (Math.Sqrt(2), Math.Sqrt(5));
        foreach (var (x, y, length) in new[] { (1, 0, 1.0), (3, 0, 3), (1, 1, diagonal), (2, 2, 2 * diagonal), (2, 1, knight), (3, 1, 1 + knight) })
        {
            foreach (var (i, j) in new[] { (x, y), (-x, y), (x, -y), (-x, -y), (y, x), (-y, x), (y, -x), (-y, -x) })
                Assert.That(heights[(4 + j) * 9 + 4 + i], Is.EqualTo(7 + 0.5 * length).Within(1e-12), $"{i}, {j}");
        }
        var over = SlopeGrid.Over(new Bounds(new Vec3(1, 2, 0), new Vec3(11, 22, 5)), 200);
        Assert.That((over.Cell, over.Columns, over.Rows, over.Count), Is.EqualTo((1.0, 16, 26, 416)));
        Assert.That((over.At(0), over.At(17)), Is.EqualTo((new Vec3(-1.5, -0.5), new Vec3(-0.5, 0.5))));
        Assert.That(SlopeGrid.Over(new Bounds(Vec3.Zero, new Vec3(1, 1, 1)), 200).Cell, Is.EqualTo(0.4));
    }

    [Test]
    public void A_layer_keeps_the_places_that_go_together()
    {
        var grid = new SlopeGrid(Vec3.Zero, 1, 5, 1);
        var all = FixedLayer.Of(3, [(0, 0), (3, 1)], grid, 0.5);
        Assert.That((all.Number, all.Places.Count), Is.EqualTo((3, 2)));
        Assert.That(all.Upper, Is.EqualTo(new[] { 0, 0.5, 1, 1, 1.5 }).Within(1e-12));
        Assert.That(all.Lower, Is.EqualTo(new[] { 0, 0, 0.5, 1, 0.5 }).Within(1e-12));
        Assert.That(FixedLayer.Of(3, [(0, 0), (1, 0), (3, 5)], grid, 0.5).Places.Select(p => p.Node), Is.EqualTo(new[] { 0, 1 }));
        Assert.That(FixedLayer.Of(3, [(0, 0), (2, 5), (3, 5)], grid, 0.5).Places.Select(p => p.Node), Is.EqualTo(new[] { 2, 3 }));
        Assert.That(FixedLayer.Of(3, [(0, 0), (3, 5)], grid, 0.5).Upper[4], Is.EqualTo(2).Within(1e-12), "As many of both: the lower one stays.");
    }
}
