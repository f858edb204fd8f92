using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Simulation;

/// <summary>Edges of planning and timeline: what takes no time, what is empty, several tools.</summary>
public class TimelineEdgeTests
{
    private static readonly Printer Rigid = new()
    {
        Cornering = Cornering.Jerk, Jerk = new(0, 0, 0, 0), PrintAcceleration = 1000, TravelAcceleration = 1000, RetractionAcceleration = 1000,
        MaxAcceleration = new(1e6, 1e6, 1e6, 1e6), MaxSpeed = new(500, 500, 500, 500), LookaheadMoves = 0, NozzleHeating = 0, BedHeating = 0,
    };

    [TestCase("M109 S200", 100)]
    [TestCase("M190 S60", 100)]
    [TestCase("G4 P0", 0)]
    [TestCase("M400", 0)]
    [TestCase("M104 S200", 100)]
    public void Waits_for_heat_without_a_rate_stop_nothing(string command, double speed)
        => Assert.That(Of(Rigid, $"G1 X50 F6000\n{command}\nG1 X100").Trapezoids().First().End, Is.EqualTo(speed).Within(1e-9));

    // 1 mm from rest: v² = 3000 mm²/s² without the slower profile.
    [TestCase(0.999, 3)]
    [TestCase(1, 3)]
    [TestCase(5, 3)]
    [TestCase(0.4, 1800)]
    [TestCase(0, 3000)]
    [TestCase(-1, 3000)]
    public void A_cruise_ratio_that_the_file_sets_is_at_most_almost_one(double ratio, double square)
    {
        var printer = Rigid with { Cornering = Cornering.SquareCornerVelocity, MaxAcceleration = new(3000, 3000, 100, 3000) };
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.AddEvent(new LimitEvent(MotionLimit.MinimumCruiseRatio, ratio));
        builder.Add(new Vec3(1, 0), 0, 0, 500, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        var t = Timeline.Of(builder.Build([new ToolpathTool(1)]), new PrintSetup { Printer = printer }).Trapezoids().Single();
        Assert.That(t.Peak * t.Peak, Is.EqualTo(square).Within(1e-9));
    }

    [Test]
    public void Layers_without_moves_have_no_state()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        var first = builder.AddLayer(new Layer(0, 0.2, 0.2));
        builder.Add(new Vec3(10, 0, 0.2), 1, 1, 20, MoveKind.Print, Role.Infill, first, 0, 0);
        builder.AddLayer(new Layer(1, 0.4, 0.2));
        var timeline = Timeline.Of(builder.Build([new ToolpathTool(1)]), new PrintSetup { Printer = Rigid });
        Assert.That(timeline.AtLayer(0)!.Value.Move, Is.Zero);
        Assert.That(timeline.AtLayer(1), Is.Null);
        Assert.That(timeline.AtLayer(2), Is.Null);
        Assert.That(timeline.AtLayer(-1), Is.Null);
        Assert.That(timeline.AtHeight(0.2)!.Value.Move, Is.Zero);
        Assert.That(timeline.AtHeight(0.201), Is.Null);
    }

    [Test]
    public void Each_tool_has_its_own_amount_of_filament()
    {
        // The first tool has E in mm³, the second in mm of filament.
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(Vec3.Zero, -10, 0, 20, MoveKind.Retract, Role.Unspecified, -1, 0, 0);
        builder.Add(Vec3.Zero, -10, 0, 20, MoveKind.Retract, Role.Unspecified, -1, 1, 1);
        var timeline = Timeline.Of(builder.Build([new ToolpathTool(1), new ToolpathTool(2.4)]), new PrintSetup { Printer = Rigid });
        Assert.That(timeline.Trapezoids().Select(t => t.Length), Is.EqualTo(new[] { 10 / (Math.PI * 0.875 * 0.875), 10 }).Within(1e-9));
    }

    [TestCase(1, 1.0)]
    [TestCase(1, 0.5)]
    [TestCase(3, 1.0)]
    public void Sums_and_places_hold_for_any_number_of_moves_and_any_amount(int moves, double amount)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var i = 1; i <= moves; i++) builder.Add(new Vec3(10 * i, 0), amount, amount, 20, MoveKind.Print, Role.Infill, -1, 0, i);
        var timeline = Timeline.Of(builder.Build([new ToolpathTool(3)]), new PrintSetup { Printer = Rigid });
        for (var i = 0; i < moves; i++)
        {
            var state = timeline.AtLength((i + 0.25) / moves);
            Assert.That((state.Move, Math.Round(state.Done, 9)), Is.EqualTo((i, 0.25)));
            Assert.That(state.Position.X, Is.EqualTo(10 * i + 2.5).Within(1e-9));
            Assert.That(timeline.AtMove(i).Filament, Is.EqualTo(amount * i).Within(1e-12));
            Assert.That(timeline.AtMove(i).Volume, Is.EqualTo(3 * amount * i).Within(1e-12));
            Assert.That(state.Filament, Is.EqualTo(amount * (i + 0.25)).Within(1e-9));
        }
        Assert.That(timeline.At(timeline.Duration).Filament, Is.EqualTo(amount * moves).Within(1e-9));
    }

    [Test]
    public void Each_role_tool_and_layer_is_in_the_statistics_also_with_a_single_extrusion()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        var roles = Enum.GetValues(typeof(Role)).Cast<Role>().ToArray();
        for (var i = 0; i < roles.Length; i++)
        {
            var layer = builder.AddLayer(new Layer(i, 0.2, 0.2));
            builder.Add(new Vec3(10 * (i + 1), 0, 0.2), 1 + i, 1 + i, 20, MoveKind.Print, roles[i], layer, i % 3, i);
        }
        var s = PrintStatistics.Of(Timeline.Of(builder.Build([new ToolpathTool(1), new ToolpathTool(2), new ToolpathTool(3)]),
            new PrintSetup { Printer = Rigid, Material = new Material { Density = 2 } }));
        Assert.That(s.Roles.Select(r => r.Role), Is.EqualTo(roles));
        Assert.That(s.Layers.Select(l => l.Layer), Is.EqualTo(Enumerable.Range(0, roles.Length)));
        Assert.That(s.Roles.Select(r => r.Volume), Is.EqualTo(roles.Select((_, i) => (double?)(1 + i) * (1 + i % 3))));
        Assert.That(s.Layers.Select(l => l.Volume), Is.EqualTo(s.Roles.Select(r => r.Volume)));
        Assert.That(s.Tools.Select(t => t.Tool), Is.EqualTo(new[] { 0, 1, 2 }));
        Assert.That(s.Tools.Sum(t => t.Volume), Is.EqualTo(s.Volume).Within(1e-9));
        // 2 g/cm³.
        Assert.That(s.Tools.Select(t => t.Mass), Is.EqualTo(s.Tools.Select(t => t.Volume * 0.002)).Within(1e-9));
        Assert.That(s.Layers.Skip(1).Zip(s.Layers, (b, a) => b.Start - a.Start - a.Time), Is.All.EqualTo(0).Within(1e-9));
    }

    [TestCase(1, 0, 0)]
    [TestCase(0, 1, 0)]
    [TestCase(0, 0, 1)]
    public void A_long_line_in_any_direction_has_its_length(double x, double y, double z)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var i = 1; i <= 1000; i++) builder.Add(0.1 * i * new Vec3(x, y, z), 0, 0, 20, MoveKind.Travel, Role.Unspecified, -1, 0, i);
        var timeline = Timeline.Of(builder.Build([new ToolpathTool(1)]), new PrintSetup { Printer = Rigid });
        Assert.That(timeline.Length, Is.EqualTo(100).Within(1e-9));
        for (var i = 0; i < 1000; i += 7) Assert.That(timeline.AtLength((i + 0.5) / 1000).Move, Is.EqualTo(i));
    }

    [Test]
    public void A_wait_has_no_motion()
    {
        var wait = new Trapezoid(0, 0, 0, 0, 5);
        Assert.That((wait.Accelerating, wait.Decelerating, wait.Length), Is.EqualTo((0.0, 0.0, 0.0)));
        Assert.That((wait.SpeedAt(2), wait.DistanceAt(2), wait.TimeAt(2)), Is.EqualTo((0.0, 0.0, 0.0)));
    }

    [Test]
    public void Times_of_distances_are_the_inverse_of_distances_at_times([Range(0, 20)] int seed)
    {
        var random = new Random(seed);
        var (start, end) = (50 * random.NextDouble(), 50 * random.NextDouble());
        var acceleration = 100 + 2000 * random.NextDouble();
        var peak = Math.Max(start, end) + 60 * random.NextDouble();
        var length = (2 * peak * peak - start * start - end * end) / (2 * acceleration) + (seed % 3 == 0 ? 0 : 20 * random.NextDouble());
        var t = Trapezoid.Over(length, start * start, peak * peak, end * end, acceleration);
        Assert.That(t.Length, Is.EqualTo(length).Within(1e-9));
        Assert.That((t.SpeedAt(0), t.SpeedAt(t.Duration)), Is.EqualTo((start, end)).Within(1e-9));
        var (area, before) = (0.0, t.SpeedAt(0));
        const int Steps = 20_000;
        for (var i = 1; i <= Steps; i++)
        {
            var time = t.Duration * i / Steps;
            var speed = t.SpeedAt(time);
            Assert.That(Math.Abs(speed - before), Is.LessThanOrEqualTo(acceleration * t.Duration / Steps + 1e-9));
            area += (speed + before) / 2 * t.Duration / Steps;
            before = speed;
            if (i % 500 != 0) continue;
            Assert.That(t.DistanceAt(time), Is.EqualTo(area).Within(1e-4 * length));
            Assert.That(t.TimeAt(t.DistanceAt(time)), Is.EqualTo(time).Within(1e-7));
        }
        Assert.That((t.TimeAt(-1), t.TimeAt(length + 1)), Is.EqualTo((0.0, t.Duration)));
    }

    [Test]
    public void Progress_of_planning_rises_to_1()
    {
        var seen = new List<double>();
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var i = 1; i <= 140_000; i++) builder.Add(new Vec3(i % 100, i % 7), 0, 0, 50, MoveKind.Travel, Role.Unspecified, -1, 0, i);
        Timeline.Of(builder.Build([new ToolpathTool(1)]), new PrintSetup { Printer = Rigid }, new Progress(seen));
        Assert.That(seen, Is.Ordered.And.All.InRange(0, 1).And.Some.EqualTo(1));
        Assert.That(seen.Count, Is.GreaterThan(1));
    }

    [Test]
    public void Statistics_of_roles_layers_and_tools_add_up_to_the_whole()
    {
        var random = new Random(5);
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var layer = 0; layer < 4; layer++) builder.AddLayer(new Layer(layer, 0.2 * (layer + 1), 0.2));
        double deposited = 0, volume = 0;
        for (var i = 0; i < 400; i++)
        {
            var (tool, print) = (random.Next(2), random.Next(3) > 0);
            var e = print ? random.NextDouble() : 0;
            deposited += e;
            volume += e * (tool + 2);
            builder.Add(new Vec3(100 * random.NextDouble(), 100 * random.NextDouble(), 0.2 * (i / 100 + 1)), e, e, 10 + 90 * random.NextDouble(),
                print ? MoveKind.Print : MoveKind.Travel, print ? (Role)(1 + random.Next(3)) : Role.Unspecified, i / 100, tool, i);
        }
        var toolpath = builder.Build([new ToolpathTool(2), new ToolpathTool(3)]);
        var s = PrintStatistics.Of(Timeline.Of(toolpath, new PrintSetup { Printer = Rigid }));
        Assert.That(s.Filament, Is.EqualTo(deposited).Within(1e-9));
        Assert.That(s.Volume, Is.EqualTo(volume).Within(1e-9));
        Assert.That(s.Roles.Sum(r => r.Length), Is.EqualTo(s.PrintLength).Within(1e-6));
        Assert.That(s.Roles.Sum(r => r.Time), Is.EqualTo(s.PrintTime).Within(1e-6));
        Assert.That(s.Layers.Sum(l => l.Time), Is.EqualTo(s.Duration).Within(1e-6));
        Assert.That(s.PrintLength + s.TravelLength, Is.EqualTo(toolpath.Moves().Sum(m => m.Length)).Within(1e-6));
    }

    private static Timeline Of(Printer printer, string lines)
    {
        var document = GCodeDocument.FromBytes(System.Text.Encoding.ASCII.GetBytes(lines + "\n"), "program");
        var toolpath = GCodeDecoder.Decode(document, new DecodeOptions { Flavor = FlavorTable.Find("marlin2") }).Value!.Toolpath;
        return Timeline.Of(toolpath, new PrintSetup { Printer = printer });
    }

    private sealed class Progress(List<double> seen) : IProgress<double>
    {
        public void Report(double value) => seen.Add(value);
    }
}
