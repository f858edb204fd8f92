using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Planning;
using Caterpillar.Tests.Slicing.Infill;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Planning;

public class CombPathTests
{
    // An L of 20 mm with legs 6 mm wide: the concave corner at (6, 6).
    private static readonly Region Ell = Region.Rectangle(0, 0, 20, 6).Union(Region.Rectangle(0, 0, 6, 20));

    private static double Length(Vec3 from, IEnumerable<Vec3> path)
    {
        var sum = 0.0;
        foreach (var p in path)
        {
            sum += from.DistanceTo(p);
            from = p;
        }
        return sum;
    }

    [Test]
    public void Around_a_corner_the_path_bends_once_beside_it()
    {
        var path = new CombPath(0.5).Find(new Vec3(18, 5, 1), new Vec3(5, 18, 1), Ell, 100)!;
        Assert.That(path, Has.Count.EqualTo(2));
        Assert.That(path[0].DistanceTo(new Vec3(5.5, 5.5, 1)), Is.LessThan(1e-3));
        Assert.That(path[1], Is.EqualTo(new Vec3(5, 18, 1)));
    }

    [Test]
    public void Around_a_hole_the_path_takes_the_shorter_side()
    {
        var path = new CombPath(0.5).Find(new Vec3(2, 9, 1), new Vec3(18, 9, 1), InfillSamples.Holed, 100)!;
        // The hole reaches from 7 to 13 mm; below it is nearer.
        Assert.That(path.Select(p => p.Y), Is.All.LessThan(9.01));
        Assert.That(Length(new Vec3(2, 9, 1), path), Is.EqualTo(2 * Math.Sqrt(4.5 * 4.5 + 2.5 * 2.5) + 7).Within(1e-3));
    }

    [Test]
    public void A_path_longer_than_the_bound_is_none()
    {
        var comb = new CombPath(0.5);
        var (from, to) = (new Vec3(18, 5), new Vec3(5, 18));
        var length = 2 * Math.Sqrt(12.5 * 12.5 + 0.25);
        Assert.That(comb.Find(from, to, Ell, length - 0.01), Is.Null);
        Assert.That(comb.Find(from, to, Ell, length + 0.01), Is.Not.Null);
    }

    [Test]
    public void Extrusions_near_the_outline_are_left_and_reached()
    {
        // On outer walls, 0.2 mm from the outline.
        var path = new CombPath(0.5).Find(new Vec3(19.8, 5.8), new Vec3(5.8, 19.8), Ell, 100)!;
        Assert.That(path[path.Count - 1], Is.EqualTo(new Vec3(5.8, 19.8)));
        Assert.That(Length(new Vec3(19.8, 5.8), path), Is.LessThan(30));
    }

    [Test]
    public void Around_a_hole_a_path_leads_from_the_wall_on_one_side_to_the_wall_on_the_other()
    {
        for (var angle = 0; angle < 90; angle += 7)
        {
            var (sin, cos) = Caterpillar.Basics.Angle.SinCos(angle);
            Vec3 Turned(double x, double y) => new(x * cos - y * sin, x * sin + y * cos);
            Polyline Square(double half) => new([Turned(-half, -half), Turned(half, -half), Turned(half, half), Turned(-half, half)], true);
            var region = Region.From([Square(10)]).Subtract(Region.From([Square(3)]));
            for (var y = -2.8; y < 3; y += 0.4)
            {
                // 0.2 mm beside the hole; 0.5 mm are kept from its edges.
                Assert.That(new CombPath(0.5).Find(Turned(-3.2, y), Turned(3.2, y), region, 16), Is.Not.Null, $"{angle}, {y}");
            }
        }
    }

    [Test]
    public void What_is_too_thin_to_walk_in_has_no_path()
        => Assert.That(new CombPath(0.5).Find(new Vec3(1, 0.4), new Vec3(9, 0.4), Region.Rectangle(0, 0, 10, 0.8), 100), Is.Null);

    [Test]
    public void Paths_in_any_region_stay_inside_it()
    {
        int found = 0, all = 0;
        for (var seed = 0; seed < 150; seed++)
        {
            var random = new Random(seed);
            foreach (var island in InfillSamples.Random(seed).Islands)
            {
                var inner = island.Offset(-0.3);
                if (inner.IsEmpty) continue;
                var comb = new CombPath(0.45);
                for (var i = 0; i < 5; i++)
                {
                    var contours = inner.Contours;
                    Vec3 Somewhere()
                    {
                        var contour = contours[random.Next(contours.Count)];
                        return contour[random.Next(contour.Count)].WithZ(2);
                    }
                    Vec3 from = Somewhere(), to = Somewhere();
                    all++;
                    if (comb.Find(from, to, island, 1000) is not { } path) continue;
                    found++;
                    Assert.That(path[path.Count - 1], Is.EqualTo(to));
                    var at = from;
                    foreach (var p in path)
                    {
                        Assert.That(island.ContainsLine(at, p), $"region {seed}: from {at} to {p}");
                        Assert.That(p.Z, Is.EqualTo(2));
                        at = p;
                    }
                }
            }
        }
        Assert.That(found, Is.GreaterThan(all * 0.85), "narrow necks, where the inset region falls apart, have none");
    }

    [TestCase(0.4, 0)]
    [TestCase(0.2, 0)]
    [TestCase(0.9, 1)]
    public void Up_to_the_next_layer_nothing_is_retracted_inside_the_part(double top, int retractions)
    {
        PathStep Line(double x, double z) => new(new PrintPath([new(x, 2, z), new(x + 2, 2, z)], new Bead(0.08, 0.2)))
        {
            // A region of its own for each layer.
            Region = Region.Rectangle(0, 0, 20, 6 + z),
        };
        var first = Line(1, 0.2);
        var second = top > 0.2 ? Line(15, top) : new PathStep(Line(15, 0.2).Path) { Region = first.Region };
        var rules = PlanningTests.Rules with { Settings = PlanningTests.Rules.Settings with { Comb = true } };
        var plan = PlanRun.Run([first, second], rules, new PlanOptions { Start = Vec3.Zero }, null, default).Value!;
        Assert.That((plan.Report.Retractions, plan.Report.Combed), Is.EqualTo((retractions, 1 - retractions)));
    }

    [Test]
    public void A_travel_up_to_the_next_layer_is_not_faster_than_the_Z_axis_may_go()
    {
        PathStep Line(double x, double z) => new(new PrintPath([new(x, 2, z), new(x + 2, 2, z)], new Bead(0.08, 0.2)))
        {
            Region = Region.Rectangle(0, 0, 20, 6 + z),
        };
        var rules = PlanningTests.Rules with { Settings = PlanningTests.Rules.Settings with { Comb = true, TravelSpeed = 150 } };
        Toolpath Plan(double x) => PlanRun.Run([Line(1, 0.2), Line(x, 0.4)], rules, new PlanOptions { Start = Vec3.Zero }, null, default).Value!.Toolpath;
        // From x = 3 to 4 and 0.2 mm up: √1.04 mm in 0.02 s; over 12 mm the speed of travels is slow enough.
        Assert.That(Rising(Plan(4)).Speed, Is.EqualTo(Math.Sqrt(1.04) / 0.02).Within(1e-9));
        Assert.That(Rising(Plan(15)).Speed, Is.EqualTo(150));

        static Move Rising(Toolpath toolpath)
            => toolpath.Moves().Single(m => m.Kind == MoveKind.Travel && m.Start.Z == 0.2 && m.End.Z > m.Start.Z && m.End.X > m.Start.X);
    }
}
