using System;
using System.Diagnostics;
using Caterpillar.Geometry;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Slice;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Measured;

/// <summary>
/// How long the first solve takes in a fresh process, when everything has still to be compiled, and the same solve again. It prints figures and asserts none.
/// Run it alone: what ran before it is compiled already.
/// </summary>
[Explicit("Prints figures for bench/RESULTS.md.")]
public sealed class FirstSolve
{
    [Test]
    public void Slice_plan_write_and_decode()
    {
        for (var run = 0; run < 3; run++)
        {
            var document = new GH_Document();
            var slice = new Canvas<PlanarSlicerComponent>(document).Feed("Geometry", Shapes.Box(height: 10));
            Time("slice", document);
            var plan = new Canvas<PlanToolpathComponent>(document).Feed("Setup", "ender3");
            plan.Input("Steps").AddSource(slice.Output("Print Paths"));
            Time("plan", document);
            var write = new Canvas<GenerateGCodeComponent>(document);
            write.Input("Toolpath").AddSource(plan.Output("Toolpath"));
            Time("check and write", document);
            var decode = new Canvas<DecodeGCodeComponent>(document);
            decode.Input("G-code").AddSource(write.Output("G-code"));
            Time("decode", document);
            TestContext.Out.WriteLine($"{decode.One<Toolpath>("Toolpath").Count} moves");
        }
    }

    private static void Time(string what, GH_Document document)
    {
        var processor = Process.GetCurrentProcess().TotalProcessorTime;
        var watch = Stopwatch.StartNew();
        document.NewSolution(false);
        var spent = Process.GetCurrentProcess().TotalProcessorTime - processor;
        TestContext.Out.WriteLine(FormattableString.Invariant(
            $"{what}: {watch.Elapsed.TotalMilliseconds:0} ms, {spent.TotalMilliseconds:0} ms of the processor"));
    }
}
