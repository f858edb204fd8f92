using System;
using System.Linq;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Tests.GCode;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Simulation;

/// <summary>States of the machine: by hand, and against a walk through all moves.</summary>
public class TimelineTests
{
    private static readonly Printer Printer = new()
    {
        Cornering = Cornering.Jerk,
        Jerk = new(0, 0, 0, 0),
        PrintAcceleration = 1000,
        TravelAcceleration = 1000,
        RetractionAcceleration = 1000,
        MaxAcceleration = new(1e6, 1e6, 1e6, 1e6),
        MaxSpeed = new(500, 500, 500, 500),
        LookaheadMoves = 0,
        NozzleHeating = 2,
        BedHeating = 0.5,
    };

    private const string Print = """
        M109 S220
        M106 S127.5
        G1 X100 F6000
        ;LAYER_CHANGE
        ;Z:0.3
        G1 Z0.3
        M83
        G1 X200 E5
        T1
        G4 S2
        ;LAYER_CHANGE
        ;Z:0.6
        G1 Z0.6
        G1 X100 E4
        G1 E-1
        """;

    [Test]
    public void The_state_in_the_middle_of_a_extrusion_says_everything()
    {
        var timeline = Of(Print);
        // 100 s of heating, 1.1 s, a triangle of 0.3 mm, and half of 1.1 s.
        var lift = 2 * Math.Sqrt(0.3 / 1000);
        var s = timeline.At(100 + 1.1 + lift + 0.55);
        Assert.That(s.Position.DistanceTo(new Vec3(150, 0, 0.3)), Is.LessThan(1e-9));
        Assert.That(s.Direction.DistanceTo(Vec3.UnitX), Is.LessThan(1e-9));
        Assert.That(s.Frame.Y.DistanceTo(Vec3.UnitY), Is.LessThan(1e-9));
        Assert.That((s.Move, s.Kind, s.Layer, s.Tool, s.Source, s.Waits), Is.EqualTo((2, MoveKind.Print, 0, 0, 8, false)));
        Assert.That(s.Done, Is.EqualTo(0.5).Within(1e-9));
        Assert.That(s.Speed, Is.EqualTo(100).Within(1e-9));
        Assert.That(s.Filament, Is.EqualTo(2.5).Within(1e-9));
        Assert.That(s.Length, Is.EqualTo(150.3).Within(1e-9));
        var area = Math.PI * 1.75 * 1.75 / 4;
        Assert.That(s.Volume, Is.EqualTo(2.5 * area).Within(1e-9));
        Assert.That(s.Flow, Is.EqualTo(0.05 * 100 * area).Within(1e-9));
        Assert.That(s.Fan, Is.EqualTo(0.5).Within(1e-9));
        Assert.That((s.NozzleTarget, s.NozzleTemperature, s.BedTarget, s.BedTemperature), Is.EqualTo((220, 220, 0, 20)));
        Assert.That(s.TimeLeft, Is.EqualTo(timeline.Duration - s.Time).Within(1e-9));
    }

    [Test]
    public void While_the_machine_waits_it_stands_and_heats()
    {
        var s = Of(Print).At(50);
        Assert.That((s.Move, s.Waits, s.Speed, s.Done, s.Position), Is.EqualTo((0, true, 0.0, 0.0, Vec3.Zero)));
        Assert.That((s.NozzleTarget, s.NozzleTemperature), Is.EqualTo((220, 120)));
        Assert.That(s.Flow, Is.Zero);
    }

    [Test]
    public void A_deposit_in_one_place_flows_at_the_speed_of_its_E()
    {
        var timeline = Of("M83\nG1 E100 F300");
        var s = timeline.AtFraction(0.5);
        Assert.That((s.Speed, s.Length), Is.EqualTo((5.0, 0.0)));
        Assert.That(s.Flow, Is.EqualTo(5 * Math.PI * 1.75 * 1.75 / 4).Within(1e-9));
    }

    [Test]
    public void Moves_lines_layers_and_heights_are_found_at_their_start()
    {
        var timeline = Of(Print);
        Assert.That(timeline.AtMove(0).Time, Is.Zero);
        Assert.That(timeline.WaitBefore(0), Is.EqualTo(100).Within(1e-9));
        Assert.That(timeline.AtMove(2).Position, Is.EqualTo(new Vec3(100, 0, 0.3)));
        Assert.That(timeline.AtSource(8)!.Value.Move, Is.EqualTo(2));
        Assert.That(timeline.AtSource(9)!.Value.Move, Is.EqualTo(3), "a line without a move is that of the next move");
        Assert.That(timeline.AtSource(99), Is.Null);
        Assert.That(timeline.AtLayer(0)!.Value.Move, Is.EqualTo(1));
        Assert.That(timeline.AtLayer(1)!.Value.Position.Z, Is.EqualTo(0.3));
        Assert.That(timeline.AtHeight(0.5)!.Value.Position, Is.EqualTo(new Vec3(200, 0, 0.6)));
        Assert.That(Of("M83\nG1 X10 Y10 Z0.2 F3000\nG1 X110 Z10.2 E5\n").AtHeight(2.7)!.Value.Position.DistanceTo(new Vec3(35, 10, 2.7)), Is.LessThan(1e-9));
        Assert.That(timeline.AtHeight(0.3)!.Value.Move, Is.EqualTo(2));
        Assert.That(timeline.AtHeight(7), Is.Null);
        Assert.That(timeline.AtLayer(-1), Is.Null);
        Assert.That(timeline.AtLayer(2), Is.Null);
        Assert.That(() => timeline.StartOf(-1), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [Test]
    public void The_highest_speed_of_a_move_is_that_of_the_head_or_in_one_place_of_the_filament()
    {
        var timeline = Of("G1 X100 F6000\nG1 X101 F30\nM83\nG1 E-1 F1200");
        Assert.That(timeline.PeakOf(0), Is.EqualTo(100).Within(1e-9));
        Assert.That(timeline.PeakOf(1), Is.EqualTo(0.5).Within(1e-9));
        Assert.That(timeline.PeakOf(2), Is.EqualTo(20).Within(1e-9));
    }

    [Test]
    public void Before_the_start_and_after_the_end_the_machine_stands_at_the_ends()
    {
        var timeline = Of(Print + "\nG4 S3");
        Assert.That(timeline.At(-5), Is.EqualTo(timeline.At(0)));
        Assert.That(timeline.At(double.NaN), Is.EqualTo(timeline.At(0)));
        var last = timeline.At(1e9);
        Assert.That((last.Move, last.Time, last.TimeLeft, last.Position), Is.EqualTo((timeline.Toolpath.Count, timeline.Duration, 0.0, new Vec3(100, 0, 0.6))));
        Assert.That(last.Filament, Is.EqualTo(9).Within(1e-9));
        Assert.That(timeline.AtFraction(1), Is.EqualTo(last));
        Assert.That(Of("").At(3).Move, Is.Zero);
    }

    [Test]
    public void By_length_half_of_the_path_is_half_of_the_path()
    {
        var timeline = Of("G1 X100 F6000\nG4 S5\nG2 X100 Y0 I-20 J0\nG1 X200");
        foreach (var fraction in new[] { 0.0, 0.1, 0.3, 0.5, 0.65, 0.9, 0.999 })
        {
            var s = timeline.AtLength(fraction);
            Assert.That(s.Length, Is.EqualTo(fraction * timeline.Length).Within(1e-6), $"{fraction}");
            Assert.That(timeline.At(s.Time).Position.DistanceTo(s.Position), Is.LessThan(1e-6));
        }
        Assert.That(timeline.AtLength(1).Time, Is.EqualTo(timeline.Duration));
        // On the circle, and not on its chords.
        var on = timeline.AtLength(0.5).Position;
        Assert.That(on.DistanceTo(new Vec3(80, 0)), Is.EqualTo(20).Within(1e-9));
    }

    [Test]
    public void States_are_those_of_a_walk_through_all_moves(
        [Values("ps_overlap_two_tools.gcode", "hand_arcs_ij_r.gcode", "s3r_nested_smoothie_volE_fwr.gcode")] string file)
    {
        var toolpath = GCodeDecoder.Decode(GCodeFiles.Document(file)).Value!.Toolpath;
        var timeline = Timeline.Of(toolpath, new PrintSetup { Printer = new Printer { ArcSegment = 0.5 } });
        var random = new Random(5);
        var times = Enumerable.Range(0, 300).Select(_ => random.NextDouble() * timeline.Duration).OrderBy(t => t).ToArray();
        double length = 0, filament = 0, volume = 0;
        var next = 0;
        foreach (var move in toolpath.Moves())
        {
            var end = timeline.EndOf(move.Index);
            for (; next < times.Length && times[next] < end; next++)
            {
                var s = timeline.At(times[next]);
                Assert.That(s.Move, Is.EqualTo(move.Index));
                Assert.That(s.Length, Is.EqualTo(length + s.Done * move.Length).Within(1e-6));
                Assert.That(s.Filament, Is.EqualTo(filament + s.Done * move.Deposited).Within(1e-6));
                if (s.Volume is { } known) Assert.That(known, Is.EqualTo(volume + s.Done * move.Deposited * toolpath.VolumePerE(move.Tool)).Within(1e-6));
                var both = move.Start.DistanceTo(s.Position) + s.Position.DistanceTo(move.End);
                if (move.Arc is null) Assert.That(both, Is.EqualTo(move.Length).Within(1e-6));
                Assert.That((s.Layer, s.Tool, s.Role), Is.EqualTo((move.Layer, move.Tool, move.Role)));
                // A little later it is a little farther.
                var later = timeline.At(times[next] + 1e-5);
                Assert.That(s.Position.DistanceTo(later.Position), Is.LessThanOrEqualTo(1e-5 * 400));
                var back = timeline.AtLength(s.Length / timeline.Length);
                if (move.Length > 0 && !s.Waits) Assert.That(back.Position.DistanceTo(s.Position), Is.LessThan(1e-4));
            }
            length += move.Length;
            filament += move.Deposited;
            volume += move.Deposited * (toolpath.VolumePerE(move.Tool) ?? 0);
        }
        Assert.That(next, Is.EqualTo(times.Length));
        Assert.That(timeline.AtMove(toolpath.Count).Volume ?? volume, Is.EqualTo(volume).Within(1e-6));
        Assert.That(timeline.Length, Is.EqualTo(length).Within(1e-6));
    }

    [Test]
    public void Time_and_distance_of_a_trapezoid_belong_together()
    {
        Trapezoid[] all = [new(0, 100, 20, 1000, 0.1 + 0.08 + 0.3), new(30, 30, 30, 500, 2), new(0, 50, 0, 1000, 0.1), new(40, 40, 10, 100, 0.3)];
        foreach (var t in all)
        {
            for (var i = 0; i <= 20; i++) Assert.That(t.TimeAt(t.DistanceAt(t.Duration * i / 20)), Is.EqualTo(t.Duration * i / 20).Within(1e-9));
        }
    }

    [Test]
    public void Seeking_allocates_nothing()
    {
        var timeline = Of(Print);
        if (Rounds.OnMono) Assert.Ignore("Mono does not count what a thread allocates.");
        for (var i = 0; i < 100; i++) timeline.AtFraction(i / 100.0);
        var before = Allocated();
        var sum = 0.0;
        for (var i = 0; i < 1000; i++)
        {
            sum += timeline.AtFraction(i / 1000.0).Position.X + timeline.AtLength(i / 1000.0).Time;
            sum += timeline.AtHeight(0.5)!.Value.Time + timeline.AtSource(8)!.Value.Time;
        }
        Assert.That(Allocated() - before, Is.LessThan(1000));
        Assert.That(sum, Is.GreaterThan(0));
    }

#if NET
    private static long Allocated() => GC.GetAllocatedBytesForCurrentThread();
#else
    private static long Allocated() => 0;
#endif

    private static Timeline Of(string lines)
    {
        var document = GCodeDocument.FromBytes(System.Text.Encoding.ASCII.GetBytes(lines + "\n"), "program");
        var decoding = GCodeDecoder.Decode(document, new DecodeOptions { Flavor = FlavorTable.Marlin2, FilamentDiameter = 1.75 });
        return Timeline.Of(decoding.Value!.Toolpath, new PrintSetup { Printer = Printer });
    }
}
