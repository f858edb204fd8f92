using System;
using System.Linq;
using Caterpillar.Curved;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Curved;

/// <summary>Moves of paths that are lifted onto curved layers, by hand-computed lengths and beads.</summary>
public class LiftedPathTests
{
    [Test]
    public void Moves_along_a_parabola_are_as_long_as_the_tolerance_allows()
    {
        var field = LayerField.Vertical(PlanSurface.Of((x, _) => x * x / 100, 1));
        var path = new PrintPath([new Vec3(-20, 0, 1), new Vec3(20, 0, 1)], [new Bead(0.08, 0.2)], false);
        var rules = new LiftRules(new PrintSettings { CurvedTolerance = 0.01 }, 0, 60, null, false);
        var points = new PathLifter(field, rules, null).Lift(new PathStep(path)).Single().Path.Points;
        var sags = points.Zip(points.Skip(1), (a, b) => (b.X - a.X) * (b.X - a.X) / 400).ToArray();
        Assert.That(sags, Has.All.LessThan(0.01));
        // At three quarters of the tolerance, in the middle where the chord is level, 1.73 mm.
        Assert.That(sags, Has.Length.LessThan(28).And.Length.GreaterThan(20));
    }

    private static JoinedExtrusion Joined(params (double X, double Y, Bead Bead)[] pieces)
    {
        var joined = new JoinedExtrusion(0.01, 0.1, 0.1);
        var at = Vec3.Zero;
        foreach (var (x, y, bead) in pieces)
        {
            joined.Add(at, new Vec3(x, y), bead, (bead.Area, bead.Area), keepsStart: false);
            at = new Vec3(x, y);
        }
        return joined;
    }

    // A layer of a fan, whose gap grows evenly along the line.
    [TestCase(10)]
    [TestCase(3)]
    public void Along_a_move_the_gap_changes_by_no_more_than_its_share(double percent)
    {
        var field = LayerField.Between(PlanSurface.Level(0), PlanSurface.Of((x, _) => 5 + 0.125 * x));
        var path = new PrintPath([new Vec3(0, 5, 0.5), new Vec3(40, 5, 0.5)], [new Bead(0.009, 0.02)], false);
        var rules = new LiftRules(new PrintSettings { CurvedGapStep = percent }, 0.06, 60, null, false);
        var points = new PathLifter(field, rules, null).Lift(new PathStep(path)).Single().Path.Points;
        var changes = points.Zip(points.Skip(1), (a, b) => 1 - a.Z / b.Z).ToArray();
        Assert.That(changes, Has.All.LessThan(percent / 100));
        Assert.That(changes, Has.Length.LessThan(1.3 * Math.Log(2) / Math.Log(1 + percent / 100) + 1));
    }

    // The gap doubles within 0.4 mm of 10.
    [Test]
    public void A_sharp_change_of_the_gap_takes_no_shorter_moves_than_half_a_line()
    {
        var field = LayerField.Between(PlanSurface.Level(0), PlanSurface.Of((x, _) => 5 + 12.5 * Math.Min(Math.Max(x - 5, 0), 0.4), 0.1));
        var path = new PrintPath([new Vec3(0, 5, 0.05), new Vec3(10, 5, 0.05)], [new Bead(0.009, 0.02)], false);
        var lifted = new PathLifter(field, new LiftRules(new PrintSettings(), 0.02, 89, null, false), null).Lift(new PathStep(path)).Single().Path;
        Assert.That(lifted.SegmentCount, Is.LessThan(8));
        var volume = Enumerable.Range(0, lifted.SegmentCount).Sum(i => lifted.BeadOf(i).Area * lifted.LengthOf(i));
        // 0.45 mm wide, with a gap of 0.1 mm, then 0.2 mm.
        Assert.That(volume, Is.EqualTo(0.009 * 5 * (5 * 1 + 0.4 * 1.5 + 4.6 * 2)).Within(0.5).Percent);
    }

    [Test]
    public void Pieces_of_an_extrusion_are_joined_where_a_line_does_and_keep_their_volume()
    {
        Bead Of(double area, double height = 0.2, double speed = 30) => new(area, height, speed);
        int Pieces(double x, double y, Bead next) => Joined((1, 0, Of(1)), (x, y, next)).Beads.Count;
        Assert.That(Pieces(3, 0, Of(1)), Is.EqualTo(1));
        Assert.That(Pieces(3, 0, Of(1.09)), Is.EqualTo(1));
        Assert.That(Pieces(3, 0, Of(0.91)), Is.EqualTo(1));
        Assert.That(Pieces(3, 0, Of(1.2)), Is.EqualTo(2));
        Assert.That(Pieces(3, 0, Of(0.8)), Is.EqualTo(2));
        Assert.That(Joined((0.05, 0, Of(1)), (0.1, 0, Of(2))).Beads.Single().Area, Is.EqualTo(1.5).Within(1e-12), "Short ones have one bead.");
        Assert.That(Joined((0.05, 0, Of(1)), (0.11, 0, Of(2))).Beads, Has.Count.EqualTo(2));
        Assert.That(Pieces(3, 0, Of(1, speed: 40)), Is.EqualTo(2));
        Assert.That(Pieces(3, 0, Of(1, height: 0)), Is.EqualTo(2));
        Assert.That(Pieces(0.5, 0, Of(1)), Is.EqualTo(2), "Back.");
        Assert.That(Pieces(2, 0.019, Of(1)), Is.EqualTo(1));
        Assert.That(Pieces(2, 0.03, Of(1)), Is.EqualTo(2));
        var mean = Joined((1, 0, Of(1, 0.2)), (4, 0, Of(1.08, 0.3)));
        Assert.That((mean.Beads[0].Area, mean.Beads[0].Height), Is.EqualTo((1.06, 0.275)).Within(1e-12));
        Assert.That(mean.Points, Is.EqualTo(new[] { Vec3.Zero, new Vec3(4, 0) }));
        Assert.That(Joined((1, 0, Of(1)), (2, 0, Of(1.06)), (3, 0, Of(0.94))).Beads, Has.Count.EqualTo(2), "Both ends of the range count.");
        Assert.That(Joined((1, 0.009, Of(1)), (2, 0.009, Of(1)), (9, -0.02, Of(1))).Beads, Has.Count.EqualTo(2), "All points that were passed count.");
        Assert.That(Joined([.. Enumerable.Range(1, 60).Select(i => ((double)i, 0.0, Of(1)))]).Beads, Has.Count.EqualTo(2), "49 at most.");
        var kept = new JoinedExtrusion(0.01, 0.1, 0.1);
        kept.Add(Vec3.Zero, new Vec3(1, 0), Of(1), (1, 1), false);
        kept.Add(new Vec3(1, 0), new Vec3(2, 0), Of(1), (1, 1), true);
        Assert.That((kept.Points.Count, kept.Beads.Count), Is.EqualTo((3, 2)));
        kept.Clear();
        kept.Add(new Vec3(5, 5), new Vec3(6, 5), Of(2), (2, 2), false);
        Assert.That(kept.Points, Is.EqualTo(new[] { new Vec3(5, 5), new Vec3(6, 5) }));
    }
}
