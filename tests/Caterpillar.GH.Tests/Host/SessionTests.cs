using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Path;
using Caterpillar.GH.Components.Simulate;
using Caterpillar.GH.Goos;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Data;
using Grasshopper.Kernel.Parameters;
using Grasshopper.Kernel.Types;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Host;

/// <summary>Whole sessions of a user.</summary>
[Category("Host")]
public sealed class SessionTests
{
    private readonly string _file = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N") + ".gcode");

    [TearDown]
    public void TearDown()
    {
        File.Delete(_file);
        File.Delete(_file + ".edited.gcode");
    }

    [Test]
    public void A_file_is_decoded_filtered_edited_previewed_and_saved()
    {
        WriteFile(layers: 24, linesOfLayer: 60);
        Session(out _);
    }

    [Test]
    [Explicit("66 MB; prints the time of each step.")]
    public void A_large_file_is_decoded_filtered_edited_previewed_and_saved()
    {
        WriteFile(layers: 1000, linesOfLayer: 2300);
        Session(out var times);
        TestContext.Out.WriteLine($"{new FileInfo(_file).Length / 1e6:0} MB: {times}");
    }

    [Test]
    public void Trees_with_grafts_nulls_and_wrong_types_give_what_they_can()
    {
        var document = new GH_Document();
        var source = new Param_GenericObject();
        Rg.LineCurve Line(double y) => new(new Rg.Point3d(50, y, 0.2), new Rg.Point3d(80, y, 0.2));
        void Add(int branch, params object?[] items)
        {
            foreach (var item in items) source.PersistentData.Append(item is null ? null! : Casting.Wrap(item), new GH_Path(0, branch));
        }
        Add(0, Line(50), null, Line(51));
        Add(1, "no curve", Line(52));
        Add(2, Line(53), Line(54));
        source.PersistentData.EnsurePath(new GH_Path(0, 3));
        document.AddObject(source, false);
        var path = new Canvas<ConstructPrintPathComponent>(document);
        path.Input("Curve").AddSource(source);
        path.Solve();
        Assert.That(path.Paths("Print Path"), Is.EqualTo(new[] { "{0;0}", "{0;1}", "{0;2}", "{0;3}" }), "The tree stays as it is.");
        Assert.That(path.All("Print Path").Select(p => p is not null), Is.EqualTo(new[] { true, false, true, false, true, true, true }));
        Assert.That(path.Errors.Concat(path.Warnings), Has.Some.Contains("{0;0}[1]").And.Some.Contains("conversion failed"));
        var plan = new Canvas<PlanToolpathComponent>(document);
        plan.Input("Steps").AddSource(path.Output("Print Path"));
        plan.Solve();
        Assert.That(plan.One<Toolpath>("Toolpath").Moves().Count(m => m.Kind == MoveKind.Print), Is.EqualTo(5));
        Assert.That(plan.Warnings, Has.Some.Contains("2 null items are ignored"));
        plan.Input("Steps").DataMapping = GH_DataMapping.Graft;
        plan.Component.ExpireSolution(false);
        plan.Solve();
        Assert.That(plan.All("Toolpath").Count(t => t is not null), Is.EqualTo(5), "Grafted, each path is a print of its own.");
        Assert.That(plan.Output("Toolpath").VolatileData.PathCount, Is.GreaterThanOrEqualTo(7), "And each null keeps its branch.");
        var bake = new Canvas<BakeToolpathComponent>(document).Feed("Bake", false);
        bake.Input("Toolpaths").AddSource(plan.Output("Toolpath"));
        bake.Solve();
        Assert.That(bake.Errors, Is.Not.Empty, "Branches without a toolpath are named.");
    }

    private void Session(out string times)
    {
        var text = "";
        void Step(string name, Action action)
        {
            var watch = Stopwatch.StartNew();
            action();
            text += $"{name} {watch.ElapsedMilliseconds} ms, ";
        }
        var document = new GH_Document();
        var decode = new Canvas<DecodeGCodeComponent>(document).Feed("File", _file);
        Step("decode", () => decode.Solve());
        var moves = decode.One<Toolpath>("Toolpath").Count;
        var lower = new Canvas<MoveFilterComponent>(document).Feed("Last Layer", 19);
        var filter = new Canvas<FilterToolpathComponent>(document);
        filter.Input("Filter").AddSource(lower.Output("Filter"));
        filter.Input("Toolpath").AddSource(decode.Output("Toolpath"));
        Step("filter", () => filter.Solve());
        var upper = new Canvas<MoveFilterComponent>(document).Feed("First Layer", 10);
        var edit = new Canvas<EditToolpathComponent>(document).Feed("Speed Factor", 0.5);
        edit.Input("Filter").AddSource(upper.Output("Filter"));
        edit.Input("Toolpath").AddSource(filter.Output("Toolpath"));
        Step("edit", () => edit.Solve());
        var preview = new Canvas<ToolpathPreviewComponent>(document).Feed("Color By", "Speed");
        preview.Input("Toolpath").AddSource(edit.Output("Toolpath"));
        Step("preview", () => preview.Solve());
        Assert.That(preview.All("Tags"), Has.Count.EqualTo(16), "Two speeds.");
        Assert.That(preview.Component.ClippingBox.Max.Z, Is.EqualTo(0.2 * 20).Within(1e-6));
        var generate = new Canvas<GenerateGCodeComponent>(document).Feed("Setup", "generic").Feed("Override Reason", "A test.");
        generate.Input("Toolpath").AddSource(edit.Output("Toolpath"));
        Step("generate", () => generate.Solve());
        Assert.That(generate.Errors, Is.Empty);
        var save = new Canvas<SaveGCodeComponent>(document).Feed("File", _file + ".edited.gcode").Feed("Save", false);
        save.Component.Params.Input[0].AddSource(generate.Output("G-code"));
        save.Solve();
        save.Feed("Save", true);
        Step("save", () => save.Solve());
        Assert.That(save.All("Path"), Is.EqualTo(new[] { _file + ".edited.gcode" }));
        var lines = File.ReadLines(_file + ".edited.gcode").ToArray();
        var before = File.ReadLines(_file).ToArray();
        Assert.That(lines.Take(100).Where(l => l.StartsWith("G1", StringComparison.Ordinal)), Is.SubsetOf(before.Take(100)), "Unedited lines stay.");
        Assert.That(lines, Has.None.StartsWith(";LAYER:20").And.Some.StartsWith(";LAYER:19"));
        Assert.That(lines.SkipWhile(l => l != ";LAYER:10").Any(l => l.Contains("F900")), Is.True, "Half of 1800 mm/min from layer 10 on.");
        Assert.That(moves, Is.GreaterThan(edit.One<Toolpath>("Toolpath").Count));
        times = text;
    }

    // Zigzag layers as a slicer writes them.
    private void WriteFile(int layers, int linesOfLayer)
    {
        using var text = new StreamWriter(_file);
        text.Write("G21\nG90\nM83\nM104 S200\nM109 S200\nG28\n");
        for (var layer = 0; layer < layers; layer++)
        {
            text.Write(";LAYER:" + Invariant(layer) + "\n;TYPE:WALL-OUTER\nG0 F6000 X50 Y50 Z" + Invariant(0.2 * (layer + 1)) + "\n");
            for (var i = 0; i < linesOfLayer; i++)
            {
                var speed = i == 0 ? "F1800 " : "";
                text.Write($"G1 {speed}X{Invariant(50 + 100.0 * (i % 2))} Y{Invariant(50 + 100.0 * i / linesOfLayer)} E3.32\n");
            }
        }
        text.Write("M104 S0\nM84\n");
    }

    private static string Invariant(double value) => value.ToString("0.###", System.Globalization.CultureInfo.InvariantCulture);
}
