using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Examples;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Shaping;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Traces;

/// <summary>Kanada's worked examples as G-code.</summary>
public class KanadaGCodeTests
{
    public static IEnumerable<string> Names => Rounds.Some(KanadaParts.All.Select(p => p.Name), 2);

    [TestCaseSource(nameof(Names))]
    public void Parts_give_the_same_code_everywhere(string name)
    {
        var setup = new PrintSetup();
        var toolpath = Golden.Under("tr-TR", () => Plan(name, setup));
        if (!Rounds.OnMono) Assert.That(PrintCheck.Run(toolpath, setup).Where(d => d.Severity == Severity.Error), Is.Empty, "it fits on a printer");
        Golden.Check($"traces/{name}.gcode", Golden.Under("ar-SA", () => NewFile.Of(toolpath)));
    }

    private static Toolpath Plan(string name, PrintSetup setup)
    {
        var center = setup.Printer.BuildBounds.Center.WithZ(0);
        var paths = KanadaParts.All.Single(p => p.Name == name).Make();
        var placed = Deformation.Cartesian(p => p + center).Apply(paths).Value!;
        var plan = Planner.Plan(placed.Select(p => (Step)p).ToArray(), setup);
        Assert.That(plan.Diagnostics.Where(d => d.Severity != Severity.Note), Is.Empty);
        return plan.Value!;
    }
}
