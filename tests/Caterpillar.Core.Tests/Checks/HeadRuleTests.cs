using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>Boxes of the head, beams of the gantry and clips: what is touched, what is told, how often.</summary>
public class HeadRuleTests
{
    private static readonly Bounds Clip = new(new Vec3(100, 100, 0), new Vec3(112, 110, 5));

    // A needle over clips of many shapes, 0.1 mm below their top: hits everywhere inside, and nowhere farther off than a cell.
    [TestCase(12, 10)]
    [TestCase(10, 0.6)]
    [TestCase(0.6, 10)]
    [TestCase(10, 0.5)]
    [TestCase(0.4, 10)]
    [TestCase(3, 3.1)]
    [TestCase(10, 0)]
    public void A_clip_is_solid_up_to_its_edges(double width, double depth)
    {
        var setup = SmallPrint.Setup(p => p with
        {
            Clips = new(new Bounds(new Vec3(100, 100, 0), new Vec3(100 + width, 100 + depth, 5))), HeadOutline = new(new HeadPoint(0.02, 0)),
        });
        bool Hits(double x, double y) => SmallPrint.Find(new SmallPrint(x, y, 20).Go(x, y, 4.9).Build(), setup, CheckCodes.ClipHit).Length > 0;
        for (var k = 0; k <= 20; k++)
        {
            // Corners are rounded by a quarter of a millimeter.
            var (insetX, insetY) = (Math.Min(0.26, width / 2), Math.Min(0.26, depth / 2));
            var (x, y) = (100 + insetX + (width - 2 * insetX) * k / 20, 100 + insetY + (depth - 2 * insetY) * k / 20);
            Assert.That(Hits(x, 100 + depth / 2), Is.True, $"{x}");
            Assert.That(Hits(100 + width / 2, y), Is.True, $"{y}");
            Assert.That(Hits(x, 99.4) || Hits(x, 100.6 + depth) || Hits(99.4, y) || Hits(100.6 + width, y), Is.False, $"{x} {y}");
        }
    }

    // Clips are lines side by side, each at most half a millimeter wide: how far a needle is off along the diagonal of a corner, and beside the left edge.
    [TestCase(12, 10, 0.25, 0)]
    [TestCase(12, 0.74, 0.185, 0)]
    [TestCase(12, 10.3, 5.15 / 21, 0)]
    [TestCase(12, 0.4, 0.2, 0)]
    [TestCase(0.2, 10, 0.25, 0.15)]
    public void A_clip_is_as_round_at_its_corners_as_its_lines(double width, double depth, double half, double beyond)
    {
        const double Needle = 0.02;
        var setup = SmallPrint.Setup(p => p with
        {
            Clips = new(new Bounds(new Vec3(100, 100, 0), new Vec3(100 + width, 100 + depth, 5))), HeadOutline = new(new HeadPoint(Needle, 0)),
        });
        bool Hits(double x, double y) => SmallPrint.Find(new SmallPrint(x, y, 20).Go(x, y, 4.9).Build(), setup, CheckCodes.ClipHit).Length > 0;
        var middle = 100 + half;
        var left = 100 - beyond - Needle;
        Assert.That((Hits(left + 0.005, middle), Hits(left - 0.005, middle)), Is.EqualTo((true, false)), "left edge");
        var end = 100 - beyond + half;
        var reach = (half + Needle) * Math.Sqrt(0.5);
        var (x, y) = (end - reach, middle - reach);
        Assert.That((Hits(x + 0.005, y + 0.005), Hits(x - 0.005, y - 0.005)), Is.EqualTo((true, false)), "corner");
    }

    // A short extrusion 5 mm above the bed, and a box 10 mm to the left of the tip, 2 mm above it: it comes over the extrusion when that is no longer fresh.
    [TestCase(0, 1)]
    [TestCase(3.5, 0)]
    public void What_was_fresh_at_the_start_of_a_move_is_hit_farther_on(double down, int found)
    {
        var setup = SmallPrint.Setup(p => p with
        {
            HeadOutline = new(new HeadPoint(0.5, 0)), HeadBoxes = new(new Bounds(new Vec3(-12, -2, 2), new Vec3(-8, 2, 9))),
        });
        var print = new SmallPrint(60, 60, 5).Print(60.5, 60, 5).Go(90, 60, down);
        Assert.That(SmallPrint.Find(print.Build(), setup, CheckCodes.HeadHits).Sum(d => d.Count), Is.EqualTo(found));
    }

    // A head that is flat and wide half a millimeter above its tip: it sinks by 2 mm while it goes away from a short extrusion.
    [TestCase(8, 1)]
    [TestCase(9.9, 0)]
    public void A_wide_head_that_sinks_hits_what_was_fresh(double down, int found)
    {
        var setup = SmallPrint.Setup(p => p with { HeadOutline = new(new HeadPoint(0.5, 0), new(60, 0.5)) });
        var print = new SmallPrint(60, 60, 10).Print(60.5, 60, 10).Go(90, 60, down);
        Assert.That(SmallPrint.Find(print.Build(), setup, CheckCodes.TravelHits).Sum(d => d.Count), Is.EqualTo(found));
    }

    [Test]
    public void A_travel_through_a_clip_is_one_finding()
    {
        var setup = SmallPrint.Setup(p => p with { Clips = new(Clip) });
        var found = SmallPrint.Find(new SmallPrint(90, 105, 20).Go(90, 105, 2).Go(140, 105, 2).Build(), setup, "collision.").Single();
        Assert.That((found.Code, found.Count, found.Source!.Move), Is.EqualTo((CheckCodes.ClipHit, 1, (int?)1)));
    }

    // Parts of the head 2 mm above the tip, 10 to 20 mm aside.
    [TestCase(true, "The print head hits bed clip 1")]
    [TestCase(false, "The gantry hits bed clip 1")]
    public void What_hits_a_clip_is_named(bool head, string text)
    {
        var part = new Bounds(new Vec3(-2, 10, 2), new Vec3(2, 20, 9));
        var setup = SmallPrint.Setup(p => p with
        {
            Clips = new(Clip), HeadOutline = new(new HeadPoint(0.5, 0)),
            HeadBoxes = head ? new(part) : ValueList<Bounds>.Empty, Gantry = head ? ValueList<Bounds>.Empty : new(part),
        });
        var found = SmallPrint.Find(new SmallPrint(105, 90, 20).Go(105, 90, 1).Build(), setup, CheckCodes.ClipHit).Single();
        Assert.That(found.Message, Does.StartWith(text));
        Assert.That(SmallPrint.Find(new SmallPrint(105, 90, 20).Go(105, 90, 3.01).Build(), setup, CheckCodes.ClipHit), Is.Empty);
    }

    // A probe that hangs 3 mm below the tip, 10 mm aside; an extrusion 5 mm above the bed.
    [TestCase(7.9, 1)]
    [TestCase(8.1, 0)]
    public void A_box_below_the_tip_hits_what_the_tip_passes_over(double z, int found)
    {
        var setup = SmallPrint.Setup(p => p with { HeadBoxes = new(new Bounds(new Vec3(-1, 9, -3), new Vec3(1, 11, 9))) });
        var print = new SmallPrint().Wall(60, 70, 60, 5).Go(50, 50, 50).Go(50, 50, z).Go(80, 50, z);
        Assert.That(SmallPrint.Find(print.Build(), setup, CheckCodes.HeadHits).Sum(d => d.Count), Is.EqualTo(found));
    }

    [Test]
    public void A_box_that_goes_on_through_extrusions_is_one_finding_for_each_move()
    {
        var setup = SmallPrint.Setup(p
            => p with { HeadOutline = new(new HeadPoint(0.5, 0)), HeadBoxes = new(new Bounds(new Vec3(-1, 9, 1), new Vec3(1, 11, 9))) });
        var print = new SmallPrint().Wall(60, 90, 60, 5).Go(65, 50, 50).Go(65, 50, 2).Go(85, 50, 2);
        Assert.That(SmallPrint.Find(print.Build(), setup, CheckCodes.HeadHits).Single().Count, Is.EqualTo(2));
    }

    // A clip from 50 to 62 mm along X and from 100 to 110 along Y; the tip is 1 mm wide, and a cell more is looked at.
    [TestCase(49.2, 105, 0)]
    [TestCase(49.6, 105, 1)]
    [TestCase(62.4, 105, 1)]
    [TestCase(62.8, 105, 0)]
    [TestCase(56, 99.2, 0)]
    [TestCase(56, 99.6, 1)]
    [TestCase(56, 110.4, 1)]
    [TestCase(56, 110.8, 0)]
    public void A_clip_ends_at_its_sides(double x, double y, int found)
    {
        var setup = SmallPrint.Setup(
            p => p with { HeadOutline = new(new HeadPoint(0.5, 0)), Clips = new(new Bounds(new Vec3(50, 100, 0), new Vec3(62, 110, 5))) });
        Assert.That(SmallPrint.Find(new SmallPrint(x, y, 20).Go(x, y, 4.9).Build(), setup, CheckCodes.ClipHit).Length, Is.EqualTo(found));
    }

    // Narrower along X than its extrusions would be.
    [TestCase(49.2, 0)]
    [TestCase(50.1, 1)]
    [TestCase(51, 0)]
    public void A_clip_may_be_thin(double x, int found)
    {
        var setup = SmallPrint.Setup(
            p => p with { HeadOutline = new(new HeadPoint(0.5, 0)), Clips = new(new Bounds(new Vec3(50, 100, 0), new Vec3(50.2, 110, 5))) });
        Assert.That(SmallPrint.Find(new SmallPrint(x, 105, 20).Go(x, 105, 4.9).Build(), setup, CheckCodes.ClipHit).Length, Is.EqualTo(found));
    }

    [Test]
    public void Each_of_several_boxes_and_beams_is_looked_at()
    {
        var boxes = new[] { new Bounds(new Vec3(-30, -30, 40), new Vec3(30, 30, 50)), new Bounds(new Vec3(9, -1, 1), new Vec3(11, 1, 9)) };
        var beams = new[] { new Bounds(new Vec3(0, -90, 40), new Vec3(0, -80, 50)), new Bounds(new Vec3(0, 14, 1), new Vec3(0, 18, 9)) };
        var setup = SmallPrint.Setup(p => p with { HeadOutline = new(new HeadPoint(0.5, 0)), HeadBoxes = new(boxes), Gantry = new(beams) });
        var print = new SmallPrint().Wall(60, 70, 60, 5).Go(55, 40, 50).Go(55, 40, 3).Go(55, 80, 3);
        var found = SmallPrint.Find(print.Build(), setup, "collision.");
        Assert.That(found.Select(d => d.Code), Is.EquivalentTo(new[] { CheckCodes.HeadHits, CheckCodes.GantryHits }));
        Assert.That(found.Single(d => d.Code == CheckCodes.HeadHits).Message, Does.StartWith("The print head hits an earlier extrusion"));
        Assert.That(found.Single(d => d.Code == CheckCodes.GantryHits).Message, Does.StartWith("The gantry hits"));
    }

    [Test]
    public void The_first_extrusion_of_a_print_can_be_hit_and_is_named()
    {
        var print = new SmallPrint(50, 50, 5).Print(70, 50, 5).Go(70, 50, 50).Go(60, 40, 50).Go(60, 40, 4.5).Go(60, 60, 4.5);
        Assert.That(SmallPrint.Find(print.Build(), SmallPrint.Setup(), "collision.").Single().Message,
            Does.StartWith("The nozzle hits an earlier extrusion (move 0) at ("));
    }

    [Test]
    public void What_the_nozzle_just_leaves_may_be_touched()
    {
        // Straight down into the end of its extrusion; and after a way of 300 mm.
        var print = new SmallPrint(50, 50, 3).Print(70, 50, 3);
        Assert.That(SmallPrint.Find(print.Go(70, 50, 2.5).Build(), SmallPrint.Setup(), "collision."), Is.Empty);
        var later = new SmallPrint(50, 50, 3).Print(70, 50, 3).Go(70, 50, 150).Go(70, 50, 2.5);
        Assert.That(SmallPrint.Find(later.Build(), SmallPrint.Setup(), "collision.").Single().Source!.Move, Is.EqualTo(2));
    }

    // A pen draws without material: no half of an extrusion excuses it.
    [TestCase(2.96, 0)]
    [TestCase(2.9, 1)]
    public void A_stroke_without_material_may_not_go_through_extrusions(double z, int found)
    {
        var print = new SmallPrint(50, 50, 3).Print(70, 50, 3).Go(70, 50, 50).Go(60, 40, 50).Go(60, 40, z).Print(60, 60, z, 0);
        Assert.That(SmallPrint.Find(print.Build(), SmallPrint.Setup(), CheckCodes.NozzleHits).Sum(d => d.Count), Is.EqualTo(found));
    }

    // A box that reaches 60 mm to one side: what is high there comes later, whichever side that is.
}
