using System;
using System.Linq;
using System.Threading;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Simulation;

/// <summary>The planner and the timeline where something begins or ends: long runs, waits, moves in place, first steps, shared layers.</summary>
public class TimelineBoundaryTests
{
    private static readonly Printer Rigid = new()
    {
        Cornering = Cornering.Jerk, Jerk = new(0, 0, 0, 0), PrintAcceleration = 1000, TravelAcceleration = 1000, RetractionAcceleration = 1000,
        MaxAcceleration = new(1e6, 1e6, 1e6, 1e6), MaxSpeed = new(500, 500, 500, 500), LookaheadMoves = 0, NozzleHeating = 2, BedHeating = 0,
    };

    // From rest to 894 mm/s and back at 1000 mm/s²: 2 √(L / a). Queues that hold less than what is needed for braking are not among them.
    [TestCase(Cornering.Jerk, 0)]
    [TestCase(Cornering.Jerk, 5000)]
    [TestCase(Cornering.JunctionDeviation, 0)]
    [TestCase(Cornering.JunctionDeviation, 5000)]
    [TestCase(Cornering.SquareCornerVelocity, 0)]
    public void A_long_line_in_many_pieces_takes_as_long_as_in_one(Cornering rule, int queue)
    {
        const int Pieces = 8000;
        var printer = Rigid with
        {
            Cornering = rule, LookaheadMoves = queue, Jerk = new(0.001, 0.001, 0.001, 0.001), MaxSpeed = new(5000, 5000, 5000, 5000),
            MaxAcceleration = new(1000, 1000, 1000, 1000), MinimumCruiseRatio = 0, SquareCornerVelocity = 0.001,
        };
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var i = 1; i <= Pieces; i++) builder.Add(new Vec3(0.1 * i, 0), 0, 0, 4000, MoveKind.Travel, Role.Unspecified, -1, 0, i);
        var timeline = Timeline.Of(builder.Build([new ToolpathTool(1)]), new PrintSetup { Printer = printer });
        Assert.That(timeline.Duration, Is.EqualTo(2 * Math.Sqrt(800.0 / 1000)).Within(1e-4));
        Assert.That(timeline.AtFraction(0.5).Speed, Is.EqualTo(Math.Sqrt(800_000)).Within(0.1));
        var all = timeline.Trapezoids().ToArray();
        for (var i = 1; i < all.Length; i++) Assert.That(all[i].Start, Is.EqualTo(all[i - 1].End).Within(1e-6), $"{i}");
    }

    [Test]
    public void A_wait_has_no_speed_no_flow_and_no_direction()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(new Vec3(100, 0), 5, 5, 100, MoveKind.Print, Role.Infill, -1, 0, 0);
        builder.AddEvent(new DwellEvent(4));
        builder.Add(new Vec3(100, 100), 5, 5, 100, MoveKind.Print, Role.Infill, -1, 0, 1);
        var timeline = Timeline.Of(builder.Build([new ToolpathTool(1)]), new PrintSetup { Printer = Rigid });
        var wait = timeline.Trapezoids().ElementAt(1);
        Assert.That(wait with { Duration = 0 }, Is.EqualTo(default(Trapezoid)));
        Assert.That(wait.Duration, Is.EqualTo(4).Within(1e-9));
        var waiting = timeline.At(1.1 + 2);
        Assert.That((waiting.Waits, waiting.Kind, waiting.Speed, waiting.Flow, waiting.Direction),
            Is.EqualTo((true, MoveKind.Dwell, 0.0, (double?)0.0, Vec3.Zero)));
        var moving = timeline.At(1.1 + 4 + 0.55);
        Assert.That((moving.Waits, moving.Kind, moving.Direction), Is.EqualTo((false, MoveKind.Print, Vec3.UnitY)));
        Assert.That(moving.Flow, Is.EqualTo(5).Within(1e-9));
    }

    [Test]
    public void A_retraction_has_a_speed_and_no_direction()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(10, 10, 1));
        builder.Add(new Vec3(10, 10, 1), -4, 0, 40, MoveKind.Retract, Role.Unspecified, -1, 0, 0);
        var state = Timeline.Of(builder.Build([new ToolpathTool(1)]), new PrintSetup { Printer = Rigid }).AtFraction(0.5);
        Assert.That((state.Direction, state.Position, state.Flow), Is.EqualTo((Vec3.Zero, new Vec3(10, 10, 1), (double?)0.0)));
        Assert.That(state.Speed, Is.Positive);
    }

    // Without a rate a heater is there at once.
    [Test]
    public void Heat_is_wanted_from_the_moment_in_which_it_is_set()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(new Vec3(100, 0), 0, 0, 100, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.AddEvent(new BedTemperatureEvent(60));
        builder.Add(new Vec3(100, 100), 0, 0, 100, MoveKind.Travel, Role.Unspecified, -1, 0, 1);
        builder.AddEvent(new BedTemperatureEvent(0));
        builder.Add(new Vec3(0, 100), 0, 0, 100, MoveKind.Travel, Role.Unspecified, -1, 0, 2);
        var timeline = Timeline.Of(builder.Build([new ToolpathTool(1)]), new PrintSetup { Printer = Rigid });
        Assert.That(new[] { 0, 1, 2 }.Select(i => timeline.AtMove(i)).Select(s => (s.BedTarget, s.BedTemperature)),
            Is.EqualTo(new[] { (0.0, 20.0), (60, 60), (0, 20) }));
        Assert.That(timeline.At(timeline.StartOf(1) - 1e-6).BedTarget, Is.Zero);
    }

    [Test]
    public void Steps_count_from_0()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(new Vec3(100, 0), 0, 0, 100, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        var one = Timeline.Of(builder.Build([new ToolpathTool(1)]), new PrintSetup { Printer = Rigid });
        Assert.That((one.AtSource(0)?.Move, one.AtSource(1)?.Move), Is.EqualTo(((int?)0, (int?)null)));
        Assert.That(() => one.EndOf(1), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => one.EndOf(-1), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That((one.EndOf(0), one.StartOf(1)), Is.EqualTo((one.Duration, one.Duration)));
    }

    // Many blocks, and places in the path between and exactly at the ends of moves; every third is in place.
    [Test]
    public void A_length_of_a_long_path_is_found_in_the_right_move()
    {
        const int Moves = 150_000;
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var i = 0; i < Moves; i++)
        {
            // Lengths without rounding.
            var step = i % 3 == 0 ? Vec3.Zero : new Vec3(i % 6 < 3 ? 0.5 : -0.5, 0);
            builder.Add(builder.Position + step, i % 3 == 0 ? 1 : 0, i % 3 == 0 ? 1 : 0, 100, i % 3 == 0 ? MoveKind.Prime
                : MoveKind.Travel, Role.Unspecified, -1, 0, i);
        }
        var timeline = Timeline.Of(builder.Build([new ToolpathTool(1)]), new PrintSetup { Printer = Rigid });
        Assert.That(timeline.Length, Is.EqualTo(50_000));
        foreach (var k in Enumerable.Range(0, 400).Select(i => i * 251 % 100_000).Concat([0, 1, 99_998, 99_999]))
        {
            // Half of the k-th move that moves.
            var state = timeline.AtLength((0.5 * k + 0.25) / 50_000);
            Assert.That(state.Move, Is.EqualTo(k / 2 * 3 + 1 + k % 2), $"{k}");
            Assert.That((state.Length, state.Filament), Is.EqualTo((0.5 * k + 0.25, k / 2 + 1.0)).Within(1e-6), $"{k}");
        }
        Assert.That(timeline.AtLength(1).Move, Is.EqualTo(Moves));
        Assert.That(timeline.AtLength(0).Time, Is.LessThan(timeline.AtLength(1e-6).Time));
    }

    [Test]
    public void Objects_of_a_layer_share_its_time()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        foreach (var (index, name) in new[] { (0, "a"), (0, "b"), (0, "c"), (1, "a"), (2, "a"), (2, "b") })
        {
            var layer = builder.AddLayer(new Layer(index, 0.2 * (index + 1), 0.2, name));
            builder.Add(builder.Position + new Vec3(100, 0), 1, 1, 100, MoveKind.Print, Role.Infill, layer, 0, 0);
        }
        var s = PrintStatistics.Of(Timeline.Of(builder.Build([new ToolpathTool(1)]),
            new PrintSetup { Printer = Rigid with { Jerk = new(500, 500, 500, 500) } }));
        Assert.That(s.Layers.Select(l => (l.Layer, l.Length, l.Volume)), Is.EqualTo(new[] { (0, 300.0, (double?)3.0), (3, 100, 1), (4, 200, 2) }));
    }

    // One homing before the first move, whose travel takes no time; the same travel later does.
    [Test]
    public void Only_the_travel_of_a_homing_takes_no_time()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(100, 0));
        builder.AddEvent(new HomeEvent(true, true, true));
        builder.Add(Vec3.Zero, 0, 0, 100, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.Add(new Vec3(100, 0), 0, 0, 100, MoveKind.Travel, Role.Unspecified, -1, 0, 1);
        builder.AddEvent(new FanEvent(1));
        builder.Add(Vec3.Zero, 0, 0, 100, MoveKind.Travel, Role.Unspecified, -1, 0, 2);
        var timeline = Timeline.Of(builder.Build([new ToolpathTool(1)]), new PrintSetup { Printer = Rigid with { HomingTime = 5 } });
        Assert.That(timeline.EndOf(0), Is.EqualTo(5).Within(1e-9));
        Assert.That((timeline.EndOf(1) - 5, timeline.Duration - timeline.EndOf(1)), Is.EqualTo((1.1, 1.1)).Within(1e-9));
    }

    [Test]
    public void Nothing_deposited_has_no_greatest_flow()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(new Vec3(100, 0), 0, 0, 100, MoveKind.Print, Role.Infill, -1, 0, 0);
        builder.Add(new Vec3(100, 0), 5, 5, 100, MoveKind.Print, Role.Infill, -1, 0, 1);
        var timeline = Timeline.Of(builder.Build([new ToolpathTool(1)]), new PrintSetup { Printer = Rigid });
        var s = PrintStatistics.Of(timeline);
        Assert.That((s.GreatestFlow, s.GreatestFlowMove, s.PrintLength), Is.EqualTo(((double?)null, -1, 100.0)));
        Assert.That(new PrintStatistics().GreatestFlowMove, Is.EqualTo(-1));
        using var cancel = new CancellationTokenSource();
        cancel.Cancel();
        Assert.That(() => PrintStatistics.Of(timeline, cancel.Token), Throws.InstanceOf<OperationCanceledException>());
    }
}
