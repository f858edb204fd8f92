using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;
using Caterpillar.Basics;
using Caterpillar.CanvasPictures;
using Caterpillar.GH.Base;
using Caterpillar.GH.Params;
using Caterpillar.GH.Plugin;
using Caterpillar.GH.Tests.Examples;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Parameters;

namespace Caterpillar.GH.Tests.Plugin;

/// <summary>
/// The pages of the manual about components: what a component looks like, its ports, a definition that uses it, and what stands before and after it there.
/// </summary>
internal sealed class ComponentPages
{
    private const int MostExamples = 6;
    private static readonly string[] Panels = [Panel.Setup, Panel.Design, Panel.Path, Panel.Slice, Panel.GCode, Panel.Simulate];
    private static readonly string Docs = Path.Combine(Caterpillar.Tests.TestData.Repository, "docs");

    private readonly IReadOnlyList<GH_Component> _components;
    private readonly ILookup<Guid, string> _examples;
    private readonly ILookup<Guid, Guid> _before;
    private readonly ILookup<Guid, Guid> _after;
    private readonly IReadOnlyDictionary<string, string> _manual;

    public ComponentPages()
    {
        _components = PluginTypes.Components.Select(PluginTypes.Make<GH_Component>).OrderBy(c => c.Name, StringComparer.Ordinal).ToArray();
        var definitions = Definitions.All.Keys.Select(name => (Name: name, Definition: Read(name))).OrderBy(d => d.Definition.Items.Count).ToArray();
        _examples = definitions.SelectMany(d => d.Definition.Items.Select(i => (i.Kind, d.Name)).Distinct()).ToLookup(p => p.Kind, p => p.Name);
        var wires = definitions.SelectMany(d => Layout.Of(d.Definition).Wires).Select(w => (From: w.From.Item.Kind, To: w.To.Item.Kind)).Distinct().ToArray();
        _before = wires.ToLookup(w => w.To, w => w.From);
        _after = wires.ToLookup(w => w.From, w => w.To);
        _manual = Directory.GetFiles(Docs, "*.md").OrderBy(f => f, StringComparer.Ordinal).ToDictionary(f => Path.GetFileName(f)!, File.ReadAllText);
    }

    /// <summary>The files of docs, by their paths there.</summary>
    public SortedDictionary<string, string> All()
    {
        var pages = new SortedDictionary<string, string>(StringComparer.Ordinal) { ["components/README.md"] = Sheet() };
        foreach (var component in _components)
        {
            pages.Add("components/" + FileOf(component), Page(component));
            pages.Add(PictureOf(component), Picture.Svg(Layout.Of(new Definition([Capsule(component)], [])), Results.None, Shown.Icon));
        }
        return pages;
    }

    /// <summary>The components that no page of the manual links to.</summary>
    public IEnumerable<string> WithoutManual => _components.Where(c => !ManualOf(c).Any()).Select(c => c.Name);

    private static Definition Read(string name)
        => Definition.Read(File.ReadAllText(Path.Combine(Caterpillar.Tests.TestData.Repository, "examples", "gh", name + ".ghx")));

    private static string FileOf(GH_Component component) => Icons.NameOf(component.GetType()) + ".md";

    private static string PictureOf(GH_Component component) => "images/components/" + Icons.NameOf(component.GetType()) + ".svg";

    private static string Icon(GH_Component component)
        => $"![{component.NickName}](../../src/Caterpillar.GH/Resources/Icons/{Icons.NameOf(component.GetType())}.png)";

    private static string Link(GH_Component component) => $"[{component.Name}]({FileOf(component)})";

    // Names of other components within a sentence.
    private string WithLinks(string text, GH_Component component)
        => Regex.Replace(text, $"(?<=[a-z,] )({string.Join("|", _components.Select(c => c.Name).OrderByDescending(n => n.Length))})\\b",
            name => name.Value == component.Name ? name.Value : Link(_components.First(c => c.Name == name.Value)));

    private static Item Capsule(GH_Component component)
    {
        Port Of(IGH_Param param) => new(Guid.Empty, param.NickName, param.DataMapping == GH_DataMapping.None ? 0 : 1, []);
        return new Item(Guid.Empty, component.ComponentGuid, Look.Component, component.Name, component.NickName, default, default,
            component.Params.Input.Select(Of).ToArray(),
            component.Params.Output.Select((p, i) => Of(p) with { Id = new Guid(i + 1, 0, 0, new byte[8]) }).ToArray());
    }

    private string Sheet()
    {
        var text = new StringBuilder("# Components\n\nThe components of the plug-in by panel, with their inputs and outputs. These pages are made from the "
            + "components themselves.\n");
        foreach (var panel in Panels)
        {
            text.Append("\n## ").Append(panel).Append("\n\n| | component | in | out |\n|---|---|---|---|\n");
            foreach (var c in _components.Where(c => c.SubCategory == panel))
            {
                text.Append("| ").Append(Icon(c)).Append(" | ").Append(Link(c)).Append(" | ")
                    .Append(string.Join(", ", ((CaterpillarComponent)c).Declared.Select(d => d.Param.Name).Distinct())).Append(" | ")
                    .Append(string.Join(", ", c.Params.Output.Select(p => p.Name))).Append(" |\n");
            }
        }
        return text.ToString();
    }

    private string Page(GH_Component component)
    {
        var text = new StringBuilder();
        text.Append("# ").Append(Icon(component)).Append(' ').Append(component.Name).Append("\n\n")
            .Append(WithLinks(component.Description, component)).Append("\n\n")
            .Append($"![{component.Name} on the canvas](../{PictureOf(component)})\n\nPanel {component.SubCategory}, nickname {component.NickName}.");
        var manual = ManualOf(component).ToArray();
        if (manual.Length > 0) text.Append(" In the manual: ").Append(string.Join(", ", manual)).Append('.');
        text.Append('\n');
        var declared = ((CaterpillarComponent)component).Declared;
        Ports(text, "Inputs", component, declared.Select(d => d.Param).ToArray(), declared);
        Ports(text, "Outputs", component, component.Params.Output, []);
        Example(text, component);
        return text.ToString();
    }

    private IEnumerable<string> ManualOf(GH_Component component)
        => _manual.Where(p => p.Value.Contains($"](components/{FileOf(component)})")).Select(p => $"[{Title(p.Value)}](../{p.Key})");

    private static string Title(string page) => page.Substring(2, page.IndexOf('\n', 0) - 2);

    private void Example(StringBuilder text, GH_Component component)
    {
        var names = _examples[component.ComponentGuid].ToArray();
        if (names.Length == 0) return;
        text.Append("\n## Example\n\n").Append(LinkTo(names[0])).Append($":\n\n![{Spoken(names[0])}](../images/definitions/{names[0]}.svg)\n");
        if (names.Length > 1) text.Append("\nAlso in ").Append(string.Join(", ", names.Skip(1).Take(MostExamples).Select(LinkTo))).Append(".\n");
        var (before, after) = (Linked(_before[component.ComponentGuid]), Linked(_after[component.ComponentGuid]));
        if (before.Length > 0) text.Append("\nBefore it: ").Append(before).Append(".\n");
        if (after.Length > 0) text.Append("\nAfter it: ").Append(after).Append(".\n");
    }

    private string Linked(IEnumerable<Guid> kinds)
        => string.Join(", ", _components.Where(c => kinds.Contains(c.ComponentGuid)).Select(Link));

    private static string LinkTo(string name) => $"[{Spoken(name)}](../definitions.md#{name.Replace('_', '-')})";

    private static string Spoken(string name) => char.ToUpperInvariant(name[0]) + name.Substring(1).Replace('_', ' ');

    // For which choices a port is shown.
    private static string When(IReadOnlyList<DeclaredPort> declared, IGH_Param port)
    {
        string Words(PortCondition condition) => condition.Port + " " + string.Join(" or ", condition.Values.Select(value
            => ((ChoiceParam)declared.First(d => d.Param.Name == condition.Port).Param).Choices.First(c => c.Value == value).Key));
        var conditions = declared.FirstOrDefault(d => ReferenceEquals(d.Param, port))?.Conditions ?? [];
        return conditions.Count == 0 ? "" : $"*{string.Join(", ", conditions.Select(Words))}:* ";
    }

    private static string DefaultOf(DeclaredPort port) => port.Default switch
    {
        null => port.IsRequired ? "required" : "optional",
        int number when port.Param is ChoiceParam choice => choice.Choices.First(c => c.Value == number).Key,
        bool flag => flag ? "True" : "False",
        double number => NumberFormatter.Format(number, 6),
        int number => NumberFormatter.Format(number),
        var other => other.ToString()!,
    };

    private void Ports(StringBuilder text, string title, GH_Component component, IReadOnlyList<IGH_Param> ports, IReadOnlyList<DeclaredPort> declared)
    {
        var isInput = declared.Count > 0;
        text.Append("\n## ").Append(title).Append("\n\n| name | nickname | type | access |").Append(isInput ? " default |" : "")
            .Append(" description |\n").Append("|---|---|---|---|").Append(isInput ? "---|" : "").Append("---|\n");
        foreach (var port in ports)
        {
            text.Append("| ").Append(port.Name).Append(" | ").Append(port.NickName).Append(" | ")
                .Append(port is ChoiceParam ? "Choice" : port is Param_Geometry ? "Geometry" : port.TypeName).Append(" | ").Append(port.Access).Append(" | ");
            // A default that depends on others is part of the description.
            var stated = isInput ? Regex.Match(port.Description, @" ?Default: (.+?)\.(?= |$)") : Match.Empty;
            var input = declared.FirstOrDefault(d => ReferenceEquals(d.Param, port));
            if (isInput) text.Append(stated.Success && input!.Default is null ? stated.Groups[1].Value : DefaultOf(input!)).Append(" | ");
            var description = stated.Success && input!.Default is null ? port.Description.Remove(stated.Index, stated.Length) : port.Description;
            text.Append(When(declared, port)).Append(WithLinks(description.Replace("|", "\\|"), component));
            if (port is ChoiceParam choice) text.Append(" One of ").Append(string.Join(", ", choice.Choices.Select(c => $"{c.Key} ({c.Value})"))).Append('.');
            text.Append(" |\n");
        }
    }
}
