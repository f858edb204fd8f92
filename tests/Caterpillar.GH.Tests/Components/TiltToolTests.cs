using System;
using System.Linq;
using Caterpillar.Curved;
using Caterpillar.Geometry;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Slice;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Components;

[Category("Host")]
public sealed class TiltToolTests
{
    private static readonly PrintSetup FiveAxis = new ProfileLibrary().Setup("five_axis_head").OrThrow();

    // One straight extrusion along x, 20 mm above the bed.
    private static ToolpathGoo Line(PrintSetup setup)
        => new(Planner.Plan([new PrintPath([new Vec3(50, 50, 20), new Vec3(70, 50, 20)], new Bead(0.08, 0.2, 40))], setup).Value!, setup);

    private static Canvas<TiltToolComponent> Tilt(TiltAim aim, params (string Port, object?[] Values)[] ports)
    {
        var canvas = new Canvas<TiltToolComponent>().Feed("Aim", aim.ToString()).Feed("Toolpath", Line(FiveAxis));
        foreach (var (port, values) in ports) canvas.Feed(port, values);
        return canvas.Solve();
    }

    // Directions of the tool at the ends of extrusions.
    private static Vec3[] Directions(Toolpath toolpath) => [.. toolpath.Moves().Where(m => m.Kind == MoveKind.Print).Select(m =>
    {
        var (a, b, c) = toolpath.TurnsOf(m.Index)!.Value;
        return FiveAxis.Printer.Kinematics!.Direction(new Vec3(a, b, c));
    })];

    private static void AssertDirection(Canvas<TiltToolComponent> canvas, Vec3 expected)
    {
        Assert.That(canvas.Errors.Concat(canvas.Warnings), Is.Empty);
        var directions = Directions(canvas.One<Toolpath>("Toolpath"));
        Assert.That(directions, Is.Not.Empty);
        Assert.That(directions.Select(d => d.DistanceTo(expected.Unit())), Is.All.LessThan(1e-9));
    }

    [Test]
    public void Formulas_give_the_direction()
        => AssertDirection(Tilt(TiltAim.Formula, ("Expressions", ["0.3", "0", "1"])), new Vec3(0.3, 0, 1));

    [Test]
    public void The_maximum_tilt_limits_it()
        => AssertDirection(Tilt(TiltAim.Formula, ("Expressions", ["1", "0", "1"]), ("Max Tilt", [30.0])), new Vec3(1, 0, Math.Sqrt(3)));

    // The end of the line is 20 mm below and 10 mm beside the point, or below the middle of a curve there.
    [Test]
    public void It_leans_toward_a_point_or_away_from_a_curve()
    {
        AssertDirection(Tilt(TiltAim.Toward, ("Geometry", [new Rg.Point3d(70, 60, 40)])), new Vec3(0, 10, 20));
        AssertDirection(Tilt(TiltAim.Away, ("Geometry", [new Rg.LineCurve(new Rg.Point3d(0, 60, 0), new Rg.Point3d(100, 60, 0))])), new Vec3(0, -10, 20));
    }

    [Test]
    public void Along_layer_normals_it_needs_the_field_that_was_sliced()
    {
        var slope = new FieldRecipe("Slope", [], LayerField.Formula("z - 0.2 * x").Value!);
        AssertDirection(Tilt(TiltAim.LayerNormals, ("Field", [slope])), new Vec3(-0.2, 0, 1));
        var smooth = new FieldRecipe("Smooth", [], (models, setup, _) => LayerField.Smooth(models, setup));
        Assert.That(Tilt(TiltAim.LayerNormals, ("Field", [smooth])).Errors, Has.One.Contains("Connect the output Field of Curved Slicer"));
    }

    [Test]
    public void What_cannot_be_is_an_error()
    {
        var upright = new Canvas<TiltToolComponent>().Feed("Aim", "Formula").Feed("Expressions", "0", "0", "1")
            .Feed("Toolpath", Line(new PrintSetup())).Solve();
        Assert.That(upright.Errors, Has.One.Contains("has no axis that tilts its tool"));
        Assert.That(Tilt(TiltAim.Formula, ("Expressions", ["0", "1"])).Errors, Has.One.Contains("three expressions"));
        Assert.That(Tilt(TiltAim.Formula, ("Expressions", ["0", "q", "1"])).Errors, Has.One.Contains("q"));
        Assert.That(Tilt(TiltAim.Toward, ("Geometry", [new Rg.Mesh()])).Errors, Has.One.Contains("curves or points"));
        Assert.That(Tilt(TiltAim.Formula, ("Expressions", ["0", "0", "1"]), ("Max Tilt", [200.0])).Errors, Has.One.Contains("1 to 180"));
    }
}
