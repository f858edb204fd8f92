using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Drawings;
using Caterpillar.Examples;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using Caterpillar.Tests.Geometry.Curves;
using NUnit.Framework;

namespace Caterpillar.Tests.Examples;

public class ExampleCurveTests
{
    public static IEnumerable<string> Names => ExampleCurves.All.Select(c => c.Name);

    [TestCaseSource(nameof(Names))]
    public void The_generator_reproduces_the_bytes(string name)
        => Assert.That(ExampleCurves.All.Single(c => c.Name == name).Make().SequenceEqual(File.ReadAllBytes(PathOf(name))),
            "run: dotnet run --project examples/make");

    [Test]
    public void The_generator_reproduces_the_map_of_the_globe()
        => Assert.That(WorldMap.ToPng().SequenceEqual(File.ReadAllBytes(Path.Combine(TestData.Repository, "examples", "turtle", WorldMap.FileName))));

    [TestCase("pimples.json", "generic", true)]
    [TestCase("thick_cup.csv", "generic", false)]
    [TestCase("calligraphy.svg", "pen_plotter", false)]
    public void Example_curves_are_written_as_the_golden_bytes(string name, string printer, bool arcs)
    {
        foreach (var culture in new[] { "de-DE", "tr-TR", "ar-SA" })
            Golden.Check("curves/" + Path.GetFileNameWithoutExtension(name) + ".gcode", Golden.Under(culture, () => Write(name, printer, arcs)));
    }

    [Test]
    public void Pimples_are_full_circles_on_every_second_band()
    {
        var curves = Read("pimples.json", new PrintSetup());
        Assert.That(curves, Has.Count.EqualTo(60));
        Assert.That(curves[0].Curve.Length, Is.EqualTo(2 * Math.PI * 20).Within(1e-3));
        Assert.That(curves[3].Curve.Length, Is.EqualTo(2 * Math.PI * (20 + 12 * 0.9)).Within(1e-2));
        Assert.That(curves.All(c => c.Curve.IsClosed));
        // The path goes into its circles and out of them without a corner.
        Assert.That(CurveMaker.Kinks(curves[3].Curve, 1), Is.Empty);
    }

    [Test]
    public void The_thick_cup_deposits_what_its_columns_state()
    {
        var path = CurvePaths.ToPaths(Read("thick_cup.csv", new PrintSetup())).Value!.Single();
        // Width, height and flow beyond the first turn.
        Assert.That(path.BeadOf(path.SegmentCount - 1).Area, Is.EqualTo(2.4 * 1.2 * 1.3).Within(1e-9));
        Assert.That(path.BeadOf(0).Area, Is.LessThan(2.4 * 0.45 * 1.3));
        Assert.That(path.End.Z, Is.EqualTo(0.4 + 40 * 1.2).Within(1e-9));
    }

    private static byte[] Write(string name, string printer, bool arcs)
    {
        var setup = new ProfileLibrary().Setup(printer, values: ["sort_paths=false", "nozzle_diameter_mm=" + (name == "thick_cup.csv" ? "2.4" : "0.4")]).Value!;
        var plain = CurveOptions.From(setup.Settings);
        var options = plain with { Shape = BeadShape.Rectangle, Subdivision = plain.Subdivision with { KeepArcs = arcs } };
        var curves = Read(name, setup);
        var bounds = curves.Aggregate(Bounds.Empty, (b, c) => b.Include(c.Curve.Bounds));
        var center = Affine.Move((setup.Printer.BuildBounds.Center - bounds.Center).WithZ(0));
        var steps = CurvePaths.ToSteps(curves.Select(c => c with { Curve = c.Curve.Transformed(center) }).ToArray(), options);
        Assert.That(steps.Diagnostics, Is.Empty);
        var written = SafeWriter.ToDocument(Planner.Plan(steps.Value!, setup).Value!, setup);
        Assert.That(written.Diagnostics.Where(d => d.Severity != Severity.Note), Is.Empty);
        return written.Value!.ToBytes();
    }

    private static IReadOnlyList<UserCurve> Read(string name, PrintSetup setup)
    {
        var read = CurveReader.Read(File.ReadAllBytes(PathOf(name)), name, new CurveReadOptions { SpeedReference = setup.Settings.PrintSpeed });
        Assert.That(read.Diagnostics, Is.Empty);
        return read.Value!;
    }

    private static string PathOf(string name) => Path.Combine(TestData.Repository, "examples", "curves", name);
}
