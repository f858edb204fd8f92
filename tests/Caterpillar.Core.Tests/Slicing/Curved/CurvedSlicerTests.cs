using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing.Curved;

public class CurvedSlicerTests
{
    private static double Tilted(double x, double y) => 0.2 * x + 0.1 * y;

    private static double Wave(double x, double y) => 1.5 * Angle.Sin(12 * x);

    private static double Bowl(double x, double y) => (x * x + y * y) / 60;

    // The part lies between two copies of the plan, so that every layer is whole: 12 layers of 0.5 mm.
    [TestCase("tilted")]
    [TestCase("wave")]
    [TestCase("bowl")]
    public void Layers_parallel_to_a_plan_have_its_height_and_the_volume_of_the_part(string plan)
    {
        Func<double, double, double> surface = plan switch { "tilted" => Tilted, "wave" => Wave, _ => Bowl };
        var box = CurvedSolids.Plan(-15, -10, 15, 10);
        var part = CurvedSolids.Between(box, 120, (x, y) => surface(x, y) + 5, (x, y) => surface(x, y) + 11);
        var field = LayerField.Vertical(PlanSurface.Of(surface, plan == "tilted" ? double.PositiveInfinity : 2));
        var layers = CurvedSolids.Slice(field, CurvedSolids.Massive, part);
        Assert.That(layers, Has.Count.EqualTo(12));
        for (var i = 0; i < layers.Count; i++)
        {
            foreach (var p in CurvedSolids.Points(layers[i])) Assert.That(p.Z, Is.EqualTo(surface(p.X, p.Y) + 5 + 0.5 * (i + 1)).Within(1e-6));
            Assert.That(CurvedSolids.Volume(layers[i]), Is.EqualTo(30 * 20 * 0.5).Within(1).Percent, $"layer {i}");
        }
    }

    [TestCase("level")]
    [TestCase("function")]
    public void The_field_z_gives_the_print_of_the_planar_slicer(string kind)
    {
        var setup = new PrintSetup().With("layer_height_mm=0.3", "infill_percent=15").OrThrow();
        var models = ModelPlacement.OnBed(
        [
            new("cone", Solids.Cone(0, 12, 9, 5)), new("block", Solids.Block(20, -5, 0, 30, 5, 4)), new("roof", Solids.Cone(5, 3, 8, 10).Moved(new Vec3(50, 0, -5))),
        ], new Vec3(110, 110));
        var field = kind == "level" ? LayerField.Level : LayerField.Of(p => p.Z, double.PositiveInfinity);
        if (kind == "function") setup = setup with { Settings = setup.Settings with { SkirtLoops = 0, CurvedMaxSlope = 5 } };
        var curved = Decoded(CurvedSlicer.Slice(models, field, setup).OrThrow(), setup);
        var planar = Decoded(PlanarSlicer.Slice(models, setup.Settings).OrThrow(), setup);
        Assert.That(curved.Count, Is.EqualTo(planar.Count));
        for (var i = 0; i < planar.Count; i++)
        {
            Assert.That(curved[i].End.DistanceTo(planar[i].End), Is.LessThan(1e-3), $"move {i}");
            Assert.That(curved[i].E, Is.EqualTo(planar[i].E).Within(Math.Max(1e-5, 1e-4 * Math.Abs(planar[i].E))), $"move {i}");
            Assert.That(curved[i].Kind, Is.EqualTo(planar[i].Kind), $"move {i}");
        }
    }

    private static Toolpath Decoded(SliceResult slices, PrintSetup setup)
    {
        var document = SafeWriter.ToDocument(Planner.Plan(slices.ToSteps(), setup).OrThrow(), setup).OrThrow();
        return GCodeDecoder.Decode(document).OrThrow().Toolpath;
    }
}
