using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Tests.Geometry.Meshes;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry;

/// <summary>Parts of geometry against slow answers.</summary>
public class SmallGeometryTests
{
    [TestCase("0,0 1,0 2,0 3,0", 0.01, "0,0")]
    [TestCase("0,0 1,0.05 2,0 3,0", 0.01, "0,0 1,0.05 2,0")]
    [TestCase("0,0 1,0.05 2,0 3,0", 0.06, "0,0")]
    [TestCase("0,0 2,0 1,0 3,0", 0.01, "0,0 2,0 1,0")]
    [TestCase("0,0 2,0 2,2 0,2 0,0", 0.01, "0,0 2,0 2,2 0,2")]
    [TestCase("0,0 1,0 2,0 2,1 2,2 2,3", 0.01, "0,0 2,0")]
    [TestCase("0,0 1,0 0,0", 0.01, "0,0 1,0")]
    public void Points_that_straight_pieces_do_not_need_are_left_away(string line, double tolerance, string kept)
    {
        var points = line.Split(' ').Select(p => p.Split(',')).Select(p => new Vec3(Number(p[0]), Number(p[1]))).ToList();
        var thin = LineThinner.Thin(points, tolerance);
        Assert.That(string.Join(" ", thin.Select(p => FormattableString.Invariant($"{p.X},{p.Y}"))), Is.EqualTo(kept));
    }

    private static double Number(string text) => double.Parse(text, System.Globalization.CultureInfo.InvariantCulture);

    [Test]
    public void Long_straight_lines_keep_a_point_in_64()
        => Assert.That(LineThinner.Thin([.. Enumerable.Range(0, 200).Select(i => new Vec3(i, 0))], 0.01).Select(p => p.X),
            Is.EqualTo(new[] { 0.0, 64, 128, 192 }));

    [TestCase(0.1)]
    [TestCase(0.001)]
    public void A_segment_is_divided_until_its_image_is_smooth(double tolerance)
    {
        static Vec3 Bend(Vec3 p) => p.WithZ(p.X * p.X / 10);
        var (points, shares) = (new List<Vec3>(), new List<double>());
        SmoothDivision.Divide(Vec3.Zero, new Vec3(10, 0), null, tolerance, run => Array.ConvertAll(run, Bend), points, shares);
        Assert.That((points[points.Count - 1], shares.Count), Is.EqualTo((new Vec3(10, 0), points.Count)));
        Assert.That(shares.Sum(), Is.EqualTo(1).Within(1e-12));
        var from = Vec3.Zero;
        for (var i = 0; i < points.Count; i++)
        {
            Assert.That(points[i].X - from.X, Is.EqualTo(10 * shares[i]).Within(1e-9));
            Assert.That(Bend(Vec3.Lerp(from, points[i], 0.5)).DistanceToSegment(Bend(from), Bend(points[i])), Is.LessThanOrEqualTo(tolerance));
            from = points[i];
        }
        Assert.That(points.Count, Is.LessThan(20 / Math.Sqrt(tolerance)), "Not without need.");
        var straight = new List<Vec3>();
        SmoothDivision.Divide(Vec3.Zero, new Vec3(10, 0), null, tolerance, run => run, straight);
        Assert.That(straight, Is.EqualTo(new[] { new Vec3(10, 0) }));
    }

    private static Region Rectangle(double x0, double y0, double x1, double y1) => Region.Rectangle(x0, y0, x1, y1);

    [Test]
    public void Regions_surround_others_that_do_not_come_to_their_boundary()
    {
        var ring = Rectangle(0, 0, 20, 20).Subtract(Rectangle(8, 8, 12, 12));
        Assert.That(ring.Surrounds(Rectangle(2, 2, 6, 6)), Is.True);
        Assert.That(ring.Surrounds(Rectangle(2, 2, 18, 18)), Is.False, "Its hole is in there.");
        Assert.That(ring.Surrounds(Rectangle(9, 9, 11, 11)), Is.False, "In the hole.");
        Assert.That(ring.Surrounds(Rectangle(0, 2, 6, 6)), Is.False, "At the edge.");
        Assert.That(ring.Surrounds(Rectangle(6, 6, 10, 10)), Is.False);
        Assert.That(ring.Surrounds(Rectangle(-5, 2, -1, 6)), Is.False);
        Assert.That(ring.Surrounds(Region.Empty), Is.True);
        Assert.That(Region.Empty.Surrounds(ring), Is.False);
        Assert.That(ring.Surrounds(Rectangle(2, 2, 18, 18).Subtract(Rectangle(7, 7, 13, 13))), Is.True, "Around the hole.");
    }

    [Test]
    public void Regions_are_apart_where_neither_touches_nor_holds_the_other()
    {
        var ring = Rectangle(0, 0, 20, 20).Subtract(Rectangle(8, 8, 12, 12));
        Assert.That(ring.IsApartFrom(Rectangle(9, 9, 11, 11)), Is.True);
        Assert.That(ring.IsApartFrom(Rectangle(30, 0, 40, 9)), Is.True);
        Assert.That(ring.IsApartFrom(Rectangle(2, 2, 6, 6)), Is.False);
        Assert.That(ring.IsApartFrom(Rectangle(15, 15, 25, 25)), Is.False);
        Assert.That(ring.IsApartFrom(Rectangle(-5, -5, 25, 25)), Is.False);
        Assert.That(ring.IsApartFrom(Region.Empty), Is.True);
        Assert.That((ring.SameAs(Rectangle(0, 0, 20, 20).Subtract(Rectangle(8, 8, 12, 12))), ring.SameAs(Rectangle(0, 0, 20, 20)), ring.SameAs(ring)),
            Is.EqualTo((true, false, true)));
    }

    [Test]
    public void Inside_of_a_box_a_cropped_region_covers_the_same_with_fewer_corners()
    {
        var random = new Random(4);
        for (var round = 0; round < 30; round++)
        {
            var star = Region.From(new Polyline(Enumerable.Range(0, 60).Select(i =>
            {
                var (sin, cos) = Caterpillar.Basics.Angle.SinCos(6 * i);
                return new Vec3(cos, sin) * (10 + 20 * random.NextDouble());
            }), closed: true));
            double x = random.NextDouble() * 40 - 30, y = random.NextDouble() * 40 - 30;
            var frame = Rectangle(x, y, x + 12, y + 9);
            var cropped = star.Cropped(frame.Box);
            Assert.That(cropped.Intersect(frame).Area, Is.EqualTo(star.Intersect(frame).Area).Within(1e-6));
            Assert.That(cropped.Contours.Sum(c => c.Count), Is.LessThanOrEqualTo(star.Contours.Sum(c => c.Count)));
            Assert.That(star.Near(frame.Box).Intersect(frame).Area, Is.EqualTo(star.Intersect(frame).Area).Within(1e-6));
        }
        Assert.That(Rectangle(0, 0, 5, 5).Union(Rectangle(50, 0, 55, 5)).Near(Rectangle(40, 0, 49, 9).Box).Area, Is.Zero);
        Assert.That(Rectangle(0, 0, 5, 5).Union(Rectangle(50, 0, 55, 5)).Near([Rectangle(40, 0, 49, 9).Box], 2).Area, Is.EqualTo(25).Within(1e-9));
    }

    [Test]
    public void Each_hole_belongs_to_the_smallest_outline_around_it()
    {
        var nested = Rectangle(0, 0, 30, 30).Subtract(Rectangle(5, 5, 25, 25)).Union(Rectangle(8, 8, 20, 20).Subtract(Rectangle(10, 10, 12, 12)))
            .Union(Rectangle(40, 0, 50, 10));
        var islands = IslandFinder.Split(nested).OrderBy(i => i.Area).ToArray();
        Assert.That(islands.Select(i => (i.Contours.Count, Math.Round(i.Area, 6))), Is.EqualTo(new[] { (1, 100.0), (2, 140.0), (2, 500.0) }));
        Assert.That(islands[1].Box, Is.EqualTo(Rectangle(8, 8, 20, 20).Box));
        Assert.That(IslandFinder.Split(islands[2]).Single(), Is.SameAs(islands[2]));
    }

    [Test]
    public void Distances_from_a_mesh_are_the_nearest_of_all_triangles_with_a_side()
    {
        var random = new Random(6);
        var box = MeshMaker.Box(-1, -2, -3, 4, 5, 6);
        var distance = new MeshDistance(box);
        for (var i = 0; i < 300; i++)
        {
            var p = new Vec3(random.NextDouble() * 14 - 5, random.NextDouble() * 16 - 6, random.NextDouble() * 18 - 7);
            var near = distance.Nearest(p);
            var clamped = new Vec3(Math.Min(Math.Max(p.X, -1), 4), Math.Min(Math.Max(p.Y, -2), 5), Math.Min(Math.Max(p.Z, -3), 6));
            var inner = new[] { p.X + 1, 4 - p.X, p.Y + 2, 5 - p.Y, p.Z + 3, 6 - p.Z }.Min();
            Assert.That(near.Distance, Is.EqualTo(inner > 0 ? -inner : p.DistanceTo(clamped)).Within(1e-9), p.ToString());
            Assert.That((p - near.Point).Length, Is.EqualTo(Math.Abs(near.Distance)).Within(1e-9));
            Assert.That((near.OnRim, near.Normal.Length), Is.EqualTo((false, 1.0)).Within(1e-9));
        }
        var sheet = new MeshDistance(TriMesh.Create([new Vec3(0, 0), new Vec3(4, 0), new Vec3(4, 4), new Vec3(0, 4)], [0, 1, 2, 0, 2, 3]));
        Assert.That((sheet.Nearest(new Vec3(1, 2, 3)).Distance, sheet.Nearest(new Vec3(1, 2, -3)).Distance), Is.EqualTo((3.0, -3.0)));
        Assert.That((sheet.Nearest(new Vec3(2, 2, 1)).OnRim, sheet.Nearest(new Vec3(5, 2, 1)).OnRim, sheet.Nearest(new Vec3(5, 5, 1)).OnRim),
            Is.EqualTo((false, true, true)));
        Assert.That(() => new MeshDistance(TriMesh.Create([], [])), Throws.ArgumentException);
    }

    [TestCase("1,2,3,4")]
    [TestCase("2.5")]
    [TestCase("0,0.1,0.2,7.5,9")]
    [TestCase("-5,99")]
    public void Each_height_has_the_triangles_that_its_plane_cuts(string heights)
    {
        var random = new Random(2);
        var points = Enumerable.Range(0, 60).Select(_ => new Vec3(random.NextDouble(), random.NextDouble(), random.Next(0, 20) / 2.0)).ToArray();
        var mesh = TriMesh.Create(points, [.. Enumerable.Range(0, 180).Select(i => i % 3 * 20 + random.Next(20))]);
        var levels = heights.Split(',').Select(Number).ToArray();
        var buckets = new LayerBuckets(mesh, levels);
        var all = new List<int>();
        for (var i = 0; i < levels.Length; i++)
        {
            var cut = Enumerable.Range(0, mesh.TriangleCount).Where(t =>
            {
                var (a, b, c) = mesh.Triangle(t);
                var z = new[] { mesh.Vertices[a].Z, mesh.Vertices[b].Z, mesh.Vertices[c].Z };
                return z.Min() < levels[i] && levels[i] <= z.Max();
            }).ToArray();
            Assert.That(buckets.Counts[i], Is.EqualTo(cut.Length));
            Assert.That(buckets.Fill(i, i + 1), Is.EqualTo(cut));
            all.AddRange(cut);
        }
        Assert.That(buckets.Fill(0, levels.Length), Is.EqualTo(all));
    }
}
