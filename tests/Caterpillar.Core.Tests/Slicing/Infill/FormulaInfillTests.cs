using System;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using NUnit.Framework;
using static Caterpillar.Tests.Slicing.Infill.InfillSamples;

namespace Caterpillar.Tests.Slicing.Infill;

public class FormulaInfillTests
{
    private static InfillRequest Of(string formula, Region? area = null) => new(area ?? Region.Rectangle(-10, -10, 10, 10), InfillPattern.Formula, 2, Width)
    {
        Formula = Compile(formula), Z = 3, Layer = 5,
    };

    [TestCase(0.05)]
    [TestCase(0.01)]
    [TestCase(0.002)]
    public void A_circle_is_met_within_the_tolerance(double tolerance)
    {
        var loop = Fill(Of("x^2 + y^2 - 49") with { Tolerance = tolerance }).Single();
        Assert.That(loop.Closed);
        var n = loop.Points.Length;
        for (var i = 0; i < n; i++)
        {
            Assert.That(loop.Points[i].LengthXY, Is.EqualTo(7).Within(tolerance / 4));
            Assert.That(((loop.Points[i] + loop.Points[(i + 1) % n]) / 2).LengthXY, Is.EqualTo(7).Within(tolerance));
        }
        Assert.That(Length([loop]), Is.EqualTo(14 * Math.PI).Within(14 * tolerance));
    }

    [Test]
    public void Straight_lines_have_two_points()
    {
        var lines = Fill(Of("x - 1.23456"));
        Assert.That(lines.Single().Points, Has.Length.EqualTo(2));
        Assert.That(lines[0].Points.Select(p => p.X), Is.All.EqualTo(1.23456).Within(0.001));
    }

    [Test]
    public void Formulas_see_height_layer_spacing_and_width()
    {
        foreach (var (formula, x) in new[] { ("x - z", 3.0), ("x - layer", 5), ("x - spacing", 2), ("x - width", Width) })
            Assert.That(Fill(Of(formula))[0].Points[0].X, Is.EqualTo(x).Within(0.002), formula);
    }

    [Test]
    public void Small_loops_between_the_nodes_of_the_first_grid_are_found()
    {
        // Circles with a radius of 0.35 mm, 4 mm apart.
        var lines = Fill(Of("hypot(mod(x + 101.13, 4) - 2, mod(y + 100.62, 4) - 2) - 0.35"));
        Assert.That(lines, Has.Count.EqualTo(25));
        Assert.That(lines.Select(l => Length([l])), Is.All.EqualTo(0.7 * Math.PI).Within(0.15));
    }

    [Test]
    public void Crossing_lines_are_separated_one_way_or_the_other()
    {
        var lines = Fill(Of("(x - 0.123) * (y - 0.234)") with { Linked = false });
        Assert.That(Length(lines), Is.EqualTo(40).Within(0.5));
        Assert.That(lines, Has.Count.EqualTo(2));
    }

    [Test]
    public void Poles_are_no_lines_and_places_without_a_value_are_left_empty()
    {
        Assert.That(Fill(Of("1 / (x - 0.1)")), Is.Empty);
        Assert.That(Fill(Of("sqrt(-1 - x^2)")), Is.Empty);
        Assert.That(Fill(Of("1")), Is.Empty);
        var half = Fill(Of("y - 0.3 + 0 * sqrt(x)")).Single();
        Assert.That(half.Points.Min(p => p.X), Is.InRange(0, 0.5));
    }

    // Infinite where the edge begins.
    [TestCase("1 / x - 1", 3, 1.0)]
    [TestCase("1 / x - 1", -1, null)]
    public void A_line_beside_a_pole_is_found_and_the_pole_is_none(string formula, double end, double? expected)
    {
        var field = new LevelField(Of(formula));
        var found = field.Zero(Vec3.Zero, field.At(0, 0), new Vec3(end, 0), field.At(end, 0), out var zero);
        Assert.That(found, Is.EqualTo(expected is not null));
        if (expected is { } x) Assert.That(zero.X, Is.EqualTo(x).Within(1e-3));
    }

    [Test]
    public void A_jump_of_the_sign_is_a_line()
        => Assert.That(Fill(Of("x > 2.345 ? 1 : -1")).Single().Points.Select(p => p.X), Is.All.EqualTo(2.345).Within(0.01));

    [Test]
    public void Lines_of_the_formula_are_cut_at_the_boundary()
    {
        var lines = Fill(Of("y - 10", Holed) with { Linked = false });
        Assert.That(lines.Select(l => Length([l])), Is.EqualTo(new[] { 7.0, 7 }).Within(1e-3));
    }
}
