using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Tests.Geometry.Meshes;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry;

/// <summary>Points, boxes, frames, maps and lines, worked out by hand.</summary>
public class BasicShapeTests
{
    [Test]
    public void Points_are_added_multiplied_and_measured()
    {
        Vec3 a = new(1, 2, 3), b = new(5, -7, 11);
        Assert.That((a + b, a - b, -a), Is.EqualTo((new Vec3(6, -5, 14), new Vec3(-4, 9, -8), new Vec3(-1, -2, -3))));
        Assert.That((a * 2, 2 * a, b / 2), Is.EqualTo((new Vec3(2, 4, 6), new Vec3(2, 4, 6), new Vec3(2.5, -3.5, 5.5))));
        Assert.That(Vec3.Dot(a, b), Is.EqualTo(5 - 14 + 33));
        Assert.That(Vec3.Cross(a, b), Is.EqualTo(new Vec3(2 * 11 + 3 * 7, 3 * 5 - 11, -7 - 2 * 5)));
        Assert.That((new Vec3(3, 4, 12).Length, new Vec3(3, 4, 12).LengthXY, new Vec3(3, 4, 12).LengthSquared), Is.EqualTo((13.0, 5.0, 169.0)));
        Assert.That((Vec3.Lerp(a, b, 0), Vec3.Lerp(a, b, 1), Vec3.Lerp(a, b, 0.5)), Is.EqualTo((a, b, new Vec3(3, -2.5, 7))));
        Assert.That(a.DistanceTo(a + new Vec3(2, 3, 6)), Is.EqualTo(7));
        Assert.That(new Vec3(0, 3, 4).Unit().DistanceTo(new Vec3(0, 0.6, 0.8)), Is.LessThan(1e-15));
        foreach (var wrong in new[] { double.NaN, double.PositiveInfinity, double.NegativeInfinity })
        {
            Assert.That(new Vec3(wrong, 0).IsFinite | new Vec3(0, wrong).IsFinite | new Vec3(0, 0, wrong).IsFinite, Is.False);
        }
        foreach (var other in new[] { new Vec3(9, 2, 3), new Vec3(1, 9, 3), new Vec3(1, 2, 9) })
            Assert.That((a == other, a != other, a.Equals(other), a.Equals((object)other)), Is.EqualTo((false, true, false, false)));
        Assert.That((a.WithZ(9), a.Equals((object)new Vec3(1, 2, 3)), a.GetHashCode() == new Vec3(1, 2, 3).GetHashCode()),
            Is.EqualTo((new Vec3(1, 2, 9), true, true)));
    }

    [TestCase(0, 0, 0, true)]
    [TestCase(2, 3, 4, true)]
    [TestCase(-0.001, 1, 1, false)]
    [TestCase(2.001, 1, 1, false)]
    [TestCase(1, -0.001, 1, false)]
    [TestCase(1, 3.001, 1, false)]
    [TestCase(1, 1, -0.001, false)]
    [TestCase(1, 1, 4.001, false)]
    public void A_box_contains_what_is_inside_or_on_it(double x, double y, double z, bool inside)
    {
        var box = new Bounds(Vec3.Zero, new Vec3(2, 3, 4));
        Assert.That(box.Contains(new Vec3(x, y, z)), Is.EqualTo(inside));
        Assert.That(box.Contains(new Vec3(x, y, z), 0.0011), Is.True);
        Assert.That(box.Contains(new Vec3(x, y, z), 0.0009), Is.EqualTo(inside));
        Assert.That(box.Contains(Bounds.Empty.Include(new Vec3(1, 1, 1)).Include(new Vec3(x, y, z))), Is.EqualTo(inside));
        Assert.That(Bounds.Empty.Contains(new Vec3(x, y, z)), Is.False);
        Assert.That(box.Contains(Bounds.Empty), Is.True);
    }

    [Test]
    public void Boxes_grow_and_are_compared()
    {
        var box = new Bounds(Vec3.Zero, new Vec3(2, 3, 4));
        Assert.That(box.Grow(1), Is.EqualTo(new Bounds(new Vec3(-1, -1, -1), new Vec3(3, 4, 5))));
        Assert.That(Bounds.Empty.Grow(1).IsEmpty, Is.True);
        Assert.That((box.Size, box.Center), Is.EqualTo((new Vec3(2, 3, 4), new Vec3(1, 1.5, 2))));
        Assert.That(box.Include(new Vec3(-1, 9, 2)), Is.EqualTo(new Bounds(new Vec3(-1, 0, 0), new Vec3(2, 9, 4))));
        Assert.That(box.Include(Bounds.Empty), Is.EqualTo(box));
        Assert.That(Bounds.Empty.Include(box), Is.EqualTo(box));
        Assert.That(box.Include(new Bounds(new Vec3(1, 1, -5), new Vec3(9, 1, 1))), Is.EqualTo(new Bounds(new Vec3(0, 0, -5), new Vec3(9, 3, 4))));
        foreach (var wrong in new[] { new Vec3(-1, 1, 1), new Vec3(1, -1, 1), new Vec3(1, 1, -1) })
            Assert.That(() => new Bounds(Vec3.Zero, wrong), Throws.ArgumentException);
        Assert.That(new Bounds(Vec3.Zero, Vec3.Zero), Is.Not.EqualTo(Bounds.Empty), "a point is something");
        Assert.That((box == new Bounds(Vec3.Zero, new Vec3(2, 3, 5)), box != new Bounds(new Vec3(1, 0, 0), new Vec3(2, 3, 4)), box.Equals((object)box)),
            Is.EqualTo((false, true, true)));
        Assert.That((Bounds.Empty.ToString(), Bounds.Of([]).IsEmpty), Is.EqualTo(("empty", true)));
    }

    [Test]
    public void Maps_are_applied_one_after_the_other()
    {
        var map = new Affine(new Vec3(1, 2, 3), new Vec3(0, 1, 4), new Vec3(5, 6, 0), new Vec3(7, 8, 9));
        Assert.That(map.Apply(new Vec3(1, 10, 100)), Is.EqualTo(new Vec3(1 + 500 + 7, 2 + 10 + 600 + 8, 3 + 40 + 9)));
        Assert.That(map.ApplyDirection(new Vec3(1, 10, 100)), Is.EqualTo(new Vec3(501, 612, 43)));
        // 1 (1·0 - 4·6) - 2 (0·0 - 4·5) + 3 (0·6 - 1·5).
        Assert.That(map.Determinant, Is.EqualTo(-24 + 40 - 15));
        var then = map.Then(Affine.Scale(2, 3, 4)).Then(Affine.Move(new Vec3(1, 1, 1)));
        var at = map.Apply(new Vec3(1, 2, 3));
        Assert.That(then.Apply(new Vec3(1, 2, 3)), Is.EqualTo(new Vec3(2 * at.X + 1, 3 * at.Y + 1, 4 * at.Z + 1)));
        Assert.That(Affine.Rotate(Vec3.UnitZ * 5, 90).Apply(new Vec3(1, 2, 3)).DistanceTo(new Vec3(-2, 1, 3)), Is.LessThan(1e-12));
        Assert.That(Affine.Rotate(Vec3.UnitX, 90).Apply(new Vec3(1, 2, 3)).DistanceTo(new Vec3(1, -3, 2)), Is.LessThan(1e-12));
        Assert.That(Affine.Rotate(Vec3.UnitY, 90).Apply(new Vec3(1, 2, 3)).DistanceTo(new Vec3(3, 2, -1)), Is.LessThan(1e-12));
        // About (1, 1, 1) by 120 degrees X becomes Y, Y becomes Z.
        Assert.That(Affine.Rotate(new Vec3(1, 1, 1), 120).Apply(new Vec3(1, 2, 3)).DistanceTo(new Vec3(3, 1, 2)), Is.LessThan(1e-12));
        Assert.That(map == then, Is.False);
        Assert.That(map, Is.EqualTo(new Affine(map.XAxis, map.YAxis, map.ZAxis, map.Shift)));
    }

    [Test]
    public void Maps_that_tilt_vertical_lines_or_level_planes_are_not_upright()
    {
        Assert.That(Affine.Rotate(Vec3.UnitZ, 30).Then(Affine.Scale(2, 3, 4)).Then(Affine.Move(new Vec3(1, 2, 3))).IsUpright, Is.True);
        Vec3 x = Vec3.UnitX, y = Vec3.UnitY, z = Vec3.UnitZ;
        Affine[] tilted = [new(x + z, y, z, Vec3.Zero), new(x, y + z, z, Vec3.Zero), new(x, y, z + x, Vec3.Zero), new(x, y, z + y, Vec3.Zero)];
        Assert.That(tilted.Select(m => m.IsUpright), Is.All.False);
    }

    [Test]
    public void Frames_turn_about_their_own_axes()
    {
        var frame = Frame.At(new Vec3(5, 6, 7));
        static void Same(Frame of, Vec3 x, Vec3 y, Vec3 z)
        {
            Assert.That(of.X.DistanceTo(x) + of.Y.DistanceTo(y) + of.Z.DistanceTo(z), Is.LessThan(1e-12));
            Assert.That(of.Origin, Is.EqualTo(new Vec3(5, 6, 7)));
        }
        // Left, nose up, left side up.
        Same(frame.Yaw(90), Vec3.UnitY, -Vec3.UnitX, Vec3.UnitZ);
        Same(frame.Pitch(90), Vec3.UnitZ, Vec3.UnitY, -Vec3.UnitX);
        Same(frame.Roll(90), Vec3.UnitX, Vec3.UnitZ, -Vec3.UnitY);
        var turned = frame.Yaw(30).Pitch(40).Roll(50);
        var local = new Vec3(1, -2, 3);
        Assert.That(turned.ToLocal(turned.ToWorld(local)).DistanceTo(local), Is.LessThan(1e-12));
        Assert.That(frame.ToWorld(local), Is.EqualTo(new Vec3(6, 4, 10)));
        Assert.That(turned.WithOrigin(Vec3.Zero).Origin, Is.EqualTo(Vec3.Zero));
        Assert.That((turned == frame, turned != frame, turned.Equals((object)turned)), Is.EqualTo((false, true, true)));
        Assert.That(Vec3.Cross(turned.X, turned.Y).DistanceTo(turned.Z), Is.LessThan(1e-12));
    }

    [Test]
    public void Lines_have_lengths_and_areas()
    {
        Vec3[] square = [new(1, 1), new(4, 1), new(4, 5), new(1, 5)];
        var open = new Polyline(square);
        var closed = new Polyline(square, true);
        Assert.That((open.Length, closed.Length, open.SegmentCount, closed.SegmentCount), Is.EqualTo((10.0, 14.0, 3, 4)));
        Assert.That((closed.SignedAreaXY, closed.Reversed().SignedAreaXY), Is.EqualTo((12.0, -12.0)));
        Assert.That(closed.Reversed().Points.Last(), Is.EqualTo(square[1]).Or.EqualTo(square[0]));
        Assert.That((new Polyline([Vec3.Zero]).SegmentCount, closed.Bounds), Is.EqualTo((0, new Bounds(new Vec3(1, 1), new Vec3(4, 5)))));
    }

    // 10 mm from (0, 0) against squares of 4 mm; touching counts.
    [TestCase(3, 3, true)]
    [TestCase(4, 0, true)]
    [TestCase(4, 4, true)]
    [TestCase(-4, -4, true)]
    [TestCase(4.001, 0, false)]
    [TestCase(0, -4.001, false)]
    [TestCase(4.001, 4.001, false)]
    public void Boundaries_meet_where_they_cross_or_touch(double x, double y, bool meet)
    {
        var fixedOne = Region.Rectangle(0, 0, 4, 4);
        var moved = Region.Rectangle(x, y, x + 4, y + 4);
        Assert.That(RegionMeeting.Meet(fixedOne.Index, moved.Index), Is.EqualTo(meet));
        Assert.That(RegionMeeting.Meet(moved.Index, fixedOne.Index), Is.EqualTo(meet));
        Assert.That(RegionMeeting.Meet(fixedOne.Index, Region.Rectangle(1, 1, 3, 3).Index), Is.False, "one inside of the other");
        Assert.That(RegionMeeting.Meet(fixedOne.Index, Region.Empty.Index), Is.False);
    }

    [Test]
    public void Boundaries_of_many_edges_meet_as_every_edge_against_every_edge()
    {
        var random = new Random(4);
        var found = new int[2];
        for (var round = 0; round < 60; round++)
        {
            var (a, b) = (Blob(random, 12 + random.Next(40)), Blob(random, 5 + random.Next(40)));
            var crosses = Edges(a).Any(s => Edges(b).Any(t => Crosses(s.A, s.B, t.A, t.B)));
            Assert.That(RegionMeeting.Meet(a.Index, b.Index), Is.EqualTo(crosses), $"round {round}");
            found[crosses ? 1 : 0]++;
        }
        Assert.That(found, Is.All.GreaterThan(10));
    }

    [TestCase(10, 1999, 5, true)]
    [TestCase(10, 2001, 5, false)]
    [TestCase(2, 10, 5, false)]
    [TestCase(3, 10, 5, true)]
    [TestCase(70, 10, 5, true)]
    public void Arcs_are_fitted_within_their_limits(int segments, double radius, double step, bool fits)
    {
        var points = Enumerable.Range(0, segments + 1).Select(i => new Vec3(radius * Angle.Cos(step * i), radius * Angle.Sin(step * i))).ToArray();
        var fit = new ArcFitter(points, radius / 50).From(0, segments);
        Assert.That(fit is not null, Is.EqualTo(fits));
        if (fit is { } found) Assert.That(found.Arc.Sweep, Is.EqualTo(Math.Min(step * segments, 330)).Within(step + 1e-9));
    }

    [TestCase(0.0)]
    [TestCase(double.PositiveInfinity)]
    [TestCase(double.NaN)]
    public void The_tolerance_of_arcs_is_checked(double tolerance) => Assert.That(() => new ArcFitter([], tolerance), Throws.ArgumentException);

    [Test]
    public void Pieces_of_a_mesh_have_area_and_volume()
    {
        var two = TriMesh.Merge([MeshMaker.Box(0, 0, 0, 2, 3, 4), MeshMaker.InsideOut(MeshMaker.Box(10, 0, 0, 11, 1, 1))]);
        var pieces = new MeshPieces(two);
        Assert.That(pieces.Count, Is.EqualTo(2));
        Assert.That(pieces.Area, Is.EqualTo(new[] { 2 * (6 + 8 + 12.0), 6 }).Within(1e-9));
        Assert.That(pieces.Volume, Is.EqualTo(new[] { 24.0, -1 }).Within(1e-9));
        Assert.That(pieces.IsClosed, Is.All.True);
        Assert.That(pieces.Of.Distinct(), Is.EqualTo(new[] { 0, 1 }));
    }

    private static Region Blob(Random random, int corners)
    {
        var (cx, cy, size) = (random.NextDouble() * 20, random.NextDouble() * 20, 1 + random.NextDouble() * 8);
        return Region.From(new Polyline(Enumerable.Range(0, corners).Select(i =>
        {
            var radius = size * (0.7 + 0.3 * random.NextDouble());
            return new Vec3(cx + radius * Angle.Cos(360.0 * i / corners), cy + radius * Angle.Sin(360.0 * i / corners));
        }), true));
    }

    private static List<(Vec3 A, Vec3 B)> Edges(Region region)
        => [.. region.Contours.SelectMany(c => Enumerable.Range(0, c.Count).Select(i => (c[i], c[(i + 1) % c.Count])))];

    private static bool Crosses(Vec3 a, Vec3 b, Vec3 c, Vec3 d)
    {
        static double Side(Vec3 p, Vec3 q, Vec3 r) => (q.X - p.X) * (r.Y - p.Y) - (q.Y - p.Y) * (r.X - p.X);
        return Side(a, b, c) * Side(a, b, d) <= 0 && Side(c, d, a) * Side(c, d, b) <= 0;
    }
}
