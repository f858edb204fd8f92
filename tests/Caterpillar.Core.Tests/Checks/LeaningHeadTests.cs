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

/// <summary>The check of a leaning head against points of extrusions that are moved into the frame of the head, pose by pose.</summary>
public class LeaningHeadTests
{
    private const double Tolerance = 0.05;

    // What lies between the points and the poses of the judge, mm.
    private const double Coarse = 0.35;
    private static readonly (double Radius, double Height)[] Outline = [(0.5, 0), (4, 6), (20, 12)];
    private static readonly Bounds Box = new(new Vec3(-6, 5, 3), new Vec3(9, 25, 30));

    [TestCase("C head z at 1 -2 0;B head y at 2 0 60")]
    [TestCase("A work x at 0 3 -38;C work z at 1 2 0")]
    [TestCase("B head y at 0 0 42;C work z")]
    public void A_slow_judge_finds_the_same(string axes)
    {
        var kinematics = new Kinematics([.. axes.Split(';').Select(a => RotaryAxis.Parse(a)!)]);
        var head = new LeaningHead(kinematics, Outline, [Box]);
        var random = new Random(5);
        double Next(double from, double to) => from + (to - from) * random.NextDouble();
        Vec3 Point(double reach) => new(Next(-reach, reach), Next(-reach, reach), Next(-reach, reach));
        int hits = 0, free = 0, boxHits = 0, boxFree = 0;
        for (var round = 0; round < 100; round++)
        {
            var strands = new List<(Vec3 A, Vec3 B, double Half, Vec3 Normal)>();
            var grid = new StrandGrid();
            for (var k = random.Next(1, 6); k > 0; k--)
            {
                var a = Point(14) + new Vec3(0, 0, -7);
                var (b, half, normal) = (a + Point(3), Next(0.1, 0.6), (Point(1) + Vec3.UnitZ).Unit());
                strands.Add((a, b, half, normal));
                grid.Add(a, b, half, normal, strands.Count);
            }
            Vec3 turns = new(Next(-80, 80), Next(-80, 80), Next(-180, 180)), from = Point(2);
            var move = new HeadMove(from, turns, from + Point(3), turns + Point(random.Next(2) * 15));
            var (deep, near) = Judge(axes, move, strands, q => Depth(q));
            var contact = head.Meets(grid, move, Tolerance, out var hit);
            if (deep > 1e-9) Assert.That(contact, Is.Not.EqualTo(HeadContact.None), $"round {round}: the judge finds {deep} mm");
            else if (!near) Assert.That(contact, Is.EqualTo(HeadContact.None), $"round {round}: the judge finds nothing near");
            Assert.That(hit is null, Is.EqualTo(contact == HeadContact.None));
            if (deep > 1e-9) hits++;
            if (!near) free++;
            var (inBox, nearBox) = Judge(axes, move, strands, InBox);
            var meets = head.MeetsBox(grid, move, Tolerance, 0, false, out _);
            if (inBox > 1e-9) Assert.That(meets, Is.True, $"round {round}: the judge finds {inBox} mm in the box");
            else if (!nearBox) Assert.That(meets, Is.False, $"round {round}: the judge finds nothing near the box");
            if (inBox > 1e-9) boxHits++;
            if (!nearBox) boxFree++;
        }
        Assert.That(new[] { hits, free, boxHits, boxFree }, Is.All.AtLeast(12), "The rounds show both.");
    }

    private static readonly PrintSetup Leaning = SmallPrint.Setup(p => p with
    {
        RotaryAxes = new([RotaryAxis.Parse("C head z from -360 to 360")!, RotaryAxis.Parse("B head y at 0 0 60 from -110 to 110")!]),
    });

    private static readonly PrintSetup OnTable = SmallPrint.Setup(p => p with
    {
        Origin = BedOrigin.Center, RotaryAxes = new([RotaryAxis.Parse("A work x at 0 0 -35 from -120 to 120")!, RotaryAxis.Parse("C work z")!]),
    });

    [TestCase(0, 90, false)]
    [TestCase(40, -90, true)]
    [TestCase(40, 90, false)]
    [TestCase(-40, 90, true)]
    public void A_head_that_leans_onto_a_wall_hits_it(double tilt, double turn, bool hits)
    {
        // The wall is 10 mm high and the tip 12 mm in front of it, at half its height.
        var print = new SmallPrint().Wall(80, 120, 100, 10).Go(100, 112, 100).Turns(0, tilt, turn).Go(100, 112, 100).Go(100, 112, 5);
        if (hits) print.Expect(CheckCodes.NozzleHits);
        print.Print(105, 112, 5).Go(105, 112, 100);
        Assert.That(Codes(print.Build(), Leaning).Contains(CheckCodes.NozzleHits), Is.EqualTo(hits));
        // The same on a table that tilts: the tool leans along y with A alone, the other way round.
        var table = new SmallPrint(-20).Wall(-20, 20, 0, 10).Go(0, 12, 100).Turns(turn > 0 ? -tilt : tilt, 0, 0).Go(0, 12, 100).Go(0, 12, 5)
            .Print(5, 12, 5).Go(5, 12, 100);
        Assert.That(Codes(table.Build(), OnTable).Contains(CheckCodes.NozzleHits), Is.EqualTo(hits));
    }

    [Test]
    public void A_head_that_leans_too_far_hits_the_bed()
    {
        var print = new SmallPrint(100, 100, 50).Turns(0, 60, 0).Go(100, 100, 50).Go(100, 100, 2);
        var found = SmallPrint.Find(print.Build(), Leaning, CheckCodes.TravelHits);
        Assert.That(found.Single().Message, Does.Contain("hits the bed"));
    }

    // Where it was after homing nobody knows, but where it goes from there is known.
    [Test]
    public void A_head_that_stands_leaning_in_the_bed_hits_it_as_it_turns_upright()
    {
        var print = new SmallPrint(100, 100, 50).Event(new HomeEvent()).Turns(0, 60, 0).Go(100, 100, 2).Turns(0, 0, 0).Go(100, 100, 50);
        Assert.That(SmallPrint.Find(print.Build(), Leaning, CheckCodes.TravelHits).Single().Source!.Move, Is.EqualTo(1));
    }

    // An extrusion of 1 mm that is fresh at first, and a travel back along it that sinks by 2 mm.
    [TestCase(-9, 0, 1)]
    [TestCase(-9, 15, 1)]
    [TestCase(9, 15, 0)]
    public void A_leaning_head_that_sinks_into_the_extrusion_it_has_just_printed_is_found(double x, double tilt, int hits)
    {
        var print = new SmallPrint(50, 50, 5).Turns(0, tilt, -90).Go(50, 50, 5).Print(51, 50, 5).Go(50 + x, 50, 3);
        Assert.That(SmallPrint.Find(print.Build(), Leaning, CheckCodes.TravelHits), Has.Length.EqualTo(hits));
    }

    // The tool leans by 30° toward a wall of 20 mm at y = 100. The lowest corner of a box that is 10 mm wide and begins 20 mm above the tip is then 14.33 mm
    // in front of the tip and 14.82 mm above it.
    [TestCase(114.33, 4.9, true)]
    [TestCase(114.33, 5.4, false)]
    [TestCase(113.3, 4.5, true)]
    [TestCase(113.3, 5.4, false)]
    [TestCase(115.1, 4.9, false)]
    public void Boxes_of_the_head_lean_with_it(double y, double z, bool hits)
    {
        var box = new Bounds(new Vec3(-5, -5, 20), new Vec3(5, 5, 60));
        var setup = Leaning with { Printer = Leaning.Printer with { HeadOutline = Thin, HeadBoxes = new(box) } };
        var found = SmallPrint.Find(BesideWall(y, z), setup, "collision.");
        Assert.That(found.Select(d => d.Code), Is.EqualTo(hits ? new[] { CheckCodes.HeadHits } : []));
        if (hits) Assert.That(found[0].Message, Does.StartWith("The print head of the leaning tool hits an earlier extrusion"));
    }

    // What carries the head does not lean: it stands 30 mm back from the tip, and 60 mm · (1 - cos 30°) = 8.04 mm lower than above an upright one.
    [TestCase(130, 7.9, true)]
    [TestCase(130, 8.3, false)]
    [TestCase(127.3, 7.9, true)]
    [TestCase(126.5, 7.9, false)]
    [TestCase(132.7, 7.9, true)]
    [TestCase(133.5, 7.9, false)]
    public void The_gantry_of_a_leaning_head_stands_upright(double y, double z, bool hits)
    {
        var beam = new Bounds(new Vec3(0, -3, 20), new Vec3(0, 3, 60));
        var setup = Leaning with { Printer = Leaning.Printer with { HeadOutline = Thin, Gantry = new(beam) } };
        var found = SmallPrint.Find(BesideWall(y, z), setup, "collision.");
        Assert.That(found.Select(d => d.Code), Is.EqualTo(hits ? new[] { CheckCodes.GantryHits } : []));
        if (hits) Assert.That(found[0].Message, Does.StartWith("The gantry of the leaning tool hits an earlier extrusion"));
    }

    private static ValueList<HeadPoint> Thin => new(new HeadPoint(0.5, 0), new(1, 6));

    private static Toolpath BesideWall(double y, double z)
        => new SmallPrint().Wall(80, 120, 100, 20).Go(100, y, 200).Turns(0, 30, -90).Go(100, y, 200).Go(100, y, z).Go(100, y, 200).Build();

    [Test]
    public void A_turn_in_place_sweeps_the_head()
    {
        // Upright and leaning away from the wall there is room, but not in between.
        var print = new SmallPrint().Wall(80, 120, 100, 10).Go(100, 112, 100).Turns(0, 40, 90).Go(100, 112, 100).Go(100, 112, 5)
            .Expect(CheckCodes.TravelHits).Turns(0, 40, 450).Go(100, 112, 5);
        var found = SmallPrint.Find(print.Build(), Leaning, CheckCodes.TravelHits);
        Assert.That(found.Single().Source!.Step, Is.EqualTo(print.Planted.Single().Move));
    }

    [TestCase(0.15)]
    [TestCase(0.3)]
    [TestCase(1.5)]
    public void A_wall_that_leans_rests_on_what_is_below_it_along_the_tool(double height)
    {
        // A nozzle of 3 mm; walls are thinner than the layers of the settings, each on the one before and the first on the bed.
        var setup = Leaning with
        {
            Printer = Leaning.Printer with { NozzleDiameter = 3 }, Settings = Leaning.Settings with { LayerHeight = 1.5, FirstLayerHeight = 1.5 },
        };
        var along = new Vec3(Angle.Sin(50), 0, Angle.Cos(50)) * height;
        var print = new SmallPrint(100, 100, 50).Turns(0, 50, 0).Go(100, 100, 50);
        for (var i = 1; i <= 3; i++)
        {
            var at = new Vec3(100, 100) + along * i;
            print.InLayer(new Layer(i, 1.5 * i, 1.5)).Go(at.X, 100, at.Z).Print(at.X, 140, at.Z, 3.4 * height).Go(at.X, 140, 50).Go(100, 100, 50);
        }
        Assert.That(SmallPrint.Find(print.Build(), setup, CheckCodes.Unsupported), Is.Empty);
        var floating = new SmallPrint(100, 100, 50).Turns(0, 50, 0).InLayer(new Layer(0, 1.5, 1.5)).Go(100, 100, 8).Print(100, 140, 8, 3.4 * height);
        Assert.That(SmallPrint.Find(floating.Build(), setup, CheckCodes.InAir), Is.Not.Empty);
    }

    [Test]
    public void A_word_beyond_its_axis_is_an_error()
    {
        var print = new SmallPrint(100, 100, 100).Turns(0, 0, 361).Go(100, 100, 101);
        Assert.That(SmallPrint.Find(print.Build(), Leaning, CheckCodes.AxisRange).Single().Message, Does.StartWith("A move turns C to 361 degrees"));
        var ranged = Leaning with { Printer = Leaning.Printer with { SlideRange = new(new Bounds(Vec3.Zero, new Vec3(150, 150, 150))) } };
        var far = new SmallPrint(140, 100, 100).Turns(0, 80, 0).Go(140, 100, 90).Build();
        Assert.That(SmallPrint.Find(far, ranged, CheckCodes.AxisRange).Single().Message, Does.Contain("slides"));
        Assert.That(SmallPrint.Find(far, Leaning, CheckCodes.AxisRange), Is.Empty);
    }

    private static string[] Codes(Toolpath toolpath, PrintSetup setup) => [.. SmallPrint.Find(toolpath, setup, "collision").Select(d => d.Code)];

    // How deep a point is in the nozzle, or how far from it at most where negative.
    private static double Depth(Vec3 q)
    {
        var best = double.NegativeInfinity;
        (double Radius, double Height)[] points = [.. Outline, (Outline[Outline.Length - 1].Radius, Outline[Outline.Length - 1].Height + LeaningHead.Above)];
        for (var i = 1; i < points.Length; i++)
        {
            var ((r0, h0), (r1, h1)) = (points[i - 1], points[i]);
            var share = Math.Max(0, Math.Min(1, (q.Z - h0) / (h1 - h0)));
            best = Math.Max(best, Math.Min(r0 + (r1 - r0) * share - q.LengthXY, Math.Min(q.Z - h0, h1 - q.Z)));
        }
        return best;
    }

    private static double InBox(Vec3 q)
        => new[] { q.X - Box.Min.X, Box.Max.X - q.X, q.Y - Box.Min.Y, Box.Max.Y - q.Y, q.Z - Box.Min.Z, Box.Max.Z - q.Z }.Min();

    private static (double Deepest, bool IsNear) Judge(
        string axes, HeadMove move, List<(Vec3 A, Vec3 B, double Half, Vec3 Normal)> strands, Func<Vec3, double> depth)
    {
        var deepest = double.NegativeInfinity;
        const int Poses = 40;
        foreach (var point in strands.SelectMany(Points))
        {
            for (var k = 0; k <= Poses; k++)
            {
                var share = (double)k / Poses;
                var q = ToHead(axes, Vec3.Lerp(move.FromTurns, move.ToTurns, share), point - Vec3.Lerp(move.From, move.To, share));
                deepest = Math.Max(deepest, depth(q - new Vec3(0, 0, Tolerance)));
            }
        }
        return (deepest, deepest > -Coarse);
    }

    // Rotations by hand: the head turns by C after its tilt, a table with the tilt undone before C.
    private static Vec3 ToHead(string axes, Vec3 turns, Vec3 p)
    {
        p = About(2, p, -turns.Z);
        return axes.StartsWith("A", StringComparison.Ordinal) ? About(0, p, -turns.X) : About(1, p, -turns.Y);
    }

    private static Vec3 About(int axis, Vec3 p, double degrees)
    {
        double s = Math.Sin(degrees * Math.PI / 180), c = Math.Cos(degrees * Math.PI / 180);
        return axis == 0 ? new Vec3(p.X, c * p.Y - s * p.Z, s * p.Y + c * p.Z) : axis == 1 ? new Vec3(c * p.X + s * p.Z, p.Y, c * p.Z - s * p.X)
            : new Vec3(c * p.X - s * p.Y, s * p.X + c * p.Y, p.Z);
    }

    private static IEnumerable<Vec3> Points((Vec3 A, Vec3 B, double Half, Vec3 Normal) strand)
    {
        var u = Vec3.Cross(strand.Normal, Math.Abs(strand.Normal.X) < 0.8 ? Vec3.UnitX : Vec3.UnitY).Unit();
        var v = Vec3.Cross(strand.Normal, u);
        var count = (int)Math.Ceiling(strand.A.DistanceTo(strand.B) / 0.25);
        for (var k = 0; k <= count; k++)
        {
            var middle = Vec3.Lerp(strand.A, strand.B, (double)k / Math.Max(count, 1));
            yield return middle;
            for (var angle = 0; angle < 360; angle += 30) yield return middle + (u * Angle.Cos(angle) + v * Angle.Sin(angle)) * strand.Half;
        }
    }
}
