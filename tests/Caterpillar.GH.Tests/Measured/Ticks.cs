using System;
using System.Diagnostics;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.GH.Components.Design;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Simulate;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Parameters;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Measured;

/// <summary>
/// What a tick of a slider costs at each component that follows a large print, and the memory that its results hold, after all ticks and after the first
/// solve. On a busy machine the processor time of a tick says more than the clock. It prints figures and asserts none:
/// <c>dotnet test tests/Caterpillar.GH.Tests -c Release -f net10.0 --filter FullyQualifiedName~Measured.Ticks --logger "console;verbosity=detailed"</c>.
/// </summary>
[Explicit("Prints figures for bench/RESULTS.md.")]
[NonParallelizable]
public sealed class Ticks
{
    private const int Count = 31;

    [TestCase(100_000)]
    [TestCase(1_000_000)]
    public void Of_a_print(int moves)
    {
        var print = Print(moves);
        var layers = print.Value.Layers.Count;
        Head($"{print.Value.Count} moves");
        Measure<SimulateComponent>("Position, Printed used", print, "Position", i => i / (double)Count,
            c => c.Params.Output.Single(p => p.Name == "Printed"));
        Measure<FilterToolpathComponent>("Last Layer", print, "Last Layer", i => layers * i / (Count + 1));
        Measure<FilterToolpathComponent>("Roles", print, "Roles", i => i % 2 == 0 ? "Infill" : "Outer Wall");
        Measure<EditToolpathComponent>("Speed Factor", print, "Speed Factor", i => 1.01 + i / 100.0);
        Measure<EditToolpathComponent>("Flow Factor", print, "Flow Factor", i => 1.01 + i / 100.0);
        Measure<ToolpathPreviewComponent>("Last Layer", print, "Last Layer", i => layers * i / (Count + 1));
        foreach (var other in new[] { "Speed", "Flow", "Layer", "Order" })
            Measure<ToolpathPreviewComponent>("Color By Role, " + other, print, "Color By", i => i % 2 == 0 ? "Role" : other);
    }

    [TestCase(100_000)]
    [TestCase(1_000_000)]
    public void Of_a_turtle(int moves)
    {
        var path = new PrintPath(Enumerable.Range(0, moves + 1).Select(i => new Vec3(i % 1000 * 0.1, i / 1000 * 0.1, i * 1e-4)), new Bead(0.08, 0.2, 40));
        Head($"{moves} moves in one path, then in paths of ten");
        Measure<TurtlePreviewComponent>("Position", path, "Position", i => i / (double)Count);
        var paths = Enumerable.Range(0, moves / 10).Select(i => (object?)new PrintPathGoo(new PrintPath(Enumerable.Range(10 * i, 11)
            .Select(k => path.Points[k]), path.BeadOf(0)))).ToArray();
        var canvas = new Canvas<TurtlePreviewComponent>().Feed("Steps", paths);
        Tick("Position, paths", canvas, "Position", i => i / (double)Count, null);
    }

    private static void Head(string of)
        => TestContext.Out.WriteLine($"{of}\n{"",-54} first ms processor   median     most processor  MB held    first");

    private static ToolpathGoo Print(int moves)
    {
        var bead = Bead.FromWidth(0.45, 0.2, 1, 60, BeadShape.Stadium);
        var steps = Enumerable.Range(0, 400).Select(i => (Step)new PrintPath(Enumerable.Range(0, moves / 400).Select(k =>
        {
            var angle = k * 2 * Math.PI / (moves / 400);
            var radius = 60 + 3 * Math.Sin(40 * angle + i * 0.05);
            return new Vec3(110 + radius * Math.Cos(angle), 110 + radius * Math.Sin(angle), 0.2 + 0.2 * i);
        }), bead, closed: true) { Role = i % 2 == 0 ? Role.OuterWall : Role.Infill, Layer = new Layer(i, 0.2 + 0.2 * i, 0.2) }).ToArray();
        var setup = new PrintSetup();
        return new ToolpathGoo(Planner.Plan(steps, setup).Value!, setup);
    }

    private static void Measure<T>(string what, object data, string port, Func<int, object> value, Func<GH_Component, IGH_Param>? used = null)
        where T : GH_Component, new()
    {
        var canvas = new Canvas<T>();
        canvas.Feed(canvas.Component.Params.Input[0].Name, data);
        Tick(what, canvas, port, value, used?.Invoke(canvas.Component));
    }

    private static void Tick<T>(string what, Canvas<T> canvas, string port, Func<int, object> value, IGH_Param? used)
        where T : GH_Component, new()
    {
        var slider = new Param_GenericObject();
        canvas.Document.AddObject(slider, false);
        var target = canvas.Component.Params.Input.SingleOrDefault(p => p.Name == port);
        if (target is null)
        {
            var filter = new Canvas<MoveFilterComponent>(canvas.Document);
            canvas.Input("Filter").AddSource(filter.Output("Filter"));
            target = filter.Input(port);
        }
        target.AddSource(slider);
        double Solve(int i)
        {
            slider.SetPersistentData(value(i));
            slider.ExpireSolution(false);
            var watch = Stopwatch.StartNew();
            canvas.Solve();
            if (used?.VolatileData.AllGoos().OfType<ToolpathGoo>().Single().Value.Count < 0) throw new InvalidOperationException();
            return watch.Elapsed.TotalMilliseconds;
        }
        using var process = Process.GetCurrentProcess();
        TimeSpan Processor()
        {
            process.Refresh();
            return process.TotalProcessorTime;
        }
        var before = GC.GetTotalMemory(true);
        var start = Processor();
        var first = Solve(Count / 2);
        var firstProcessor = (Processor() - start).TotalMilliseconds;
        var alone = GC.GetTotalMemory(true) - before;
        start = Processor();
        var times = Enumerable.Range(1, Count).Select(Solve).OrderBy(t => t).ToArray();
        var processor = (Processor() - start).TotalMilliseconds / Count;
        var held = GC.GetTotalMemory(true) - before;
        TestContext.Out.WriteLine($"{typeof(T).Name,-28} {what,-24} {first,8:0} {firstProcessor,9:0} "
            + $"{times[Count / 2],8:0.0} {times[Count - 1],8:0.0} {processor,9:0.0} "
            + $"{held / 1e6,8:0.0} {alone / 1e6,8:0.0}   {canvas.Component.RuntimeMessageLevel}");
        GC.KeepAlive(canvas);
    }
}
