using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Caterpillar.GH.Plugin;
using Caterpillar.GH.Base;
using Caterpillar.GH.Params;
using Grasshopper;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Parameters;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Plugin;

/// <summary>What Grasshopper and its users expect of names, descriptions, ids and icons.</summary>
[Category("Host")]
public sealed class MetadataTests
{
    private static readonly string[] Panels = [Panel.Setup, Panel.Design, Panel.Path, Panel.Slice, Panel.GCode, Panel.Simulate];

    [TestCaseSource(typeof(PluginTypes), nameof(PluginTypes.Objects))]
    public void Grasshopper_can_make_it(Type type)
    {
        Assert.That(type.IsPublic, "Grasshopper needs public classes.");
        Assert.That(type.GetConstructor(Type.EmptyTypes), Is.Not.Null, "Grasshopper needs a constructor without parameters.");
        Assert.That(PluginTypes.Make<IGH_DocumentObject>(type).ComponentGuid, Is.Not.EqualTo(Guid.Empty));
    }

    [Test]
    public void No_two_share_an_id()
    {
        var ids = PluginTypes.Objects.Select(t => PluginTypes.Make<IGH_DocumentObject>(t).ComponentGuid).Append(new PluginInfo().Id);
        Assert.That(ids, Is.Unique);
    }

    [TestCaseSource(typeof(PluginTypes), nameof(PluginTypes.Components))]
    public void Names_and_descriptions_are_complete(Type type)
    {
        var component = PluginTypes.Make<GH_Component>(type);
        Assert.That(component.Category, Is.EqualTo("Caterpillar"));
        Assert.That(Panels, Has.Member(component.SubCategory));
        Assert.That(component.Name, Does.Match("^[A-Z][A-Za-z-]*( [A-Z][A-Za-z-]*)*$"));
        Assert.That(component.NickName, Is.Not.Empty);
        Assert.That(component.Description, Does.EndWith("."));
        Assert.That(component.Description.Length, Is.GreaterThan(20));
    }

    [Test]
    public void No_two_components_share_a_name_or_nickname()
    {
        var all = PluginTypes.Components.Select(PluginTypes.Make<GH_Component>).ToArray();
        Assert.That(all.Select(c => c.Name), Is.Unique);
        Assert.That(all.Select(c => c.NickName), Is.Unique);
    }

    [TestCaseSource(typeof(PluginTypes), nameof(PluginTypes.Components))]
    public void Ports_are_named_described_and_told_apart(Type type)
    {
        var component = PluginTypes.Make<GH_Component>(type);
        foreach (var side in new[] { component.Params.Input, component.Params.Output })
        {
            Assert.That(side.Select(p => p.Name), Is.Unique);
            Assert.That(side.Select(p => p.NickName), Is.Unique);
            foreach (var port in side)
            {
                Assert.That(port.Name, Does.Match("^[A-Z][A-Za-z-]*( [A-Z][A-Za-z-]*)*$"));
                Assert.That(port.Description, Does.EndWith("."), port.Name);
                Assert.That(port.NickName.Length, Is.InRange(1, 3), port.Name);
            }
        }
    }

    [TestCaseSource(typeof(PluginTypes), nameof(PluginTypes.Components))]
    public void Numbers_state_their_unit(Type type)
    {
        var unit = new Regex(
            @"\b(mm|mm²|mm³|mm/s|°C|degrees|percent|seconds|grams|currency|ratio|[Ff]actor|from [01-9]|from -?1|[Nn]umber of|[Cc]ounts?)\b|mm²|mm³|°C|0 to 1");
        var component = PluginTypes.Make<GH_Component>(type);
        foreach (var port in component.Params.Where(p => p is Param_Number or Param_Integer
            && p is not (ChoiceParam or PrinterChoiceParam or MaterialChoiceParam or SettingsChoiceParam)))
            Assert.That(unit.IsMatch(port.Description), $"{port.Name}: {port.Description}");
    }

    [TestCaseSource(typeof(PluginTypes), nameof(PluginTypes.Components))]
    public void Singular_and_plural_follow_access(Type type)
    {
        // Words that are the same in both, or one value for many things.
        string[] collective = ["Geometry", "Settings", "Diagnostics", "Infill", "Generations", "Script", "Summary", "Printed On", "Material"];
        foreach (var port in PluginTypes.Make<GH_Component>(type).Params)
        {
            if (collective.Contains(port.Name)) continue;
            var plural = port.Name.EndsWith("s", StringComparison.Ordinal) && !port.Name.EndsWith("ss", StringComparison.Ordinal)
                && !port.Name.EndsWith("Radius", StringComparison.Ordinal);
            Assert.That(plural, Is.EqualTo(port.Access != GH_ParamAccess.item), port.Name);
        }
    }

    [TestCaseSource(typeof(PluginTypes), nameof(PluginTypes.Objects))]
    public void It_has_an_icon_of_24_pixels_with_an_empty_border(Type type)
    {
        using var stream = Icons.Open(Icons.NameOf(type));
        Assert.That(stream, Is.Not.Null, $"Draw {Icons.NameOf(type)} in tools/Caterpillar.Icons.");
        var (width, height, alpha) = PngAlpha.Read(stream!);
        Assert.That((width, height), Is.EqualTo((24, 24)));
        for (var i = 0; i < alpha.Length; i++)
        {
            int x = i % 24, y = i / 24;
            if (x < 2 || y < 2 || x > 21 || y > 21) Assert.That(alpha[i], Is.LessThan(128), $"({x}, {y}) touches the border");
        }
        Assert.That(alpha.Count(a => a > 200), Is.GreaterThan(20));
    }

    [Test]
    public void A_class_without_an_icon_gets_the_general_one()
    {
        Assert.That(Icons.Open("NoSuchComponent"), Is.Null);
        Assert.That(Icons.Open("Component"), Is.Not.Null);
        // On .NET without a drawing library there is no bitmap, and no exception either.
        Assert.That(() => Icons.Load("NoSuchComponent"), Throws.Nothing);
    }

    [Test]
    public void The_plug_in_introduces_itself()
    {
        var info = new PluginInfo();
        Assert.That(info.Name, Is.EqualTo("Caterpillar"));
        Assert.That(info.Version, Is.EqualTo("0.9.0"));
        Assert.That(info.License, Is.EqualTo(GH_LibraryLicense.opensource));
        Assert.That(new PluginPriority().PriorityLoad(), Is.EqualTo(GH_LoadingInstruction.Proceed));
        Assert.That(Instances.ComponentServer.Categories["Caterpillar symbol"], Is.EqualTo('C'));
    }

    [TestCase("net48")]
    [TestCase("net8.0")]
    public void No_part_of_the_host_is_next_to_the_plug_in(string framework)
    {
        var folder = Path.GetFullPath(Path.Combine(TestContext.CurrentContext.TestDirectory, "..", "..", "Caterpillar.GH"));
        var built = Directory.Exists(folder)
            ? Directory.GetDirectories(folder).Where(d => d.EndsWith("_" + framework, StringComparison.OrdinalIgnoreCase)).ToArray() : [];
        if (built.Length == 0) Assert.Ignore($"The plug-in is not built for {framework} here.");
        foreach (var output in built)
        {
            var dlls = Directory.GetFiles(output, "*.dll").Select(Path.GetFileName).OrderBy(f => f, StringComparer.Ordinal);
            Assert.That(dlls, Is.EqualTo(new[] { "Caterpillar.Core.dll", "Caterpillar.GH.dll", "Newtonsoft.Json.dll" }), output);
            Assert.That(Directory.GetFiles(output, "*.gha"), Is.Empty, "Only the release makes a .gha.");
        }
    }
}
