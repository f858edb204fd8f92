using System;
using System.Globalization;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using FsCheck;
using FsCheck.Fluent;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>Checks with an object that lies on the bed before anything is printed.</summary>
public class PrintedOnTests
{
    // A ramp that rises by 1 in 4 along X, from 2 mm at x = 20 to 12 mm at x = 60.
    private static readonly TriMesh Ramp = Plate((x, _) => 2 + (x - 20) / 4, 20, 60, 20, 50);

    private static readonly PrintSetup OnRamp = SmallPrint.Setup() with { PrintedOn = Ramp };

    [Test]
    public void An_extrusion_on_the_object_is_supported_and_collides_with_nothing()
    {
        var print = new SmallPrint().Over(25, 30, 3.45).Print(55, 30, 10.95).Over(25, 31, 3.45).Print(55, 31, 10.95).Over(0, 0, 200).Build();
        Assert.That(SmallPrint.Find(print, OnRamp, "").Select(d => d.ToString()), Is.Empty);
        Assert.That(SmallPrint.Find(print, SmallPrint.Setup(), "extrusion.").Select(d => d.Code), Is.EqualTo(new[] { CheckCodes.Unsupported }));
    }

    [Test]
    public void An_extrusion_above_the_object_lies_in_the_air_and_a_layer_on_a_extrusion_does_not()
    {
        var high = new SmallPrint().Over(25, 30, 5.25).Print(55, 30, 12.75).Over(0, 0, 200).Build();
        Assert.That(SmallPrint.Find(high, OnRamp, "extrusion.").Select(d => d.Code), Is.EqualTo(new[] { CheckCodes.Unsupported }));
        var second = new SmallPrint().Over(25, 30, 3.45).Print(55, 30, 10.95).Over(25, 30, 3.65).Print(55, 30, 11.15).Over(0, 0, 200).Build();
        Assert.That(SmallPrint.Find(second, OnRamp, ""), Is.Empty);
    }

    [Test]
    public void Moves_through_the_object_are_found()
    {
        // Level at 5 mm it enters the ramp at x = 32.
        var print = new SmallPrint().Over(22, 30, 5).Expect(CheckCodes.NozzleHits).Print(50, 30, 5).Over(0, 0, 200);
        Found(print, OnRamp, exact: false);
        var travel = new SmallPrint().Over(22, 30, 5).Expect(CheckCodes.TravelHits).Go(50, 30, 5).Go(50, 30, 200);
        var setup = OnRamp with { Printer = OnRamp.Printer with { HeadOutline = new(new HeadPoint(0.5, 0)) } };
        var found = SmallPrint.Find(travel.Build(), setup, "collision.");
        Assert.That(found.Select(d => (d.Code, d.Source!.Move)), Is.EqualTo(new[] { (CheckCodes.TravelHits, (int?)travel.Planted[0].Move) }));
        Assert.That(found[0].Count, Is.EqualTo(2), "in, and out upward");
        Assert.That(found[0].Message, Does.Contain("the object below the print"));
        Assert.That(X(found[0].Message), Is.EqualTo(32).Within(1));
    }

    [Test]
    public void An_arc_through_the_object_is_one_finding()
    {
        var wall = SmallPrint.Setup() with { PrintedOn = Plate((_, _) => 8, 40, 60, 20, 50) };
        var print = new SmallPrint().Over(20, 30, 5).Arc(80, 30, 5, new Vec3(50, 100, 5), 2 * Angle.ToDegrees(Math.Atan(3 / 7.0))).Go(80, 30, 200);
        Assert.That(SmallPrint.Find(print.Build(), wall, CheckCodes.TravelHits).Single().Count, Is.EqualTo(1));
    }

    [Test]
    public void The_cone_and_boxes_of_the_head_hit_the_object_on_the_way_down()
    {
        var block = Plate((_, _) => 20, 40, 60, 20, 50);
        var plain = SmallPrint.Setup() with { PrintedOn = block };
        // The cone reaches 4 mm at a height of 6 mm.
        Found(new SmallPrint().Go(37, 30, 200).Expect(CheckCodes.TravelHits).Go(37, 30, 0.2).Go(10, 30, 0.2), plain, exact: false);
        Found(new SmallPrint().Go(15, 30, 200).Go(15, 30, 0.2), plain);
        var boxed = plain with { Printer = plain.Printer with
        {
            HeadBoxes = new(new Bounds(new Vec3(0, -5, 8), new Vec3(50, 5, 60))), HeadOutline = new(new HeadPoint(0.5, 0), new(1, 6)),
        } };
        Found(new SmallPrint().Go(15, 30, 200).Expect(CheckCodes.HeadHits).Go(15, 30, 0.2).Go(0, 30, 0.2), boxed, exact: false);
    }

    [Test]
    public void What_is_written_is_checked_with_the_object()
    {
        var good = new SmallPrint().Over(25, 30, 3.45).Print(55, 30, 10.95).Over(0, 0, 200).Build();
        Assert.That(SafeWriter.ToDocument(good, OnRamp).Diagnostics.Select(d => d.Code), Has.None.EqualTo(CheckCodes.Unsupported));
        var bad = new SmallPrint().Over(22, 30, 5).Print(50, 30, 5).Over(0, 0, 200).Build();
        Assert.That(SafeWriter.ToDocument(bad, OnRamp).Value, Is.Null);
        Assert.That(SafeWriter.ToDocument(bad, SmallPrint.Setup()).Diagnostics.Select(d => d.Code), Has.None.EqualTo(CheckCodes.NozzleHits));
    }

    [Test]
    public void Lines_over_an_object_are_never_above_it_and_never_far_below()
    {
        Prop.ForAll(Gen.Choose(0, 1_000_000).ToArbitrary(), seed =>
        {
            var random = new Random(seed);
            double a = 1 + 3 * random.NextDouble(), b = 10 + 20 * random.NextDouble(), c = random.NextDouble();
            double Height(double x, double y) => 6 + a * Angle.Sin(b * x) + c * y / 8;
            var mesh = Plate(Height, 0, 20, 0, 15);
            var heights = new MeshHeights(mesh);
            var top = new ObjectTop(mesh, 0.25);
            for (var i = 0; i < 200; i++)
            {
                var p = new Vec3(20 * random.NextDouble(), 15 * random.NextDouble());
                var exact = heights.TopUnder(p.X, p.Y);
                Assert.That(top.Under(p.X, p.Y, 100), Is.EqualTo(exact));
                // The steepest slope over the distance of lines.
                var near = top.Lines.TopAlong(p, p, 0.13);
                var slope = a * b * Math.PI / 180 + c / 8;
                Assert.That(near, Is.InRange(exact - 0.13 * slope - 0.01, exact + 0.13 * slope + 0.01), p.ToString());
            }
        }).Check(Config.QuickThrowOnFailure.WithMaxTest(20).WithReplay(20, 3));
    }

    private static void Found(SmallPrint print, PrintSetup setup, bool exact = true)
    {
        var found = SmallPrint.Find(print.Build(), setup, "collision.");
        if (exact || print.Planted.Count == 0) Assert.That(found.Select(d => (d.Source!.Move!.Value, d.Code)), Is.EqualTo(print.Planted));
        else Assert.That(found.Select(d => (d.Source!.Move!.Value, d.Code)), Does.Contain(print.Planted[0]));
        Assert.That(found.Select(d => d.Message), Has.All.Contains("the object below the print"));
    }

    // "… at (x, y, z)."
    private static double X(string message) => double.Parse(message.Substring(message.LastIndexOf('(') + 1).Split(',')[0], CultureInfo.InvariantCulture);

    private static TriMesh Plate(Func<double, double, double> height, double x0, double x1, double y0, double y1)
    {
        const int Parts = 16;
        var vertices = (from j in Enumerable.Range(0, Parts + 1) from i in Enumerable.Range(0, Parts + 1)
            let x = x0 + (x1 - x0) * i / Parts let y = y0 + (y1 - y0) * j / Parts select new Vec3(x, y, height(x, y))).ToList();
        var triangles = (from j in Enumerable.Range(0, Parts) from i in Enumerable.Range(0, Parts) let n = j * (Parts + 1) + i
            from v in new[] { n, n + 1, n + Parts + 2, n, n + Parts + 2, n + Parts + 1 } select v).ToList();
        return TriMesh.Create(vertices, triangles);
    }
}
