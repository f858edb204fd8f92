using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.GH.Base;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Data;
using Grasshopper.Kernel.Parameters;
using Grasshopper.Kernel.Types;

namespace Caterpillar.GH.Tests.Host;

/// <summary>A definition with one component, whose inputs are fed through wires from floating parameters.</summary>
internal sealed class Canvas<T>
    where T : GH_Component, new()
{
    public Canvas()
        : this(new GH_Document())
    {
    }

    /// <summary>Another component in a definition.</summary>
    public Canvas(GH_Document document)
    {
        Document = document;
        Component = new T();
        Document.AddObject(Component, false);
    }

    public GH_Document Document { get; }

    public T Component { get; }

    /// <summary>An item or a list, in one branch. Null is a null on the wire.</summary>
    public Canvas<T> Feed(string input, params object?[]? items) => FeedTree(input, items ?? [null]);

    /// <summary>A tree with the branches {0}, {1} and so on.</summary>
    public Canvas<T> FeedTree(string input, params object?[][] branches)
    {
        var source = new Param_GenericObject { NickName = input };
        for (var i = 0; i < branches.Length; i++)
        {
            var path = new GH_Path(i);
            source.PersistentData.EnsurePath(path);
            foreach (var item in branches[i]) source.PersistentData.Append(Wrap(item)!, path);
        }
        Document.AddObject(source, false);
        var target = Input(input);
        target.RemoveAllSources();
        target.AddSource(source);
        Component.ExpireSolution(false);
        return this;
    }

    /// <summary>Adds a port for a key with the zoomable +, renames it, and connects a value.</summary>
    public Canvas<T> Key(string key, params object?[] items)
    {
        AddKey(key);
        return Feed(key, items);
    }

    /// <summary>Adds a port for a key with the zoomable + and renames it.</summary>
    public IGH_Param AddKey(string key)
    {
        var made = Component.Params.Insert(Component.Params.Input.Count);
        Component.Params.Rename(made, key);
        Document.RunSchedule();
        return Component.Params.Input.Single(p => p.NickName == key);
    }

    public Canvas<T> Solve()
    {
        Document.NewSolution(false);
        return this;
    }

    /// <summary>An input. If it is shown for some choices only, the ports are made to follow those that are fed.</summary>
    public IGH_Param Input(string name)
    {
        if (Component is ChosenPortsComponent chosen && Component.Params.Input.All(p => p.Name != name)) Chosen.Follow(chosen);
        return Component.Params.Input.Single(p => p.Name == name);
    }

    public IGH_Param Output(string name) => Component.Params.Output.Single(p => p.Name == name);

    /// <summary>All items of an output, in order; null if the component gave none.</summary>
    public List<object?> All(string output)
    {
        var data = Output(output).VolatileData;
        var all = new List<object?>();
        for (var i = 0; i < data.PathCount; i++)
        {
            foreach (IGH_Goo? goo in data.get_Branch(i)) all.Add(goo?.ScriptVariable());
        }
        return all;
    }

    /// <summary>The only item of an output.</summary>
    public TValue One<TValue>(string output) => (TValue)All(output).Single()!;

    public string[] Paths(string output) => Output(output).VolatileData.Paths.Select(p => p.ToString()).ToArray();

    public IList<string> Errors => Component.RuntimeMessages(GH_RuntimeMessageLevel.Error);

    public IList<string> Warnings => Component.RuntimeMessages(GH_RuntimeMessageLevel.Warning);

    public IList<string> Notes => Component.RuntimeMessages(GH_RuntimeMessageLevel.Remark);

    private static IGH_Goo? Wrap(object? item) => item is null ? null : Casting.Wrap(item);
}
