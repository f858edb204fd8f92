using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Simulation;

/// <summary>Places in time that are easily missed by one: ends, waits, sources out of order, arcs.</summary>
public class TimelineDetailTests
{
    private static readonly PrintSetup Setup = new()
    {
        Printer = new Printer
        {
            Cornering = Cornering.Jerk, Jerk = new(0, 0, 0, 0), PrintAcceleration = 1000, TravelAcceleration = 1000, LookaheadMoves = 0,
            MaxAcceleration = new(1e6, 1e6, 1e6, 1e6), MaxSpeed = new(500, 500, 500, 500), NozzleHeating = 2, BedHeating = 1, ArcSegment = 1,
        },
    };

    [Test]
    public void Waits_before_each_move_and_after_the_last_are_told()
    {
        var timeline = Of(b =>
        {
            b.AddEvent(new DwellEvent(2), 0);
            Go(b, 10, 0, 0);
            b.AddEvent(new DwellEvent(3), 1);
            b.AddEvent(new DwellEvent(4), 2);
            Go(b, 20, 0, 1);
            Go(b, 30, 0, 2);
            b.AddEvent(new DwellEvent(5), 3);
        });
        Assert.That(Enumerable.Range(0, 4).Select(timeline.WaitBefore), Is.EqualTo(new[] { 2.0, 7, 0, 5 }).Within(1e-9));
        Assert.That(timeline.Waits.Dwells, Is.EqualTo(14));
        Assert.That(timeline.EndOf(2), Is.EqualTo(timeline.StartOf(3)));
        Assert.That(timeline.Duration, Is.EqualTo(timeline.StartOf(3) + 5).Within(1e-9));
        Assert.That(() => timeline.EndOf(3), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => timeline.StartOf(4), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [TestCase(0, 0)]
    [TestCase(3, 1)]
    [TestCase(4, 1)]
    [TestCase(5, 3)]
    [TestCase(6, -1)]
    public void Sources_out_of_order_are_found_from_the_first_on(int source, int move)
    {
        var timeline = Of(b =>
        {
            Go(b, 10, 0, 2);
            Go(b, 20, 0, 4);
            Go(b, 30, 0, 1);
            Go(b, 40, 0, 5);
        });
        Assert.That(timeline.AtSource(source)?.Move ?? -1, Is.EqualTo(move));
    }

    [TestCase(2, 0)]
    [TestCase(3, 2)]
    [TestCase(4, 2)]
    [TestCase(5, -1)]
    public void Moves_without_a_source_go_with_the_next_that_has_one(int source, int move)
    {
        var timeline = Of(b =>
        {
            Go(b, 10, 0, 2);
            Go(b, 20, 0, 2);
            Go(b, 30, 0, -1);
            Go(b, 40, 0, 4);
        });
        Assert.That(timeline.AtSource(source)?.Move ?? -1, Is.EqualTo(move));
    }

    [Test]
    public void Along_an_arc_the_head_goes_along_its_tangent()
    {
        // A quarter circle to the left around (0, 10).
        var timeline = Of(b => b.Add(new Vec3(10, 10), 0, 0, 20, MoveKind.Travel, Role.Unspecified, -1, 0, 0, new Arc(new Vec3(0, 10), 90)));
        foreach (var (time, degrees) in new[] { (0.0, 0.0), (timeline.Duration / 2, 45), (timeline.Duration, 90) })
        {
            var state = timeline.At(time);
            var (sin, cos) = Caterpillar.Basics.Angle.SinCos(degrees);
            if (time < timeline.Duration) Assert.That(state.Direction.DistanceTo(new Vec3(cos, sin)), Is.LessThan(1e-3), $"{degrees}°");
            Assert.That(state.Position.DistanceTo(new Vec3(10 * sin, 10 - 10 * cos)), Is.LessThan(1e-9), $"{degrees}°");
        }
    }

    [Test]
    public void By_length_and_sums_each_move_of_many_is_found()
    {
        // More than two stretches of kept sums and more than a block of moves of one length each.
        const int Count = 70_000;
        var timeline = Of(b =>
        {
            for (var i = 1; i <= Count; i++) b.Add(new Vec3(i % 2, i / 2, 0), 0.5, 0.5, 50, MoveKind.Print, Role.Infill, -1, 0, i);
        });
        Assert.That(timeline.Length, Is.EqualTo(Enumerable.Range(0, Count).Sum(i => timeline.Toolpath[i].Length)).Within(1e-6));
        var before = 0.0;
        for (var i = 0; i < Count; i++)
        {
            var length = timeline.Toolpath[i].Length;
            if (i % 127 < 3 || i % 65_536 < 2)
            {
                var state = timeline.AtLength((before + length / 2) / timeline.Length);
                Assert.That((state.Move, Math.Round(state.Done, 6)), Is.EqualTo((i, 0.5)));
                Assert.That(timeline.AtMove(i).Filament, Is.EqualTo(0.5 * i).Within(1e-6));
                Assert.That(timeline.AtMove(i).Volume, Is.EqualTo(i).Within(1e-6));
            }
            before += length;
        }
        Assert.That(timeline.AtLength(0).Move, Is.Zero);
        Assert.That(timeline.AtLength(2).Done, Is.EqualTo(timeline.At(timeline.Duration).Done));
    }

    [Test]
    public void The_fan_and_the_heaters_are_those_that_were_set_last()
    {
        var timeline = Of(b =>
        {
            Go(b, 10, 0, 0);
            b.AddEvent(new FanEvent(0.25), 1);
            b.AddEvent(new BedTemperatureEvent(30, true), 1);
            Go(b, 20, 0, 1);
            b.AddEvent(new FanEvent(1), 2);
            b.AddEvent(new BedTemperatureEvent(0), 2);
            b.AddEvent(new DwellEvent(4), 2);
            Go(b, 30, 0, 2);
        });
        Assert.That(Enumerable.Range(0, 3).Select(m => timeline.AtMove(m).Fan), Is.EqualTo(new[] { 0, 0.25, 1 }));
        Assert.That(timeline.Waits.Heating, Is.EqualTo(10));
        Assert.That(timeline.At(timeline.StartOf(1) + 5).BedTemperature, Is.EqualTo(25).Within(1e-9));
        Assert.That(timeline.At(timeline.StartOf(1) + 5).BedTarget, Is.EqualTo(30));
        Assert.That(timeline.At(timeline.StartOf(2) + 4).BedTemperature, Is.EqualTo(26).Within(1e-9));
        Assert.That(timeline.At(timeline.StartOf(2) + 4).BedTarget, Is.Zero);
    }

    [Test]
    public void Statistics_name_the_extrusion_of_the_greatest_flow_and_the_waits()
    {
        var timeline = Of(b =>
        {
            b.Add(new Vec3(100, 0), 10, 10, 20, MoveKind.Print, Role.OuterWall, -1, 0, 0);
            b.Add(new Vec3(0, 0), 10, 10, 40, MoveKind.Print, Role.Infill, -1, 0, 1);
            b.Add(new Vec3(100, 0), 10, 10, 30, MoveKind.Print, Role.Infill, -1, 0, 2);
            b.Add(new Vec3(100, 0), -2, 0, 30, MoveKind.Retract, Role.Unspecified, -1, 0, 3);
            Go(b, 100, 50, 4);
        });
        var s = PrintStatistics.Of(timeline);
        Assert.That((s.GreatestFlowMove, s.Retractions, s.Moves), Is.EqualTo((1, 1, 5)));
        Assert.That(s.GreatestFlow, Is.EqualTo(10 * 2 / 100.0 * 40).Within(1e-9));
        Assert.That((s.PrintLength, s.TravelLength, s.Filament), Is.EqualTo((300.0, 50.0, 30.0)));
        Assert.That(s.Volume, Is.EqualTo(60).Within(1e-9));
        Assert.That(s.PrintTime + s.TravelTime + s.ExtruderTime + s.Waits.Total, Is.EqualTo(s.Duration).Within(1e-9));
        Assert.That(s.Roles.Select(r => (r.Role, r.Length)), Is.EqualTo(new[] { (Role.OuterWall, 100.0), (Role.Infill, 200.0) }));
        Assert.That(s.PrintBounds, Is.EqualTo(new Bounds(Vec3.Zero, new Vec3(100, 0))));
    }

    [Test]
    public void Null_arguments_are_a_misuse()
    {
        var empty = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero).Build([new ToolpathTool(1)]);
        var none = new Dictionary<string, string>();
        Assert.That(() => Timeline.Of(null!, Setup), Throws.ArgumentNullException);
        Assert.That(() => Timeline.Of(empty, null!), Throws.ArgumentNullException);
        Assert.That(() => PrintStatistics.Of(null!), Throws.ArgumentNullException);
        Assert.That(() => SlicerLimits.Of(null!, new Printer()), Throws.ArgumentNullException);
        Assert.That(() => SlicerLimits.Of(none, null!), Throws.ArgumentNullException);
        Assert.That(SlicerLimits.Of(none, new Printer()), Is.Null);
    }

    private static void Go(ToolpathBuilder builder, double x, double y, int source)
        => builder.Add(new Vec3(x, y), 0, 0, 50, MoveKind.Travel, Role.Unspecified, -1, 0, source);

    private static Timeline Of(Action<ToolpathBuilder> moves)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        moves(builder);
        return Timeline.Of(builder.Build([new ToolpathTool(2)]), Setup);
    }
}
