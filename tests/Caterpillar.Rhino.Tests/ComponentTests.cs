using System;
using System.Linq;
using Caterpillar.GH.Plugin;
using Grasshopper;
using Grasshopper.Kernel;
using NUnit.Framework;
using Rhino.Testing.Fixtures;

namespace Caterpillar.Rhino.Tests;

/// <summary>Grasshopper takes every component and parameter of the plug-in.</summary>
[TestFixture]
public sealed class ComponentTests : RhinoTestFixture
{
    [Test]
    public void Grasshopper_can_make_every_component_and_parameter()
    {
        var objects = typeof(PluginInfo).Assembly.GetExportedTypes().Where(t => !t.IsAbstract && typeof(IGH_DocumentObject).IsAssignableFrom(t)).ToArray();
        Assert.That(objects, Is.Not.Empty);
        foreach (var type in objects)
        {
            var id = ((IGH_DocumentObject)Activator.CreateInstance(type)!).ComponentGuid;
            var made = Instances.ComponentServer.EmitObject(id);
            Assert.That(made, Is.Not.Null, type.Name);
            Assert.That(made.Icon_24x24, Is.Not.Null, type.Name);
        }
    }
}
