using System;
using System.Threading;
using Caterpillar.Jobs;
using Caterpillar.Machines;

namespace Caterpillar.Examples.CSharp;

/// <summary>Slices a model with diagnostics, progress and cancellation.</summary>
public static class SliceWithProgress
{
    public static bool Run(string model, string output, IProgress<double> progress, CancellationToken cancel)
    {
        var setup = new ProfileLibrary().Setup("generic").OrThrow();
        var sliced = PrintJob.Slice(model, setup, options: null, progress, cancel);
        foreach (var diagnostic in sliced.Diagnostics) Console.WriteLine(diagnostic);
        using var print = sliced.Value;
        return print?.WriteFile(output, reason: null, progress, cancel).Value is not null;
    }
}
