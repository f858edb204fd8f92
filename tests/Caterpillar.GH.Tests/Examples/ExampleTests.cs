using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Plugin;
using Caterpillar.GH.Tests.Host;
using GH_IO.Serialization;
using Grasshopper;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Parameters;
using Grasshopper.Kernel.Special;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Examples;

/// <summary>The definitions of examples/gh are those that the code makes; they open, solve without an error, and give the G-code of the golden files.</summary>
public sealed class ExampleTests
{
    private static readonly string Root = Caterpillar.Tests.TestData.Repository;

    // Their slicing takes seconds and is the library's, whose tests run on both runtimes.
    private static readonly HashSet<string> Slow = ["between_boundaries", "curved_roof", "planar_slice", "print_on_terrain", "vase", "wave_layers",
        "modifiers", "infill_curves", "draw_on_dome", "slanted_layers", "tilted_tool"];

    public static IEnumerable<string> Names => Definitions.All.Keys;

    /// <summary>The quick ones are those that any host solves.</summary>
    public static IEnumerable<TestCaseData> Solved()
        => Names.Select(name => Slow.Contains(name) ? new TestCaseData(name) : new TestCaseData(name).SetCategory("Host"));

    private static readonly ConcurrentDictionary<string, Lazy<(GH_Document Document, string Code)>> Solutions = new();

    private static bool Renews => Environment.GetEnvironmentVariable("CATERPILLAR_RENEW") == "1";

    [SetUp]
    public void SetUp() => Instances.ComponentServer.Load(typeof(PluginInfo).Assembly);

    [Category("Host")]
    [TestCaseSource(nameof(Names))]
    public void It_is_what_the_code_makes(string name)
    {
        var file = FileOf(name);
        var made = Sketch.Save(Definitions.All[name](name).Finish(file, Renews));
        if (Renews) File.WriteAllText(file, made, new UTF8Encoding(false));
        Assert.That(made, Is.EqualTo(File.ReadAllText(file).Replace("\r\n", "\n")), "Made with CATERPILLAR_RENEW=1.");
    }

    [TestCaseSource(nameof(Solved))]
    public void It_opens_solves_and_gives_the_G_code_of_its_golden_file(string name)
    {
        var (document, code) = Done(name);
        var golden = Path.Combine(Root, "tests", "Caterpillar.GH.Tests", "Examples", "Golden", name + ".gcode");
        if (Renews) File.WriteAllText(golden, GoldenCode.Short(code), new UTF8Encoding(false));
        Assert.That(GoldenCode.Short(code), Is.EqualTo(GoldenCode.Read(Root, name)));
        Assert.That(GoldenCode.Compared(code, GoldenCode.Read(Root, name)), Is.EqualTo("same"));
        var copy = new GH_Document { FilePath = FileOf(name) };
        var archive = new GH_Archive();
        var saved = Sketch.Save(document);
        archive.Deserialize_Xml(saved);
        Assert.That(archive.ExtractObject(copy, "Definition"), Is.True);
        Assert.That(Sketch.Save(copy), Is.EqualTo(saved), "Saved and opened again.");
        if (!Slow.Contains(name)) Assert.That(Solve(copy), Is.EqualTo(code), "And solved again.");
    }

    [TestCaseSource(nameof(Names))]
    public void Nothing_in_it_fails_or_warns(string name)
        // A panel without data is empty, which is no fault.
        => Assert.That(Done(name).Document.Messages().Where(m => !m.Contains(", Remark: ") && !m.StartsWith("Panel, ", StringComparison.Ordinal)), Is.Empty);

    [TestCaseSource(nameof(Names))]
    public void The_manual_shows_its_picture(string name)
    {
        var file = Path.Combine(Root, "docs", "images", "definitions", name + ".svg");
        var picture = Shown.Picture(Done(name).Document);
        Assert.That(picture, Does.Not.Contain("&lt;null&gt;"), "A panel of nothing.");
        if (Renews) File.WriteAllText(file, picture, new UTF8Encoding(false));
        Assert.That(picture, Is.EqualTo(File.ReadAllText(file).Replace("\r\n", "\n")), "Made with CATERPILLAR_RENEW=1.");
    }

    [Test]
    public void The_manual_shows_the_first_print_stage_by_stage()
    {
        string[][] added = [["Setup", "Model"], ["Slice"], ["Plan"], ["Look"], ["Save"]];
        for (var step = 1; step <= added.Length; step++)
        {
            var file = Path.Combine(Root, "docs", "images", "first_print", $"{step}.svg");
            var picture = Shown.Picture(Done("first_print").Document, added.Take(step).SelectMany(s => s).ToArray());
            if (Renews) File.WriteAllText(file, picture, new UTF8Encoding(false));
            Assert.That(picture, Is.EqualTo(File.ReadAllText(file).Replace("\r\n", "\n")), "Made with CATERPILLAR_RENEW=1.");
        }
    }

    /// <summary>All definitions end in the same parts that write: the quick ones are enough.</summary>
    public static IEnumerable<string> Opened => Names.Where(name => !Slow.Contains(name));

    [TestCaseSource(nameof(Opened))]
    public void Opening_it_with_every_Boolean_at_true_writes_nothing(string name)
    {
        var folder = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N"));
        Directory.CreateDirectory(folder);
        try
        {
            var document = Open(name);
            foreach (var save in document.Objects.OfType<GH_Panel>().Where(p => p.UserText == "example.gcode"))
                save.UserText = Path.Combine(folder, save.UserText);
            foreach (var toggle in document.Objects.OfType<GH_BooleanToggle>()) toggle.Value = true;
            foreach (var button in document.Objects.OfType<GH_ButtonObject>()) button.ButtonDown = true;
            foreach (var port in document.Objects.OfType<IGH_Component>().SelectMany(c => c.Params.Input).OfType<Param_Boolean>()
                .Where(p => p.SourceCount == 0))
                port.SetPersistentData(true);
            document.NewSolution(true);
            document.NewSolution(true);
            while (document.RunSchedule())
            {
            }
            Assert.That(Directory.GetFileSystemEntries(folder), Is.Empty);
        }
        finally
        {
            Directory.Delete(folder, true);
        }
    }

    private static string FileOf(string name) => Path.Combine(Root, "examples", "gh", name + ".ghx");

    private static GH_Document Open(string name)
    {
        var archive = new GH_Archive();
        Assert.That(archive.Deserialize_Xml(File.ReadAllText(FileOf(name))), Is.True);
        var document = new GH_Document { FilePath = FileOf(name) };
        Assert.That(archive.ExtractObject(document, "Definition"), Is.True, "All its objects are known.");
        return document;
    }

    private static (GH_Document Document, string Code) Done(string name) => Solutions.GetOrAdd(name, n => new(() =>
    {
        var document = Open(n);
        return (document, Solve(document));
    })).Value;

    private static string Solve(GH_Document document)
    {
        document.NewSolution(true);
        var errors = document.Objects.OfType<IGH_ActiveObject>()
            .SelectMany(o => o.RuntimeMessages(GH_RuntimeMessageLevel.Error).Select(m => o.NickName + ": " + m));
        Assert.That(errors, Is.Empty);
        var generate = document.Objects.OfType<GenerateGCodeComponent>().SingleOrDefault();
        if (generate is not null) return Encoding.UTF8.GetString(((GCodeGoo)generate.Params.Output[0].VolatileData.get_Branch(0)[0]!).Value.ToBytes());
        return Saved(document);
    }

    // What a definition without Generate writes when its button is pressed.
    private static string Saved(GH_Document document)
    {
        var file = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N") + ".gcode");
        var target = document.Objects.OfType<GH_Panel>().Single(p => p.UserText == "example.gcode");
        var button = document.Objects.OfType<GH_ButtonObject>().Single(b => b.NickName == "Save");
        (target.UserText, button.ButtonDown) = (file, true);
        document.NewSolution(true);
        var text = File.ReadAllText(file);
        File.Delete(file);
        (target.UserText, button.ButtonDown) = ("example.gcode", false);
        document.NewSolution(true);
        return text;
    }
}
