using System;
using System.Linq;
using Caterpillar.GH.Components.Design;
using Caterpillar.GH.Components.Setup;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using NUnit.Framework;
using Rhino;

namespace Caterpillar.GH.Tests.Components;

[Category("Host")]
public sealed class TraceComponentsTests
{
    private static readonly Bead Extrusion = new(0.196, 0, 25);

    [Test]
    public void The_model_of_a_bead_changes_its_area()
    {
        var canvas = new Canvas<ConstructBeadComponent>().Feed("Width", 0.5).Feed("Height", 0.5).Feed("Cross Section", "Rectangle", "stadium", 2).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        var circle = Math.PI * 0.25 * 0.25;
        Assert.That(canvas.All("Area").Cast<double>(), Is.EqualTo(new[] { 0.25, circle, circle }).Within(1e-12));
        Assert.That(new Canvas<ConstructBeadComponent>().Feed("Width", 0.5).Feed("Height", 0.0).Feed("Cross Section", "Circle").Solve().One<double>("Area"),
            Is.EqualTo(circle).Within(1e-12));
    }

    [Test]
    public void Bad_widths_of_beads_are_named_and_the_rest_continues()
    {
        var canvas = new Canvas<ConstructBeadComponent>().Feed("Width", 0.5, null, -1.0, double.NaN, 0.6).Feed("Height", 0.2).Solve();
        Assert.That(canvas.All("Bead").Select(b => b is null), Is.EqualTo(new[] { false, true, true, true, false }));
        Assert.That(canvas.Errors, Has.Count.EqualTo(3).And.One.EqualTo("{0}[1]: Width: the connected source gives no valid data."));
        Assert.That(new Canvas<ConstructBeadComponent>().Feed("Width", 0.2).Feed("Height", 0.5).Feed("Cross Section", "Stadium").Solve().Errors.Single(),
            Does.Contain("at least as wide as it is high"));
        Assert.That(new Canvas<ConstructBeadComponent>().Feed("Width", 0.2).Feed("Height", 0.5).Feed("Cross Section", 7).Solve().Errors.Single(),
            Does.Contain("no choice 7"));
        Assert.That(new Canvas<ConstructBeadComponent>().FeedTree("Width", [0.4], [0.5, 0.6]).Feed("Height", 0.2).Solve().Paths("Bead"),
            Is.EqualTo(new[] { "{0}", "{1}" }));
    }

    [Test]
    public void Circles_stand_on_their_plane_in_document_units()
    {
        using var _ = new InDocument(UnitSystem.Centimeters);
        var plane = new Rg.Plane(new Rg.Point3d(1, 2, 3), Rg.Vector3d.YAxis, Rg.Vector3d.ZAxis);
        var path = Path(new Canvas<RoundTraceComponent>().Feed("Plane", plane).Feed("Radius", 10.0).Feed("Bead", Extrusion).Feed("Segments Per Turn", 4));
        Assert.That(path.SegmentCount, Is.EqualTo(4));
        Assert.That(path.Points.Select(p => p.ToString()),
            Is.EqualTo(new[] { "(10, 30, 30)", "(10, 20, 40)", "(10, 10, 30)", "(10, 20, 20)", "(10, 30, 30)" }));
        Assert.That(path.BeadOf(0), Is.EqualTo(Extrusion));
    }

    [Test]
    public void Without_a_bead_a_string_is_that_of_a_common_nozzle()
    {
        var bead = Path(new Canvas<RoundTraceComponent>().Feed("Radius", 10.0)).BeadOf(0);
        // A stadium of 0.45 × 0.2 mm.
        Assert.That((bead.Area, bead.Height, bead.Speed), Is.EqualTo((Bead.FromWidth(0.45, 0.2, shape: BeadShape.Stadium).Area, 0.2, 0.0)));
    }

    [Test]
    public void Spirals_go_out_or_in()
    {
        var outwards = Path(new Canvas<RoundTraceComponent>().Feed("Kind", "Spiral").Feed("Radius", 5.0).Feed("Pitch", 0.5));
        Assert.That(outwards.SegmentCount, Is.EqualTo(720));
        Assert.That((outwards.Start.LengthXY, outwards.End.LengthXY), Is.EqualTo((0.0, 5.0)));
        var inwards = Path(new Canvas<RoundTraceComponent>().Feed("Kind", "Spiral").Feed("Radius", 5.0).Feed("Pitch", 0.5).Feed("Inward", true));
        Assert.That(inwards.Start.DistanceTo(outwards.End), Is.LessThan(1e-12));
    }

    [Test]
    public void A_helix_climbs_and_its_flow_ramps()
    {
        var plain = Path(new Canvas<RisingTraceComponent>().Feed("Radius", 10.0).Feed("Height", 4.0).Feed("Pitch", 0.4).Feed("Bead", Extrusion)
            .Feed("Segments Per Turn", 36));
        Assert.That(plain.SegmentCount, Is.EqualTo(360));
        Assert.That(plain.End.Z, Is.EqualTo(4).Within(1e-12));
        Assert.That(plain.IsUniform, Is.True);
        var ramp = Path(new Canvas<RisingTraceComponent>().Feed("Radius", 10.0).Feed("Height", 4.0).Feed("Pitch", 0.4).Feed("Bead", Extrusion)
            .Feed("Segments Per Turn", 36).Feed("Ramp", "Start").Feed("Minimum Flow", 0.5));
        // The middle of the first string is 1/72 of a turn on.
        Assert.That(ramp.BeadOf(0).Area / 0.196, Is.EqualTo(0.5 + 0.5 / 72).Within(1e-12));
        Assert.That(ramp.BeadOf(359).Area, Is.EqualTo(0.196));
        var both = Path(new Canvas<RisingTraceComponent>().Feed("Radius", 10.0).Feed("Height", 4.0).Feed("Pitch", 0.4).Feed("Ramp", 3));
        Assert.That(both.BeadOf(both.SegmentCount - 1).Area, Is.LessThan(0.25 * 0.0814));
    }

    [Test]
    public void Cylinders_and_cones_have_their_size()
    {
        var cylinder = Path(new Canvas<RisingTraceComponent>().Feed("Kind", "Cylinder").Feed("Radius", 5.0).Feed("Height", 1.0).Feed("Pitch", 0.25)
            .Feed("Horizontal Pitch", 0.5));
        Assert.That(cylinder.SegmentCount, Is.EqualTo(4 * 720 + 3));
        Assert.That(cylinder.Bounds.Max.Z, Is.EqualTo(0.75));
        var cone = Path(new Canvas<RisingTraceComponent>().Feed("Kind", "Cone").Feed("Bottom Radius", 10.0)
            .Feed("Top Radius", 0.0).Feed("Height", 5.0).Feed("Pitch", 0.5));
        Assert.That((cone.Start.LengthXY, cone.End.LengthXY), Is.EqualTo((10.0, 0.0)));
    }

    [Test]
    public void Bad_shapes_are_named_and_the_rest_continues()
    {
        var canvas = new Canvas<RisingTraceComponent>().Feed("Radius", 10.0, null, -1.0, 5.0).Feed("Height", 1.0).Feed("Pitch", 0.4).Solve();
        Assert.That(canvas.All("Print Path").Select(p => p is null), Is.EqualTo(new[] { false, true, true, false }));
        Assert.That(canvas.Warnings.Single(), Does.Contain("Radius is missing"));
        Assert.That(canvas.Errors.Single(), Does.StartWith("{0}[2]").And.Contain("Radius must be greater than zero"));
        Assert.That(Error(new Canvas<RisingTraceComponent>().Feed("Radius", 10.0).Feed("Height", 1.0).Feed("Pitch", 1e-12)), Does.Contain("100 million"));
        Assert.That(Error(new Canvas<RoundTraceComponent>().Feed("Radius", 10.0).Feed("Segments Per Turn", 2)), Does.Contain("three strings"));
        Assert.That(Error(new Canvas<RisingTraceComponent>().Feed("Kind", "Cone")
            .Feed("Bottom Radius", -1.0).Feed("Top Radius", 1.0).Feed("Height", 1.0).Feed("Pitch", 0.4)),
            Does.Contain("0 or more"));
        Assert.That(Error(new Canvas<RisingTraceComponent>().Feed("Radius", 1.0).Feed("Height", 1.0).Feed("Pitch", 0.4).Feed("Ramp", 1)
            .Feed("Minimum Flow", 2.0)),
            Does.Contain("between 0 and 1"));
        Assert.That(Error(new Canvas<RoundTraceComponent>().Feed("Kind", "Spiral")
            .Feed("Radius", double.PositiveInfinity).Feed("Pitch", 0.5)), Does.Contain("finite"));
        Assert.That(new Canvas<RoundTraceComponent>().Feed("Radius", 10.0).Feed("Bead", "wide").Solve().Errors,
            Has.Member("Bead: This is not a bead. Use a width in mm, or width x height: 0.5 x 0.2."));
        Assert.That(new Canvas<RisingTraceComponent>().Feed("Kind", "Cylinder").Solve().All("Print Path"), Is.Empty.Or.EqualTo(new object?[] { null }));
        Assert.That(new Canvas<RoundTraceComponent>().FeedTree("Radius", [1.0], [2.0, 3.0]).Solve().Paths("Print Path"), Is.EqualTo(new[] { "{0}", "{1}" }));
    }

    private static PrintPath Path<T>(Canvas<T> canvas)
        where T : GH_Component, new()
    {
        Assert.That(canvas.Solve().Errors, Is.Empty);
        return canvas.One<PrintPath>("Print Path");
    }

    private static string Error<T>(Canvas<T> canvas)
        where T : GH_Component, new()
        => canvas.Solve().Errors.Single();
}
