using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

public class WallTests
{
    internal static WallRules Rules(BeadShape shape = BeadShape.Stadium, int count = 2)
        => new() { Count = count, OuterWidth = 0.45, InnerWidth = 0.45, Thickness = 0.2, Shape = shape, MinWidth = 0.2, MaxWidth = 0.8 };

    /// <summary>Walls and what fills their inside.</summary>
    internal static List<WallPath> Solid(Region region, WallRules rules)
    {
        var builder = new WallBuilder(rules, new RegionEngine());
        var walls = builder.Build(region);
        var paths = walls.Paths.ToList();
        foreach (var island in walls.Inside.Islands) paths.AddRange(builder.Fill(island).Paths);
        return paths;
    }

    /// <summary>Printed volume by ideal volume; a stadium leaves the two round edges of the cross-section open.</summary>
    internal static double Fullness(Region region, WallRules rules)
        => Solid(region, rules).Sum(p => p.Volume(rules)) / (region.Offset(-rules.Edge).Area * rules.Thickness);

    [Test]
    public void A_square_has_the_walls_that_one_computes_by_hand()
    {
        var rules = Rules(BeadShape.Rectangle);
        var result = new WallBuilder(rules, new RegionEngine()).Build(Region.Rectangle(0, 0, 20, 20));
        Assert.That(result.Paths.Select(p => p.Index), Is.EqualTo(new[] { 0, 1 }));
        Assert.That(result.Paths.Select(p => p.Closed), Is.All.True);
        // Half a width from the outline, and a width further in.
        Assert.That(result.Paths[0].Points.Select(p => Math.Max(Math.Abs(p.X - 10), Math.Abs(p.Y - 10))), Is.All.EqualTo(9.775).Within(1e-5));
        Assert.That(result.Paths[1].Points.Select(p => Math.Max(Math.Abs(p.X - 10), Math.Abs(p.Y - 10))), Is.All.EqualTo(9.325).Within(1e-5));
        Assert.That(result.Paths.SelectMany(p => p.Widths), Is.All.EqualTo(0.45));
        Assert.That(result.Inside.Area, Is.EqualTo(18.2 * 18.2).Within(1e-3));
        Assert.That(result.TooThin, Is.Empty);
    }

    [TestCase(true)]
    [TestCase(false)]
    public void Only_inner_walls_are_round_at_inner_corners_in_chords_that_are_not_short(bool variableWidth)
    {
        // An angle whose inner corner is at (8, 8): the outer wall has it at 7.775, the inner wall a width farther in.
        var angle = Region.From(new Polyline([new(0, 0), new(20, 0), new(20, 8), new(8, 8), new(8, 20), new(0, 20)], closed: true));
        var rules = Rules(BeadShape.Rectangle) with { VariableWidth = variableWidth, Corners = JoinStyle.Round };
        var walls = new WallBuilder(rules, new RegionEngine()).Build(angle).Paths;
        var corner = new Vec3(7.775, 7.775);
        Assert.That(walls.Single(w => w.Index == 0).Points, Has.Length.EqualTo(6).And.Some.Matches((Vec3 p) => p.DistanceTo(corner) < 1e-5));
        var inner = walls.Single(w => w.Index == 1);
        var round = inner.Points.Where(p => p.DistanceTo(corner) < 0.6).ToArray();
        Assert.That(round, Has.Length.GreaterThan(2));
        Assert.That(round.Select(p => p.DistanceTo(corner)), Is.All.EqualTo(0.45).Within(1e-5));
        Assert.That(round.Zip(round.Skip(1), (a, b) => a.DistanceTo(b)), Is.All.GreaterThan(0.15));
        Assert.That(inner.Points, Has.Length.EqualTo(5 + round.Length));
    }

    [TestCase(BeadShape.Rectangle)]
    [TestCase(BeadShape.Stadium)]
    public void A_frame_of_any_thickness_is_full(BeadShape shape)
    {
        var rules = Rules(shape);
        var bad = Enumerable.Range(0, 101).Select(i => Math.Round(0.4 + 0.02 * i, 2))
            .Select(t => (Thickness: t, Fullness: Fullness(WallShapes.Frame(t), rules)))
            .Where(f => Math.Abs(f.Fullness - 1) > 0.01).ToArray();
        Assert.That(bad, Is.Empty);
    }

    [Test]
    public void Thin_frames_are_one_closed_extrusion_as_wide_as_they()
    {
        var paths = Solid(WallShapes.Frame(0.5), Rules(BeadShape.Rectangle));
        Assert.That(paths, Has.Count.EqualTo(1));
        Assert.That((paths[0].Closed, paths[0].IsExtrusion), Is.EqualTo((true, true)));
        // At the corners the largest disc is wider.
        Assert.That(paths[0].Widths, Has.All.InRange(0.499, 0.5 * 1.18));
        Assert.That(paths[0].Points.Select(p => Math.Max(Math.Abs(p.X), Math.Abs(p.Y))), Has.All.EqualTo(9.75).Within(0.06));
    }

    [Test]
    public void Two_walls_share_a_frame_that_is_not_twice_as_thick_as_one()
    {
        var paths = Solid(WallShapes.Frame(1), Rules(BeadShape.Rectangle));
        Assert.That(paths, Has.Count.EqualTo(2));
        Assert.That(paths.SelectMany(p => p.Widths), Has.All.InRange(0.4999, 0.55));
        Assert.That(paths.Select(p => p.Closed), Is.All.True);
    }

    [TestCase(8)]
    [TestCase(20)]
    [TestCase(40)]
    public void A_wedge_is_full(double length)
        => Assert.That(Fullness(WallShapes.Wedge(0.3, 3, length), Rules()), Is.EqualTo(1).Within(0.02));

    [TestCase(5)]
    [TestCase(7)]
    [TestCase(9)]
    public void A_star_is_full(int tips) => Assert.That(Fullness(WallShapes.Star(tips, 6, 2.5), Rules()), Is.EqualTo(1).Within(0.02));

    [Test]
    public void Thin_rings_are_full()
    {
        foreach (var thickness in new[] { 0.3, 0.4, 0.55, 0.7, 0.9, 1.1, 1.3, 1.5, 1.8, 2.2 })
            Assert.That(Fullness(WallShapes.Ring(4, thickness), Rules()), Is.EqualTo(1).Within(0.005), $"{thickness} mm");
    }

    // Strokes of 0.6 mm: of two beads, or of one, whose ends meet those of others.
    [TestCase(0.4)]
    [TestCase(0.45)]
    [TestCase(0.6)]
    public void Letters_are_full(double width)
    {
        foreach (var degrees in new[] { 0.0, 17, 45 })
        {
            var rules = Rules() with { OuterWidth = width, InnerWidth = width, MaxWidth = 1.8 * width };
            var bad = WallShapes.Letters().Select(l => (l.Letter, Fullness: Fullness(Turned(l.Region, degrees), rules)))
                .Where(l => Math.Abs(l.Fullness - 1) > 0.03).ToArray();
            Assert.That(bad, Is.Empty, $"turned by {degrees}°");
        }
    }

    private static Region Turned(Region region, double degrees)
    {
        var turn = Affine.Rotate(Vec3.UnitZ, degrees);
        return Region.From(region.Contours.Select(c => new Polyline(Enumerable.Range(0, c.Count).Select(i => turn.Apply(c[i])), closed: true)));
    }

    [TestCase(1.1)]
    [TestCase(0.6)]
    [TestCase(1.9)]
    public void Beads_of_a_ring_leave_nothing_open_and_nothing_twice(double thickness)
    {
        var rules = Rules();
        var region = WallShapes.Ring(4, thickness);
        var raster = new BeadRaster(region.Bounds, 0.02);
        foreach (var path in Solid(region, rules)) raster.Add(path.Points, path.Widths.Select(rules.Spacing).ToArray(), path.Closed);
        // Pixels at the border may count to either side.
        var (area, uncovered, twice, outside) = raster.Measure(region.Offset(-rules.Edge));
        Assert.That(uncovered / area, Is.LessThan(0.015));
        Assert.That(twice / area, Is.LessThan(0.015));
        Assert.That(outside / area, Is.LessThan(0.015));
    }

    [TestCase("meshes/fandisk.stl", 10.1)]
    [TestCase("meshes/igea.ply", 30.1)]
    [TestCase("meshes/homer.stl", 30.1)]
    public void The_outer_wall_follows_the_outline_within_a_hundredth_of_a_millimeter(string file, double z)
    {
        var section = MeshSections.At(TestData.Mesh(TestData.Shared(file)), [z]).Value![0];
        var region = Region.From(section.Loops).Simplified(0.0125);
        var outer = new WallBuilder(Rules(), new RegionEngine()).Build(region).Paths.Where(p => p is { Index: 0, IsExtrusion: false }).ToArray();
        // Whole contours at the nominal distance: between the outlines that are a little nearer and a little farther.
        var near = region.Offset(-0.225 + 0.0125);
        var far = region.Offset(-0.225 - 0.0125);
        double length = 0, off = 0;
        foreach (var path in outer)
        {
            for (var i = 0; i < path.SegmentCount; i++)
            {
                Vec3 a = path.Points[i], b = path.Points[(i + 1) % path.Points.Length];
                if (Math.Abs(path.Widths[i] - 0.45) > 1e-9) continue;
                var middle = (a + b) * 0.5;
                length += (b - a).LengthXY;
                if (!near.Contains(middle.X, middle.Y) || far.Contains(middle.X, middle.Y)) off += (b - a).LengthXY;
            }
        }
        Assert.That(length, Is.GreaterThan(50));
        Assert.That(off / length, Is.LessThan(0.001));
    }

    [Test]
    public void A_lone_extrusion_reaches_both_ends_of_its_shape()
    {
        var extrusion = Solid(Region.Rectangle(0, 0, 0.5, 5), Rules(BeadShape.Rectangle)).Single();
        Assert.That((extrusion.Closed, extrusion.IsExtrusion), Is.EqualTo((false, true)));
        Assert.That(extrusion.Points.Select(p => p.X), Is.All.EqualTo(0.25).Within(1e-4));
        Assert.That(extrusion.Points.Max(p => p.Y) - extrusion.Points.Min(p => p.Y), Is.EqualTo(5).Within(1e-3));
        Assert.That(extrusion.Widths, Is.All.EqualTo(0.5).Within(1e-4));
    }

    [Test]
    public void What_is_too_thin_is_reported_with_its_place_and_area()
    {
        var region = Region.Rectangle(0, 0, 10, 10).Union(Region.Rectangle(20, 0, 20.05, 10));
        var result = new WallBuilder(Rules(), new RegionEngine()).Build(region);
        Assert.That(result.TooThin, Has.Count.EqualTo(1));
        Assert.That(result.TooThin[0].Area, Is.EqualTo(0.5).Within(1e-3));
        Assert.That(result.TooThin[0].Place.DistanceTo(new Vec3(20.025, 5)), Is.LessThan(0.01));
    }

    [Test]
    public void Widths_stay_within_their_limits_and_points_within_the_region()
    {
        foreach (var region in Shapes())
        {
            foreach (var shape in new[] { BeadShape.Rectangle, BeadShape.Stadium })
            {
                var rules = Rules(shape);
                var reach = region.Offset(0.005);
                foreach (var path in Solid(region, rules))
                {
                    Assert.That(path.Widths, Has.All.InRange(rules.MinWidth - 1e-9, rules.MaxWidth + 1e-9));
                    Assert.That(path.Points.All(p => reach.Contains(p.X, p.Y)), Is.True);
                }
            }
        }
    }

    [Test]
    public void Walls_of_one_width_stay_an_option()
    {
        var rules = Rules() with { VariableWidth = false };
        var result = new WallBuilder(rules, new RegionEngine()).Build(WallShapes.Wedge(0.3, 3, 20));
        Assert.That(result.Paths.SelectMany(p => p.Widths), Is.All.EqualTo(0.45));
        Assert.That(result.Paths.Select(p => p.Closed), Is.All.True);
    }

    internal static IEnumerable<Region> Shapes()
    {
        foreach (var t in new[] { 0.44, 0.66, 0.9, 1.24, 1.5, 1.98 }) yield return WallShapes.Frame(t);
        yield return WallShapes.Wedge(0.3, 3, 20);
        yield return WallShapes.Star(5, 6, 2.5);
        yield return WallShapes.Star(9, 6, 2.5);
        foreach (var (_, region) in WallShapes.Letters()) yield return region;
    }
}
