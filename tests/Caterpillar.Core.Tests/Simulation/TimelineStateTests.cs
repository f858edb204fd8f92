using System;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Simulation;

/// <summary>States at moves that take no time, beside waits, and what long toolpaths and arcs add to them.</summary>
public class TimelineStateTests
{
    [Test]
    public void The_wait_before_a_move_does_not_belong_to_the_one_before_it()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        Travel(builder, 10);
        Travel(builder, 10);
        builder.AddEvent(new DwellEvent(3));
        Travel(builder, 20);
        var timeline = Timeline.Of(builder.Build([new ToolpathTool(1)]), new PrintSetup());
        Assert.That(Enumerable.Range(0, 4).Select(timeline.WaitBefore), Is.EqualTo(new[] { 0.0, 0, 3, 0 }).Within(1e-12));
        Assert.That(Enumerable.Range(0, 4).Select(i => timeline.AtMove(i).Waits), Is.EqualTo(new[] { false, false, true, false }));
        Assert.That(timeline.AtMove(1).Kind, Is.EqualTo(MoveKind.Travel));
    }

    [Test]
    public void A_wait_after_the_last_move_is_one()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        Travel(builder, 10);
        builder.AddEvent(new DwellEvent(3));
        var timeline = Timeline.Of(builder.Build([new ToolpathTool(1)]), new PrintSetup());
        var state = timeline.AtMove(1);
        Assert.That((state.Waits, state.Kind, state.Flow, state.TimeLeft), Is.EqualTo((true, MoveKind.Dwell, (double?)0, 3.0)));
        Assert.That(timeline.At(timeline.Duration).Waits, Is.False);
    }

    // Half a billionth of a millimeter takes no time.
    [Test]
    public void A_length_may_be_in_a_move_that_takes_no_time()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        Travel(builder, 8);
        Travel(builder, 8 + 5e-10);
        builder.AddEvent(new DwellEvent(3));
        Travel(builder, 16);
        var timeline = Timeline.Of(builder.Build([new ToolpathTool(1)]), new PrintSetup());
        var state = timeline.AtLength(8 / timeline.Length);
        Assert.That((state.Move, state.Time, state.Waits), Is.EqualTo((1, timeline.StartOf(1), false)));
    }

    [Test]
    public void After_all_moves_there_is_no_direction()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        Travel(builder, 10);
        var timeline = Timeline.Of(builder.Build([new ToolpathTool(1)]), new PrintSetup());
        Assert.That((timeline.AtMove(0).Direction, timeline.AtMove(1).Direction), Is.EqualTo((Vec3.UnitX, Vec3.Zero)));
    }

    [TestCase(2.0, 3.0)]
    [TestCase(null, null)]
    public void The_volume_of_what_is_printed_is_known_where_that_of_all_tools_is(double? other, double? volume)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(new Vec3(10, 0), 1, 1, 50, MoveKind.Print, Role.Infill, -1, 0, -1);
        builder.Add(new Vec3(20, 0), 1, 1, 50, MoveKind.Print, Role.Infill, -1, 1, -1);
        var timeline = Timeline.Of(builder.Build([new ToolpathTool(1), new ToolpathTool(other)]), new PrintSetup());
        Assert.That(timeline.AtMove(2).Volume, Is.EqualTo(volume));
    }

    [Test]
    public void Of_extrusions_at_the_same_height_the_first_is_found()
    {
        var index = new PathIndex(Extrusions(9, i => 1 + i / 3));
        Assert.That(new[] { 1.0, 1.5, 2, 2.5, 3 }.Select(index.FirstAbove), Is.EqualTo(new[] { 0, 3, 3, 6, 6 }));
    }

    // Blocks hold 65,536 moves: the second begins far below the top of the first.
    [Test]
    public void Heights_are_searched_in_all_blocks()
    {
        const int Block = ToolpathBlock.Capacity;
        var index = new PathIndex(Extrusions(Block + 200, i => i < Block ? Math.Min(i, 100) : i - Block));
        Assert.That(new[] { 0.0, 50, 100, 100.5, 150, 199, 200 }.Select(index.FirstAbove),
            Is.EqualTo(new[] { 0, 50, 100, Block + 101, Block + 150, Block + 199, Block + 200 }));
    }

    [Test]
    public void Arcs_are_in_the_bounds_of_a_print_as_they_bulge()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(new Vec3(20, 0, 0), 1, 1, 50, MoveKind.Print, Role.Infill, -1, 0, -1, new Arc(new Vec3(10, 0, 0), 180));
        var print = PrintStatistics.Of(Timeline.Of(builder.Build([new ToolpathTool(1)]), new PrintSetup()));
        Assert.That((print.PrintBounds.Min.Y, print.PrintBounds.Max.Y), Is.EqualTo((-10.0, 0.0)));
        Assert.That(print.PrintLength, Is.EqualTo(10 * Math.PI).Within(1e-12));
    }

    [Test]
    public void A_limit_of_zero_stops_the_machine_for_a_long_time_but_not_for_ever()
    {
        var limits = new MachineLimits(new Printer());
        limits.Apply(new AccelerationEvent(0));
        limits.Apply(new LimitEvent(MotionLimit.SpeedX, -5));
        Assert.That((limits[MotionLimit.PrintAcceleration], limits[MotionLimit.TravelAcceleration], limits.HeadAcceleration, limits[MotionLimit.SpeedX]),
            Is.EqualTo((1e-6, 1e-6, 1e-6, 1e-6)));
    }

    [Test]
    public void Where_only_times_are_kept_no_speeds_are_however_long_the_print()
    {
        var columns = new MotionColumns(1, timesOnly: true);
        for (var i = 1; i <= 1000; i++)
        {
            columns.Add(new Trapezoid(0, 10, 0, 100, 0.5));
            Assert.That(columns.TotalTime, Is.EqualTo(0.5 * i));
        }
        Assert.That(columns.HasSpeeds, Is.False);
    }

    [TestCase(3, 4)]
    [TestCase(4, 5)]
    [TestCase(10, 11)]
    [TestCase(5000, 5001)]
    public void There_is_room_for_the_start_of_each_move_and_the_end(int moves, int room)
    {
        var columns = new MotionColumns(3);
        Assert.That(columns.First, Has.Length.EqualTo(4));
        columns.Begin(moves, 7);
        Assert.That(columns.First.Length, Is.GreaterThanOrEqualTo(room));
        Assert.That(columns.First[moves], Is.EqualTo(7));
    }

    [Test]
    public void Planning_tells_its_progress_by_blocks()
    {
        var progress = new Checks.Shares();
        Timeline.Of(Extrusions(2 * ToolpathBlock.Capacity + 10, _ => 1), new PrintSetup(), progress);
        Assert.That(progress.All, Is.EqualTo(new[] { 1 / 3.0, 2 / 3.0, 1 }));
    }

    // Of the same tool again there is no change, and heat is for the tool in use.
    [Test]
    public void A_tool_stays_until_another_is_chosen()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.AddEvent(new ToolEvent(1));
        builder.AddEvent(new ToolEvent(1));
        builder.AddEvent(new NozzleTemperatureEvent(200, false));
        builder.Add(new Vec3(100, 0), 1, 1, 50, MoveKind.Print, Role.Infill, -1, 1, -1);
        builder.AddEvent(new ToolEvent(0));
        builder.Add(new Vec3(0, 0), 1, 1, 50, MoveKind.Print, Role.Infill, -1, 0, -1);
        var setup = new PrintSetup { Printer = new Printer { ToolChangeTime = 7 } };
        var timeline = Timeline.Of(builder.Build([new ToolpathTool(1), new ToolpathTool(1)]), setup);
        Assert.That(timeline.Waits.ToolChanges, Is.EqualTo(14));
        Assert.That((timeline.At(timeline.EndOf(0) - 0.01).NozzleTarget, timeline.At(timeline.EndOf(1) - 0.01).NozzleTarget), Is.EqualTo((200.0, 0.0)));
    }

    [Test]
    public void Waits_add_up() => Assert.That(new WaitTimes(1, 2, 4, 8).Total, Is.EqualTo(15));

    [Test]
    public void A_tool_that_only_travels_leaves_the_volume_known()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(new Vec3(10, 0), 1, 1, 50, MoveKind.Print, Role.Infill, -1, 0, -1);
        builder.Add(new Vec3(20, 0), 0, 0, 50, MoveKind.Travel, Role.Unspecified, -1, 1, -1);
        var print = PrintStatistics.Of(Timeline.Of(builder.Build([new ToolpathTool(2), new ToolpathTool(null)]), new PrintSetup()));
        Assert.That((print.Volume, print.Tools.Count), Is.EqualTo(((double?)2, 2)));
    }

    // By Klipper the head's limit is not that of the extruder alone.
    [Test]
    public void The_extruder_alone_may_be_quicker_than_the_head()
    {
        var printer = new Printer
        {
            Cornering = Cornering.SquareCornerVelocity, MaxAcceleration = new(500, 500, 100, 3000), RetractionAcceleration = 2500,
            MaxSpeed = new(500, 500, 500, 500),
        };
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(Vec3.Zero, 1, 1, 100, MoveKind.Prime, Role.Unspecified, -1, 0, -1);
        builder.Add(new Vec3(10, 0), 0, 0, 100, MoveKind.Travel, Role.Unspecified, -1, 0, -1);
        var timeline = Timeline.Of(builder.Build([new ToolpathTool(1)]), new PrintSetup { Printer = printer });
        Assert.That(timeline.Trapezoids().Select(t => t.Acceleration), Is.EqualTo(new[] { 2500.0, 500 }));
    }

    private static void Travel(ToolpathBuilder builder, double x)
        => builder.Add(new Vec3(x, 0), 0, 0, 50, MoveKind.Travel, Role.Unspecified, -1, 0, -1);

    private static Toolpath Extrusions(int count, Func<int, double> height)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var i = 0; i < count; i++) builder.Add(new Vec3(i % 2, 0, height(i)), 1, 1, 50, MoveKind.Print, Role.Infill, -1, 0, -1);
        return builder.Build([new ToolpathTool(1)]);
    }
}
