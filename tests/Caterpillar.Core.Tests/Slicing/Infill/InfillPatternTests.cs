using System;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using NUnit.Framework;
using static Caterpillar.Tests.Slicing.Infill.InfillSamples;

namespace Caterpillar.Tests.Slicing.Infill;

public class InfillPatternTests
{
    private static readonly Region Square = Region.Rectangle(-10.3, -10.3, 9.7, 9.7);

    private static double[] Heights(InfillRequest request) => Fill(request with { Linked = false }).Select(l => l.Points[0].Y).OrderBy(y => y).ToArray();

    [Test]
    public void Lines_are_a_spacing_apart_from_the_origin()
    {
        var lines = Fill(new InfillRequest(Square, InfillPattern.Lines, 5, Width) { Linked = false, Z = 0.6 });
        Assert.That(lines.Select(l => l.Points[0].Y), Is.EqualTo(new[] { -10.0, -5, 0, 5 }).Within(1e-9));
        Assert.That(lines.Select(l => l.Points[1].X), Is.All.EqualTo(9.7).Within(1e-9));
        Assert.That(lines.SelectMany(l => l.Points).Select(p => p.Z), Is.All.EqualTo(0.6));
    }

    [Test]
    public void Linked_lines_are_one_zigzag_of_which_the_links_run_along_the_sides()
    {
        var line = Fill(new InfillRequest(Square, InfillPattern.Lines, 5, Width)).Single();
        Assert.That(line.Points, Has.Length.EqualTo(8));
        Assert.That(Length([line]), Is.EqualTo(4 * 20 + 3 * 5).Within(1e-6));
    }

    [Test]
    public void A_grid_has_two_families_twice_as_far_apart()
    {
        var lines = Fill(new InfillRequest(Square, InfillPattern.Grid, 2.5, Width) { Linked = false });
        Assert.That(lines.Where(l => l.Points[0].Y == l.Points[1].Y).Select(l => l.Points[0].Y), Is.EqualTo(new[] { -10.0, -5, 0, 5 }).Within(1e-9));
        Assert.That(lines.Count(l => Math.Abs(l.Points[0].X - l.Points[1].X) < 1e-9), Is.EqualTo(4));
        Assert.That(InfillFiller.Families(InfillPattern.Grid), Is.EqualTo(2));
    }

    [Test]
    public void Triangles_meet_in_points()
    {
        var lines = Fill(new InfillRequest(Square, InfillPattern.Triangles, 2, Width) { Linked = false });
        // Heights of the triangles are three spacings: 0, ±6 along the first direction.
        Assert.That(lines.Where(l => Math.Abs(l.Points[0].Y - l.Points[1].Y) < 1e-9).Select(l => l.Points[0].Y), Is.EqualTo(new[] { -6.0, 0, 6 }).Within(1e-9));
        Assert.That(lines.Count(l => Distance(l, Vec3.Zero) < 1e-6), Is.EqualTo(3), "through the origin");
    }

    [Test]
    public void The_planes_of_cubes_move_on_with_the_height_and_come_back_after_an_edge()
    {
        var request = new InfillRequest(Square, InfillPattern.Cubic, 2, Width);
        double[] Rows(double z) => Fill(request with { Z = z, Linked = false })
            .Where(l => Math.Abs(l.Points[0].Y - l.Points[1].Y) < 1e-6).Select(l => l.Points[0].Y).ToArray();
        Assert.That(Rows(0), Is.EqualTo(new[] { -6.0, 0, 6 }).Within(1e-9));
        Assert.That(Rows(Math.Sqrt(2)), Is.EqualTo(new[] { -7.0, -1, 5 }).Within(1e-9));
        Assert.That(Rows(6 * Math.Sqrt(2)), Is.EqualTo(Rows(0)).Within(1e-9));
    }

    [TestCase(0.0)]
    [TestCase(0.3)]
    [TestCase(1.1)]
    [TestCase(1.75)]
    [TestCase(2.9)]
    [TestCase(4.0)]
    public void The_gyroid_solves_its_equation(double z)
    {
        const double Spacing = 2;
        var period = GyroidPattern.MeanLength * Spacing;
        var lines = Fill(new InfillRequest(Square, InfillPattern.Gyroid, Spacing, Width) { Z = z, Linked = false });
        Assert.That(lines, Is.Not.Empty);
        double k = 2 * Math.PI / period, worst = 0;
        foreach (var line in lines)
        {
            for (var i = 1; i < line.Points.Length; i++)
            {
                var p = (line.Points[i] + line.Points[i - 1]) / 2;
                double x = k * p.X, y = k * p.Y, h = k * z;
                var f = Math.Sin(x) * Math.Cos(y) + Math.Sin(y) * Math.Cos(h) + Math.Sin(h) * Math.Cos(x);
                var dx = k * (Math.Cos(x) * Math.Cos(y) - Math.Sin(h) * Math.Sin(x));
                var dy = k * (Math.Cos(y) * Math.Cos(h) - Math.Sin(x) * Math.Sin(y));
                worst = Math.Max(worst, Math.Abs(f) / Math.Max(Math.Sqrt(dx * dx + dy * dy), 0.2));
            }
        }
        Assert.That(worst, Is.LessThan(0.06), "middles of chords, mm off");
    }

    [Test]
    public void The_gyroid_of_a_layer_lies_on_the_one_below()
    {
        var request = new InfillRequest(Square, InfillPattern.Gyroid, 2, Width) { Linked = false };
        var farthest = 0.0;
        for (var i = 0; i < 25; i++)
        {
            var below = Fill(request with { Z = 0.2 * i });
            foreach (var line in Fill(request with { Z = 0.2 * (i + 1) }))
            {
                foreach (var p in line.Points.Where(p => Math.Abs(p.X) < 8 && Math.Abs(p.Y) < 8)) farthest = Math.Max(farthest, below.Min(l => Distance(l, p)));
            }
        }
        Assert.That(farthest, Is.LessThan(0.9), "its flattest places lean by four layers' height at most");
    }

    [Test]
    public void Honeycombs_have_sides_of_one_length_and_never_cross()
    {
        const double Spacing = 3;
        var lines = Fill(new InfillRequest(Square, InfillPattern.Honeycomb, Spacing, Width) { Linked = false });
        var side = 2 / Math.Sqrt(3) * (Spacing * 4 / 3 - Width);
        foreach (var line in lines)
        {
            for (var i = 2; i + 1 < line.Points.Length; i++) Assert.That(line.Points[i].DistanceTo(line.Points[i - 1]), Is.EqualTo(side).Within(1e-6));
        }
        var least = lines.SelectMany((a, i) => lines.Skip(i + 1).SelectMany(b => a.Points.Select(p => Distance(b, p)))).Min();
        Assert.That(least, Is.EqualTo(Width).Within(1e-6), "pairs run next to each other");
    }

    [Test]
    public void Dense_honeycombs_become_lines()
        => Assert.That(Heights(new InfillRequest(Square, InfillPattern.Honeycomb, 0.5, Width)), Has.Length.EqualTo(40));

    [Test]
    public void Concentric_loops_begin_half_a_spacing_inside()
    {
        var loops = Fill(new InfillRequest(Square, InfillPattern.Concentric, 4, Width));
        Assert.That(loops.Select(l => l.Closed), Is.All.True);
        Assert.That(loops.Select(l => Length([l])), Is.EqualTo(new[] { 4 * 16.0, 4 * 8 }).Within(1e-6));
        var solid = Fill(new InfillRequest(Square, InfillPattern.Concentric, 4, Width) { Solid = true });
        Assert.That(solid.Select(l => Length([l])), Is.EqualTo(new[] { 4 * 20.0, 4 * 12, 4 * 4 }).Within(1e-6));
    }

    [Test]
    public void Hilberts_curve_goes_from_cell_to_cell_through_all_of_them()
    {
        var lines = Fill(new InfillRequest(Region.Rectangle(-8, -8, 8, 8), InfillPattern.Hilbert, 1, Width) { Linked = false });
        var inside = lines.SelectMany(l => l.Points.Zip(l.Points.Skip(1), (a, b) => a.DistanceTo(b))).Sum();
        // Four quarters of 64 cells, of which those at the rim also go out.
        Assert.That(inside, Is.InRange(252, 262));
        Assert.That(lines.SelectMany(l => l.Points).Select(p => Math.Abs(p.X * 2 % 1) + Math.Abs(p.Y * 2 % 1)), Is.All.EqualTo(0).Within(1e-6),
            "middles of cells");
    }

    [Test]
    public void Curves_of_the_user_are_cut_at_the_boundary()
    {
        var curve = new Polyline([new Vec3(-5, 3, 9), new Vec3(25, 3, 9)]);
        var loop = new Polyline([new Vec3(1, 15), new Vec3(5, 15), new Vec3(3, 18)], closed: true);
        var lines = Fill(new InfillRequest(Holed, InfillPattern.Curves, 1, Width) { Curves = [curve, loop], Z = 0.4 });
        Assert.That(lines[0].Points, Is.EqualTo(new[] { new Vec3(0, 3, 0.4), new Vec3(20, 3, 0.4) }).Using<Vec3, Vec3>((a, b) => a.DistanceTo(b) < 1e-6));
        Assert.That(lines[1].Closed && lines[1].Points.Length == 3);
    }

    [Test]
    public void What_cannot_be_filled_is_empty_and_what_makes_no_sense_is_refused()
    {
        foreach (var pattern in Patterns)
        {
            Assert.That(Fill(Request(Region.Empty, pattern, 2)), Is.Empty, $"{pattern}");
            Assert.That(() => Fill(Request(Region.Rectangle(0, 0, 0.01, 0.01), pattern, 2)), Throws.Nothing, $"{pattern}");
            Assert.That(() => Fill(Request(Holed, pattern, 500)), Throws.Nothing, $"{pattern}");
            foreach (var bad in new[] { 0, -1, double.NaN, double.PositiveInfinity })
            {
                Assert.That(() => Fill(Request(Holed, pattern, bad)), Throws.ArgumentException, $"{pattern}");
                Assert.That(() => Fill(Request(Holed, pattern, 2) with { Width = bad }), Throws.ArgumentException, $"{pattern}");
            }
        }
        Assert.That(() => Fill(new InfillRequest(Holed, InfillPattern.Formula, 2, Width)), Throws.ArgumentException);
        Assert.That(() => Fill(new InfillRequest(Holed, InfillPattern.Curves, 2, Width)), Throws.ArgumentException);
    }

    private static double Distance(InfillLine line, Vec3 p)
    {
        var least = double.PositiveInfinity;
        for (var i = 1; i < line.Points.Length; i++)
        {
            Vec3 a = line.Points[i - 1].WithZ(0), d = line.Points[i].WithZ(0) - a;
            var t = Math.Min(Math.Max(Vec3.Dot(p.WithZ(0) - a, d) / d.LengthSquared, 0), 1);
            least = Math.Min(least, (a + d * t).DistanceTo(p.WithZ(0)));
        }
        return least;
    }
}
