using System;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.GCode;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Toolpaths;
using NUnit.Framework;
using Rhino;

namespace Caterpillar.GH.Tests.Components;

[Category("Host")]
public sealed class ToolpathEditTests
{
    private const string File = "; by hand\nM104 S210\nM109 S210\nG90\nM83\n;LAYER_CHANGE\n;TYPE:Perimeter\nG1 X10 Y10 Z0.2 F3000\nG1 X20 Y10 E0.5 F1200 ; "
        + "one\n"
        + ";TYPE:Internal infill\nG1 X20 Y20 E0.5\n;LAYER_CHANGE\n;TYPE:Perimeter\nG1 X20 Y20 Z0.4\nG1 X10 Y20 E0.5\n; end\n";

    private static ToolpathGoo Decoded()
        => (ToolpathGoo)new Canvas<DecodeGCodeComponent>().Feed("G-code", File).Solve().Output("Toolpath").VolatileData.get_Branch(0)[0]!;

    private static Toolpath Value(ToolpathGoo goo) => goo.Value;

    [Test]
    public void A_toolpath_is_taken_apart_with_a_branch_per_layer()
    {
        var canvas = new Canvas<DeconstructToolpathComponent>().Feed("Toolpath", Decoded()).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(canvas.Paths("Points"), Is.EqualTo(new[] { "{0;0;0}", "{0;0;1}" }).Or.EqualTo(new[] { "{0;0}", "{0;1}" }));
        Assert.That(canvas.All("Kinds"), Is.EqualTo(Value(Decoded()).Moves().Select(m => m.Kind.ToString())));
        Assert.That(canvas.All("Roles"), Has.Member("InnerWall").And.Member("Infill"));
        Assert.That(canvas.All("Sources"), Has.Member(9).And.Member(11));
        Assert.That(canvas.All("E Values").Cast<double>().Sum(), Is.EqualTo(1.5).Within(1e-9));
        Assert.That(canvas.All("Points").Last(), Is.EqualTo(new Rg.Point3d(10, 20, 0.4)));
    }

    [Test]
    public void Branches_have_the_numbers_of_the_layers_of_the_file()
    {
        var text = "G28\nG90\nM83\n;LAYER:3\n;TYPE:WALL-OUTER\nG1 X10 Y10 Z0.8 F3000\nG1 X20 E0.5\n;LAYER:4\nG1 X20 Y20 Z1 F3000\nG1 X10 E0.5\n";
        var goo = new Canvas<DecodeGCodeComponent>().Feed("G-code", text).Solve().Output("Toolpath").VolatileData.get_Branch(0)[0];
        var paths = new Canvas<DeconstructToolpathComponent>().Feed("Toolpath", goo).Solve().Paths("Points");
        Assert.That(paths.Where(p => p.EndsWith(";3}", StringComparison.Ordinal) || p.EndsWith(";4}", StringComparison.Ordinal)).Count(), Is.EqualTo(2));
    }

    [Test]
    public void Null_and_wrong_toolpaths_stop_only_their_item()
    {
        var apart = new Canvas<DeconstructToolpathComponent>().FeedTree("Toolpath", [null], [Decoded(), "G28"]).Solve();
        Assert.That(apart.All("Kinds"), Is.Not.Empty);
        Assert.That(apart.Warnings, Has.Count.EqualTo(2));
        var edited = new Canvas<EditToolpathComponent>().Feed("Toolpath", null, Decoded()).Feed("Speed Factor", 2).Solve();
        Assert.That(edited.All("Toolpath").Select(t => t is null), Is.EqualTo(new[] { true, false }));
        Assert.That(new Canvas<FilterToolpathComponent>().Solve().Warnings, Is.EqualTo(new[] { "Input parameter T failed to collect data" }));
    }

    [Test]
    public void Moves_of_a_role_a_layer_or_a_box_are_kept_or_removed()
    {
        var infill = new Canvas<FilterToolpathComponent>().Feed("Toolpath", Decoded()).Feed("Filter", Filter("Roles", "infill")).Solve();
        Assert.That(infill.Errors, Is.Empty);
        Assert.That(infill.One<Toolpath>("Toolpath").Moves().Where(m => m.Kind == MoveKind.Print).Select(m => m.Role).Distinct(),
            Is.EqualTo(new[] { Role.Infill }));
        var first = new Canvas<FilterToolpathComponent>().Feed("Toolpath", Decoded()).Feed("Filter", Filter("Last Layer", 0)).Feed("Remove", true).Solve();
        Assert.That(first.One<Toolpath>("Toolpath").Moves().Count(m => m.Kind == MoveKind.Print), Is.EqualTo(1));
        var box = new Canvas<FilterToolpathComponent>().Feed("Toolpath", Decoded())
            .Feed("Filter", Filter("Box", Rg.Brep.CreateFromBox(new Rg.BoundingBox(15, 5, 0, 25, 15, 1))))
            .Solve();
        Assert.That(box.One<Toolpath>("Toolpath").Moves().Count(m => m.Kind == MoveKind.Print), Is.EqualTo(1));
        Assert.That(new Canvas<MoveFilterComponent>().Feed("Roles", "infill", 99).Solve().Errors, Has.One.Contains("Roles has no choice 99"));
    }

    [Test]
    public void A_box_is_in_document_units()
    {
        var goo = Decoded();
        using var _ = new InDocument(UnitSystem.Centimeters);
        var box = new Canvas<FilterToolpathComponent>().Feed("Toolpath", goo)
            .Feed("Filter", Filter("Box", Rg.Brep.CreateFromBox(new Rg.BoundingBox(1.5, 0.5, 0, 2.5, 1.5, 1))))
            .Solve();
        Assert.That(box.One<Toolpath>("Toolpath").Moves().Count(m => m.Kind == MoveKind.Print), Is.EqualTo(1));
    }

    [Test]
    public void An_edited_file_is_written_again_with_only_its_edits()
    {
        var edit = new Canvas<EditToolpathComponent>().Feed("Toolpath", Decoded()).Feed("Filter", Filter("Roles", "Infill")).Feed("Speed Factor", 0.5).Solve();
        Assert.That(edit.Errors, Is.Empty);
        var goo = edit.Output("Toolpath").VolatileData.get_Branch(0)[0];
        var write = new Canvas<GenerateGCodeComponent>().Feed("Toolpath", goo).Feed("Setup", "generic").Solve();
        Assert.That(write.Errors, Is.Empty);
        var lines = Encoding.UTF8.GetString(write.One<GCodeDocument>("G-code").ToBytes()).Split('\n');
        Assert.That(lines.Except(File.Split('\n')), Has.All.Contains("F"), "Only lines with another speed are new.");
        Assert.That(lines, Has.Some.EqualTo("G1 X20 Y10 E0.5 F1200 ; one").And.Some.Contains("X20 Y20 E0.5 F600"));
        write.Feed("Rewrite All", true).Solve();
        Assert.That(Encoding.UTF8.GetString(write.One<GCodeDocument>("G-code").ToBytes()), Does.Not.Contain("; by hand"));
    }

    [Test]
    public void An_unedited_file_comes_back_byte_for_byte()
        => Assert.That(new Canvas<GenerateGCodeComponent>().Feed("Toolpath", Decoded()).Feed("Setup", "generic").Solve().One<GCodeDocument>("G-code")
            .ToBytes(),
            Is.EqualTo(Encoding.UTF8.GetBytes(File)));

    [Test]
    public void Pauses_tools_and_lines_come_before_their_layers()
    {
        var canvas = new Canvas<InsertAtLayerComponent>().Feed("Toolpath", Decoded()).Feed("Layers", 0, 1).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(canvas.One<Toolpath>("Toolpath").Events.Count(e => e.Event is PauseEvent), Is.EqualTo(2));
        Assert.That(canvas.Feed("Layers", 17).Solve().Warnings, Has.One.Contains("Layer 17 not found."));
        canvas.Feed("Layers", 1).Feed("Kind", "Tool").Feed("Value", 1).Solve();
        Assert.That(canvas.One<Toolpath>("Toolpath").Moves().Last().Tool, Is.EqualTo(1));
        Assert.That(canvas.Feed("Value", 1.5).Solve().Errors, Has.One.Contains("a tool number from 0 to 99"));
        Assert.That(canvas.Feed("Kind", "Fan").Feed("Value", 2).Solve().Errors, Has.One.Contains("from 0 to 1"));
        foreach (var (kind, value, expected) in new (string, double, PrinterEvent)[]
        {
            ("Nozzle Temperature", 600, new NozzleTemperatureEvent(600, true)), ("Bed Temperature", 300, new BedTemperatureEvent(300, true)),
            ("Fan", 1, new FanEvent(1)), ("Dwell", 1e6, new DwellEvent(1e6)),
        })
        {
            var toolpath = canvas.Feed("Kind", kind).Feed("Value", value).Solve().One<Toolpath>("Toolpath");
            Assert.That(toolpath.Events.Select(e => e.Event), Has.Member(expected));
            Assert.That(canvas.Feed("Value", value + 0.01).Solve().Errors, Is.Not.Empty, kind);
        }
        var raw = canvas.Feed("Kind", "Raw Line").Feed("Text", "M117 nuts").Solve();
        Assert.That(Written(raw.Output("Toolpath").VolatileData.get_Branch(0)[0]), Is.EqualTo(File.Replace("G1 X20 Y20 Z0.4", "M117 nuts\nG1 X20 Y20 Z0.4")));
    }

    [Test]
    public void A_transform_moves_the_layers_in_document_units()
    {
        var goo = Decoded();
        using var _ = new InDocument(UnitSystem.Centimeters);
        var edit = new Canvas<EditToolpathComponent>().Feed("Toolpath", goo).Feed("Transform", Rg.Transform.Translation(0.5, 0, 0)).Solve();
        Assert.That(edit.Errors, Is.Empty);
        Assert.That(Written(edit.Output("Toolpath").VolatileData.get_Branch(0)[0]), Is.EqualTo(File.Replace("X20", "X25").Replace("X10", "X15")));
        Assert.That(edit.Feed("Flow Factor", -1).Solve().Errors, Has.One.Contains("Flow Factor must be 0 or more"));
        Assert.That(edit.Feed("Flow Factor", 1).Feed("Speed Factor", 0).Solve().Errors, Has.One.Contains("Speed Factor must be greater than zero"));
    }

    [Test]
    public void Formulas_deform_a_decoded_file()
    {
        var bend = new Canvas<DeformToolpathComponent>().Feed("Toolpath", Decoded()).Feed("Z", "z + x / 100").Solve();
        Assert.That(bend.Errors, Is.Empty);
        var before = Value(Decoded()).Moves().Where(m => m.Kind == MoveKind.Print).ToArray();
        var after = bend.One<Toolpath>("Toolpath").Moves().Where(m => m.Kind == MoveKind.Print).ToArray();
        Assert.That(after.Select(m => m.End.Z), Is.EqualTo(before.Select(m => m.End.Z + m.End.X / 100)).Within(1e-12));
        Assert.That(after[0].E, Is.EqualTo(0.5 * Math.Sqrt(1 + 1e-4)).Within(1e-12));
        Assert.That(bend.Feed("Z", "z +").Solve().Errors, Is.Not.Empty);
        Assert.That(bend.Feed("Z", "z").Feed("Tolerance", 0).Solve().Errors, Has.One.Contains("Tolerance must be greater than zero"));
        var turned = new Canvas<DeformToolpathComponent>().Feed("Toolpath", Decoded()).Feed("System", "Cylindrical").Feed("Theta", "theta + 90")
            .Feed("Plane", new Rg.Plane(new Rg.Point3d(10, 10, 0), Rg.Vector3d.XAxis, Rg.Vector3d.YAxis)).Solve();
        Assert.That(turned.One<Toolpath>("Toolpath").Moves().First(m => m.Kind == MoveKind.Print).End.DistanceTo(new Caterpillar.Geometry.Vec3(10, 20, 0.2)),
            Is.LessThan(1e-9));
    }

    [Test]
    public void Start_and_end_code_of_a_decoded_file_are_replaced_and_checked()
    {
        var write = new Canvas<GenerateGCodeComponent>().Feed("Toolpath", Decoded()).Feed("Setup", "generic").Feed("Start G-code",
            "M104 S200\nM109 S200\nG28")
            .Feed("End G-code", "M84").Solve();
        Assert.That(write.Errors, Is.Empty);
        var text = Encoding.UTF8.GetString(write.One<GCodeDocument>("G-code").ToBytes());
        Assert.That(text, Does.StartWith("M104 S200\nM109 S200\nG28\n").And.EndWith("M84\n").And.Contain("G1 X20 Y10 E0.5 F1200 ; one")
            .And.Not.Contain("by hand"));
        Assert.That(write.Feed("Start G-code", "M104 S200\nG1 X900").Solve().Errors, Is.Not.Empty, "the new lines are checked too");
        Assert.That(write.Feed("Rewrite All", true).Solve().Warnings, Has.Some.Contains("Start G-code"));
    }

    private static string Written(object? goo)
        => Encoding.UTF8.GetString(new Canvas<GenerateGCodeComponent>().Feed("Toolpath", goo).Feed("Setup", "generic").Solve().One<GCodeDocument>("G-code")
            .ToBytes());

    [Test]
    public void Saving_happens_once_per_press_and_never_overwrites_a_file_by_default()
    {
        var folder = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N"));
        Directory.CreateDirectory(folder);
        try
        {
            var file = Path.Combine(folder, "out.gcode");
            var canvas = new Canvas<SaveGCodeComponent>();
            canvas.Document.FilePath = Path.Combine(folder, "definition.gh");
            canvas.Feed("G-code", GCodeDocument.FromText(File)).Feed("File", "out.gcode").Solve();
            Assert.That(System.IO.File.Exists(file), Is.False, "Nothing is written without a press.");
            canvas.Feed("Save", true).Solve();
            Assert.That(canvas.Errors, Is.Empty);
            Assert.That(System.IO.File.ReadAllText(file), Is.EqualTo(File));
            Assert.That(canvas.One<string>("Path"), Is.EqualTo(file));
            System.IO.File.WriteAllText(file, "changed");
            canvas.Component.ExpireSolution(false);
            canvas.Solve();
            Assert.That(System.IO.File.ReadAllText(file), Is.EqualTo("changed"), "Held down, it does not write again.");
            Assert.That(canvas.Errors, Is.Empty, "Nor does it try to.");
            canvas.Feed("Save", false).Solve().Feed("Save", true).Solve();
            Assert.That(canvas.Errors, Has.One.Contains("already exists. Set Overwrite to true"));
            Assert.That(System.IO.File.ReadAllText(file), Is.EqualTo("changed"));
            canvas.Feed("Save", false).Feed("Overwrite", true).Solve().Feed("Save", true).Solve();
            Assert.That(System.IO.File.ReadAllText(file), Is.EqualTo(File));
            canvas.Feed("G-code", GCodeDocument.FromText("G28\n")).Feed("Save", false).Solve();
            Assert.That(canvas.All("Path"), Is.EqualTo(new object?[] { null }), "Other G-code is not in the file yet.");
            Assert.That(Directory.GetFiles(folder), Has.Length.EqualTo(1));
            canvas.Feed("File", "out.bgcode").Feed("Save", true).Solve();
            Assert.That(GCodeDocument.ReadFile(Path.Combine(folder, "out.bgcode")).Value!.ToBytes(), Is.EqualTo(Encoding.ASCII.GetBytes("\nG28\n")),
                "The name asks for binary code.");
        }
        finally
        {
            Directory.Delete(folder, true);
        }
    }

    [Test]
    public void A_toggle_that_is_true_from_the_start_writes_nothing_until_it_has_been_false()
    {
        var file = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N") + ".gcode");
        try
        {
            var canvas = new Canvas<SaveGCodeComponent>().Feed("G-code", "G28").Feed("File", file).Feed("Save", true).Solve();
            canvas.Feed("G-code", "G29").Solve();
            Assert.That(System.IO.File.Exists(file), Is.False, "As a definition opens that was saved with the toggle at true.");
            canvas.Feed("Save", false).Solve().Feed("G-code", [null]).Feed("Save", true).Solve().Feed("G-code", "G28").Solve();
            Assert.That(System.IO.File.Exists(file), Is.False, "A press while the G-code was bad is not made up for.");
            canvas.Feed("Save", false).Solve().Feed("Save", true).Solve();
            Assert.That(System.IO.File.ReadAllText(file), Is.EqualTo("G28"));
        }
        finally
        {
            System.IO.File.Delete(file);
        }
    }

    [Test]
    public void A_missing_folder_is_an_error()
    {
        var canvas = new Canvas<SaveGCodeComponent>().Feed("G-code", "G28", null).Feed("File", Path.Combine(Path.GetTempPath(), "no such folder", "a.gcode"))
            .Solve().Feed("Save", true).Solve();
        Assert.That(canvas.Errors, Has.Count.EqualTo(1));
        Assert.That(canvas.Warnings, Has.Member("{0}[1]: G-code is missing."));
    }

    private static MoveFilter Filter(string port, params object?[] values)
        => new Canvas<MoveFilterComponent>().Feed(port, values).Solve().One<MoveFilter>("Filter");
}
