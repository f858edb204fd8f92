using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Caterpillar.Tests.Turtles;

/// <summary>Every command list of the shared data against the numbers of an implementation in 40 digits.</summary>
internal sealed class ReplayTests
{
    private static IEnumerable<string> Programs()
    {
        var file = Path.Combine(TestData.Repository, "..", "shared", "data", "turtle", "truth.json");
        return File.Exists(file) ? Truth(file).Properties().Select(p => p.Name).ToArray() : ["seven_star"];
    }

    private static JObject Truth(string file) => JObject.Parse(File.ReadAllText(file));

    [Category("Arithmetic")]
    [TestCaseSource(nameof(Programs))]
    public void Command_lists_replay_to_their_numbers(string name)
    {
        var truth = (JObject)Truth(TestData.Shared("turtle/truth.json"))[name]!;
        var exact = (JObject)truth["exact"]!;
        var start = Point(truth["start"]!);
        var turtle = CommandList.Replay(TestData.Shared("turtle/" + (string)truth["file"]!));
        var totals = CommandList.Total(turtle, start);
        var place = Math.Max(1e-9, 10 * ((double?)truth["float64_error"]?["position_mm"] ?? 0));
        var length = Math.Max(1e-9, 10 * ((double?)truth["float64_error"]?["print_length_mm"] ?? 0));
        Assert.Multiple(() =>
        {
            Assert.That(totals.PrintMoves, Is.EqualTo((int)truth["counts"]!["print_moves"]!), "print moves");
            Assert.That(totals.TravelMoves, Is.EqualTo((int)truth["counts"]!["travel_moves"]!), "travel moves");
            Assert.That(totals.PrintLength, Is.EqualTo((double)exact["print_length"]!).Within(length), "printed length");
            Assert.That(totals.TravelLength, Is.EqualTo((double)exact["travel_length"]!).Within(length), "travel length");
            Assert.That(totals.EPrint, Is.EqualTo((double)exact["e_print"]!).Within(length), "E of moves");
            Assert.That(totals.EExtrude, Is.EqualTo((double)exact["e_extrude"]!).Within(length), "E in place");
            Assert.That(totals.PrintTime, Is.EqualTo((double)exact["print_time_s"]!).Within(1e-7), "time");
            Assert.That(totals.Box.Min.DistanceTo(Point(exact["bbox_print"]![0]!)), Is.LessThan(place), "box");
            Assert.That(totals.Box.Max.DistanceTo(Point(exact["bbox_print"]![1]!)), Is.LessThan(place), "box");
            Assert.That(turtle.Position.DistanceTo(Point(exact["end"]!)), Is.LessThan(place), "end");
            Assert.That(turtle.Pose.X.DistanceTo(Point(exact["forward"]!)), Is.LessThan(1e-9), "forward");
            Assert.That(turtle.Pose.Y.DistanceTo(Point(exact["left"]!)), Is.LessThan(1e-9), "left");
            Assert.That(turtle.Pose.Z.DistanceTo(Point(exact["up"]!)), Is.LessThan(1e-9), "up");
        });
        var events = turtle.ToSteps().OfType<EventStep>().Select(e => e.Event).ToArray();
        Assert.That(events.OfType<DwellEvent>().Sum(e => e.Seconds * 1000), Is.EqualTo((double)truth["counts"]!["dwell_ms"]!).Within(1e-3));
        Assert.That(events.OfType<ExtrudeEvent>().Count(), Is.EqualTo((int)truth["counts"]!["extrudes"]!));
        Assert.That(events.OfType<PauseEvent>().Count(), Is.EqualTo((int)truth["counts"]!["pauses"]!));
    }

    private static Vec3 Point(JToken token) => new((double)token[0]!, (double)token[1]!, (double)token[2]!);
}
