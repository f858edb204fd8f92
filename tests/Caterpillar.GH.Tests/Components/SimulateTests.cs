using System;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Setup;
using Caterpillar.GH.Components.Simulate;
using Caterpillar.GH.Conversion;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Preview;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Components;

[Category("Host")]
public sealed class SimulateTests
{
    private static readonly Bead Bead = new(0.08, 0.2, 40);

    private static PrintPath Line(double x, double y, int layer, double length = 20, Role role = Role.OuterWall)
        => new([new Vec3(x, y, 0.2 * (layer + 1)), new Vec3(x + length, y, 0.2 * (layer + 1))], Bead)
        {
            Role = role, Layer = new Layer(layer, 0.2 * (layer + 1), 0.2, "Part"),
        };

    private static ToolpathGoo Planned(params PrintPath[] paths)
        => new(Planner.Plan(paths.Select(p => (Step)p).ToArray(), new PrintSetup()).Value!, new PrintSetup());

    private static ToolpathGoo TwoLayers() => Planned(Line(50, 50, 0), Line(50, 60, 0, role: Role.Infill), Line(50, 50, 1), Line(50, 60, 1, role: Role.Infill));

    [Test]
    public void The_nozzle_is_where_the_timeline_says()
    {
        var goo = TwoLayers();
        var timeline = Timeline.Of(goo.Value, goo.Setup!);
        foreach (var t in new[] { 0.0, 0.3, 0.77, 1.0 })
        {
            var canvas = new Canvas<SimulateComponent>().Feed("Toolpath", goo).Feed("Position", t).Solve();
            Assert.That(canvas.Errors, Is.Empty);
            var state = timeline.AtFraction(t);
            var tip = canvas.One<Rg.Plane>("Plane").Origin;
            Assert.That(tip.DistanceTo(new Rg.Point3d(state.Position.X, state.Position.Y, state.Position.Z)), Is.LessThan(1e-9));
            Assert.That(canvas.One<double>("Time"), Is.EqualTo(state.Time));
            Assert.That(canvas.One<int>("Line"), Is.EqualTo(state.Source));
            var printed = canvas.One<Toolpath>("Printed");
            Assert.That(Printed(printed), Is.EqualTo(timeline.AtMove(state.Move).Filament + (state.Move < goo.Value.Count
                ? goo.Value[state.Move].Deposited * state.Done : 0)).Within(1e-9));
        }
    }

    [Test]
    public void Positions_count_time_length_or_layers()
    {
        var goo = TwoLayers();
        double Z(string by, double at)
            => new Canvas<SimulateComponent>().Feed("Toolpath", goo).Feed("Position", at).Feed("Position Unit", by).Solve().One<Rg.Plane>("Plane").Origin.Z;
        Assert.That(Z("Layer", 0.4), Is.LessThan(0.7));
        Assert.That(new Canvas<SimulateComponent>().Feed("Toolpath", goo).Feed("Position", 0.75).Feed("Position Unit", "layer").Solve().One<string>("State"),
            Does.Contain("mm/s"));
        Assert.That(Z("Length", 1), Is.EqualTo(Z("Time", 1)));
        Assert.That(new Canvas<SimulateComponent>().Feed("Toolpath", goo).Feed("Position", 1.5).Solve().Errors, Has.One.Contains("0 to 1"));
    }

    [Test]
    public void Positions_are_also_seconds_layers_and_lines()
    {
        var goo = TwoLayers();
        var timeline = Timeline.Of(goo.Value, goo.Setup!);
        Canvas<SimulateComponent> At(string by, double position)
            => new Canvas<SimulateComponent>().Feed("Toolpath", goo).Feed("Position", position).Feed("Position Unit", by).Solve();
        Assert.That(At("Seconds", 1.5).One<double>("Time"), Is.EqualTo(1.5).Within(1e-9));
        Assert.That(At("Seconds", 1e6).One<double>("Time"), Is.EqualTo(timeline.Duration));
        var second = timeline.AtLayer(1)!.Value.Time;
        Assert.That(At("Layer Number", 1).One<double>("Time"), Is.EqualTo(second));
        Assert.That(At("Layer", 0.75).One<double>("Time"), Is.EqualTo((second + timeline.Duration) / 2).Within(1e-9), "Half of the second of two layers.");
        var source = goo.Value[goo.Value.Count - 1].Source;
        Assert.That(At("Line", source).One<double>("Time"), Is.EqualTo(timeline.AtSource(source)!.Value.Time));
        foreach (var (by, position) in new[] { ("Layer Number", 2.0), ("Layer Number", -1), ("Line", 1e12), ("Line", -1) })
            Assert.That(At(by, position).Errors, Has.One.Contains("has no such layer, line or step"), by);
    }

    [Test]
    public void The_head_is_a_mesh_above_the_nozzle()
    {
        var canvas = new Canvas<SimulateComponent>().Feed("Toolpath", TwoLayers()).Feed("Position", 0.4).Solve();
        var (tip, box) = (canvas.One<Rg.Plane>("Plane").Origin, canvas.One<Rg.Mesh>("Head Mesh").GetBoundingBox(true));
        Assert.That((box.Min.Z, box.Max.Z, box.Max.X), Is.EqualTo((tip.Z, tip.Z + 12, tip.X + 20)).Within(1e-6));
    }

    [Test]
    public void What_is_printed_is_drawn_up_to_the_nozzle()
    {
        var goo = TwoLayers();
        var lines = PrintedLines.Of(goo.Value, DocumentUnits.Current);
        Assert.That(lines.Count, Is.EqualTo(4));
        var second = Enumerable.Range(0, goo.Value.Count).Where(i => goo.Value[i].Kind == MoveKind.Print).ElementAt(1);
        lines.ShowUntil(second, 0.25);
        var drawn = lines.End.Where(l => l.Length > 0).ToArray();
        Assert.That((lines.Blocks, drawn.Length), Is.EqualTo((0, 2)));
        Assert.That(drawn[1].Length, Is.EqualTo(5).Within(1e-9));
        lines.ShowUntil(goo.Value.Count, 0);
        Assert.That(lines.End.Sum(l => l.Length), Is.EqualTo(80).Within(1e-9));
        lines.ShowUntil(0, 0);
        Assert.That(lines.End.Sum(l => l.Length), Is.Zero);
    }

    [Test]
    public void Blocks_are_whole_however_far_the_print_is()
    {
        var points = Enumerable.Range(0, 5001).Select(i => new Vec3(50 + 0.01 * i, 50 + i % 2, 0.2)).ToArray();
        var lines = PrintedLines.Of(Planned(new PrintPath(points, Bead)).Value, DocumentUnits.Current);
        var toolpath = Planned(new PrintPath(points, Bead)).Value;
        var total = Enumerable.Range(0, toolpath.Count).Where(i => toolpath[i].Kind == MoveKind.Print).Sum(i => toolpath[i].Length);
        foreach (var move in new[] { 0, 1023, 1024, 1025, 2048, 4000, toolpath.Count })
        {
            lines.ShowUntil(move, 0);
            var before = Enumerable.Range(0, move).Where(i => toolpath[i].Kind == MoveKind.Print).Sum(i => toolpath[i].Length);
            var drawn = lines.End.Sum(l => l.Length);
            if (lines.Blocks == 0) Assert.That(drawn, Is.EqualTo(before).Within(1e-6));
            else Assert.That(drawn, Is.LessThan(before));
        }
        Assert.That(total, Is.GreaterThan(0));
    }

    [Test]
    public void Playing_starts_at_a_press_follows_the_clock_and_stops_at_the_end()
    {
        var goo = TwoLayers();
        var now = 0.0;
        var canvas = new Canvas<PlayComponent>().Feed("Toolpath", goo).Feed("Speed", 1.0).Feed("Run", true);
        canvas.Component.Seconds = () => now;
        canvas.Solve();
        Assert.That((canvas.Component.Plays, canvas.Document.ScheduledCount), Is.EqualTo((false, 0)), "As a definition opens that was saved while it ran.");
        canvas.Feed("Run", false).Solve().Feed("Run", true).Solve();
        Assert.That((canvas.One<double>("Position"), canvas.Document.ScheduledCount), Is.EqualTo((0.0, 1)));
        var duration = Timeline.Of(goo.Value, goo.Setup!).Duration;
        now = duration / 4;
        canvas.Document.RunSchedule();
        Assert.That(canvas.One<double>("Position"), Is.EqualTo(0.25).Within(1e-9));
        now = 2 * duration;
        canvas.Document.RunSchedule();
        Assert.That((canvas.One<double>("Position"), canvas.Component.Plays, canvas.Document.ScheduledCount), Is.EqualTo((1.0, false, 0)));
        canvas.Feed("Run", false).Feed("Reset", true).Solve();
        Assert.That(canvas.One<double>("Position"), Is.Zero);
    }

    [Test]
    public void Playing_stops_when_the_document_is_left_or_the_component_is_locked()
    {
        var canvas = new Canvas<PlayComponent>().Feed("Toolpath", TwoLayers()).Solve().Feed("Run", true).Solve();
        Assert.That(canvas.Component.Plays, Is.True);
        canvas.Component.DocumentContextChanged(canvas.Document, Grasshopper.Kernel.GH_DocumentContext.Unloaded);
        Assert.That(canvas.Component.Plays, Is.False);
        canvas.Feed("Run", false).Solve().Feed("Run", true).Solve();
        canvas.Component.Locked = true;
        canvas.Document.RunSchedule();
        Assert.That(canvas.Component.Plays, Is.False);
    }

    [Test]
    public void Statistics_are_those_of_the_library()
    {
        var goo = TwoLayers();
        var expected = PrintStatistics.Of(Timeline.Of(goo.Value, goo.Setup!));
        var canvas = new Canvas<StatisticsComponent>().Feed("Toolpath", goo).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(canvas.One<double>("Time"), Is.EqualTo(expected.Duration));
        Assert.That(canvas.One<double>("Print Length"), Is.EqualTo(80).Within(1e-9));
        Assert.That(canvas.All("Layer Times"), Is.EqualTo(expected.Layers.Select(l => (object)l.Time)));
        Assert.That(canvas.All("Summary"), Has.Some.Contains("OuterWall: "));
        var slow = new Canvas<StatisticsComponent>().Feed("Toolpath", goo)
            .Feed("Setup", new Printer { PrintAcceleration = 50, TravelAcceleration = 50 }).Solve();
        Assert.That(slow.One<double>("Time"), Is.GreaterThan(expected.Duration));
    }

    [Test]
    public void A_check_passes_the_toolpath_on_or_shows_where_it_fails()
    {
        var good = new Canvas<CheckComponent>().Feed("Toolpath", TwoLayers()).Solve();
        Assert.That(good.Errors, Is.Empty);
        Assert.That((good.One<bool>("OK"), good.One<Toolpath>("Checked Toolpath").Count), Is.EqualTo((true, TwoLayers().Value.Count)));
        var bad = new Canvas<CheckComponent>().Feed("Toolpath", Planned(Line(210, 50, 0))).Solve();
        Assert.That(good.Component.Message, Is.EqualTo("OK"));
        Assert.That(bad.Component.Message, Does.Match(@"^\d+ errors$"));
        Assert.That(bad.One<bool>("OK"), Is.False);
        Assert.That(bad.All("Checked Toolpath"), Is.EqualTo(new object?[] { null }));
        Assert.That(bad.Errors, Has.Some.Contains("bed.outside"));
        Assert.That(bad.All("Points").Cast<Rg.Point3d>().First().X, Is.EqualTo(230).Within(1e-9));
    }

    [Test]
    public void A_decoded_file_is_checked_as_its_firmware_reads_it()
    {
        var file = new Canvas<DecodeGCodeComponent>().Feed("G-code", "M104 S200\nM109 S200\nG28\nM83\nG1 X10 Y10 Z0.2 F3000\nG1 X20 Y10 E0.5 F1200\n").Solve();
        var canvas = new Canvas<CheckComponent>().Feed("Toolpath", file.Output("Toolpath").VolatileData.get_Branch(0)[0]).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(canvas.One<bool>("OK"), Is.True);
    }

    [TestCase("Role", 2)]
    [TestCase("Layer", 16)]
    [TestCase("Speed", 1)]
    [TestCase("Order", 16)]
    [TestCase("Time", 16)]
    [TestCase("Flow", 1)]
    [TestCase("Width", 1)]
    public void A_preview_has_a_legend(string by, int bands)
    {
        var canvas = new Canvas<ToolpathPreviewComponent>().Feed("Toolpath", TwoLayers()).Feed("Color By", by).Solve();
        Assert.That(canvas.Errors.Concat(canvas.Warnings), Is.Empty);
        Assert.That(canvas.All("Tags").Count, Is.EqualTo(canvas.All("Colors").Count));
        Assert.That(canvas.All("Tags").Count, Is.EqualTo(bands).Or.EqualTo(16));
        Assert.That(canvas.All("Tags").Distinct().Count(), Is.GreaterThan(0));
    }

    [Test]
    public void Colors_by_width_are_those_of_a_stadium_of_the_height_of_the_layer()
    {
        var path = new PrintPath([new(50, 50, 0.2), new(80, 50, 0.2)], new Bead(0.08, 0.2, 40)) { Layer = new Layer(0, 0.2, 0.2) };
        var goo = new ToolpathGoo(Planning.Planner.Plan([path], new PrintSetup()).Value!);
        var canvas = new Canvas<ToolpathPreviewComponent>().Feed("Toolpath", goo).Feed("Color By", "Width").Solve();
        // 0.08 / 0.2 + 0.2 * (1 - π / 4)
        Assert.That(canvas.All("Tags"), Is.EqualTo(new[] { "0.443 to 0.443 mm" }));
    }

    [Test]
    public void A_printer_is_made_from_geometry_and_values()
    {
        var bed = new Rg.Box(new Rg.BoundingBox(-90, -80, 0, 90, 80, 200));
        var head = new Rg.Box(new Rg.BoundingBox(-20, -30, 4, 20, 30, 40));
        var canvas = new Canvas<PrinterComponent>().Feed("Bed", bed).Feed("Nozzle Diameter", 0.6).Feed("Head Parts", head).Feed("Name", "Mine")
            .Key("max_flow_mm3_s", 20).Key("start_gcode", "G28", "M420 S1").Solve();
        Assert.That(canvas.Errors, Is.Empty);
        var printer = canvas.One<Printer>("Printer");
        Assert.That((printer.BuildVolume, printer.Origin, printer.NozzleDiameter, printer.MaxFlow, printer.Title),
            Is.EqualTo((new Vec3(180, 160, 200), BedOrigin.Center, 0.6, 20.0, "Mine")));
        Assert.That(printer.HeadBoxes.Single(), Is.EqualTo(new Bounds(new Vec3(-20, -30, 4), new Vec3(20, 30, 40))));
        Assert.That(printer.StartGCode, Is.EqualTo(new[] { "G28", "M420 S1" }));
        Assert.That(new Canvas<PrinterComponent>().Feed("Bed", new Rg.Box(new Rg.BoundingBox(5, 5, 0, 90, 80, 200))).Solve().Errors,
            Has.One.Contains("The origin must be"));
    }

    [Test]
    public void A_header_becomes_a_printer_and_a_material()
    {
        var folder = System.IO.Path.Combine(System.IO.Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N"));
        System.IO.Directory.CreateDirectory(folder);
        try
        {
            var (header, footer) = (System.IO.Path.Combine(folder, "start.gcode"), System.IO.Path.Combine(folder, "end.gcode"));
            System.IO.File.WriteAllText(header, "M104 S{hotend_temp}\nM140 S60\nG28\nM82\nG1 X10 Y10 Z5 F3000\n");
            System.IO.File.WriteAllText(footer, "M104 S0\nM84\n");
            var canvas = new Canvas<ImportProfileComponent>().Feed("File", header).Feed("Footer", footer).Solve();
            Assert.That(canvas.Errors, Is.Empty);
            Assert.That(canvas.One<Printer>("Printer").EndGCode, Has.Member("M84"));
            Assert.That(canvas.One<Printer>("Printer").ExtrusionMode, Is.EqualTo(ExtrusionMode.Absolute));
            Assert.That(canvas.One<Material>("Material").BedTemperature, Is.EqualTo(60));
            Assert.That(canvas.One<Rg.Point3d>("Start").DistanceTo(new Rg.Point3d(10, 10, 5)), Is.LessThan(1e-9));
            Assert.That(new Canvas<ImportProfileComponent>().Feed("File", header + "x").Solve().Errors, Has.One.Contains("File not found"));
        }
        finally
        {
            System.IO.Directory.Delete(folder, true);
        }
    }

    [Test]
    public void Of_a_whole_print_only_the_start_and_the_end_are_imported()
    {
        var file = System.IO.Path.Combine(System.IO.Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N") + ".gcode");
        System.IO.File.WriteAllText(file, "; generated by PrusaSlicer\nM104 S210\nM140 S55\nG28\nM83\n;LAYER_CHANGE\n;Z:0.2\n;TYPE:External perimeter\n"
            + "G1 X50 Y50 Z0.2 F6000\nG1 X70 Y50 E1 F1200\nG1 X70 Y70 E1\n;LAYER_CHANGE\n;Z:0.4\nG1 X70 Y70 Z0.4\nG1 X50 Y70 E1\nM104 S0\nM84\n");
        try
        {
            var canvas = new Canvas<ImportProfileComponent>().Feed("File", file).Solve();
            Assert.That(canvas.Errors, Is.Empty);
            var printer = canvas.One<Printer>("Printer");
            Assert.That(printer.StartGCode, Has.Some.Contains("G28").And.None.Contains("X70"));
            Assert.That(printer.EndGCode, Has.Member("M84").And.None.Contains("X50"));
            Assert.That(canvas.One<Material>("Material").NozzleTemperature, Is.EqualTo(210));
        }
        finally
        {
            System.IO.File.Delete(file);
        }
    }

    [Test]
    public void A_skirt_has_its_rings_from_the_outside_in()
    {
        var canvas = new Canvas<Caterpillar.GH.Components.Design.RoundTraceComponent>().Feed("Kind", "Skirt").Feed("Radius", 10.0)
            .Feed("Loop Count", 3).Feed("Pitch", 1.0).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        var path = canvas.One<PrintPath>("Print Path");
        Assert.That((path.Bounds.Max.X, path.Start.LengthXY), Is.EqualTo((12.0, 12.0)).Within(1e-9));
        Assert.That(new Canvas<Caterpillar.GH.Components.Design.RoundTraceComponent>().Feed("Kind", "Skirt").Feed("Radius", 10.0)
            .Feed("Loop Count", 0).Solve().Errors,
            Has.One.Contains("1 to 1000"));
    }

    private static double Printed(Toolpath toolpath) => toolpath.Moves().Sum(m => m.Deposited);
}
