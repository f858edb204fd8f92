using System;
using System.IO;
using System.Linq;
using Caterpillar.GCode;
using Caterpillar.GH.Components.Design;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Path;
using Caterpillar.GH.Components.Setup;
using Caterpillar.GH.Components.Simulate;
using Caterpillar.GH.Components.Slice;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.GH.Plugin;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using GH_IO.Serialization;
using Grasshopper;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Parameters;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Components;

/// <summary>Printer, material, settings and what is printed on go along one wire, and paths remember them.</summary>
[Category("Host")]
public sealed class OneSetupTests
{
    private static readonly PrintPath Line = new([new(50, 50, 0.2), new(80, 50, 0.2)], new Bead(0.08, 0.2));

    private static PrintSetup SetupOf(string printer) => new ProfileLibrary().Setup(printer).OrThrow();

    private static double[] SpeedsOf(Toolpath toolpath) => toolpath.Moves().Where(m => m.Kind == MoveKind.Print).Select(m => m.Speed).Distinct().ToArray();

    [Test]
    public void From_a_mesh_to_a_saved_file_every_number_fits_the_clay_printer()
    {
        var document = new GH_Document();
        var setup = new Canvas<PrintSetupComponent>(document).Feed("Printer", "potter_super");
        var slicer = new Canvas<PlanarSlicerComponent>(document).Feed("Geometry", Shapes.Box(150, 150, 60, 12));
        var plan = new Canvas<PlanToolpathComponent>(document);
        var file = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N") + ".gcode");
        var save = new Canvas<SaveGCodeComponent>(document).Feed("File", file).Feed("Save", false);
        slicer.Input("Setup").AddSource(setup.Output("Setup"));
        plan.Input("Steps").AddSource(slicer.Output("Print Paths"));
        save.Input("G-code").AddSource(plan.Output("Toolpath"));
        try
        {
            document.NewSolution(false);
            Assert.That(File.Exists(file), Is.False);
            save.Feed("Save", true).Solve();
            Assert.That(document.Objects.OfType<IGH_ActiveObject>().SelectMany(o => o.RuntimeMessages(GH_RuntimeMessageLevel.Error)), Is.Empty);
            Assert.That(plan.Warnings, Is.Empty);
            Assert.That(save.One<string>("Path"), Is.EqualTo(file));
            var clay = SetupOf("potter_super");
            var (printer, settings) = (clay.Printer, clay.Settings);
            var read = GCodeDecoder.Decode(GCodeDocument.ReadFile(file).OrThrow(), new DecodeOptions { Flavor = printer.Flavor }).OrThrow().Toolpath;
            var prints = read.Moves().Where(m => m.Kind == MoveKind.Print && m.Layer >= 0).ToArray();
            Assert.That(prints, Is.Not.Empty);
            Assert.That(read.Layers.Select(l => l.Z), Is.EqualTo(Enumerable.Range(1, 8).Select(i => 1.5 * i)).Within(1e-6));
            var area = Bead.FromWidth(settings.LineWidth, settings.LayerHeight, shape: settings.BeadShape).Area;
            var perE = clay.Extrusion.VolumePerE!.Value;
            var walls = prints.Where(m => m.Length > 40).Select(m => m.Deposited * perE / m.Length).ToArray();
            Assert.That(walls, Is.Not.Empty);
            Assert.That(walls, Has.All.EqualTo(area * clay.Material.FlowRatio).Within(0.05 * area),
                "Lines of 3.4 mm, not of 0.45 mm; solid infill is spaced to fit.");
            Assert.That(prints.Select(m => m.Speed), Has.All.LessThanOrEqualTo(settings.PrintSpeed + 1e-6));
            Assert.That(prints.Max(m => m.Speed), Is.EqualTo(settings.PrintSpeed).Within(1e-6));
            Assert.That(read.Moves().Where(m => m.Kind == MoveKind.Travel && m.Layer >= 0).Max(m => m.Speed),
                Is.LessThanOrEqualTo(settings.TravelSpeed + 1e-6));
            Assert.That(File.ReadAllLines(file), Has.Some.StartsWith("M302 P1"), "The start code of the printer.");
        }
        finally
        {
            File.Delete(file);
        }
    }

    [Test]
    public void Settings_that_only_the_slicer_has_are_planned_with()
    {
        var settings = SetupOf("generic").Settings with { PrintSpeed = 33, OuterWallSpeed = 33, FirstLayerSpeed = 33 };
        var slicer = new Canvas<PlanarSlicerComponent>().Feed("Setup", settings).Feed("Geometry", Shapes.Box(height: 0.4));
        var plan = new Canvas<PlanToolpathComponent>(slicer.Document);
        plan.Input("Steps").AddSource(slicer.Output("Print Paths"));
        plan.Solve();
        Assert.That(plan.Errors.Concat(plan.Warnings), Is.Empty);
        Assert.That(SpeedsOf(plan.One<Toolpath>("Toolpath")), Is.EqualTo(new[] { 33.0 }));
        plan.Feed("Setup", "generic").Solve();
        Assert.That(plan.Warnings.Single(), Does.Contain("setup.differs").And.Contain("print_speed_mm_s (33, here 60)").And.Contain("outer_wall_speed_mm_s"));
        plan.Feed("Setup", settings).Solve();
        Assert.That(plan.Warnings, Is.Empty, "The same values are the same setup.");
    }

    [Test]
    public void A_plan_for_another_printer_names_what_differs()
    {
        var slicer = new Canvas<PlanarSlicerComponent>().Feed("Geometry", Shapes.Box(height: 0.4));
        var plan = new Canvas<PlanToolpathComponent>(slicer.Document).Feed("Setup", "potter_super");
        plan.Input("Steps").AddSource(slicer.Output("Print Paths"));
        plan.Solve();
        Assert.That(plan.Warnings.Single(), Does.Contain("line_width_mm (0.45, here 3.4)").And.Contain(" more differ. Connect the same Print Setup to both."));
        Assert.That(plan.One<Toolpath>("Toolpath").Count, Is.GreaterThan(0));
        var check = new Canvas<CheckComponent>(slicer.Document).Feed("Setup", "ender3");
        check.Input("Toolpath").AddSource(plan.Output("Toolpath"));
        check.Solve();
        Assert.That(check.Warnings, Has.Some.Contains("The toolpath was made with another setup"));
    }

    [Test]
    public void Turtles_traces_and_curves_remember_their_setup_through_moves_and_sorting()
    {
        var ring = new Canvas<RoundTraceComponent>().Feed("Radius", 30.0).Feed("Setup", "potter_super");
        var sorted = new Canvas<SortPathsComponent>(ring.Document);
        var plan = new Canvas<PlanToolpathComponent>(ring.Document);
        sorted.Input("Print Paths").AddSource(ring.Output("Print Path"));
        plan.Input("Steps").AddSource(sorted.Output("Print Paths"));
        plan.Solve();
        var goo = (ToolpathGoo)plan.Output("Toolpath").VolatileData.get_Branch(0)[0]!;
        Assert.That(goo.Setup, Is.EqualTo(SetupOf("potter_super")));
        Assert.That(ring.One<PrintPath>("Print Path").BeadOf(0).Width(BeadShape.Stadium), Is.EqualTo(3.4).Within(1e-9));
        var moved = (PrintPathGoo)((PrintPathGoo)ring.Output("Print Path").VolatileData.get_Branch(0)[0]!).Transform(Rg.Transform.Translation(5, 0, 0))!;
        Assert.That(moved.Setup, Is.EqualTo(SetupOf("potter_super")));
        var own = new Canvas<RoundTraceComponent>().Feed("Radius", 30.0).Feed("Bead", new Bead(1, 0.5)).Solve();
        Assert.That(((PrintPathGoo)own.Output("Print Path").VolatileData.get_Branch(0)[0]!).Setup, Is.Null, "Nothing of it comes from a setup.");
        var turtle = new Canvas<TurtleComponent>().Feed("Program", "forward 1").Feed("Setup", "lutum").Solve();
        Assert.That(((StepGoo)turtle.Output("Steps").VolatileData.get_Branch(0)[0]!).Setup, Is.EqualTo(SetupOf("lutum")));
    }

    [Test]
    public void A_curve_connected_as_it_is_gets_the_bead_of_the_setup()
    {
        var curve = new Rg.LineCurve(new Rg.Point3d(150, 150, 1.5), new Rg.Point3d(190, 150, 1.5));
        var plan = new Canvas<PlanToolpathComponent>().Feed("Steps", curve).Feed("Setup", "potter_super").Feed("Mode", "As Drawn").Solve();
        Assert.That(plan.Errors.Concat(plan.Warnings), Is.Empty);
        var clay = SetupOf("potter_super");
        var print = plan.One<Toolpath>("Toolpath").Moves().Single(m => m.Kind == MoveKind.Print);
        var area = Bead.FromWidth(3.4, 1.5, shape: BeadShape.Stadium).Area * clay.Material.FlowRatio;
        Assert.That(print.Deposited * clay.Extrusion.VolumePerE!.Value / 40, Is.EqualTo(area).Within(1e-9));
    }

    [Test]
    public void A_profile_is_chosen_in_the_menu_and_stays_the_same_one_when_others_are_added()
    {
        var canvas = new Canvas<PrintSetupComponent>();
        var port = (PrinterChoiceParam)canvas.Input("Printer");
        Assert.That(port.HasNamedValues);
        // What a click in the menu does.
        port.SetPersistentData(PrinterChoiceParam.NumberOf("ender3"));
        Assert.That(canvas.Solve().One<PrintSetup>("Setup"), Is.EqualTo(SetupOf("ender3")));
        var folder = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N"));
        var settings = Folders.Settings;
        try
        {
            Folders.Settings = folder;
            Directory.CreateDirectory(Profiles.UserFolder);
            File.WriteAllText(Path.Combine(Profiles.UserFolder, "another.json"), "{\"inherits\": \"generic\", \"title\": \"Another\"}");
            var copy = Copied(canvas.Document);
            copy.NewSolution(true);
            Assert.That(Result(copy).Printer.Name, Is.EqualTo("ender3"));
            ((PrinterChoiceParam)((GH_Component)copy.Objects[0]).Params.Input[0]).SetPersistentData(PrinterChoiceParam.NumberOf("another"));
            copy.NewSolution(true);
            Assert.That(Result(copy).Printer.Title, Is.EqualTo("Another"));
            File.Delete(Path.Combine(Profiles.UserFolder, "another.json"));
            var gone = Copied(copy);
            gone.NewSolution(true);
            Assert.That(((GH_Component)gone.Objects[0]).RuntimeMessages(GH_RuntimeMessageLevel.Error), Has.Some.Contains("\"another\" not found"));
        }
        finally
        {
            Folders.Settings = settings;
            if (Directory.Exists(folder)) Directory.Delete(folder, true);
        }
    }

    [Test]
    public void A_profile_comes_as_a_file_next_to_the_definition_or_from_another_component()
    {
        var folder = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N"));
        Directory.CreateDirectory(folder);
        try
        {
            File.WriteAllText(Path.Combine(folder, "mine.json"), "{\"inherits\": \"generic\", \"title\": \"Mine\"}");
            var canvas = new Canvas<PrintSetupComponent>();
            canvas.Document.FilePath = Path.Combine(folder, "definition.gh");
            Assert.That(canvas.Feed("Printer", "mine.json").Solve().One<PrintSetup>("Setup").Printer.Title, Is.EqualTo("Mine"));
            Assert.That(canvas.Feed("Printer", "none.json").Solve().Errors, Has.Some.Contains("none.json"));
            var printer = new PrinterGoo { Value = SetupOf("lutum").Printer };
            Assert.That(canvas.Feed("Printer", printer).Solve().One<PrintSetup>("Setup"), Is.EqualTo(SetupOf("lutum")));
            Assert.That(canvas.Feed("Material", "clay_285").Feed("Settings", "fine").Solve().One<PrintSetup>("Setup").Material.Name, Is.EqualTo("clay_285"));
            Assert.That(canvas.Feed("Printer", 12).Solve().Errors, Is.Not.Empty);
        }
        finally
        {
            Directory.Delete(folder, true);
        }
    }

    [Test]
    public void A_setup_is_stored_whole_and_so_is_a_profile_at_a_port()
    {
        var floor = Caterpillar.Geometry.TriMesh.Create([new(0, 0, 1.0 / 3), new(9, 0, 2), new(0, 9, 2)], [0, 1, 2]);
        var setup = SetupOf("ender3") with { PrintedOn = floor };
        var param = new SetupParam();
        param.SetPersistentData(new SetupGoo { Value = setup });
        var choice = new PrinterChoiceParam();
        choice.SetPersistentData(new PrinterGoo { Value = setup.Printer with { Title = "Internalized" } });
        var archive = new GH_LooseChunk("test");
        param.Write(archive.CreateChunk("setup"));
        choice.Write(archive.CreateChunk("choice"));
        var (copy, other) = (new SetupParam(), new PrinterChoiceParam());
        copy.Read(archive.FindChunk("setup"));
        other.Read(archive.FindChunk("choice"));
        var read = ((SetupGoo)copy.PersistentData.Branches[0][0]).Value;
        Assert.That(read with { PrintedOn = null }, Is.EqualTo(setup with { PrintedOn = null }));
        Assert.That(read.PrintedOn!.Vertices, Is.EqualTo(floor.Vertices));
        Assert.That(other.PersistentDataCount, Is.EqualTo(1));
        var floating = new GH_Document();
        floating.AddObject(other, false);
        floating.NewSolution(false);
        Assert.That(((ProfileChoice<PrinterGoo>)other.VolatileData.get_Branch(0)[0]!).Profile!.Value.Title, Is.EqualTo("Internalized"));
    }

    [Test]
    public void A_setup_comes_from_a_name_a_printer_a_material_or_settings()
    {
        static PrintSetup? Cast(object source)
        {
            var goo = new SetupGoo();
            return goo.CastFrom(source) ? goo.Value : null;
        }
        Assert.That(Cast("lutum"), Is.EqualTo(SetupOf("lutum")));
        Assert.That(Cast(new PrinterGoo { Value = SetupOf("lutum").Printer }), Is.EqualTo(SetupOf("lutum")));
        var petg = new ProfileLibrary().Material("petg").OrThrow();
        Assert.That(Cast(new MaterialGoo { Value = petg }), Is.EqualTo(SetupOf("generic") with { Material = petg }));
        Assert.That(Cast(new PrintSettings { WallCount = 7 })!.Settings.WallCount, Is.EqualTo(7));
        Assert.That(Cast("lutumm"), Is.Null);
        Assert.That(Cast(3.5), Is.Null);
    }

    [Test]
    public void A_setup_a_printer_a_material_and_settings_come_from_a_written_file()
    {
        var file = System.IO.Path.Combine(System.IO.Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N") + ".gcode");
        var setup = SetupOf("lutum").With("wall_count=7").OrThrow();
        File.WriteAllText(file, "G28\n" + string.Join("\n", FileSetup.Lines(setup)) + "\n");
        try
        {
            var (whole, printer, settings, material) = (new SetupGoo(), new PrinterGoo(), new SettingsGoo(), new MaterialGoo());
            Assert.That(new[] { whole.CastFrom(file), printer.CastFrom(file), settings.CastFrom(file), material.CastFrom(file) }, Is.All.True);
            Assert.That(whole.Value.Differences(setup), Is.Empty);
            Assert.That((printer.Value, material.Value, settings.Value), Is.EqualTo((whole.Value.Printer, whole.Value.Material, whole.Value.Settings)));
            File.WriteAllText(file, "G28\n");
            var empty = new SetupGoo();
            Assert.That(empty.CastFrom(file), Is.False);
            Assert.That(empty.Problem, Does.Contain("setup.not_in_file"));
        }
        finally
        {
            File.Delete(file);
        }
    }

    [Test]
    public void Deconstructed_it_gives_every_key_with_a_value_that_is_read_back()
    {
        var setup = SetupOf("potter_super");
        var canvas = new Canvas<DeconstructSetupComponent>().Feed("Setup", "potter_super").Solve();
        Assert.That(canvas.One<Printer>("Printer"), Is.EqualTo(setup.Printer));
        var pairs = canvas.All("Keys").Zip(canvas.All("Values"), (k, v) => $"{k}={v}").ToArray();
        Assert.That(pairs, Has.Length.GreaterThan(190).And.Member("line_width_mm=3.4").And.Member("build_volume_mm=[400, 400, 500]"));
        var again = SetupOf("ender3").With(pairs).OrThrow();
        Assert.That(again.Differences(setup), Is.Empty);
        Assert.That(SetupOf("ender3").Differences(setup).Select(d => d.Key),
            Has.Member("nozzle_diameter_mm").And.Member("layer_height_mm").And.Member("start_gcode"));
    }

    [Test]
    public void Bad_values_at_a_setup_are_answered_at_once()
    {
        var narrow = new PrintSettings { LineWidth = 0.1 };
        var canvas = new Canvas<PrintSetupComponent>().Feed("Settings", narrow).Solve();
        Assert.That(canvas.Errors, Has.Some.Contains("setup.narrow_bead"));
        Assert.That(canvas.All("Setup"), Is.EqualTo(new object?[] { null }));
    }

    [Test]
    public void A_toolpath_that_could_damage_the_machine_is_not_saved()
    {
        var file = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N") + ".gcode");
        var far = (PathStep)Line.Transformed(Caterpillar.Geometry.Affine.Move(new(200, 0, 0)));
        var outside = new ToolpathGoo(Planning.Planner.Plan([far], new PrintSetup()).OrThrow(), new PrintSetup());
        var save = new Canvas<SaveGCodeComponent>().Feed("G-code", outside).Feed("File", file).Feed("Save", false).Solve();
        Assert.That(save.Errors, Is.Empty);
        save.Feed("Save", true).Solve();
        Assert.That(save.Errors, Has.Some.Contains("bed.outside").And.Some.Contains("write.refused"));
        Assert.That((save.Component.Message, File.Exists(file)), Is.EqualTo(("refused", false)));
        save.Feed("Save", false).Solve();
        Assert.That(save.Errors, Has.Some.Contains("write.refused"), "It stays red when the button is released.");
        save.Feed("G-code", new ToolpathGoo(outside.Value)).Feed("Save", true).Solve();
        Assert.That(save.Warnings, Has.Some.Contains("connect Print Setup"));
        save.Feed("G-code", 12).Solve();
        Assert.That(save.Errors, Has.Some.Contains("data conversion failed"));
    }

    private static PrintSetup Result(GH_Document document)
        => ((SetupGoo)((GH_Component)document.Objects[0]).Params.Output[0].VolatileData.get_Branch(0)[0]!).Value;

    private static GH_Document Copied(GH_Document document)
    {
        Instances.ComponentServer.Load(typeof(PluginInfo).Assembly);
        var archive = new GH_Archive();
        archive.AppendObject(document, "Definition");
        var read = new GH_Archive();
        read.Deserialize_Xml(archive.Serialize_Xml());
        var copy = new GH_Document();
        Assert.That(read.ExtractObject(copy, "Definition"), Is.True);
        return copy;
    }
}
