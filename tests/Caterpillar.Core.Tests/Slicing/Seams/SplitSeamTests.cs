using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

/// <summary>Aligned seams where contours split, join and begin.</summary>
public class SplitSeamTests
{
    private static readonly PrintSettings Plain = new()
    {
        LineWidth = 0.4, BeadShape = BeadShape.Rectangle, Resolution = 0, TopLayers = 0, BottomLayers = 0, InfillDensityPercent = 0, WallCount = 1,
        MinLayerTime = 0, SkirtLoops = 0, SeamPosition = SeamPosition.Aligned,
    };

    // A trunk of 2 mm, whose seam lies in the notch of its back, carries two branches.
    [TestCase(10, 9.7, 10.3)]
    [TestCase(10, 8.8, 11.2)]
    [TestCase(8, 9.5, 10.5)]
    [TestCase(12, 9.5, 10.5)]
    [TestCase(3, 8, 12)]
    [TestCase(17, 8, 12)]
    public void Each_branch_begins_at_the_place_nearest_to_the_seam_of_the_trunk(double notch, double left, double right)
    {
        Vec3[] outline = [new(0, 0), new(20, 0), new(20, 10), new(notch + 1, 10), new(notch, 8), new(notch - 1, 10), new(0, 10)];
        var layers = Solids.Slice(Plain, Solids.Loft(0, outline, 2, outline), Solids.Block(0, 0, 2, left, 10, 4), Solids.Block(right, 0, 2, 20, 10, 4));
        var trunk = Walls(layers[9]).Single()[0];
        Assert.That(trunk.DistanceTo(new Vec3(notch, 8)), Is.LessThan(1), "in the notch");
        var branches = Walls(layers[10]);
        Assert.That(branches, Has.Length.EqualTo(2));
        foreach (var branch in branches)
        {
            var best = LoopPlace.Nearest(branch, trunk).Point.DistanceTo(trunk);
            // It may keep a millimeter from the air of the notch, and lie in a corner within one more.
            Assert.That(branch[0].DistanceTo(trunk), Is.LessThan(best + 2), $"{branch[0]} above {trunk}");
        }
        foreach (var layer in layers.Skip(11)) Assert.That(Jump(layers[10], layer), Is.LessThan(1), "the branches go straight on");
    }

    [TestCase(0.0)]
    [TestCase(0.3)]
    public void A_body_keeps_its_seam_where_a_finger_joins_it(double grown)
    {
        // The finger goes straight on, so that its seam is nearer to the joined contour than that of the body, which grows.
        var layers = Solids.Slice(Plain, Solids.Block(0, 0, 0, 20, 20, 4), Solids.Block(8, -6, 0, 12, -2, 4),
            Solids.Block(-grown, 0, 4, 20 + grown, 20 + grown, 6), Solids.Block(8, -6, 4, 12, 1, 6));
        var below = Walls(layers[19]);
        Assert.That(below, Has.Length.EqualTo(2));
        var body = below.OrderByDescending(w => w[0].Y).First()[0];
        foreach (var layer in layers.Skip(20)) Assert.That(Walls(layer).Single()[0].DistanceTo(body), Is.LessThan(1), $"at {layer.Layer.Z}");
    }

    [Test]
    public void An_island_that_begins_has_its_seam_in_its_concave_corner_from_the_first_layer_on()
    {
        // Begins 2.5 mm beside the block, whose seam is no concern of it.
        var layers = Solids.Slice(Plain, Solids.Block(0, 0, 0, 20, 20, 4), Solids.Block(0, 22.5, 2, 20, 30.5, 4), Solids.Block(0, 22.5, 2, 8, 42.5, 4));
        Assert.That(Walls(layers[9]), Has.Length.EqualTo(1));
        foreach (var layer in layers.Skip(10))
        {
            Assert.That(Walls(layer), Has.Length.EqualTo(2));
            Assert.That(Walls(layer).Min(w => w[0].DistanceTo(new Vec3(7.8, 30.3))), Is.LessThan(0.01), $"at {layer.Layer.Z}");
        }
    }

    [TestCase(1.9, true)]
    [TestCase(2.1, false)]
    public void Loops_are_close_by_the_least_distance_between_them(double gap, bool close)
    {
        var square = Rectangle(0, 0, 10, 10);
        Vec3[][] others =
        [
            Rectangle(10 + gap, 3, 30, 4), Rectangle(-30, 3, -gap, 4), Rectangle(3, 10 + gap, 4, 30), Rectangle(3, -30, 4, -gap),
            Rectangle(gap, gap, 10 - gap, 10 - gap), Rectangle(-gap, -gap, 10 + gap, 10 + gap),
        ];
        foreach (var other in others)
        {
            Assert.That(LoopGap.IsWithin(square, other, 2), Is.EqualTo(close));
            Assert.That(LoopGap.IsWithin(other, square, 2), Is.EqualTo(close));
        }
    }

    [Test]
    public void Loops_that_cross_far_from_their_corners_are_close()
        => Assert.That(LoopGap.IsWithin(Rectangle(-30, -5, 30, 5), Rectangle(-5, -30, 5, 30), 2));

    private static double Jump(SlicedLayer below, SlicedLayer layer) => Walls(layer).Max(w => Walls(below).Min(b => b[0].DistanceTo(w[0])));

    private static Vec3[][] Walls(SlicedLayer layer)
        => Solids.Paths(layer, Role.OuterWall, Role.OverhangWall).Where(p => p.IsClosed).Select(p => p.Points.Select(v => v.WithZ(0)).ToArray()).ToArray();

    private static Vec3[] Rectangle(double x0, double y0, double x1, double y1) => [new(x0, y0), new(x1, y0), new(x1, y1), new(x0, y1)];
}
