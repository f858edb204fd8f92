using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;

namespace Caterpillar.Bench;

/// <summary>Every target of speed that needs no other program, measured in one run: a table for RESULTS.md.</summary>
internal static class Targets
{
    public static void Run(string program, string gcode, string meshes)
    {
        var work = Directory.CreateTempSubdirectory("caterpillar-").FullName;
        try
        {
            var targets = new List<Target>();
            foreach (var target in Start(program).Concat(Files(program, gcode, work)).Concat(Pages(program, gcode, work)).Concat(Helix(program, work))
                .Concat(Motion()).Concat(Checks()).Concat(Guard()).Concat(Meshes(program, meshes, work)).Concat(LargeMesh(program, work)))
            {
                Console.Error.WriteLine(target.ToRow());
                targets.Add(target);
            }
            Console.WriteLine(Machine());
            Console.WriteLine();
            Console.WriteLine("| job | at most | measured | | |");
            Console.WriteLine("|---|---|---|---|---|");
            foreach (var target in targets) Console.WriteLine(target.ToRow());
        }
        finally
        {
            Directory.Delete(work, true);
        }
    }

    private static string Machine() => string.Create(CultureInfo.InvariantCulture,
        $"{Environment.ProcessorCount} cores, {GC.GetGCMemoryInfo().TotalAvailableMemoryBytes / 1e9:0} GB, .NET {Environment.Version}, Linux "
            + $"{(Environment.Is64BitProcess ? "x64" : "x86")}.");

    private static IEnumerable<Target> Start(string program)
    {
        var runs = ProcessRuns.Of(program, ["--version"]);
        yield return new Target("the program says its version", "s", 0.1, runs.Wall, runs.Remark);
    }

    // A page of the viewer: what the manual says of its size.
    private static IEnumerable<Target> Pages(string program, string gcode, string work)
    {
        var page = Path.Combine(work, "page.html");
        var whole = ProcessRuns.Of(program, ["view", gcode, "-o", page, "--quiet"], 3);
        var size = new FileInfo(page).Length;
        var megabytes = (new FileInfo(gcode).Length / 1e6).ToString("0", CultureInfo.InvariantCulture);
        yield return new Target($"`view`, {megabytes} MB: a page with its lines", "s", double.NaN, whole.Wall,
            string.Create(CultureInfo.InvariantCulture, $"{whole.Remark}, a page of {size / 1e6:0} MB"));
        var moves = GCodeDecoder.DecodeFile(gcode).OrThrow().Toolpath.Count;
        ProcessRuns.Of(program, ["view", gcode, "-o", page, "--quiet", "--no-gcode"], 1);
        yield return new Target("bytes of that page for a move, without the lines", "bytes", 10, (double)new FileInfo(page).Length / moves);
        var sphere = Path.Combine(work, "page.stl");
        Samples.WriteSphere(20_000, sphere);
        var print = Path.Combine(work, "page.gcode");
        ProcessRuns.Of(program, ["slice", sphere, "-o", print, "--quiet"], 1);
        ProcessRuns.Of(program, ["view", print, "-o", page, "--quiet", "--no-gcode"], 1);
        moves = GCodeDecoder.DecodeFile(print).OrThrow().Toolpath.Count;
        yield return new Target("the same for a sliced sphere", "bytes", 10, (double)new FileInfo(page).Length / moves, $"{moves} moves");
    }

    // The big file: 300 MB/s where every line changes.
    private static IEnumerable<Target> Files(string program, string gcode, string work)
    {
        var megabytes = new FileInfo(gcode).Length / 1e6;
        var output = Path.Combine(work, "o.gcode");
        Target Whole(string job, double allowed, params string[] arguments)
        {
            var runs = ProcessRuns.Of(program, arguments);
            return new Target(job, "s", allowed, runs.Wall, $"{runs.Remark}, {(megabytes / runs.Wall).ToString("0", CultureInfo.InvariantCulture)} MB/s");
        }
        var size = megabytes.ToString("0", CultureInfo.InvariantCulture) + " MB";
        yield return Whole($"`decode --json`, {size}", megabytes / 200, "decode", gcode, "--json");
        yield return Whole($"`convert` without a change, {size}", megabytes / 200, "convert", gcode, "-o", output);
        yield return Whole($"`convert --e-mode relative`, {size}", megabytes / 300, "convert", gcode, "--e-mode", "relative", "-o", output);
        yield return Whole($"`convert --move 10,5`, {size}", megabytes / 300, "convert", gcode, "--move", "10,5", "-o", output);
        yield return Whole($"`convert --scale 0.5`, {size}", megabytes / 300, "convert", gcode, "--scale", "0.5", "-o", output);
        yield return Whole($"`convert --speed 90%`, {size}", megabytes / 300, "convert", gcode, "--speed", "90%", "-o", output);
        yield return Whole($"`convert --decimals 2,4,0`, {size}", megabytes / 300, "convert", gcode, "--decimals", "2,4,0", "-o", output);
    }

    private static IEnumerable<Target> Helix(string program, string work)
    {
        var csv = Path.Combine(work, "helix.csv");
        using (var text = new StreamWriter(csv))
        {
            text.WriteLine("x,y,z");
            for (var i = 0; i <= 1_000_000; i++)
            {
                var angle = i * 2 * Math.PI / 1000;
                text.WriteLine(string.Create(CultureInfo.InvariantCulture,
                    $"{110 + 40 * Math.Cos(angle):0.000},{110 + 40 * Math.Sin(angle):0.000},{0.2 + i * 2e-4:0.0000}"));
            }
        }
        var script = Path.Combine(work, "helix.turtle");
        File.WriteAllText(script, "start 110 70 0.2\nrepeat 1000000 [ forward_lift 0.25 0.0002; left 0.36 ]\n");
        var output = Path.Combine(work, "h.gcode");
        var curves = ProcessRuns.Of(program, ["curves", csv, "-o", output], 3);
        yield return new Target("`curves`, a helix of 10⁶ points from CSV, checked and written", "s", 0.8, curves.Wall, curves.Remark);
        var turtle = ProcessRuns.Of(program, ["turtle", script, "-o", output], 3);
        yield return new Target("`turtle`, a helix of 10⁶ strings from a script, checked and written", "s", 0.8, turtle.Wall, turtle.Remark);
    }

    private static IEnumerable<Target> Motion()
    {
        var free = GC.GetTotalMemory(true);
        var toolpath = Samples.Print(2_500_000);
        yield return new Target("memory of a move of a toolpath", "bytes", double.NaN, (GC.GetTotalMemory(true) - free) / (double)toolpath.Count);
        foreach (var rule in new[] { Cornering.JunctionDeviation, Cornering.Jerk, Cornering.SquareCornerVelocity })
        {
            var setup = new PrintSetup { Printer = new Printer { Cornering = rule } };
            yield return new Target($"timeline of 2.5 million moves, {rule}", "s", 0.3, Time(() => Timeline.Of(toolpath, setup)));
        }
        var timeline = Timeline.Of(toolpath, new PrintSetup());
        const int Steps = 1_000_000;
        var sum = 0.0;
        var before = GC.GetAllocatedBytesForCurrentThread();
        var seconds = Time(() =>
        {
            for (var i = 0; i < Steps; i++) sum += timeline.AtFraction(i * 0.618 % 1).Time;
        });
        var allocated = (GC.GetAllocatedBytesForCurrentThread() - before) / Steps;
        yield return new Target("one seek in it", "µs", 10, seconds / Steps * 1e6, double.IsFinite(sum) ? "" : "?");
        yield return new Target("memory of the state at a step of a slider", "bytes", 0, allocated);
    }

    private static IEnumerable<Target> Checks()
    {
        var toolpath = Samples.Print(1_000_000);
        yield return new Target("all checks of a million moves, collisions among them", "s", 2, Time(() => PrintCheck.Run(toolpath, new PrintSetup())));
    }

    // Processor time by itself, one thread, against writing; and the time for which one waits longer, as both go on at once.
    private static IEnumerable<Target> Guard()
    {
        var times = GuardTimes.Measure(15);
        var (writing, reading, both) = (times.Writing, times.Reading, times.Both);
        yield return new Target("read-back of a million moves (decoded, compared) against half of writing them, processor time", "s", writing.Processor / 2,
            reading.Processor, string.Create(CultureInfo.InvariantCulture,
                $"writing {writing.Processor:0.000} s, {reading.Processor / writing.Processor:0.00} × of it, one thread each"));
        yield return new Target("time that reading back adds to writing them, both at once", "s", writing.Wall / 2, both.Wall - writing.Wall,
            string.Create(CultureInfo.InvariantCulture,
                $"writing {writing.Wall:0.000} s, written, read and compared in {both.Wall:0.000} s: {both.Wall / writing.Wall - 1:0.00} × more"));
    }

    private static IEnumerable<Target> Meshes(string program, string folder, string work)
    {
        var mesh = Path.Combine(folder, "igea.ply");
        if (!File.Exists(mesh)) yield break;
        var output = Path.Combine(work, "m.gcode");
        (string What, string[] Options)[] kinds =
        [
            ("2 walls, 20 % infill", ["--set", "infill_density_percent=20", "--set", "top_layers=0", "--set", "bottom_layers=0"]),
            ("skins, seams, bridges, supports", ["--set", "support=grid"]),
            ("walls only", ["--set", "infill_density_percent=0", "--set", "top_layers=0", "--set", "bottom_layers=0"]),
            ("spiral vase", ["--set", "spiral_vase=true"]),
        ];
        foreach (var (what, options) in kinds)
        {
            var runs = ProcessRuns.Of(program, ["slice", mesh, .. options, "-o", output, "--override", "benchmark"], 3);
            yield return new Target($"`slice` of igea (268,686 triangles): {what}", "s", double.NaN, runs.Wall, runs.Remark);
            yield return new Target($"its peak memory: {what}", "MB", 150, runs.Peak);
        }
    }

    // Its peak memory is to be below that of other slicers: bench/peers.sh with the same mesh.
    private static IEnumerable<Target> LargeMesh(string program, string work)
    {
        var mesh = Path.Combine(work, "sphere.stl");
        Samples.WriteSphere(500_000, mesh);
        var runs = ProcessRuns.Of(program, ["slice", mesh, "--set", "infill_density_percent=20", "--set", "top_layers=0", "--set", "bottom_layers=0",
            "-o", Path.Combine(work, "sphere.gcode"), "--override", "benchmark"], 3);
        yield return new Target("`slice` of a sphere of 500,000 triangles: 2 walls, 20 % infill", "s", double.NaN, runs.Wall, runs.Remark);
    }

    // Median of five in seconds, after one to warm up.
    private static double Time(Action work)
    {
        work();
        return ProcessRuns.Median(Enumerable.Range(0, 5).Select(_ =>
        {
            var watch = Stopwatch.StartNew();
            work();
            return watch.Elapsed.TotalSeconds;
        }));
    }
}
