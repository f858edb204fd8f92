using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;

namespace Caterpillar.Examples.CSharp;

/// <summary>Slices several models, arranged on the bed: two copies of each at half size.</summary>
public static class SliceSeveral
{
    public static void Run(string[] models, string output)
    {
        var setup = new ProfileLibrary().Setup("generic").OrThrow();
        var placing = new ModelPlacing { Scale = new Vec3(0.5, 0.5, 0.5), Copies = 2, Spacing = 8 };
        using var print = PrintJob.Slice(models, setup, placing).OrThrow();
        print.WriteFile(output).OrThrow();
    }
}
