using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>Planted collisions, each with the one move that must be found, and the same a little aside, where nothing must be.</summary>
public class CollisionTests
{
    // Of an extrusion.
    private static readonly double Half = new Bead(SmallPrint.Area, 0.2).Width(new PrintSettings().BeadShape) / 2;

    // The flat of the tip is 0.5, the cone reaches (4, 6), the head (20, 12).
    private static readonly PrintSetup Plain = SmallPrint.Setup();

    private static readonly PrintSetup Boxed = SmallPrint.Setup(p => p with
    {
        HeadBoxes = new(new Bounds(new Vec3(-25, -45, 8), new Vec3(50, 30, 60))), HeadOutline = new(new HeadPoint(0.5, 0), new(4, 6)),
    });

    private static readonly PrintSetup Beamed = SmallPrint.Setup(p => p with
    {
        Gantry = new(new Bounds(new Vec3(0, 20, 30), new Vec3(0, 60, 100))), HeadOutline = new(new HeadPoint(0.5, 0), new(4, 6)),
    });

    private static readonly PrintSetup Clipped = SmallPrint.Setup(p => p with
    {
        Clips = new(new Bounds(new Vec3(0, 100, 0), new Vec3(12, 110, 5)), new Bounds(new Vec3(208, 100, 0), new Vec3(220, 110, 5))),
        HeadOutline = new(new HeadPoint(0.5, 0), new(4, 6)),
    });

    public static IEnumerable<TestCaseData> Hits()
    {
        foreach (var (name, setup, print) in Planted())
            yield return new TestCaseData(setup, print).SetName("A_planted_collision_is_found_at_its_move_and_line(" + name + ")");
    }

    [Test]
    public void There_are_enough_planted_collisions() => Assert.That(Planted().Count(), Is.AtLeast(50));

    [TestCaseSource(nameof(Hits))]
    public void A_planted_collision_is_found_at_its_move_and_line(PrintSetup setup, object made)
    {
        var print = (SmallPrint)made;
        var (move, code) = print.Planted.Single();
        var toolpath = print.Build();
        var found = SmallPrint.Find(toolpath, setup, "collision.").Single();
        Assert.That((found.Code, found.Severity, found.Source!.Move, found.Source.Step), Is.EqualTo((code, Severity.Error, move, toolpath[move].Source)),
            found.ToString());
        Assert.That(found.Count, Is.EqualTo(1), "only this move");
        var (file, lines, _) = SmallPrint.Written(toolpath, setup);
        var inFile = PrintCheck.Run(file, setup).Single(d => d.Code.StartsWith("collision.", StringComparison.Ordinal));
        Assert.That((inFile.Code, inFile.Source!.Line), Is.EqualTo((code, lines.OfMove(move).Last)));
    }

    // Beside a wall whose top is so much above the tip, at this distance of its side from the axis.
    [TestCase(1, 0.5 + 3.5 / 6)]
    [TestCase(3, 0.5 + 3.5 / 2)]
    [TestCase(5.8, 0.5 + 3.5 * 5.8 / 6)]
    [TestCase(9, 12)]
    [TestCase(19, 20)]
    public void The_cone_passes_just_beside_a_wall_and_not_nearer(double below, double distance)
    {
        // Extrusions far below the top of the print are asked for by their cells.
        var margin = below > 14 ? 0.5 : 0.02;
        foreach (var (aside, hits) in new[] { (margin, 0), (-0.02, 1) })
        {
            var y = 50 - Half - distance - aside;
            // Of the wall only what is above the tip counts; flush is 0.05.
            var tip = 20 - below - CollisionCheck.Flush;
            var print = new SmallPrint().Wall(60, 80, 50, 20).Go(20, y, 200).Go(20, y, tip).Go(120, y, tip);
            var found = PrintCheck.Run(print.Build(), Plain).Where(d => d.Code is CheckCodes.TravelHits or CheckCodes.Slope);
            Assert.That(found.Sum(d => d.Count), Is.EqualTo(hits), $"{aside} mm");
        }
    }

    [TestCase(0.049, 0)]
    [TestCase(0.051, 1)]
    public void Travels_may_touch_what_is_printed_by_a_twentieth_of_a_millimeter(double depth, int hits)
    {
        var print = new SmallPrint().Wall(60, 80, 50, 4).Go(70, 30, 200).Go(70, 30, 4 - depth).Go(70, 70, 4 - depth);
        Assert.That(SmallPrint.Find(print.Build(), Plain, "collision.").Sum(d => d.Count), Is.EqualTo(hits));
    }

    // Extrusions of 0.2 mm.
    [TestCase(0.099, 0)]
    [TestCase(0.101, 1)]
    public void An_extrusion_may_be_printed_into_another_by_half_its_height(double depth, int hits)
    {
        var print = new SmallPrint().Wall(60, 80, 50, 4).Go(70, 30, 200).Go(70, 30, 4 - depth).Print(70, 70, 4 - depth);
        Assert.That(SmallPrint.Find(print.Build(), Plain, "collision.nozzle").Sum(d => d.Count), Is.EqualTo(hits));
    }

    [TestCase(-25.8, 0)]
    [TestCase(-24.8, 1)]
    [TestCase(50.8, 0)]
    [TestCase(49.8, 1)]
    public void A_box_of_the_head_ends_at_its_edges(double x, int hits)
    {
        // The wall along Y is at x from the axis of the nozzle, 20 mm high: 12 above the bottom of the box at Z 0.2.
        var print = new SmallPrint().Over(100 + x, 100, 0.2);
        for (var k = 1; k <= 100; k++) print.Go(100 + x, print.At.Y, 0.2 * k).Print(100 + x, k % 2 == 1 ? 104 : 100, 0.2 * k);
        print.Go(100 + x, 100, 200).Go(100, 100, 200).Go(100, 100, 1);
        Assert.That(SmallPrint.Find(print.Build(), Boxed, "collision.head").Sum(d => d.Count), Is.EqualTo(hits));
    }

    [TestCase(12, 0)]
    [TestCase(11.6, 0)]
    [TestCase(12.4, 1)]
    public void A_box_of_the_head_hits_only_what_is_above_its_bottom(double top, int hits)
    {
        // Its bottom is 8 above the tip, and flush is 0.05.
        var print = new SmallPrint().Wall(60, 80, 50, top).Go(70, 30, 200).Go(70, 30, 4).Go(70, 31, 4);
        Assert.That(SmallPrint.Find(print.Build(), Boxed, "collision.head").Count(), Is.EqualTo(hits));
    }

    [TestCase(19.5, 0)]
    [TestCase(20.5, 1)]
    [TestCase(59.5, 1)]
    [TestCase(60.6, 0)]
    public void The_gantry_reaches_over_the_whole_bed_along_X(double y, int hits)
    {
        var print = new SmallPrint().Wall(5, 25, 100 + y, 34).Go(200, 100, 200).Go(200, 100, 3).Go(210, 100, 3);
        Assert.That(SmallPrint.Find(print.Build(), Beamed, "collision.gantry").Count(), Is.EqualTo(hits));
    }

    [Test]
    public void Where_the_nozzle_digs_into_a_slope_of_less_than_45_degrees_is_a_note()
    {
        // Extrusions side by side, 0.4 apart, each 0.2 lower than the one before: 27°.
        var print = new SmallPrint(50, 50, 5);
        for (var k = 0; k < 5; k++) print.Go(50, 50 + 0.4 * k, 5 - 0.2 * k).Print(60, 50 + 0.4 * k, 5 - 0.2 * k).Go(60, 50 + 0.4 * k, 100)
            .Go(50, 50 + 0.4 * k + 0.4, 100);
        var found = PrintCheck.Run(print.Build(), Plain).Where(d => d.Code.StartsWith("collision.", StringComparison.Ordinal)
            || d.Code == CheckCodes.Slope).ToArray();
        Assert.That(found.Select(d => (d.Code, d.Severity)), Is.EqualTo(new[] { (CheckCodes.Slope, Severity.Note) }));
        Assert.That(found[0].Message,
            Is.EqualTo("The flat of the nozzle tip cuts into a slope next to it by more than 0.05 mm between (50, 50.4, 100) and (50, 50.4, 4.8). "
                + "A narrower tip or a gentler slope avoids this."));
    }

    // Straight down from the end of an extrusion, whose last 1.4 mm are fresh: after 0.7 mm its part up to 0.7 mm before the end is not any more, and the tip,
    // 0.75 mm below, reaches 0.77 mm to its axis. A box of the head below 0.3 mm reaches as far.
    [TestCase(4.2, 0, "collision.travel")]
    [TestCase(4.31, 0, "")]
    [TestCase(4.2, 0.71, "collision.travel collision.head")]
    [TestCase(4.2, 0.4, "collision.travel")]
    [TestCase(3.4, 0, "collision.travel")]
    public void What_stops_to_be_fresh_in_the_middle_of_a_move_is_hit_by_the_rest_of_it(double z, double box, string codes)
    {
        var setup = SmallPrint.Setup(p => p with
        {
            HeadOutline = new(new HeadPoint(0.5, 0), new(4, 6)),
            HeadBoxes = box > 0 ? new(new Bounds(new Vec3(-box, -box, 0.3), new Vec3(box, box, 10))) : ValueList<Bounds>.Empty,
        });
        var found = SmallPrint.Find(new SmallPrint(50, 50, 5).Print(60, 50, 5).Go(60, 50, z).Build(), setup, "collision.");
        Assert.That(string.Join(" ", found.Select(d => d.Code)), Is.EqualTo(codes));
        Assert.That(found.Select(d => (d.Count, d.Source!.Move)), Is.All.EqualTo((1, 1)));
        Assert.That(found.Select(d => d.Message), Is.All.Contain("an earlier extrusion (move 0)"));
    }

    // The same down and aside: 0.65 mm below, the flat of the tip reaches 0.71 mm to the axis, which is 0.76 mm away, and 1 mm where it digs.
    [Test]
    public void What_stops_to_be_fresh_in_the_middle_of_a_move_is_dug_into_by_the_rest_of_it()
    {
        var setup = SmallPrint.Setup(p => p with { HeadOutline = new(new HeadPoint(0.5, 0), new(4, 6)) });
        var print = new SmallPrint(50, 50, 5).Print(60, 50, 5).Go(60, 50.3, 4.3);
        Assert.That(SmallPrint.Find(print.Build(), setup, CheckCodes.Slope).Select(d => (d.Count, d.Source!.Move)), Is.EqualTo(new[] { (1, (int?)1) }));
        Assert.That(SmallPrint.Find(print.Build(), setup, "collision.").Select(d => d.Code), Is.EqualTo(new[] { CheckCodes.Slope }));
    }

    [Test]
    public void The_message_names_what_is_hit_and_where()
    {
        var print = new SmallPrint().Wall(60, 80, 50, 1).Go(70, 30, 200).Go(70, 30, 0.9).Go(70, 70, 0.9);
        var found = SmallPrint.Find(print.Build(), Plain, "collision.travel").Single();
        Assert.That(found.Message, Does.StartWith("The nozzle hits an earlier extrusion (move 12) at (70, 49."));
    }

    [Test]
    public void Its_own_fresh_extrusion_never_stands_in_the_path_of_the_nozzle()
    {
        // A loop, a steep zigzag upward, straight up and on.
        var print = new SmallPrint().Print(20, 10, 0.2).Print(20, 20, 0.2).Print(10, 20, 0.2).Print(10, 10, 0.2).Go(10, 10, 0.4).Print(20, 10, 0.4);
        print.Over(100, 100, 0.2).Print(100, 100, 8).Print(101, 100, 8).Over(50, 50, 0.2).Print(60, 50, 8).Print(70, 50, 9);
        Assert.That(SmallPrint.Find(print.Build(), Plain, "collision."), Is.Empty);
    }

    [Test]
    public void After_homing_the_head_comes_from_where_it_is()
    {
        var print = new SmallPrint().Wall(0, 80, 60, 10).Event(new HomeEvent()).Go(0, 0, 0).Go(0, 0, 12);
        Assert.That(SmallPrint.Find(print.Build(), Plain, "collision."), Is.Empty);
    }

    [TestCase(40, 50, 3, 1)]
    [TestCase(100, 50, 3, 1)]
    [TestCase(100, 80, 3, 0)]
    [TestCase(100, 50, 7, 0)]
    public void Homing_along_X_goes_at_its_height(double from, double y, double z, int hits)
    {
        var print = new SmallPrint().Wall(20, 30, 50, 6).Go(from, y, 200).Go(from, y, z).Event(new HomeEvent(true, false, false)).Go(0, y, z);
        Assert.That(SmallPrint.Find(print.Build(), Plain, "collision."), Has.Length.EqualTo(hits));
    }

    [TestCase(2, 1)]
    [TestCase(60, 0)]
    public void Homing_down_beside_the_print_is_a_collision_where_it_stands_there(double y, int hits)
    {
        var print = new SmallPrint().Wall(0, 80, y, 10).Event(new HomeEvent()).Go(0, 0, 0);
        Assert.That(SmallPrint.Find(print.Build(), Plain, "collision."), Has.Length.EqualTo(hits));
        // Deltas home upward.
        var delta = SmallPrint.Setup(p => p with { BedShape = BedShape.Round, BuildVolume = new Vec3(400, 400, 400) });
        Assert.That(SmallPrint.Find(print.Build(), delta, "collision."), Is.Empty);
    }

    private static IEnumerable<(string Name, PrintSetup Setup, SmallPrint Print)> Planted()
    {
        foreach (var depth in new[] { 0.06, 0.2, 1, 5 })
        {
            foreach (var (dx, dy) in new[] { (1, 0), (-1, 0), (0, 1), (0, -1), (1, 1) })
            {
                // Through a post of 0.4 mm, from 30 mm away to 30 mm beyond it.
                var (x, y, z) = (100 - 30 * dx, 50 - 30 * dy, 6 - depth);
                yield return ($"travel {depth} {dx} {dy}", Plain,
                    Post(6).Go(x, y, 200).Go(x, y, z).Expect(CheckCodes.TravelHits).Go(100 + 30 * dx, 50 + 30 * dy, z));
                if (depth > 0.1)
                    yield return ($"print {depth} {dx} {dy}", Plain,
                        Post(6).Go(x, y, 200).Go(x, y, z).Expect(CheckCodes.NozzleHits).Print(100 + 30 * dx, 50 + 30 * dy, z));
            }
        }
        foreach (var (below, distance) in new[] { (1.0, 1.0), (2, 1.6), (4, 2.7), (8, 8.5), (15, 19) })
            yield return ($"cone {below}", Plain,
                Post(18).Go(60, 50 + distance, 200).Go(60, 50 + distance, 18 - below).Expect(CheckCodes.TravelHits).Go(140, 50 + distance, 18 - below));
        foreach (var gap in new[] { 5.0, 12, 19 })
            yield return ($"one object after the other {gap}", Plain, Post(30).Over(100, 150, 0.2).Expect(CheckCodes.NozzleHits).Print(100, 50.4 + gap, 0.2));
        foreach (var (from, to) in new[] { (20.0, 1.0), (1.0, 20.0), (12.0, 4.0) })
            yield return ($"ramp {from} to {to}", Plain, Post(18).Go(60, 50, 200).Go(60, 50, from).Expect(CheckCodes.TravelHits).Go(140, 50, to));
        yield return ("straight down", Plain, Post(6).Go(100, 50, 200).Expect(CheckCodes.TravelHits).Go(100, 50, 5));
        yield return ("straight down beside", Plain, Post(6).Go(100.6, 50, 200).Expect(CheckCodes.TravelHits).Go(100.6, 50, 5));
        yield return ("arc", Plain, Post(6).Go(60, 90, 200).Go(60, 90, 5).Expect(CheckCodes.TravelHits).Arc(140, 90, 5, new Vec3(100, 90, 5), 180));
        yield return ("drawn around and down", Plain, Spiral());
        yield return ("down beside itself", Plain, Hairpin());
        yield return ("box", Boxed, Post(18).Go(100, 10, 200).Expect(CheckCodes.HeadHits).Go(100, 30, 4));
        yield return ("box on a ramp", Boxed, Post(18).Go(20, 40, 50).Expect(CheckCodes.HeadHits).Go(90, 40, 6));
        yield return ("box beyond the nozzle", Boxed, Post(18).Go(120, 80, 200).Expect(CheckCodes.HeadHits).Go(120, 80, 9));
        yield return ("beam", Beamed, Post(40).Go(200, 10, 200).Expect(CheckCodes.GantryHits).Go(200, 10, 2));
        yield return ("beam from afar", Beamed, Post(40).Go(5, 200, 200).Go(5, 200, 5).Expect(CheckCodes.GantryHits).Go(5, 15, 5));
        yield return ("clip", Clipped, new SmallPrint(50, 105, 10).Go(50, 105, 3).Expect(CheckCodes.ClipHit).Go(5, 105, 3));
        yield return ("clip from above", Clipped, new SmallPrint(50, 105, 10).Go(215, 105, 10).Expect(CheckCodes.ClipHit).Go(215, 105, 4.9));
        yield return ("cone at a clip", Clipped, new SmallPrint(50, 105, 10).Go(50, 105, 1).Expect(CheckCodes.ClipHit).Print(14, 105, 1));
        yield return ("gantry at a clip",
            SmallPrint.Setup(p => p with { Clips = Clipped.Printer.Clips, Gantry = new(new Bounds(new Vec3(0, 20, 3), new Vec3(0, 60, 9))) }),
            new SmallPrint(50, 200, 10).Go(100, 200, 1).Expect(CheckCodes.ClipHit).Go(100, 85, 1));
        yield return ("head at a clip",
            SmallPrint.Setup(p => p with { Clips = Clipped.Printer.Clips, HeadBoxes = new(new Bounds(new Vec3(-5, -5, 2), new Vec3(60, 5, 9))) }),
            new SmallPrint(50, 105, 10).Go(50, 105, 1).Expect(CheckCodes.ClipHit).Go(160, 105, 1));
    }

    // A post at (100, 50), 0.4 mm wide and up to some height.
    private static SmallPrint Post(double top)
    {
        var print = new SmallPrint().Over(100, 49.8, 0.2);
        for (var k = 1; k <= (int)Math.Round(top / 0.2); k++) print.Go(100, print.At.Y, 0.2 * k).Print(100, k % 2 == 1 ? 50.2 : 49.8, 0.2 * k);
        return print.Go(100, print.At.Y, 200);
    }

    // Around a circle of 5 mm and down by 1 mm a turn: after almost a turn the nozzle is below the extrusion of the turn before.
    private static SmallPrint Spiral()
    {
        var print = new SmallPrint(105, 100, 30).Go(105, 100, 20);
        for (var k = 1; k <= 39; k++)
        {
            var (sin, cos) = Angle.SinCos(9.0 * k);
            // From the move on which the flat of the tip comes to the first extrusion.
            if (k == 39) print.Expect(CheckCodes.NozzleHits);
            print.Print(100 + 5 * cos, 100 + 5 * sin, 20 - k / 40.0);
        }
        return print;
    }

    // Up a steep line, over, and down close beside it.
    private static SmallPrint Hairpin()
        => new SmallPrint(50, 50, 9).Go(50, 50, 0.2).Print(55, 50, 15).Print(55.5, 50.5, 15).Expect(CheckCodes.NozzleHits).Print(50.5, 50.5, 1);
}
