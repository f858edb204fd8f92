using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using NetTopologySuite.Operation.Buffer;
using NUnit.Framework;
using JoinStyle = Caterpillar.Geometry.JoinStyle;

namespace Caterpillar.Tests.Geometry;

public class RegionOffsetTests
{
    [Test]
    public void A_coarse_round_corner_has_chords_of_one_length()
    {
        // 0.1 from the arc of radius 1 is a chord of 51.7° at most, so a right angle has two of 45°.
        var chords = Region.Rectangle(0, 0, 10, 10).Offset(1, JoinStyle.Round, 2, 0.1).Contours.Single();
        var lengths = Enumerable.Range(0, chords.Count).Select(i => chords[i].DistanceTo(chords[(i + 1) % chords.Count])).OrderBy(l => l).ToArray();
        Assert.That(lengths, Has.Length.EqualTo(12));
        Assert.That(lengths.Take(8), Is.All.EqualTo(2 * Math.Sin(Math.PI / 8)).Within(1e-4));
        Assert.That(lengths.Skip(8), Is.All.EqualTo(10).Within(1e-4));
    }

    [Test]
    public void A_square_grows_and_shrinks_by_the_formula_of_each_join()
    {
        var square = Region.Rectangle(0, 0, 10, 10);
        Assert.That(square.Offset(1).Area, Is.EqualTo(144).Within(1e-9));
        Assert.That(square.Offset(-1).Area, Is.EqualTo(64).Within(1e-9));
        Assert.That(square.Offset(-1, JoinStyle.Round).Area, Is.EqualTo(64).Within(1e-9));
        Assert.That(square.Offset(1, JoinStyle.Round, 2, 1e-4).Area, Is.EqualTo(100 + 40 + Math.PI).Within(1e-3));
        // Each corner square of side 1 loses a triangle beyond distance 1 on the diagonal: height √2 − 1, base twice that.
        var cut = (Math.Sqrt(2) - 1) * (Math.Sqrt(2) - 1);
        Assert.That(square.Offset(1, JoinStyle.Square).Area, Is.EqualTo(144 - 4 * cut).Within(1e-4));
        Assert.That(square.Offset(1, JoinStyle.Miter, 1.2).Area, Is.EqualTo(144 - 4 * cut).Within(1e-4));
        Assert.That(square.Offset(-5).IsEmpty);
        Assert.That(square.Offset(-4.9999).Area, Is.EqualTo(0.0002 * 0.0002).Within(1e-9));
        Assert.That(square.Offset(-100).IsEmpty);
        Assert.That(square.Offset(0).Area, Is.EqualTo(100));
    }

    [Test]
    public void A_hole_shrinks_when_the_region_grows_and_vanishes()
    {
        var ring = Region.Rectangle(0, 0, 30, 30).Subtract(Region.Rectangle(10, 10, 20, 20));
        Assert.That(ring.Offset(2).Area, Is.EqualTo(34 * 34 - 36).Within(1e-9));
        Assert.That(ring.Offset(5).Contours, Has.Count.EqualTo(1));
        Assert.That(ring.Offset(5).Area, Is.EqualTo(1600).Within(1e-9));
        Assert.That(ring.Offset(-2).Area, Is.EqualTo(26 * 26 - 14 * 14).Within(1e-9));
        Assert.That(ring.Offset(-5).IsEmpty);
    }

    [Test]
    public void Neighbors_join_and_a_dumbbell_parts()
    {
        var two = Region.Rectangle(0, 0, 10, 10).Union(Region.Rectangle(11, 0, 21, 10));
        Assert.That(two.Offset(0.4).Islands, Has.Count.EqualTo(2));
        Assert.That(two.Offset(0.6).Islands, Has.Count.EqualTo(1));
        var dumbbell = two.Union(Region.Rectangle(9, 4.5, 12, 5.5));
        Assert.That(dumbbell.Offset(-0.4).Islands, Has.Count.EqualTo(1));
        Assert.That(dumbbell.Offset(-0.6).Islands, Has.Count.EqualTo(2));
        Assert.That(dumbbell.Opened(0.6).Islands, Has.Count.EqualTo(2));
        Assert.That(two.Closed(0.6).Islands, Has.Count.EqualTo(1));
    }

    [Test]
    public void A_thin_sliver_beside_a_block_does_not_hurt_it()
    {
        var block = Region.Rectangle(0, 0, 10, 10);
        var both = block.Union(Region.Rectangle(-0.25, 0, -0.05, 10)).Union(Region.Rectangle(10.05, 0, 10.25, 3));
        Assert.That(both.Offset(-0.4).Area, Is.EqualTo(block.Offset(-0.4).Area).Within(1e-9));
    }

    [Test]
    public void Round_offsets_agree_with_buffers_of_NetTopologySuite()
    {
        var random = new Random(3);
        for (var k = 0; k < (Fast ? 150 : 20); k++)
        {
            var region = k % 3 == 0 ? Region.From(RegionReference.Random(random, 12, 10), FillRule.EvenOdd)
                : Region.From(new[] { RegionReference.Star(random, 10 + k % 50, 0, 0, 4, 10), RegionReference.Star(random, 12, 1, 1, 1, 5) }, FillRule.EvenOdd);
            var nts = RegionReference.ToNts(region);
            foreach (var d in new[] { 0.3, -0.3, 1.7, -1.1, 4 })
            {
                var ours = region.Offset(d, JoinStyle.Round, 2, 0.0005);
                RegionReference.AssertValid(ours);
                var theirs = BufferOp.Buffer(nts, d, new BufferParameters(64));
                Assert.That(ours.Area, Is.EqualTo(theirs.Area).Within(0.002 * (1 + theirs.Length)), $"region {k} by {d}");
            }
        }
    }

    [TestCase(JoinStyle.Miter)]
    [TestCase(JoinStyle.Round)]
    [TestCase(JoinStyle.Square)]
    public void Offsets_are_what_sweeping_every_edge_and_corner_gives(JoinStyle join)
    {
        var random = new Random(12);
        for (var k = 0; k < Rounds.Of(24, 60, 12) / (join == JoinStyle.Round ? 2 : 1); k++)
        {
            var region = (k % 6) switch
            {
                0 => Region.From(RegionReference.Random(random, 14, 10), FillRule.EvenOdd),
                1 => Region.From(RegionReference.Star(random, 60, 0, 0, 8, 8.2)),
                2 => Region.From(RegionReference.Star(random, 60, 0, 0, 3, 10)),
                3 => Region.From(RegionReference.Star(random, 120, 0, 0, 2, 2.02)),
                4 => Region.Rectangle(-10, -10, 10, 10).Subtract(Region.From(RegionReference.Star(random, 90, 1, 0, 1.8, 1.9))),
                _ => Region.From(new[] { RegionReference.Star(random, 80, 0, 0, 8, 9), RegionReference.Star(random, 40, 0, 0, 4, 5) }, FillRule.EvenOdd),
            };
            foreach (var d in new[] { 0.15, -0.15, 0.5, -0.5, 1.5, -1.5 })
            {
                var ours = region.Offset(d, join, 2, 0.0001);
                var swept = RegionReference.OffsetBySweeping(region, d, join, 2);
                Assert.That(ours.Xor(swept).Area, Is.LessThan((join == JoinStyle.Round ? 2e-4 : 2e-5) * (1 + swept.Perimeter)), $"region {k} by {d}");
            }
        }
    }

    [Test]
    public void Larger_distances_give_larger_regions()
    {
        var random = new Random(4);
        for (var k = 0; k < (Fast ? 60 : 6); k++)
        {
            var region = Region.From(new[] { RegionReference.Star(random, 40, 0, 0, 3, 10), RegionReference.Star(random, 12, 1, 1, 1, 3) }, FillRule.EvenOdd);
            foreach (JoinStyle join in Enum.GetValues(typeof(JoinStyle)))
            {
                Region? previous = null;
                foreach (var d in new[] { -2, -1, -0.5, -0.1, 0, 0.1, 0.5, 1, 2 })
                {
                    var now = region.Offset(d, join);
                    RegionReference.AssertValid(now);
                    if (previous is not null) Assert.That(previous.Subtract(now).Area, Is.LessThan(1e-2), $"{join} {d}");
                    previous = now;
                }
            }
        }
    }

    [Test]
    public void Offsets_of_regions_on_the_finest_grid_stay_valid()
    {
        var random = new Random(9);
        for (var k = 0; k < (Fast ? 300 : 20); k++)
        {
            var region = Region.From(RegionReference.Random(random, 10, 12, 1e-5), FillRule.EvenOdd);
            foreach (var d in new[] { 1e-5, -1e-5, 3e-5, 1e-4, 0.4 })
            {
                RegionReference.AssertValid(region.Offset(d));
                RegionReference.AssertValid(region.Offset(d, JoinStyle.Round));
            }
        }
    }

    [Test]
    public void Results_have_the_same_bits_on_every_runtime()
    {
        var random = new Random(77);
        var hash = 14695981039346656037UL;
        for (var k = 0; k < 12; k++)
        {
            var region = Region.From(new[] { RegionReference.Star(random, 40, 0, 0, 3, 10), RegionReference.Random(random, 9, 12) }, FillRule.EvenOdd);
            foreach (JoinStyle join in Enum.GetValues(typeof(JoinStyle)))
            {
                foreach (var path in region.Offset(0.3, join).Subtract(region.Offset(-0.4, join)).Simplified(0.01).Paths)
                {
                    foreach (var p in path) hash = unchecked(((hash ^ (uint)p.X) * 1099511628211UL ^ (uint)p.Y) * 1099511628211UL);
                }
            }
            foreach (var line in region.HatchLines(33, 0.5))
            {
                hash = unchecked((hash ^ (ulong)BitConverter.DoubleToInt64Bits(line.From.X)) * 1099511628211UL);
                hash = unchecked((hash ^ (ulong)BitConverter.DoubleToInt64Bits(line.To.Y)) * 1099511628211UL);
            }
        }
        Assert.That(hash, Is.EqualTo(9827784083124805963UL));
    }

    [Test]
    public void Simplifying_keeps_within_the_tolerance()
    {
        var circle = Region.From(new Polyline(Enumerable.Range(0, 1000).Select(i =>
        {
            var (sin, cos) = Angle.SinCos(i * 0.36);
            return new Vec3(20 * cos, 20 * sin);
        }), closed: true));
        var simple = circle.Simplified(0.0125);
        RegionReference.AssertValid(simple);
        Assert.That(simple.VertexCount(), Is.InRange(60, 200));
        Assert.That(simple.Subtract(circle.Offset(0.0126)).IsEmpty && circle.Offset(-0.0126).Subtract(simple).IsEmpty);
        Assert.That(circle.Simplified(0).VertexCount(), Is.EqualTo(1000));
    }

    [Test]
    public void Every_vertex_that_simplifying_drops_is_near_a_chord()
    {
        var random = new Random(15);
        for (var k = 0; k < (Fast ? 15 : 6); k++)
        {
            var region = Region.From(RegionReference.Star(random, 300, 0, 0, 10, 10.05 + k % 3 * 0.3));
            foreach (var tolerance in new[] { 0.01, 0.05, 0.2 })
            {
                var simple = region.Simplified(tolerance);
                RegionReference.AssertValid(simple);
                Assert.That(simple.VertexCount(), Is.LessThanOrEqualTo(region.VertexCount()));
                var turned = Region.From(region.Contours.Select(c => new Polyline(c.Points.Skip(77).Concat(c.Points.Take(77)), closed: true)))
                    .Simplified(tolerance);
                Assert.That(turned.Xor(simple).IsEmpty, "it depends on where the contour starts");
                foreach (var p in region.Contours[0].Points)
                {
                    var nearest = simple.Contours.Min(c => Enumerable.Range(0, c.Count).Min(i => Distance(p, c[i], c[(i + 1) % c.Count])));
                    Assert.That(nearest, Is.LessThanOrEqualTo(tolerance + 2e-5));
                }
            }
        }
    }

    private static double Distance(Vec3 p, Vec3 a, Vec3 b)
    {
        var t = Vec3.Dot(p - a, b - a) / (b - a).LengthSquared;
        return p.DistanceTo(Vec3.Lerp(a, b, Math.Min(Math.Max(t, 0), 1)));
    }

    private static bool Fast => !Rounds.OnMono;
}
