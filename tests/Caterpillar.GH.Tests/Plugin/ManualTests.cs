using System;
using System.IO;
using System.Linq;
using System.Text;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Plugin;

/// <summary>The pages of docs/components are made from the components themselves; CATERPILLAR_RENEW=1 writes them.</summary>
public sealed class ManualTests
{
    private static readonly string Docs = Path.Combine(Caterpillar.Tests.TestData.Repository, "docs");
    private static readonly string[] Folders = ["components", "images/components"];

    [Test]
    public void The_pages_show_every_component_as_it_is()
    {
        var pages = new ComponentPages().All();
        if (Environment.GetEnvironmentVariable("CATERPILLAR_RENEW") == "1")
        {
            foreach (var folder in Folders)
            {
                Directory.CreateDirectory(Path.Combine(Docs, folder));
                foreach (var old in Directory.GetFiles(Path.Combine(Docs, folder))) File.Delete(old);
            }
            foreach (var page in pages) File.WriteAllText(Path.Combine(Docs, page.Key), page.Value, new UTF8Encoding(false));
        }
        Assert.That(Folders.SelectMany(f => Directory.GetFiles(Path.Combine(Docs, f)).Select(file => f + "/" + Path.GetFileName(file))),
            Is.EquivalentTo(pages.Keys));
        foreach (var page in pages) Assert.That(File.ReadAllText(Path.Combine(Docs, page.Key)).Replace("\r\n", "\n"), Is.EqualTo(page.Value), page.Key);
    }

    [Test]
    public void Every_component_has_a_page_of_the_manual_that_explains_its_use() => Assert.That(new ComponentPages().WithoutManual, Is.Empty);
}
