using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Curved;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Curved;

/// <summary>Surfaces over the bed that layers follow, by hand-computed heights and slopes.</summary>
public class PlanSurfaceTests
{
    private static readonly Lazy<OverhangPlan> Descending = new(() => Against(45));
    private static readonly Lazy<OverhangPlan> Flatter = new(() => Against(30));

    [Test]
    public void A_transformed_surface_has_the_heights_and_slopes_of_its_places()
    {
        var plan = PlanSurface.Of((x, _) => 0.1 * x, 5);
        void Same(Affine map, double x, double y, double height, double byX, double byY, double detail)
        {
            var moved = plan.Transformed(map);
            var slope = moved.Slope(x, y);
            Assert.That(new[] { moved.Height(x, y), slope.ByX, slope.ByY, moved.Detail }, Is.EqualTo(new[] { height, byX, byY, detail }).Within(1e-6));
        }
        Same(Affine.Move(new Vec3(5, 0, 2)), 15, 0, 3, 0.1, 0, 5);
        Same(Affine.Scale(2, 3, 4), 2, 0, 0.4, 0.2, 0, 10);
        Same(Affine.Rotate(Vec3.UnitZ, 90), 0, 10, 1, 0, 0.1, 5);
        Assert.That(plan.Transformed(Affine.Identity), Is.SameAs(plan));
        Assert.That(() => plan.Transformed(Affine.Rotate(Vec3.UnitX, 10)), Throws.ArgumentException);
        Assert.That(() => plan.Transformed(Affine.Scale(1, 1, 0)), Throws.ArgumentException);
        Assert.That(PlanSurface.Level(3).Moved(new Vec3(0, 0, 1)).IsLevel, Is.True);
        Assert.That(plan.IsLevel, Is.False);
    }

    [TestCase(45, 4, 6, -5)]
    [TestCase(-45, 4, 6, 5)]
    [TestCase(45, 1, 2, 0)]
    [TestCase(45, -2, -2, -5)]
    public void A_cone_falls_from_its_axis(double degrees, double x, double y, double height)
    {
        Assert.That(PlanSurface.Cone(new Vec3(1, 2), degrees).Height(x, y), Is.EqualTo(height).Within(1e-9));
        Assert.That(() => PlanSurface.Cone(Vec3.Zero, 80.1), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => PlanSurface.Cone(Vec3.Zero, double.NaN), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => PlanSurface.Cone(Vec3.Zero, -80), Throws.Nothing);
    }

    [TestCase(3, 4, 1.5, 0.5)]
    [TestCase(20, 5, 5, 0.5)]
    [TestCase(-10, 5, 0, 0.5)]
    [TestCase(5, 30, 2.5, 0.5)]
    [TestCase(10, 10, 5, 0.5)]
    public void Beyond_its_edge_a_mesh_has_the_height_where_one_comes_to_it(double x, double y, double height, double byX)
    {
        var mesh = TriMesh.Create([new Vec3(0, 0, 0), new Vec3(10, 0, 5), new Vec3(10, 10, 5), new Vec3(0, 10, 0)], [0, 1, 2, 0, 2, 3]);
        var plan = PlanSurface.Of(mesh);
        Assert.That(plan.Height(x, y), Is.EqualTo(height).Within(1e-6));
        Assert.That(plan.Slope(x, y).ByX, Is.EqualTo(byX).Within(1e-9));
        Assert.That(plan.Slope(x, y).ByY, Is.Zero.Within(1e-9));
        Assert.That(plan.Covers(x, y), Is.EqualTo(x is >= 0 and <= 10 && y is >= 0 and <= 10));
        Assert.That(plan.Covers(10.01, 5), Is.True, "By rounding.");
        Assert.That(plan.Height(10 + 1e-9, 5), Is.EqualTo(5).Within(1e-6), "moved no farther than it needs");
        Assert.That(plan.Covers(10.03, 5), Is.False);
        foreach (var (dx, dy) in new[] { (-1, 0), (0, 1), (0, -1), (1, 1), (-1, -1), (1, -1) })
        {
            Assert.That(plan.Covers(5 + 5.01 * dx, 5 + 5.01 * dy), Is.True, $"{dx}, {dy}");
            Assert.That(plan.Covers(5 + 5.03 * dx, 5 + 5.03 * dy), Is.False, $"{dx}, {dy}");
        }
        Assert.That(PlanSurface.OnBed(mesh.Moved(new Vec3(0, 0, -2))).Height(x, y), Is.EqualTo(plan.Covers(x, y) ? Math.Max(0, height - 2) : 0).Within(1e-6));
    }

    [TestCase("curved.plan_empty", 0, 0, 0)]
    [TestCase("curved.plan_vertical", 0, 0, 5)]
    [TestCase("curved.plan_upside_down", 0, 5, 0)]
    public void A_surface_without_heights_is_reported(string code, double x, double y, double z)
    {
        var empty = x + y + z == 0;
        var mesh = TriMesh.Create(empty ? [] : [Vec3.Zero, new Vec3(x, y, z), new Vec3(9, 0)], empty ? [] : [0, 1, 2]);
        var problems = new DiagnosticList();
        PlanSurface.Of(mesh).Check(problems);
        Assert.That(problems.ToList().Select(d => d.Code), Is.EqualTo(new[] { code }));
        Assert.That(PlanSurface.Of(mesh).Moved(new Vec3(1, 0)).Height(99, 99), Is.Not.NaN);
        Assert.That(PlanSurface.Of(mesh).Slope(99, 99), Is.EqualTo((0.0, 0.0)), "it is level");
    }

    [TestCase(15, 15, 0)]
    [TestCase(10.5, 19.5, 0)]
    [TestCase(25, 15, -5)]
    [TestCase(4, 15, -6)]
    [TestCase(15, 2, -8)]
    [TestCase(15, 27, -7)]
    [TestCase(25, 25, -7.071)]
    [TestCase(6, 7, -5)]
    [TestCase(99, 15, -10.37)]
    public void Against_overhangs_layers_fall_with_the_distance_from_the_foot(double x, double y, double height)
    {
        Assert.That(Descending.Value.Height(x, y), Is.EqualTo(height).Within(x > 50 ? 0.7 : 0.03));
        Assert.That(Flatter.Value.Height(x, y), Is.EqualTo(Descending.Value.Height(x, y) / Math.Sqrt(3)).Within(1e-9));
    }

    [Test]
    public void Details_against_overhangs_are_four_cells()
    {
        Assert.That(Descending.Value.Detail, Is.EqualTo(1));
        Assert.That(new OverhangPlan(Region.Rectangle(1, 10, 8, 20), new Bounds(Vec3.Zero, new Vec3(9, 400, 10)), 45).Detail, Is.EqualTo(4));
    }

    private static OverhangPlan Against(double degrees)
        => new(Region.Rectangle(10, 10, 20, 20), new Bounds(Vec3.Zero, new Vec3(30, 30, 10)), degrees);
}
