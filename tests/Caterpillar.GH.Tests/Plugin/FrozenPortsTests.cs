using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.GH.Base;
using Caterpillar.GH.Params;
using Caterpillar.GH.Tests.Api;
using Grasshopper.Kernel;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Plugin;

/// <summary>
/// Definitions find components by their id and ports by their position: neither may change. frozen-ports.txt lists them; new ports go to the end with a
/// default. To add what is new, run the tests with CATERPILLAR_RENEW_PORTS=1 and read the difference.
/// </summary>
public sealed class FrozenPortsTests
{
    private static string FrozenFile => Path.Combine(ApiFixture.TestFolder, "Plugin", "frozen-ports.txt");

    [Test]
    public void Ids_and_ports_are_those_of_the_list()
    {
        var now = Describe();
        if (Environment.GetEnvironmentVariable("CATERPILLAR_RENEW_PORTS") == "1") File.WriteAllText(FrozenFile, now, new UTF8Encoding(false));
        Assert.That(now, Is.EqualTo(File.ReadAllText(FrozenFile).Replace("\r\n", "\n")));
    }

    [Test]
    public void What_was_frozen_is_still_there_in_its_order()
    {
        var now = Sections(Describe());
        foreach (var frozen in Sections(File.ReadAllText(FrozenFile).Replace("\r\n", "\n")))
        {
            Assert.That(now, Does.ContainKey(frozen.Key), "A component or parameter is gone or has another id: hide it instead of removing it.");
            foreach (var side in new[] { "in ", "out " })
            {
                var before = frozen.Value.Where(l => l.StartsWith(side, StringComparison.Ordinal)).ToArray();
                var after = now[frozen.Key].Where(l => l.StartsWith(side, StringComparison.Ordinal)).Take(before.Length);
                Assert.That(after, Is.EqualTo(before), frozen.Key + ": ports keep their place, new ones go to the end.");
            }
        }
    }

    private static string Describe()
    {
        var text = new StringBuilder();
        foreach (var item in PluginTypes.Objects.Select(PluginTypes.Make<IGH_DocumentObject>))
        {
            text.Append(item.ComponentGuid).Append(' ').Append(item.GetType().Name).Append('\n');
            if (item is not GH_Component component) continue;
            foreach (var port in ((CaterpillarComponent)component).Declared) text.Append("  in ").Append(Port(port.Param)).Append(When(port)).Append('\n');
            foreach (var port in component.Params.Output) text.Append("  out ").Append(Port(port)).Append('\n');
        }
        return text.ToString();
    }

    private static string When(DeclaredPort port)
        => string.Concat(port.Conditions.Select(c => $" for {c.Port} {string.Join(", ", c.Values.OrderBy(v => v))}"));

    private static string Port(IGH_Param port)
    {
        var text = $"{port.Name} ({port.NickName}) {port.GetType().Name} {port.Access}";
        if (port.Optional) text += " optional";
        if (port.DataMapping != GH_DataMapping.None) text += " " + port.DataMapping.ToString().ToLowerInvariant();
        if (port is ChoiceParam choice) text += " [" + string.Join(", ", choice.Choices.Select(v => $"{v.Key}={v.Value}")) + "]";
        return text;
    }

    private static Dictionary<string, List<string>> Sections(string text)
    {
        var sections = new Dictionary<string, List<string>>(StringComparer.Ordinal);
        List<string>? current = null;
        foreach (var line in text.Split('\n').Where(l => l.Length > 0))
        {
            if (line[0] != ' ') sections.Add(line, current = []);
            else current!.Add(line.Trim());
        }
        return sections;
    }
}
