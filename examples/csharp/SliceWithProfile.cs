using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;

namespace Caterpillar.Examples.CSharp;

/// <summary>Slices a model with a printer profile.</summary>
public static class SliceWithProfile
{
    public static void Run(string model, string output)
    {
        var setup = new ProfileLibrary().Setup("ender3", values: ["layer_height_mm=0.28"]).OrThrow();
        var meshes = MeshReader.Read(model).OrThrow().OnBed(setup.Printer);
        var layers = PlanarSlicer.Slice(meshes, setup.Settings).OrThrow();
        var toolpath = Planner.Plan(layers.ToSteps(), setup).OrThrow();
        SafeWriter.WriteFile(toolpath, setup, output).OrThrow();
    }
}
