#if NET
using System.IO;
using Caterpillar.Tests;
using Caterpillar.Tests.Architecture;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Plugin;

/// <summary>The folders of the plug-in have an order, lowest first. Where types live is read from the debug information.</summary>
public class FolderTests
{
    [Test]
    public void Folders_use_only_those_before_them()
    {
        string[] order =
        [
            FolderOrder.Root, "Conversion", "Bake", "Plugin", "Preview", "Goos", "Params", "Base", "Components",
            "Components/Setup", "Components/Design", "Components/Path", "Components/Slice", "Components/GCode", "Components/Simulate",
        ];
        var source = Path.Combine(TestData.Repository, "src", "Caterpillar.GH");
        var uses = FolderUses.Of(typeof(Caterpillar.GH.Base.CaterpillarComponent).Assembly.Location, source);
        Assert.That(FolderOrder.Offenses(uses, "", order), Is.Empty);
    }
}
#endif
