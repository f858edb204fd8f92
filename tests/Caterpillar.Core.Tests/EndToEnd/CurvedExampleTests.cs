using System.Linq;
using Caterpillar.Examples;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.EndToEnd;

/// <summary>The curved examples of the manual: the same bytes everywhere, checked as they are made, and simulated to their end.</summary>
public class CurvedExampleTests
{
    // The others take longer, and are checked when their pictures are drawn.
    private static readonly string[] Names = ["terrain", "ribs", "vase"];

    [Test]
    public void Curved_examples_give_the_golden_bytes_and_can_be_simulated([ValueSource(nameof(Names))] string name)
    {
        var toolpath = CurvedExamples.All.Single(e => e.Name == name).Make();
        Golden.Check("curved/" + name + ".gcode", Golden.Under("tr-TR", () => GCodeWriter.ToBytes(toolpath)));
        var printed = toolpath.Moves().Where(m => m.Kind == MoveKind.Print).ToArray();
        Assert.That(printed.Select(m => m.End.Z).Distinct().Count(), Is.GreaterThan(300), "The layers are curved.");
        Assert.That(printed.Min(m => m.End.Z), Is.GreaterThan(0));
        var statistics = PrintStatistics.Of(Timeline.Of(toolpath, new PrintSetup()));
        Assert.That(statistics.Duration, Is.InRange(30, 20_000));
    }
}
