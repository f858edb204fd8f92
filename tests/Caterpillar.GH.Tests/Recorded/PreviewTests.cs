using System;
using System.Collections.Generic;
using System.Drawing;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Slice;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.GH.Preview;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Data;
using NUnit.Framework;
using Rhino;
using Rhino.Display;
using Rhino.DocObjects;

namespace Caterpillar.GH.Tests.Goos;

/// <summary>What is drawn and baked, as recorded by the display and the document.</summary>
public sealed class PreviewTests
{
    private static PrintPath Path(int points = 3) => new(Enumerable.Range(0, points).Select(i => new Vec3(i, i % 2, 1)), new Bead(0.08));

    private static Canvas<PlanarSlicerComponent> Sliced() => new Canvas<PlanarSlicerComponent>()
        .Feed("Setup", new PrintSettings { LayerHeight = 0.5, FirstLayerHeight = 0.5, LineWidth = 0.6 }).Feed("Geometry", Shapes.Box()).Solve();

    private static DisplayPipeline Drawn(GH_Component component)
    {
        var display = new DisplayPipeline();
        component.DrawViewportWires(new HeadlessPreviewArgs(new GH_Document(), display));
        return display;
    }

    [Test]
    public void The_paths_of_a_slicer_are_drawn_in_one_call_in_the_color_of_their_state()
    {
        var canvas = Sliced();
        var display = Drawn(canvas.Component);
        Assert.That(display.Calls.Select(c => (c.What, c.Color, c.Thickness)), Is.EqualTo(new[] { ("lines", Color.DarkRed, 1) }));
        Assert.That(((Rg.Line[])display.Calls[0].Item).Sum(l => l.Length),
            Is.EqualTo(canvas.All("Print Paths").Cast<PrintPath>().Sum(p => p.Length)).Within(1e-6), "Walls, infill and regions are hidden.");
        Assert.That(Drawn(canvas.Component).Calls[0].Item, Is.SameAs(display.Calls[0].Item), "The lines are made once.");
        canvas.Component.Attributes.Selected = true;
        Assert.That(Drawn(canvas.Component).Calls.Select(c => c.Color).Distinct(), Is.EqualTo(new[] { Color.DarkGreen }));
    }

    [Test]
    public void A_wire_is_made_once_and_again_for_other_units()
    {
        var goo = new PrintPathGoo(Path());
        object Wire()
        {
            var display = new DisplayPipeline();
            goo.DrawViewportWires(new GH_PreviewWireArgs(new RhinoViewport(), display, Color.Red, 3));
            return display.Calls.Single().Item;
        }
        var wire = Wire();
        Assert.That(Wire(), Is.SameAs(wire));
        using var _ = new InDocument(UnitSystem.Meters);
        Assert.That(((Rg.Line[])Wire()).Max(l => l.To.X), Is.EqualTo(0.002).Within(1e-12));
    }

    [Test]
    public void Of_too_many_lines_some_are_drawn_and_that_is_said()
    {
        var display = new DisplayPipeline();
        var half = Path(Thinning.MostLines / 2 + 2);
        var param = new PrintPathParam();
        var document = new GH_Document();
        document.AddObject(param, false);
        int Drawn(params object[] paths)
        {
            var source = new Grasshopper.Kernel.Parameters.Param_GenericObject();
            foreach (var path in paths) source.PersistentData.Append(Grasshopper.Kernel.Types.Casting.Wrap(path), new GH_Path(0));
            document.AddObject(source, false);
            param.RemoveAllSources();
            param.AddSource(source);
            param.ExpireSolution(true);
            display.Calls.Clear();
            param.DrawViewportWires(new HeadlessPreviewArgs(document, display));
            return ((Rg.Line[])display.Calls.Single().Item).Length;
        }
        Assert.That(Drawn(half), Is.EqualTo(half.SegmentCount));
        Assert.That(param.RuntimeMessages(GH_RuntimeMessageLevel.Remark), Is.Empty);
        Assert.That(Drawn(half, half), Is.EqualTo(half.SegmentCount).Within(1), "The limit is one of the parameter.");
        Assert.That(param.RuntimeMessages(GH_RuntimeMessageLevel.Remark),
            Has.One.EqualTo("The preview shows one line in 2, because there are too many lines."));
        var quarter = Path(Thinning.MostLines / 4 + 2);
        var layers = Enumerable.Range(0, 8).Select(i => (object)(quarter with { Layer = new Caterpillar.Toolpaths.Layer(i, 0.2 * i, 0.2) })).ToArray();
        Assert.That(Drawn(layers), Is.EqualTo(3 * quarter.SegmentCount), "Layers 0, 3 and 6.");
        Assert.That(param.RuntimeMessages(GH_RuntimeMessageLevel.Remark), Has.One.Contains("one layer in 3"));
    }

    [Test]
    public void A_toolpath_draws_what_is_printed_and_not_the_travels()
    {
        var plan = new Canvas<PlanToolpathComponent>().Feed("Steps", Path(), Path(5)).Feed("Setup", "generic").Solve();
        var lines = (Rg.Line[])Drawn(plan.Component).Calls.Single().Item;
        Assert.That(lines.Sum(l => l.Length), Is.EqualTo(Path().Length + Path(5).Length).Within(1e-9));
    }

    [Test]
    public void A_large_print_is_drawn_in_few_calls_and_its_box_is_kept()
    {
        var canvas = new Canvas<PlanarSlicerComponent>().Feed("Setup", new PrintSettings { LayerHeight = 0.2, FirstLayerHeight = 0.2 })
            .Feed("Geometry", Shapes.Box(100, 100, 40, 40)).Solve();
        Assert.That(canvas.All("Print Paths"), Has.Count.GreaterThan(500));
        Assert.That(Drawn(canvas.Component).Calls, Has.Count.EqualTo(1));
        using var other = new InDocument(UnitSystem.Centimeters);
        Assert.That(canvas.Component.ClippingBox.Max.X, Is.EqualTo(14).Within(0.1), "New units are noticed.");
    }

    [Test]
    public void A_hidden_component_has_no_clipping_box()
    {
        var canvas = Sliced();
        Assert.That(canvas.Component.ClippingBox.Max.Z, Is.EqualTo(2).Within(1e-9));
        canvas.Component.Hidden = true;
        Assert.That(canvas.Component.ClippingBox.IsValid, Is.False);
    }

    [Test]
    public void The_outputs_decide_what_can_be_baked()
    {
        using var document = new InDocument();
        var ids = new List<Guid>();
        var empty = new Canvas<PlanarSlicerComponent>().Solve();
        Assert.That(empty.Component.IsBakeCapable, Is.False);
        empty.Component.BakeGeometry(document.Document, new ObjectAttributes(), ids);
        var canvas = Sliced();
        Assert.That(canvas.Component.IsBakeCapable, Is.True);
        canvas.Component.BakeGeometry(document.Document, new ObjectAttributes(), ids);
        Assert.That(ids, Has.Count.EqualTo(document.Document.Objects.Count).And.Count.EqualTo(2 * canvas.All("Print Paths").Count));
        var text = new Canvas<GCodeTextComponent>().Feed("G-code", "G28").Solve();
        Assert.That((text.Component.IsBakeCapable, text.Component.IsPreviewCapable), Is.EqualTo((false, false)));
    }

    [Test]
    public void A_toolpath_is_baked_as_extrusions_on_layers_with_their_facts()
    {
        using var document = new InDocument();
        var path = new PrintPath(Path().Points, new Bead(0.0812345, 0.2)) { Role = Role.OuterWall, Layer = new Caterpillar.Toolpaths.Layer(3, 1, 0.2, "Vase") };
        var plan = new Canvas<PlanToolpathComponent>().Feed("Steps", path, Path(5)).Feed("Setup", "generic").Solve();
        var ids = new List<Guid>();
        plan.Component.BakeGeometry(document.Document, null!, ids);
        var items = document.Document.Objects.Items;
        Assert.That(items.Select(i => i.Id), Is.EqualTo(ids));
        Assert.That(ids, Has.Count.EqualTo(2));
        Assert.That(items.Select(i => document.Document.Layers.FindIndex(i.Attributes.LayerIndex).FullPath),
            Is.EqualTo(new[] { "Caterpillar::Vase::OuterWall", "Caterpillar::Print::Extrusion" }));
        var wall = items[0].Attributes;
        Assert.That(((Rg.Curve)items[0].Geometry).GetLength(), Is.EqualTo(path.Length).Within(1e-9));
        Assert.That(wall.GetUserString("caterpillar.layer"), Is.EqualTo("3"));
        Assert.That(wall.GetUserString("caterpillar.length_mm"), Is.EqualTo(NumberFormatter.Format(path.Length, 3)));
        Assert.That(wall.GetUserString("caterpillar.step"), Is.EqualTo("0"));
        Assert.That(double.Parse(wall.GetUserString("caterpillar.e"), System.Globalization.CultureInfo.InvariantCulture), Is.GreaterThan(0));
        Assert.That(wall.GetUserString("caterpillar.area_mm2"), Is.EqualTo("0.08123"));
        Assert.That(wall.PlotWeight, Is.EqualTo(path.BeadOf(0).Width(BeadShape.Stadium)));
        Assert.That((wall.ColorSource, wall.PlotWeightSource), Is.EqualTo((ObjectColorSource.ColorFromObject, ObjectPlotWeightSource.PlotWeightFromObject)));
    }

    [Test]
    public void Arcs_are_baked_as_arcs()
    {
        using var document = new InDocument(UnitSystem.Centimeters);
        var quarter = new PrintPath([new Vec3(10, 0, 0.2), new Vec3(0, 10, 0.2), new Vec3(0, 20, 0.2)], [new Bead(0.08), new Bead(0.08)], false,
            [new Caterpillar.Geometry.Arc(Vec3.Zero, 90), null]);
        var toolpath = Caterpillar.Planning.Planner.Plan([quarter], new PrintSetup()).Value!;
        new ToolpathGoo(toolpath).BakeGeometry(document.Document, new ObjectAttributes(), out var id);
        var baked = (Rg.PolyCurve)document.Document.Objects.Items.Single(i => i.Id == id).Geometry;
        Assert.That(baked.SegmentCurve(0), Is.InstanceOf<Rg.ArcCurve>());
        Assert.That(baked.GetLength(), Is.EqualTo((Math.PI * 5 + 10) / 10).Within(1e-6));
        Assert.That(baked.PointAtEnd.DistanceTo(new Rg.Point3d(0, 2, 0.02)), Is.LessThan(1e-9));
    }

    [Test]
    public void Extrusions_there_and_back_are_curves_that_rhino_calls_valid()
    {
        var back = new PrintPath([new Vec3(0, 0, 0.2), new Vec3(10, 0, 0.2), new Vec3(0, 0, 0.2)], new Bead(0.08));
        var curve = Caterpillar.GH.Conversion.RhinoGeometry.ToCurve(back, Caterpillar.GH.Conversion.DocumentUnits.Current)!;
        Assert.That((curve.PointCount, curve.IsValid), Is.EqualTo((4, true)));
        Assert.That(curve.GetLength(), Is.EqualTo(20).Within(1e-12));
        Assert.That(Caterpillar.GH.Conversion.PolylineMaker.Of([new Rg.Point3d(1, 1, 1), new Rg.Point3d(1, 1, 1)]), Is.Null);
    }

    [Test]
    public void Hidden_outputs_stay_hidden_in_the_file()
    {
        PrintPathParam Reopened(PrintPathParam param)
        {
            var archive = new GH_IO.Serialization.GH_Archive();
            archive.AppendObject(param, "Param");
            var read = new GH_IO.Serialization.GH_Archive();
            read.Deserialize_Xml(archive.Serialize_Xml());
            var copy = new PrintPathParam { Hidden = !param.Hidden };
            read.ExtractObject(copy, "Param");
            return copy;
        }
        Assert.That(Reopened(new PrintPathParam { Hidden = true }).Hidden, Is.True);
        Assert.That(Reopened(new PrintPathParam()).Hidden, Is.False);
    }

    [Test]
    public void A_hidden_parameter_has_no_clipping_box()
    {
        var param = new PrintPathParam();
        param.AddVolatileData(new GH_Path(0), 0, Path());
        Assert.That(param.ClippingBox.IsValid, Is.True);
        param.Hidden = true;
        Assert.That(param.ClippingBox.IsValid, Is.False);
    }
}
