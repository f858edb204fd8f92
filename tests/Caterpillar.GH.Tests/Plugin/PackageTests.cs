using System;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Xml.Linq;
using Caterpillar.GH.Plugin;
using Caterpillar.Package;
using Mono.Cecil;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Plugin;

/// <summary>The package for Rhino's package manager, made of the builds that are here.</summary>
public sealed class PackageTests
{
    private static readonly string[] FromRhino = ["RhinoCommon", "Grasshopper", "GH_IO", "System.Drawing.Common", "Microsoft.Win32.SystemEvents"];
    private static readonly string Texts = Caterpillar.Tests.TestData.Repository;
    private string _icon = "";

    private static string Build(string framework)
    {
        // debug_net10.0, release_net10.0
        var tests = new DirectoryInfo(TestContext.CurrentContext.TestDirectory);
        var folder = Path.Combine(tests.Parent!.Parent!.FullName, "Caterpillar.GH", tests.Name.Split('_')[0] + "_" + framework);
        if (!File.Exists(Path.Combine(folder, "Caterpillar.GH.dll"))) Assert.Ignore($"The plug-in is not built for {framework} here.");
        return folder;
    }

    [OneTimeSetUp]
    public void Prepare() => _icon = Path.Combine(Texts, "src", "Caterpillar.GH", "Resources", "package.png");

    private static byte[] Bytes(YakPackage package)
    {
        using var stream = new MemoryStream();
        package.Write(stream);
        return stream.ToArray();
    }

    [Test]
    public void A_package_for_Rhino_8_has_a_folder_for_each_runtime_with_all_that_is_needed()
    {
        var package = YakPackage.ForRhino8(Build("net48"), Build("net8.0"), _icon, Texts, "0.9.0");
        Assert.That(package.FileName, Is.EqualTo("caterpillar-0.9.0-rh8_20-any.yak"));
        using var zip = new ZipArchive(new MemoryStream(Bytes(package)), ZipArchiveMode.Read);
        var names = zip.Entries.Select(e => e.FullName).ToArray();
        Assert.That(names, Is.EqualTo(new[] { "LICENSE", "THIRD-PARTY-NOTICES.md", "icon.png", "manifest.yml",
            "net48/Caterpillar.Core.dll", "net48/Caterpillar.GH.gha", "net48/Newtonsoft.Json.dll",
            "net8.0/Caterpillar.Core.dll", "net8.0/Caterpillar.GH.gha", "net8.0/Newtonsoft.Json.dll" }));
        foreach (var folder in new[] { "net48/", "net8.0/" })
        {
            var inside = names.Where(n => n.StartsWith(folder, StringComparison.Ordinal)).Select(Path.GetFileNameWithoutExtension).ToArray();
            foreach (var entry in zip.Entries.Where(e => e.FullName.StartsWith(folder, StringComparison.Ordinal)))
            {
                using var content = new MemoryStream();
                using (var packed = entry.Open()) packed.CopyTo(content);
                content.Position = 0;
                using var module = ModuleDefinition.ReadModule(content);
                foreach (var needed in module.AssemblyReferences.Select(r => r.Name))
                {
                    Assert.That(inside.Contains(needed) || FromRhino.Contains(needed) || IsFramework(needed), Is.True, $"{entry.FullName} needs {needed}");
                }
            }
            Assert.That(inside.Intersect(FromRhino), Is.Empty);
        }
    }

    [Test]
    public void A_package_for_Rhino_7_is_flat()
    {
        var package = YakPackage.ForRhino7(Build("net48"), _icon, Texts, "1.2.3-beta");
        Assert.That(package.FileName, Is.EqualTo("caterpillar-1.2.3-beta-rh7_37-any.yak"));
        using var zip = new ZipArchive(new MemoryStream(Bytes(package)), ZipArchiveMode.Read);
        Assert.That(zip.Entries.Select(e => e.FullName),
            Is.EqualTo(new[] { "Caterpillar.Core.dll", "Caterpillar.GH.gha", "LICENSE",
                "Newtonsoft.Json.dll", "THIRD-PARTY-NOTICES.md", "icon.png", "manifest.yml" }));
    }

    [Test]
    public void The_manifest_states_what_the_package_manager_asks_for()
    {
        using var zip = new ZipArchive(new MemoryStream(Bytes(YakPackage.ForRhino7(Build("net48"), _icon, Texts, "0.9.0"))), ZipArchiveMode.Read);
        using var reader = new StreamReader(zip.GetEntry("manifest.yml")!.Open());
        var lines = reader.ReadToEnd().Split('\n');
        Assert.That(lines, Has.Member("name: caterpillar").And.Member("version: 0.9.0").And.Member("icon: icon.png"));
        Assert.That(lines, Has.Member("authors:").And.Member("- guid:" + new PluginInfo().Id));
        Assert.That(lines.Single(l => l.StartsWith("description: ", StringComparison.Ordinal)), Is.EqualTo("description: " + new PluginInfo().Description));
        Assert.That(lines, Has.None.Contains("\r").And.None.Contains("\t"));
    }

    [Test]
    public void The_notices_name_every_package_that_the_projects_bring_along()
    {
        var notices = File.ReadAllText(Path.Combine(Texts, "THIRD-PARTY-NOTICES.md"));
        foreach (var project in Directory.GetFiles(Path.Combine(Texts, "src"), "*.csproj", SearchOption.AllDirectories))
        {
            foreach (var package in XDocument.Load(project).Descendants("PackageReference").Where(p => p.Attribute("PrivateAssets") is null))
            {
                Assert.That(notices, Does.Contain($"| {package.Attribute("Include")!.Value} | {package.Attribute("Version")!.Value} |"), project);
            }
        }
    }

    [Test]
    public void The_same_build_gives_the_same_bytes_and_a_wrong_folder_is_refused()
    {
        Assert.That(Bytes(YakPackage.ForRhino7(Build("net48"), _icon, Texts, "0.9.0")),
            Is.EqualTo(Bytes(YakPackage.ForRhino7(Build("net48"), _icon, Texts, "0.9.0"))));
        Assert.That(() => YakPackage.ForRhino7(Path.GetTempPath() + "nothing", _icon, Texts, "0.9.0"), Throws.InvalidOperationException);
        var hosts = TestContext.CurrentContext.TestDirectory;
        Assert.That(() => YakPackage.ForRhino7(hosts, _icon, Texts, "0.9.0"), Throws.InvalidOperationException.With.Message.Contains("must not be packed"));
    }

    private static bool IsFramework(string name)
        => name is "mscorlib" or "netstandard" or "System" or "WindowsBase" || name.StartsWith("System.", StringComparison.Ordinal)
        || name.StartsWith("Microsoft.", StringComparison.Ordinal);
}
