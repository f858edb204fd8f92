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

/// <summary>What a tick of a slider costs at each component that follows a large print. It prints figures and asserts none.</summary>
[Explicit("Prints figures for bench/RESULTS.md.")]
public sealed class Ticks
{
    [TestCase(100_000)]
    [TestCase(1_000_000)]
    public void Of_a_print(int moves)
    {
        var print = Print(moves);
        var layers = print.Value.Layers.Count;
        TestContext.Out.WriteLine($"{print.Value.Count} moves: first solve, median and worst of 15 ticks, ms");
        Measure<SimulateComponent>("Position, Printed used", print, "Position", i => i / 15.0, c => c.Params.Output.Single(p => p.Name == "Printed"));
        Measure<FilterToolpathComponent>("Last Layer", print, "Last Layer", i => layers * i / 16);
        Measure<FilterToolpathComponent>("Roles", print, "Roles", i => i % 2 == 0 ? "Infill" : "Outer Wall");
        Measure<EditToolpathComponent>("Speed Factor", print, "Speed Factor", i => 1.01 + i / 100.0);
        Measure<EditToolpathComponent>("Flow Factor", print, "Flow Factor", i => 1.01 + i / 100.0);
        Measure<ToolpathPreviewComponent>("Last Layer", print, "Last Layer", i => layers * i / 16);
        Measure<ToolpathPreviewComponent>("Color By", print, "Color By", i => new[] { "Speed", "Layer", "Role", "Order" }[i % 4]);
    }

    [TestCase(100_000)]
    [TestCase(1_000_000)]
    public void Of_a_turtle(int moves)
    {
        var path = new PrintPath(Enumerable.Range(0, moves + 1).Select(i => new Vec3(i % 1000 * 0.1, i / 1000 * 0.1, i * 1e-4)), new Bead(0.08, 0.2, 40));
        TestContext.Out.WriteLine($"{moves} moves in one path, then in paths of ten: first solve, median and worst of 15 ticks, ms");
        Measure<TurtlePreviewComponent>("Position", path, "Position", i => i / 15.0);
        var paths = Enumerable.Range(0, moves / 10).Select(i => (object?)new PrintPathGoo(new PrintPath(Enumerable.Range(10 * i, 11)
            .Select(k => path.Points[k]), path.BeadOf(0)))).ToArray();
        var canvas = new Canvas<TurtlePreviewComponent>().Feed("Steps", paths);
        Tick("Position, paths", canvas, "Position", i => i / 15.0, null);
    }

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
        var first = Solve(7);
        var times = Enumerable.Range(1, 15).Select(Solve).OrderBy(t => t).ToArray();
        TestContext.Out.WriteLine($"{typeof(T).Name,-28} {what,-24} {first,8:0} {times[7],8:0.0} {times[14],8:0.0}   {canvas.Component.RuntimeMessageLevel}");
    }
}
