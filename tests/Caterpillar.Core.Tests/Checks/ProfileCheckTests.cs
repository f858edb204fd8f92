using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>A square of extrusions in the middle of the bed passes all checks on every printer that is shipped, with its start and end code.</summary>
public class ProfileCheckTests
{
    private static readonly ProfileLibrary Library = new();

    public static IEnumerable<string> Printers() => Library.Names<Printer>();

    [TestCaseSource(nameof(Printers))]
    public void A_small_print_passes_on_every_shipped_printer(string name)
    {
        var setup = Library.Setup(name).OrThrow();
        var (height, center) = (setup.Settings.FirstLayerHeight, setup.Printer.BuildBounds.Center);
        var bead = new Bead(setup.Settings.LineWidth * height, height, Math.Min(20, setup.MaxFlow / (setup.Settings.LineWidth * height)));
        if (setup.Printer.ExtrusionUnit == ExtrusionUnit.None) bead = new Bead(0, 0, 20);
        Vec3 At(double x, double y) => new(center.X + x, center.Y + y, height);
        var path = new PrintPath([At(-10, -10), At(10, -10), At(10, 10), At(-10, 10), At(-10, -9)], bead);
        var plan = Planner.Plan([new PathStep(path)], setup).OrThrow();
        var written = SafeWriter.ToDocument(plan, setup);
        Assert.That(written.Diagnostics.Where(d => d.Severity != Severity.Note), Is.Empty);
        var read = SmallPrint.Decode(written.Value!.ToBytes(), setup);
        Assert.That(PrintCheck.Run(read, setup).Where(d => d.Severity == Severity.Error), Is.Empty);
    }
}
