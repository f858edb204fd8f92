using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;
using Caterpillar.GH.Base;
using Caterpillar.GH.Tests.Host;
using Caterpillar.GH.Tests.Plugin;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Data;
using Grasshopper.Kernel.Parameters;
using Grasshopper.Kernel.Types;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Components;

/// <summary>Each component with nothing, with less than it needs, with the wrong type, with items, lists and trees, and canceled.</summary>
[FixtureLifeCycle(LifeCycle.InstancePerTestCase)]
public sealed class EveryInputTests
{
    /// <summary>Components without work that could take long.</summary>
    private static readonly HashSet<string> Short = new(StringComparer.Ordinal)
    {
        "BakeToolpathComponent", "ConstructBeadComponent", "ConstructPrintPathComponent", "ConstructToolpathComponent", "MoveFilterComponent",
        "PrintSettingsComponent", "StepComponent", "ViewerPageComponent",
        "DeconstructPrintPathComponent", "DeconstructSetupComponent", "GCodeTextComponent", "LayerFieldComponent", "MaterialComponent",
        "PrintSetupComponent",
        "PrinterComponent",
        "SaveGCodeComponent", "SubdivideCurveComponent", "TurtleEventComponent", "TurtleExtrusionComponent", "TurtleMoveComponent", "TurtlePenComponent",
        "TurtleProgramComponent", "TurtleRepeatComponent", "TurtleRotateComponent", "WaitForResultsComponent",
    };

    private readonly GH_Document _document = new();

    [TearDown]
    public void TearDown() => GH_Document.EscapeKey = () => false;

    public static IEnumerable<TestCaseData> RequiredPorts() => Ports((c, p) => !Recipes.CanDoWithout(c, p));

    /// <summary>Texts take anything in words.</summary>
    public static IEnumerable<TestCaseData> TypedPorts() => Ports((_, p) => p is not (Param_String or Param_FilePath));

    public static IEnumerable<TestCaseData> ItemPorts() => Ports((c, p) => p.Access == GH_ParamAccess.item && !Recipes.CanDoWithout(c, p));

    public static IEnumerable<TestCaseData> ListPorts()
        => Ports((c, p) => p.Access == GH_ParamAccess.list && p.DataMapping != GH_DataMapping.Flatten && !Recipes.CanDoWithout(c, p));

    [TestCaseSource(typeof(PluginTypes), nameof(PluginTypes.Components))]
    public void Alone_it_asks_for_what_it_needs(Type type)
    {
        var component = PluginTypes.Make<GH_Component>(type);
        _document.AddObject(component, false);
        _document.NewSolution(false);
        var required = component.Params.Input.Where(p => !Recipes.CanDoWithout(component, p)).ToArray();
        Assert.That(Recipes.Errors(component), Is.Empty);
        foreach (var port in required)
            Assert.That(component.RuntimeMessages(GH_RuntimeMessageLevel.Warning), Has.Some.Contains(port.NickName + " failed to collect data"));
        if (required.Length > 0) Assert.That(Given(component), Is.Empty);
    }

    [TestCaseSource(nameof(RequiredPorts))]
    public void Without_one_of_its_inputs_it_gives_nothing(Type type, string port)
    {
        var component = Recipes.Make(type, _document);
        var input = component.Params.Input.Single(p => p.Name == port);
        input.RemoveAllSources();
        _document.NewSolution(false);
        Assert.That(component.RuntimeMessageLevel, Is.EqualTo(GH_RuntimeMessageLevel.Warning), string.Join("\n", Recipes.Errors(component)));
        Assert.That(Given(component), Is.Empty);
    }

    [TestCaseSource(nameof(TypedPorts))]
    public void With_the_wrong_type_it_is_red_and_gives_nothing(Type type, string port)
    {
        var component = Recipes.Make(type, _document);
        Recipes.Connect(_document, component.Params.Input.Single(p => p.Name == port), new Version(1, 2));
        _document.NewSolution(false);
        Assert.That(Recipes.Errors(component), Has.Some.Contains("onversion failed"), "Grasshopper says so of the port.");
        Assert.That(Given(component), Is.Empty);
    }

    [TestCaseSource(nameof(ItemPorts))]
    public void A_list_at_an_item_input_gives_a_result_for_each(Type type, string port)
    {
        var single = Solved(type, null, 1);
        var list = Solved(type, port, 2);
        if (type.Name == "PlayComponent")
        {
            Assert.That(Recipes.Errors(list), Has.One.Contains("Play takes only one toolpath. Use one Play for each."));
            return;
        }
        Assert.That(Recipes.Errors(list), Is.Empty);
        for (var i = 0; i < single.Params.Output.Count; i++)
            Assert.That(Texts(list.Params.Output[i]), Is.EquivalentTo(Twice(single.Params.Output[i])), single.Params.Output[i].Name);
    }

    [TestCaseSource(nameof(ListPorts))]
    public void A_tree_at_a_list_input_gives_a_result_for_each_branch(Type type, string port)
    {
        var single = Solved(type, null, 1);
        var component = Recipes.Make(type, _document);
        var source = (Param_GenericObject)component.Params.Input.Single(p => p.Name == port).Sources.Single();
        source.PersistentData.AppendRange(source.PersistentData.Branches[0].ToArray(), new GH_Path(1));
        _document.NewSolution(false);
        Assert.That(Recipes.Errors(component), Is.Empty);
        for (var i = 0; i < single.Params.Output.Count; i++)
            Assert.That(Texts(component.Params.Output[i]), Is.EquivalentTo(Twice(single.Params.Output[i])), single.Params.Output[i].Name);
    }

    [TestCaseSource(typeof(PluginTypes), nameof(PluginTypes.Components))]
    public void Escape_cancels_its_long_work(Type type)
    {
        var component = Recipes.Make(type, _document);
        var held = new TaskCompletionSource<bool>();
        ((CaterpillarComponent)component).Background.Queue = held.Task;
        GH_Document.EscapeKey = () =>
        {
            Task.Delay(50).ContinueWith(_ => held.TrySetResult(true));
            return true;
        };
        _document.NewSolution(false);
        var canceled = component.RuntimeMessages(GH_RuntimeMessageLevel.Warning).Contains("Canceled. Recompute to start again.");
        Assert.That(canceled, Is.EqualTo(!Short.Contains(type.Name)));
        if (!canceled) return;
        Assert.That((_document.AbortRequested, Recipes.Errors(component).Length), Is.EqualTo((true, 0)));
        Assert.That(Given(component), Is.Empty);
        GH_Document.EscapeKey = () => false;
        component.ExpireSolution(true);
        Assert.That(Recipes.Errors(component), Is.Empty);
        Assert.That(Given(component), Is.Not.Empty, "The next solve does it again.");
    }

    private static IEnumerable<TestCaseData> Ports(Func<GH_Component, IGH_Param, bool> which)
    {
        foreach (var type in PluginTypes.Components)
        {
            var component = PluginTypes.Make<GH_Component>(type);
            foreach (var port in component.Params.Input.Where(p => which(component, p)))
                yield return new TestCaseData(type, port.Name).SetArgDisplayNames(type.Name, port.Name);
        }
    }

    // The port gets its value so often.
    private static GH_Component Solved(Type type, string? port, int times)
    {
        var document = new GH_Document();
        var component = Recipes.Make(type, document);
        if (port is not null)
        {
            var source = (Param_GenericObject)component.Params.Input.Single(p => p.Name == port).Sources.Single();
            var one = source.PersistentData.Branches[0].ToArray();
            for (var i = 1; i < times; i++) source.PersistentData.AppendRange(one, new GH_Path(0));
        }
        document.NewSolution(false);
        return component;
    }

    private static IEnumerable<string> Twice(IGH_Param output) => Texts(output).Concat(Texts(output));

    private static string[] Texts(IGH_Param output) => output.VolatileData.AllGoos().Select(g => g?.ToString() ?? "null").ToArray();

    private static IGH_Goo[] Given(GH_Component component)
        => component.Params.Output.SelectMany(o => o.VolatileData.AllGoos()).Where(g => g is not null).Select(g => g!).ToArray();
}
