using System;
using System.Collections.Generic;
using System.Drawing;
using System.Linq;
using System.Security.Cryptography;
using System.Text;
using Caterpillar.GH.Base;
using Caterpillar.GH.Components.Setup;
using Caterpillar.GH.Tests.Host;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Special;

namespace Caterpillar.GH.Tests.Examples;

/// <summary>A definition made from code: objects in columns, the same ids each time, a note, and a group around all.</summary>
internal sealed class Sketch
{
    private const int ColumnWidth = 240;
    private const int RowHeight = 110;
    private readonly string _name;
    private readonly GH_Group _group = new();
    private readonly Dictionary<int, int> _rows = [];
    private readonly HashSet<object> _identified = [];
    private int _count;

    public Sketch(string name, string note)
    {
        _name = name;
        Document.Name = name;
        Document.SetId(NextId());
        var panel = Add(0, new GH_Panel { UserText = note, NickName = "Read me" });
        panel.Attributes.Bounds = new RectangleF(panel.Attributes.Pivot, new SizeF(220, 90));
    }

    public GH_Document Document { get; } = new();

    /// <summary>Adds an object to a column, below what is there.</summary>
    public T Add<T>(int column, T item)
        where T : GH_DocumentObject
    {
        item.NewInstanceGuid(NextId());
        Document.AddObject(item, false);
        if (item is GH_Component component)
        {
            Identify(component);
        }
        _rows.TryGetValue(column, out var row);
        _rows[column] = row + 1;
        item.Attributes.Pivot = new PointF(40 + column * ColumnWidth, 40 + row * RowHeight);
        item.Attributes.Bounds = new RectangleF(item.Attributes.Pivot, new SizeF(160, 60));
        _group.ObjectIDs.Add(item.InstanceGuid);
        return item;
    }

    public GH_Panel Text(int column, string name, string text, bool lines = false)
        => Add(column, new GH_Panel { NickName = name, UserText = text, Multiline = !lines });

    public GH_NumberSlider Slider(int column, string name, double value, double least, double most, int digits = 2)
        => Add(column, new GH_NumberSlider { NickName = name, Value = value, Minimum = least, Maximum = most, Digits = digits });

    public GH_BooleanToggle Toggle(int column, string name) => Add(column, new GH_BooleanToggle { NickName = name });

    /// <summary>A component with its inputs connected: a parameter, or a component, whose first output is taken, or one of its outputs by name.</summary>
    public T Component<T>(int column, params (string Input, object Source)[] wires)
        where T : GH_Component, new()
    {
        var component = Add(column, new T());
        foreach (var (input, source) in wires)
        {
            var port = Port(component, input);
            port.AddSource(source switch
            {
                GH_Component other => other.Params.Output[0],
                (GH_Component other, string output) => other.Params.Output.Single(p => p.Name == output),
                _ => (IGH_Param)source,
            });
        }
        if (component is ChosenPortsComponent chosen) Chosen.Follow(chosen);
        Identify(component);
        return component;
    }

    // A port that is shown for some choices, or one for a key.
    private IGH_Param Port(GH_Component component, string name)
    {
        if (component.Params.Input.FirstOrDefault(p => p.Name == name) is { } shown) return shown;
        if (component is ChosenPortsComponent chosen) Chosen.Follow(chosen);
        else if (component is KeyPortsComponent) AddKey(component, name);
        Identify(component);
        return component.Params.Input.Single(p => p.Name == name);
    }

    // As a user does it, without a solution.
    private void AddKey(GH_Component component, string key)
    {
        Document.Enabled = false;
        component.Params.Rename(component.Params.Insert(component.Params.Input.Count), key);
        Document.RunSchedule();
        Document.Enabled = true;
    }

    private void Identify(GH_Component component)
    {
        foreach (var port in component.Params.Cast<GH_DocumentObject>().Where(p => _identified.Add(p))) port.NewInstanceGuid(NextId());
    }

    /// <summary>The definition, with its group.</summary>
    public GH_Document Finish()
    {
        _group.NickName = _name;
        _group.NewInstanceGuid(NextId());
        Document.AddObject(_group, false);
        return Document;
    }

    private Guid NextId()
    {
        using var hash = SHA256.Create();
        return new Guid(hash.ComputeHash(Encoding.UTF8.GetBytes(_name + "/" + _count++.ToString(System.Globalization.CultureInfo.InvariantCulture))).Take(16)
            .ToArray());
    }
}
