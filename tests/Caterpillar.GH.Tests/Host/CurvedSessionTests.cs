using System;
using System.IO;
using System.Linq;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Setup;
using Caterpillar.GH.Components.Simulate;
using Caterpillar.GH.Components.Slice;
using Caterpillar.GH.Goos;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Host;

/// <summary>A session of a user who prints a wedge in layers that divide the space between the bed and a slanted sheet.</summary>
[Category("Host")]
public sealed class CurvedSessionTests
{
    // The wedge is 3 mm high where it is highest.
    private const int Layers = 6;

    private static readonly PrintSettings Walls = new()
    {
        LayerHeight = 0.5, FirstLayerHeight = 0.5, LineWidth = 0.8, WallCount = 2, TopLayers = 0, BottomLayers = 0, InfillDensityPercent = 0, SkirtLoops = 0,
        PrintSpeed = 20, OuterWallSpeed = 20, FirstLayerSpeed = 20,
    };

    // The sheet rises by a twentieth from 2 mm at X 100.
    private static double Height(double x) => 2 + 0.05 * (x - 100);

    [Test]
    public void Between_two_surfaces_all_layers_rise_alike_from_model_to_saved_file()
    {
        var document = new GH_Document();
        var setup = new Canvas<PrintSetupComponent>(document).Feed("Settings", Walls);
        var printer = new Canvas<PrinterComponent>(document).Feed("Nozzle Diameter", 0.8);
        setup.Input("Printer").AddSource(printer.Output("Printer"));
        var field = new Canvas<LayerFieldComponent>(document).Feed("Kind", "Between").Feed("Surfaces", Sheet(_ => 0), Sheet(Height));
        var slicer = new Canvas<CurvedSlicerComponent>(document).Feed("Geometry", Wedge());
        var plan = new Canvas<PlanToolpathComponent>(document);
        var check = new Canvas<CheckComponent>(document);
        var preview = new Canvas<ToolpathPreviewComponent>(document).Feed("Color By", "Layer");
        var save = new Canvas<SaveGCodeComponent>(document).Feed("Save", false);
        slicer.Input("Setup").AddSource(setup.Output("Setup"));
        slicer.Input("Field").AddSource(field.Output("Field"));
        plan.Input("Steps").AddSource(slicer.Output("Print Paths"));
        check.Input("Toolpath").AddSource(plan.Output("Toolpath"));
        preview.Input("Toolpath").AddSource(plan.Output("Toolpath"));
        save.Input("G-code").AddSource(check.Output("Checked Toolpath"));
        var file = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N") + ".gcode");
        try
        {
            save.Feed("File", file).Solve();
            Assert.That(document.Messages(), Is.Empty);
            Assert.That((field.Component.Message, slicer.Component.Message), Is.EqualTo(("Between", $"{Layers} layers")));
            Assert.That(slicer.Paths("Walls"), Has.Length.EqualTo(Layers), "A branch for each layer.");
            for (var i = 0; i < Layers; i++)
            {
                var walls = slicer.Output("Walls").VolatileData.get_Branch(i).Cast<PrintPathGoo>();
                var parts = walls.SelectMany(w => w.Value.Points).Select(p => p.Z / Height(p.X)).ToArray();
                Assert.That(parts, Has.All.EqualTo((i + 1.0) / Layers).Within(0.02), "Layer " + i);
            }
            Assert.That(preview.All("Tags"), Has.Count.EqualTo(16));
            Assert.That(check.One<bool>("OK"), Is.True);
            save.Feed("Save", true).Solve();
            Assert.That(document.Messages(), Is.Empty);
            Assert.That(save.One<string>("Path"), Is.EqualTo(file));
            var read = GCodeDecoder.Decode(GCodeDocument.ReadFile(file).OrThrow(), new DecodeOptions { Flavor = FlavorTable.Marlin2, FilamentDiameter = 1.75 })
                .OrThrow().Toolpath;
            var prints = read.Moves().Where(m => m.Kind == MoveKind.Print && m.Layer >= 0 && m.Length > 1).ToArray();
            Assert.That(read.Layers, Has.Count.EqualTo(Layers));
            Assert.That(prints.Select(m => m.End.Z / Height(m.End.X) * Layers), Has.All.Matches<double>(k => Math.Abs(k - Math.Round(k)) < 0.1));
            // Where the wedge is higher, beads are thicker: their areas are as their heights.
            double Area(Func<Move, bool> where) => prints.Where(where).Average(m => read.VolumeOf(m)!.Value / m.Length);
            var (low, high) = (Area(m => m.End.X < 102 && m.Start.X < 102), Area(m => m.End.X > 118 && m.Start.X > 118));
            Assert.That(high / low, Is.EqualTo(Height(119) / Height(101)).Within(0.15));
        }
        finally
        {
            File.Delete(file);
        }
    }

    private static Rg.Mesh Sheet(Func<double, double> height)
    {
        var mesh = new Rg.Mesh();
        mesh.Vertices.UseDoublePrecisionVertices = true;
        foreach (var (x, y) in new[] { (95.0, 95.0), (125.0, 95.0), (125.0, 125.0), (95.0, 125.0) }) mesh.Vertices.Add(x, y, height(x));
        mesh.Faces.AddFace(0, 1, 2, 3);
        return mesh;
    }

    private static Rg.Mesh Wedge()
    {
        var box = Shapes.Box(100, 100, 20);
        var wedge = new Rg.Mesh();
        wedge.Vertices.UseDoublePrecisionVertices = true;
        wedge.Vertices.AddVertices(box.Vertices.ToPoint3dArray().Select(p => new Rg.Point3d(p.X, p.Y, p.Z > 0 ? Height(p.X) : 0)));
        for (var i = 0; i < box.Faces.Count; i++) wedge.Faces.AddFace(box.Faces[i]);
        return wedge;
    }
}
