using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

public class CurveInfillTests
{
    private static readonly PrintSettings Plain = new()
    {
        LineWidth = 0.4, BeadShape = BeadShape.Rectangle, WallCount = 1, InfillDensityPercent = 20, InfillOverlapPercent = 0, TopLayers = 0, BottomLayers = 0,
        TopThickness = 0, BottomThickness = 0, MinLayerTime = 0, InfillPattern = InfillPattern.Curves,
    };

    private static PrintSettings With(params Polyline[] curves) => Plain with { InfillCurves = InfillPoint.Of(curves) };

    [Test]
    public void Curves_are_cut_at_the_walls_and_printed_in_every_layer()
    {
        // A level line through a block and a hole of it, and one beside the block.
        var settings = With(new Polyline([new(-50, 7), new(50, 7)], false), new Polyline([new(-50, 99), new(50, 99)], false));
        var layers = Solids.Slice(settings, Solids.Block(0, 0, 0, 20, 10, 1));
        Assert.That(layers, Has.Count.EqualTo(5));
        foreach (var layer in layers)
        {
            var path = Solids.Paths(layer, Role.Infill).Single();
            // One wall of 0.4 mm, and half an extrusion beside it.
            Assert.That(path.RawPoints.Select(p => p.X).OrderBy(x => x), Is.EqualTo(new[] { 0.6, 19.4 }).Within(1e-3));
            Assert.That(path.RawPoints.Select(p => p.Y), Is.All.EqualTo(7).Within(1e-3));
            Assert.That(path.Volume, Is.EqualTo(18.8 * 0.4 * 0.2).Within(1e-3), "of the usual extrusion");
        }
    }

    [Test]
    public void A_closed_curve_inside_stays_closed_and_as_it_is([Values(20, 100)] double percent)
    {
        var circle = new Polyline(Solids.Circle(3, 40).Select(p => p + new Vec3(10, 10)).ToArray(), true);
        var path = Solids.Paths(Solids.Slice(With(circle) with { InfillDensityPercent = percent }, Solids.Block(0, 0, 0, 20, 20, 1))[2], Role.Infill).Single();
        Assert.That(path.IsClosed);
        Assert.That(path.Length, Is.EqualTo(circle.Length).Within(1e-2));
    }

    [Test]
    public void Ends_of_curves_are_not_linked_along_the_walls()
    {
        var lines = Enumerable.Range(1, 9).Select(i => new Polyline([new Vec3(-5, i), new Vec3(25, i)], false)).ToArray();
        var paths = Solids.Paths(Solids.Slice(With(lines), Solids.Block(0, 0, 0, 20, 10, 1))[0], Role.Infill);
        Assert.That(paths.Select(p => p.SegmentCount), Is.EqualTo(Enumerable.Repeat(1, 9)));
    }

    [Test]
    public void Points_and_curves_are_the_same()
    {
        var curves = new[] { new Polyline([new(0, 1), new(2, 3)], false), new Polyline([new(0, 0), new(4, 0), new(4, 4)], true) };
        var points = InfillPoint.Of(curves);
        Assert.That(points.Select(p => p.Curve), Is.EqualTo(new[] { 0, 0, 1, 1, 1, 1 }));
        var back = InfillPoint.Curves(points);
        Assert.That(back.Select(c => c.IsClosed), Is.EqualTo(new[] { false, true }));
        Assert.That(back.SelectMany(c => c.Points), Is.EqualTo(curves.SelectMany(c => c.Points)));
    }

    [Test]
    public void The_key_reads_points_and_refuses_others()
    {
        var setup = new ProfileLibrary().Setup().Value!;
        var read = setup.With(["infill_pattern=curves", "infill_curves_mm=0,0,0;0,10,5.5;1,3,3;1,4,4"]);
        Assert.That(read.Value!.Settings.InfillCurves, Is.EqualTo(new[] { new InfillPoint(0, 0, 0), new(0, 10, 5.5), new(1, 3, 3), new(1, 4, 4) }));
        Assert.That(setup.With(["infill_curves_mm=0,0"]).Diagnostics, Is.Not.Empty);
        Assert.That(setup.With(["infill_curves_mm=0.5,0,0"]).Diagnostics, Is.Not.Empty);
    }

    [Test]
    public void Without_curves_there_is_a_warning()
        => Assert.That(Solids.Try(Plain, Solids.Block(0, 0, 0, 20, 10, 1)).Diagnostics.Select(d => d.Code), Is.EqualTo(new[] { "slice.no_curves" }));
}
