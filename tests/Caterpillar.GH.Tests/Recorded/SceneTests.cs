using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.GH.Components.Simulate;
using Caterpillar.GH.Conversion;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Preview;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using NUnit.Framework;
using Rhino.Display;

namespace Caterpillar.GH.Tests.Recorded;

/// <summary>What the components that draw by themselves draw.</summary>
public sealed class SceneTests
{
    private static ToolpathGoo Planned(int lines = 40)
    {
        var paths = Enumerable.Range(0, lines)
            .Select(i => (Step)new PrintPath([new Vec3(50, 50 + i % 10, 0.2 + i / 10 * 0.2), new Vec3(80, 50 + i % 10, 0.2 + i / 10 * 0.2)],
            Bead.FromWidth(0.6, 0.2, 1, 40, BeadShape.Stadium)) { Role = i % 2 == 0 ? Role.OuterWall
                : Role.Infill, Layer = new Layer(i / 10, 0.2 + i / 10 * 0.2, 0.2, "Part") });
        return new ToolpathGoo(Planner.Plan(paths.ToArray(), new PrintSetup()).Value!, new PrintSetup());
    }

    private static List<DrawCall> Draw(GH_Component component)
    {
        var display = new DisplayPipeline();
        var args = new HeadlessPreviewArgs(new GH_Document(), display);
        component.DrawViewportWires(args);
        component.DrawViewportMeshes(args);
        return display.Calls;
    }

    [Test]
    public void A_preview_is_one_call_for_each_color_and_one_for_travels_and_retractions()
    {
        var canvas = new Canvas<ToolpathPreviewComponent>().Feed("Toolpath", Planned()).Feed("Travel", true).Solve();
        var calls = Draw(canvas.Component);
        Assert.That(calls.Select(c => c.What), Is.EqualTo(new[] { "lines", "lines", "lines", "points" }).Or.EqualTo(new[] { "lines", "lines", "lines" }));
        Assert.That(calls.Take(2).Sum(c => ((Rg.Line[])c.Item).Sum(l => l.Length)), Is.EqualTo(40 * 30).Within(1e-6));
        canvas.Component.Hidden = true;
        Assert.That(Draw(canvas.Component), Is.Empty);
        Assert.That(canvas.Component.ClippingBox.IsValid, Is.False);
    }

    [Test]
    public void Lines_that_keep_one_color_are_drawn_as_they_are_and_not_copied()
    {
        // Three layers of 5000 lines, of one role and speed.
        var steps = Enumerable.Range(0, 3).Select(i => (Step)new PrintPath(Enumerable.Range(0, 5001).Select(k => new Vec3(50 + k % 2 * 10 + k * 0.01, 50,
            0.2 + 0.2 * i)), Bead.FromWidth(0.6, 0.2, 1, 40, BeadShape.Stadium)) { Role = Role.OuterWall, Layer = new Layer(i, 0.2 + 0.2 * i, 0.2) });
        var print = new ToolpathGoo(Planner.Plan(steps.ToArray(), new PrintSetup(), new PlanOptions { Policy = PlanPolicy.AsDrawn }).Value!);
        var canvas = new Canvas<ToolpathPreviewComponent>().Feed("Toolpath", print);
        Rg.Line[][] Lines(string color)
        {
            canvas.Feed("Color By", color).Solve();
            return Draw(canvas.Component).Select(c => (Rg.Line[])c.Item).ToArray();
        }
        var role = Lines("Role").Single();
        Assert.That(role, Has.Length.EqualTo(15000));
        Assert.That(Lines("Flow").Single(), Is.SameAs(role), "The flow differs in the last digits only.");
        Assert.That(canvas.All("Tags"), Has.Count.EqualTo(1));
        var layers = Lines("Layer");
        Assert.That(layers.Select(l => l.Length), Is.EqualTo(new[] { 5000, 5000, 5000 }));
        Assert.That(layers.SelectMany(l => l), Is.EqualTo(role));
        canvas.Feed("First Layer", 1).Feed("Last Layer", 1);
        Assert.That(Lines("Role").Single(), Is.EqualTo(role.Skip(5000).Take(5000)));
    }

    [Test]
    public void Beads_are_a_mesh_with_a_color_for_each_vertex_and_layers_can_be_chosen()
    {
        var canvas = new Canvas<ToolpathPreviewComponent>().Feed("Toolpath", Planned()).Feed("Solid", true).Feed("First Layer", 1).Feed("Last Layer", 2)
            .Feed("Color By", "Layer").Solve();
        var calls = Draw(canvas.Component);
        Assert.That(calls.Select(c => c.What).Distinct(), Is.EqualTo(new[] { "colours" }));
        var meshes = calls.Select(c => (Rg.Mesh)c.Item).ToArray();
        Assert.That(meshes.Sum(m => m.Vertices.Count), Is.EqualTo(20 * 16), "Two rings of eight for each of twenty extrusions.");
        Assert.That(meshes.All(m => m.VertexColors.Count == m.Vertices.Count), Is.True);
        Assert.That(canvas.Component.ClippingBox.Max.Z, Is.EqualTo(0.6).Within(1e-9));
    }

    [Test]
    public void Speeds_that_differ_in_their_last_digits_have_one_color_and_others_sixteen()
    {
        var toolpath = Planned(4).Value;
        var parts = new SceneParts(toolpath, DocumentUnits.Current, default);
        PreviewColors Of(params double[] values)
        {
            // Of travels and of what has no value, nothing is shown.
            var all = Enumerable.Repeat(double.NegativeInfinity, toolpath.Count).ToArray();
            values.CopyTo(all, 0);
            return PreviewColors.Of(all, parts, new ShownLayers(null, null), PreviewColor.Speed);
        }
        var same = Of(40, 40 * (1 + 1e-12), 40);
        Assert.That((same.Colors.Count, same.Texts.Single()), Is.EqualTo((1, "40 to 40 mm/s")));
        Assert.That(Enumerable.Range(0, 4).Select(same.BandOf), Is.EqualTo(new[] { 0, 0, 0, PreviewColors.Hidden }));
        var several = Of(40, 41, 48, 56);
        Assert.That((several.Colors.Count, several.Texts[0], several.Texts[15]), Is.EqualTo((16, "40 to 41 mm/s", "55 to 56 mm/s")));
        Assert.That(several.Colors.Distinct().Count(), Is.EqualTo(16));
        foreach (var (band, share) in new[] { (0, 0.0), (3, 0.2), (15, 1) })
            Assert.That(several.Colors[band], Is.EqualTo(RhinoGeometry.ToColor(Caterpillar.Display.Palette.At(share))));
        Assert.That(Enumerable.Range(0, 4).Select(several.BandOf), Is.EqualTo(new[] { 0, 1, 8, 15 }));
        Assert.That(Of(double.NaN, 40).BandOf(0), Is.Zero);
        Assert.That(Of().Colors, Has.Count.EqualTo(1));
    }

    [Test]
    public void Seams_and_the_printer_are_one_call_each()
    {
        var canvas = new Canvas<ToolpathPreviewComponent>().Feed("Toolpath", Planned()).Feed("Seam", true).Feed("Setup", "generic").Solve();
        Assert.That(canvas.Errors, Is.Empty);
        var calls = Draw(canvas.Component);
        Assert.That(calls.Select(c => c.What), Is.EqualTo(new[] { "lines", "lines", "lines", "points" }));
        Assert.That(((Rg.Line[])calls[2].Item), Has.Length.EqualTo(12), "The edges of the build volume.");
        Assert.That(canvas.Component.ClippingBox.Max, Is.EqualTo(new Rg.Point3d(220, 220, 250)));
        // Half of the forty lines are walls.
        Assert.That(((IEnumerable<Rg.Point3d>)calls[3].Item).Count(), Is.EqualTo(20));
    }

    [Test]
    public void A_turtle_points_where_the_head_goes()
    {
        var canvas = new Canvas<SimulateComponent>().Feed("Toolpath", Planned(1)).Feed("Position Unit", "Length").Feed("Position", 0.99).Solve();
        var head = (Rg.Line[])Draw(canvas.Component)[1].Item;
        var corners = head.Skip(head.Length - 3).Select(l => l.From).ToArray();
        var tip = canvas.One<Rg.Plane>("Plane");
        Assert.That(corners.Select(c => Math.Round((c - tip.Origin).Length, 6)), Is.EqualTo(new[] { 2.0, 2, 5 }));
        Assert.That((corners[2] - tip.Origin) * tip.XAxis, Is.EqualTo(5).Within(1e-9), "The sharp corner is forward.");
    }

    [Test]
    public void A_simulation_draws_blocks_and_the_head()
    {
        var canvas = new Canvas<SimulateComponent>().Feed("Toolpath", Planned()).Feed("Position", 0.5).Solve();
        var calls = Draw(canvas.Component);
        Assert.That(calls.Select(c => c.What), Is.EqualTo(new[] { "lines", "lines" }));
        var half = ((Rg.Line[])calls[0].Item).Sum(l => l.Length);
        Assert.That(half, Is.InRange(300, 900));
        var same = calls[0].Item;
        canvas.Feed("Position", 0.9).Solve();
        Assert.That(Draw(canvas.Component)[0].Item, Is.SameAs(same), "A slider allocates no lines.");
        Assert.That(((Rg.Line[])Draw(canvas.Component)[0].Item).Sum(l => l.Length), Is.GreaterThan(half));
    }
}
