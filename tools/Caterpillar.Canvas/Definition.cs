using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Xml.Linq;

namespace Caterpillar.CanvasPictures;

/// <summary>What an object looks like.</summary>
internal enum Look
{
    Component,
    Parameter,
    Panel,
    Slider,
    Toggle,
    Button,
    ValueList,
}

/// <summary>An end of wires. Tags are the little marks of flatten, graft, reverse and simplify; the sources are ids of other ports.</summary>
internal sealed record Port(Guid Id, string NickName, int Tags, IReadOnlyList<Guid> Sources);

/// <summary>An object of a definition as its file describes it. The text is what a panel, slider, toggle or value list shows.</summary>
internal sealed record Item(Guid Id, Guid Kind, Look Look, string Name, string NickName, Spot Pivot, Box Bounds, IReadOnlyList<Port> Inputs,
    IReadOnlyList<Port> Outputs)
{
    public string Text { get; init; } = "";

    /// <summary>Where a slider's grip stands, from 0 to 1.</summary>
    public double Fraction { get; init; }

    /// <summary>Whether a panel shows numbers of lines.</summary>
    public bool Numbered { get; init; }
}

/// <summary>A named frame around objects; the color is written as #rrggbb.</summary>
internal sealed record Group(string NickName, string Color, IReadOnlyList<Guid> Members);

/// <summary>A definition as a .ghx file holds it.</summary>
internal sealed record Definition(IReadOnlyList<Item> Items, IReadOnlyList<Group> Groups)
{
    private static readonly Guid GroupKind = new("c552a431-af5b-46a9-a8a4-0fcbc27ef596");

    private static readonly Dictionary<Guid, Look> Looks = new()
    {
        [new Guid("59e0b89a-e487-49f8-bab8-b5bab16be14c")] = Look.Panel,
        [new Guid("57da07bd-ecab-415d-9d86-af36d7073abc")] = Look.Slider,
        [new Guid("2e78987b-9dfb-42a2-8b76-3923ac8bd91a")] = Look.Toggle,
        [new Guid("a8b97322-2d53-47cd-905e-b932c3ccd74e")] = Look.Button,
        [new Guid("00027467-0d24-4fa7-b178-8dc0ac5f42ec")] = Look.ValueList,
    };

    /// <exception cref="FormatException">The text is no definition.</exception>
    public static Definition Read(string xml)
    {
        var root = XDocument.Parse(xml).Root;
        var objects = Chunk(Chunk(root, "Definition"), "DefinitionObjects") ?? throw new FormatException("The file holds no Grasshopper definition.");
        var items = new List<Item>();
        var groups = new List<Group>();
        foreach (var found in Chunks(objects, "Object"))
        {
            var container = Chunk(found, "Container")!;
            var kind = new Guid(Value(found, "GUID")!);
            if (kind == GroupKind) groups.Add(ReadGroup(container));
            else items.Add(ReadItem(kind, Value(found, "Name") ?? "", container));
        }
        return new Definition(items, groups);
    }

    /// <summary>Only these groups, with what is in them.</summary>
    public Definition Only(IReadOnlyCollection<string> groups)
    {
        var kept = Groups.Where(g => groups.Contains(g.NickName)).ToArray();
        return new Definition(Items.Where(i => kept.Any(g => g.Members.Contains(i.Id))).ToArray(), kept);
    }

    private static Group ReadGroup(XElement container)
    {
        var color = (PaintOf(container) ?? "150;170;135;255").Split(';').Select(v => int.Parse(v, CultureInfo.InvariantCulture)).ToArray();
        var hex = string.Concat(color.Skip(1).Select(v => v.ToString("x2", CultureInfo.InvariantCulture)));
        return new Group(Value(container, "NickName") ?? "", "#" + hex, Values(container, "ID").Select(v => new Guid(v)).ToArray());
    }

    // The only color that a group has.
    private static string? PaintOf(XElement container)
        => container.Element("items")?.Elements("item").FirstOrDefault(i => (string?)i.Attribute("type_name") == "gh_drawing_color")?.Value;

    private static Item ReadItem(Guid kind, string name, XElement container)
    {
        var look = Looks.TryGetValue(kind, out var known) ? known : Value(container, "SourceCount") is null ? Look.Component : Look.Parameter;
        var inputs = Ports(container, "param_input", "InputParam");
        var outputs = Ports(container, "param_output", "OutputParam");
        var attributes = Chunk(container, "Attributes");
        var bounds = Element(attributes, "Bounds");
        var box = bounds is null ? default : new Box(Number(bounds, "X"), Number(bounds, "Y"), Number(bounds, "W"), Number(bounds, "H"));
        var pivot = Element(attributes, "Pivot");
        var port = ReadPort(container);
        if (look != Look.Component)
        {
            inputs = [port];
            outputs = [port];
        }
        var item = new Item(port.Id, kind, look, name, port.NickName, pivot is null ? new Spot(box.X, box.Y) : new Spot(Number(pivot, "X"), Number(pivot, "Y")),
            box, inputs, outputs);
        return look switch
        {
            Look.Panel => item with { Text = Value(container, "UserText") ?? "", Numbered = Value(Chunk(container, "PanelProperties"),
                "DrawIndices") == "true" },
            Look.Slider => WithSlider(item, Chunk(container, "Slider")!),
            Look.Toggle => item with { Text = Value(container, "ToggleValue") == "true" ? "True" : "False" },
            Look.ValueList => item with
            {
                Text = Chunks(container, "ListItem").Where(i => Value(i, "Selected") == "true").Select(i => Value(i, "Name")).FirstOrDefault() ?? "",
            },
            _ => item,
        };
    }

    private static Item WithSlider(Item item, XElement slider)
    {
        double Of(string name) => double.Parse(Value(slider, name) ?? "0", CultureInfo.InvariantCulture);
        var digits = (int)Of("Digits");
        return item with
        {
            Text = Of("Value").ToString("F" + digits.ToString(CultureInfo.InvariantCulture), CultureInfo.InvariantCulture),
            Fraction = (Of("Value") - Of("Min")) / Math.Max(Of("Max") - Of("Min"), 1e-9),
        };
    }

    // Fixed ports stand in the container, those that the user may add in a chunk of their own.
    private static IReadOnlyList<Port> Ports(XElement container, string name, string variable)
        => Chunks(container, name).Concat(Chunks(Chunk(container, "ParameterData"), variable)).Select(ReadPort).ToArray();

    private static Port ReadPort(XElement chunk)
    {
        var tags = (Value(chunk, "Mapping") is not (null or "0") ? 1 : 0) + (Value(chunk, "ReverseData") == "true" ? 1 : 0)
            + (Value(chunk, "SimplifyData") == "true" ? 1 : 0);
        return new Port(new Guid(Value(chunk, "InstanceGuid")!), Value(chunk, "NickName") ?? "", tags, Values(chunk,
            "Source").Select(v => new Guid(v)).ToArray());
    }

    private static IEnumerable<XElement> Chunks(XElement? parent, string name)
        => parent?.Element("chunks")?.Elements("chunk").Where(c => (string?)c.Attribute("name") == name) ?? [];

    private static XElement? Chunk(XElement? parent, string name) => Chunks(parent, name).FirstOrDefault();

    private static IEnumerable<XElement> Elements(XElement? parent, string name)
        => parent?.Element("items")?.Elements("item").Where(i => (string?)i.Attribute("name") == name) ?? [];

    private static XElement? Element(XElement? parent, string name) => Elements(parent, name).FirstOrDefault();

    private static string? Value(XElement? parent, string name) => Element(parent, name)?.Value;

    private static IEnumerable<string> Values(XElement? parent, string name) => Elements(parent, name).Select(i => i.Value);

    private static double Number(XElement item, string part) => double.Parse(item.Element(part)!.Value, CultureInfo.InvariantCulture);
}
