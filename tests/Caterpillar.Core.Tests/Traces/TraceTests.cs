using System;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using Caterpillar.Traces;
using NUnit.Framework;

namespace Caterpillar.Tests.Traces;

public class TraceTests
{
    [Test]
    public void Moves_add_no_string_and_draws_do()
    {
        var trace = new Trace(0.2, new Vec3(1, 0, 0)).Move(new Vec3(2, 0, 0)).Draw(new Vec3(2, 3, 0)).SetArea(0.3).SetSpeed(20).Draw(new Vec3(2, 3, 4));
        Assert.That(trace.Strings, Is.EqualTo(new[]
        {
            new TraceString(new Vec3(2, 0, 0), new Vec3(2, 3, 0), 0.2, 0),
            new TraceString(new Vec3(2, 3, 0), new Vec3(2, 3, 4), 0.3, 20),
        }));
        var paths = trace.ToPaths();
        Assert.That(paths, Has.Count.EqualTo(1));
        Assert.That(paths[0].BeadOf(0).Area, Is.EqualTo(0.2));
        Assert.That(paths[0].BeadOf(1).Speed, Is.EqualTo(20));
        Assert.That(paths[0].Volume, Is.EqualTo(3 * 0.2 + 4 * 0.3).Within(1e-12));
    }

    [Test]
    public void A_move_starts_another_path()
    {
        var trace = new Trace(0.2).Draw(new Vec3(1, 0, 0)).Move(new Vec3(5, 0, 0)).Draw(new Vec3(6, 0, 0));
        Assert.That(trace.ToPaths().Select(p => (p.Start.X, p.End.X)), Is.EqualTo(new[] { (0.0, 1.0), (5.0, 6.0) }));
    }

    [TestCase(3)]
    [TestCase(7)]
    [TestCase(72)]
    public void A_circle_closes_exactly_and_has_equal_strings(int n)
    {
        var strings = new Trace(0.2).Circle(new Vec3(10, 20, 0.3), 5, n).Strings;
        Assert.That(strings, Has.Count.EqualTo(n));
        Assert.That(strings[n - 1].End, Is.EqualTo(strings[0].Start));
        var chord = 2 * 5 * Math.Sin(Math.PI / n);
        Assert.That(strings.Select(s => s.Length), Is.All.EqualTo(chord).Within(1e-12));
    }

    [Test]
    public void A_helix_climbs_its_pitch_each_turn_and_ends_at_its_height()
    {
        // 3.5 turns of 8 strings: 28 strings, each 2r sin(180/8) wide and 0.4/8 high.
        var strings = new Trace(0.2).Helix(Vec3.Zero, 10, 1.4, 0.4, 8).Strings;
        Assert.That(strings, Has.Count.EqualTo(28));
        Assert.That(strings[27].End.Z, Is.EqualTo(1.4).Within(1e-12));
        Assert.That(strings[27].End.X, Is.EqualTo(-10).Within(1e-12));
        var chord = 20 * Math.Sin(Math.PI / 8);
        Assert.That(strings.Select(s => s.Length), Is.All.EqualTo(Math.Sqrt(chord * chord + 0.05 * 0.05)).Within(1e-12));
    }

    [Test]
    public void A_ramp_starts_and_ends_with_little_flow()
    {
        var strings = new Trace(1).Helix(Vec3.Zero, 10, 4, 1, 10, new FlowRamp(0.2)).Strings;
        // The middle of string i is at turn (i + 0.5)/10.
        Assert.That(strings[0].Area, Is.EqualTo(0.2 + 0.8 * 0.05).Within(1e-12));
        Assert.That(strings[9].Area, Is.EqualTo(0.2 + 0.8 * 0.95).Within(1e-12));
        Assert.That(strings.Skip(10).Take(20).Select(s => s.Area), Is.All.EqualTo(1));
        Assert.That(strings[39].Area, Is.EqualTo(0.2 + 0.8 * 0.05).Within(1e-12));
    }

    [Test]
    public void A_spiral_gains_its_pitch_each_turn_both_ways()
    {
        var outwards = new Trace(1).Spiral(new Vec3(0, 0, 2), 10, 2, 60).Strings;
        Assert.That(outwards, Has.Count.EqualTo(300));
        Assert.That(outwards[59].End.DistanceTo(new Vec3(2, 0, 2)), Is.LessThan(1e-12));
        Assert.That(outwards[299].End.DistanceTo(new Vec3(10, 0, 2)), Is.LessThan(1e-12));
        // Length of an Archimedean spiral r = aθ: a/2 (θ√(1+θ²) + asinh θ).
        double a = 2 / (2 * Math.PI), t = 10 * Math.PI;
        var exact = a / 2 * (t * Math.Sqrt(1 + t * t) + Math.Log(t + Math.Sqrt(1 + t * t)));
        Assert.That(outwards.Sum(s => s.Length), Is.EqualTo(exact).Within(0.1));
        var inwards = new Trace(1).Spiral(new Vec3(0, 0, 2), 9, 2, 60, inwards: true).Strings;
        Assert.That(inwards[0].Start.DistanceTo(new Trace(1).Spiral(new Vec3(0, 0, 2), 9, 2, 60).Position), Is.LessThan(1e-12));
        Assert.That(inwards[inwards.Count - 1].End.DistanceTo(new Vec3(0, 0, 2)), Is.LessThan(1e-12));
    }

    [Test]
    public void A_filled_cylinder_is_one_path_of_stacked_spirals()
    {
        var trace = new Trace(0.2).Cylinder(new Vec3(0, 0, 0.3), 5, 0.9, 0.3, 0.45);
        Assert.That(trace.ToPaths(), Has.Count.EqualTo(1));
        Assert.That(trace.Strings.Select(s => s.End.Z).Distinct().Count(), Is.EqualTo(3));
        Assert.That(trace.Strings.Max(s => s.End.Z), Is.EqualTo(0.9).Within(1e-12));
        // The extrusions cover the disc: length × pitch is the area of three discs, within the curvature of the inner turns.
        Assert.That(trace.Strings.Sum(s => s.Length) * 0.45, Is.EqualTo(3 * Math.PI * 25).Within(3));
    }

    [Test]
    public void A_cone_ends_with_its_upper_radius()
    {
        var trace = new Trace(0.2).Cone(new Vec3(1, 2, 0), 10, 4, 5, 0.5);
        Assert.That((trace.Position - new Vec3(1, 2, 5)).LengthXY, Is.EqualTo(4).Within(1e-12));
        Assert.That(trace.Position.Z, Is.EqualTo(5).Within(1e-12));
    }

    [Test]
    public void Short_strings_are_merged_and_keep_their_mean_area()
    {
        var trace = new Trace(1).Draw(new Vec3(0.1, 0, 0)).SetArea(3).Draw(new Vec3(0.4, 0, 0)).Draw(new Vec3(5, 0, 0));
        var path = trace.ToPaths().Single();
        var merged = PathMerging.JoinShort(path, 0.5);
        Assert.That(merged.Points.Select(p => p.X), Is.EqualTo(new[] { 0, 0.4, 5 }));
        Assert.That(merged.BeadOf(0).Area, Is.EqualTo((0.1 * 1 + 0.3 * 3) / 0.4).Within(1e-12));
        Assert.That(PathMerging.JoinShort(path, 0), Is.SameAs(path));
    }

    [Test]
    public void Merging_a_fine_spiral_thins_its_center_only()
    {
        var fine = new Trace(0.2).Spiral(Vec3.Zero, 20, 0.5, 300).ToPaths().Single();
        var merged = PathMerging.JoinShort(fine, 0.2);
        Assert.That(merged.SegmentCount, Is.LessThan(fine.SegmentCount));
        Assert.That(Enumerable.Range(3, merged.SegmentCount - 3).Select(i => merged.Points[i].DistanceTo(merged.Points[i + 1])), Is.All.GreaterThan(0.1));
        Assert.That(merged.End, Is.EqualTo(fine.End));
    }

    [Test]
    public void Invalid_values_are_rejected()
    {
        Assert.That(() => new Trace(-1), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => new Trace(1).Draw(new Vec3(double.NaN, 0, 0)), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => new Trace(1).Helix(Vec3.Zero, 10, 10, 0), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => new Trace(1).Helix(Vec3.Zero, 10, 1e9, 1e-3), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => new Trace(1).Circle(Vec3.Zero, 1, 2), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => new FlowRamp(2), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [Test]
    public void A_trace_begins_where_it_is_told_to()
        => Assert.That(new Trace(0.2, new Vec3(3, 4, 5)).Draw(new Vec3(3, 4, 9)).Strings.Single().Start, Is.EqualTo(new Vec3(3, 4, 5)));

    [Test]
    public void A_filled_cylinder_goes_out_in_one_layer_and_back_in_the_next()
    {
        var strings = new Trace(0.2).Cylinder(new Vec3(50, 50, 0.3), radius: 4, height: 1.2, verticalPitch: 0.3, horizontalPitch: 1, stringsPerTurn: 12)
            .Strings;
        Assert.That(strings.Select(s => Math.Round(s.End.Z, 9)).Distinct(), Is.EqualTo(new[] { 0.3, 0.6, 0.9, 1.2 }));
        double Radius(Vec3 p) => (p - new Vec3(50, 50, p.Z)).Length;
        Assert.That(Radius(strings[0].Start), Is.Zero.Within(1e-9));
        // Layers of 48 strings, and one up between them: they end at the edge and in the middle by turns.
        Assert.That(strings, Has.Count.EqualTo(4 * 48 + 3));
        Assert.That(new[] { 0, 1, 2, 3 }.Select(i => Math.Round(Radius(strings[49 * i + 47].End), 9)), Is.EqualTo(new[] { 4.0, 0, 4, 0 }));
        Assert.That(strings.Zip(strings.Skip(1), (a, b) => a.End == b.Start), Is.All.True, "One extrusion.");
    }

    [TestCase(0, 5)]
    [TestCase(30, 5)]
    [TestCase(2, 2)]
    [TestCase(0.5, 0.5)]
    public void A_filled_cylinder_goes_up_at_a_speed_of_Z_axes(double speed, double up)
    {
        var strings = new Trace(0.2).SetSpeed(speed).Cylinder(new Vec3(50, 50, 0.3), 4, 0.6, 0.3, 1).Strings;
        Assert.That(strings.Where(s => s.End.Z > s.Start.Z).Select(s => s.Speed), Is.EqualTo(new[] { up }));
        Assert.That(strings.Where(s => s.End.Z == s.Start.Z).Select(s => s.Speed), Is.All.EqualTo(speed));
    }

    [Test]
    public void A_turn_has_three_strings_or_more()
        => Assert.That(new Trace(0.2).Cone(Vec3.Zero, 1, 1, height: 2, pitch: 1, stringsPerTurn: 3).Strings, Has.Count.EqualTo(6));

    [Test]
    public void Sizes_that_make_no_shape_are_refused()
    {
        var trace = new Trace(0.2);
        Assert.That(() => trace.Circle(Vec3.Zero, 0), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => trace.Spiral(Vec3.Zero, 0, 1), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => trace.Cone(Vec3.Zero, -1, 1, 5, 1), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => trace.Cone(Vec3.Zero, 1, -1, 5, 1), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => trace.Cone(Vec3.Zero, 1, 1, 0, 1), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => trace.Cone(Vec3.Zero, 1, 1, 1, 1, stringsPerTurn: 2), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => trace.Cylinder(Vec3.Zero, 5, 5, 0, 1), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => trace.Cylinder(Vec3.Zero, 5, 0, 1, 1), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => trace.Helix(Vec3.Zero, 5, 1e9, 0.001), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(trace.Strings, Is.Empty);
    }
}
