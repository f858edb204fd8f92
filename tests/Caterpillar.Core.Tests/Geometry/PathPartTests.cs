using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry;

/// <summary>The parts of the segments of a path, which follow each other, are those of each segment by itself.</summary>
public class PathPartTests
{
    [TestCase(1, 0.0)]
    [TestCase(2, 0.0)]
    [TestCase(3, 0.3)]
    [TestCase(4, -0.3)]
    [TestCase(5, 0.01)]
    public void Parts_along_a_path_are_those_of_each_segment_alone(int seed, double distance)
    {
        var random = new Random(seed);
        var region = Blobs(random);
        // A path beside the boundary, and one across it.
        var beside = region.Offset(distance).Contours.Select(c => c.Raw);
        var across = Enumerable.Range(0, 400).Select(i => new Vec3(20 + 18 * Math.Cos(i / 63.0) + random.NextDouble(), 20 + 18 * Math.Sin(i / 63.0))).ToArray();
        // With corners where it crosses the boundary, but for rounding.
        var cut = across.SelectMany((p, i) => region.ClipLines([new Polyline([p, across[(i + 1) % across.Length]])]).SelectMany(c => c.Points).Append(p)
            .OrderBy(q => q.DistanceTo(p))).ToArray();
        foreach (var path in beside.Append(across).Append(cut))
        {
            foreach (var outside in new[] { false, true })
            {
                var clipper = new LineClipper(region.Index, outside);
                clipper.Follow(path);
                for (var i = 0; i < path.Length; i++)
                {
                    // Some are not asked for.
                    if (i % 7 == 3) continue;
                    Vec3 a = path[i], b = path[i + 1 == path.Length ? 0 : i + 1];
                    if (a.DistanceTo(b) < 1e-3) continue;
                    var parts = new List<(double From, double To)>();
                    clipper.Parts(i, parts);
                    var alone = region.ClipLines([new Polyline([a, b])], outside).Select(p => (p[0].DistanceTo(a), p[p.Count - 1].DistanceTo(a))).ToArray();
                    var length = a.DistanceTo(b);
                    Assert.That(parts.Select(p => p.From * length), Is.EqualTo(alone.Select(p => p.Item1)).Within(1e-9), $"{i} of {path.Length}");
                    Assert.That(parts.Select(p => p.To * length), Is.EqualTo(alone.Select(p => p.Item2)).Within(1e-9), $"{i} of {path.Length}");
                }
            }
        }
    }

    [Test]
    public void Nothing_is_inside_of_an_empty_region()
    {
        var clipper = new LineClipper(Region.Empty.Index, outside: true);
        clipper.Follow([new Vec3(0, 0), new Vec3(1, 0), new Vec3(1, 1)]);
        var parts = new List<(double From, double To)>();
        for (var i = 0; i < 3; i++) clipper.Parts(i, parts);
        Assert.That(parts, Is.EqualTo(new[] { (0.0, 1.0), (0.0, 1.0), (0.0, 1.0) }));
    }

    private static Region Blobs(Random random)
    {
        var all = Region.Empty;
        for (var k = 0; k < 12; k++)
        {
            double x = 40 * random.NextDouble(), y = 40 * random.NextDouble(), r = 2 + 6 * random.NextDouble();
            var points = Enumerable.Range(0, 90).Select(i => new Vec3(x + r * Math.Cos(i * Math.PI / 45), y + r * Math.Sin(i * Math.PI / 45)));
            all = all.Union(Region.From([new Polyline(points, closed: true)]));
        }
        return all;
    }
}
