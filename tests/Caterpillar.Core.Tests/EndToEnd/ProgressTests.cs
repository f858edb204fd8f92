using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Curved;
using Caterpillar.Display;
using Caterpillar.Drawings;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Shaping;
using Caterpillar.Slicing;
using Caterpillar.Tests.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.EndToEnd;

/// <summary>Long calls report numbers that ascend from 0 to 1 and end at 1.</summary>
public class ProgressTests
{
    private static readonly PrintSetup Setup = new();

    private static readonly Lazy<Toolpath> Planned = new(() =>
    {
        var block = new NamedMesh("block", Solids.Block(100, 100, 0, 120, 120, 12));
        return Planner.Plan(PlanarSlicer.Slice([block], Setup.Settings).OrThrow().ToSteps(), Setup).OrThrow();
    });

    [TestCase(1)]
    [TestCase(3)]
    public void Of_the_slicer(int models)
    {
        var meshes = Enumerable.Range(0, models).Select(i => new NamedMesh("block", Solids.Block(30 * i, 0, 0, 30 * i + 20, 20, 12))).ToArray();
        var reported = new Reported();
        PlanarSlicer.Slice(meshes, Setup.Settings, new SliceOptions { Threads = 2 }, reported).OrThrow();
        AssertAscending(reported, 8);
        // Sections are the first two fifths.
        Assert.That(reported.Values, Has.Some.InRange(0.399999, 0.400001));
    }

    [TestCase(null)]
    [TestCase("tested by hand")]
    public void Of_the_writer(string? reason)
    {
        var (drafted, written) = (new Reported(), new Reported());
        using var memory = new MemoryStream();
        SafeWriter.Write(Planned.Value, Setup, memory, reason, drafted, isDraft: true).OrThrow();
        AssertAscending(drafted, 3);
        SafeWriter.Write(Planned.Value, Setup, memory, reason, written).OrThrow();
        AssertAscending(written, 3);
    }

    [Test]
    public void Of_the_editor()
    {
        var decoding = GCodeDecoder.Decode(SafeWriter.ToDocument(Planned.Value, Setup).OrThrow()).OrThrow();
        var edited = decoding.Toolpath.ScaleSpeed(new MoveFilter { FirstLayer = 3 }, 0.5);
        var (editor, guarded, replaced) = (new Reported(), new Reported(), new Reported());
        GCodeEditor.ToDocument(decoding, edited, null, editor).OrThrow();
        AssertAscending(editor, 1);
        SafeWriter.ToDocument(decoding, edited, Setup, progress: guarded).OrThrow();
        AssertAscending(guarded, 3);
        SafeWriter.ToDocument(decoding, edited, Setup, code: new EditOptions { End = ["M84"] }, reason: "tested by hand", progress: replaced).OrThrow();
        AssertAscending(replaced, 3);
    }

    [Test]
    public void Of_the_report_of_sections()
    {
        var reported = new Reported();
        SectionReport.Of("block", Solids.Block(0, 0, 0, 20, 20, 12), [.. Enumerable.Range(1, 100).Select(i => 0.1 * i)], null, reported).OrThrow();
        AssertAscending(reported, 3);
    }

    [Test]
    public void Of_every_job()
    {
        var (curved, drawn, converted) = (new Reported(), new Reported(), new Reported());
        var block = new SliceModel(new NamedMesh("block", Solids.Block(100, 100, 0, 110, 110, 3)), Setup.Settings);
        PrintJob.Slice([block], LayerField.Of(p => p.Z), Setup, null, curved).OrThrow();
        AssertAscending(curved, 8);
        var (read, onto) = (new Reported(), new Reported());
        PrintJob.Slice(Path.Combine(TestData.Repository, "examples", "models", "bracket.stl"), Setup, null, read).OrThrow().Dispose();
        AssertAscending(read, 8);
        PrintJob.Slice([block], Setup, new PrintJobOptions { Onto = Solids.Block(90, 90, 0, 120, 120, 5) }, onto).OrThrow().Dispose();
        AssertAscending(onto, 8);
        var curves = Enumerable.Range(0, 600).Select(i => new UserCurve(new PolylineCurve([new Vec3(0, i), new Vec3(9, i)]))).ToArray();
        CurvePaths.ToSteps(curves, null, drawn).OrThrow();
        AssertAscending(drawn, 4);
        var file = GCodeDecoder.Decode(SafeWriter.ToDocument(Planned.Value, Setup).OrThrow()).OrThrow();
        using var memory = new MemoryStream();
        var conversion = new FileJob(file) { Target = new ConvertOptions { Flavor = FlavorTable.Marlin2, RelativeE = false } };
        conversion.Write(memory, "a.gcode", Setup, null, converted).OrThrow();
        AssertAscending(converted, 3);
    }

    [Test]
    public void Of_shares_of_what_is_merged_or_shown()
    {
        var (merged, shown) = (new Reported(), new Reported());
        var toolpath = Planner.Merge([Planned.Value, Planned.Value, Planned.Value], Setup, merged).OrThrow();
        Assert.That(merged.Values, Is.EqualTo(new[] { 1 / 3.0, 2 / 3.0, 1 }));
        ViewerPage.Write(new ViewerContent("a") { Toolpath = toolpath }, Stream.Null, shown);
        Assert.That(shown.Values, Is.Not.Empty.And.Ordered.And.All.InRange(0.0, 1.0));
    }

    [Test]
    public void Of_paths_that_are_shaped()
    {
        PrintPath[] paths = [.. Enumerable.Range(0, 4).Select(i => new PrintPath([new Vec3(0, i, 0.2), new Vec3(9, i, 0.2)], new Bead(0.1, 0.2)))];
        var (deformed, modulated, filled, projected) = (new Reported(), new Reported(), new Reported(), new Reported());
        Deformation.Cartesian(p => p * 2).Apply(paths, 0, deformed).OrThrow();
        new Modulation(ModulationMode.Flow, _ => 1, 1, 0.8).Apply(paths, modulated).OrThrow();
        new GapBead().Apply(paths, filled).OrThrow();
        SurfaceProjection.Project([.. paths.Select(p => new PathStep(p))], PlanSurface.Level(0), Setup, progress: projected).OrThrow();
        foreach (var reported in new[] { deformed, modulated, filled, projected }) Assert.That(reported.Values, Is.EqualTo(new[] { 0.25, 0.5, 0.75, 1 }));
    }

    private static void AssertAscending(Reported reported, int least)
    {
        Assert.That(reported.Values, Has.Count.AtLeast(least));
        Assert.That(reported.Values, Is.Ordered.And.All.InRange(0.0, 1.0));
        Assert.That(reported.Values.Last(), Is.EqualTo(1));
    }

    private sealed class Reported : IProgress<double>
    {
        public List<double> Values { get; } = [];

        public void Report(double value)
        {
            lock (Values) Values.Add(value);
        }
    }
}
