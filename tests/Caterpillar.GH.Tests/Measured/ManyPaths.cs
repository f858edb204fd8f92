using System;
using System.Diagnostics;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Path;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Data;
using Grasshopper.Kernel.Parameters;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Measured;

/// <summary>How long a solve takes when nothing has changed. It prints figures and asserts none.</summary>
[Explicit("Prints figures for bench/RESULTS.md.")]
public sealed class ManyPaths
{
    private const int Count = 100_000;

    private readonly GH_Document _document = new();
    private PrintPathParam _source = null!;

    [OneTimeSetUp]
    public void Make()
    {
        var data = new Param_GenericObject();
        _source = new PrintPathParam();
        _source.AddSource(data);
        var bead = new Bead(0.08, 0.2, 40);
        for (var i = 0; i < Count; i++)
        {
            var (x, y) = (i % 400 * 0.5, i / 400 * 0.5);
            data.PersistentData.Append(new PrintPathGoo(new PrintPath([new Vec3(x, y, 0.2), new Vec3(x + 0.4, y, 0.2)], bead)
                with { Layer = new Layer(0, 0.2, 0.2) }), new GH_Path(0));
        }
        _document.AddObject(data, false);
        _document.AddObject(_source, false);
        _document.NewSolution(false);
    }

    [Test]
    public void Unchanged()
    {
        TestContext.Out.WriteLine($"{Count} paths; best and median ms of 9 solves with unchanged inputs, median of taking the list alone");
        Measure<SortPathsComponent>("Print Paths", c => Recipes.Connect(_document, c.Params.Input[1], (int)Planning.SortRule.Layer));
        Measure<MergePathsComponent>("Print Paths");
        Measure<FitArcsComponent>("Print Paths");
        Measure<DeformComponent>("Print Paths", c => Recipes.Connect(_document, c.Params.Input.Single(p => p.Name == "Z"), "1.1 * z"));
        Measure<ModulateComponent>("Print Paths", c => Recipes.Connect(_document, c.Params.Input.Single(p => p.Name == "Expression"), "0.5"));
        Measure<CoolLayersComponent>("Print Paths");
        Measure<GapBeadComponent>("Print Paths");
        Measure<PlanToolpathComponent>("Steps", c => Recipes.Connect(_document, c.Params.Input.Single(p => p.Name == "Setup"), "generic"));
        Measure<DeconstructPrintPathComponent>("Print Path");
    }

    private void Measure<T>(string port, Action<GH_Component>? feed = null)
        where T : GH_Component, new()
    {
        var component = new T();
        _document.AddObject(component, false);
        var input = component.Params.Input.Single(p => p.Name == port);
        input.AddSource(_source);
        feed?.Invoke(component);
        var first = Time(() => _document.NewSolution(false));
        var times = Enumerable.Range(0, 9).Select(_ =>
        {
            component.ExpireSolution(false);
            return Time(() => _document.NewSolution(false));
        }).OrderBy(t => t).ToArray();
        var taking = Enumerable.Range(0, 9).Select(_ =>
        {
            component.ExpireSolution(false);
            return Time(input.CollectData);
        }).OrderBy(t => t).ToArray();
        TestContext.Out.WriteLine($"{component.Name,-24} {times[0],8:0.0} {times[4],8:0.0} {taking[4],8:0.0}   first {first,8:0.0}   "
            + $"{component.RuntimeMessageLevel}");
        _document.RemoveObject(component, false);
    }

    private static double Time(Action action)
    {
        var watch = Stopwatch.StartNew();
        action();
        return watch.Elapsed.TotalMilliseconds;
    }
}
