using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

public class InfillBridgeTests
{
    private static readonly PrintSettings Plain = new()
    {
        LineWidth = 0.4, BeadShape = BeadShape.Rectangle, LayerHeight = 0.2, FirstLayerHeight = 0.2, InfillDensityPercent = 20,
            InfillPattern = InfillPattern.Lines,
        TopLayers = 3, BottomLayers = 3, TopThickness = 0, BottomThickness = 0, MinLayerTime = 0, InfillOverlapPercent = 0,
    };

    private static readonly TriMesh Block = Solids.Block(0, 0, 0, 30, 20, 4);

    // Layers 0 to 2 and 17 to 19 of 20 are closed; 17 is the one over infill.
    private static PrintPath[] Bridges(PrintSettings settings, int layer = 17) => Solids.Paths(Solids.Slice(settings, Block)[layer], Role.Bridge);

    private static double LongestDirection(IEnumerable<PrintPath> paths)
    {
        double longest = 0, angle = 0;
        foreach (var path in paths)
        {
            for (var i = 0; i < path.SegmentCount; i++)
            {
                var d = path.EndOf(i) - path.RawPoints[i];
                if (d.LengthXY > longest) (longest, angle) = (d.LengthXY, Angle.Atan2(d.Y, d.X));
            }
        }
        return (angle + 360) % 180;
    }

    [TestCase(InfillPattern.Lines, 90)]
    [TestCase(InfillPattern.Triangles, 90)]
    [TestCase(InfillPattern.Grid, 45)]
    [TestCase(InfillPattern.Gyroid, 45)]
    public void The_first_closed_layer_over_infill_goes_across_its_lines(InfillPattern pattern, double turn)
    {
        var settings = Plain with { InfillPattern = pattern, InfillAngle = 30, InfillRotation = 90 };
        var below = 30 + 16 * 90;
        var direction = LongestDirection(Bridges(settings));
        Assert.That(Math.Abs(direction - (below + turn) % 180) % 180, Is.LessThan(0.5).Or.GreaterThan(179.5));
    }

    [Test]
    public void Bridges_turn_at_the_walls_and_closed_layers_that_are_not_seen_before_them()
    {
        Assert.That(FromWalls(Bridges(Plain)), Is.All.LessThan(0.01));
        var inside = FromWalls(Solids.Paths(Solids.Slice(Plain, Block)[18], Role.SolidInfill));
        Assert.That(inside, Has.Some.InRange(0.1, 0.2).And.All.LessThan(0.21));
    }

    // Distances of the corners of paths from the rectangle around all of them.
    private static double[] FromWalls(PrintPath[] paths)
    {
        var points = paths.SelectMany(p => p.Points).ToArray();
        var box = Bounds.Of(points);
        return Array.ConvertAll(points, p => Math.Min(Math.Min(p.X - box.Min.X, box.Max.X - p.X), Math.Min(p.Y - box.Min.Y, box.Max.Y - p.Y)));
    }

    [Test]
    public void Only_the_first_closed_layer_is_a_bridge()
    {
        var layers = Solids.Slice(Plain, Block);
        Assert.That(Enumerable.Range(0, layers.Count).Where(i => Solids.Paths(layers[i], Role.Bridge).Length > 0), Is.EqualTo(new[] { 17 }));
        Assert.That(Solids.Paths(layers[17], Role.SolidInfill), Is.Empty);
    }

    [Test]
    public void Bridges_over_infill_have_their_own_speed_and_flow()
    {
        var usual = Bridges(Plain with { InfillBridgeSpeed = 33 });
        Assert.That(usual, Is.Not.Empty);
        Assert.That(usual.SelectMany(p => Enumerable.Range(0, p.SegmentCount).Select(i => p.BeadOf(i).Speed)), Is.All.EqualTo(33));
        var more = Bridges(Plain with { InfillBridgeFlowRatio = 1.1 });
        Assert.That(more.Sum(p => p.Volume), Is.EqualTo(1.1 * usual.Sum(p => p.Volume)).Within(1e-6));
    }

    [Test]
    public void Bridges_over_infill_hold_the_volume_of_their_area()
    {
        // Two walls of 0.4 mm on each side.
        var inside = (30 - 1.6) * (20 - 1.6) * 0.2;
        Assert.That(Bridges(Plain).Sum(p => p.Volume), Is.EqualTo(inside).Within(0.5).Percent);
    }

    [Test]
    public void Dense_infill_and_narrow_areas_need_no_bridge()
    {
        Assert.That(Bridges(Plain with { InfillDensityPercent = 60 }), Is.Empty);
        Assert.That(Bridges(Plain with { InfillBridges = false }), Is.Empty);
        var rib = Solids.Slice(Plain, Solids.Block(0, 0, 0, 30, 4, 4));
        Assert.That(rib.SelectMany(l => Solids.Paths(l, Role.Bridge)), Is.Empty);
    }

    [Test]
    public void Over_a_hollow_part_they_span_it_the_short_distance()
        => Assert.That(LongestDirection(Bridges(Plain with { InfillDensityPercent = 0 })), Is.EqualTo(90).Within(0.5));

    [Test]
    public void Over_infill_of_several_layers_they_cross_its_lines_too()
    {
        var settings = Plain with { CombineInfillLayers = 2, InfillAngle = 0, InfillRotation = 90 };
        // Layers 14 and 15 share the last whole group; 16 stands alone beside a closed layer.
        var below = (16 / 2 * 90) % 180;
        Assert.That(LongestDirection(Bridges(settings)), Is.EqualTo((below + 90) % 180).Within(0.5));
    }
}
