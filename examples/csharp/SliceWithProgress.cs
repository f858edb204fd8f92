using System;
using System.Threading;
using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;

namespace Caterpillar.Examples.CSharp;

/// <summary>Shows what was noticed, reports progress, and can be canceled.</summary>
public static class SliceWithProgress
{
    public static bool Run(string model, string output, IProgress<double> progress, CancellationToken cancel)
    {
        var setup = new ProfileLibrary().Setup("generic").OrThrow();
        var read = MeshReader.Read(model, progress, cancel);
        foreach (var diagnostic in read.Diagnostics) Console.WriteLine(diagnostic);
        if (read.Value is not { } meshes) return false;
        var layers = PlanarSlicer.Slice(meshes.OnBed(setup.Printer), setup.Settings, options: null, progress, cancel).OrThrow();
        var toolpath = Planner.Plan(layers.ToSteps(), setup, options: null, progress, cancel).OrThrow();
        return SafeWriter.WriteFile(toolpath, setup, output, reason: null, progress, cancel).Value is not null;
    }
}
