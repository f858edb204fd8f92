using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Shaping;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Shaping;

public class DeformationTests
{
    [Test]
    public void A_straight_wall_bends_into_an_arc_within_the_tolerance()
    {
        // x becomes the angle: 90 mm along X at y = 20 become a quarter of a circle of radius 20.
        var line = new PrintPath([new Vec3(0, 20, 1), new Vec3(90, 20, 1)], new Bead(0.2));
        var bend = Deformation.Cartesian(p => new Vec3(p.Y * Angle.Cos(p.X), p.Y * Angle.Sin(p.X), p.Z));
        var bent = bend.Apply([line], 0.01).Value!.Single();
        Assert.That(bent.Points.Select(p => p.LengthXY), Is.All.EqualTo(20).Within(1e-12));
        // The chords keep within 0.01 mm: sagitta r(1 - cos(a/2)).
        var worst = Enumerable.Range(0, bent.SegmentCount).Max(i => 20 - ((bent.Points[i] + bent.EndOf(i)) * 0.5).LengthXY);
        Assert.That(worst, Is.LessThan(0.0101).And.GreaterThan(0.001));
        Assert.That(bend.Apply([line]).Value!.Single().SegmentCount, Is.EqualTo(1));
    }

    [Test]
    public void Area_and_speed_are_taken_at_the_middle_before_the_mapping()
    {
        var path = new PrintPath([Vec3.Zero, new Vec3(10, 0, 0), new Vec3(10, 20, 0)], new Bead(1, 0, 10));
        var deformed = Deformation.Cartesian(p => p * 2, (c, p) => c + p.X, (v, p) => v + p.Y).Apply([path]).Value!.Single();
        Assert.That(deformed.BeadOf(0).Area, Is.EqualTo(6));
        Assert.That(deformed.BeadOf(1).Area, Is.EqualTo(11));
        Assert.That(deformed.BeadOf(0).Speed, Is.EqualTo(10));
        Assert.That(deformed.BeadOf(1).Speed, Is.EqualTo(20));
        Assert.That(deformed.End, Is.EqualTo(new Vec3(20, 40, 0)));
    }

    [Test]
    public void Composition_is_one_after_the_other()
    {
        var path = new PrintPath([new Vec3(1, 2, 3), new Vec3(4, -5, 6)], new Bead(1));
        var twist = Deformation.Cylindrical(p => new Vec3(p.X, p.Y + 30 * p.Z, p.Z));
        var shift = Deformation.Cartesian(p => p + new Vec3(7, 0, 0));
        var both = twist.Then(shift).Apply([path]).Value!.Single();
        var apart = shift.Apply(twist.Apply([path]).Value!).Value!.Single();
        Assert.That(both.Points, Is.EqualTo(apart.Points));
        Assert.That(both.Points, Is.Not.EqualTo(shift.Then(twist).Apply([path]).Value!.Single().Points));
    }

    [Test]
    public void The_identity_changes_nothing_but_rounding()
    {
        var random = new Random(5);
        var path = new PrintPath(Enumerable.Range(0, 50)
            .Select(_ => new Vec3(random.NextDouble() * 40 - 20, random.NextDouble() * 40 - 20, random.NextDouble())), new Bead(1));
        var same = Deformation.Cylindrical(p => p, axis: new Vec3(3, 4)).Apply([path], 0.01).Value!.Single();
        Assert.That(same.Length, Is.EqualTo(path.Length).Within(1e-9));
        Assert.That(same.Volume, Is.EqualTo(path.Volume).Within(1e-9));
    }

    [Test]
    public void Angles_continue_through_full_turns()
    {
        // Two turns of a circle unrolled by angle: x = angle must run from 0 to 720 without a jump.
        var points = Enumerable.Range(0, 73).Select(i => new Vec3(10 * Angle.Cos(10 * i), 10 * Angle.Sin(10 * i), 0));
        var unrolled = Deformation.Cylindrical(p => new Vec3(5, 0, p.Y)).Apply([new PrintPath(points, new Bead(1))]).Value!.Single();
        Assert.That(unrolled.Points.Select(p => p.Z), Is.EqualTo(Enumerable.Range(0, 73).Select(i => 10.0 * i)).Within(1e-9));
    }

    [Test]
    public void A_closed_path_stays_closed()
    {
        var square = new PrintPath([new Vec3(1, 1), new Vec3(-1, 1), new Vec3(-1, -1), new Vec3(1, -1)], new Bead(1), closed: true);
        var grown = Deformation.Cylindrical(p => new Vec3(p.X * 3, p.Y, p.Z)).Apply([square], 0.05).Value!.Single();
        Assert.That(grown.IsClosed, Is.True);
        Assert.That(grown.Length, Is.EqualTo(24).Within(0.2));
    }

    [Test]
    public void Arcs_become_chords()
    {
        var path = new PrintPath([new Vec3(10, 0), new Vec3(-10, 0)], [new Bead(1)], arcs: [new Arc(Vec3.Zero, 180)]);
        var same = Deformation.Cartesian().Apply([path]).Value!.Single();
        Assert.That(same.HasArcs, Is.False);
        Assert.That(same.Length, Is.EqualTo(Math.PI * 10).Within(0.02));
    }

    [Test]
    public void Maps_that_fail_give_an_error_and_no_paths()
    {
        var path = new PrintPath([new Vec3(1, 1), new Vec3(2, 2)], new Bead(1));
        var nan = Deformation.Cartesian(p => new Vec3(p.X, double.NaN, 0)).Apply([path], 0.1);
        Assert.That(nan.Value, Is.Null);
        Assert.That(nan.Diagnostics.Single().Code, Is.EqualTo("shape.position"));
        var negative = Deformation.Cartesian(area: (c, _) => -c).Apply([path]);
        Assert.That(negative.Diagnostics.Single().Code, Is.EqualTo("shape.value"));
        Assert.That(() => Deformation.Cartesian().Apply([path], -1), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [Test]
    public void A_path_through_the_axis_keeps_the_angle_that_it_has_beside_it()
    {
        // Radius unchanged, a quarter turn on: begins on the axis, leaves along +Y, comes back and goes through.
        var seen = new System.Collections.Generic.List<Vec3>();
        var quarter = Deformation.Cylindrical(p =>
        {
            seen.Add(p);
            return p with { Y = p.Y + 90 };
        });
        Vec3[] points = [Vec3.Zero, new(0, 4, 0), Vec3.Zero, new(0, 2, 1)];
        var mapped = quarter.Map(points);
        Assert.That(seen.Select(p => p.Y), Is.All.EqualTo(90).Within(1e-12));
        Assert.That(mapped[1].DistanceTo(new Vec3(-4, 0, 0)), Is.LessThan(1e-12));
        seen.Clear();
        quarter.Map([Vec3.Zero, new Vec3(0, 0, 5)]);
        Assert.That(seen.Select(p => p.Y), Is.All.EqualTo(0), "A path on the axis has the angle 0.");
    }
}
