using System.IO;
using Caterpillar.Tests;
using Caterpillar.Tests.Architecture;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

/// <summary>The folders of the terminal program have an order, lowest first. Where types live is read from the debug information.</summary>
public class FolderTests
{
    [Test]
    public void Folders_use_only_those_before_them()
    {
        string[] order =
        [
            "Reports", "Running", "Options", "Viewing", "Verbs", "Usage", "Batches", FolderOrder.Root,
        ];
        var uses = FolderUses.Of(typeof(Caterpillar.Cli.Session).Assembly.Location, Path.Combine(TestData.Repository, "src", "Caterpillar.Cli"));
        Assert.That(FolderOrder.Offenses(uses, "", order), Is.Empty);
    }
}
