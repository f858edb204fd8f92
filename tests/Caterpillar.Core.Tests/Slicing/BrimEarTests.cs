using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

/// <summary>Disks that hold corners on the bed.</summary>
[TestFixture]
public class BrimEarTests
{
    private static readonly PrintSettings Ears = new()
    {
        LineWidth = 0.4, BeadShape = BeadShape.Rectangle, WallCount = 1, MinLayerTime = 0, LayerHeight = 0.2, BrimType = BrimType.Ears, BrimWidth = 5,
    };

    private static readonly TriMesh Block = Solids.Block(0, 0, 0, 40, 30, 1);

    private static PrintPath[] Brim(PrintSettings settings, params TriMesh[] meshes)
    {
        var layers = Solids.Slice(settings, meshes);
        Assert.That(layers.Skip(1).SelectMany(l => Solids.Paths(l, Role.Brim)), Is.Empty);
        return Solids.Paths(layers[0], Role.Brim);
    }

    // The corners of a region that the brim surrounds: those within a distance of one of its points.
    private static int Held(PrintPath[] brim, IEnumerable<Vec3> corners, double distance = 5)
        => corners.Count(c => brim.Any(p => p.Points.Any(q => (q - c).LengthXY < distance)));

    [Test]
    public void Each_corner_of_a_block_has_three_quarters_of_a_disk()
    {
        var brim = Brim(Ears, Block);

        Assert.That(brim.Sum(p => p.Volume), Is.EqualTo(4 * 0.75 * Math.PI * 25 * 0.2).Within(1.5).Percent);
        Assert.That(Held(brim, [new(0, 0), new(40, 0), new(40, 30), new(0, 30)]), Is.EqualTo(4));
        foreach (var p in brim.SelectMany(b => b.Points))
        {
            Assert.That(p is { X: > 0 and < 40, Y: > 0 and < 30 }, Is.False, "outside the part");
            Assert.That(new Vec3(Math.Min(Math.Abs(p.X), Math.Abs(p.X - 40)), Math.Min(Math.Abs(p.Y), Math.Abs(p.Y - 30))).LengthXY, Is.LessThan(5));
        }
    }

    [Test]
    public void A_gap_stays_open_and_the_skirt_goes_around_the_ears()
    {
        var gap = Brim(Ears with { BrimGap = 1 }, Block).SelectMany(p => p.Points);
        Assert.That(gap.Where(p => p.Y is > 0 and < 30).Min(p => p.X < 20 ? -p.X : p.X - 40), Is.EqualTo(1.2).Within(0.02));
        var skirt = Solids.Paths(Solids.Slice(Ears with { SkirtLoops = 1, SkirtDistance = 3 }, Block)[0], Role.Skirt).Single();
        Assert.That(skirt.Points.Min(p => p.X), Is.EqualTo(-5 - 3 - 0.2).Within(0.06));
    }

    [Test]
    public void Corners_count_up_to_the_angle_and_round_sides_do_not()
    {
        var hexagon = Solids.Cone(0, 20, 1, 20, 6);
        Assert.That(Brim(Ears with { BrimEarsMaxAngle = 119 }, hexagon), Is.Empty);
        Assert.That(Held(Brim(Ears with { BrimEarsMaxAngle = 121 }, hexagon), Solids.Circle(20, 6)), Is.EqualTo(6));
        Assert.That(Brim(Ears, Solids.Cone(0, 10, 1, 10, 96)), Is.Empty);
        Assert.That(Brim(Ears with { BrimEarsMaxAngle = 0 }, Block), Is.Empty);
    }

    [Test]
    public void A_rounded_corner_has_one_ear_and_concave_ones_have_none()
    {
        var rounded = Region.Rectangle(1, 1, 39, 29).Offset(1, JoinStyle.Round);
        Assert.That(Brim(Ears, Prism.On(rounded, 1)).Sum(p => p.Volume), Is.EqualTo(4 * 0.75 * Math.PI * 25 * 0.2).Within(6).Percent);
        // A frame: its hole has four corners that are concave.
        var frame = Region.Rectangle(0, 0, 40, 40).Subtract(Region.Rectangle(12, 12, 28, 28));
        Assert.That(Brim(Ears, Prism.On(frame, 1)).SelectMany(p => p.Points).Count(p => p is { X: > 10 and < 30, Y: > 10 and < 30 }), Is.Zero);
    }

    [Test]
    public void Points_by_hand_have_disks_with_any_brim_or_none()
    {
        var ears = new ValueList<BrimEar>(new BrimEar(20, 0, 12), new BrimEar(60, 60, 4));
        var settings = Ears with { BrimWidth = 0, BrimType = BrimType.OuterOnly, BrimEars = ears };
        var brim = Brim(settings, Block);
        Assert.That(brim.Sum(p => p.Volume), Is.EqualTo((Math.PI * 36 / 2 + Math.PI * 4) * 0.2).Within(2).Percent);
        // With a brim of 2 mm the ear begins outside of it.
        var both = Brim(settings with { BrimWidth = 2 }, Block).Sum(p => p.Volume);
        var half = 36 * Math.Acos(2 / 6.0) - 2 * Math.Sqrt(36 - 4);
        Assert.That(both, Is.EqualTo((140 * 2 + Math.PI * 4 + half + Math.PI * 4) * 0.2).Within(2).Percent);
    }

    [Test]
    public void A_diameter_of_0_is_refused_by_name()
        => Assert.That(() => Ears with { BrimEars = new ValueList<BrimEar>(new BrimEar(1, 2, 0)) },
            Throws.InstanceOf<ArgumentOutOfRangeException>().With.Message.Contains("brim_ears_mm"));

    [Test]
    public void Supports_get_no_ears()
    {
        // A table: its top hangs over, and supports stand around the leg.
        var settings = Ears with { Support = SupportKind.Grid };
        TriMesh[] table = [Solids.Cone(0, 5, 6, 5, 64), Solids.Block(-20, -20, 6, 20, 20, 8)];
        Assert.That(Brim(settings, table), Is.Empty);
    }
}
