using Caterpillar.Jobs;
using Caterpillar.Machines;

namespace Caterpillar.Examples.CSharp;

/// <summary>Prints the curves of a file (CSV, JSON, SVG, or lines of OBJ) in their order.</summary>
public static class CurveFile
{
    public static void Run(string curves, string output)
    {
        var setup = new ProfileLibrary().Setup("generic").OrThrow();
        PrintJob.Curves(curves, setup).OrThrow().WriteFile(output).OrThrow();
    }
}
