using System;
using System.Collections.Generic;
using System.Drawing;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Slice;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
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
        .Feed("Settings", new PrintSettings { LayerHeight = 0.5, FirstLayerHeight = 0.5, LineWidth = 0.6 }).Feed("Geometry", Shapes.Box()).Solve();

    private static DisplayPipeline Drawn(GH_Component component)
    {
        var display = new DisplayPipeline();
        component.DrawViewportWires(new HeadlessPreviewArgs(new GH_Document(), display));
        return display;
    }

    [Test]
    public void Paths_are_one_thin_wire_each_in_the_color_of_their_state()
    {
        var canvas = Sliced();
        var paths = canvas.All("Print Paths").Count + canvas.All("Walls").Count + canvas.All("Infill").Count + canvas.All("Regions").Count;
        var display = Drawn(canvas.Component);
        Assert.That(display.Calls, Has.Count.EqualTo(paths));
        Assert.That(display.Calls.Select(c => (c.What, c.Color, c.Thickness)).Distinct(), Is.EqualTo(new[] { ("curve", Color.DarkRed, 1) }));
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
        Assert.That(((Rg.Curve)Wire()).GetBoundingBox(true).Max.X, Is.EqualTo(0.002).Within(1e-12));
    }

    [Test]
    public void Very_large_goo_draws_nothing()
    {
        var display = new DisplayPipeline();
        new PrintPathGoo(Path(PreviewLimits.Points + 1)).DrawViewportWires(new GH_PreviewWireArgs(new RhinoViewport(), display, Color.Red, 1));
        Assert.That(display.Calls, Is.Empty);
    }

    [Test]
    public void A_toolpath_draws_what_is_printed_and_not_the_travels()
    {
        var plan = new Canvas<PlanToolpathComponent>().Feed("Steps", Path(), Path(5)).Feed("Printer", "generic").Solve();
        var curves = Drawn(plan.Component).Calls.Select(c => (Rg.Curve)c.Item).ToArray();
        Assert.That(curves, Has.Length.EqualTo(2));
        Assert.That(curves.Sum(c => c.GetLength()), Is.EqualTo(Path().Length + Path(5).Length).Within(1e-9));
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
    public void A_hidden_parameter_has_no_clipping_box()
    {
        var param = new PrintPathParam();
        param.AddVolatileData(new GH_Path(0), 0, Path());
        Assert.That(param.ClippingBox.IsValid, Is.True);
        param.Hidden = true;
        Assert.That(param.ClippingBox.IsValid, Is.False);
    }
}
