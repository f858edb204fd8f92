using NUnit.Framework;

namespace Caterpillar.GH.Tests.Api;

/// <summary>What compiles against the stand-ins must load in Rhino.</summary>
public sealed class ApiCheckTests
{
    [TestCase("RhinoCommon")]
    [TestCase("GH_IO")]
    [TestCase("Grasshopper")]
    public void The_stand_in_shows_only_what_the_real_assembly_has(string assembly)
    {
        var check = ApiFixture.Check();
        using var module = ApiFixture.Open(assembly);
        check.CheckHost(module);
        Assert.That(check.Problems, Is.Empty, string.Join("\n", check.Problems));
    }

    [Test]
    public void The_plug_in_uses_and_overrides_only_what_exists()
    {
        var check = ApiFixture.Check();
        using var module = ApiFixture.Open("Caterpillar.GH");
        check.CheckPlugin(module);
        Assert.That(check.Problems, Is.Empty, string.Join("\n", check.Problems));
    }
}
