using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using FsCheck;
using FsCheck.Fluent;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

public class WallPropertyTests
{
    [Test]
    public void Walls_of_any_region_are_within_their_limits_and_inside_it()
        => Check(seed =>
        {
            var region = Wild(seed);
            var rules = WallTests.Rules((BeadShape)(seed & 1), seed % 4);
            var reach = region.Offset(0.01);
            return WallTests.Solid(region, rules).All(p => p.Widths.Length == p.Points.Length && p.Points.Length > (p.Closed ? 2 : 1)
                && p.Widths.All(w => w >= rules.MinWidth - 1e-9 && w <= rules.MaxWidth + 1e-9)
                && p.Points.All(q => reach.Contains(q.X, q.Y)));
        });

    [Test]
    public void Regions_of_some_size_are_full()
        => Check(seed =>
        {
            var region = Wild(seed).Opened(0.25);
            var rules = WallTests.Rules();
            return region.Area < 20 || Math.Abs(WallTests.Fullness(region, rules) - 1) < 0.04;
        });

    [Test]
    public void The_same_region_gives_the_same_walls()
    {
        var rules = WallTests.Rules();
        var builder = new WallBuilder(rules, new RegionEngine());
        foreach (var seed in Enumerable.Range(0, 20))
        {
            // A builder that has worked before gives what a fresh one gives.
            var used = builder.Build(Wild(seed));
            var fresh = new WallBuilder(rules, new RegionEngine()).Build(Wild(seed));
            Assert.That(used.Paths.SelectMany(p => p.Points), Is.EqualTo(fresh.Paths.SelectMany(p => p.Points)));
            Assert.That(used.Paths.SelectMany(p => p.Widths), Is.EqualTo(fresh.Paths.SelectMany(p => p.Widths)));
        }
    }

    private static void Check(Func<int, bool> property)
        => Prop.ForAll(Gen.Choose(0, 1_000_000).ToArbitrary(), property).Check(Config.QuickThrowOnFailure.WithMaxTest(60).WithReplay(20, 3));

    // Polygons with and without crossings, strokes, and boxes whose sides lie on common lines.
    private static Region Wild(int seed)
    {
        var random = new Random(seed);
        var size = 1 + 12 * random.NextDouble();
        var contours = new List<Polyline>();
        for (var k = random.Next(1, 5); k > 0; k--)
        {
            var n = random.Next(3, 25);
            var center = Place(random, size);
            switch (random.Next(4))
            {
                case 0:
                    contours.Add(new Polyline(Enumerable.Range(0, n).Select(_ => center + Place(random, size)), closed: true));
                    break;
                case 1:
                    contours.Add(new Polyline(Enumerable.Range(0, n).Select(i =>
                    {
                        var (sin, cos) = Angle.SinCos(360.0 * i / n);
                        return center + new Vec3(cos, sin) * (size * (0.2 + 0.3 * random.NextDouble()));
                    }), closed: true));
                    break;
                case 2:
                    var at = center;
                    var line = new Polyline(Enumerable.Range(0, n).Select(_ => at += Place(random, 0.4 * size)));
                    contours.AddRange(RegionTools.Around([line], 0.1 + 0.6 * random.NextDouble(), JoinStyle.Miter).Contours);
                    break;
                default:
                    double x = Math.Round(center.X, 1), y = Math.Round(center.Y, 1), w = 0.1 * random.Next(1, 40), h = 0.1 * random.Next(1, 40);
                    contours.Add(new Polyline([new Vec3(x, y), new Vec3(x + w, y), new Vec3(x + w, y + h), new Vec3(x, y + h)], closed: true));
                    break;
            }
        }
        return Region.From(contours, random.Next(2) == 0 ? FillRule.NonZero : FillRule.EvenOdd);
    }

    private static Vec3 Place(Random random, double size) => new((random.NextDouble() - 0.5) * size, (random.NextDouble() - 0.5) * size);
}
