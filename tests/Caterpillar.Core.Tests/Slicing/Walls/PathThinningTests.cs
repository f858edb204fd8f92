using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Slicing;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

public class PathThinningTests
{
    [Test]
    public void Points_between_which_course_and_width_are_straight_are_left_away()
    {
        Vec3[] points = [new(0, 0), new(1, 0.001), new(2, 0), new(3, 0), new(4, 0)];
        var (kept, widths) = PathThinning.Thin(points, [0.4, 0.41, 0.42, 0.43, 0.44], closed: false, 0.01, 0.005);
        Assert.That(kept, Is.EqualTo(new[] { points[0], points[4] }));
        Assert.That(widths, Is.EqualTo(new[] { 0.4, 0.44 }));
    }

    [TestCase(0.403, 2)]
    [TestCase(0.41, 3)]
    public void A_point_next_to_another_stays_only_where_its_width_is_another(double width, int count)
    {
        var (kept, _) = PathThinning.Thin([new(0, 0), new(0.005, 0), new(2, 0)], [0.4, width, width], closed: false, 0.01, 0.005);
        Assert.That(kept, Has.Length.EqualTo(count));
    }

    [Test]
    public void A_bulge_of_the_width_and_a_corner_stay()
    {
        Vec3[] points = [new(0, 0), new(1, 0), new(2, 0), new(3, 0), new(3, 1)];
        var (kept, _) = PathThinning.Thin(points, [0.4, 0.4, 0.5, 0.4, 0.4], closed: false, 0.01, 0.005);
        Assert.That(kept, Is.EqualTo(points));
    }

    [Test]
    public void What_is_left_is_within_both_tolerances_of_what_was_there([Range(1, 8)] int seed)
    {
        const double Tolerance = 0.0125, WidthTolerance = 0.009;
        var random = new Random(seed);
        var n = 400;
        var points = new Vec3[n];
        var widths = new double[n];
        for (var i = 0; i < n; i++)
        {
            var (sin, cos) = Angle.SinCos(360.0 * i / n);
            var radius = 10 + 0.01 * random.NextDouble() + 0.3 * Angle.SinCos(360.0 * 5 * i / n).Sin;
            points[i] = new Vec3(radius * cos, radius * sin);
            widths[i] = 0.4 + 0.03 * Angle.SinCos(360.0 * 7 * i / n).Sin + 0.004 * random.NextDouble();
        }
        var (kept, keptWidths) = PathThinning.Thin(points, widths, closed: true, Tolerance, WidthTolerance);
        Assert.That(kept, Has.Length.LessThan(n / 2));
        for (var i = 0; i < n; i++)
        {
            var (distance, width) = Nearest(kept, keptWidths, points[i]);
            Assert.That(distance, Is.LessThan(Tolerance * 1.01));
            Assert.That(width, Is.EqualTo(widths[i]).Within(WidthTolerance * 1.1));
        }
    }

    [TestCase(1.0)]
    [TestCase(1.55)]
    [TestCase(2.1)]
    public void Facets_on_both_sides_of_a_thin_wall_do_not_multiply_its_points(double thickness)
    {
        // Corners of the one side lie between those of the other.
        var region = Facets(30, 120, 0).Subtract(Facets(30 - thickness, 101, 0.7));
        var rules = WallTests.Rules();
        var even = new WallBuilder(rules with { VariableWidth = false }, new RegionEngine()).Build(region);
        var result = new WallBuilder(rules, new RegionEngine()).Build(region);
        Assert.That(result.Paths, Has.Count.EqualTo(thickness < 1.2 ? 2 : thickness < 2 ? 4 : 5));
        Assert.That(result.Paths.Sum(p => p.Points.Length), Is.LessThan(2 * 110 * result.Paths.Count));
        Assert.That(even.Paths.Sum(p => p.Points.Length), Is.GreaterThan(200));
        // Nothing is lost by it.
        Assert.That(WallTests.Fullness(region, rules), Is.EqualTo(1).Within(0.002));
    }

    private static Region Facets(double radius, int corners, double from) => Region.From(new Polyline(Enumerable.Range(0, corners).Select(i =>
    {
        var (sin, cos) = Angle.SinCos(from + 360.0 * i / corners);
        return new Vec3(radius * cos, radius * sin);
    }), closed: true));

    private static (double Distance, double Width) Nearest(Vec3[] points, double[] widths, Vec3 p)
    {
        var best = (Distance: double.PositiveInfinity, Width: 0.0);
        for (var i = 0; i < points.Length; i++)
        {
            var next = (i + 1) % points.Length;
            Vec3 a = points[i], d = points[next] - a;
            var t = Math.Min(1, Math.Max(0, Vec3.Dot(p - a, d) / d.LengthSquared));
            var distance = (p - (a + d * t)).LengthXY;
            if (distance < best.Distance) best = (distance, widths[i] + (widths[next] - widths[i]) * t);
        }
        return best;
    }
}
