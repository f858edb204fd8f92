using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Shaping;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Shaping;

public class GapBeadTests
{
    private static readonly Bead Bead = new(0.08, 0.2, 30);
    private static readonly GapBead Gap = new() { Shape = BeadShape.Rectangle };

    [Test]
    public void On_the_bed_the_gap_is_the_height()
    {
        var path = Apply(Gap, Line(0, 0, 0.3, 10, 0, 0.3)).Single();
        Assert.That(path.SegmentCount, Is.EqualTo(1), "pieces with the same gap stay one segment");
        Assert.That(path.BeadOf(0).Area, Is.EqualTo(0.12).Within(1e-12));
        Assert.That(path.BeadOf(0).Height, Is.EqualTo(0.3).Within(1e-12));
        Assert.That(path.BeadOf(0).Speed, Is.EqualTo(30));
        var thick = Apply(Gap with { Width = 1 }, Line(0, 0, 0.3, 10, 0, 0.3)).Single();
        Assert.That(thick.BeadOf(0).Area, Is.EqualTo(0.3).Within(1e-12));
    }

    [Test]
    public void A_bead_at_its_own_height_stays_as_it_is()
    {
        var path = Apply(Gap, Line(0, 0, 0.2, 10, 0, 0.2)).Single();
        Assert.That(path.BeadOf(0).Area, Is.EqualTo(0.08).Within(1e-12));
    }

    [Test]
    public void On_a_slope_the_volume_is_the_width_times_the_area_below_the_path()
    {
        // The tip rises from 0.2 to 0.6 mm: 4 mm² below it, 0.4 mm wide.
        var path = Apply(Gap, Line(0, 0, 0.2, 10, 0, 0.6)).Single();
        Assert.That(path.SegmentCount, Is.EqualTo(11));
        Assert.That(path.Volume, Is.EqualTo(1.6).Within(1e-9));
        Assert.That(path.BeadOf(0).Area, Is.LessThan(path.BeadOf(10).Area));
        // A steep one, too: the length in plan counts.
        var steep = Apply(Gap with { MaxGap = 20, AirGap = 20 }, Line(0, 0, 0, 10, 0, 10)).Single();
        Assert.That(steep.Volume, Is.EqualTo(20).Within(0.05));
    }

    [Test]
    public void The_gap_to_an_earlier_path_is_measured_to_what_was_deposited()
    {
        var shaped = Apply(Gap, Line(0, 0, 0.2, 20, 0, 0.6), Line(0, 0, 0.8, 20, 0, 0.8), Line(0, 0.1, 1.1, 20, 0.1, 1.1));
        // Above the ramp the gap falls from 0.6 to 0.2, above the second path it is 0.3.
        Assert.That(shaped[1].Volume, Is.EqualTo(20 * 0.4 * 0.4).Within(0.01));
        Assert.That(shaped[1].BeadOf(0).Height, Is.EqualTo(0.59).Within(0.01));
        Assert.That(shaped[2].SegmentCount, Is.EqualTo(1));
        Assert.That(shaped[2].BeadOf(0).Height, Is.EqualTo(0.3).Within(1e-9));
    }

    [Test]
    public void Extrusions_beside_a_path_in_the_same_layer_are_not_under_it()
    {
        var shaped = Apply(Gap, Line(0, 0, 0.2, 20, 0, 0.2), Line(0, 0.15, 0.2, 20, 0.15, 0.2));
        Assert.That(shaped[1].BeadOf(0).Height, Is.EqualTo(0.2).Within(1e-12));
    }

    [Test]
    public void Between_two_extrusions_the_nearer_one_counts()
    {
        var shaped = Apply(Gap, Line(0, 0, 0.2, 20, 0, 0.2), Line(0, 0.5, 0.2, 20, 0.5, 0.2), Line(0, 0.25, 0.5, 20, 0.25, 0.5));
        Assert.That(shaped[2].BeadOf(0).Height, Is.EqualTo(0.3).Within(1e-12));
    }

    [Test]
    public void A_surface_is_underneath_too()
    {
        // A roof along y = 0 that falls to both sides by 1 in 2, from 5 mm.
        var roof = TriMesh.Create([new Vec3(0, -10, 0), new Vec3(20, -10, 0), new Vec3(0, 0, 5), new Vec3(20, 0, 5), new Vec3(0, 10, 0), new Vec3(20, 10, 0)],
            [0, 1, 3, 0, 3, 2, 2, 3, 5, 2, 5, 4]);
        var path = Apply(Gap with { Surface = roof }, Line(10, -9, 0.8, 10, -1, 4.8)).Single();
        Assert.That(path.SegmentCount, Is.EqualTo(1));
        Assert.That(path.Volume, Is.EqualTo(0.4 * 0.3 * 8).Within(1e-9));
    }

    [Test]
    public void Limits_are_kept_and_reported()
    {
        var result = Gap.Apply([Line(0, 0, 0.01, 5, 0, 0.01), Line(0, 5, 2, 5, 5, 2), Line(0, 9, 4, 5, 9, 4)]);
        Assert.That(result.Value!.Select(p => p.BeadOf(0).Height), Is.EqualTo(new[] { 0.05, 1, 0.2 }).Within(1e-12));
        Assert.That(result.Diagnostics.Select(d => (d.Code, d.Severity)), Is.EqualTo(new[]
        {
            ("gap.narrow", Severity.Warning), ("gap.wide", Severity.Note), ("gap.air", Severity.Note),
        }));
        var nothing = Apply(Gap with { Bed = null }, Line(0, 0, 0.3, 5, 0, 0.3)).Single();
        Assert.That(nothing.BeadOf(0), Is.EqualTo(Bead));
        var upright = Apply(Gap, Line(0, 0, 0.1, 0, 0, 0.9)).Single();
        Assert.That(upright.BeadOf(0), Is.EqualTo(Bead));
        Assert.That(GapBead.For(new PrintSettings { LayerHeight = 0.4 }), Has.Property("MinGap").EqualTo(0.1).And.Property("MaxGap").EqualTo(0.8));
    }

    [Test]
    public void A_helix_starts_thin_and_then_lies_on_its_previous_turn()
    {
        // Two turns of radius 10 with a pitch of 0.4 mm.
        var helix = new PrintPath([new Vec3(10, 0, 0), new Vec3(10, 0, 0.4), new Vec3(10, 0, 0.8)], [Bead, Bead], false,
            [new Arc(Vec3.Zero, 360), new Arc(Vec3.Zero, 360)]);
        var path = Apply(Gap, helix).Single();
        Assert.That(path.HasArcs, Is.True);
        var length = 0.0;
        for (var i = 0; i < path.SegmentCount; i++)
        {
            length += path.LengthOf(i);
            var turn = length / helix.LengthOf(0);
            var height = path.BeadOf(i).Height;
            // The ramp of the first turn, at the middle of a piece; then the pitch.
            if (turn > 0.15 && turn < 0.99) Assert.That(height, Is.EqualTo(0.4 * turn).Within(0.01));
            if (turn > 1.02) Assert.That(height, Is.EqualTo(0.4).Within(0.01));
        }
        Assert.That(length, Is.EqualTo(helix.Length).Within(1e-9));
        Assert.That(path.BeadOf(path.SegmentCount - 1).Area, Is.EqualTo(0.16).Within(0.005));
    }

    [Test]
    public void Closed_paths_stay_closed_and_strokes_stay_strokes()
    {
        var square = new PrintPath([new Vec3(0, 0, 0.3), new Vec3(9, 0, 0.3), new Vec3(9, 9, 0.3), new Vec3(0, 9, 0.3)], Bead,
            closed: true) { Name = "square" };
        var path = Apply(Gap, square).Single();
        Assert.That((path.IsClosed, path.SegmentCount, path.Name), Is.EqualTo((true, 4, "square")));
        Assert.That(path.Points, Is.EqualTo(square.Points));
        var stroke = new PrintPath([new Vec3(0, 0, 0.3), new Vec3(9, 0, 0.3)], new Bead(0));
        Assert.That(Apply(Gap, stroke).Single().BeadOf(0).Area, Is.Zero);
    }

    [Test]
    public void A_bead_without_a_height_needs_a_width()
    {
        var path = new PrintPath([new Vec3(0, 0, 0.3), new Vec3(9, 0, 0.3)], new Bead(0.1));
        var result = Gap.Apply([path]);
        Assert.That(result.Value, Is.Null);
        Assert.That(result.Diagnostics.Single().Code, Is.EqualTo("gap.no_width"));
        Assert.That(Apply(Gap with { Width = 0.5 }, path).Single().BeadOf(0).Area, Is.EqualTo(0.15).Within(1e-12));
        Assert.That(() => new GapBead { MinGap = 0 }, Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    private static PrintPath[] Apply(GapBead gap, params PrintPath[] paths) => gap.Apply(paths).Value!.ToArray();

    private static PrintPath Line(double x0, double y0, double z0, double x1, double y1, double z1) => new([new Vec3(x0, y0, z0), new Vec3(x1, y1, z1)], Bead);
}
