using System;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Slice;
using Caterpillar.GH.Conversion;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using NUnit.Framework;
using Rhino;

namespace Caterpillar.GH.Tests.Components;

[Category("Host")]
public sealed class SlicerTests
{
    private static readonly PrintSettings Quick = new() { LayerHeight = 0.5, FirstLayerHeight = 0.5, LineWidth = 0.6, WallCount = 1 };

    private static Canvas<PlanarSlicerComponent> Slice(params object?[] geometry)
        => new Canvas<PlanarSlicerComponent>().Feed("Setup", Quick).Feed("Geometry", geometry).Solve();

    [TearDown]
    public void TearDown() => GH_Document.EscapeKey = () => false;

    [Test]
    public void A_box_gives_a_branch_per_layer()
    {
        var canvas = Slice(Shapes.Box());
        Assert.That(canvas.Errors.Concat(canvas.Warnings).Concat(canvas.Notes), Is.Empty);
        Assert.That(canvas.Paths("Print Paths"), Is.EqualTo(new[] { "{0;0;0}", "{0;0;1}", "{0;0;2}", "{0;0;3}" }));
        Assert.That(canvas.All("Walls"), Has.Count.EqualTo(4));
        Assert.That(canvas.All("Print Paths"), Has.Count.EqualTo(canvas.All("Walls").Count + canvas.All("Infill").Count));
        var region = (Rg.Curve)canvas.All("Regions")[0]!;
        Assert.That(region.GetLength(), Is.EqualTo(40).Within(1e-4));
        Assert.That(canvas.Component.Message, Is.EqualTo("4 layers"));
        Assert.That(canvas.Output("Print Paths").VolatileData.get_Branch(0)[0]!.ToString(),
            Does.StartWith("Print Path (OuterWall, ").And.EndsWith(", closed)"));
    }

    [Test]
    public void Inside_a_modifier_its_settings_apply()
    {
        var settings = Quick with { TopLayers = 0, BottomLayers = 0, InfillDensityPercent = 10, InfillSpacing = 0 };
        var canvas = new Canvas<PlanarSlicerComponent>().Feed("Setup", settings).Feed("Geometry", Shapes.Box(size: 20));
        double Infill() => canvas.Solve().All("Infill").Cast<PrintPath>().Where(p => p.Role == Role.Infill).Sum(p => p.Length);
        var before = Infill();
        canvas.Feed("Modifiers", Shapes.Box(100, 100, 10, 2));
        Assert.That(Infill(), Is.Zero);
        Assert.That(canvas.Warnings, Has.One.Contains("Modifier Settings are missing."));
        canvas.Feed("Modifier Settings", settings with { InfillDensityPercent = 40 });
        Assert.That(Infill(), Is.EqualTo(before * (0.75 + 0.25 * 4)).Within(0.15 * before), "A quarter is filled four times as densely.");
        Assert.That(canvas.Errors.Concat(canvas.Warnings), Is.Empty);
        canvas.Input("Modifiers").RemoveAllSources();
        canvas.Component.ExpireSolution(false);
        Assert.That(Infill(), Is.EqualTo(before).Within(1e-9));
        Assert.That(canvas.Warnings, Has.One.Contains("have no effect without Modifiers"));
    }

    [Test]
    public void Each_solid_has_its_part_settings()
    {
        var settings = Quick with { TopLayers = 0, BottomLayers = 0, TopThickness = 0, BottomThickness = 0, InfillDensityPercent = 0, InfillSpacing = 0 };
        var canvas = new Canvas<PlanarSlicerComponent>().Feed("Setup", settings)
            .Feed("Geometry", Shapes.Box(0, 0, 10, 2), null, Shapes.Box(20, 0, 10, 2), Shapes.Box(40, 0, 10, 2));
        int[] Walls()
        {
            var walls = canvas.Solve().All("Walls").Cast<PrintPath>().Select(p => p.Points[0].X).ToArray();
            // Of four layers.
            return new[] { 0, 20, 40 }.Select(left => walls.Count(x => x > left && x < left + 10) / 4).ToArray();
        }
        Assert.That(Walls(), Is.EqualTo(new[] { 1, 1, 1 }));
        canvas.Feed("Part Settings", settings with { WallCount = 2 });
        Assert.That(Walls(), Is.EqualTo(new[] { 2, 2, 2 }), "the last ones are those of all that follow");
        canvas.Feed("Part Settings", settings with { WallCount = 3 }, settings with { WallCount = 2 });
        Assert.That(Walls(), Is.EqualTo(new[] { 3, 2, 2 }), "the second ones, too");
        canvas.Feed("Part Settings", settings, settings with { WallCount = 4 }, settings with { WallCount = 3 }, settings with { WallCount = 2 });
        Assert.That(Walls(), Is.EqualTo(new[] { 1, 3, 2 }), "beside the solids, one of which is null");
        Assert.That(canvas.Warnings, Has.None.Contains("Part Settings"));
        canvas.Feed("Part Settings", settings, settings, settings, settings, settings);
        Assert.That(Walls(), Is.EqualTo(new[] { 1, 1, 1 }));
        Assert.That(canvas.Warnings, Has.One.Contains("5 Part Settings for 4 solids"));
        canvas.Feed("Part Settings", settings, settings, settings with { ModelType = ModelType.Modifier }).Solve();
        Assert.That(canvas.Errors, Has.One.Contains("Part Settings of Solid 1 have a model_type that is not printed"));
    }

    [Test]
    public void Part_settings_without_sizes_follow_the_nozzle()
    {
        var setup = new PrintSetup(new Printer { NozzleDiameter = 0.8 }, new Material(), new PrintSettings());
        var canvas = new Canvas<PlanarSlicerComponent>().Feed("Setup", setup).Feed("Geometry", Shapes.Box(0, 0, 20, 4))
            .Feed("Part Settings", new PrintSettings { WallCount = 1 }).Solve();
        Assert.That(canvas.All("Walls").Cast<PrintPath>().Select(p => p.BeadOf(0).Width(setup.Settings.BeadShape)),
            Is.All.EqualTo(setup.Settings.LineWidth).Within(1e-6).And.All.GreaterThan(0.8));
    }

    [Test]
    public void Infill_follows_curves_in_document_units()
    {
        using var _ = new InDocument(UnitSystem.Centimeters);
        var settings = Quick with { TopLayers = 0, BottomLayers = 0, InfillDensityPercent = 20 };
        var circle = new Rg.ArcCurve(new Rg.Circle(new Rg.Point3d(11, 11, 7), 0.5));
        var canvas = new Canvas<PlanarSlicerComponent>().Feed("Setup", settings).Feed("Geometry", Shapes.Box(10, 10, 2, 0.2)).Feed("Infill Curves", circle)
            .Solve();
        Assert.That(canvas.Errors.Concat(canvas.Warnings), Is.Empty);
        var infill = canvas.All("Infill").Cast<PrintPath>().Where(p => p.Role == Role.Infill).ToArray();
        Assert.That(infill, Has.Length.EqualTo(4));
        Assert.That(infill.SelectMany(p => p.Points).Select(p => p.WithZ(0).DistanceTo(new Vec3(110, 110))), Has.All.EqualTo(5).Within(0.06));
    }

    [Test]
    public void What_the_slicer_knows_of_its_paths_reaches_planning()
    {
        var slicer = new Canvas<PlanarSlicerComponent>().Feed("Setup", Quick with { WallCount = 3 }).Feed("Geometry", Shapes.Box()).Solve();
        var plan = new Canvas<PlanToolpathComponent>(slicer.Document).Feed("Setup", Quick with { WallCount = 3 });
        plan.Input("Steps").AddSource(slicer.Output("Print Paths"));
        plan.Solve();
        Assert.That(plan.Errors, Is.Empty);
        var solid = new NamedMesh("Solid 0", RhinoMesh.ToTriangles(Shapes.Box(), DocumentUnits.Current));
        var slices = PlanarSlicer.Slice([solid], Quick with { WallCount = 3 }, new SliceOptions { Threads = 1 }).Value!;
        var steps = slices.Layers.SelectMany(l => l.Steps).ToArray();
        Assert.That(steps.Count(s => s.Joined), Is.GreaterThan(0));
        var expected = Planner.Plan(steps, ((ToolpathGoo)plan.Output("Toolpath").VolatileData.get_Branch(0)[0]!).Setup!).Value!;
        var planned = plan.One<Toolpath>("Toolpath");
        Assert.That(Enumerable.Range(0, planned.Count).Select(i => planned[i].End),
            Is.EqualTo(Enumerable.Range(0, expected.Count).Select(i => expected[i].End)));
    }

    [Test]
    public void A_solid_gives_the_same_as_its_mesh()
    {
        var (mesh, solid) = (Slice(Shapes.Box()), Slice(Shapes.Solid()));
        Assert.That(solid.Errors, Is.Empty);
        Assert.That(solid.All("Print Paths").Cast<PrintPath>().Select(p => p.Length),
            Is.EqualTo(mesh.All("Print Paths").Cast<PrintPath>().Select(p => p.Length)));
    }

    [Test]
    public void A_box_in_any_pose_gives_the_same_as_its_mesh()
    {
        double[] Lengths(object? model)
        {
            var canvas = Slice(model);
            Assert.That(canvas.Errors.Concat(canvas.Warnings), Is.Empty, model!.ToString());
            return canvas.All("Print Paths").Cast<PrintPath>().Select(p => Math.Round(p.Length, 6)).ToArray();
        }
        var expected = Lengths(Shapes.Box());
        Assert.That(Lengths(new Rg.Box(new Rg.BoundingBox(100, 100, 0, 110, 110, 2))), Is.EqualTo(expected));
        var upsideDown = new Rg.Plane(new Rg.Point3d(110, 100, 2), -Rg.Vector3d.XAxis, Rg.Vector3d.YAxis);
        Assert.That(Lengths(new Rg.Box(upsideDown, new Rg.Interval(10, 0), new Rg.Interval(0, 10), new Rg.Interval(0, 2))).Sum(),
            Is.EqualTo(expected.Sum()).Within(1e-3));
    }

    [Test]
    public void A_mesh_with_a_face_of_no_area_is_sliced_and_one_with_a_wrong_corner_is_named()
    {
        var flat = Shapes.Box();
        flat.Faces.AddFace(0, 0, 1);
        Assert.That(Slice(flat).Errors, Is.Empty);
        Assert.That(Slice(flat).All("Walls"), Has.Count.EqualTo(4));
        var wrong = Shapes.Box();
        wrong.Faces.AddFace(new Rg.MeshFace(0, 1, 2000));
        Assert.That(Slice(wrong).Errors, Has.One.Contains("refers to a vertex that does not exist"));
    }

    [TestCase(-1, 1, 2, 3)]
    [TestCase(0, -1, 2, 3)]
    [TestCase(0, 1, -1, 3)]
    [TestCase(0, 1, 2, -1)]
    [TestCase(4, 1, 2, 3)]
    [TestCase(0, 1, 2, 4)]
    public void Each_corner_of_a_face_must_be_a_vertex(int a, int b, int c, int d)
    {
        var mesh = new Rg.Mesh();
        foreach (var (x, y) in new[] { (0, 0), (4, 0), (4, 3), (0, 3) }) mesh.Vertices.Add(x, y, 0);
        mesh.Faces.AddFace(new Rg.MeshFace(0, 1, 2, 3));
        Assert.That(() => RhinoMesh.ToTriangles(mesh, DocumentUnits.Current), Throws.Nothing);
        mesh.Faces.AddFace(new Rg.MeshFace(a, b, c, d));
        Assert.That(() => RhinoMesh.ToTriangles(mesh, DocumentUnits.Current), Throws.InstanceOf<InputProblem>().With.Message.StartsWith("Face 1 of a mesh"));
    }

    [Test]
    public void A_change_below_single_precision_is_sliced_again()
    {
        // Rhino's own checksum of a mesh is taken from single-precision points.
        var canvas = new Canvas<PlanarSlicerComponent>().Feed("Setup", Quick).Feed("Geometry", Shapes.Box(5000, 100)).Solve();
        var before = canvas.All("Walls").Cast<PrintPath>().First();
        canvas.Feed("Geometry", Shapes.Box(5000.0001, 100)).Solve();
        Assert.That(Shapes.Box(5000.0001, 100).DataCRC(0), Is.EqualTo(Shapes.Box(5000, 100).DataCRC(0)));
        Assert.That(canvas.All("Walls")[0], Is.Not.SameAs(before));
    }

    [Test]
    public void Solids_of_a_list_are_one_print_and_branches_are_several()
    {
        var list = Slice(Shapes.Box(), Shapes.Box(130));
        Assert.That(list.All("Walls").Cast<PrintPath>().Count(p => p.Role == Role.OuterWall), Is.EqualTo(8));
        var tree = new Canvas<PlanarSlicerComponent>().Feed("Setup", Quick).FeedTree("Geometry", [Shapes.Box()], [Shapes.Box(130, height: 1)]).Solve();
        Assert.That(tree.Paths("Walls"), Is.EqualTo(new[] { "{0;0;0}", "{0;0;1}", "{0;0;2}", "{0;0;3}", "{1;0;0}", "{1;0;1}" }));
    }

    [Test]
    public void Null_and_flat_geometry_stop_only_their_branch()
    {
        var canvas = new Canvas<PlanarSlicerComponent>().Feed("Setup", Quick)
            .FeedTree("Geometry", [Shapes.Box(), null], [new Rg.LineCurve(new Rg.Point3d(0, 0, 0), new Rg.Point3d(1, 0, 0))], [null], [Shapes.Box()]).Solve();
        Assert.That(canvas.All("Walls"), Has.Count.EqualTo(8));
        Assert.That(canvas.Warnings, Has.Member("{0}[0]: Geometry: 1 null item is ignored.").And.Count.EqualTo(1));
        Assert.That(canvas.Errors, Has.One.Contains("A LineCurve cannot be sliced").And.One.Contains("Geometry: the connected source gives no valid data"));
    }

    [Test]
    public void A_gap_in_the_surface_is_a_warning_that_shows_its_edges()
    {
        var canvas = Slice(Shapes.OpenBox());
        Assert.That(canvas.Warnings, Is.Not.Empty);
        Assert.That(canvas.All("Naked Edges").Cast<Rg.Curve>().Sum(e => e.GetLength()), Is.GreaterThanOrEqualTo(40));
        Assert.That(canvas.All("Diagnostics"), Has.Some.Contains("naked edges"));
    }

    [Test]
    public void Geometry_in_other_units_is_scaled_to_mm_and_back()
    {
        using var _ = new InDocument(UnitSystem.Centimeters);
        var canvas = Slice(Shapes.Box(10, 10, 1, 0.2));
        Assert.That(canvas.All("Walls"), Has.Count.EqualTo(4));
        Assert.That(((PrintPath)canvas.All("Walls")[0]!).Bounds.Max.X, Is.InRange(109, 110));
        Assert.That(((Rg.Curve)canvas.All("Regions")[0]!).GetLength(), Is.EqualTo(4).Within(1e-4));
        Assert.That(canvas.Notes, Has.Count.EqualTo(1));
    }

    [Test]
    public void A_tolerance_of_zero_is_refused()
        => Assert.That(Slice(Shapes.Box()).Feed("Tolerance", 0).Solve().Errors, Has.One.Contains("Tolerance must be greater than zero, not 0."));

    [Test]
    public void Nothing_to_print_is_an_error()
        => Assert.That(Slice(Shapes.Box(size: 0.1)).Errors, Has.Some.Contains("slice.empty"));

    [Test]
    public void The_last_result_is_kept_until_something_changes()
    {
        var canvas = Slice(Shapes.Box());
        var first = canvas.All("Walls")[0];
        canvas.Component.ExpireSolution(false);
        canvas.Solve();
        Assert.That(canvas.All("Walls")[0], Is.SameAs(first));
        canvas.Feed("Setup", Quick with { LineWidth = 0.7 }).Solve();
        Assert.That(canvas.All("Walls")[0], Is.Not.SameAs(first));
        canvas.Feed("Setup", Quick).Solve();
        Assert.That(canvas.All("Walls")[0], Is.Not.SameAs(first), "Only the last solve is kept.");
    }

    [Test]
    public void Escape_stops_the_solution()
    {
        GH_Document.EscapeKey = () => true;
        var canvas = new Canvas<PlanarSlicerComponent>().Feed("Setup", Quick with { LayerHeight = 0.02, FirstLayerHeight = 0.02, InfillDensityPercent = 90 })
            .Feed("Geometry", Shapes.Box(10, 10, 190, 200)).Solve();
        Assert.That(canvas.Warnings, Is.EqualTo(new[] { "Canceled. Recompute to start again." }));
        Assert.That(canvas.Document.AbortRequested, Is.True);
        Assert.That(canvas.All("Walls"), Is.Empty);
    }
}
