using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;

namespace Caterpillar.Examples;

/// <summary>A curved example, checked and simulated.</summary>
internal sealed class CurvedReport
{
    // On slopes, the flat nozzle tip touches. Some lines do not quite meet.
    private static readonly string[] Usual = [CheckCodes.Slope, CheckCodes.Gap];

    private static readonly Dictionary<string, string[]> Also = new(StringComparer.Ordinal)
    {
        // The spiral starts with a height of 0.
        ["vase"] = [CheckCodes.Width],

        // Some lines of the sparse infill begin at the fork of the branches.
        ["branching"] = [CheckCodes.Unsupported],
    };

    private CurvedReport(Toolpath toolpath, IReadOnlyList<Diagnostic> findings, double duration)
    {
        Toolpath = toolpath;
        Findings = findings;
        Duration = duration;
    }

    public Toolpath Toolpath { get; }

    public IReadOnlyList<Diagnostic> Findings { get; }

    /// <summary>Print time, s.</summary>
    public double Duration { get; }

    /// <summary>Generates, checks and simulates an example.</summary>
    public static CurvedReport Of(CurvedExample example)
        => new(example.Toolpath, PrintCheck.Run(example.Toolpath, example.Setup), PrintStatistics.Of(Timeline.Of(example.Toolpath, example.Setup)).Duration);

    /// <summary>Unexpected findings of the checks.</summary>
    public IEnumerable<Diagnostic> Unexpected(string name)
        => Findings.Where(f => f.Severity == Severity.Error || !(Usual.Contains(f.Code) || (Also.TryGetValue(name, out var codes) && codes.Contains(f.Code))));

    /// <summary>Writes a table of all examples. False if one has unexpected findings.</summary>
    public static bool WriteAll(TextWriter output)
    {
        var good = true;
        output.WriteLine("| example | printing moves | time of print | noted by the checks |");
        output.WriteLine("|---|---|---|---|");
        foreach (var (name, make, _, _) in CurvedExamples.All)
        {
            var report = Of(make());
            var moves = report.Toolpath.Moves().Count(m => m.Kind == MoveKind.Print).ToString("N0", CultureInfo.InvariantCulture);
            var time = TimeSpan.FromSeconds(Math.Round(report.Duration)).ToString(@"h\:mm\:ss", CultureInfo.InvariantCulture);
            output.WriteLine($"| {name} | {moves} | {time} | {string.Join(", ", report.Findings.Select(f => $"`{f.Code}`"))} |");
            foreach (var finding in report.Unexpected(name))
            {
                good = false;
                output.WriteLine($"Not expected: {finding}");
            }
        }
        return good;
    }
}
