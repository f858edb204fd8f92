using System;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Traces;
using NUnit.Framework;

namespace Caterpillar.Tests.Traces;

/// <summary>Numbers of strings, flows and limits of the shapes.</summary>
public class TraceDetailTests
{
    private static readonly Vec3 Middle = new(10, 20, 1);

    [TestCase(0.49, 1)]
    [TestCase(0.74, 1)]
    [TestCase(0.76, 2)]
    [TestCase(1.2, 2)]
    [TestCase(0.01, 1)]
    public void A_filled_cylinder_has_its_height_in_rounded_layers(double height, int layers)
        => Assert.That(new Trace(0.2).Cylinder(Middle, 2, height, 0.5, 1, 12).Strings.Select(s => Math.Round(s.End.Z, 9)).Distinct().Count(),
            Is.EqualTo(layers));

    [Test]
    public void A_skirt_is_rings_from_the_outside_in()
    {
        var strings = new Trace(0.2).Skirt(Middle, 5, loops: 3, pitch: 0.5, strings: 8).Strings;
        Assert.That(strings, Has.Count.EqualTo(24));
        Assert.That(strings.Select(s => Math.Round(s.End.DistanceTo(Middle), 9)), Is.EqualTo(Enumerable.Repeat(6.0, 8).Concat(Enumerable.Repeat(5.5, 8))
            .Concat(Enumerable.Repeat(5.0, 8))));
        Assert.That(new Trace(0.2).Skirt(Middle, 5, strings: 8).Strings, Has.Count.EqualTo(8));
        Assert.That(() => new Trace(0.2).Skirt(Middle, 5, loops: 0), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(new Trace(0.2).Skirt(Middle, 5).ToPaths(), Has.Count.EqualTo(1));
        Assert.That(new Trace(0.2).Skirt(Middle, 5, 2).ToPaths(), Has.Count.EqualTo(2));
    }

    [Test]
    public void A_last_string_as_short_as_rounding_errors_is_dropped()
    {
        Assert.That(new Trace(0.2).Helix(Middle, 5, height: 0.3, pitch: 0.1, stringsPerTurn: 10).Strings, Has.Count.EqualTo(30));
        var rest = new Trace(0.2).Helix(Middle, 5, height: 0.304, pitch: 0.1, stringsPerTurn: 10).Strings;
        Assert.That(rest, Has.Count.EqualTo(31));
        Assert.That(rest[30].End.Z, Is.EqualTo(1.304).Within(1e-12));
        Assert.That(rest[29].End.Z, Is.EqualTo(1.3).Within(1e-12));
    }

    [TestCase(0.2, true, true, 0.25, 9, 0.4)]
    [TestCase(0.2, true, true, 1, 9, 1)]
    [TestCase(0.2, true, true, 9, 0.5, 0.6)]
    [TestCase(0.2, true, true, 0.5, 0.5, 0.36)]
    [TestCase(0.2, false, true, 0.25, 9, 1)]
    [TestCase(0.2, true, false, 9, 0.25, 1)]
    [TestCase(0, true, true, 0, 9, 0)]
    [TestCase(1, true, true, 0, 0, 1)]
    [TestCase(0.2, true, true, -1, 9, 0.2)]
    public void A_ramp_rises_over_the_first_turn_and_falls_over_the_last(double minimum, bool start, bool end, double done, double left, double flow)
        => Assert.That(new FlowRamp(minimum, start, end).At(done, left), Is.EqualTo(flow).Within(1e-12));

    [Test]
    public void A_ramp_takes_its_flow_in_the_middle_of_each_string()
    {
        var strings = new Trace(1).Helix(Middle, 5, height: 4, pitch: 1, stringsPerTurn: 4, ramp: new FlowRamp(0)).Strings;
        Assert.That(strings.Select(s => s.Area),
            Is.EqualTo(new[] { 0.125, 0.375, 0.625, 0.875, 1, 1, 1, 1, 1, 1, 1, 1, 0.875, 0.625, 0.375, 0.125 }).Within(1e-12));
        Assert.That(new FlowRamp().At(0, 9), Is.EqualTo(0.2));
        Assert.That(() => new FlowRamp(-0.1), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => new FlowRamp(1.1), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [Test]
    public void The_radius_of_a_cone_follows_its_height()
    {
        var strings = new Trace(0.2).Cone(Middle, 10, 0, height: 5, pitch: 1, stringsPerTurn: 4).Strings;
        foreach (var s in strings) Assert.That((s.End - Middle).LengthXY, Is.EqualTo(10 - 2 * (s.End.Z - 1)).Within(1e-9));
        Assert.That(strings[0].Start, Is.EqualTo(Middle + new Vec3(10, 0)));
        Assert.That(strings[1].End.DistanceTo(Middle + new Vec3(-9, 0, 0.5)), Is.LessThan(1e-12));
    }

    [Test]
    public void Flat_spirals_start_and_end_at_the_same_angle_both_ways()
    {
        var outward = new Trace(0.2).Spiral(Middle, 2.25, 1, stringsPerTurn: 4).Strings;
        var inward = new Trace(0.2).Spiral(Middle, 2.25, 1, stringsPerTurn: 4, inwards: true).Strings;
        Assert.That(outward, Has.Count.EqualTo(9));
        Assert.That(outward[8].End.DistanceTo(Middle + new Vec3(0, 2.25)), Is.LessThan(1e-12));
        Assert.That(inward[0].Start.DistanceTo(outward[8].End), Is.LessThan(1e-12));
        Assert.That(inward[8].End.DistanceTo(Middle), Is.LessThan(1e-12));
        Assert.That(outward[4].End.DistanceTo(Middle + new Vec3(0, 1.25)), Is.LessThan(1e-12));
        // Both go round counterclockwise: after 1.25 of its turns, the inward one is half a turn beyond X.
        Assert.That(inward[4].End.DistanceTo(Middle + new Vec3(-1, 0)), Is.LessThan(1e-12));
    }

    [Test]
    public void A_circle_begins_where_it_is_told_to()
    {
        var strings = new Trace(0.2).Circle(Middle, 5, strings: 4, from: 90).Strings;
        Assert.That(strings.Select(s => s.Start.DistanceTo(Middle)), Is.All.EqualTo(5).Within(1e-12));
        Assert.That(strings[0].Start.DistanceTo(Middle + new Vec3(0, 5)), Is.LessThan(1e-12));
        Assert.That(strings[1].Start.DistanceTo(Middle + new Vec3(-5, 0)), Is.LessThan(1e-12));
        Assert.That(strings[3].End, Is.EqualTo(strings[0].Start));
        Assert.That(new Trace(0.2).Circle(Middle, 5).Strings, Has.Count.EqualTo(72));
        Assert.That(new Trace(0.2).Circle(Middle, 5, 3).Strings, Has.Count.EqualTo(3));
    }

    [TestCase(double.NaN)]
    [TestCase(double.PositiveInfinity)]
    [TestCase(-1)]
    public void Values_that_are_no_amounts_are_refused_by_every_shape(double bad)
    {
        void Refused(Action<Trace> draw) => Assert.That(() => draw(new Trace(0.2)), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Refused(t => t.SetArea(bad));
        Refused(t => t.SetSpeed(bad));
        Refused(t => t.Circle(Middle, bad));
        Refused(t => t.Spiral(Middle, bad, 1));
        Refused(t => t.Spiral(Middle, 5, bad));
        Refused(t => t.Cone(Middle, bad, 1, 1, 1));
        Refused(t => t.Cone(Middle, 1, bad, 1, 1));
        Refused(t => t.Cone(Middle, 1, 1, bad, 1));
        Refused(t => t.Cone(Middle, 1, 1, 1, bad));
        Refused(t => t.Cylinder(Middle, bad, 1, 1, 1));
        Refused(t => t.Cylinder(Middle, 1, bad, 1, 1));
        Refused(t => t.Cylinder(Middle, 1, 1, bad, 1));
        Refused(t => t.Cylinder(Middle, 1, 1, 1, bad));
        Refused(t => t.Spiral(Middle, 5, 1, stringsPerTurn: 2));
        Refused(t => t.Move(new Vec3(0, double.NaN, 0)));
    }

    [Test]
    public void Area_and_speed_of_strings_go_into_their_paths()
    {
        var trace = new Trace(0.2).SetSpeed(30).Draw(new Vec3(1, 0, 0)).SetArea(0.3).SetSpeed(0).Draw(new Vec3(2, 0, 0)).Draw(new Vec3(2, 0, 0));
        var path = trace.Move(new Vec3(5, 5, 0)).Draw(new Vec3(6, 5, 0)).ToPaths();
        Assert.That(path.Select(p => p.SegmentCount), Is.EqualTo(new[] { 2, 1 }));
        Assert.That((path[0].BeadOf(0).Area, path[0].BeadOf(0).Speed, path[0].BeadOf(1).Area, path[0].BeadOf(1).Speed), Is.EqualTo((0.2, 30.0, 0.3, 0.0)));
        Assert.That(path[0].Points.Concat(path[1].Points).Select(p => p.X), Is.EqualTo(new[] { 0.0, 1, 2, 5, 6 }));
        Assert.That(() => new Trace(0.2) { Cancel = new System.Threading.CancellationToken(true) }.Draw(new Vec3(1, 0, 0)),
            Throws.InstanceOf<OperationCanceledException>());
    }
}
