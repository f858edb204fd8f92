using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.GH.Base;
using Caterpillar.GH.Params;
using Caterpillar.GH.Plugin;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Parameters;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Plugin;

/// <summary>The pages of docs/components are made from the components themselves; CATERPILLAR_RENEW=1 writes them.</summary>
public sealed class ManualTests
{
    private static readonly string[] Panels = [Panel.Setup, Panel.Design, Panel.Path, Panel.Slice, Panel.GCode, Panel.Simulate];

    private static string Folder => Path.Combine(Caterpillar.Tests.TestData.Repository, "docs", "components");

    [Test]
    public void The_pages_show_every_component_as_it_is()
    {
        var pages = Pages();
        if (Environment.GetEnvironmentVariable("CATERPILLAR_RENEW") == "1")
        {
            Directory.CreateDirectory(Folder);
            foreach (var old in Directory.GetFiles(Folder, "*.md")) File.Delete(old);
            foreach (var page in pages) File.WriteAllText(Path.Combine(Folder, page.Key), page.Value, new UTF8Encoding(false));
        }
        Assert.That(Directory.GetFiles(Folder, "*.md").Select(f => Path.GetFileName(f)!), Is.EquivalentTo(pages.Keys));
        foreach (var page in pages) Assert.That(File.ReadAllText(Path.Combine(Folder, page.Key)).Replace("\r\n", "\n"), Is.EqualTo(page.Value), page.Key);
    }

    private static SortedDictionary<string, string> Pages()
    {
        var components = PluginTypes.Components.Select(PluginTypes.Make<GH_Component>).OrderBy(c => c.Name, StringComparer.Ordinal).ToArray();
        var pages = new SortedDictionary<string, string>(StringComparer.Ordinal) { ["README.md"] = Sheet(components) };
        foreach (var component in components) pages.Add(FileOf(component), Page(component));
        return pages;
    }

    private static string FileOf(GH_Component component) => Icons.NameOf(component.GetType()) + ".md";

    private static string Icon(GH_Component component)
        => $"![{component.NickName}](../../src/Caterpillar.GH/Resources/Icons/{Icons.NameOf(component.GetType())}.png)";

    private static string Sheet(IReadOnlyList<GH_Component> components)
    {
        var text = new StringBuilder("# Components\n\nThe components of the plug-in by panel, with their inputs and outputs. These pages are made from the "
            + "components themselves.\n");
        foreach (var panel in Panels)
        {
            text.Append("\n## ").Append(panel).Append("\n\n| | component | in | out |\n|---|---|---|---|\n");
            foreach (var c in components.Where(c => c.SubCategory == panel))
            {
                text.Append("| ").Append(Icon(c)).Append(" | [").Append(c.Name).Append("](").Append(FileOf(c)).Append(") | ")
                    .Append(string.Join(", ", ((CaterpillarComponent)c).Declared.Select(d => d.Param.Name).Distinct())).Append(" | ")
                    .Append(string.Join(", ", c.Params.Output.Select(p => p.Name))).Append(" |\n");
            }
        }
        return text.ToString();
    }

    private static string Page(GH_Component component)
    {
        var text = new StringBuilder();
        text.Append("# ").Append(Icon(component)).Append(' ').Append(component.Name).Append("\n\n").Append(component.Description).Append("\n\nPanel ")
            .Append(component.SubCategory).Append(", nickname ").Append(component.NickName).Append(".\n");
        var declared = ((CaterpillarComponent)component).Declared;
        Ports(text, "Inputs", declared.Select(d => d.Param).ToArray(), p => declared.First(d => ReferenceEquals(d.Param, p)).IsRequired ? "yes" : "", declared);
        Ports(text, "Outputs", component.Params.Output, null, []);
        return text.ToString();
    }

    // For which choices a port is shown.
    private static string When(IReadOnlyList<DeclaredPort> declared, IGH_Param port)
    {
        string Words(PortCondition condition) => condition.Port + " " + string.Join(" or ", condition.Values.Select(value
            => ((ChoiceParam)declared.First(d => d.Param.Name == condition.Port).Param).Choices.First(c => c.Value == value).Key));
        var conditions = declared.FirstOrDefault(d => ReferenceEquals(d.Param, port))?.Conditions ?? [];
        return conditions.Count == 0 ? "" : $"*{string.Join(", ", conditions.Select(Words))}:* ";
    }

    private static void Ports(StringBuilder text, string title, IReadOnlyList<IGH_Param> ports, Func<IGH_Param, string>? required,
        IReadOnlyList<DeclaredPort> declared)
    {
        text.Append("\n## ").Append(title).Append("\n\n| name | nickname | type | access |").Append(required is null ? "" : " required |")
            .Append(" description |\n")
            .Append("|---|---|---|---|").Append(required is null ? "" : "---|").Append("---|\n");
        foreach (var port in ports)
        {
            text.Append("| ").Append(port.Name).Append(" | ").Append(port.NickName).Append(" | ")
                .Append(port is ChoiceParam ? "Choice" : port is Param_Geometry ? "Geometry" : port.TypeName)
                .Append(" | ")
                .Append(port.Access).Append(" | ");
            if (required is not null) text.Append(required(port)).Append(" | ");
            text.Append(When(declared, port)).Append(port.Description.Replace("|", "\\|"));
            if (port is ChoiceParam choice) text.Append(" One of ").Append(string.Join(", ", choice.Choices.Select(c => $"{c.Key} ({c.Value})"))).Append('.');
            text.Append(" |\n");
        }
    }
}
