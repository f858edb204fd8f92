using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Grasshopper.Kernel;
using NUnit.Framework;
using Rhino.Testing.Fixtures;

namespace Caterpillar.Rhino.Tests;

/// <summary>Every example definition opens and solves without an error of any component.</summary>
[TestFixture]
public sealed class ExampleTests : RhinoTestFixture
{
    private static IEnumerable<string> Definitions()
    {
        var examples = Path.Combine(Repository(), "examples");
        return Directory.GetFiles(examples, "*.gh*", SearchOption.AllDirectories)
            .Where(f => f.EndsWith(".gh", StringComparison.OrdinalIgnoreCase) || f.EndsWith(".ghx", StringComparison.OrdinalIgnoreCase))
            .OrderBy(f => f, StringComparer.Ordinal);
    }

    [TestCaseSource(nameof(Definitions))]
    public void An_example_solves_without_errors(string file)
    {
        var io = new GH_DocumentIO();
        Assert.That(io.Open(file), Is.True);
        var document = io.Document;
        document.Enabled = true;
        document.NewSolution(false);
        var errors = document.Objects.OfType<IGH_ActiveObject>()
            .SelectMany(o => o.RuntimeMessages(GH_RuntimeMessageLevel.Error).Select(m => o.NickName + ": " + m));
        Assert.That(errors, Is.Empty);
        Assert.That(document.Objects.OfType<IGH_Component>().Count(c => c.Category == "Caterpillar"), Is.GreaterThan(0));
    }

    private static string Repository()
    {
        for (var folder = new DirectoryInfo(AppContext.BaseDirectory); folder is not null; folder = folder.Parent)
        {
            if (File.Exists(Path.Combine(folder.FullName, "Caterpillar.sln"))) return folder.FullName;
        }
        throw new DirectoryNotFoundException("Caterpillar.sln is not above " + AppContext.BaseDirectory);
    }
}
