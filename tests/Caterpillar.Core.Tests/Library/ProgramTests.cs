using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using Caterpillar.Checks;
using Caterpillar.Flavors;
using Caterpillar.Examples.CSharp;
using Caterpillar.Files;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Shaping;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Library;

/// <summary>The programs of <c>examples/csharp</c>, run, and what they make.</summary>
public sealed class ProgramTests : IDisposable
{
    private TemporaryFolder _folder = null!;

    private static string Bracket => Path.Combine(TestData.Repository, "examples", "models", "bracket.stl");

    private string Sliced => _folder.File("sliced.gcode");

    private string Output => _folder.File("output.gcode");

    [OneTimeSetUp]
    public void Slice()
    {
        _folder = new TemporaryFolder();
        SliceWithProfile.Run(Bracket, Sliced);
    }

    [OneTimeTearDown]
    public void Dispose() => _folder.Dispose();

    [Test]
    public void Slice_with_a_profile()
    {
        var file = Decoded(Sliced);
        var model = MeshReader.Read(Bracket).OrThrow().Single().Mesh;
        var box = new MoveFilter { Roles = [Role.OuterWall] }.BoundsIn(file.Toolpath);
        var printer = new ProfileLibrary().Printer("ender3").OrThrow();
        Assert.That((box.Center - printer.BuildBounds.Center).LengthXY, Is.EqualTo(0).Within(0.05));
        // The middle of the outer wall lies within half a line of the surface.
        Assert.That((box.Size.X, box.Size.Y), Is.EqualTo((model.Bounds.Size.X - 0.45, model.Bounds.Size.Y - 0.45)).Within(0.1));
        Assert.That(file.Toolpath.Layers.Skip(2).Take(9).Select(l => l.Thickness), Is.All.EqualTo(0.28).Within(1e-9));
    }

    [Test]
    [Category("Arithmetic")]
    public void Several_models()
    {
        SliceSeveral.Run([Bracket, Path.Combine(TestData.Repository, "examples", "models", "vase.stl")], Output);
        var layers = Decoded(Output).Toolpath.Layers;
        Assert.That(layers.Select(l => l.Object).Distinct(), Is.EquivalentTo(new[] { "bracket", "vase", "bracket (2)", "vase (2)" }));
    }

    [Test]
    public void Turtle_file()
    {
        TurtleFile.Run(Path.Combine(TestData.Repository, "examples", "turtle", "hilbert.turtle"), Output);
        var (_, length, _) = Part(Decoded(Output).Toolpath);
        // Three layers of 4^5 − 1 sides of 2 mm.
        Assert.That(length, Is.EqualTo(3 * 1023 * 2).Within(0.1));
    }

    [Test]
    public void Curve_file()
    {
        var file = _folder.File("bow.csv");
        File.WriteAllText(file, "x,y,z\n80,100,0.2\n110,140,0.2\n140,100,0.2\n");
        CurveFile.Run(file, Output);
        Assert.That(Part(Decoded(Output).Toolpath).Length, Is.EqualTo(100).Within(0.1));
    }

    [Test]
    public void Statistics()
    {
        var statistics = FileStatistics.Run(Sliced);
        Assert.That(statistics.PrintLength, Is.EqualTo(ToolpathTotals.Of(Decoded(Sliced).Toolpath).PrintLength).Within(0.1));
        Assert.That(statistics.Duration, Is.GreaterThan(statistics.PrintTime).And.GreaterThan(60));
    }

    [Test]
    public void Turtle_star()
    {
        TurtleStar.Run(Output);
        var (box, length, volume) = Part(Decoded(Output).Toolpath);
        // Ten layers of five sides of 40 mm, 0.6 × 0.2 mm.
        Assert.That(length, Is.EqualTo(2000).Within(0.1));
        Assert.That(volume, Is.EqualTo(2000 * 0.12).Within(0.3));
        Assert.That((box.Min.Z, box.Max.Z), Is.EqualTo((0.2, 2.0)).Within(1e-9));
        Assert.That(box.Size.X, Is.EqualTo(40).Within(0.01));
    }

    [Test]
    public void Trace_vase()
    {
        TraceVase.Run(Output);
        var toolpath = Decoded(Output).Toolpath;
        var box = Part(toolpath).Box;
        // 24 mm at the foot, a quarter more at half the height.
        Assert.That(box.Size.X, Is.EqualTo(60).Within(0.05));
        Assert.That(box.Max.Z, Is.EqualTo(60.2).Within(1e-3));
        var prints = toolpath.Moves().Where(IsPart).ToArray();
        Assert.That(prints[prints.Length - 1].Index - prints[0].Index, Is.EqualTo(prints.Length - 1), "nothing but extrusion between the first and the last");
    }

    [Test]
    public void Decode_edit_write()
    {
        EditFile.Run(Sliced, Output);
        var (before, after) = (Decoded(Sliced).Toolpath, Decoded(Output).Toolpath);
        Assert.That(after.Count, Is.EqualTo(before.Count));
        var pairs = before.Moves().Zip(after.Moves(), (a, b) => (Before: a, After: b)).ToArray();
        Assert.That(pairs.All(p => p.Before.End == p.After.End && p.Before.E == p.After.E));
        Assert.That(pairs.Where(p => p.Before.Role == Role.OuterWall && p.Before.Kind == MoveKind.Print).Select(p => p.After.Speed / p.Before.Speed),
            Is.All.EqualTo(0.5).Within(0.01));
        Assert.That(pairs.Where(p => p.Before.Role == Role.Infill && p.Before.Kind == MoveKind.Print).All(p => p.Before.Speed == p.After.Speed));
        var pause = after.Events.Single(e => e.Event is PauseEvent);
        Assert.That(after.Layers[after[pause.Move].Layer].Index, Is.EqualTo(12));
        // Lines without a speed are those of the input.
        var lines = new HashSet<string>(File.ReadAllLines(Sliced));
        Assert.That(File.ReadAllLines(Output).Where(l => !l.Contains("F")).Count(l => !lines.Contains(l)), Is.LessThanOrEqualTo(3));
    }

    [Test]
    public void Safe_edit()
    {
        var file = _folder.File("moved.gcode");
        Assert.That(SafeEdit.Run(Sliced, file).Select(d => d.Code), Is.SupersetOf(new[] { "bed.outside", SafeWriter.Refused }));
        Assert.That(File.Exists(file), Is.False);
    }

    [Test]
    public void Custom_path()
    {
        CustomPath.Run(Output);
        var (box, length, volume) = Part(Decoded(Output).Toolpath);
        Assert.That((box.Min.X, box.Max.X), Is.EqualTo((60.0, 160.0)).Within(1e-3));
        Assert.That(volume / length, Is.EqualTo(0.8 * 0.3).Within(1e-3));
    }

    [Test]
    public void Deform_a_file()
    {
        DeformFile.Run(Sliced, Output);
        var (before, after) = (Decoded(Sliced).Toolpath, Decoded(Output).Toolpath);
        Assert.That(after.Layers.Count, Is.EqualTo(before.Layers.Count));
        // The walls of the top layer are turned by as many degrees as they are mm high.
        var last = new MoveFilter { FirstLayer = before.Layers.Max(l => l.Index), Kinds = [MoveKind.Print] };
        var middle = MoveFilter.Prints.InLayersOf(before).BoundsIn(before).Center;
        var turned = last.BoundsIn(before.Transform(last, Turn(middle, last.BoundsIn(before).Max.Z)));
        var box = last.BoundsIn(after);
        Assert.That((box.Min - turned.Min).Length + (box.Max - turned.Max).Length, Is.LessThan(0.05));
        Assert.That(ToolpathTotals.Of(after).DepositedE, Is.EqualTo(ToolpathTotals.Of(before).DepositedE).Within(2).Percent);
    }

    [Test]
    [Category("Arithmetic")]
    public void Convert()
    {
        ConvertFile.Run(Sliced, Output);
        Assert.That(File.ReadAllLines(Output), Does.Contain("M83"));
        var klipper = GCodeDecoder.DecodeFile(Output, new DecodeOptions { Flavor = FlavorTable.Klipper }).OrThrow();
        var (before, after) = (ToolpathTotals.Of(Decoded(Sliced).Toolpath), ToolpathTotals.Of(klipper.Toolpath));
        Assert.That((after.PrintLength, after.DepositedE), Is.EqualTo((before.PrintLength, before.DepositedE)).Within(0.5));
    }

    [Test]
    public void Check()
    {
        Assert.That(CheckFile.Run(Sliced).Where(f => f.Contains("error")), Is.Empty);
        var bad = _folder.File("bad.gcode");
        File.WriteAllText(bad, "G28\nM109 S200\nM83\nG1 X300 Y10 Z0.2 F3000\nG1 X280 E1\n");
        Assert.That(CheckFile.Run(bad).First(), Does.StartWith("bad.gcode:4: error bed.outside").Or.StartWith("bad.gcode:4, move"));
    }

    [Test]
    public void A_file_that_does_not_state_its_filament_is_checked_with_that_of_the_material()
    {
        // 10 mm of filament over 1 mm at 50 mm/s: 1200 mm³/s.
        var file = GCodeDecoder.Decode(GCodeDocument.FromText("G28\nM109 S200\nM83\nG1 X50 Y50 Z0.2 F3000\nG1 X51 E10\n")).OrThrow();
        Assert.That(PrintCheck.Run(file, new PrintSetup()).Select(d => d.Code), Does.Contain("limit.flow"));
        Assert.That(SafeWriter.ToDocument(file, file.Toolpath, new PrintSetup()).Diagnostics.Select(d => d.Code), Does.Contain("limit.flow"));
    }

    [Test]
    [Category("Arithmetic")]
    public void ToolpathImage()
    {
        TurtleStar.Run(Output);
        var file = _folder.File("star.png");
        DrawImage.Run(Output, file);
        var image = ImageReader.Read(File.ReadAllBytes(file), "star.png").OrThrow();
        Assert.That((image.Width, image.Height), Is.EqualTo((960, 720)));
    }

    [Test]
    public void Progress_and_cancel()
    {
        var done = new Reported();
        Assert.That(SliceWithProgress.Run(Bracket, Output, done, default), Is.True);
        Assert.That(done.Last, Is.EqualTo(1).Within(0.2));
        var file = _folder.File("canceled.gcode");
        Assert.That(() => SliceWithProgress.Run(Bracket, file, done, new CancellationToken(true)), Throws.InstanceOf<OperationCanceledException>());
        Assert.That(File.Exists(file), Is.False);
    }

    // The start code prints its lines at the left edge of the bed.
    private static bool IsPart(Move move) => move.Kind == MoveKind.Print && move.End.X > 20;

    private static (Bounds Box, double Length, double Volume) Part(Toolpath toolpath)
    {
        var prints = toolpath.Moves().Where(IsPart).ToArray();
        return (prints.Aggregate(Bounds.Empty, (box, m) => box.Include(m.Bounds)), prints.Sum(m => m.Length), prints.Sum(m => toolpath.VolumeOf(m)!.Value));
    }

    private static Affine Turn(Vec3 about, double degrees)
        => Affine.Move(-about).Then(Affine.Rotate(Vec3.UnitZ, degrees)).Then(Affine.Move(about));

    private static DecodedGCode Decoded(string file) => GCodeDecoder.DecodeFile(file).OrThrow();

    private sealed class Reported : IProgress<double>
    {
        public double Last { get; private set; }

        public void Report(double value) => Last = value;
    }
}
