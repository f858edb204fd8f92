using System;
using System.Linq;
using Caterpillar.Geometry;
using FsCheck;
using FsCheck.Fluent;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry;

/// <summary>Quick answers about regions that are near each other or not, and what of a region matters in a box.</summary>
public class RegionNeighborTests
{
    private static void ForAll(Action<Random> act)
        => Prop.ForAll(Gen.Choose(0, 1_000_000).ToArbitrary(), seed => act(new Random(seed))).Check(Config.QuickThrowOnFailure.WithReplay(20, 3));

    private static readonly Region Square = Region.Rectangle(0, 0, 10, 10);

    private static readonly Region Frame = Square.Subtract(Region.Rectangle(3, 3, 7, 7));

    private static Region FrameAt(double x, double y) => Region.Rectangle(x, y, x + 10, y + 10).Subtract(Region.Rectangle(x + 3, y + 3, x + 7, y + 7));

    private static Region Star(Random random, double size)
        => Region.From(RegionReference.Star(random, 3 + random.Next(30), 40 * random.NextDouble(), 40 * random.NextDouble(), size / 3, size));

    // Beside it, in its hole, across its border, within, around it, and with a common corner or side.
    [TestCase(11, 0, 12, 5, true)]
    [TestCase(4, 4, 6, 6, true)]
    [TestCase(8, 4, 12, 6, false)]
    [TestCase(1, 1, 2, 2, false)]
    [TestCase(-1, -1, 11, 11, false)]
    [TestCase(10, 10, 12, 12, false)]
    [TestCase(10, 2, 12, 4, false)]
    public void A_region_is_apart_where_it_neither_touches_nor_lies_in_nor_around(double x0, double y0, double x1, double y1, bool apart)
        => Assert.That(Frame.IsApartFrom(Region.Rectangle(x0, y0, x1, y1)), Is.EqualTo(apart));

    [Test]
    public void Everything_is_apart_from_nothing()
    {
        Assert.That(Region.Empty.IsApartFrom(Square));
        Assert.That(Square.IsApartFrom(Region.Empty));
        Assert.That(IsFarther(Region.Empty, 1, Vec3.Zero));
    }

    [Test]
    public void Regions_are_apart_where_NetTopologySuite_finds_them_disjoint() => ForAll(random =>
    {
        Region all = Star(random, 15).Union(Star(random, 15)).Subtract(Star(random, 6)), small = Star(random, 6);
        Assert.That(all.IsApartFrom(small), Is.EqualTo(RegionReference.ToNts(all).Disjoint(RegionReference.ToNts(small))));
    });

    [TestCase(12, 5, 1.99, true)]
    [TestCase(12, 5, 2.01, false)]
    [TestCase(13, 14, 4.99, true)]
    [TestCase(13, 14, 5.01, false)]
    [TestCase(5, 5, 1.99, true)]
    [TestCase(5, 5, 2.01, false)]
    [TestCase(1.5, 1.5, 0.1, false)]
    public void A_place_is_farther_than_the_nearest_side_or_corner(double x, double y, double distance, bool farther)
        => Assert.That(IsFarther(Frame, distance, new Vec3(x, y)), Is.EqualTo(farther));

    [Test]
    public void A_place_is_as_far_as_NetTopologySuite_measures() => ForAll(random =>
    {
        var region = Star(random, 15).Union(Star(random, 10));
        var place = new Vec3(60 * random.NextDouble() - 10, 60 * random.NextDouble() - 10);
        var distance = RegionReference.ToNts(region).Distance(RegionReference.ToNts(region).Factory.CreatePoint(
            new NetTopologySuite.Geometries.Coordinate(place.X, place.Y)));
        Assert.That(IsFarther(region, distance + 1e-4, place), Is.False);
        if (distance > 1e-3) Assert.That(IsFarther(region, distance - 1e-4, place));
    });

    private static bool IsFarther(Region region, double distance, Vec3 place)
        => !region.Contains(place.X, place.Y) && region.NearestEdge(place, distance) is null;

    [Test]
    public void Regions_beside_each_other_are_one_with_all_contours()
    {
        var both = Region.Beside([Frame, Region.Empty, Region.Rectangle(4, 4, 6, 6), Region.Rectangle(20, 0, 21, 1)]);
        Assert.That(both.Contours, Has.Count.EqualTo(4));
        Assert.That(both.Area, Is.EqualTo(84 + 4 + 1).Within(1e-9));
        Assert.That(both.Contains(5, 5) && !both.Contains(3.5, 5));
        Assert.That(Region.Beside([]).IsEmpty);
    }

    [Test]
    public void Regions_that_are_apart_are_beside_each_other_what_their_union_is() => ForAll(random =>
    {
        Region a = Star(random, 15), b = Star(random, 6);
        if (!a.IsApartFrom(b)) return;
        Assert.That(Region.Beside([a, b]).Xor(a.Union(b)).Area, Is.Zero);
    });

    [TestCase(0.0, 0)]
    [TestCase(0.00001, 1)]
    [TestCase(0.000011, 2)]
    [TestCase(1.5, 150_000)]
    public void A_box_grows_on_all_sides_by_whole_steps_of_the_grid(double distance, int steps)
    {
        var box = new GridBox { MinX = -5, MinY = 10, MaxX = 7, MaxY = 20 }.Grown(distance);
        Assert.That((box.MinX, box.MinY, box.MaxX, box.MaxY), Is.EqualTo((-5 - steps, 10 - steps, 7 + steps, 20 + steps)));
    }

    [Test]
    public void A_box_grows_to_the_ends_of_the_grid_and_no_farther()
    {
        var box = new GridBox { MinX = -5, MinY = 10, MaxX = 7, MaxY = 20 }.Grown(1e6);
        Assert.That((box.MinX, box.MinY, box.MaxX, box.MaxY), Is.EqualTo((int.MinValue, int.MinValue, int.MaxValue, int.MaxValue)));
    }

    [Test]
    public void Contours_near_any_of_several_places_are_near()
    {
        var rows = Region.Beside(Enumerable.Range(0, 10).Select(i => Region.Rectangle(10 * i, 0, 10 * i + 1, 1)));
        GridBox Box(double x) => Region.Rectangle(x, 0, x + 1, 1).Box;
        Assert.That(rows.Near([Box(12), Box(58)], 1.5).Contours.Select(c => c.Points.Min(p => p.X)), Is.EqualTo(new[] { 10.0, 60 }));
        Assert.That(rows.Near([Box(12)], 0.5).IsEmpty);
        Assert.That(rows.Near([], 1).IsEmpty);
    }

    [Test]
    public void A_cropped_contour_loses_the_corners_beyond_each_side_of_a_box()
    {
        var ring = Region.From(new Polyline(Enumerable.Range(0, 360).Select(d => new Vec3(50 * Math.Cos(d * Math.PI / 180), 50 * Math.Sin(d * Math.PI / 180))),
            closed: true));
        var cropped = ring.Cropped(Region.Rectangle(48, -3, 60, 3).Box);
        Assert.That(cropped.VertexCount(), Is.LessThan(20));
        Assert.That(ring.Cropped(Region.Rectangle(60, 0, 70, 1).Box).IsEmpty);
        Assert.That(ring.Cropped(Region.Rectangle(-1, -1, 1, 1).Box).Intersect(Region.Rectangle(-1, -1, 1, 1)).Area, Is.EqualTo(4).Within(1e-9));
    }

    [Test]
    public void In_the_box_a_cropped_region_is_what_it_was() => ForAll(random =>
    {
        Region region = Star(random, 20).Union(Star(random, 20)).Subtract(Star(random, 9)), small = Star(random, 8);
        var engine = new RegionEngine();
        var cropped = region.Cropped(small.Box);
        var common = RegionReference.ToNts(small).Intersection(RegionReference.ToNts(region)).Area;
        Assert.That(small.Intersect([cropped], engine).Area, Is.EqualTo(common).Within(1e-3));
        Assert.That(Region.Difference([small], [cropped], engine).Xor(small.Subtract(region)).Area, Is.EqualTo(0).Within(1e-3));
    });

    [Test]
    public void Several_regions_are_clipped_with_several_in_one_pass() => ForAll(random =>
    {
        Region a = Star(random, 15), b = Star(random, 15), c = Star(random, 12), d = Star(random, 12);
        var engine = new RegionEngine();
        Assert.That(Region.Difference([a, b], [c, d], engine).Xor(a.Union(b).Subtract(c.Union(d))).Area, Is.EqualTo(0).Within(1e-3));
        Assert.That(a.Intersect([c, d], engine).Xor(a.Intersect(c.Union(d))).Area, Is.EqualTo(0).Within(1e-3));
        Assert.That(Region.Difference([], [c], engine).IsEmpty && Region.Difference([a], [], engine).Area == a.Area && a.Intersect([], engine).IsEmpty);
    });

    [Test]
    public void Of_many_contours_the_near_ones_stay_in_their_order_and_holes_belong_to_the_outline_around_them() => ForAll(random =>
    {
        var many = Region.Beside(Enumerable.Range(0, 100).Select(i => FrameAt(20 * (i % 12), 20 * (i / 12))));
        var boxes = Enumerable.Range(0, 1 + random.Next(3)).Select(_ => (X: 250 * random.NextDouble(), Y: 190 * random.NextDouble()))
            .Select(p => Region.Rectangle(p.X, p.Y, p.X + 50 * random.NextDouble() + 1, p.Y + 9).Box).ToArray();
        bool IsNear(GridPoint[] path) => boxes.Any(b => GridBox.Overlap(GridBox.Of(path), b));
        Assert.That(many.Near(boxes, 0).Paths, Is.EqualTo(many.Paths.Where(IsNear)));
        Assert.That(many.Islands, Has.Count.EqualTo(100));
        Assert.That(many.Islands, Has.All.Matches<Region>(i => i.Paths.Length == 2 && i.Area == Frame.Area));
    });
}
