using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using FsCheck;
using FsCheck.Fluent;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

/// <summary>Supports as trees: tips, places with a free descent, branches.</summary>
public class TreeTests
{
    private static readonly PrintSettings Settings = new()
    {
        LineWidth = 0.4, BeadShape = BeadShape.Rectangle, TopLayers = 0, BottomLayers = 0, InfillDensityPercent = 0, WallCount = 1, MinLayerTime = 0,
        Support = SupportKind.Tree,
    };

    private static readonly Role[] Roles = [Role.Support, Role.SupportInterface];

    private static void ForAll(Action<Random> act)
        => Prop.ForAll(Gen.Choose(0, 1_000_000).ToArbitrary(), seed => act(new Random(seed))).Check(Config.QuickThrowOnFailure.WithReplay(20, 3));

    // A slab of 12 mm at a height on a post beside it.
    private static TriMesh[] Shelf(double z) => [Solids.Block(0, 0, 0, 3, 12, z + 2), Solids.Block(0, 0, z, 15, 12, z + 2)];

    // The circle within the polygon has the radius less a tolerance: r cos(180° / n).
    [TestCase(0.4, 6)]
    [TestCase(1, 8)]
    [TestCase(2.5, 12)]
    public void A_branch_has_as_few_corners_as_the_tolerance_of_a_twentieth_of_a_millimeter_allows(double radius, int corners)
    {
        var node = new TreeNode(0, new Vec3(3, 4)) { Radius = radius };
        var ring = node.Region.Contours.Single();
        Assert.That(ring, Has.Count.EqualTo(corners));
        Assert.That(Enumerable.Range(0, corners).Select(k => ring[k].DistanceTo(node.Place)), Is.All.EqualTo(radius + 0.05).Within(1e-4));
        // n / 2 · r² · sin(360° / n).
        Assert.That(node.Region.Area, Is.EqualTo(corners / 2.0 * Math.Pow(radius + 0.05, 2) * Math.Sin(2 * Math.PI / corners)).Within(1e-3));
    }

    [Test]
    public void Tips_stand_along_the_edges_and_within_and_no_nearer_than_most_of_their_distance() => ForAll(random =>
    {
        double width = 1 + 30 * random.NextDouble(), depth = 1 + 30 * random.NextDouble();
        var tips = new TreeTips(4, 0.4).Below(Region.Rectangle(0, 0, width, depth), 10);
        Assert.That(tips, Is.Not.Empty);
        Assert.That(tips.All(t => t.X >= 0.2 - 1e-3 && t.Y >= 0.2 - 1e-3 && t.X <= width - 0.2 + 1e-3 && t.Y <= depth - 0.2 + 1e-3));
        for (var i = 0; i < tips.Count; i++) Assert.That(tips.Skip(i + 1).All(t => t.DistanceTo(tips[i]) > 0.7 * 4 - 1e-9));
        for (var k = 0; k < 20; k++)
        {
            var place = new Vec3(width * random.NextDouble(), depth * random.NextDouble(), 10);
            Assert.That(tips.Min(t => t.DistanceTo(place)), Is.LessThan(4 + 0.3), "nothing is far from all tips");
        }
    });

    // Rows every 5 mm, ending on edges 0.2 mm inside.
    [Test]
    public void Rows_that_tips_carry_begin_and_end_on_one()
    {
        var area = Region.From(new Polyline([new(0, 1), new(30, 1), new(17.6, 26), new(12.4, 26)], closed: true));
        var tips = new TreeTips(5, 0.4).Below(area, 10);
        foreach (var row in area.Offset(-0.2).HatchLines(0, 5).Where(r => r.From.DistanceTo(r.To) >= 5))
        {
            foreach (var end in new[] { row.From, row.To }) Assert.That(tips.Min(t => (t - end).LengthXY), Is.LessThan(0.05), $"{end}");
        }
        Assert.That(tips.Count(t => Math.Abs(t.Y - 10) < 0.01), Is.GreaterThan(4), "and others between them");
    }

    [Test]
    public void What_lies_close_above_tips_needs_no_others()
    {
        var tips = new TreeTips(4, 0.4);
        Assert.That(tips.Below(Region.Rectangle(0, 0, 1, 1), 10), Has.Count.EqualTo(1), "in the middle");
        Assert.That(tips.Below(Region.Rectangle(1, 0, 2, 1), 10.2), Is.Empty);
        Assert.That(tips.Below(Region.Rectangle(1, 0, 2, 1), 20), Has.Count.EqualTo(1));
    }

    [Test]
    public void A_path_leads_to_the_bed_where_branches_can_lean_out_far_enough()
    {
        // A plate 10 mm wide up to 1 mm, layers of 0.2 mm, and nothing above: 45° bring a branch of 0.5 mm out from 2 mm within the plate 2.5 mm above it.
        var plate = Region.Rectangle(0, 0, 10, 10);
        var levels = Enumerable.Range(0, 40).Select(i => (i < 5 ? new[] { plate } : [], 0.2)).ToArray();
        var space = new TreeSpace(levels, 0.5, 1, new ParallelOptions());
        Assert.That(space.IsBlocked(4, new Vec3(-0.4, 5)) && !space.IsBlocked(4, new Vec3(-0.6, 5)) && !space.IsBlocked(5, new Vec3(5, 5)));
        bool IsTrapped(double within, double above) => space.IsTrapped(4 + (int)Math.Round(above / 0.2), new Vec3(within, 5));
        // With a twentieth less of lean.
        Assert.That((IsTrapped(2, 2), IsTrapped(2, 3)), Is.EqualTo((true, false)));
        Assert.That((IsTrapped(5, 5), IsTrapped(5, 6)), Is.EqualTo((true, false)));
        Assert.That(space.NearestExit(9, new Vec3(2, 5)).X, Is.EqualTo(-0.5 + 0.95).Within(0.05));
        Assert.That(space.Room(4, new Vec3(-1.5, 5)), Is.EqualTo(1).Within(0.02));
        Assert.That((space.Room(4, new Vec3(5, 5)), space.Room(4, new Vec3(-9, 5))), Is.EqualTo((0, 5)));
    }

    [Test]
    public void Branches_join_on_their_way_down()
    {
        var layers = Solids.Slice(Settings, Shelf(30));
        int Pieces(double z) => layers.First(l => l.Layer.Z > z).Support.Islands.Count;
        Assert.That(Pieces(28.5), Is.GreaterThan(6), "tips");
        Assert.That((Pieces(15), Pieces(1)), Is.EqualTo((1, 1)), "a trunk");
    }

    [Test]
    public void Branches_are_single_walls_that_get_thicker_downwards_as_far_as_they_may()
    {
        var layers = Solids.Slice(Settings with { TreeBranchDiameter = 3 }, Shelf(40));
        double Width(double z) => layers.First(l => l.Layer.Z > z).Support.Bounds.Size.X;
        Assert.That((Width(20), Width(5)), Is.EqualTo((3.0, 3.0)).Using<double>((a, b) => Math.Abs(a - b) < 0.15));
        Assert.That(Width(0), Is.GreaterThan(4), "the foot");
        foreach (var layer in layers.Where(l => l.Layer.Z is > 2 and < 20))
            Assert.That(Solids.Paths(layer, Roles).Select(p => p.IsClosed), Is.EqualTo(new[] { true }));
        var thin = Solids.Slice(Settings with { TreeBranchDiameterAngle = 0 }, Shelf(40));
        Assert.That(thin.First(l => l.Layer.Z > 5).Support.Bounds.Size.X, Is.LessThan(1.1));
    }

    [Test]
    public void Trunks_are_smooth()
    {
        // Where two branches become one there are no more tips above than here: no kink, at most a few degrees from layer to layer.
        var layers = Solids.Slice(Settings, Shelf(40)).Where(l => l.Layer.Z is > 3 and < 25).ToArray();
        Assert.That(layers.Select(l => l.Support.Islands.Count), Is.All.EqualTo(1));
        var places = Array.ConvertAll(layers, l => l.Support.Bounds.Center);
        for (var i = 2; i < places.Length; i++)
            Assert.That((places[i] - 2 * places[i - 1] + places[i - 2]).LengthXY, Is.LessThan(0.06));
    }

    [Test]
    public void Branches_go_around_the_part_where_a_path_leads_to_the_bed()
    {
        // A foot below half of the shelf: all of it can be held from the bed.
        TriMesh[] model = [.. Shelf(30), Solids.Block(2, 0, 0, 8, 12, 3)];
        foreach (var place in new[] { SupportPlacement.Everywhere, SupportPlacement.BuildPlate })
        {
            var layers = Solids.Slice(Settings with { SupportPlacement = place }, model);
            Assert.That(layers.First(l => l.Layer.Z > 3).Support.Intersect(Region.Rectangle(0, 0, 8, 12)).Area, Is.Zero, $"{place}");
            Assert.That(layers.First(l => l.Layer.Z > 29.3).Support.Area, Is.GreaterThan(0.95 * 11 * 12), $"{place}");
        }
    }

    [Test]
    public void Branches_end_on_the_part_where_it_lies_close_below()
    {
        // 4 mm below a shelf at 30 mm: less than a sixth of its height.
        TriMesh[] model = [.. Shelf(30), Solids.Block(2, 0, 0, 8, 12, 26)];
        double Standing(SupportPlacement place) => Solids.Slice(Settings with { SupportPlacement = place }, model)
            .First(l => l.Layer.Z > 26.5).Support.Intersect(Region.Rectangle(3, 0, 6, 12)).Area;
        Assert.That(Standing(SupportPlacement.Everywhere), Is.GreaterThan(2));
        Assert.That(Standing(SupportPlacement.BuildPlate), Is.Zero);
    }

    // Slopes from the bed: each layer leans out by 0.2 / tan(slope) mm.
    [TestCase(20)]
    [TestCase(30)]
    public void Roofs_below_a_slope_keep_half_a_line_more_from_it_and_lie_on_one_another(double slope)
    {
        var settings = Settings with { SupportAngle = 50, SupportXyGap = 0.6 };
        TriMesh[] model = [Solids.Cone(0, 3, 5, 3), Solids.Cone(4.99, 3, 5 + 12 * Math.Tan(slope * Math.PI / 180), 15)];
        var layers = Solids.Slice(settings, model);
        var strips = 0;
        for (var i = 1; i < layers.Count; i++)
        {
            var (support, below) = (layers[i].Support, layers[i - 1].Support);
            if (layers[i].Layer.Z < 5.5 || support.IsEmpty) continue;
            Assert.That(support.Intersect(layers[i].Region.Offset(0.6 + 0.2, JoinStyle.Round)).Area, Is.LessThan(0.15 * support.Area), $"{layers[i].Layer.Z}");
            // Rings around the cone, between branches.
            if (support.Contours.Count < 2) continue;
            strips++;
            Assert.That(support.Subtract(below).Area, Is.LessThan(0.6 * support.Area), $"{layers[i].Layer.Z}");
        }
        Assert.That(strips, Is.GreaterThan(10));
    }

    [Test]
    public void Between_supports_nothing_is_retracted_where_no_part_is_in_the_way()
    {
        // Tips on both sides of a wall.
        TriMesh[] model = [Solids.Block(10, 0, 0, 12, 12, 12), Solids.Block(2, 0, 10, 20, 12, 12)];
        var steps = Solids.Slice(Settings, model).First(l => l.Layer.Z > 8).Steps.Where(s => Roles.Contains(s.Path.Role)).ToArray();
        Assert.That(steps.Select(s => s.Region).Distinct().Count(), Is.EqualTo(1));
        var (region, left) = (steps[0].Region!, steps.Where(s => s.Path.Start.X < 10).Select(s => s.Path.Start).ToArray());
        Assert.That(left, Has.Length.GreaterThan(1));
        Assert.That(left.All(a => left.Any(b => b != a && region.ContainsLine(a, b))));
        Assert.That(steps.Where(s => s.Path.Start.X > 12).All(s => !region.ContainsLine(left[0], s.Path.Start)));
    }

    [TestCase(5, 1)]
    [TestCase(60, 2)]
    public void Branches_that_are_near_each_other_are_printed_in_one_go(double apart, int islands)
    {
        var far = Shelf(10).Select(b => b.Moved(new Vec3(15 + apart, 0)));
        var steps = Solids.Slice(Settings, [.. Shelf(10), .. far]).First(l => l.Layer.Z > 5).Steps.Where(s => Roles.Contains(s.Path.Role));
        Assert.That(steps.Select(s => s.Group!.Value.Island).Distinct().Count(), Is.EqualTo(islands));
    }

    // A cylinder that leans out: 70° from the bed are 20° from the vertical.
    [TestCase(20, false)]
    [TestCase(45, false)]
    [TestCase(70, true)]
    public void The_angle_of_overhangs_is_measured_from_the_vertical(double angle, bool held)
    {
        var (rise, low) = (20, Solids.Circle(4, 48));
        var aside = new Vec3(rise * Math.Tan(angle * Math.PI / 180), 0);
        var layers = Solids.Slice(Settings with { SupportAngle = 50 }, Solids.Loft(0, low, rise, [.. low.Select(p => p + aside)]));
        Assert.That(layers.Any(l => Solids.Paths(l, Roles).Length > 0), Is.EqualTo(held));
    }
}
