using System;
using System.Linq;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Tests.Geometry.Meshes;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

[TestFixture]
public class ModelPlacementTests
{
    private static readonly NamedMesh Block = new("block", MeshMaker.Box(10, 20, 5, 14, 28, 8));

    [Test]
    public void Scaling_keeps_the_middle_of_the_foot()
    {
        Assert.That(Box(new[] { Block }.Scaled(new Vec3(2, 1, 3))), Is.EqualTo(new Bounds(new Vec3(8, 20, 5), new Vec3(16, 28, 14))));
        Assert.That(Box(new[] { Block }.ScaledTo(16)).Size, Is.EqualTo(new Vec3(8, 16, 6)));
        Assert.That(Box(new[] { Block }.ScaledTo(new Vec3(1, 2, 12))).Size, Is.EqualTo(new Vec3(1, 2, 12)));
        var plate = new NamedMesh("plate", MeshMaker.Box(0, 0, 0, 4, 8, 0.5));
        Assert.That(Box(new[] { plate }.ScaledTo(new Vec3(4, 8, 1))).Size, Is.EqualTo(new Vec3(4, 8, 1)), "thinner than 1 mm");
        Assert.That(Block.Mesh.Bounds.Size, Is.EqualTo(new Vec3(4, 8, 3)), "the input is as it was");
        Assert.That(() => new[] { Block }.Scaled(new Vec3(1, 0, 1)), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => new[] { Block }.ScaledTo(double.NaN), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [Test]
    public void Turning_goes_about_x_then_y_then_z()
    {
        var turned = Box(new[] { Block }.Rotated(new Vec3(90, 0, 90)));
        // About X: 4 × 3 × 8; then about Z: 3 × 4 × 8.
        Assert.That((turned.Size - new Vec3(3, 4, 8)).Length, Is.LessThan(1e-9));
        Assert.That(new[] { Block }.Rotated(new Vec3(0, 0, 360))[0].Mesh.Vertices, Is.EqualTo(Block.Mesh.Vertices));
    }

    [Test]
    public void On_the_bed_models_keep_their_places_to_each_other()
    {
        var second = new NamedMesh("second", MeshMaker.Box(20, 20, 6, 30, 30, 7));
        var placed = new[] { Block, second }.OnBed(new Vec3(100, 50));
        Assert.That(Box(placed), Is.EqualTo(new Bounds(new Vec3(90, 45, 0), new Vec3(110, 55, 3))));
        Assert.That(placed[1].Mesh.Bounds.Min - placed[0].Mesh.Bounds.Min, Is.EqualTo(new Vec3(10, 0, 1)));
    }

    [Test]
    public void Copies_have_names_of_their_own()
        => Assert.That(new[] { Block }.Copies(3).Select(m => m.Name), Is.EqualTo(new[] { "block", "block (2)", "block (3)" }));

    [Test]
    public void The_largest_face_is_laid_on_the_bed([Range(0, 11)] int turn)
    {
        var leaning = new[] { Block }.Rotated(new Vec3(17 + 31 * turn, 23 * turn, 40));
        var flat = leaning.LaidFlat()[0].Mesh;
        // Largest face of 4 × 8 × 3: 32 mm².
        Assert.That(flat.Bounds.Min.Z, Is.Zero);
        Assert.That(FootArea(flat), Is.EqualTo(32).Within(1e-6));
        Assert.That(flat.Bounds.Size.Z, Is.EqualTo(3).Within(1e-9));
    }

    [Test]
    public void A_model_that_lies_flat_already_is_not_turned()
    {
        var block = new NamedMesh("block", MeshMaker.Box(0, 0, 0, 8, 8, 2));
        Assert.That(new[] { block }.LaidFlat()[0].Mesh.Vertices, Is.EqualTo(block.Mesh.Vertices));
        var cube = new NamedMesh("cube", MeshMaker.Box(0, 0, 0, 5, 5, 5));
        Assert.That(new[] { cube }.LaidFlat()[0].Mesh.Vertices, Is.EqualTo(cube.Mesh.Vertices), "of equal faces the one below");
    }

    [TestCase("fandisk.stl", 300)]
    [TestCase("plate_holes.stl", 3000)]
    [TestCase("homer.stl", 1)]
    [TestCase("spot.obj", 1)]
    public void Real_models_lie_on_a_face_of_their_hull(string file, double least)
    {
        var mesh = TestData.Mesh(TestData.Shared("meshes/" + file)).Rotated(new Vec3(1, 2, 3), 77);
        var first = new[] { new NamedMesh("a", mesh) }.LaidFlat()[0].Mesh;
        var again = new[] { new NamedMesh("a", mesh) }.LaidFlat()[0].Mesh;
        Assert.That(again.Vertices, Is.EqualTo(first.Vertices), "the same every time");
        // The outline of what touches the bed.
        var foot = first.Vertices.Where(v => v.Z < 1e-3 * first.Bounds.Size.Length).Select(v => v.WithZ(0)).ToArray();
        Assert.That(HullArea(foot), Is.GreaterThan(least));
        Assert.That(first.Volume, Is.EqualTo(mesh.Volume).Within(1e-6).Percent);
    }

    [Test]
    public void Flat_models_have_no_hull_and_stay()
    {
        var sheet = new NamedMesh("sheet", TriMesh.Create([new(0, 0, 0), new(5, 0, 0), new(0, 5, 0)], [0, 1, 2]));
        Assert.That(new[] { sheet }.LaidFlat()[0].Mesh.Vertices, Is.EqualTo(sheet.Mesh.Vertices));
    }

    [Test]
    public void A_tiny_or_huge_model_says_what_it_would_be_in_other_units()
    {
        string? Tell(double side)
            => Solids.Try(new PrintSettings(), MeshMaker.Box(0, 0, 0, side, side / 2, side / 4)).Diagnostics
                .SingleOrDefault(d => d.Code == "models.unit")?.Message;
        Assert.That(Tell(0.16), Is.EqualTo("Model is 0.16 × 0.08 × 0.04 mm. In meters it would be 160 × 80 × 40 mm, in inches 4.06 × 2.03 × 1.02 mm, "
            + "in centimeters 1.6 × 0.8 × 0.4 mm. Set the unit where the file is read (--unit, or Unit of Read Model), or scale the model."));
        Assert.That(Tell(2.9), Is.Not.Null);
        Assert.That(Tell(3), Is.Null);
        var huge = new[] { new NamedMesh("scan", MeshMaker.Box(0, 0, 0, 160_000, 80_000, 40_000)) }.OnBed(new Printer());
        Assert.That(ModelCheck.Fit(huge, new Printer()).Select(d => d.Code), Is.EqualTo(new[] { "models.too_large", "models.unit" }));
        Assert.That(ModelCheck.Fit(huge, new Printer())[1].Message,
            Does.StartWith("Model is 160000 × 80000 × 40000 mm. In micrometers it would be 160 × 80 × 40 mm."));
    }

    [Test]
    public void What_does_not_fit_says_by_how_much_and_which_scale_does()
    {
        var printer = new Printer { Title = "Small", BuildVolume = new Vec3(100, 80, 50) };
        var large = new[] { new NamedMesh("large", MeshMaker.Box(0, 0, 0, 125, 60, 60)) }.OnBed(printer);
        Assert.That(ModelCheck.Fit(large, printer).Single().ToString(), Is.EqualTo(
            "warning models.too_large: Model is 125 × 60 × 60 mm: 25 mm too long in X, 10 mm too long in Z for Small (100 × 80 × 50 mm). "
            + "Scale it to 80 % to fit."));
        Assert.That(ModelCheck.Fit(large.Scaled(new Vec3(0.8, 0.8, 0.8)), printer), Is.Empty);
        var round = printer with { BedShape = BedShape.Round, BuildVolume = new Vec3(100, 100, 100) };
        var square = new[] { new NamedMesh("square", MeshMaker.Box(0, 0, 0, 80, 80, 10)) }.OnBed(round);
        Assert.That(ModelCheck.Fit(square, round).Single().Message, Does.EndWith(
            "mm: too large for Small (100 × 100 × 100 mm, round bed). Scale it to 88.38 % to fit."), "100 / (80 √2) = 0.88388");
        var aside = new[] { new NamedMesh("aside", MeshMaker.Box(-3, 0, 0, 10, 10, 10)) };
        Assert.That(ModelCheck.Fit(aside, printer).Single().Message, Is.EqualTo("Model is 3 mm too far left for the build volume of Small. Move it to fit."));
    }

    [Test]
    public void Models_larger_than_the_build_volume_are_hopeless_unless_that_check_is_changed()
    {
        NamedMesh[] Box(double size) => [new("box", MeshMaker.Box(0, 0, 0, size, 60, 60))];
        var setup = new PrintSetup { Printer = new Printer { BuildVolume = new Vec3(100, 80, 70) } };
        Assert.That(ModelCheck.IsTooLarge(Box(100.5), setup), Is.False, "extrusions keep half a width from the outline");
        Assert.That(ModelCheck.IsTooLarge(Box(103), setup));
        Assert.That(ModelCheck.IsTooLarge([], setup), Is.False);
        Assert.That(ModelCheck.IsTooLarge(Box(103), setup.With("check_severities=bed.outside=warning").Value!), Is.False);
        Assert.That(ModelCheck.IsTooLarge(Box(103), setup.With("check_severities=bed.outside=off").Value!), Is.False);
        Assert.That(ModelCheck.IsTooLarge(Box(103), setup.With("check_severities=bed.outside=error").Value!));
        Assert.That(ModelCheck.IsTooLarge(Box(103), setup.With("check_severities=extrusion.gap=off").Value!), "other checks decide nothing here");
    }

    [Test]
    public void The_head_must_pass_beside_what_stands_already()
    {
        // Outline 0.5 mm at the tip, 4 mm at 6 mm, 20 mm at 12 mm.
        var printer = new Printer();
        NamedMesh[] Two(double distance, double low) =>
        [
            new("low", MeshMaker.Box(50, 50, 0, 60, 60, low)), new("high", MeshMaker.Box(60 + distance, 50, 0, 70 + distance, 60, 40)),
        ];
        Assert.That(ModelCheck.Clearance(Two(4.1, 6), printer), Is.Empty);
        Assert.That(ModelCheck.Clearance(Two(3.9, 6), printer).Single().ToString(), Is.EqualTo(
            "high: error models.no_clearance: Model is 3.9 mm from low, which is printed first. The print head needs 4 mm next to a part 6 mm high. "
            + "Move them apart."));
        Assert.That(ModelCheck.Clearance(Two(11.9, 9), printer), Has.Count.EqualTo(1), "12 mm at a height of 9 mm");
        Assert.That(ModelCheck.Clearance(Two(12.1, 9), printer), Is.Empty);
        Assert.That(ModelCheck.Clearance(Two(19.9, 30), printer), Has.Count.EqualTo(1));
        var gantry = printer with { HeadBoxes = new ValueList<Bounds>(new Bounds(new Vec3(-30, -40, 20), new Vec3(30, 40, 60))) };
        Assert.That(ModelCheck.Clearance(Two(49, 30), gantry), Has.Count.EqualTo(1));
        Assert.That(ModelCheck.Clearance(Two(49, 12), gantry), Is.Empty);
    }

    private static Bounds Box(System.Collections.Generic.IReadOnlyList<NamedMesh> models) => ModelPlacement.BoxOf(models);

    private static double FootArea(TriMesh mesh)
        => Enumerable.Range(0, mesh.TriangleCount).Where(t => mesh.Normal(t).Z < -0.999999 && mesh.Vertices[mesh.Triangle(t).A].Z < 1e-6)
            .Sum(t => Vec3.Cross(mesh.Vertices[mesh.Triangle(t).B] - mesh.Vertices[mesh.Triangle(t).A],
                mesh.Vertices[mesh.Triangle(t).C] - mesh.Vertices[mesh.Triangle(t).A]).Length / 2);

    private static double HullArea(Vec3[] points)
    {
        var hull = new NetTopologySuite.Geometries.GeometryFactory().CreateMultiPointFromCoords(
            points.Select(p => new NetTopologySuite.Geometries.Coordinate(p.X, p.Y)).ToArray()).ConvexHull();
        return hull.Area;
    }

    [Test]
    public void A_placed_model_knows_the_transform_from_its_file()
    {
        var read = new NamedMesh("part", MeshMaker.Box(0, 0, 3, 10, 20, 8));
        var models = new[] { read }.Scaled(new Vec3(2, 1, 3)).Rotated(new Vec3(30, 0, 70)).LaidFlat().Copies(2);
        models = ModelArranger.Arrange(models, new Printer()).OrThrow();
        Assert.That(models, Has.Count.EqualTo(2));
        Assert.That(models[0].Placed, Is.Not.EqualTo(models[1].Placed));
        foreach (var model in models)
        {
            for (var i = 0; i < read.Mesh.VertexCount; i++)
                Assert.That(model.Placed.Apply(read.Mesh.Vertices[i]).DistanceTo(model.Mesh.Vertices[i]), Is.LessThan(1e-9));
            var back = model.Transformed(model.Placed.Inverse);
            Assert.That(back.Mesh.Bounds.Min.DistanceTo(read.Mesh.Bounds.Min) + back.Mesh.Bounds.Max.DistanceTo(read.Mesh.Bounds.Max), Is.LessThan(1e-9));
        }
    }
}
