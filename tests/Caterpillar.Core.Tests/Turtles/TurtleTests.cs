using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Flavors;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using Caterpillar.Turtles;
using NUnit.Framework;

namespace Caterpillar.Tests.Turtles;

internal sealed class TurtleTests
{
    private const double FilamentArea = Math.PI / 4 * 1.75 * 1.75;

    private static PrintPath OnlyPath(Turtle t) => t.ToSteps().OfType<PathStep>().Single().Path;

    private static void Near(Vec3 actual, Vec3 expected) => Assert.That(actual.DistanceTo(expected), Is.LessThan(1e-12), $"{actual} is not {expected}");

    [Test]
    public void Positive_yaw_turns_left_positive_pitch_raises_the_nose_positive_roll_lifts_the_left_side()
    {
        Near(new Turtle().Left(90).Pose.X, Vec3.UnitY);
        Near(new Turtle().PitchUp(90).Pose.X, Vec3.UnitZ);
        Near(new Turtle().RollRight(90).Pose.Y, Vec3.UnitZ);
        Near(new Turtle().Right(30).Pose.X, new Turtle().Left(-30).Pose.X);
        Near(new Turtle().PitchDown(30).Pose.X, new Turtle().PitchUp(-30).Pose.X);
        Near(new Turtle().RollLeft(30).Pose.Y, new Turtle().RollRight(-30).Pose.Y);
        Near(new Turtle().Left(20).TurnAround().Pose.X, -new Turtle().Left(20).Pose.X);
    }

    [Test]
    public void Moves_go_to_their_targets()
    {
        Near(new Turtle().PitchUp(90).Forward(3).Position, new Vec3(0, 0, 3));
        Near(new Turtle().Left(90).Backward(3).Position, new Vec3(0, -3));
        Near(new Turtle().PitchUp(90).Lift(2).Position, new Vec3(-2, 0));
        Near(new Turtle().PitchUp(90).LiftWorld(2).Position, new Vec3(0, 0, 2));
        Near(new Turtle().PitchUp(90).ForwardLift(3, 2).Position, new Vec3(-2, 0, 3));
        Near(new Turtle().Left(90).PitchUp(50).Forward(3, 2).Position, new Vec3(0, 3, 2));
        Near(new Turtle().StartAt(1, 2, 3).GoTo(null, 0, null).Position, new Vec3(1, 0, 3));
        Near(new Turtle().Jump(1, 2, 3).SetHeading(90).Forward(1).Position, new Vec3(1, 3, 3));
        Near(new Turtle().Move(5).Position, new Vec3(5, 0));
    }

    [Test]
    public void Yaw_pitch_and_roll_are_read_back_also_straight_up_and_down_and_in_radians()
    {
        var random = new Random(3);
        for (var i = 0; i < 500; i++)
        {
            var pitch = i % 5 == 0 ? 90 : i % 5 == 1 ? -90 : random.NextDouble() * 180 - 90;
            var (yaw, roll) = (random.NextDouble() * 360 - 180, random.NextDouble() * 360 - 180);
            var t = new Turtle().SetHeading(yaw, pitch, roll);
            var again = new Turtle().SetHeading(t.Yaw, t.Pitch, t.Roll);
            Assert.That(again.Pose.X.DistanceTo(t.Pose.X) + again.Pose.Y.DistanceTo(t.Pose.Y), Is.LessThan(1e-7));
            if (Math.Abs(pitch) == 90) Assert.That(t.Roll, Is.Zero);
            else Assert.That((t.Yaw, t.Pitch, t.Roll),
                Is.EqualTo((yaw, pitch, roll))
                .Using<(double A, double B, double C)>((p, q) => Math.Abs(p.A - q.A) + Math.Abs(p.B - q.B) + Math.Abs(p.C - q.C) < 1e-5));
        }
        var straightUp = new Turtle().SetHeading(30, 90);
        Assert.That((straightUp.Yaw, straightUp.Pitch, straightUp.Roll),
            Is.EqualTo((30.0, 90.0, 0.0)).Using<(double A, double B, double C)>((p, q) => Math.Abs(p.A - q.A) + Math.Abs(p.B - q.B)
            + Math.Abs(p.C - q.C) < 1e-12));
        var radians = new Turtle { AngleUnit = AngleUnit.Radians };
        radians.SetHeading(0.5, -0.25, 0.125);
        Assert.That(radians.Yaw, Is.EqualTo(0.5).Within(1e-14));
        Assert.That(radians.Pitch, Is.EqualTo(-0.25).Within(1e-14));
        Assert.That(radians.Roll, Is.EqualTo(0.125).Within(1e-14));
        Near(new Turtle { AngleUnit = AngleUnit.Radians }.Left(Math.PI / 2).Pose.X, Vec3.UnitY);
    }

    [Test]
    public void Change_heading_adds_to_the_angles_and_face_looks_at_a_point()
    {
        var t = new Turtle().SetHeading(10, 20, 30).ChangeHeading(5, -5, 2);
        Assert.That(t.Yaw, Is.EqualTo(15).Within(1e-12));
        Assert.That(t.Pitch, Is.EqualTo(15).Within(1e-12));
        Assert.That(t.Roll, Is.EqualTo(32).Within(1e-12));
        Near(new Turtle().StartAt(1, 1, 1).Face(new Vec3(4, 5, 1)).Pose.X, new Vec3(0.6, 0.8));
        var up = new Turtle().Left(40).Face(new Vec3(0, 0, 7));
        Near(up.Pose.X, Vec3.UnitZ);
        Assert.That(up.Yaw, Is.EqualTo(40).Within(1e-12));
        Near(new Turtle().SetHeading(10, 20, 30).Level().Pose.Y, new Turtle().SetHeading(10).Pose.Y);
        Assert.That(() => new Turtle().Face(Vec3.Zero), Throws.ArgumentException);
        Near(new Turtle().GoTo(0, 2, faceTravel: true).Pose.X, Vec3.UnitY);
    }

    [Test]
    public void A_million_turns_keep_the_axes_orthonormal()
    {
        var t = new Turtle();
        for (var i = 0; i < 333_334; i++) t.Left(7.1).PitchUp(3.3).RollRight(-5.7);
        var pose = t.Pose;
        Assert.That(Math.Abs(pose.X.Length - 1) + Math.Abs(pose.Y.Length - 1) + Math.Abs(pose.Z.Length - 1), Is.LessThan(1e-12));
        Assert.That(Math.Abs(Vec3.Dot(pose.X, pose.Y)) + Math.Abs(Vec3.Dot(pose.Y, pose.Z)) + Math.Abs(Vec3.Dot(pose.Z, pose.X)), Is.LessThan(1e-12));
    }

    [Test]
    public void Circles_arcs_and_polygons_close_exactly()
    {
        var random = new Random(9);
        for (var i = 0; i < 100; i++)
        {
            var t = new Turtle().StartAt(random.NextDouble() * 100, random.NextDouble() * 100, 3)
                .SetHeading(random.NextDouble() * 360, random.NextDouble() * 90, random.NextDouble() * 90);
            var pose = t.Pose;
            Assert.That(t.Circle(random.NextDouble() * 20, i).Pose, Is.EqualTo(pose));
            Assert.That(t.Arc(5, -360, 0, 7).Pose, Is.EqualTo(pose));
            Assert.That(t.Arc(5, 1080).Pose, Is.EqualTo(pose));
            Assert.That(t.Polygon(3 + i, 4.2).Pose, Is.EqualTo(pose));
            Assert.That(t.Polygon(3 + i, -4.2).Pose, Is.EqualTo(pose));
            Assert.That(t.CircleAround(3).Pose, Is.EqualTo(pose));
        }
    }

    [Test]
    public void Arcs_keep_to_their_circle()
    {
        var t = new Turtle().Arc(10, 90, 0, 30);
        Near(t.Position, new Vec3(10, 10));
        Near(t.Pose.X, Vec3.UnitY);
        Assert.That(OnlyPath(t).SegmentCount, Is.EqualTo(30));
        Assert.That(OnlyPath(t).Points.Select(p => p.DistanceTo(new Vec3(0, 10))), Is.All.EqualTo(10).Within(1e-12));
        var right = new Turtle().Arc(10, -90, 4, 8);
        Near(right.Position, new Vec3(10, -10, 4));
        Near(right.Pose.X, -Vec3.UnitY);
        // Sagitta of the chords at the default tolerance.
        var points = OnlyPath(new Turtle().Circle(20)).Points;
        Assert.That(20 - ((points[0] + points[1]) / 2).DistanceTo(new Vec3(0, 20)), Is.LessThan(0.01).And.GreaterThan(0.005));
        Near(new Turtle().Polygon(4, 3).ToSteps().OfType<PathStep>().Single().Path.Points[2], new Vec3(3, 3));
    }

    [Test]
    public void Moves_with_the_same_tags_are_one_path_with_a_bead_each()
    {
        var t = new Turtle().Forward(10).SetDensity(0.1).Left(90).Forward(5).SetRate(600).Backward(5);
        var path = OnlyPath(t);
        Assert.That(path.SegmentCount, Is.EqualTo(3));
        Assert.That(path.BeadOf(0).Area, Is.EqualTo(0.05 * FilamentArea).Within(1e-15));
        Assert.That(path.BeadOf(1).Area, Is.EqualTo(0.1 * FilamentArea).Within(1e-15));
        Assert.That(path.BeadOf(1).Speed, Is.EqualTo(1000 / 60.0));
        Assert.That(path.BeadOf(2).Speed, Is.EqualTo(10));
        Assert.That(TurtleHistory.Of(t.ToSteps()).Sum(m => m.Filament), Is.EqualTo(0.5 + 0.5 + 0.5).Within(1e-12), "backward moves extrude too");
        t.Layer(1, 0.2).Forward(1).Color(255, 0, 128).Forward(1).Tool(1).Forward(1).Name("rim").Forward(1).As(Role.Skirt).Forward(1);
        var paths = t.ToSteps().OfType<PathStep>().Select(s => s.Path).ToArray();
        Assert.That(paths.Select(p => p.Layer?.Index), Is.EqualTo(new int?[] { null, 1, 1, 1, 1, 1 }));
        Assert.That(paths.Select(p => p.Color), Is.EqualTo(new int?[] { null, null, 0xFF0080, 0xFF0080, 0xFF0080, 0xFF0080 }));
        Assert.That(paths.Select(p => p.Tool), Is.EqualTo(new[] { 0, 0, 0, 1, 1, 1 }));
        Assert.That(paths.Last().Name + paths.Last().Role, Is.EqualTo("rimSkirt"));
        Assert.That(paths.Zip(paths.Skip(1), (a, b) => a.End == b.Start), Is.All.True);
    }

    [Test]
    public void Pen_and_lifts_carry_no_hidden_extrusion()
    {
        var t = new Turtle().Forward(10).PenUp().PenUp().Forward(5).PenDown().PenDown().Lift(1).Forward(2).ForwardLift(0, 3);
        var steps = t.ToSteps();
        Assert.That(steps.OfType<EventStep>(), Is.Empty);
        Assert.That(steps.Select(s => s.GetType().Name), Is.EqualTo(new[] { "PathStep", "TravelStep", "PathStep" }));
        Assert.That(((TravelStep)steps[1]).Points, Is.EqualTo(new[] { new Vec3(15, 0), new Vec3(15, 0, 1) }));
        Assert.That(TurtleHistory.Of(steps).Sum(m => m.Filament), Is.EqualTo((10 + 2 + 3) * 0.05).Within(1e-12));
    }

    [Test]
    public void Pop_returns_by_a_travel_that_states_its_intent()
    {
        var t = new Turtle().Forward(1).Push().SetRate(120).SetDensity(0.2).Left(90).Forward(5).PenUp().Pop();
        Assert.That(t.Position, Is.EqualTo(new Vec3(1, 0)));
        Assert.That(t.Pose.X, Is.EqualTo(Vec3.UnitX));
        Assert.That(t.IsPenDown && Math.Abs(t.Rate - 1000) < 1e-9 && Math.Abs(t.Density - 0.05) < 1e-15, Is.True);
        var back = t.ToSteps().OfType<TravelStep>().Single();
        Assert.That(back.Intent, Is.EqualTo(TravelIntent.Return));
        Assert.That(back.Points, Is.EqualTo(new[] { new Vec3(1, 0) }));
        Assert.That(() => t.Pop(), Throws.InvalidOperationException);
        Assert.That(new Turtle().Push().Pop().ToSteps(), Is.Empty);
    }

    [Test]
    public void Events_keep_their_position()
    {
        var t = new Turtle().NozzleTemperature(210).BedTemperature(0, wait: false).StartAt(5, 5).Extrude(2).Fan(0.5).Dwell(250).Forward(1).Pause("turn")
            .Comment("c").Raw("M400").Mix(0.25).Acceleration(500);
        Assert.That(t.ToSteps().Select(s => s is EventStep e ? e.Event.ToString() : s.GetType().Name), Is.EqualTo(new[]
        {
            new NozzleTemperatureEvent(210, true).ToString(), new BedTemperatureEvent(0).ToString(), "TravelStep",
                new ExtrudeEvent(2 * FilamentArea, 1000 / 60.0).ToString(),
            new FanEvent(0.5).ToString(), new DwellEvent(0.25).ToString(), "PathStep", new PauseEvent("turn").ToString(), new CommentEvent("c").ToString(),
                new RawEvent("M400").ToString(),
            new RawEvent("M163 S0 P0.25").ToString(), new RawEvent("M163 S1 P0.75").ToString(), new RawEvent("M164 S0").ToString(),
                new AccelerationEvent(500).ToString(),
        }));
        Assert.That(t.ToSteps().OfType<TravelStep>().Single().Points.Single(), Is.EqualTo(new Vec3(5, 5)), "an extrusion in place needs a position");
    }

    [Test]
    public void The_triangle_points_forward()
    {
        var triangle = Turtle.TriangleOf(new Turtle().StartAt(1, 1, 1).Left(90).Pose);
        Near(triangle[0], new Vec3(-1, 1, 1));
        Near(triangle[1], new Vec3(3, 1, 1));
        Near(triangle[2], new Vec3(1, 6, 1));
    }

    [Test]
    public void Reading_the_steps_does_not_end_the_path()
    {
        var t = new Turtle().Forward(1);
        Assert.That(t.ToSteps(), Has.Count.EqualTo(1));
        t.Left(90).Forward(1);
        Assert.That(OnlyPath(t).SegmentCount, Is.EqualTo(2));
        var poses = new Turtle(new TurtleOptions { KeepPoses = true }).Forward(1).Left(90).Poses;
        Assert.That(poses, Has.Count.EqualTo(3));
        Near(poses[2].X, Vec3.UnitY);
    }

    [Test]
    public void Senseless_values_are_rejected()
    {
        IEnumerable<TestDelegate> bad =
        [
            () => new Turtle().Forward(double.NaN), ()
                => new Turtle().Forward(double.PositiveInfinity), () => new Turtle().Left(double.NaN), () => new Turtle().SetRate(0),
            () => new Turtle().SetDensity(-1), ()
                => new Turtle().SetArea(double.NaN), () => new Turtle().Fan(2), () => new Turtle().Dwell(-1), () => new Turtle().Extrude(double.NaN),
            () => new Turtle().Polygon(2, 1), ()
                => new Turtle().Arc(-1, 90), () => new Turtle().Color(0x1000000), () => new Turtle().Tool(-1), () => new Turtle().NozzleTemperature(-5),
            () => new Turtle().Layer(-1), () => new Turtle().Mix(1.5), () => new Turtle().StartAt(double.NaN, 0),
        ];
        foreach (var act in bad) Assert.That(act, Throws.InstanceOf<ArgumentException>());
        Assert.That(() => new Turtle().Forward(1).StartAt(0, 0), Throws.InvalidOperationException);
        Assert.That(() => new Turtle(new TurtleOptions { Start = Frame.At(new Vec3(double.NaN, 0)) }), Throws.ArgumentException);
    }
}
