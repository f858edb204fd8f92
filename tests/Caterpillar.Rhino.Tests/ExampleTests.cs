using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Tests.Examples;
using Grasshopper.Kernel;
using NUnit.Framework;
using Rhino.Testing.Fixtures;

namespace Caterpillar.Rhino.Tests;

/// <summary>
/// Every example definition opens and solves without an error of any component. <c>artifacts/rhino-report.txt</c> says how its G-code compares with the golden
/// file, for docs/rhino-only.md.
/// </summary>
[TestFixture]
public sealed class ExampleTests : RhinoTestFixture
{
    private readonly SortedDictionary<string, string> _report = new(StringComparer.Ordinal);

    [OneTimeTearDown]
    public void WriteReport()
    {
        var lines = new[] { $"Rhino {global::Rhino.RhinoApp.Version}, {Environment.OSVersion}, .NET {Environment.Version}", "" }
            .Concat(_report.Select(r => r.Key.PadRight(22) + r.Value));
        File.WriteAllLines(Path.Combine(Directory.CreateDirectory(Path.Combine(Repository(), "artifacts")).FullName, "rhino-report.txt"), lines);
    }

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
            .SelectMany(o => o.RuntimeMessages(GH_RuntimeMessageLevel.Error).Select(m => o.NickName + ": " + m)).ToArray();
        var name = Path.GetFileNameWithoutExtension(file);
        _report[name] = errors.Length > 0 ? "failed: " + string.Join("; ", errors) : Compared(document, name);
        Assert.That(errors, Is.Empty);
        Assert.That(document.Objects.OfType<IGH_Component>().Count(c => c.Category == "Caterpillar"), Is.GreaterThan(0));
    }

    // Breps are meshed by Rhino itself: other G-code is no failure, but worth reading.
    private static string Compared(GH_Document document, string name)
    {
        var generate = document.Objects.OfType<GenerateGCodeComponent>().SingleOrDefault();
        if (generate is null) return "solves; writes only at its button";
        return generate.Params.Output[0].VolatileData.AllData(true).FirstOrDefault() is GCodeGoo code
            ? GoldenCode.Compared(Encoding.UTF8.GetString(code.Value.ToBytes()), GoldenCode.Read(Repository(), name))
            : "failed: no G-code";
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
