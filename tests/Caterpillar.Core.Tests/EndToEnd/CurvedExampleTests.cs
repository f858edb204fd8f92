using System.Linq;
using Caterpillar.Examples;
using Caterpillar.GCode;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.EndToEnd;

/// <summary>The curved examples of the manual: the same bytes everywhere, checked, and simulated to their end.</summary>
public class CurvedExampleTests
{
    // The others take longer: dotnet run --project examples/make -- --curved.
    private static readonly string[] Names = ["terrain", "overhang", "vase"];

    [TestCaseSource(nameof(Names))]
    public void Curved_examples_give_the_golden_bytes_pass_the_checks_and_can_be_simulated(string name)
    {
        var report = CurvedReport.Of(CurvedExamples.All.Single(e => e.Name == name).Make());
        Golden.Check("curved/" + name + ".gcode", Golden.Under("tr-TR", () => NewFile.Of(report.Toolpath)));
        Assert.That(report.Unexpected(name), Is.Empty);
        var printed = report.Toolpath.Moves().Where(m => m.Kind == MoveKind.Print).ToArray();
        Assert.That(printed.Select(m => m.End.Z).Distinct().Count(), Is.GreaterThan(300), "The layers are curved.");
        Assert.That(printed.Min(m => m.End.Z), Is.GreaterThan(0));
        Assert.That(report.Duration, Is.InRange(30, 20_000));
    }
}
