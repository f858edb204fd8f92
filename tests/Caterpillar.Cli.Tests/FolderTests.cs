using System.IO;
using System.Linq;
using Caterpillar.Tests;
using Caterpillar.Tests.Architecture;
using Mono.Cecil;
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

    // On Linux, cryptography is OpenSSL, which small images do not have: the runtime ends a program that asks for it. DecodeVerb looks whether it is there.
    [Test]
    public void Nothing_but_the_digest_of_a_decoded_file_needs_cryptography()
    {
        foreach (var type in new[] { typeof(Caterpillar.Cli.Session), typeof(Caterpillar.Toolpaths.Toolpath) })
        {
            using var module = ModuleDefinition.ReadModule(type.Assembly.Location);
            var users = module.GetTypes().SelectMany(t => TypeUses.Of(t).Where(u => u.Used.Namespace == "System.Security.Cryptography").Select(_ => t.Name));
            Assert.That(users.Distinct(), Is.SubsetOf(new[] { nameof(DecodeVerb) }));
        }
    }
}
