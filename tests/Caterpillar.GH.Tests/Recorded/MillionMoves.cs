using System;
using System.Diagnostics;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.GH.Components.Simulate;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Parameters;
using NUnit.Framework;
using Rhino.Display;

namespace Caterpillar.GH.Tests.Measured;

/// <summary>What a print of a million moves costs each frame and each step of a slider. It prints figures and asserts none.</summary>
[Explicit("Prints figures for bench/RESULTS.md.")]
public sealed class MillionMoves
{
    private ToolpathGoo _print = null!;

    [OneTimeSetUp]
    public void Make()
    {
        // 400 layers of a wavy ring.
        var bead = Bead.FromWidth(0.45, 0.2, 1, 60, BeadShape.Stadium);
        var steps = Enumerable.Range(0, 400).Select(i => (Step)new PrintPath(Enumerable.Range(0, 2500).Select(k =>
        {
            var angle = k * 2 * Math.PI / 2500;
            var radius = 60 + 3 * Math.Sin(40 * angle + i * 0.05);
            return new Vec3(110 + radius * Math.Cos(angle), 110 + radius * Math.Sin(angle), 0.2 + 0.2 * i);
        }), bead, closed: true) { Role = Role.OuterWall, Layer = new Layer(i, 0.2 + 0.2 * i, 0.2) }).ToArray();
        var setup = new PrintSetup();
        _print = new ToolpathGoo(Planner.Plan(steps, setup).Value!, setup);
    }

    [Test]
    public void A_step_of_a_slider()
    {
        var canvas = new Canvas<SimulateComponent>().Feed("Toolpath", _print);
        var slider = new Param_Number();
        canvas.Document.AddObject(slider, false);
        canvas.Input("Position").AddSource(slider);
        slider.SetPersistentData(0.0);
        canvas.Solve();
        var times = new double[200];
        var bytes = new long[200];
        for (var i = 0; i < times.Length; i++)
        {
            slider.SetPersistentData(i * 37 % 200 / 199.0);
            slider.ExpireSolution(false);
            var before = Allocated;
            times[i] = Milliseconds(() => canvas.Solve());
            bytes[i] = Allocated - before;
        }
        Array.Sort(times);
        Array.Sort(bytes);
        TestContext.Out.WriteLine($"Simulate, {_print.Value.Count} moves, 200 positions: median {times[100]:0.00} ms, 95 % {times[190]:0.00} ms, most "
            + $"{times[199]:0.00} ms; memory of a step: median {bytes[100] / 1024} KB, 95 % {bytes[190] / 1024} KB");
        Frame("Simulate", canvas.Component);
    }

    [TestCase(PreviewMode.Lines)]
    [TestCase(PreviewMode.TravelAndSeam)]
    public void A_frame(PreviewMode mode)
    {
        var canvas = new Canvas<ToolpathPreviewComponent>().Feed("Toolpath", _print);
        if (mode == PreviewMode.TravelAndSeam) canvas.Feed("Travel", true).Feed("Seam", true).Feed("Setup", "generic").Feed("Color By", "Layer");
        TestContext.Out.WriteLine($"Toolpath Preview {mode}: first solve {Milliseconds(() => canvas.Solve()):0} ms, again "
            + $"{Milliseconds(() => Again(canvas)):0.0} ms");
        Frame("Toolpath Preview", canvas.Component);
    }

    public enum PreviewMode
    {
        Lines,
        TravelAndSeam,
    }

    private static long Allocated
#if NET
        => GC.GetAllocatedBytesForCurrentThread();
#else
        => GC.GetTotalMemory(false);
#endif

    private static void Again(Canvas<ToolpathPreviewComponent> canvas)
    {
        canvas.Component.ExpireSolution(false);
        canvas.Solve();
    }

    private static void Frame(string name, GH_Component component)
    {
        var display = new DisplayPipeline();
        var args = new HeadlessPreviewArgs(new GH_Document(), display);
        var drawing = Milliseconds(() =>
        {
            component.DrawViewportWires(args);
            component.DrawViewportMeshes(args);
        });
        var box = Enumerable.Range(0, 101).Select(_ => Milliseconds(() => component.ClippingBox.GetHashCode())).OrderBy(t => t).ElementAt(50);
        TestContext.Out.WriteLine($"{name}: {display.Calls.Count} draw calls in {drawing:0.00} ms, ClippingBox {box:0.0000} ms");
    }

    private static double Milliseconds(Action action)
    {
        var watch = Stopwatch.StartNew();
        action();
        return watch.Elapsed.TotalMilliseconds;
    }
}
