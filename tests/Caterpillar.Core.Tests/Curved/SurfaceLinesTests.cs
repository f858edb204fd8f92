using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Curved;
using Caterpillar.Geometry;
using Caterpillar.Slicing;
using Caterpillar.Tests.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Curved;

/// <summary>Lines on surfaces along directions.</summary>
public class SurfaceLinesTests
{
    private static readonly Bounds Plan = CurvedSolids.Plan(-20, -15, 20, 15);

    [Test]
    public void Principal_directions_of_a_cylinder_run_around_it_and_along_it()
    {
        // Its axis runs at 30 degrees to X.
        var (sin, cos) = Angle.SinCos(30);
        var cylinder = PlanSurface.Of((x, y) => Math.Sqrt(900 - (y * cos - x * sin) * (y * cos - x * sin)), 1);
        foreach (var place in new[] { new Vec3(3, 4), new Vec3(-8, 10), new Vec3(12, -9) })
        {
            var along = SurfaceLines.PrincipalDirection(cylinder, place, across: true);
            Assert.That(Math.Abs(Vec3.Cross(along, new Vec3(cos, sin)).Z), Is.LessThan(3e-3));
            // On the slope the other one is at right angles in space, which it is in plan, too, for a cylinder that lies.
            var around = SurfaceLines.PrincipalDirection(cylinder, place);
            Assert.That(Math.Abs(Vec3.Dot(around, new Vec3(cos, sin))), Is.LessThan(3e-3));
        }
        Assert.That(SurfaceLines.PrincipalDirection(PlanSurface.Level(3), Vec3.Zero), Is.EqualTo(Vec3.Zero), "A plane has none.");
    }

    [Test]
    public void Lines_along_one_direction_are_even_on_the_surface()
    {
        var slope = PlanSurface.Of((x, y) => 0.75 * y);
        var lines = SurfaceLines.Along(slope, Plan, _ => Vec3.UnitX, 2.5);
        // 30 mm in plan are 37.5 along the slope.
        Assert.That(lines, Has.Count.EqualTo(15));
        var y = lines.Select(l => l[0].Y).OrderBy(v => v).ToArray();
        for (var i = 1; i < y.Length; i++) Assert.That(y[i] - y[i - 1], Is.EqualTo(2).Within(0.01));
        foreach (var line in lines)
        {
            Assert.That(line.Points.All(p => Math.Abs(p.Y - line[0].Y) < 1e-9 && Math.Abs(p.Z - 0.75 * p.Y) < 1e-9));
            Assert.That(line.Length, Is.GreaterThan(38));
        }
    }

    [Test]
    public void Lines_along_curves_run_like_the_nearest_of_them_and_keep_their_distance()
    {
        var ring = new Polyline(Solids.Circle(10, 90), closed: true);
        var lines = SurfaceLines.AlongCurves(PlanSurface.Level(0), Plan, [ring], 2);
        foreach (var line in lines)
        {
            var middle = line[0].LengthXY;
            if (line.Points.Min(p => p.LengthXY) > 4) Assert.That(line.Points.All(p => Math.Abs(p.LengthXY - middle) < 0.3), $"a ring of {middle} mm");
        }
        for (var i = 0; i < lines.Count; i++)
        {
            for (var k = 0; k < i; k++)
                Assert.That(lines[i].Points.Min(p => lines[k].Points.Min(q => q.DistanceTo(p))), Is.GreaterThan(0.95));
        }
    }

    // Lines go round a bend of up to 60 degrees from one step to the next. A steeper one ends them.
    [TestCase(50, true)]
    [TestCase(58, true)]
    [TestCase(63, false)]
    [TestCase(80, false)]
    public void Lines_follow_bends_and_end_at_corners(double degrees, bool goesOn)
    {
        var (sin, cos) = Angle.SinCos(degrees);
        var lines = SurfaceLines.Along(PlanSurface.Level(1), Plan, p => p.X < 0 ? Vec3.UnitX : new Vec3(cos, sin), 2);
        Assert.That(lines.Any(l => l.Points.Any(p => p.X < -5) && l.Points.Any(p => p.X > 1)), Is.EqualTo(goesOn));
        Assert.That(lines.SelectMany(l => l.Points), Is.All.Matches<Vec3>(p => p.Z == 1));
    }

    [Test]
    public void Infill_of_curved_layers_follows_the_lines()
    {
        static double Tilted(double x, double y) => 0.4 * y + 10;
        var part = CurvedSolids.Between(Plan, 4, Tilted, (x, y) => Tilted(x, y) + 1);
        var lines = Enumerable.Range(-2, 5).Select(i => new Polyline([new(-20, 6 * i), new(20, 6 * i)])).ToArray();
        var settings = CurvedSolids.Massive with { InfillDensityPercent = 20 };
        var result = CurvedSolids.Try(LayerField.Vertical(PlanSurface.Of(Tilted)), settings, new CurvedOptions { InfillLines = _ => lines }, part).OrThrow();
        foreach (var layer in result.Layers)
        {
            var places = layer.Steps.Where(s => s.Path.Role == Role.Infill).Select(s => s.Path.Start.Y).OrderBy(y => y).ToArray();
            Assert.That(places, Is.EqualTo(new[] { -12.0, -6, 0, 6, 12 }).Within(1e-2));
        }
    }
}
