using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Bench;

/// <summary>
/// What reading back costs the guard, beside writing: a million moves are written, what was written is decoded and compared with them by one thread, and both
/// is done at once, as the guard does. In turns, so that all of them see the machine alike; medians.
/// </summary>
internal sealed class GuardTimes
{
    private const int Moves = 1_000_000;
    private readonly Toolpath _plan = Samples.Print(Moves);
    // Nothing but the comparison with the plan.
    private readonly PrintSetup _setup = new()
    {
        Printer = new Printer
        {
            CheckSeverities = new(CheckCodes.All.Where(r => !PlanComparison.Codes.Contains(r.Code)).Select(r => new CheckSeverity(r.Code, null))),
        },
    };

    private readonly GCodeFormat _format;
    private readonly WrittenLines _lines = new();
    private readonly byte[] _text;

    private GuardTimes()
    {
        _format = SetupFormat.Of(_setup, _plan).Value ?? new GCodeFormat(_setup.Printer);
        using var memory = new MemoryStream();
        new GCodeWriter(_plan, _format) { Written = _lines }.WriteAll(memory);
        _text = memory.ToArray();
    }

    /// <summary>Times in seconds: by the clock, and of the processor.</summary>
    public (double Wall, double Processor) Writing { get; private init; }

    /// <inheritdoc cref="Writing"/>
    public (double Wall, double Processor) Reading { get; private init; }

    /// <inheritdoc cref="Writing"/>
    public (double Wall, double Processor) Both { get; private init; }

    public static GuardTimes Measure(int rounds)
    {
        var run = new GuardTimes();
        Action[] works = [run.Write, run.Read, run.WriteAndRead];
        var times = new List<(double Wall, double Processor)>[works.Length];
        for (var round = -1; round < rounds; round++)
        {
            for (var i = 0; i < works.Length; i++)
            {
                var time = Time(works[i]);
                // The first round only warms up.
                if (round < 0) times[i] = [];
                else times[i].Add(time);
            }
        }
        return new GuardTimes { Writing = Median(times[0]), Reading = Median(times[1]), Both = Median(times[2]) };
    }

    /// <summary>A table in Markdown.</summary>
    public static void Run()
    {
        var times = Measure(15);
        Console.WriteLine("| a million moves | by the clock | processor |");
        Console.WriteLine("|---|---|---|");
        Console.WriteLine(Row("written", times.Writing));
        Console.WriteLine(Row("read back: decoded and compared, one thread", times.Reading));
        Console.WriteLine(Row("written and read back at once", times.Both));
        Console.WriteLine(string.Create(CultureInfo.InvariantCulture,
            $"| reading back / writing | {times.Reading.Wall / times.Writing.Wall:0.00} | {times.Reading.Processor / times.Writing.Processor:0.00} |"));
        Console.WriteLine(string.Create(CultureInfo.InvariantCulture,
            $"| (both at once − writing) / writing | {times.Both.Wall / times.Writing.Wall - 1:0.00} | "
                + $"{times.Both.Processor / times.Writing.Processor - 1:0.00} |"));
    }

    private static string Row(string what, (double Wall, double Processor) time)
        => string.Create(CultureInfo.InvariantCulture, $"| {what} | {time.Wall:0.0000} s | {time.Processor:0.0000} s |");

    private void Write() => new GCodeWriter(_plan, _format).WriteAll(Stream.Null);

    private void Read()
    {
        var comparison = Compare(_lines);
        var blocks = 0;
        var options = new DecodeOptions
        {
            Flavor = _setup.Printer.Flavor, FilamentDiameter = _setup.Material.FilamentDiameter, Threads = 1,
            Take = block => Take(comparison, block, ref blocks),
        };
        comparison.End(GCodeDecoder.DecodeStream(new MemoryStream(_text), options).OrThrow().Toolpath, blocks);
    }

    private void WriteAndRead()
    {
        using var back = new ReadBack(_plan, _setup, _format, null, true, default);
        back.Write(_plan);
        back.End(_format);
        back.Finish(null);
    }

    private PlanComparison Compare(WrittenLines lines) => new(_plan, _format, lines, new Findings(_setup.Printer, _plan));

    private static void Take(PlanComparison comparison, DecodedBlock block, ref int blocks)
    {
        comparison.Take(block.Columns, block.Start);
        blocks++;
    }

    private static (double Wall, double Processor) Time(Action work)
    {
        GC.Collect();
        using var process = Process.GetCurrentProcess();
        var before = process.TotalProcessorTime;
        var watch = Stopwatch.StartNew();
        work();
        var wall = watch.Elapsed.TotalSeconds;
        process.Refresh();
        return (wall, (process.TotalProcessorTime - before).TotalSeconds);
    }

    private static (double Wall, double Processor) Median(List<(double Wall, double Processor)> times)
        => (ProcessRuns.Median(times.ConvertAll(t => t.Wall)), ProcessRuns.Median(times.ConvertAll(t => t.Processor)));
}
