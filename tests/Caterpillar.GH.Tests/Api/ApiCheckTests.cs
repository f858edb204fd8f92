using NUnit.Framework;

namespace Caterpillar.GH.Tests.Api;

/// <summary>What compiles against the stand-ins must load in Rhino.</summary>
public sealed class ApiCheckTests
{
    [Test]
    public void The_plug_in_uses_and_overrides_only_what_exists()
    {
        var check = ApiFixture.Check();
        using var module = ApiFixture.Open("Caterpillar.GH");
        check.CheckPlugin(module);
        Assert.That(check.Problems, Is.Empty, string.Join("\n", check.Problems));
    }
}
