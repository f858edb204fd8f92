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

public class ModifierTests
{
    private static readonly PrintSettings Plain = new()
    {
        LineWidth = 0.4, BeadShape = BeadShape.Rectangle, LayerHeight = 0.2, FirstLayerHeight = 0.2, WallCount = 2, InfillDensityPercent = 20,
        TopLayers = 0, BottomLayers = 0, TopThickness = 0, BottomThickness = 0, MinLayerTime = 0, InfillPattern = InfillPattern.Lines, InfillOverlapPercent = 0,
    };

    private static readonly TriMesh Part = Solids.Block(0, 0, 0, 40, 20, 4);

    private static readonly TriMesh Half = Solids.Block(20, -5, 1, 50, 25, 3);

    private static Result<SliceResult> Sliced(PrintSettings common, TriMesh modifier, PrintSettings inside, SliceOptions? options = null)
        => PlanarSlicer.SliceEach(
            [new SliceModel(new NamedMesh("part", Part), common),
                new SliceModel(new NamedMesh("mod", modifier), inside with { ModelType = ModelType.Modifier })],
            common, options);

    private static IReadOnlyList<SlicedLayer> Layers(PrintSettings common, TriMesh modifier, PrintSettings inside)
    {
        var result = Sliced(common, modifier, inside);
        Assert.That(result.Diagnostics, Is.Empty);
        return result.Value!.Layers;
    }

    // Length of extrusions of a role in the left and in the right half.
    private static (double Left, double Right) Lengths(SlicedLayer layer, params Role[] roles)
    {
        double left = 0, right = 0;
        foreach (var path in Solids.Paths(layer, roles))
        {
            for (var i = 0; i < path.SegmentCount; i++)
            {
                Vec3 a = path.RawPoints[i], b = path.EndOf(i);
                for (var k = 0; k < 100; k++)
                {
                    if (Vec3.Lerp(a, b, (k + 0.5) / 100).X < 20) left += a.DistanceTo(b) / 100;
                    else right += a.DistanceTo(b) / 100;
                }
            }
        }
        return (left, right);
    }

    [Test]
    public void Infill_is_denser_inside_a_modifier_and_walls_stay_whole()
    {
        var layers = Layers(Plain, Half, Plain with { InfillDensityPercent = 60 });
        Assert.That(layers, Has.Count.EqualTo(20), "the modifier is not printed");
        var (left, right) = Lengths(layers[8], Role.Infill);
        Assert.That(right / left, Is.EqualTo(3).Within(0.5));
        var walls = Solids.Paths(layers[8], Role.OuterWall, Role.InnerWall);
        Assert.That(walls, Has.Length.EqualTo(2));
        Assert.That(walls.Sum(w => w.Length), Is.EqualTo(2 * (39.6 + 19.6) + 2 * (38.8 + 18.8)).Within(0.01));
        // Below and above it nothing is different.
        foreach (var i in new[] { 2, 17 })
        {
            var (l, r) = Lengths(layers[i], Role.Infill);
            Assert.That(r / l, Is.EqualTo(1).Within(0.1));
        }
    }

    [Test]
    public void More_walls_inside_a_modifier_go_around_what_it_covers()
    {
        var layers = Layers(Plain, Half, Plain with { WallCount = 4 });
        var walls = Solids.Paths(layers[8], Role.OuterWall, Role.InnerWall);
        Assert.That(walls, Has.Length.EqualTo(6), "two on the left, four on the right");
        Assert.That(walls.Count(w => w.RawPoints.All(p => p.X < 20)), Is.EqualTo(2));
        Assert.That(walls.Count(w => w.RawPoints.All(p => p.X > 20)), Is.EqualTo(4));
    }

    [Test]
    public void A_solid_part_stays_solid_whatever_its_modifiers_divide()
    {
        var solid = Plain with { InfillDensityPercent = 100 };
        foreach (var inside in new[] { solid with { InfillAngle = 10 }, solid with { WallCount = 5 }, solid with { LineWidth = 0.5 } })
            Assert.That(Solids.Volume(Layers(solid, Half, inside)), Is.EqualTo(40 * 20 * 4).Within(1).Percent);
    }

    [Test]
    public void Surfaces_of_a_modifier_are_at_the_ends_of_the_part_and_not_at_the_modifier()
    {
        var tall = Solids.Block(20, -5, -1, 50, 25, 9);
        var layers = Layers(Plain, tall, Plain with { TopLayers = 3 });
        Assert.That(layers.Select(l => Solids.Paths(l, Role.TopSurface, Role.SolidInfill, Role.Bridge).Length > 0),
            Is.EqualTo(Enumerable.Range(0, 20).Select(i => i >= 17)));
        var (left, right) = Lengths(layers[19], Role.TopSurface);
        Assert.That(left, Is.Zero);
        Assert.That(right, Is.GreaterThan(500));
    }

    [Test]
    public void Speed_and_flow_of_a_modifier_hold_inside_it()
    {
        var common = Plain with { InfillSpeed = 80, OuterWallSpeed = 30 };
        var layers = Layers(common, Half, common with { InfillSpeed = 50, PartFlowRatio = 1.2 });
        var usual = Layers(common, Half, common);
        var paths = Solids.Paths(layers[8], Role.Infill);
        Assert.That(paths.Where(p => p.RawPoints.All(v => v.X < 20)).Select(p => p.BeadOf(0).Speed), Is.Not.Empty.And.All.Zero, "the speed of the print");
        Assert.That(paths.Where(p => p.RawPoints.All(v => v.X > 20)).Select(p => p.BeadOf(0).Speed), Is.Not.Empty.And.All.EqualTo(50));
        double Right(IReadOnlyList<SlicedLayer> from) => Solids.Paths(from[8], Role.Infill).Where(p => p.RawPoints.All(v => v.X > 20)).Sum(p => p.Volume);
        Assert.That(Right(layers), Is.EqualTo(1.2 * Right(usual)).Within(1e-6));
    }

    [Test]
    public void The_last_of_two_modifiers_applies_where_both_are()
    {
        SliceModel Modifier(double percent) => new(new NamedMesh("mod", Half), Plain with { ModelType = ModelType.Modifier, InfillDensityPercent = percent });
        var result = PlanarSlicer.SliceEach([new SliceModel(new NamedMesh("part", Part), Plain), Modifier(80), Modifier(40)], Plain);
        var (left, right) = Lengths(result.Value!.Layers[8], Role.Infill);
        Assert.That(right / left, Is.EqualTo(2).Within(0.2));
    }

    [Test]
    public void A_modifier_outside_of_all_parts_is_a_warning()
    {
        var result = Sliced(Plain, Solids.Block(100, 100, 0, 110, 110, 4), Plain with { InfillDensityPercent = 60 });
        Assert.That(result.Diagnostics.Select(d => d.Code), Is.EqualTo(new[] { "slice.modifier_outside" }));
        Assert.That(Solids.Volume(result.Value!.Layers), Is.EqualTo(Solids.Volume(Solids.Slice(Plain, Part))).Within(1e-9));
    }

    [Test]
    public void Modifiers_alone_are_nothing_to_print()
    {
        var result = PlanarSlicer.SliceEach([new SliceModel(new NamedMesh("mod", Half), Plain with { ModelType = ModelType.Modifier })], Plain);
        Assert.That(result.Diagnostics.Select(d => d.Code), Does.Contain("slice.empty"));
    }

    [Test]
    public void Threads_change_nothing_beside_modifiers([Values(InfillPattern.Lightning, InfillPattern.Gyroid)] InfillPattern pattern)
    {
        var common = Plain with { TopLayers = 2 };
        string Text(int threads) => string.Join(";",
            Sliced(common, Half, common with { InfillPattern = pattern, TopLayers = 6, InfillDensityPercent = 35 }, new SliceOptions { Threads = threads })
                .Value!.Layers
            .SelectMany(l => l.Steps).SelectMany(s => s.Path.RawPoints).Select(p => p.ToString()));
        Assert.That(Text(3), Is.EqualTo(Text(1)));
    }
}
