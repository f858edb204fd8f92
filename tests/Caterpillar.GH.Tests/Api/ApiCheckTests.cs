using NUnit.Framework;

namespace Caterpillar.GH.Tests.Api;

/// <summary>What compiles against the stand-ins must load in Rhino.</summary>
[Category("Host")]
public sealed class ApiCheckTests
{
    [Test]
    public void The_plug_in_uses_and_overrides_only_what_exists()
    {
        var check = ApiFixture.Check();
        using var module = ApiFixture.Open("Caterpillar.GH");
        check.CheckPlugin(module);
        Assert.That(check.Problems, Is.Empty, string.Join("\n", check.Problems));
        Print("plug-in", check);
    }

    [TestCase("RhinoCommon")]
    [TestCase("GH_IO")]
    [TestCase("Grasshopper")]
    public void A_stand_in_shows_only_what_exists(string name)
    {
        var check = ApiFixture.Check();
        using var module = ApiFixture.Open(name);
        if (module.Assembly.Name.HasPublicKey) Assert.Ignore($"This {name} is the real one.");
        check.CheckHost(module);
        Assert.That(check.Problems, Is.Empty, string.Join("\n", check.Problems));
        Print(name, check);
    }

    private static void Print(string name, ApiCheck check)
    {
        foreach (var source in check.Found) TestContext.Out.WriteLine($"{name}: {source.Value.Count} members by {source.Key}");
    }
}
