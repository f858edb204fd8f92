using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.GH.Tests.Host;
using Caterpillar.GH.Tests.Plugin;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Types;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Components;

/// <summary>What holds for all components alike.</summary>
public sealed class EveryComponentTests
{
    public static IEnumerable<TestCaseData> PortsThatCanBeLeftOut()
    {
        foreach (var type in PluginTypes.Components)
        {
            var component = PluginTypes.Make<GH_Component>(type);
            foreach (var port in component.Params.Input.Where(p => Recipes.CanDoWithout(component, p)))
                yield return new TestCaseData(type, port.Name).SetArgDisplayNames(type.Name, port.Name);
        }
    }

    [Category("Host")]
    [TestCaseSource(typeof(PluginTypes), nameof(PluginTypes.Components))]
    public void It_solves_with_what_it_needs(Type type)
    {
        var component = Solve(type, null, out _);
        Assert.That(Recipes.Errors(component), Is.Empty);
    }

    [TestCaseSource(nameof(PortsThatCanBeLeftOut))]
    public void A_port_whose_source_failed_makes_it_red_without_a_result(Type type, string port)
    {
        var component = Solve(type, port, out _);
        Assert.That(Recipes.Errors(component), Has.Some.Contains(port + ": the connected source gives no valid data."));
        foreach (var output in component.Params.Output)
            Assert.That(output.VolatileData.Paths.SelectMany(p => output.VolatileData.get_Branch(p)!.Cast<IGH_Goo?>()), Has.All.Null, output.Name);
    }

    [TestCaseSource(typeof(PluginTypes), nameof(PluginTypes.Components))]
    public void A_port_that_needs_a_value_gives_nothing_for_null(Type type)
    {
        var ports = PluginTypes.Make<GH_Component>(type).Params.Input.Select(p => p.Name).ToArray();
        foreach (var port in ports)
        {
            var component = Solve(type, port, out _);
            Assert.That(component.RuntimeMessageLevel, Is.EqualTo(GH_RuntimeMessageLevel.Error).Or.EqualTo(GH_RuntimeMessageLevel.Warning), port);
            foreach (var output in component.Params.Output.Where(o => o.Name != "Diagnostics"))
                Assert.That(output.VolatileData.Paths.SelectMany(p => output.VolatileData.get_Branch(p)!.Cast<IGH_Goo?>()), Has.All.Null, port + ", "
                    + output.Name);
        }
    }

    [TestCaseSource(typeof(PluginTypes), nameof(PluginTypes.Components))]
    public void It_says_nothing_any_more_when_its_inputs_are_gone(Type type)
    {
        var component = Solve(type, null, out var document);
        foreach (var port in component.Params.Input) port.RemoveAllSources();
        component.ExpireSolution(false);
        Assert.That(component.Message, Is.Empty);
        document.NewSolution(false);
    }

    private static GH_Component Solve(Type type, string? nullPort, out GH_Document document)
    {
        document = new GH_Document();
        var component = Recipes.Make(type, document);
        if (nullPort is not null) Recipes.Connect(document, component.Params.Input.Single(p => p.Name == nullPort), [null]);
        document.NewSolution(false);
        return component;
    }
}
