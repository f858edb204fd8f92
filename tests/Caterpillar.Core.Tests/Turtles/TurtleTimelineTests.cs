using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using Caterpillar.Turtles;
using NUnit.Framework;

namespace Caterpillar.Tests.Turtles;

internal sealed class TurtleTimelineTests
{
    private static TurtleTimeline Timeline(Turtle turtle) => new(turtle.ToSteps());

    [Test]
    public void The_pose_looks_along_the_path()
    {
        var timeline = Timeline(new Turtle().StartAt(1, 1).Forward(10).Dwell(5).Left(90).PenUp().Forward(10).PenDown().Extrude(1).LiftWorld(5).Forward(5));
        Assert.That(timeline.Length, Is.EqualTo(30));
        Assert.That(timeline.PoseAt(0).Origin, Is.EqualTo(new Vec3(1, 1)));
        Assert.That(timeline.PoseAt(1 / 6.0).Origin.DistanceTo(new Vec3(6, 1)), Is.LessThan(1e-12));
        Assert.That(timeline.PoseAt(0.5).X.DistanceTo(Vec3.UnitY), Is.LessThan(1e-12));
        var lifted = timeline.PoseAt(22.5 / 30);
        Assert.That(lifted.Origin.DistanceTo(new Vec3(11, 11, 2.5)), Is.LessThan(1e-12));
        Assert.That(lifted.X.DistanceTo(Vec3.UnitZ) + lifted.Y.DistanceTo(-Vec3.UnitX), Is.LessThan(1e-12), "upward it keeps its left side");
        Assert.That(timeline.PoseAt(1).Origin.DistanceTo(new Vec3(11, 16, 5)), Is.LessThan(1e-12));
        Assert.That(timeline.PoseAt(7).Origin, Is.EqualTo(timeline.PoseAt(1).Origin));
    }

    [Test]
    public void What_is_printed_grows_along_the_path()
    {
        var timeline = Timeline(new Turtle().Forward(10).PenUp().Forward(10).PenDown().Forward(10).Left(90).Forward(10));
        double Printed(double part)
        {
            var (last, done) = timeline.At(part);
            return timeline.Moves.Take(last + 1).Where(m => m.Prints).Sum(m => m.Length * (m == timeline.Moves[last] ? done : 1));
        }
        Assert.That(new[] { 0, 0.125, 0.25, 0.5, 0.75, 1 }.Select(Printed), Is.EqualTo(new double[] { 0, 5, 10, 10, 20, 30 }).Within(1e-12));
    }

    [Test]
    public void No_steps_are_a_path_without_length()
    {
        Assert.That(new TurtleTimeline([]).PoseAt(0.5), Is.EqualTo(Frame.World));
        Assert.That(new TurtleTimeline([]).At(0.3), Is.EqualTo((-1, 1.0)));
        var still = new TurtleTimeline([new EventStep(new ExtrudeEvent(2))]);
        Assert.That(still.PoseAt(0.3).Origin, Is.EqualTo(Vec3.Zero));
        Assert.That(still.At(0.3).Done, Is.EqualTo(1), "what takes no way is done");
        Assert.That(still.Moves.Count(m => m.Prints), Is.Zero);
    }
}
