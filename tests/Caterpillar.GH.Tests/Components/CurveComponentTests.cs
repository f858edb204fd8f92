using System;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.GH.Components.Path;
using Caterpillar.GH.Components.Setup;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Toolpaths;
using NUnit.Framework;
using Rhino;

namespace Caterpillar.GH.Tests.Components;

[Category("Host")]
public sealed class CurveComponentTests
{
    private static readonly Bead Thin = new(0.1, 0.2, 30);

    [Test]
    public void A_bead_comes_from_width_and_height()
    {
        var canvas = new Canvas<ConstructBeadComponent>().Feed("Width", 0.8).Feed("Height", 0.4).Feed("Flow", 1.017).Feed("Cross Section", "Rectangle")
            .Feed("Speed", 24.0).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(canvas.One<double>("Area"), Is.EqualTo(0.8 * 0.4 * 1.017).Within(1e-12));
        // The sample of the Caterpillar paper.
        Assert.That(canvas.One<double>("E Factor"), Is.EqualTo(0.1353).Within(1e-4));
        Assert.That(canvas.One<Bead>("Bead").Speed, Is.EqualTo(24));
        Assert.That(new Canvas<ConstructBeadComponent>().Feed("Width", -1.0).Solve().Errors, Has.Count.EqualTo(1));
    }

    [Test]
    public void A_curve_becomes_a_path_with_its_bead()
    {
        var curve = Rg.NurbsCurve.Create(false, 3, new Rg.Point3d[] { new(0, 0, 1), new(5, 0, 1), new(10, 5, 1), new(10, 10, 1), new(20, 12, 1) });
        var canvas = new Canvas<ConstructPrintPathComponent>().Feed("Curve", curve).Feed("Bead", new BeadGoo(Thin)).Feed("Role", "Outer Wall")
            .Feed("Subdivision", 0.5).Feed("Layer", 4).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        var path = canvas.One<PrintPath>("Print Path");
        Assert.That((path.Role, path.Layer!.Index, path.BeadOf(0)), Is.EqualTo((Role.OuterWall, 4, Thin)));
        Assert.That(path.SegmentCount, Is.EqualTo((int)Math.Ceiling(curve.GetLength() / 0.5)));
        Assert.That(path.Start, Is.EqualTo(new Vec3(0, 0, 1)));
        foreach (var p in path.Points) Assert.That(Nearest(curve, p), Is.LessThan(1e-3));
    }

    [Test]
    public void Polylines_circles_and_joined_curves_keep_what_they_are()
    {
        var square = new Rg.PolylineCurve(new Rg.Point3d[] { new(0, 0, 0), new(5, 0, 0), new(9, 0, 0), new(9, 9, 0), new(0, 9, 0), new(0, 0, 0) });
        var path = new Canvas<ConstructPrintPathComponent>().Feed("Curve", square).Solve().One<PrintPath>("Print Path");
        Assert.That((path.IsClosed, path.Points.Count), Is.EqualTo((true, 4)));
        Assert.That(path.BeadOf(0).Height, Is.EqualTo(0.2));

        var triangle = new Rg.PolylineCurve(new Rg.Point3d[] { new(0, 0, 0), new(9, 0, 0), new(9, 9, 0), new(0, 0, 0) });
        path = new Canvas<ConstructPrintPathComponent>().Feed("Curve", triangle).Solve().One<PrintPath>("Print Path");
        Assert.That((path.IsClosed, path.Points.Count), Is.EqualTo((true, 3)));

        var circle = new Rg.ArcCurve(new Rg.Circle(new Rg.Point3d(1, 2, 3), 4));
        var arcs = new Canvas<ConstructPrintPathComponent>().Feed("Curve", circle).Feed("Keep Arc", true).Solve().One<PrintPath>("Print Path");
        Assert.That((arcs.IsClosed, arcs.SegmentCount), Is.EqualTo((true, 2)));
        Assert.That(arcs.Length, Is.EqualTo(8 * Math.PI).Within(1e-9));

        var joined = new Rg.PolyCurve();
        joined.Append(new Rg.LineCurve(new Rg.Point3d(0, 0, 0), new Rg.Point3d(10, 0, 0)));
        joined.Append(new Rg.ArcCurve(new Rg.Arc(new Rg.Plane(new Rg.Point3d(10, 5, 0), -Rg.Vector3d.YAxis, Rg.Vector3d.XAxis), 5, Math.PI / 2)));
        var both = new Canvas<ConstructPrintPathComponent>().Feed("Curve", joined).Feed("Keep Arc", true).Solve().One<PrintPath>("Print Path");
        Assert.That(both.SegmentCount, Is.EqualTo(2));
        Assert.That(both.ArcOf(1)!.Value.Sweep, Is.EqualTo(90).Within(1e-9));
        Assert.That(both.End.DistanceTo(new Vec3(15, 5, 0.2)), Is.LessThan(1e-9));
    }

    [Test]
    public void Curves_are_scaled_to_mm()
    {
        using var _ = new InDocument(UnitSystem.Centimeters);
        var canvas = new Canvas<ConstructPrintPathComponent>().Feed("Curve", new Rg.ArcCurve(new Rg.Circle(new Rg.Point3d(0, 0, 0.1), 2)))
            .Feed("Keep Arc", true).Solve();
        Assert.That(canvas.One<PrintPath>("Print Path").Length, Is.EqualTo(40 * Math.PI).Within(1e-9));
        Assert.That(canvas.Notes, Has.Some.Contains("centimeters"));
    }

    [Test]
    public void Bad_items_give_null_and_the_rest_continues()
    {
        var line = new Rg.LineCurve(new Rg.Point3d(0, 0, 0), new Rg.Point3d(10, 0, 0));
        var canvas = new Canvas<ConstructPrintPathComponent>().Feed("Curve", line, null, line).Solve();
        Assert.That(canvas.All("Print Path").Select(p => p is null), Is.EqualTo(new[] { false, true, false }));
        Assert.That(canvas.Warnings, Has.Member("{0}[1]: Curve is missing."));
        Assert.That(new Canvas<ConstructPrintPathComponent>().Feed("Curve", line).Feed("Subdivision", 0.0).Solve().Errors,
            Has.Some.Contains("greater than zero"));
        var below = new Canvas<ConstructPrintPathComponent>().Feed("Curve", new Rg.LineCurve(new Rg.Point3d(0, 0, -1), new Rg.Point3d(10, 0, 0))).Solve();
        Assert.That(below.Warnings, Has.Some.Contains("curves.below_bed"));
        Assert.That(below.All("Diagnostics"), Has.Count.EqualTo(1));
    }

    [Test]
    public void Subdividing_separates_linear_and_curved_parts()
    {
        var joined = new Rg.PolyCurve();
        joined.Append(new Rg.LineCurve(new Rg.Point3d(0, 0, 0), new Rg.Point3d(10, 0, 0)));
        joined.Append(new Rg.ArcCurve(new Rg.Arc(new Rg.Plane(new Rg.Point3d(10, 5, 0), -Rg.Vector3d.YAxis, Rg.Vector3d.XAxis), 5, Math.PI / 2)));
        joined.Append(new Rg.LineCurve(new Rg.Point3d(15, 5, 0), new Rg.Point3d(15, 9, 0)));
        var byDistance = new Canvas<SubdivideCurveComponent>().Feed("Curve", joined).Solve();
        Assert.That(byDistance.Errors, Is.Empty);
        Assert.That((byDistance.All("Lines").Count, byDistance.All("Curved Parts").Count, byDistance.All("Points").Count), Is.EqualTo((2, 1, 2 + 8 + 1)));
        var byAngle = new Canvas<SubdivideCurveComponent>().Feed("Curve", joined).Feed("Mode", "Angle").Feed("Angle", 30.0).Solve();
        Assert.That(byAngle.All("Points"), Has.Count.EqualTo(2 + 4 + 1).Or.Count.EqualTo(2 + 3 + 1));
        var byTolerance = new Canvas<SubdivideCurveComponent>().Feed("Curve", joined).Feed("Mode", 1).Feed("Tolerance", 0.5).Solve();
        Assert.That(byTolerance.All("Points").Count, Is.LessThan(6));
    }

    [Test]
    public void Arcs_are_fitted_and_the_message_counts()
    {
        var circle = new PrintPath(Enumerable.Range(0, 60).Select(i => new Vec3(10 * Math.Cos(i * Math.PI / 30), 10 * Math.Sin(i * Math.PI / 30))), Thin,
            closed: true);
        var canvas = new Canvas<FitArcsComponent>().Feed("Print Paths", circle).Solve();
        var fitted = canvas.One<PrintPath>("Print Paths");
        Assert.That(fitted.SegmentCount, Is.EqualTo(2));
        Assert.That(canvas.Component.Message, Is.EqualTo("60 → 2 segments"));
        Assert.That(new Canvas<FitArcsComponent>().Feed("Print Paths", circle).Feed("Tolerance", -1.0).Solve().Errors, Is.Not.Empty);
    }

    [Test]
    public void Paths_are_oriented_in_their_order()
    {
        PrintPath[] lines = [Line(0, 10), Line(20, 11)];
        var oriented = new Canvas<SortPathsComponent>().Feed("Rule", "Orient").Feed("Print Paths", lines[0], lines[1]).Solve();
        Assert.That(oriented.All("Print Paths").Cast<PrintPath>().Select(p => p.Start.X), Is.EqualTo(new[] { 0.0, 11 }));
        Assert.That(oriented.One<double>("Travel"), Is.EqualTo(1));
        var kept = new Canvas<SortPathsComponent>().Feed("Rule", "Orient").Feed("Print Paths", lines[0], lines[1]).Feed("Reverse", false).Solve();
        Assert.That(kept.All("Print Paths").Cast<PrintPath>().Select(p => p.Start.X), Is.EqualTo(new[] { 0.0, 20 }));
    }

    [Test]
    public void Touching_paths_are_merged_in_each_branch()
    {
        var canvas = new Canvas<MergePathsComponent>().FeedTree("Print Paths", [Line(0, 10), Line(10, 20)], [Line(0, 10), null, Line(11, 20)]).Solve();
        Assert.That(canvas.All("Print Paths").Cast<PrintPath>().Select(p => p.SegmentCount), Is.EqualTo(new[] { 2, 1, 1 }));
        Assert.That(canvas.Warnings, Has.Some.Contains("1 null item"));
    }

    private static PrintPath Line(double from, double to) => new([new Vec3(from, 0), new Vec3(to, 0)], Thin);

    private static double Nearest(Rg.Curve curve, Vec3 p)
        => Enumerable.Range(0, 5001).Min(i => curve.PointAt(curve.Domain.ParameterAt(i / 5000.0))
            .DistanceTo(new Rg.Point3d(p.X, p.Y, p.Z))) - curve.GetLength() / 5000;
}
