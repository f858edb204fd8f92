using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Drawings;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Curves;

public class CurvePathsTests
{
    [Test]
    public void The_E_per_mm_of_the_sample_in_the_paper_is_reproduced()
    {
        // G1 X65.7029 Y68.4932 Z40.1287 E1.3947, then G1 X66.6977 Y67.4932 Z40.2310 E1.5861: 0.1353 mm of filament per mm.
        var line = new PolylineCurve([new Vec3(65.7029, 68.4932, 40.1287), new Vec3(66.6977, 67.4932, 40.2310)]);
        var options = new CurveOptions { Width = 0.8, Height = 0.4, Flow = 1.017 };
        var path = CurvePaths.ToPaths([new UserCurve(line)], options).Value!.Single();
        var law = new ExtrusionModel(ExtrusionUnit.Mm, 1.75);
        var e = law.E(path.Length, path.BeadOf(0).Area);
        Assert.That(e / path.Length, Is.EqualTo(0.1353).Within(5e-5));
        Assert.That(1.3947 + e, Is.EqualTo(1.5861).Within(1e-4));
    }

    [Test]
    public void Curves_are_printed_in_their_order()
    {
        var random = new Random(41);
        var curves = Enumerable.Range(0, 20).Select(_ => new UserCurve(new PolylineCurve([Point(random), Point(random)]))).ToArray();
        var steps = CurvePaths.ToSteps(curves).Value!;
        for (var i = 0; i < curves.Length; i++)
        {
            var step = (PathStep)steps[i];
            Assert.That(step.Path.Points, Is.EqualTo(new[] { curves[i].Curve.Start, curves[i].Curve.End }));
            Assert.That(step.Group, Is.Null);
        }
        var sortable = CurvePaths.ToSteps(curves, new CurveOptions { Sorting = CurveSorting.All }).Value!;
        Assert.That(((PathStep)sortable[3]).Group, Is.EqualTo(new StepGroup(0)));
        var layered = CurvePaths.ToSteps([curves[0] with { Layer = new Layer(7, 1) }], new CurveOptions { Sorting = CurveSorting.WithinLayers }).Value!;
        Assert.That(((PathStep)layered[0]).Group, Is.EqualTo(new StepGroup(7)));
    }

    [Test]
    public void Settings_of_a_curve_take_precedence_over_those_for_all()
    {
        var line = new PolylineCurve([Vec3.Zero, Vec3.UnitX]);
        var options = new CurveOptions { Width = 0.5, Height = 0.2, Speed = 30 };
        Bead Bead(UserCurve curve) => CurvePaths.ToPaths([curve], options).Value!.Single().BeadOf(0);
        Assert.That(Bead(new UserCurve(line)), Is.EqualTo(new Bead(0.5 * 0.2, 0.2, 30)));
        Assert.That(Bead(new UserCurve(line) { Width = 1, Speed = 10, Flow = 2 }), Is.EqualTo(new Bead(1 * 0.2 * 2, 0.2, 10)));
        Assert.That(Bead(new UserCurve(line) { Area = 0.7, Height = 0.3 }), Is.EqualTo(new Bead(0.7, 0.3, 30)));
        var path = CurvePaths.ToPaths([new UserCurve(line) { Name = "a", Tool = 2, Role = Role.Brim, Layer = new Layer(3, 1) }], options).Value!.Single();
        Assert.That((path.Name, path.Tool, path.Role, path.Layer!.Index), Is.EqualTo(("a", 2, Role.Brim, 3)));
    }

    [Test]
    public void A_flat_drawing_is_stacked_in_layers()
    {
        var line = new UserCurve(new PolylineCurve([new Vec3(10, 10), new Vec3(30, 10)])) { Name = "a", Layer = new Layer(7, 9) };
        UserCurve[] flat = [line, UserCurve.DotAt(new Vec3(10, 20), 2)];
        var settings = new PrintSettings { FirstLayerHeight = 0.3, LayerHeight = 0.2, LineWidth = 0.5, BeadShape = BeadShape.Rectangle };
        var options = CurveOptions.For(new PrintSetup { Settings = settings }) with { Layers = 3 };
        var made = CurvePaths.ToSteps(flat, options);
        var paths = made.Value!.OfType<PathStep>().Select(s => s.Path).ToArray();
        Assert.That(paths.Select(p => (p.Layer!.Index, Math.Round(p.Layer.Z, 9), p.Layer.Thickness)),
            Is.EqualTo(new[] { (0, 0.3, 0.3), (1, 0.5, 0.2), (2, 0.7, 0.2) }));
        Assert.That(paths.Select(p => p.Points[0].Z), Is.EqualTo(paths.Select(p => p.Layer!.Z)));
        Assert.That(paths.Select(p => p.BeadOf(0).Area), Is.EqualTo(new[] { 0.15, 0.1, 0.1 }).Within(1e-12), "as thick as their layers");
        Assert.That(made.Value!.OfType<TravelStep>().Select(t => Math.Round(t.Points.Last().Z, 9)), Is.EqualTo(new[] { 0.3, 0.5, 0.7 }), "dots, too");
        Assert.That(made.Diagnostics.Single().Message, Does.EndWith("the height of the first layer, and stacked 3 layers high."));
        var own = CurvePaths.ToPaths([flat[0] with { Height = 0.25 }], options).Value!;
        Assert.That(own.Select(p => p.BeadOf(0).Area), Is.All.EqualTo(0.125).Within(1e-12), "a height of its own stays");
        Assert.That(CurvePaths.ToPaths(flat, options with { Layers = 1 }).Value!.Single().Layer, Is.EqualTo(new Layer(0, 0.3, 0.3)));
        UserCurve[] rising = [new(new PolylineCurve([new Vec3(10, 20), new Vec3(30, 20, 1)]))];
        foreach (var wrong in new[] { CurvePaths.ToPaths(rising, options), CurvePaths.ToPaths(flat, options with { Strokes = true }) })
            Assert.That((wrong.Value, wrong.Diagnostics.Single().Code), Is.EqualTo(((IReadOnlyList<PrintPath>?)null, "curves.not_flat")));
    }

    [Test]
    public void A_flat_drawing_is_printed_at_the_height_of_the_first_layer()
    {
        UserCurve[] flat = [new(new PolylineCurve([new Vec3(10, 10), new Vec3(30, 10)])), new(new PolylineCurve([new Vec3(10, 20), new Vec3(30, 20)]))];
        var setup = new PrintSetup { Settings = new PrintSettings { FirstLayerHeight = 0.3 } };
        var raised = CurvePaths.ToPaths(flat, CurveOptions.For(setup));
        Assert.That(raised.Value!.SelectMany(p => p.Points).Select(p => p.Z), Is.All.EqualTo(0.3));
        Assert.That(raised.Diagnostics.Single().ToString(),
            Is.EqualTo("note curves.flat: The drawing is flat at Z 0. It is printed at Z 0.3, the height of the first layer."));
        Assert.That(Heights(flat, CurveOptions.From(setup.Settings)), Is.All.Zero, "as drawn");
        Assert.That(Heights(flat, CurveOptions.For(setup) with { Strokes = true }), Is.All.Zero, "a pen");
        Assert.That(Heights([flat[0] with { Area = 0 }], CurveOptions.For(setup)), Is.All.Zero, "nothing is extruded");
        var plotter = setup with { Printer = new Printer { ExtrusionUnit = ExtrusionUnit.None } };
        Assert.That(Heights(flat, CurveOptions.For(plotter)), Is.All.Zero, "a printer without an extruder");
        UserCurve[] rising = [flat[0], new(new PolylineCurve([new Vec3(10, 20), new Vec3(30, 20, 1)]))];
        Assert.That(Heights(rising, CurveOptions.For(setup)), Is.EqualTo(new[] { 0.0, 0, 0, 1 }), "not flat");

        static double[] Heights(UserCurve[] curves, CurveOptions options)
            => CurvePaths.ToPaths(curves, options).Value!.SelectMany(p => p.Points).Select(p => p.Z).ToArray();
    }

    [Test]
    public void Strokes_deposit_nothing()
    {
        var paths = CurvePaths.ToPaths([new UserCurve(ArcCurve.Circle(Vec3.Zero, 5)) { Area = 3 }], new CurveOptions { Strokes = true }).Value!;
        Assert.That(paths.Single().Volume, Is.Zero);
        Assert.That(CurvePaths.ToPaths([new UserCurve(ArcCurve.Circle(Vec3.Zero, 5)) { Area = 0 }]).Value!.Single().Volume, Is.Zero);
    }

    [Test]
    public void Values_along_a_polyline_become_ramps_with_the_same_volume()
    {
        var points = new Vec3[] { new(0, 0), new(10, 0), new(20, 0), new(20, 5) };
        var curve = new UserCurve(new PolylineCurve(points)) { Along = new PointValues(areas: [0.1, 0.3, 0.3, 0.3], speeds: [20, 20, 40, 40]) };
        var path = CurvePaths.ToPaths([curve]).Value!.Single();
        Assert.That(path.Volume, Is.EqualTo(10 * 0.2 + 10 * 0.3 + 5 * 0.3).Within(1e-12));
        foreach (var point in points) Assert.That(path.Points, Does.Contain(point));
        for (var i = 1; i < path.SegmentCount; i++)
        {
            Assert.That(Math.Abs(path.BeadOf(i).Area - path.BeadOf(i - 1).Area), Is.LessThan(0.1 * 0.3 + 1e-12));
            Assert.That(Math.Abs(path.BeadOf(i).Speed - path.BeadOf(i - 1).Speed), Is.LessThan(0.1 * 40 + 1e-12));
        }
        Assert.That(path.BeadOf(path.SegmentCount - 1), Is.EqualTo(new Bead(0.3, 0.2, 40)));
    }

    [Test]
    public void Flows_along_a_polyline_scale_width_and_height()
    {
        var curve = new UserCurve(new PolylineCurve([new(0, 0), new(10, 0), new(20, 0)])) { Flow = 5, Along = new PointValues(flows: [1, 2, 3]) };
        var path = CurvePaths.ToPaths([curve], new CurveOptions { Width = 0.5, Height = 0.2, Steps = true }).Value!.Single();
        Assert.That(path.Points.Select(p => p.X), Is.EqualTo(new[] { 0.0, 10, 20 }));
        Assert.That(new[] { path.BeadOf(0).Area, path.BeadOf(1).Area }, Is.EqualTo(new[] { 0.1, 0.2 }).Within(1e-12));
    }

    [Test]
    public void The_layer_of_a_flat_curve_is_raised_with_it()
    {
        var curve = new UserCurve(new PolylineCurve([Vec3.Zero, new Vec3(10, 0)])) { Layer = new Layer(2, 0) };
        var path = CurvePaths.ToPaths([curve], new CurveOptions { FlatHeight = 0.3 }).Value!.Single();
        Assert.That((path.Start.Z, path.Layer), Is.EqualTo((0.3, new Layer(2, 0.3))));
    }

    [Test]
    public void Values_along_other_curves_are_spaced_by_length()
    {
        var curve = new UserCurve(new ArcCurve(Frame.World, 10, 180)) { Along = new PointValues(areas: [0.1, 0.1, 0.4]) };
        var path = CurvePaths.ToPaths([curve], new CurveOptions { Subdivision = SubdivisionOptions.ByDistance(0.5) }).Value!.Single();
        for (var i = 0; i < path.SegmentCount; i++)
        {
            if (path.EndOf(i).X > 0) Assert.That(path.BeadOf(i).Area, Is.EqualTo(0.1).Within(1e-12));
        }
        Assert.That(path.BeadOf(path.SegmentCount - 1).Area, Is.EqualTo(0.4).Within(0.02));
        Assert.That(path.Volume, Is.EqualTo(path.Length * (0.5 * 0.1 + 0.5 * 0.25)).Within(0.01));
    }

    [Test]
    public void A_closed_polyline_with_values_returns_to_the_first_value()
    {
        var curve = new UserCurve(new PolylineCurve([new(0, 0), new(4, 0), new(4, 4)], closed: true)) { Along = new PointValues(areas: [0.1, 0.2, 0.3]) };
        var path = CurvePaths.ToPaths([curve]).Value!.Single();
        Assert.That(path.IsClosed, Is.True);
        Assert.That(path.BeadOf(path.SegmentCount - 1).Area, Is.EqualTo(0.1).Within(0.02));
        Assert.That(path.Volume, Is.EqualTo(4 * 0.15 + 4 * 0.25 + Math.Sqrt(32) * 0.2).Within(1e-9));
    }

    [Test]
    public void Arcs_are_kept_or_fitted_on_request()
    {
        var circle = new UserCurve(ArcCurve.Circle(new Vec3(5, 5, 0.2), 5));
        var kept = CurvePaths.ToPaths([circle], new CurveOptions { Subdivision = SubdivisionOptions.ByDistance(1) with { KeepArcs = true } }).Value!.Single();
        Assert.That(kept.SegmentCount, Is.EqualTo(2));
        Assert.That(kept.IsClosed, Is.True);
        var fitted = CurvePaths.ToPaths([circle], new CurveOptions { FitArcs = 0.05 }).Value!.Single();
        Assert.That(fitted.HasArcs, Is.True);
        Assert.That(fitted.Length, Is.EqualTo(kept.Length).Within(0.1));
    }

    [Test]
    public void Touching_curves_are_joined_on_request()
    {
        var curves = new[] { new UserCurve(new PolylineCurve([Vec3.Zero, Vec3.UnitX])), new UserCurve(new PolylineCurve([Vec3.UnitX, new Vec3(1, 1)])) };
        Assert.That(CurvePaths.ToPaths(curves).Value, Has.Count.EqualTo(2));
        Assert.That(CurvePaths.ToPaths(curves, new CurveOptions { MergeTolerance = 0.01 }).Value, Has.Count.EqualTo(1));
    }

    [Test]
    public void Bad_curves_are_reported()
    {
        var line = new PolylineCurve([Vec3.Zero, Vec3.UnitX]);
        Diagnostic Problem(UserCurve curve) => CurvePaths.ToPaths([curve]).Diagnostics[0];
        Assert.That(Problem(new UserCurve(line) { Area = -1 }).Code, Is.EqualTo("curves.bead"));
        Assert.That(Problem(new UserCurve(line) { Width = double.NaN }).Severity, Is.EqualTo(Severity.Error));
        Assert.That(Problem(new UserCurve(line) { Along = new PointValues(areas: [0.1, -0.1]) }).Code, Is.EqualTo("curves.bead"));
        var below = CurvePaths.ToPaths([new UserCurve(new PolylineCurve([Vec3.Zero, new Vec3(5, 0, -1)]))]);
        Assert.That(below.Value, Has.Count.EqualTo(1));
        Assert.That(below.Diagnostics[0].Code, Is.EqualTo("curves.below_bed"));
        Assert.That(below.Diagnostics[0].Message, Does.Contain("Z -1 mm"));
        var point = CurvePaths.ToPaths([new UserCurve(new PolylineCurve([Vec3.UnitX, Vec3.UnitX])), new UserCurve(line)]);
        Assert.That(point.Value, Has.Count.EqualTo(1));
        Assert.That(point.Diagnostics[0].Code, Is.EqualTo("curves.too_short"));
        Assert.That(CurvePaths.ToPaths([]).Diagnostics[0].Code, Is.EqualTo("curves.empty"));
        Assert.That(() => new PointValues(areas: [1, 2], speeds: [1, 2, 3]), Throws.ArgumentException);
    }

    [Test]
    public void Repeated_points_and_crossings_are_printed_as_drawn()
    {
        var eight = new PolylineCurve([new(0, 0), new(4, 4), new(4, 4), new(4, 0), new(0, 4), new(0, 4), new(2, 2)]);
        var path = CurvePaths.ToPaths([new UserCurve(eight)]).Value!.Single();
        Assert.That(path.Points, Is.EqualTo(new Vec3[] { new(0, 0), new(4, 4), new(4, 0), new(0, 4), new(2, 2) }));
        var withValues = new UserCurve(eight) { Along = new PointValues(areas: [.1, .1, .1, .1, .1, .2, .2]) };
        Assert.That(CurvePaths.ToPaths([withValues]).Value!.Single().Length, Is.EqualTo(path.Length).Within(1e-12));
    }

    private static Vec3 Point(Random random) => new(random.NextDouble() * 100, random.NextDouble() * 100, random.NextDouble());

    [Test]
    public void A_division_that_is_too_fine_names_its_curve()
    {
        var circle = new UserCurve(new ArcCurve(Frame.World, 10)) { Source = new SourceLocation("c.svg", 7) };
        var made = CurvePaths.ToPaths([circle], new CurveOptions { Subdivision = SubdivisionOptions.ByDistance(1e-9) });
        Assert.That(made.Value, Is.Null);
        Assert.That(made.Diagnostics.Select(d => (d.Code, d.Source!.Line)), Does.Contain(("curves.too_fine", (int?)7)));
    }

    [Test]
    public void Merged_curves_state_the_first_of_them_and_those_after_it_their_own()
    {
        UserCurve Line(double from, double to, int line)
            => new(new PolylineCurve([new Vec3(from, 0, 0.2), new Vec3(to, 0, 0.2)])) { Source = new SourceLocation("a.csv", line) };
        var steps = CurvePaths.ToSteps([Line(0, 10, 1), Line(10, 20, 2), Line(20, 30, 3), Line(50, 60, 4), Line(80, 90, 5), Line(90, 95, 6)],
            new CurveOptions { MergeTolerance = 0.01 }).Value!;
        Assert.That(steps.Select(s => ((PathStep)s).Path.End.X), Is.EqualTo(new[] { 30.0, 60, 95 }));
        Assert.That(steps.Select(s => s.Source!.Line), Is.EqualTo(new int?[] { 1, 4, 5 }));
    }
}
