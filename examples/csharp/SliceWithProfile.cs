using Caterpillar.Jobs;
using Caterpillar.Machines;

namespace Caterpillar.Examples.CSharp;

/// <summary>Slices a model with a printer profile.</summary>
public static class SliceWithProfile
{
    public static void Run(string model, string output)
    {
        var setup = new ProfileLibrary().Setup("ender3", values: ["layer_height_mm=0.28"]).OrThrow();
        using var print = PrintJob.Slice(model, setup).OrThrow();
        print.WriteFile(output).OrThrow();
    }
}
