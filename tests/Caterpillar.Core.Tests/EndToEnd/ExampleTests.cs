using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using NUnit.Framework;

namespace Caterpillar.Tests.EndToEnd;

/// <summary>Every example model gives the same bytes on every runtime, in every culture and with any number of threads.</summary>
public class ExampleTests
{
    private static readonly string[] Models = ["vase", "bracket", "saddle_roof", "terrain"];

    private static IEnumerable<TestCaseData> Cases()
        => Models.SelectMany((model, i) => Rounds.InTurn(["de-DE", "tr-TR", "ar-SA"], i, 1).Select(culture => Case(model, culture)));

    // The largest one takes half of the time of all.
    private static TestCaseData Case(string model, string culture)
        => model == "vase" ? new TestCaseData(model, culture).SetCategory("Arithmetic") : new TestCaseData(model, culture);

    [TestCaseSource(nameof(Cases))]
    public void Example_models_are_sliced_to_the_golden_bytes(string model, string culture)
        => Golden.Check("slice/" + model + ".gcode", Golden.Under(culture, () => Slice(model, culture == "tr-TR" ? 1 : 3)));

    [Category("Arithmetic")]
    [TestCase("none")]
    [TestCase("tree")]
    public void The_first_print_of_the_manual_has_no_findings(string support)
    {
        var setup = new ProfileLibrary().Setup("ender3", values: ["support=" + support]).OrThrow();
        using var job = PrintJob.Slice(Path.Combine(TestData.Repository, "examples", "models", "bracket.stl"), setup).OrThrow();
        var written = SafeWriter.ToDocument(job.Toolpath, setup);
        Assert.That(written.Diagnostics, Is.Empty);
    }

    private static byte[] Slice(string model, int threads)
    {
        var file = Path.Combine(TestData.Repository, "examples", "models", model + ".stl");
        // Coarser than a real print, to keep the test fast.
        var setup = new ProfileLibrary().Setup("generic", values: ["layer_height_mm=0.3", "first_layer_height_mm=0.3", "skirt_loops=1"]).Value!;
        var models = ModelPlacement.OnBed(MeshReader.Read(file).Value!, setup.Printer.BuildBounds.Center);
        var sliced = PlanarSlicer.Slice(models, setup.Settings, new SliceOptions { Threads = threads });
        Assert.That(sliced.Diagnostics.Where(d => d.Severity != Severity.Note), Is.Empty);
        var planned = Planner.Plan(sliced.Value!.ToSteps(), setup);
        var written = SafeWriter.ToDocument(planned.Value!, setup);
        Assert.That(written.Diagnostics.Where(d => d.Severity == Severity.Error), Is.Empty);
        return written.Value!.ToBytes();
    }
}
