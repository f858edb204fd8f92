using System;
using System.IO;
using System.Linq;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Path;
using Caterpillar.GH.Components.Setup;
using Caterpillar.GH.Components.Simulate;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Host;

/// <summary>A session of a user who prints two drawn curves: one with a width at each vertex; between them the fan starts and the head waits.</summary>
[Category("Host")]
public sealed class CurvesSessionTests
{
    private readonly string _file = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N") + ".gcode");

    [TearDown]
    public void TearDown() => File.Delete(_file);

    [Test]
    public void Widths_of_vertices_and_events_between_curves_are_in_the_saved_file()
    {
        var document = new GH_Document();
        var setup = new Canvas<PrintSetupComponent>(document).Feed("Printer", "ender3");
        // Drawn flat, as in Rhino's Top view: 40 mm at a width that grows from 0.4 to 0.8 mm, and a line of 40 mm beside it.
        var swelling = new Canvas<ConstructPrintPathComponent>(document).Feed("Widths", 0.4, 0.6, 0.8).Feed("Heights", 0.2).Feed("Speeds", 20.0)
            .Feed("Curve", new Rg.PolylineCurve(new Rg.Point3d[] { new(80, 100, 0), new(100, 100, 0), new(120, 100, 0) }));
        var line = new Canvas<ConstructPrintPathComponent>(document).Feed("Curve", new Rg.LineCurve(new Rg.Point3d(80, 110, 0), new Rg.Point3d(120, 110, 0)));
        var fan = new Canvas<StepComponent>(document).Feed("Kind", "Fan").Feed("Fan Speed", 0.5);
        var wait = new Canvas<StepComponent>(document).Feed("Kind", "Dwell").Feed("Duration", 2.0);
        var plan = new Canvas<PlanToolpathComponent>(document).Feed("Sort", "None");
        var preview = new Canvas<ToolpathPreviewComponent>(document).Feed("Color By", "Width");
        var check = new Canvas<CheckComponent>(document);
        var save = new Canvas<SaveGCodeComponent>(document).Feed("File", _file).Feed("Save", false);
        swelling.Input("Setup").AddSource(setup.Output("Setup"));
        line.Input("Setup").AddSource(setup.Output("Setup"));
        foreach (var step in new[] { swelling.Output("Print Path"), fan.Output("Step"), wait.Output("Step"), line.Output("Print Path") })
            plan.Input("Steps").AddSource(step);
        preview.Input("Toolpath").AddSource(plan.Output("Toolpath"));
        check.Input("Toolpath").AddSource(plan.Output("Toolpath"));
        save.Input("G-code").AddSource(check.Output("Checked Toolpath"));

        document.NewSolution(false);
        Assert.That(document.Messages().Where(m => !m.Contains("The drawing is flat at Z 0. It is printed at Z 0.2")), Is.Empty);
        Assert.That(preview.All("Tags"), Has.Count.EqualTo(16), "The width grows evenly.");
        Assert.That(check.One<bool>("OK"), Is.True);
        save.Feed("Save", true).Solve();
        Assert.That(save.One<string>("Path"), Is.EqualTo(_file));

        var read = GCodeDecoder.Decode(GCodeDocument.ReadFile(_file).OrThrow(), new DecodeOptions { Flavor = FlavorTable.Marlin2, FilamentDiameter = 1.75 })
            .OrThrow().Toolpath;
        var prints = read.Moves().Where(m => m.Kind == MoveKind.Print && m.Start.X >= 79 && m.Start.Y >= 99).ToArray();
        Assert.That(prints.Select(m => m.End.Z), Is.All.EqualTo(0.2).Within(1e-9));
        var first = prints.Where(m => m.Start.Y < 105).ToArray();
        var second = prints.Where(m => m.Start.Y > 105).ToArray();
        Assert.That((first.Sum(m => m.Length), second.Sum(m => m.Length)), Is.EqualTo((40.0, 40.0)).Within(1e-6));
        Assert.That(first.Select(m => m.Speed), Is.All.EqualTo(20).Within(1e-6));
        // Beads with round sides: the area of a width is w h - (1 - pi / 4) h². The mean width is 0.6 mm.
        var area = 0.6 * 0.2 - (1 - Math.PI / 4) * 0.04;
        Assert.That(first.Sum(m => read.VolumeOf(m)!.Value) / 40, Is.EqualTo(area).Within(0.01 * area));
        double Area(Move move) => read.VolumeOf(move)!.Value / move.Length;
        Assert.That(Area(first.Last()) / Area(first.First()), Is.EqualTo(0.8 / 0.4).Within(0.4));
        var lines = File.ReadAllLines(_file);
        int At(Predicate<string> what) => Array.FindIndex(lines, what);
        int fans = At(l => l == "M106 S128" || l == "M106 S127"), waits = At(l => l.StartsWith("G4 ", StringComparison.Ordinal) && l.Contains("2"));
        Assert.That(fans, Is.GreaterThan(At(l => l.Contains("X120"))), "After the first curve.");
        Assert.That(waits, Is.GreaterThan(fans).And.LessThan(Array.FindLastIndex(lines, l => l.Contains("X120"))), "Before the second.");
    }
}
