using System;
using System.Linq;
using Caterpillar.GH.Components.Slice;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;
using Rhino;

namespace Caterpillar.GH.Tests.Recorded;

/// <summary>Models that only Rhino itself can mesh; the stand-ins know their flat kinds.</summary>
public sealed class ModelTests
{
    private static readonly PrintSettings Quick = new() { LayerHeight = 0.5, FirstLayerHeight = 0.5, LineWidth = 0.6, WallCount = 1 };

    private static Canvas<PlanarSlicerComponent> Slice(params object?[] geometry)
        => new Canvas<PlanarSlicerComponent>().Feed("Setup", Quick).Feed("Geometry", geometry).Solve();

    [Test]
    public void Extrusions_and_subds_give_the_same_as_a_mesh()
    {
        double[] Lengths(object model)
        {
            var canvas = Slice(model);
            Assert.That(canvas.Errors.Concat(canvas.Warnings), Is.Empty, model.ToString());
            return canvas.All("Print Paths").Cast<PrintPath>().Select(p => Math.Round(p.Length, 6)).ToArray();
        }
        var expected = Lengths(Shapes.Box());
        Assert.That(Lengths(Rg.Extrusion.CreateBoxExtrusion(new Rg.Box(new Rg.BoundingBox(100, 100, 0, 110, 110, 2)))), Is.EqualTo(expected));
        Assert.That(Lengths(Rg.SubD.CreateFromMesh(Shapes.Box())), Is.EqualTo(expected));
    }

    [Test]
    public void A_surface_is_sliced_with_a_warning_about_its_edges()
    {
        var wall = new Rg.PlaneSurface(new Rg.Plane(new Rg.Point3d(100, 100, 0), Rg.Vector3d.XAxis, Rg.Vector3d.ZAxis), new Rg.Interval(0, 10),
            new Rg.Interval(0, 2));
        Assert.That(Slice(wall).Warnings, Has.Some.Contains("naked edges"));
        Assert.That(Slice(wall).All("Naked Edges"), Is.Not.Empty);
    }

    [TestCase(UnitSystem.Unset, 1.0)]
    [TestCase(UnitSystem.None, 1.0)]
    [TestCase(UnitSystem.CustomUnits, 25.0)]
    [TestCase(UnitSystem.Miles, 1609344.0)]
    public void Units_that_are_not_set_are_mm_and_custom_ones_are_scaled(UnitSystem units, double scale)
    {
        using var document = new InDocument(units);
        document.Document.CustomUnit = 0.025;
        Assert.That(Caterpillar.GH.Conversion.DocumentUnits.Current.ToMillimeters, Is.EqualTo(scale).Within(1e-9));
    }
}
