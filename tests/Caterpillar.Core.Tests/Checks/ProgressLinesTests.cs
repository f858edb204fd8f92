using System;
using System.IO;
using System.Linq;
using Caterpillar.Checks;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

public class ProgressLinesTests
{
    [TestCase("marlin2", "M73 P0 R10")]
    [TestCase("prusa", "M73 P0 R10")]
    [TestCase("sailfish", "M73 P0")]
    public void A_file_shows_its_progress_and_states_its_time(string flavor, string first)
    {
        var lines = Written(flavor);
        Assert.That(lines, Does.Contain(";TIME:600"));
        var progress = lines.Where(l => l.StartsWith("M73", StringComparison.Ordinal)).ToArray();
        Assert.That(progress[0], Is.EqualTo(first));
        Assert.That(progress.Last(), Is.EqualTo(first.Contains("R10") ? "M73 P100 R0" : "M73 P100"));
        Assert.That(progress, Is.Unique);
        // 60 moves of 10 s: the percent is that of the time before the next move, minutes are the nearest.
        var at = Array.IndexOf(lines, progress[30]);
        Assert.That(progress[30], Does.StartWith("M73 P50"));
        Assert.That(lines[at + 1], Does.Contain("X31").Or.Contain("X30"));
        Assert.That(progress.Length, Is.EqualTo(61));
        for (var i = 1; i < 60; i++) Assert.That(progress[i], Does.StartWith($"M73 P{100 * i / 60}"), $"{i}");
    }

    [Test]
    public void Flavors_without_the_command_and_printers_that_want_none_get_none()
    {
        Assert.That(Written("marlin1").Count(l => l.StartsWith("M73", StringComparison.Ordinal)), Is.Zero);
        Assert.That(Written("marlin1"), Does.Contain(";TIME:600"));
        var quiet = Written("marlin2", wanted: false);
        Assert.That(quiet.Any(l => l.StartsWith("M73", StringComparison.Ordinal) || l.StartsWith(";TIME", StringComparison.Ordinal)), Is.False);
    }

    [Test]
    public void A_print_of_less_than_a_second_has_progress_too()
    {
        var (toolpath, all) = ProgressCommands.Add(new SmallPrint().Print(12, 10, 0.2).Build(), SmallPrint.Setup(), null, default);
        Assert.That(all, Is.InRange(0.01, 0.9));
        var shown = toolpath.Events.Select(e => (e.Move, e.Event));
        Assert.That(shown, Is.EqualTo(new[] { (0, (PrinterEvent)new ProgressEvent(0, 0)), (1, new ProgressEvent(100, 0)) }));
    }

    // Minutes are the nearest: 100 minutes and a few seconds.
    [TestCase(6000, "M73 P0 R100")]
    [TestCase(5969, "M73 P0 R100")]
    [TestCase(5960, "M73 P0 R99")]
    public void Minutes_have_sixty_seconds(double seconds, string first)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(10, 10, 0.2));
        builder.Add(new Vec3(20, 10, 0.2), 0, 0, 10, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.AddEvent(new DwellEvent(seconds));
        builder.Add(new Vec3(30, 10, 0.2), 0.4, 0.4, 10, MoveKind.Print, Role.OuterWall, -1, 0, 1);
        var (toolpath, all) = ProgressCommands.Add(builder.Build([new ToolpathTool(2.4)]), SmallPrint.Setup(), null, default);
        Assert.That(all, Is.InRange(seconds + 1.5, seconds + 3));
        var (move, shown) = toolpath.Events.Where(e => e.Event is ProgressEvent).Select(e => (e.Move, (ProgressEvent)e.Event)).First();
        Assert.That((move, $"M73 P{shown.Percent} R{shown.MinutesLeft}"), Is.EqualTo((0, first)));
    }

    [Test]
    public void After_the_last_move_all_is_done_also_where_the_machine_waits()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(10, 10, 0.2));
        builder.Add(new Vec3(20, 10, 0.2), 0.4, 0.4, 10, MoveKind.Print, Role.OuterWall, -1, 0, 0);
        builder.AddEvent(new DwellEvent(600));
        var (toolpath, _) = ProgressCommands.Add(builder.Build([new ToolpathTool(2.4)]), SmallPrint.Setup(), null, default);
        Assert.That(toolpath.Events.Select(e => e.Event).OfType<ProgressEvent>().Last(), Is.EqualTo(new ProgressEvent(100, 0)));
    }

    [TestCase(0, 0)]
    [TestCase(1, 2)]
    public void A_print_that_takes_time_has_a_first_and_a_last_line(int moves, int lines)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(10, 10, 0.2));
        // A move in place without E takes no time.
        builder.Add(new Vec3(10 + 10 * moves, 10, 0.2), 0, 0, 10, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        var (toolpath, seconds) = ProgressCommands.Add(builder.Build([new ToolpathTool(2.4)]), SmallPrint.Setup(), null, default);
        Assert.That((toolpath.Events.Count, seconds is not null), Is.EqualTo((lines, lines > 0)));
        var nothing = new ToolpathBuilder(MoveSource.Steps, new Vec3(10, 10, 0.2)).Build([new ToolpathTool(2.4)]);
        Assert.That(ProgressCommands.Add(nothing, SmallPrint.Setup(), null, default), Is.EqualTo((nothing, (double?)null)));
    }

    [Test]
    public void Progress_changes_no_move()
    {
        var with = Decode(Written("marlin2"));
        var without = Decode(Written("marlin2", wanted: false));
        Assert.That(with.Moves().Select(m => (m.End, m.E, m.Speed, m.Kind)), Is.EqualTo(without.Moves().Select(m => (m.End, m.E, m.Speed, m.Kind))));
    }

    [Test]
    public void Minutes_left_agree_with_the_timeline_of_the_written_file()
    {
        var lines = Written("marlin2");
        var file = Decode(lines);
        var timeline = Timeline.Of(file, Setup("marlin2", true));
        for (var i = 0; i < lines.Length; i++)
        {
            if (!lines[i].StartsWith("M73 P", StringComparison.Ordinal) || timeline.AtSource(i + 2) is not { } state) continue;
            var minutes = int.Parse(lines[i].Substring(lines[i].IndexOf('R') + 1), System.Globalization.CultureInfo.InvariantCulture);
            Assert.That(state.TimeLeft / 60, Is.EqualTo(minutes).Within(0.51), lines[i]);
        }
    }

    private static Toolpath Decode(string[] lines)
    {
        var bytes = System.Text.Encoding.ASCII.GetBytes(string.Join("\n", lines));
        return GCodeDecoder.Decode(GCodeDocument.FromBytes(bytes), new DecodeOptions { Flavor = FlavorTable.Marlin2 }).Value!.Toolpath;
    }

    private static PrintSetup Setup(string flavor, bool wanted) => new()
    {
        Printer = new Printer
        {
            Flavor = FlavorTable.Find(flavor)!,
            ProgressCommands = wanted,
            Cornering = Cornering.Jerk,
            Jerk = new(8, 8, 8, 8),
            MinExtrusionTemperature = 0,
        },
    };

    // 60 extrusions of 1 mm at 0.1 mm/s: 600 s.
    private static string[] Written(string flavor, bool wanted = true)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var i = 1; i <= 60; i++) builder.Add(new Vec3(i, 0, 0.2), 0.03, 0.03, 0.1, MoveKind.Print, Role.Unspecified, -1, 0, i);
        using var memory = new MemoryStream();
        var result = SafeWriter.Write(builder.Build([new ToolpathTool(2.405)]), Setup(flavor, wanted), memory);
        Assert.That(result.Value, Is.Not.Null, string.Join("\n", result.Diagnostics));
        return System.Text.Encoding.ASCII.GetString(memory.ToArray()).Split('\n');
    }
}
