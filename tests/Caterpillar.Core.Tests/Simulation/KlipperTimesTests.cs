using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Flavors;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Tests.GCode;
using Caterpillar.Toolpaths;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Caterpillar.Tests.Simulation;

/// <summary>Times by Klipper's own planner (shared data <c>times</c>): small programs for one rule each, and prints.</summary>
public class KlipperTimesTests
{
    private static readonly string[] Sets = ["A", "B"];

    public static IEnumerable<string> Synthetic() => Names("synthetic");

    // Mono is slow: a few prints there.
    public static IEnumerable<string> Prints() => !Rounds.OnMono ? Names("gcode") : Names("gcode").Take(6);

    [Test, Combinatorial]
    public void Small_programs_take_as_long_as_in_Klipper([ValueSource(nameof(Synthetic))] string file, [ValueSource(nameof(Sets))] string set)
    {
        var entry = Data()["synthetic"]![file]!;
        var timeline = Timeline.Of(Decoded(TestData.Shared("times/synthetic/" + file)), Setup(set));
        Assert.That(timeline.Duration, Is.EqualTo((double)entry[set]!["seconds"]! + (double)entry["dwell_s"]!).Within(1e-6));
        if (entry[set]!["expected"]!.Type == JTokenType.Null) return;
        Assert.That(timeline.Duration - (double)entry["dwell_s"]!, Is.EqualTo((double)entry[set]!["expected"]!).Within(1e-6));
    }

    [Test, Combinatorial]
    public void Prints_and_their_checkpoints_take_as_long_as_in_Klipper([ValueSource(nameof(Prints))] string file, [ValueSource(nameof(Sets))] string set)
    {
        var entry = Data()["gcode"]![file]!;
        var name = GCodeFiles.All().First(f => f.StartsWith(file, StringComparison.Ordinal));
        var timeline = Timeline.Of(Decoded(TestData.Shared("gcode/" + name)), Setup(set));
        var dwells = (double)(entry["dwell_s"] ?? 0);
        Assert.That(timeline.Duration - dwells, Is.EqualTo((double)entry[set]!["seconds"]!).Within(2e-5));
        var lines = timeline.Toolpath.Moves().Select(m => m.Source).ToArray();
        foreach (var checkpoint in entry[set]!["checkpoints"]!)
        {
            var line = (int)checkpoint[0]!;
            Assert.That(timeline.EndOf(Array.FindLastIndex(lines, s => s <= line)), Is.EqualTo((double)checkpoint[1]!).Within(2e-5), $"line {line}");
        }
    }

    [Test]
    public void Every_trapezoid_of_the_small_programs_is_that_of_Klipper()
    {
        var table = System.Text.Encoding.ASCII.GetString(TestData.ReadBytes(TestData.Shared("times/synthetic_moves.csv.gz")));
        var rows = table.Split('\n').Skip(1).Where(r => r.Length > 0)
            .Select(r => r.Split(',')).ToLookup(r => (File: r[0], Set: r[1]));
        Assert.That(rows, Has.Count.EqualTo(68));
        foreach (var moves in rows)
        {
            var timeline = Timeline.Of(Decoded(TestData.Shared($"times/synthetic/{moves.Key.File}.gcode")), Setup(moves.Key.Set));
            var ours = timeline.Trapezoids().Where(t => t.Acceleration > 0).ToArray();
            Assert.That(ours, Has.Length.EqualTo(moves.Count()), moves.Key.File);
            foreach (var (own, row) in ours.Zip(moves, (own, row) => (own, row)))
            {
                var place = $"{moves.Key.File}, {moves.Key.Set}, line {row[2]}";
                Assert.That(own.Accelerating, Is.EqualTo(Number(row[4])).Within(2e-8), place);
                Assert.That(own.Decelerating, Is.EqualTo(Number(row[6])).Within(2e-8), place);
                Assert.That(own.Start, Is.EqualTo(Number(row[7])).Within(2e-5), place);
                Assert.That(own.Peak, Is.EqualTo(Number(row[8])).Within(2e-5), place);
                Assert.That(own.End, Is.EqualTo(Number(row[9])).Within(2e-5), place);
                Assert.That(own.Length, Is.EqualTo(Number(row[11])).Within(1e-8), place);
            }
        }
    }

    private static double Number(string text) => double.Parse(text, System.Globalization.CultureInfo.InvariantCulture);

    private static IEnumerable<string> Names(string kind)
    {
        var file = Path.GetFullPath(Path.Combine(TestData.Repository, "..", "shared", "data", "times", "klipper.json"));
        return File.Exists(file) ? ((JObject)JObject.Parse(File.ReadAllText(file))[kind]!).Properties().Select(p => p.Name) : ["none"];
    }

    private static JObject Data() => JObject.Parse(File.ReadAllText(TestData.Shared("times/klipper.json")));

    // As that run took it: E in mm also where a slicer meant mm³, and no tools: T was unknown there.
    private static Toolpath Decoded(string file)
    {
        var text = System.Text.Encoding.GetEncoding(28591).GetString(TestData.ReadBytes(file));
        var bytes = System.Text.Encoding.GetEncoding(28591).GetBytes(System.Text.RegularExpressions.Regex.Replace(text, "(?m)^T[0-9]", ";"));
        var toolpath = GCodeDecoder.Decode(GCodeDocument.FromBytes(bytes, file), new DecodeOptions { Flavor = FlavorTable.Klipper }).Value!.Toolpath;
        return toolpath.With(tools: [new ToolpathTool(null)]);
    }

    private static PrintSetup Setup(string set)
    {
        var settings = Data()["settings"]![set]!;
        double Value(string key) => (double)settings[key]!;
        return new PrintSetup() with
        {
            Printer = new Printer
            {
                Flavor = FlavorTable.Klipper,
                Cornering = Cornering.SquareCornerVelocity,
                MaxSpeed = new(Value("max_velocity"), Value("max_velocity"), Value("max_z_velocity"), Value("max_extrude_only_velocity")),
                MaxAcceleration = new(Value("max_accel"), Value("max_accel"), Value("max_z_accel"), Value("max_extrude_only_accel")),
                RetractionAcceleration = Value("max_extrude_only_accel"),
                SquareCornerVelocity = Value("square_corner_velocity"),
                MinimumCruiseRatio = Value("minimum_cruise_ratio"),
                InstantaneousCornerVelocity = 1,
                LookaheadMoves = 0,
                ArcSegment = 1,
                RetractionLength = 1,
                RetractionSpeed = 30,
                NozzleHeating = 0,
                BedHeating = 0,
            },
        };
    }
}
