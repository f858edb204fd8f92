using System.Linq;
using Caterpillar.GH.Tests.Api;
using Grasshopper.Kernel;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Recorded;

/// <summary>The stand-ins for Rhino and Grasshopper themselves.</summary>
public sealed class StandInTests
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

    [TestCase("RhinoCommon")]
    [TestCase("Grasshopper")]
    [TestCase("GH_IO")]
    public void The_stand_ins_state_what_they_are(string name)
    {
        var type = name switch { "RhinoCommon" => typeof(Rhino.RhinoDoc), "Grasshopper" => typeof(GH_Document), _ => typeof(GH_IO.GH_ISerializable) };
        string Of(string attribute) => (string)type.Assembly.GetCustomAttributesData().Single(a => a.AttributeType.Name == attribute).ConstructorArguments[0]
            .Value!;
        Assert.That(type.Assembly.GetName().Name, Is.EqualTo(name));
        Assert.That(Of("AssemblyTitleAttribute"), Is.EqualTo(name + " (headless stand-in)"));
        Assert.That(Of("AssemblyInformationalVersionAttribute"), Does.StartWith("7.37.0-headless"));
    }
}
