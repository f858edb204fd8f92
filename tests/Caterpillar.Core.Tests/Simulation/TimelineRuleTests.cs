using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Simulation;

/// <summary>Rules of the timeline and its statistics at small numbers: one move, one millimeter, half a second.</summary>
public class TimelineRuleTests
{
    private static readonly Printer Rigid = new()
    {
        Cornering = Cornering.Jerk, Jerk = new(0, 0, 0, 0), PrintAcceleration = 1000, TravelAcceleration = 1000, RetractionAcceleration = 1000,
        MaxAcceleration = new(1e6, 1e6, 1e6, 1e6), MaxSpeed = new(500, 500, 500, 500), LookaheadMoves = 0, NozzleHeating = 2, BedHeating = 1, ArcSegment = 1,
    };

    private static readonly Printer Klipper = Rigid with
    {
        Cornering = Cornering.SquareCornerVelocity, SquareCornerVelocity = 5, MinimumCruiseRatio = 0, InstantaneousCornerVelocity = 1,
        MaxAcceleration = new(3000, 3000, 100, 3000),
    };

    [Test]
    public void Without_moves_the_head_stands_where_it_begins()
    {
        var state = Timeline.Of(new ToolpathBuilder(MoveSource.Steps, new Vec3(1, 2, 3)).Build([new ToolpathTool(1)]), Setup(Rigid)).At(0);
        Assert.That((state.Position, state.Layer, state.Source, state.Move), Is.EqualTo((new Vec3(1, 2, 3), -1, -1, 0)));
        Assert.That((state.NozzleTarget, state.BedTarget, state.Fan), Is.EqualTo((0.0, 0.0, 0.0)));
        var nowhere = Timeline.Of(new ToolpathBuilder(MoveSource.Steps, null).Build([new ToolpathTool(1)]), Setup(Rigid)).At(0);
        Assert.That(nowhere.Position, Is.EqualTo(Vec3.Zero));
    }

    [Test]
    public void After_the_last_move_the_head_stands_at_its_end()
    {
        var timeline = Of(b => b.Go(10, 0, 0).Go(10, 20, 0));
        var state = timeline.AtMove(2);
        Assert.That((state.Move, state.Position, state.Speed, state.Source), Is.EqualTo((2, new Vec3(10, 20), 0.0, 1)));
        Assert.That(timeline.AtLength(1.5), Is.EqualTo(timeline.At(timeline.Duration)));
        Assert.That(timeline.AtLength(-1).Position, Is.EqualTo(Vec3.Zero));
        Assert.That(timeline.AtLength(0.5).Position, Is.EqualTo(new Vec3(10, 5)).Using<Vec3>((a, b) => a.DistanceTo(b) < 1e-9));
    }

    // Sources of three moves; −1 has none. The move that a source begins with, or −1.
    [TestCase(new[] { 1, -1, -1 }, 1, 0)]
    [TestCase(new[] { 1, -1, -1 }, 2, -1)]
    [TestCase(new[] { -1, -1, 3 }, 2, 0)]
    [TestCase(new[] { 1, -1, 3 }, 2, 1)]
    [TestCase(new[] { 1, -1, 3 }, 3, 1)]
    [TestCase(new[] { 1, -1, 3 }, 4, -1)]
    [TestCase(new[] { 1, 3, 5 }, 3, 1)]
    [TestCase(new[] { 5, 3, 1 }, 4, 0)]
    [TestCase(new[] { 2, 1, 3 }, 3, 2)]
    [TestCase(new[] { 2, 1, 3 }, 4, -1)]
    public void A_move_without_a_source_goes_with_the_next_that_has_one(int[] sources, int source, int move)
    {
        var builder = new ToolpathBuilder(MoveSource.Lines, Vec3.Zero);
        for (var i = 0; i < sources.Length; i++) builder.Add(new Vec3(10 * (i + 1), 0), 0, 0, 20, MoveKind.Travel, Role.Unspecified, -1, 0, sources[i]);
        var state = Timeline.Of(builder.Build([new ToolpathTool(1)]), Setup(Rigid)).AtSource(source);
        Assert.That(state?.Move ?? -1, Is.EqualTo(move));
    }

    [Test]
    public void Flow_is_that_of_the_extrusion_however_short_it_is()
    {
        // 0.25 mm of filament of 2 mm² over half a millimeter, and a move without displacement.
        var timeline = Of(b => b.Print(0.5, 0, 0, 0.25, 20).Prime(0, 10));
        var middle = timeline.At(timeline.Duration / 2);
        Assert.That(middle.Speed, Is.GreaterThan(10));
        Assert.That(middle.Flow, Is.EqualTo(middle.Speed).Within(1e-9));
        Assert.That(timeline.AtMove(1).Flow, Is.Zero);
    }

    // Only the extruder alone, with or without Z, and what pulls back is as slow as the extruder.
    [TestCase(100, 0, 0, 1, false)]
    [TestCase(0, 100, 0, 1, false)]
    [TestCase(100, 0, 0, -1, true)]
    [TestCase(0, 0, 100, 1, true)]
    [TestCase(0, 0, 100, 0, false)]
    [TestCase(0, 0, 0, 1, true)]
    public void By_Klipper_the_extruder_limits_moves_of_its_own(double x, double y, double z, double e, bool limited)
    {
        double Time(double most)
        {
            var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
            builder.Add(new Vec3(x, y, z), e, Math.Max(e, 0), 50, e > 0 ? MoveKind.Print : MoveKind.Travel, Role.Unspecified, -1, 0, 0);
            return Timeline.Of(builder.Build([new ToolpathTool(2)]), Setup(Klipper with { MaxSpeed = new(500, 500, 500, most) })).Duration;
        }

        Assert.That(Time(0.01), limited ? Is.GreaterThan(90) : Is.EqualTo(Time(500)));
    }

    [TestCase(Cornering.JunctionDeviation, MotionLimit.JunctionDeviation)]
    [TestCase(Cornering.SquareCornerVelocity, MotionLimit.SquareCornerVelocity)]
    public void Straight_lines_are_not_stopped_at_where_every_corner_is(Cornering rule, Enum named)
    {
        var limit = (MotionLimit)named;
        var printer = Rigid with { Cornering = rule, MinimumCruiseRatio = 0 };
        double Time(params double[] ends)
        {
            var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
            builder.AddEvent(new LimitEvent(limit, 0));
            foreach (var x in ends) builder.Add(new Vec3(x, 0), 0, 0, 50, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
            return Timeline.Of(builder.Build([new ToolpathTool(2)]), Setup(printer)).Duration;
        }

        Assert.That(Time(40, 100), Is.EqualTo(Time(100)).Within(1e-9));
    }

    [TestCase(1e-9, true)]
    [TestCase(1.1e-9, false)]
    public void A_move_of_a_billionth_of_a_millimeter_is_one_of_the_extruder(double length, bool inPlace)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(new Vec3(length, 0), 1, 0, 10, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        var s = PrintStatistics.Of(Timeline.Of(builder.Build([new ToolpathTool(2)]), Setup(Rigid)));
        Assert.That((s.ExtruderTime > 0, s.TravelTime > 0, s.GreatestSpeed > 0), Is.EqualTo((inPlace, !inPlace, !inPlace)));
        Assert.That(s.Duration > 0.1, Is.EqualTo(inPlace), "E is filament to turn where it is in place");
    }

    [Test]
    public void The_first_move_may_have_the_greatest_flow_and_cheap_material_has_a_cost()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(new Vec3(100, 0), 10, 10, 50, MoveKind.Print, Role.Infill, -1, 0, 0);
        builder.Add(new Vec3(0, 0), 5, 5, 50, MoveKind.Print, Role.Infill, -1, 0, 1);
        var setup = Setup(Rigid) with { Material = new Material { CostPerKg = 0.5, Density = 2 } };
        var s = PrintStatistics.Of(Timeline.Of(builder.Build([new ToolpathTool(2)]), setup));
        Assert.That((s.GreatestFlowMove, s.GreatestFlow), Is.EqualTo((0, 10.0)));
        // 30 mm³ of 2 g/cm³.
        Assert.That((s.Mass, s.Cost), Is.EqualTo((0.06, 0.06 / 1000 * 0.5)));
    }

    [Test]
    public void Material_in_place_flows_at_the_speed_of_the_filament()
    {
        // 1 mm of filament of 2 mm² at 10 mm/s.
        var timeline = Of(b => b.Prime(1, 10));
        Assert.That(timeline.At(timeline.Duration / 2).Flow, Is.EqualTo(20).Within(1e-9));
    }

    [Test]
    public void The_frame_of_the_nozzle_has_its_X_along_the_motion_in_plan()
    {
        var timeline = Of(b => b.Go(30, 40, 20).Go(30, 40, 60));
        var frame = timeline.At(timeline.EndOf(0) / 2).Frame;
        Assert.That((frame.X - new Vec3(0.6, 0.8)).Length + (frame.Y - new Vec3(-0.8, 0.6)).Length, Is.LessThan(1e-9));
        Assert.That(timeline.At((timeline.EndOf(0) + timeline.EndOf(1)) / 2).Frame.X, Is.EqualTo(Vec3.UnitX), "straight up");
    }

    // Arcs in pieces of 1 mm, one at least.
    [TestCase(0.5, 1)]
    [TestCase(1.5, 1)]
    [TestCase(2.5, 2)]
    public void An_arc_has_whole_pieces(double length, int pieces)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        var arc = new Arc(new Vec3(0, 10), length / 10 * 180 / Math.PI);
        builder.Add(new Vec3(10 * Math.Sin(length / 10), 10 - 10 * Math.Cos(length / 10)), 0, 0, 20, MoveKind.Travel, Role.Unspecified, -1, 0, 0, arc);
        Assert.That(Timeline.Of(builder.Build([new ToolpathTool(1)]), Setup(Rigid)).Trapezoids().Count(), Is.EqualTo(pieces));
    }

    [TestCase(0.5)]
    [TestCase(1)]
    [TestCase(2)]
    public void Dwells_of_any_length_wait(double seconds)
    {
        var timeline = Of(b => b.Event(new DwellEvent(seconds)).Go(10, 0, 0));
        Assert.That((timeline.WaitBefore(0), timeline.Waits.Dwells), Is.EqualTo((seconds, seconds)));
        Assert.That(timeline.At(seconds / 2).Waits, Is.True);
    }

    // Jumps of 8 mm/s along X at rest, with any number of moves ahead, in one run of many.
    [TestCase(0)]
    [TestCase(2)]
    [TestCase(4)]
    public void The_first_move_begins_at_the_jerk_of_its_axis(int queue)
    {
        var printer = Rigid with { Jerk = new(8, 8, 8, 8), LookaheadMoves = queue };
        var timeline = Of(b =>
        {
            for (var i = 1; i <= 30; i++) b.Go(5 * i, 0, 0);
        }, printer);
        var all = timeline.Trapezoids().ToArray();
        Assert.That((all[0].Start, all[all.Length - 1].End), Is.EqualTo((8.0, 8.0)).Within(1e-9));
    }

    [TestCase(0.5)]
    [TestCase(1)]
    [TestCase(1.5)]
    public void Accelerations_of_any_size_have_their_times(double acceleration)
    {
        var t = Trapezoid.Over(100, 0, 4, 1, acceleration);
        Assert.That((t.Accelerating, t.Decelerating), Is.EqualTo((2 / acceleration, 1 / acceleration)).Within(1e-12));
        Assert.That(t.TimeAt(t.DistanceAt(1)), Is.EqualTo(1).Within(1e-9));
        Assert.That(t.DistanceAt(1), Is.EqualTo(acceleration / 2).Within(1e-12));
        Assert.That((t.SpeedAt(-1), t.SpeedAt(0), t.SpeedAt(t.Duration), t.SpeedAt(t.Duration + 1)), Is.EqualTo((0.0, 0.0, 1.0, 1.0)).Within(1e-9));
    }

    // Klipper: the extruder alone has the lower of two limits.
    [TestCase(500, 2000)]
    [TestCase(2000, 500)]
    public void The_extruder_alone_has_the_lower_of_its_accelerations(double axis, double retraction)
    {
        var printer = Klipper with { MaxAcceleration = new(3000, 3000, 100, axis), RetractionAcceleration = retraction };
        Assert.That(Of(b => b.Prime(1, 100), printer).Trapezoids().Single().Acceleration, Is.EqualTo(500));
    }

    // The extruder begins to turn by 1 mm, or by 0.5, for each of the path: it may jump by 1 mm/s.
    [TestCase(1, 1)]
    [TestCase(0.5, 2)]
    [TestCase(0, 100)]
    public void Straight_on_the_jump_of_the_extruder_limits_the_corner(double share, double speed)
    {
        var timeline = Of(b => b.Go(50, 0, 0, 100).Print(100, 0, 0, 50 * share, 100), Klipper);
        Assert.That(timeline.Trapezoids().First().End, Is.EqualTo(speed).Within(1e-9));
    }

    [Test]
    public void Volumes_of_E_are_told_as_filament_and_prices_are_of_kilograms()
    {
        // 10 mm³ of filament of 1.75 mm; 2 g/cm³ and half a unit for a kilogram.
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(new Vec3(10, 0), 10, 10, 20, MoveKind.Print, Role.Infill, -1, 0, 0);
        var setup = Setup(Rigid) with { Material = new Material { Density = 2, CostPerKg = 0.5 } };
        var s = PrintStatistics.Of(Timeline.Of(builder.Build([new ToolpathTool(1)]), setup));
        Assert.That(s.Filament, Is.EqualTo(10 / (Math.PI * 0.875 * 0.875)).Within(1e-9));
        Assert.That(s.Tools.Single().Filament, Is.EqualTo(s.Filament));
        Assert.That((s.Volume, s.Mass, s.Cost), Is.EqualTo(((double?)10, (double?)0.02, (double?)0.00001)).Within(1e-12));
        var free = setup with { Material = setup.Material with { CostPerKg = 0 } };
        Assert.That(PrintStatistics.Of(Timeline.Of(builder.Build([new ToolpathTool(1)]), free)).Cost, Is.Null);
    }

    [Test]
    public void Layers_of_objects_that_are_printed_together_are_one_in_the_statistics()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        foreach (var (number, name) in new[] { (0, "a"), (0, "b"), (1, "a"), (1, "b") })
            builder.Add(builder.Position + new Vec3(10, 0), 1, 1, 20, MoveKind.Print, Role.Infill, builder.AddLayer(new Layer(number, 0.2, 0.2, name)), 0, 0);
        var s = PrintStatistics.Of(Timeline.Of(builder.Build([new ToolpathTool(1)]), Setup(Rigid)));
        Assert.That(s.Layers.Select(l => (l.Layer, l.Length, l.Volume)), Is.EqualTo(new[] { (0, 20.0, (double?)2), (2, 20.0, 2) }));
    }

    [Test]
    public void Limits_of_a_slicer_wait_for_no_heat()
    {
        var settings = new Dictionary<string, string>
        {
            ["machine_max_acceleration_extruding"] = "1500", ["machine_max_acceleration_travel"] = "0", ["machine_max_acceleration_retracting"] = "0",
        };
        foreach (var axis in "xyze")
        foreach (var what in new[] { "feedrate", "acceleration", "jerk" })
            settings[$"machine_max_{what}_{axis}"] = "200,100";
        var printer = SlicerLimits.Of(settings, Rigid)!;
        Assert.That((printer.NozzleHeating, printer.BedHeating, printer.LookaheadMoves), Is.EqualTo((0.0, 0.0, 64)));
        Assert.That((printer.PrintAcceleration, printer.TravelAcceleration, printer.RetractionAcceleration), Is.EqualTo((1500.0, 1500.0, 1500.0)));
        Assert.That((printer.MaxSpeed.X, SlicerLimits.Of(settings, Rigid, silent: true)!.MaxSpeed.X), Is.EqualTo((200.0, 100.0)));
        settings.Remove("machine_max_jerk_e");
        Assert.That(SlicerLimits.Of(settings, Rigid), Is.Null);
    }

    private static PrintSetup Setup(Printer printer) => new() { Printer = printer };

    private static Timeline Of(Action<Moves> moves, Printer? printer = null)
    {
        var all = new Moves();
        moves(all);
        return Timeline.Of(all.Builder.Build([new ToolpathTool(2)]), Setup(printer ?? Rigid));
    }

    private sealed class Moves
    {
        public ToolpathBuilder Builder { get; } = new(MoveSource.Steps, Vec3.Zero);

        public Moves Go(double x, double y, double z, double speed = 50)
        {
            Builder.Add(new Vec3(x, y, z), 0, 0, speed, MoveKind.Travel, Role.Unspecified, -1, 0, Builder.Count);
            return this;
        }

        public Moves Print(double x, double y, double z, double e, double speed)
        {
            Builder.Add(new Vec3(x, y, z), e, e, speed, MoveKind.Print, Role.Infill, -1, 0, Builder.Count);
            return this;
        }

        public Moves Prime(double e, double speed)
        {
            Builder.Add(Builder.Position, e, e, speed, MoveKind.Prime, Role.Unspecified, -1, 0, Builder.Count);
            return this;
        }

        public Moves Event(PrinterEvent what)
        {
            Builder.AddEvent(what, Builder.Count);
            return this;
        }
    }
}
