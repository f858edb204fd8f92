using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Jobs;

/// <summary>Files for machines with rotary axes: a bowl, printed with the tool along its normals, is written, read, checked and simulated.</summary>
[Category("Arithmetic")]
public class RotaryFileTests
{
    private const double Height = 0.2;

    [TestCase("C head z from -360 to 360, B head y at 0 0 60")]
    [TestCase("[\"C head z from -360 to 360\", \"B head y at 0 0 60\"]")]
    public void Axes_are_given_on_one_line_with_or_without_brackets(string text)
    {
        var printer = new ProfileLibrary().Setup("generic", values: ["rotary_axes=" + text]).OrThrow().Printer;
        Assert.That(printer.RotaryAxes.Select(a => (a.Word, a.Max, a.Point.Z)),
            Is.EqualTo(new[] { (RotaryWord.C, 360, 0), (RotaryWord.B, double.PositiveInfinity, 60) }));
    }

    [TestCase("five_axis_head", "machine")]
    [TestCase("five_axis_table", "machine")]
    [TestCase("five_axis_head", "tip")]
    public void The_tip_stays_on_its_path_between_the_written_points(string printer, string positions)
    {
        var setup = new ProfileLibrary().Setup(printer).OrThrow().With("rotary_positions=" + positions, "start_gcode=", "end_gcode=").OrThrow();
        using var job = PrintJob.Draw(Rings(setup.Printer), setup, new PrintJobOptions { Tilt = new ToolAim(p => Normal(p, setup.Printer)) }).OrThrow();
        var written = SafeWriter.ToDocument(job.Toolpath, setup, reason: "a drawing in the air");
        var document = written.Value!;
        string[] wrong = ["collision", "file.pos", "limit.axis", "limit.speed"];
        Assert.That(written.Diagnostics.Where(d => d.Severity != Severity.Note && wrong.Any(w => d.Code.StartsWith(w, StringComparison.Ordinal))), Is.Empty);
        var file = GCodeDecoder.Decode(document).OrThrow();
        var kinematics = setup.Printer.Kinematics!;
        // The machine moves all its words evenly; a controller that knows the tip keeps it on the line itself.
        var read = file.Toolpath;
        var planned = job.Toolpath.Moves().Where(m => m.Kind == MoveKind.Print).ToArray();
        var (at, turns, next, off) = (Vec3.Zero, Vec3.Zero, 0, 0.0);
        foreach (var move in read.Moves())
        {
            var words = read.WordsAt(move.Index);
            if (move.Deposited > 0)
            {
                for (var s = 0.0; s <= 1; s += 0.125)
                {
                    var slides = Vec3.Lerp(move.Start, move.End, s);
                    var tip = positions == "tip" ? slides : kinematics.Tip(slides, Vec3.Lerp(turns, words, s));
                    while (next < planned.Length - 1 && tip.DistanceToSegment(planned[next].Start, planned[next].End) > 0.01) next++;
                    off = Math.Max(off, tip.DistanceToSegment(planned[next].Start, planned[next].End));
                    var tool = kinematics.Direction(Vec3.Lerp(turns, words, s));
                    Assert.That(tool.DistanceTo(Normal(tip, setup.Printer)), Is.LessThan(0.03), "the tool is along the normal");
                }
            }
            (at, turns) = (move.End, words);
        }
        Assert.That(next, Is.EqualTo(planned.Length - 1), "all of the plan is there");
        Assert.That(off, Is.LessThan(0.01));
        // On the part it is the plan again, in the same time, with the head as it leans.
        var part = file.Unrolled();
        Assert.That(part.Moves().Sum(m => m.Kind == MoveKind.Print ? m.Length : 0), Is.EqualTo(planned.Sum(m => m.Length)).Within(0.05));
        var (time, wanted) = (Timeline.Of(part, setup), Timeline.Of(job.Toolpath, setup));
        Assert.That(time.Duration, Is.EqualTo(wanted.Duration).Within(0.1 * wanted.Duration));
        var state = time.AtFraction(0.5);
        Assert.That(state.Frame.Z.DistanceTo(Normal(state.Position, setup.Printer)), Is.LessThan(0.05));
        var upright = setup with { Printer = setup.Printer with { RotaryAxes = ValueList<RotaryAxis>.Empty } };
        Assert.That(time.Duration, Is.GreaterThan(Timeline.Of(job.Toolpath, upright).Duration), "rotary axes are slower than the tip");
    }

    // More lines than a block of moves holds; the tool is turned every 700 lines, not near the end of the block.
    [Test]
    public void Rotary_words_of_a_long_file_stay_with_their_extrusions()
    {
        var text = new System.Text.StringBuilder("G90\nM83\n;LAYER:0\nG1 Z0.2 F3000\n");
        for (var i = 0; i < 66_000; i++)
        {
            if (i == 65_900) text.Append(";LAYER:1\nG1 Z0.4\n");
            text.Append("G1 X").Append(i % 200 + 1).Append(" Y").Append(i / 200 % 200);
            text.Append(i % 700 == 0 ? $" B{i / 700} C{-i / 700}" : "").Append(" E0.02\n");
        }
        var job = new FileJob(GCodeDecoder.Decode(GCodeDocument.FromText(text.ToString())).OrThrow());
        Assert.That(job.Toolpath.Blocks, Has.Count.EqualTo(2));
        Assert.That(job.Toolpath.WordsAt(job.Toolpath.Count - 1), Is.EqualTo(new Vec3(0, 94, -94)));
        var words = Words(job.Toolpath);
        Assert.That(words, Has.Length.EqualTo(66_000));
        FileEdits[] edits =
        [
            new() { Move = new Vec3(5, 2), PauseAtLayers = [1], PauseFor = new PrintSetup { Printer = new Printer { PauseLift = 5 } } },
            new() { Remove = true, Filter = new MoveFilter { LastLayer = 0 } },
        ];
        foreach (var edit in edits)
        {
            using var stream = new System.IO.MemoryStream();
            job.Edit(edit).OrThrow().Write(stream, "edited.gcode", null).OrThrow();
            var written = Words(GCodeDecoder.Decode(GCodeDocument.FromBytes(stream.ToArray())).OrThrow().Toolpath);
            Assert.That(written.SequenceEqual(edit.Remove ? words.Skip(65_900) : words), Is.True, edit.ToString());
        }

        static Vec3[] Words(Toolpath toolpath) => [.. toolpath.Moves().Where(m => m.Kind == MoveKind.Print).Select(m => toolpath.WordsAt(m.Index))];
    }

    [Test]
    public void A_polar_machine_turns_the_platform_under_the_nozzle()
    {
        var setup = new PrintSetup().With("rotary_axes=C work z speed 360", "rotary_positions=polar", "origin=center", "start_gcode=", "end_gcode=").OrThrow();
        var square = new PrintPath([new(20, 20, 0.2), new(-20, 20, 0.2), new(-20, -20, 0.2), new(20, -20, 0.2)], new Bead(0.08, 0.2, 30), closed: true);
        using var job = PrintJob.Draw([square], setup).OrThrow();
        var plain = Planner.Plan([square], setup, new PlanOptions { Policy = PlanPolicy.AsDrawn }).OrThrow();
        using var drawn = PrintJob.Draw([square], setup, new PrintJobOptions { Policy = PlanPolicy.AsDrawn }).OrThrow();
        Assert.That(PrintStatistics.Of(plain, setup).Duration, Is.EqualTo(Timeline.Of(drawn.Toolpath, setup).Duration).Within(1e-6), "also of a plain path");
        var document = SafeWriter.ToDocument(job.Toolpath, setup).OrThrow();
        var text = System.Text.Encoding.ASCII.GetString(document.ToBytes());
        Assert.That(text, Does.Not.Match(@"\nG1[^;]* Y-?[1-9]"), "no Y");
        var file = GCodeDecoder.Decode(document).OrThrow();
        foreach (var move in file.Unrolled().Moves().Where(m => m.Kind == MoveKind.Print))
        {
            var side = Math.Max(Math.Abs(move.End.X), Math.Abs(move.End.Y));
            Assert.That(side, Is.EqualTo(20).Within(0.003), "on the square");
        }
        Assert.That(PrintCheck.Run(file, setup).Where(d => d.Severity == Severity.Error && d.Code.StartsWith("bed", StringComparison.Ordinal)), Is.Empty);
    }

    [Test]
    public void An_overhang_of_90_degrees_is_printed_from_the_side()
    {
        var setup = new ProfileLibrary().Setup("five_axis_head").OrThrow().With("start_gcode=", "end_gcode=").OrThrow();
        var steps = new List<Step>();
        for (var k = 1; k <= 150; k++) steps.Add(Line(100, 0.2 * k, k));
        // A shelf that grows out of the wall, each line on the one before.
        for (var k = 1; k <= 15; k++) steps.Add(Line(100.2 + 0.2 * k, 27, k));
        using var job = PrintJob.Draw(steps, setup, new PrintJobOptions { Tilt = new ToolAim(p => p.Y > 100.1 ? Vec3.UnitY : Vec3.UnitZ) }).OrThrow();
        Assert.That(job.Toolpath.WordsAt(job.Toolpath.Moves().Last(m => m.Kind == MoveKind.Print).Index).Y, Is.EqualTo(90).Or.EqualTo(-90));
        var found = PrintCheck.Run(job.Toolpath, setup);
        string[] wrong = ["collision", "extrusion.unsupported", "limit.axis"];
        Assert.That(found.Where(d => wrong.Any(w => d.Code.StartsWith(w, StringComparison.Ordinal))), Is.Empty);
        // With the tool upright the shelf hangs in the air.
        using var upright = PrintJob.Draw(steps, setup).OrThrow();
        Assert.That(PrintCheck.Run(upright.Toolpath, setup).Select(d => d.Code), Does.Contain(CheckCodes.Unsupported));

        static Step Line(double y, double z, int k)
            => new PrintPath(k % 2 == 0 ? [new Vec3(100, y, z), new(140, y, z)] : [new Vec3(140, y, z), new(100, y, z)], new Bead(0.08, Height, 30));
    }

    [Test]
    public void A_tool_leans_less_where_its_head_would_hit()
    {
        var setup = new ProfileLibrary().Setup("five_axis_head").OrThrow().With("start_gcode=", "end_gcode=").OrThrow();
        var steps = Enumerable.Range(1, 150).Select(k => Line(100, 0.2 * k)).Append(Line(112, 5)).ToArray();
        // Toward the wall, which is 30 mm high, by 45 degrees.
        using var job = PrintJob.Draw(steps, setup, new PrintJobOptions { Tilt = new ToolAim(p => p.Y > 105 ? new Vec3(0, -1, 1) : Vec3.UnitZ) }).OrThrow();
        Assert.That(PrintCheck.Run(job.Toolpath, setup).Select(d => d.Code), Does.Not.Contain(CheckCodes.NozzleHits));
        var last = job.Toolpath.Moves().Last(m => m.Kind == MoveKind.Print);
        Assert.That(Math.Abs(job.Toolpath.WordsAt(last.Index).Y), Is.LessThan(40));
        var plain = new ToolDirections(setup.Printer.Kinematics!, p => p.Y > 105 ? new Vec3(0, -1, 1) : Vec3.UnitZ).Apply(job.Plan.Toolpath);
        Assert.That(PrintCheck.Run(plain, setup).Select(d => d.Code), Does.Contain(CheckCodes.NozzleHits));

        static Step Line(double y, double z) => new PrintPath([new Vec3(100, y, z), new(140, y, z)], new Bead(0.08, Height, 30));
    }

    // The bed is at the bottom of a bowl.
    private static Vec3 Normal(Vec3 p, Printer printer)
    {
        var middle = printer.BuildBounds.Center.WithZ(80);
        return (middle - p).Unit();
    }

    private static IReadOnlyList<Step> Rings(Printer printer)
    {
        var middle = printer.BuildBounds.Center.WithZ(80);
        var steps = new List<Step>();
        for (var tilt = 5; tilt <= 45; tilt += 5)
        {
            var (sin, cos) = Angle.SinCos(tilt);
            var points = Enumerable.Range(0, 90).Select(k => middle + new Vec3(60 * sin * Angle.Cos(4 * k), 60 * sin * Angle.Sin(4 * k), -60 * cos));
            steps.Add(new PathStep(new PrintPath([.. points], new Bead(0.08, Height, 30), closed: true)));
        }
        return steps;
    }
}
