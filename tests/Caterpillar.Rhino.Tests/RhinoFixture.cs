using System.IO;
using NUnit.Framework;
using Rhino.Testing.Fixtures;

namespace Caterpillar.Rhino.Tests;

/// <summary>Starts Rhino and loads the plug-in as Grasshopper does, once for all tests.</summary>
[SetUpFixture]
public sealed class RhinoFixture : RhinoSetupFixture
{
    public override void OneTimeSetup()
    {
        base.OneTimeSetup();
        var plugin = Path.Combine(TestContext.CurrentContext.TestDirectory, "Caterpillar.GH.dll");
        var gha = Path.ChangeExtension(plugin, ".gha");
        File.Copy(plugin, gha, overwrite: true);
        LoadGHA([gha]);
    }
}
