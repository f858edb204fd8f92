using System;
using System.Collections.Generic;
using System.Drawing;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using System.Text;
using Caterpillar.CanvasPictures;
using Caterpillar.GH.Base;
using Caterpillar.GH.Params;
using Caterpillar.GH.Tests.Examples.Arranging;
using Caterpillar.GH.Tests.Host;
using GH_IO.Serialization;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Data;
using Grasshopper.Kernel.Parameters;
using Grasshopper.Kernel.Special;
using Grasshopper.Kernel.Types;

namespace Caterpillar.GH.Tests.Examples;

/// <summary>A definition made from code: the same ids each time, a note that explains it, and a named group for each stage.</summary>
internal sealed class Sketch
{
    private const float SliderWidth = 220;
    private const float NoteWidth = 520;

    private static readonly Dictionary<string, Color> Colors = new(StringComparer.Ordinal)
    {
        ["Setup"] = Color.FromArgb(150, 168, 196, 224),
        ["Design"] = Color.FromArgb(150, 176, 214, 168),
        ["Shape"] = Color.FromArgb(150, 198, 222, 150),
        ["Model"] = Color.FromArgb(150, 176, 214, 168),
        ["Field"] = Color.FromArgb(150, 198, 222, 150),
        ["Slice"] = Color.FromArgb(150, 240, 214, 150),
        ["Path"] = Color.FromArgb(150, 198, 222, 150),
        ["Plan"] = Color.FromArgb(150, 236, 190, 160),
        ["Edit"] = Color.FromArgb(150, 240, 214, 150),
        ["Look"] = Color.FromArgb(150, 206, 190, 224),
        ["Check"] = Color.FromArgb(150, 226, 186, 200),
        ["Save"] = Color.FromArgb(150, 200, 200, 200),
    };

    private readonly string _name;
    private readonly HashSet<object> _identified = [];
    private readonly List<GH_Group> _stages = [];
    private int _count;

    /// <param name="name">Name of the file.</param>
    /// <param name="shows">What the definition shows.</param>
    /// <param name="change">What a reader might change.</param>
    public Sketch(string name, string shows, string change)
    {
        _name = name;
        Document.Name = name;
        Document.SetId(NextId());
        var text = shows + "\n\nTry: " + change;
        Place(new GH_Panel { UserText = text, NickName = "Read me" }, NoteWidth, PanelHeight(text, NoteWidth) + 13);
    }

    public GH_Document Document { get; } = new();

    /// <summary>What is added from here on belongs to this stage.</summary>
    public Sketch Stage(string name)
    {
        var group = _stages.Find(g => g.NickName == name);
        if (group is not null) _stages.Remove(group);
        else group = GH_Group.Of(name, Colors[name.Split(' ')[0]]);
        _stages.Add(group);
        return this;
    }

    public GH_Panel Text(string name, string text, bool lines = false, float width = 200)
        => Place(new GH_Panel { NickName = name, UserText = text, Multiline = !lines }, width, PanelHeight(text, width) + 13);

    /// <summary>A panel that shows what an output gives.</summary>
    public void Show(string name, GH_Component from, string output, int lines = 1, float width = 170)
    {
        var panel = Place(new GH_Panel { NickName = name, Multiline = lines == 1 }, width, 20 + 13 * lines + 6);
        panel.AddSource(Output((from, output)));
    }

    public GH_NumberSlider Slider(string name, double value, double least, double most, int digits = 1)
        => Place(new GH_NumberSlider { NickName = name, Value = value, Minimum = least, Maximum = most, Digits = digits }, SliderWidth, 20);

    public GH_BooleanToggle Toggle(string name, bool value = false)
        => Place(new GH_BooleanToggle { NickName = name, Value = value }, (float)Math.Round(Letters.Width(name)) + 76, 22);

    public GH_ButtonObject Button(string name) => Place(new GH_ButtonObject { NickName = name }, (float)Math.Round(Letters.Width(name)) + 76, 22);

    /// <summary>A list to choose a text from.</summary>
    public GH_ValueList Choice(string name, string chosen, params string[] names)
        => List(name, chosen, names.Select(n => new GH_ValueListItem(n, "\"" + n + "\"")));

    /// <summary>
    /// A component with its inputs connected: a parameter, or a component, whose first output is taken, or one of its outputs by name, or several, or a choice.
    /// Choices come before the ports that they show; the name of a key adds its port.
    /// </summary>
    public T Component<T>(params (string Input, object Source)[] wires)
        where T : GH_Component, new()
    {
        var component = Place(new T(), 0, 0);
        Identify(component);
        foreach (var (input, source) in wires) Wire(component, input, source);
        if (component is ChosenPortsComponent chosen) Chosen.Follow(chosen);
        Identify(component);
        return component;
    }

    private void Wire(GH_Component component, string input, object source)
    {
        var port = Port(component, input);
        if (source is Pick pick)
        {
            var choices = ((ChoiceParam)port).Choices.Select(c => new GH_ValueListItem(c.Key, c.Value.ToString(CultureInfo.InvariantCulture)));
            source = List(pick.Name ?? input, pick.Value, choices);
        }
        foreach (var one in source as object[] ?? [source]) port.AddSource(Output(one));
    }

    // A port that is shown for some choices, or one for a key.
    private IGH_Param Port(GH_Component component, string name)
    {
        if (component.Params.Input.FirstOrDefault(p => p.Name == name) is { } shown) return shown;
        if (component is ChosenPortsComponent chosen) Chosen.Follow(chosen);
        else if (component is ProfileComponent) AddKey(component, name);
        Identify(component);
        return component.Params.Input.SingleOrDefault(p => p.Name == name)
            ?? throw new ArgumentException($"{component.Name} has no input {name}: {string.Join(", ", component.Params.Input.Select(p => p.Name))}.");
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

    public Param_Point Point(string name, double x, double y, double z)
    {
        var point = Geometry(name, new Param_Point());
        point.SetPersistentData(new GH_Point(new Rg.Point3d(x, y, z)));
        return point;
    }

    /// <summary>Meshes that the file holds.</summary>
    public Param_Mesh Mesh(string name, params byte[][] meshes)
    {
        var parameter = Geometry(name, new Param_Mesh());
        foreach (var bytes in meshes) parameter.PersistentData.Append(new GH_Mesh { Bytes = bytes }, new GH_Path(0));
        return parameter;
    }

    /// <summary>Curves that the file holds.</summary>
    public Param_Curve Curve(string name, params byte[][] curves)
    {
        var parameter = Geometry(name, new Param_Curve());
        foreach (var bytes in curves) parameter.PersistentData.Append(new GH_Curve { Bytes = bytes }, new GH_Path(0));
        return parameter;
    }

    /// <summary>Breps that the file holds.</summary>
    public Param_Brep Brep(string name, params byte[][] breps)
    {
        var parameter = Geometry(name, new Param_Brep());
        foreach (var bytes in breps) parameter.PersistentData.Append(new GH_Brep { Bytes = bytes }, new GH_Path(0));
        return parameter;
    }

    private T Geometry<T>(string name, T parameter)
        where T : GH_DocumentObject
    {
        parameter.NickName = name;
        return Place(parameter, 0, 0);
    }

    /// <summary>The definition with its groups. Places are those of the file. Where it is renewed, they are found again.</summary>
    public GH_Document Finish(string file, bool renews)
    {
        foreach (var group in _stages)
        {
            group.NewInstanceGuid(NextId());
            Document.AddObject(group, false);
        }
        var made = Read(Save(Document));
        var places = renews ? new Arrangement(made).Run() : Read(File.ReadAllText(file)).Items.ToDictionary(i => i.Id, i => i.Pivot);
        foreach (var item in made.Items.Where(i => places.ContainsKey(i.Id)))
        {
            var attributes = Document.FindObject(item.Id, true).Attributes;
            var pivot = places[item.Id];
            var placed = Placed.Of(item with { Pivot = pivot, Bounds = item.Bounds with { X = pivot.X, Y = pivot.Y } });
            attributes.Pivot = new PointF((float)pivot.X, (float)pivot.Y);
            attributes.Bounds = new RectangleF((float)Math.Round(placed.Box.X), (float)placed.Box.Y, (float)Math.Round(placed.Box.Width),
                (float)placed.Box.Height);
        }
        return Document;
    }

    public static string Save(GH_Document document)
    {
        var archive = new GH_Archive();
        if (!archive.AppendObject(document, "Definition")) throw new InvalidOperationException("The definition can't be saved.");
        return archive.Serialize_Xml().Replace("\r\n", "\n");
    }

    private static Definition Read(string xml) => Definition.Read(xml);

    private GH_ValueList List(string name, string chosen, IEnumerable<GH_ValueListItem> items)
    {
        var list = new GH_ValueList { NickName = name };
        list.ListItems.AddRange(items);
        list.ListItems.Single(i => i.Name == chosen).Selected = true;
        return Place(list, (float)Math.Round(Letters.Width(name) + 44 + list.ListItems.Max(i => Letters.Width(i.Name))), 22);
    }

    private T Place<T>(T item, float width, float height)
        where T : GH_DocumentObject
    {
        item.NewInstanceGuid(NextId());
        Document.AddObject(item, false);
        item.Attributes.Bounds = new RectangleF(0, 0, width, height);
        if (_stages.Count > 0) _stages[_stages.Count - 1].ObjectIDs.Add(item.InstanceGuid);
        return item;
    }

    private static IGH_Param Output(object source) => source switch
    {
        GH_Component other => other.Params.Output[0],
        (GH_Component other, string name) => other.Params.Output.SingleOrDefault(p => p.Name == name)
            ?? throw new ArgumentException($"{other.Name} has no output {name}: {string.Join(", ", other.Params.Output.Select(p => p.Name))}."),
        _ => (IGH_Param)source,
    };

    private static float PanelHeight(string text, float width)
    {
        var letters = (int)((width - 24) / Letters.PanelLetter);
        return (float)(text.Split('\n').SelectMany(l => Wrapped.Lines(l, letters)).Count() * Letters.PanelLine + 12);
    }

    private Guid NextId()
    {
        using var hash = SHA256.Create();
        return new Guid(hash.ComputeHash(Encoding.UTF8.GetBytes(_name + "/" + _count++.ToString(CultureInfo.InvariantCulture))).Take(16).ToArray());
    }
}

/// <summary>One of the choices of an input, as a list to choose from. The list is named as the input, unless it has a name of its own.</summary>
internal sealed record Pick(string Value, string? Name = null);
