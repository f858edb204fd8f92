using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

public class TopBottomFinderTests
{
    private static readonly PrintSettings Plain = new()
    {
        LayerHeight = 0.2, LineWidth = 0.4, TopLayers = 4, BottomLayers = 3, TopThickness = 0, BottomThickness = 0,
        SolidInfillExpansion = 0.6, MinSolidWidth = 0.2, BridgeAnchor = 1, SolidInfillThresholdArea = 0,
    };

    [Test]
    public void The_tread_of_a_stair_is_a_top_surface_that_extends_under_the_next_step()
    {
        var stair = Stack(Plain, (10, Region.Rectangle(0, 0, 20, 20)), (10, Region.Rectangle(0, 0, 10, 20)));
        var inside = Region.Rectangle(1, 1, 19, 19);
        var tread = Areas(stair, 9, inside);
        // Open to the sky from x = 10 on, and 0.6 mm under the step.
        Assert.That(tread.Top.Area, Is.EqualTo(9.6 * 18).Within(1e-3));
        Assert.That(tread.Top.Bounds.Min.X, Is.EqualTo(9.4).Within(1e-4));
        Assert.That((tread.Solid.IsEmpty, tread.Bottom.IsEmpty, tread.Bridges.Count), Is.EqualTo((true, true, 0)));
        Assert.That(tread.Sparse.Area, Is.EqualTo(8.4 * 18).Within(1e-3));
        // Three more solid layers below it, not four.
        foreach (var layer in new[] { 8, 7, 6 })
        {
            var below = Areas(stair, layer, inside);
            Assert.That(below.Solid.Area, Is.EqualTo(9.6 * 18).Within(1e-3));
            Assert.That(below.Top.IsEmpty, Is.True);
        }
        Assert.That(Areas(stair, 5, inside).Sparse, Is.SameAs(inside));
        Assert.That(Areas(stair, 0, inside).Bottom, Is.SameAs(inside));
        Assert.That(Areas(stair, 2, inside).Solid, Is.SameAs(inside));
        Assert.That(Areas(stair, 3, inside).Sparse, Is.SameAs(inside));
        Assert.That(Areas(stair, 19, Region.Rectangle(1, 1, 9, 19)).Top.Area, Is.EqualTo(8 * 18).Within(1e-3));
    }

    [Test]
    public void Thin_layers_get_more_closed_layers_until_their_thickness_suffices()
    {
        var block = Stack(Plain with { TopThickness = 1.1 }, (20, Region.Rectangle(0, 0, 20, 20)));
        var inside = Region.Rectangle(1, 1, 19, 19);
        // 1.1 mm of 0.2 mm layers: six.
        Assert.That(Enumerable.Range(10, 10).Select(i => Areas(block, i, inside).Sparse.IsEmpty), Is.EqualTo(Enumerable.Range(10, 10).Select(i => i >= 14)));
    }

    [Test]
    public void A_slab_over_two_pillars_is_a_bridge_along_the_gap()
    {
        var pillars = Region.Rectangle(0, 0, 5, 10).Union(Region.Rectangle(15, 0, 20, 10));
        var areas = Areas(Stack(Plain, (5, pillars), (5, Region.Rectangle(0, 0, 20, 10))), 5, Region.Rectangle(1, 1, 19, 9));
        var bridge = areas.Bridges.Single();
        // 10 mm of air and 1 mm on each pillar.
        Assert.That(bridge.Area.Area, Is.EqualTo(12 * 8).Within(1e-3));
        Assert.That(bridge.Angle % 180, Is.EqualTo(0).Within(1e-9));
        Assert.That(areas.Bottom.IsEmpty, Is.True);
    }

    [Test]
    public void A_bridge_over_a_slanted_gap_runs_straight_across_it()
    {
        // A hole of 8 mm by 24 mm, turned by 30°.
        var slab = Region.Rectangle(-20, -20, 20, 20);
        var (sin, cos) = Caterpillar.Basics.Angle.SinCos(30);
        Vec3 Turned(double x, double y) => new(x * cos - y * sin, x * sin + y * cos);
        var gap = Region.From(new Polyline([Turned(-4, -12), Turned(4, -12), Turned(4, 12), Turned(-4, 12)], true));
        var bridge = Areas(Stack(Plain, (3, slab.Subtract(gap)), (3, slab)), 3, Region.Rectangle(-19, -19, 19, 19)).Bridges.Single();
        Assert.That((bridge.Angle % 180 + 180) % 180, Is.EqualTo(30).Within(8));
    }

    [Test]
    public void A_balcony_is_held_on_one_side_only_and_is_no_bridge()
    {
        var areas = Areas(Stack(Plain, (5, Region.Rectangle(0, 0, 5, 10)), (5, Region.Rectangle(0, 0, 20, 10))), 5, Region.Rectangle(1, 1, 19, 9));
        Assert.That(areas.Bridges, Is.Empty);
        Assert.That(areas.Bottom.Area, Is.EqualTo(15 * 8).Within(1e-3));
    }

    [Test]
    public void Slivers_are_left_to_the_walls_and_small_pieces_of_infill_are_closed()
    {
        var inside = Region.Rectangle(1, 1, 19, 19);
        // The layer above leaves 0.15 mm of the inside open: narrower than 0.2 mm.
        var narrow = Stack(Plain, (5, Region.Rectangle(0, 0, 20, 20)), (5, Region.Rectangle(0, 0, 18.85, 20)));
        Assert.That(Areas(narrow, 4, inside).Sparse.Area, Is.EqualTo(18 * 18).Within(1e-3));
        var small = Areas(Stack(Plain with { SolidInfillThresholdArea = 400 }, (20, Region.Rectangle(0, 0, 20, 20))), 10, inside);
        Assert.That((small.Sparse.IsEmpty, small.Solid.Area), Is.EqualTo((true, inside.Area)));
        var hollow = Areas(Stack(Plain with { SolidInfillThresholdArea = 400, InfillDensityPercent = 0 }, (20, Region.Rectangle(0, 0, 20, 20))), 10, inside);
        Assert.That(hollow.Sparse, Is.SameAs(inside));
        var tiny = Region.Rectangle(5, 5, 5.8, 5.8);
        Assert.That(Areas(Stack(Plain with { InfillDensityPercent = 0 }, (20, Region.Rectangle(0, 0, 20, 20))), 10, tiny).Sparse, Is.SameAs(tiny));
    }

    [Test]
    public void The_areas_cover_the_inside_and_do_not_overlap([Range(1, 40)] int seed)
    {
        var random = new System.Random(seed);
        Region Blob() => Region.Union(Enumerable.Range(0, 4).Select(_ =>
        {
            double x = random.Next(0, 20), y = random.Next(0, 20);
            return Region.Rectangle(x, y, x + 4 + 10 * random.NextDouble(), y + 4 + 10 * random.NextDouble());
        }));
        var stack = Stack(Plain with { SolidInfillThresholdArea = 5 }, Enumerable.Range(0, 8).Select(_ => (1, Blob())).ToArray());
        for (var i = 0; i < 8; i++)
        {
            var inside = stack.Layers[i].Region.Offset(-0.8);
            if (inside.IsEmpty) continue;
            var areas = Areas(stack, i, inside);
            var parts = new[] { areas.Top, areas.Bottom, areas.Solid, areas.Sparse }.Concat(areas.Bridges.Select(b => b.Area)).ToArray();
            Assert.That(Region.Union(parts).Area, Is.EqualTo(inside.Area).Within(1e-3));
            Assert.That(parts.Sum(p => p.Area), Is.EqualTo(inside.Area).Within(1e-3));
            Assert.That(Region.Union(parts).Subtract(inside).Area, Is.LessThan(1e-3));
        }
    }

    [Test]
    public void A_region_surrounds_what_it_contains_with_a_distance([Range(1, 60)] int seed)
    {
        var random = new System.Random(seed);
        Region Blob() => Region.Union(Enumerable.Range(0, 3).Select(_ =>
        {
            double x = random.Next(0, 12), y = random.Next(0, 12);
            return Region.Rectangle(x, y, x + 2 + 6 * random.NextDouble(), y + 2 + 6 * random.NextDouble());
        }));
        var a = Blob().Offset(random.NextDouble() * 3);
        var b = Blob();
        if (random.Next(2) == 0) a = a.Subtract(Region.Rectangle(5, 5, 5 + random.NextDouble(), 6));
        if (a.Surrounds(b)) Assert.That(b.Subtract(a).IsEmpty, Is.True);
        else Assert.That(b.Offset(0.01).Subtract(a).IsEmpty, Is.False);
    }

    private static Body Stack(PrintSettings settings, params (int Count, Region Region)[] parts)
    {
        var body = new Body(new NamedMesh("stack", TriMesh.Empty), 0);
        var rules = SliceRules.Of(settings, 0.2);
        body.Layers = parts.SelectMany(p => Enumerable.Repeat(p.Region, p.Count))
            .Select((region, i) => new LayerWork(body, i, new PlannedLayer(0.2 * (i + 1), 0.2, 0.2 * i + 0.1), rules) { Region = region }).ToArray();
        return body;
    }

    private static IslandAreas Areas(Body body, int layer, Region inside)
        => new TopBottomFinder(body.Layers[layer], body.Layers[layer].Rules, new RegionEngine()).Find(inside);
}
