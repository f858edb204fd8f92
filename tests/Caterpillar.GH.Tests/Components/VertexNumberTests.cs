using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Path;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Components;

/// <summary>Construct Print Path with flat curves, layers, and numbers along a curve.</summary>
[Category("Host")]
public sealed class VertexNumberTests
{
    private static readonly Rg.PolylineCurve Corner = new(new Rg.Point3d[] { new(0, 0, 1), new(10, 0, 1), new(10, 5, 1) });
    private static readonly Rg.LineCurve Flat = new(new Rg.Point3d(50, 50, 0), new Rg.Point3d(80, 50, 0));

    private static Canvas<ConstructPrintPathComponent> Drawn(params object?[] curves) => new Canvas<ConstructPrintPathComponent>().Feed("Curve", curves);

    private static BeadGoo Bead(double area, double height) => new(new Bead(area, height));

    [Test]
    public void A_flat_curve_is_raised_to_the_first_layer_with_a_remark()
    {
        var canvas = Drawn(Flat).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(canvas.One<PrintPath>("Print Path").Points.Select(p => p.Z), Is.All.EqualTo(0.2));
        Assert.That(canvas.Notes, Has.One.Contains("The drawing is flat at Z 0. It is printed at Z 0.2"));
        Assert.That(canvas.Feed("Base", "As Drawn").Solve().One<PrintPath>("Print Path").Start.Z, Is.EqualTo(0));
        Assert.That(canvas.Notes, Is.Empty);
    }

    [Test]
    public void The_height_of_the_first_layer_is_that_of_the_setup_else_that_of_the_bead()
    {
        var setup = new SetupGoo { Value = new PrintSetup() with { Settings = new PrintSettings { FirstLayerHeight = 1.5, LayerHeight = 1, LineWidth = 3 } } };
        Assert.That(Drawn(Flat).Feed("Setup", setup).Solve().One<PrintPath>("Print Path").Start.Z, Is.EqualTo(1.5));
        Assert.That(Drawn(Flat).Feed("Bead", Bead(2, 0.8)).Solve().One<PrintPath>("Print Path").Start.Z, Is.EqualTo(0.8));
        Assert.That(Drawn(Flat).Feed("Bead", Bead(2, 0.8)).Feed("Setup", setup).Solve().One<PrintPath>("Print Path").Start.Z, Is.EqualTo(1.5));
        Assert.That(Drawn(Flat).Feed("Setup", "pen_plotter").Solve().One<PrintPath>("Print Path").Start.Z, Is.EqualTo(0), "A pen draws at Z 0.");
        Assert.That(Drawn(Flat).Feed("Layer", 3).Solve().One<PrintPath>("Print Path").Layer, Is.EqualTo(new Layer(3, 0.2)));
    }

    [Test]
    public void Layers_are_stacked_in_a_branch_per_curve_and_planned_layer_by_layer()
    {
        var other = new Rg.LineCurve(new Rg.Point3d(50, 60, 0), new Rg.Point3d(80, 60, 0));
        var canvas = Drawn(Flat, other).Feed("Layer Count", 3).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(canvas.Paths("Layers"), Is.EqualTo(new[] { "{0;0}", "{0;1}" }));
        Assert.That(canvas.Paths("Print Path"), Is.EqualTo(new[] { "{0}" }));
        var layers = canvas.All("Layers").Cast<PrintPath>().ToArray();
        Assert.That(layers.Select(p => Math.Round(p.Start.Z, 9)), Is.EqualTo(new[] { 0.2, 0.4, 0.6, 0.2, 0.4, 0.6 }));
        Assert.That(layers.Select(p => p.Layer!.Index), Is.EqualTo(new[] { 0, 1, 2, 0, 1, 2 }));
        var plan = new Canvas<PlanToolpathComponent>(canvas.Document);
        plan.Input("Steps").AddSource(canvas.Output("Layers"));
        plan.Solve();
        var printed = plan.One<Toolpath>("Toolpath").Moves().Where(m => m.Kind == MoveKind.Print).Select(m => Math.Round(m.End.Z, 9));
        Assert.That(printed, Is.EqualTo(new[] { 0.2, 0.2, 0.4, 0.4, 0.6, 0.6 }));
    }

    [Test]
    public void Layers_need_a_flat_curve_on_the_bed()
    {
        Assert.That(Drawn(Corner).Feed("Layer Count", 2).Solve().Errors, Has.One.Contains("curves.not_flat"));
        Assert.That(Drawn(Flat).Feed("Layer Count", 2).Feed("Base", "As Drawn").Solve().Errors, Has.One.Contains("Layer Count needs Base at Bed"));
        Assert.That(Drawn(Flat).Feed("Layer Count", -1).Solve().Errors, Has.One.Contains("Layer Count must be from 0 to 100000."));
    }

    [Test]
    public void One_number_holds_for_the_whole_path()
    {
        var canvas = Drawn(Corner).Feed("Widths", 0.8).Feed("Heights", 0.4).Feed("Flows", 1.5).Feed("Speeds", 25.0).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        // A stadium of 0.8 by 0.4 mm, and half as much again.
        var area = 1.5 * (0.4 * 0.4 + Math.PI / 4 * 0.16);
        Assert.That(Beads(canvas), Is.EqualTo(new[] { (Round(area), 0.4, 25.0), (Round(area), 0.4, 25.0) }));
    }

    [Test]
    public void A_bead_without_a_height_gets_that_of_the_settings_where_widths_are_given()
    {
        var area = 0.6 * 0.2 + Math.PI / 4 * 0.04;
        var canvas = Drawn(Corner).Feed("Bead", Bead(0.1, 0)).Feed("Widths", 0.8).Solve();
        Assert.That(Beads(canvas), Is.EqualTo(new[] { (Round(area), 0.2, 0.0), (Round(area), 0.2, 0.0) }));
    }

    [Test]
    public void Numbers_for_each_vertex_change_evenly_or_in_steps()
    {
        var steps = Drawn(Corner).Feed("Bead", Bead(0.1, 0.2)).Feed("Speeds", 10.0, 20.0, 40.0).Feed("Interpolation", "Steps").Solve();
        Assert.That(Beads(steps), Is.EqualTo(new[] { (0.1, 0.2, 10.0), (0.1, 0.2, 20.0) }), "The area of the bead stays.");
        // From 10 to 12.5 in steps of at most a tenth of it: two parts, at a quarter and three quarters.
        var even = Drawn(Corner).Feed("Bead", Bead(0.1, 0.2)).Feed("Speeds", 10.0, 12.5, 12.5).Solve();
        Assert.That(Beads(even).Select(b => b.Speed), Is.EqualTo(new[] { 10.625, 11.875, 12.5 }));
        var flows = Drawn(Corner).Feed("Widths", 1.0).Feed("Heights", 0.5).Feed("Flows", 1.0, 2.0, 1.0).Feed("Interpolation", "Steps").Solve();
        var one = 0.25 + Math.PI / 4 * 0.25;
        Assert.That(Beads(flows).Select(b => b.Area), Is.EqualTo(new[] { Round(one), Round(2 * one) }));
    }

    [TestCase(false)]
    [TestCase(true)]
    public void Deconstruct_gives_what_Construct_takes(bool closed)
    {
        var points = new List<Vec3> { new(0, 0, 1), new(10, 0, 1), new(10, 5, 1), new(0, 5, 1) };
        Bead[] beads = [new(0.09, 0.2, 10), new(0.2, 0.25, 20), new(0.12, 0.3, 30), new(0.15, 0.2, 0)];
        var path = new PrintPath(points, closed ? beads : beads.Take(3), closed);
        var apart = new Canvas<DeconstructPrintPathComponent>().Feed("Print Path", path).Solve();
        var corners = apart.All("Points").Cast<Rg.Point3d>().ToList();
        if (closed) corners.Add(corners[0]);
        var canvas = Drawn(new Rg.PolylineCurve(corners)).Feed("Interpolation", "Steps");
        foreach (var name in new[] { "Widths", "Heights", "Speeds" }) canvas.Feed(name, apart.All(name).ToArray());
        canvas.Solve();
        Assert.That(canvas.Errors, Is.Empty);
        var back = canvas.One<PrintPath>("Print Path");
        Assert.That(back.Points, Is.EqualTo(path.Points));
        var given = Enumerable.Range(0, path.SegmentCount).Select(i => path.BeadOf(i));
        Assert.That(Beads(canvas), Is.EqualTo(given.Select(b => (Round(b.Area), b.Height, b.Speed))));
    }

    [Test]
    public void Another_count_is_an_error_that_names_the_port_and_both_counts()
    {
        Assert.That(Drawn(Corner).Feed("Widths", 1.0, 2.0, 3.0, 4.0).Solve().Errors,
            Has.One.Contains("{0}[0]: Widths has 4 numbers, but the curve has 3 vertices. Give one for all, or one for each vertex"));
        var circle = new Rg.ArcCurve(new Rg.Circle(new Rg.Point3d(0, 0, 1), 10));
        Assert.That(Drawn(circle).Feed("Widths", 1.0, 2.0).Feed("Speeds", 10.0, 20.0, 30.0).Solve().Errors,
            Has.One.Contains("Widths has 2 numbers, but another list has 3."));
        Assert.That(Drawn(circle).Feed("Widths", 1.0, 2.0).Solve().Errors, Is.Empty, "At equal distances.");
        Assert.That(Drawn(Corner).Feed("Flows", -1.0).Solve().Errors, Has.One.Contains("curves.bead"));
    }

    [Test]
    public void A_tree_beside_grafted_curves_gives_each_its_numbers_and_a_bad_branch_stops_only_its_own()
    {
        var canvas = new Canvas<ConstructPrintPathComponent>().FeedTree("Curve", [Corner], [Corner], [Corner]).Feed("Bead", Bead(0.1, 0.2))
            .FeedTree("Speeds", [10.0], [10.0, 20.0, 30.0, 40.0], [5.0, 6.0]).Solve();
        Assert.That(canvas.Paths("Print Path"), Is.EqualTo(new[] { "{0}", "{1}", "{2}" }));
        var paths = canvas.All("Print Path").Cast<PrintPath?>().ToArray();
        Assert.That(paths[0]!.BeadOf(0).Speed, Is.EqualTo(10));
        Assert.That(paths[1], Is.Null);
        Assert.That(new[] { paths[2]!.BeadOf(0).Speed, paths[2]!.BeadOf(1).Speed }, Is.EqualTo(new[] { 5.0, 6.0 }), "One for each segment.");
        Assert.That(canvas.Errors, Has.One.StartsWith("{1}[0]: Speeds has 4 numbers"));
        Assert.That(Drawn(Corner).Feed("Speeds", 10.0, null, 20.0).Solve().Errors, Has.One.Contains("Speeds: the connected source gives no valid data."));
        Assert.That(Drawn(Corner).Feed("Speeds", "fast").Solve().Errors, Has.Some.Contains("onversion failed"));
    }

    private static double Round(double value) => Math.Round(value, 9);

    private static (double Area, double Height, double Speed)[] Beads(Canvas<ConstructPrintPathComponent> canvas)
    {
        var path = canvas.One<PrintPath>("Print Path");
        return Enumerable.Range(0, path.SegmentCount).Select(i => path.BeadOf(i)).Select(b => (Round(b.Area), b.Height, b.Speed)).ToArray();
    }
}
