using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Curved;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Tests.Slicing;
using NUnit.Framework;

namespace Caterpillar.Tests.Curved;

/// <summary>Plans and fields that do not do, and partial prints.</summary>
public class CurvedDiagnosticTests
{
    private static readonly TriMesh Part = Solids.Block(-10, -10, 0, 10, 10, 4);

    private static TriMesh Plane(double x0, double x1, double slope)
        => TriMesh.Create([new(x0, -20, x0 * slope), new(x1, -20, x1 * slope), new(x1, 20, x1 * slope), new(x0, 20, x0 * slope)], [0, 1, 2, 0, 2, 3]);

    [Test]
    public void A_plan_smaller_than_the_part_is_an_error_and_a_partial_print_only_when_asked()
    {
        var field = LayerField.Vertical(PlanSurface.Of(Plane(-20, 3, 0.1)));
        var refused = CurvedSolids.Try(field, CurvedSolids.Massive, null, Part);
        Assert.That(refused.Value, Is.Null);
        Assert.That(refused.Diagnostics.Single().Code, Is.EqualTo("curved.outside_plan"));
        Assert.That(refused.Diagnostics[0].Message, Does.Contain("% of the part, first at x"));
        var partial = CurvedSolids.Try(field, CurvedSolids.Massive, new CurvedOptions { Partial = true }, Part);
        Assert.That(partial.Diagnostics.Select(d => (d.Code, d.Severity)), Does.Contain(("curved.outside_plan", Severity.Warning)));
        var points = partial.Value!.Layers.SelectMany(CurvedSolids.Points).ToArray();
        Assert.That(points.Max(p => p.X), Is.EqualTo(3).Within(0.1));
        Assert.That(points.Min(p => p.X), Is.EqualTo(-9.602).Within(1e-3), "Half an extrusion along the slope.");
    }

    [Test]
    public void Beside_a_surface_a_partial_print_with_layers_along_its_normals_ends()
    {
        var part = Solids.Block(-6, -6, 0, 6, 6, 2);
        var field = LayerField.Offset(Plane(-20, 3, 0.1));
        Assert.That(CurvedSolids.Try(field, CurvedSolids.Massive, null, part).Diagnostics.Single().Code, Is.EqualTo("curved.outside_plan"));
        var partial = CurvedSolids.Try(field, CurvedSolids.Massive, new CurvedOptions { Partial = true }, part);
        Assert.That(partial.Diagnostics.Select(d => (d.Code, d.Severity)), Does.Contain(("curved.outside_plan", Severity.Warning)));
        Assert.That(partial.Value!.Layers.SelectMany(CurvedSolids.Points).Max(p => p.X), Is.EqualTo(3).Within(0.1));
    }

    [Test]
    public void Layers_that_are_all_beside_the_plan_are_left_out()
    {
        // What is higher than 2 mm lies beside the surface.
        TriMesh[] parts = [Solids.Block(-6, -6, 0, 6, 6, 2), Solids.Block(8, -6, 0, 12, 6, 5)];
        var field = LayerField.Vertical(PlanSurface.Of(Plane(-20, 7, 0)));
        var partial = CurvedSolids.Try(field, CurvedSolids.Massive, new CurvedOptions { Partial = true }, parts);
        Assert.That(partial.Value!.Layers.Select(l => l.Steps.Count), Is.All.GreaterThan(0));
        Assert.That(partial.Value.Layers.SelectMany(CurvedSolids.Points).Max(p => p.Z), Is.EqualTo(2).Within(0.2));
    }

    [Test]
    public void A_plan_with_a_hole_or_beside_the_part_is_an_error_that_tells_where()
    {
        // A square frame: the hole is 6 mm wide.
        Vec3[] frame =
            [new(-20, -20), new(20, -20), new(20, 20), new(-20, 20), new(-3, -3), new(3, -3), new(3, 3), new(-3, 3)];
        var plan = TriMesh.Create(frame, [0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7]);
        var holed = CurvedSolids.Try(LayerField.Vertical(PlanSurface.Of(plan)), CurvedSolids.Massive, null, Part);
        Assert.That(holed.Value, Is.Null);
        Assert.That(holed.Diagnostics.Single().Message, Does.Contain("9 % of the part, first at x -2."));
        var beside = CurvedSolids.Try(LayerField.Vertical(PlanSurface.Of(Plane(50, 90, 0))), CurvedSolids.Massive, null, Part);
        Assert.That(beside.Diagnostics.Single().Message, Does.Contain("100 % of the part"));
    }

    [Test]
    public void Layers_steeper_than_the_head_allows_are_an_error_that_tells_the_angle()
    {
        var field = LayerField.Vertical(PlanSurface.Of((x, _) => 0.5 * x));
        var refused = CurvedSolids.Try(field, CurvedSolids.Massive with { CurvedMaxSlope = 20.16 }, null, Part);
        Assert.That(refused.Value, Is.Null);
        var problem = refused.Diagnostics.Single(d => d.Severity == Severity.Error);
        Assert.That(problem.Code, Is.EqualTo("curved.too_steep"));
        Assert.That(problem.Message, Does.Match("^[0-9]+ mm of paths are steeper than the 20[.]2 degrees that"));
        Assert.That(problem.Message, Does.Contain("26.6 degrees").And.Contain("within 63.4 degrees of its axis up to 4 mm above the tip"));
        Assert.That(CurvedSolids.Try(field, CurvedSolids.Massive with { CurvedMaxSlope = 27 }, null, Part).Value, Is.Not.Null);
    }

    // Layers of 26.6 degrees, a head that allows 20.
    [TestCase(5, false)]
    [TestCase(7, true)]
    public void A_tool_that_tilts_measures_slopes_from_its_own_axis(double tilt, bool allowed)
    {
        var options = new CurvedOptions { MaxTilt = tilt };
        var result = CurvedSolids.Try(LayerField.Vertical(PlanSurface.Of((x, _) => 0.5 * x)), CurvedSolids.Massive with { CurvedMaxSlope = 20 }, options, Part);
        Assert.That(result.Value is not null, Is.EqualTo(allowed));
        Assert.That(() => new CurvedOptions { MaxTilt = 91 }, Throws.InstanceOf<System.ArgumentOutOfRangeException>());
    }

    [Test]
    public void The_head_of_the_printer_limits_the_slope()
    {
        // The outline rises 6 mm over 3.5 mm, then 6 mm over 16 mm; seen from the edge of the tip.
        var printer = new Printer();
        Assert.That(HeadSlope.OfHead(printer, 100, 100), Is.EqualTo(Angle.Atan2(12, 19.5)).Within(1e-9));
        Assert.That(HeadSlope.OfHead(printer, 100, 6), Is.EqualTo(Angle.Atan2(6, 4)).Within(1e-9), "Layers of little height do not reach the block.");
        Assert.That(HeadSlope.OfHead(printer, 4, 100), Is.EqualTo(Angle.Atan2(6, 4)).Within(1e-9), "Nor do small parts.");
    }

    // Two triangles face up and two down, two and one, one and two.
    [TestCase(0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2)]
    [TestCase(0, 1, 2, 0, 2, 3, 1, 4, 5)]
    [TestCase(0, 1, 2, 1, 4, 5, 1, 5, 2)]
    public void A_folded_plan_is_an_error(params int[] triangles)
    {
        var folded = TriMesh.Create([new(-20, -20, 0), new(20, -20, 0), new(20, 20, 0), new(-20, 20, 0), new(-20, -20, 5), new(-20, 20, 5)], triangles);
        var refused = CurvedSolids.Try(LayerField.Vertical(PlanSurface.Of(folded)), CurvedSolids.Massive, null, Part);
        Assert.That(refused.Value, Is.Null);
        Assert.That(refused.Diagnostics.Select(d => d.Code), Is.EqualTo(new[] { "curved.plan_folded" }));
        Assert.That(refused.Diagnostics[0].Message, Does.EndWith(PlanSurface.Otherwise));
    }

    [Test]
    public void A_plan_upside_down_is_a_warning()
    {
        var over = TriMesh.Create([new(-20, -20, 0), new(20, -20, 2), new(20, 20, 2), new(-20, 20, 0)], [0, 2, 1, 0, 3, 2]);
        foreach (var field in new[] { LayerField.Vertical(PlanSurface.Of(over)), LayerField.Offset(over) })
        {
            var result = CurvedSolids.Try(field, CurvedSolids.Massive, null, Part);
            Assert.That(result.Diagnostics.Select(d => d.Code), Does.Contain("curved.plan_upside_down"));
            Assert.That(result.Value, Is.Not.Null);
        }
    }

    [TestCase("z - 30 / (x - 20.5)", null)]
    [TestCase("sin(90 * z)", "curved.overhanging_layers")]
    [TestCase("-z", "curved.overhanging_layers")]
    [TestCase("z + 1 / (x - x)", "curved.overhanging_layers")]
    public void Formulas_must_rise_with_z(string formula, string? code)
    {
        var result = CurvedSolids.Try(LayerField.Formula(formula).OrThrow(), CurvedSolids.Massive, null, Part);
        Assert.That(result.Diagnostics.Where(d => d.Severity == Severity.Error).Select(d => d.Code), Is.EqualTo(code is null ? [] : new[] { code }));
    }

    [Test]
    public void Layers_need_space_to_blend_and_between_surfaces()
    {
        var steep = PlanSurface.Of((x, _) => 10 + 0.4 * x);
        var blend = CurvedSolids.Try(LayerField.Vertical(steep, new LayerBlend(0, 3)), CurvedSolids.Massive, null, Part);
        Assert.That(blend.Diagnostics.Single().Code, Is.EqualTo("curved.blend_too_short"));
        var cross = CurvedSolids.Try(LayerField.Between(PlanSurface.Level(5), PlanSurface.Of((x, _) => 6 + 0.4 * x)), CurvedSolids.Massive, null, Part);
        Assert.That(cross.Diagnostics.Single().Code, Is.EqualTo("curved.surfaces_cross"));
        foreach (var refused in new[] { blend, cross }) Assert.That(refused.Diagnostics[0].Message, Does.EndWith(PlanSurface.Otherwise));
    }

    [Test]
    public void A_plan_with_vertical_faces_in_its_middle_is_refused_at_once()
    {
        // A disk with a boss.
        var boss = CurvedSolids.Lathe(24, (10, 0), (10, 4), (5, 4), (5, 5.5));
        foreach (var field in new[] { LayerField.Vertical(PlanSurface.Of(boss)), LayerField.Between(PlanSurface.Level(0), PlanSurface.Of(boss)),
            LayerField.Vertical(PlanSurface.Of(boss), new LayerBlend(0, 20)) })
        {
            var step = CurvedSolids.Try(field, CurvedSolids.Massive, null, boss).Diagnostics.Single();
            Assert.That((step.Severity, step.Code), Is.EqualTo((Severity.Error, "curved.plan_steps")));
            Assert.That(step.Message, Does.StartWith("The plan has a step of 1.5 mm at (").And.EndWith(PlanSurface.Otherwise));
        }
    }

    [TestCase(2)]
    [TestCase(6)]
    public void A_vertical_face_of_a_plan_is_found_however_high_it_is(double height)
    {
        var boss = CurvedSolids.Lathe(24, (10, 0), (10, 4), (5, 4), (5, 4 + height));
        var problems = new DiagnosticList();
        LayerField.Vertical(PlanSurface.Of(boss)).FitTo(PartColumns.Of([boss]), CurvedSolids.Massive, problems);
        Assert.That(problems.ToList().Single().Message, Does.StartWith($"The plan has a step of {NumberFormatter.Format(height, 2)} mm at ("));
    }

    [Test]
    public void A_formula_that_is_no_formula_tells_the_column()
    {
        var result = LayerField.Formula("z + sinn(x)");
        Assert.That(result.Value, Is.Null);
        Assert.That(result.Diagnostics[0].Source!.Column, Is.EqualTo(5));
    }
}
