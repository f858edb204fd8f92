using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using Caterpillar.GCode;
using Caterpillar.Flavors;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Tests.GCode;
using NUnit.Framework;

namespace Caterpillar.Tests.Simulation;

/// <summary>Times against the estimate that PrusaSlicer leaves in its files, with the limits of its own settings, normal and silent.</summary>
public class SlicerEstimateTests
{
    private const double Percent = 1;

    public static IEnumerable<string> Files() => GCodeFiles.Affordable().Where(f => f.StartsWith("ps_", StringComparison.Ordinal) || f == "none");

    [TestCaseSource(nameof(Files))]
    public void Times_are_those_of_PrusaSlicer_within_one_percent(string file)
    {
        var document = GCodeFiles.Document(file);
        var decoding = GCodeDecoder.Decode(document).Value!;
        var text = System.Text.Encoding.GetEncoding(28591).GetString(GCodeFiles.Bytes(file));
        var found = 0;
        foreach (var (mode, silent) in new[] { ("normal", false), ("silent", true) })
        {
            var match = Regex.Match(text, $@"estimated printing time \({mode} mode\) = (?:(\d+)h )?(?:(\d+)m )?(\d+)s");
            if (!match.Success) continue;
            found++;
            int Part(int i) => match.Groups[i].Success ? int.Parse(match.Groups[i].Value, System.Globalization.CultureInfo.InvariantCulture) : 0;
            var seconds = Part(1) * 3600 + Part(2) * 60 + Part(3);
            var timeline = Timeline.Of(decoding.Toolpath, new PrintSetup { Printer = SlicerLimits.Of(decoding.Settings, new Printer(), silent)! });
            TestContext.Out.WriteLine($"| {file} | {mode} | {seconds} | {timeline.Duration:F1} | {100 * (timeline.Duration / seconds - 1):+0.00;-0.00} % |");
            Assert.That(timeline.Duration, Is.EqualTo(seconds).Within(Percent).Percent, mode);
        }
        Assert.That(found, Is.GreaterThan(0));
    }
}
