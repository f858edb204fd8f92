using System;
using System.IO;
using System.IO.Compression;
using System.Linq;
using Caterpillar.GH.Components.Design;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Simulate;
using Caterpillar.GH.Components.Setup;
using Caterpillar.GH.Components.Slice;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Components;

/// <summary>Models on the bed, paths on objects, curves from files.</summary>
[Category("Host")]
public sealed class ModelPlacingTests
{
    private static readonly PrintPath Flat = new([new Vec3(102, 105, 0.2), new Vec3(108, 105, 0.2)], new Bead(0.08, 0.2, 40));

    private static Rg.BoundingBox BoxOf(object? geometry) => ((Rg.GeometryBase)geometry!).GetBoundingBox(true);

    [Test]
    public void Pieces_stand_on_the_bed_next_to_each_other()
    {
        var canvas = new Canvas<ArrangeModelsComponent>().Feed("Geometry", Shapes.Box(0, 0, 20), Shapes.Solid(500, 0, 30)).Feed("Count", 3).Feed("Spacing", 4)
            .Solve();
        Assert.That(canvas.Errors.Concat(canvas.Warnings), Is.Empty);
        var boxes = canvas.All("Geometry").Select(BoxOf).ToArray();
        Assert.That(boxes, Has.Length.EqualTo(6));
        Assert.That(canvas.All("Geometry")[1], Is.InstanceOf<Rg.Brep>(), "A solid stays one.");
        foreach (var box in boxes)
        {
            Assert.That(box.Min.Z, Is.EqualTo(0).Within(1e-6));
            Assert.That(new[] { box.Min.X, box.Min.Y }, Is.All.GreaterThanOrEqualTo(2 - 1e-6));
            Assert.That(new[] { box.Max.X, box.Max.Y }, Is.All.LessThanOrEqualTo(218 + 1e-6));
        }
        for (var i = 0; i < boxes.Length; i++)
        {
            for (var k = 0; k < i; k++)
            {
                var gap = Math.Max(Math.Max(boxes[i].Min.X - boxes[k].Max.X, boxes[k].Min.X - boxes[i].Max.X),
                    Math.Max(boxes[i].Min.Y - boxes[k].Max.Y, boxes[k].Min.Y - boxes[i].Max.Y));
                Assert.That(gap, Is.GreaterThanOrEqualTo(4 - 1e-6), $"{i}, {k}");
            }
        }
    }

    [Test]
    public void The_transforms_move_what_belongs_to_the_solid()
    {
        var canvas = new Canvas<ArrangeModelsComponent>().Feed("Geometry", Shapes.Box(500, 300)).Solve();
        var map = (Rg.Transform)canvas.All("Transforms").Single()!;
        var corner = new Rg.Point3d(500, 300, 0);
        corner.Transform(map);
        var box = BoxOf(canvas.All("Geometry").Single());
        Assert.That((corner - box.Min).Length, Is.LessThan(1e-6));
    }

    [Test]
    public void What_has_no_place_is_named()
    {
        var canvas = new Canvas<ArrangeModelsComponent>().Feed("Geometry", Shapes.Box(size: 300)).Solve();
        Assert.That(canvas.Errors, Has.Some.Contains("models.no_space"));
        Assert.That(canvas.All("Geometry"), Is.Empty);
        Assert.That(new Canvas<ArrangeModelsComponent>().Feed("Geometry", Shapes.Box()).Feed("Count", 0).Solve().Errors, Has.One.Contains("Count must be"));
        Assert.That(new Canvas<ArrangeModelsComponent>().Feed("Geometry", Shapes.Box()).Feed("Spacing", -1).Solve().Errors,
            Has.One.Contains("Spacing must be 0 or more"));
    }

    [Test]
    public void A_leaning_box_is_laid_flat_where_it_is()
    {
        var box = Shapes.Box(0, 0, 10, 2);
        box.Transform(Rg.Transform.Rotation(0.6, new Rg.Vector3d(1, 0.3, 0.1), new Rg.Point3d(40, 20, 7)));
        Assert.That(BoxOf(box).Max.Z - BoxOf(box).Min.Z, Is.GreaterThan(4));
        var canvas = new Canvas<LayFlatComponent>().Feed("Geometry", box).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        var flat = BoxOf(canvas.All("Geometry").Single());
        Assert.That(flat.Min.Z, Is.EqualTo(0).Within(1e-6));
        Assert.That(flat.Max.Z, Is.EqualTo(2).Within(1e-5));
    }

    [Test]
    public void Paths_follow_the_top_of_an_object()
    {
        Canvas<ProjectPathsComponent> Onto(double offset)
            => new Canvas<ProjectPathsComponent>().Feed("Print Paths", Flat).Feed("Geometry", Shapes.Box(90, 90, 40, 3))
            .Feed("Offset", offset).Solve();
        double Z(Canvas<ProjectPathsComponent> canvas) => canvas.All("Print Paths").Cast<PrintPath>().Single().Bounds.Max.Z;
        Assert.That(Onto(0).Errors, Is.Empty);
        Assert.That(Z(Onto(0)), Is.EqualTo(3.2).Within(1e-3));
        Assert.That(Z(Onto(0.3)), Is.EqualTo(3.5).Within(1e-3));
        Assert.That(Z(Onto(-0.05)), Is.EqualTo(3.15).Within(1e-3));
    }

    [Test]
    public void Paths_beside_the_object_are_an_error_or_left_out()
    {
        var canvas = new Canvas<ProjectPathsComponent>().Feed("Print Paths", Flat).Feed("Geometry", Shapes.Box(100, 100, 5, 3)).Solve();
        Assert.That(canvas.Errors, Has.Some.Contains("curved."));
        Assert.That(canvas.All("Print Paths"), Is.Empty);
        canvas.Feed("Partial", true).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(canvas.All("Print Paths").Cast<PrintPath>().Sum(p => p.Length), Is.EqualTo(3).Within(0.1));
    }

    private static SetupGoo On(object? obstacle)
    {
        var setup = new Canvas<PrintSetupComponent>();
        if (obstacle is not null) setup.Feed("Printed On", obstacle);
        return new SetupGoo { Value = setup.Solve().One<PrintSetup>("Setup") };
    }

    [Test]
    public void Travels_stay_above_obstacles()
    {
        var paths = new[] { 30.0, 180 }.Select(x => (object?)new PrintPath([new Vec3(x, 105, 0.2), new Vec3(x + 5, 105, 0.2)], new Bead(0.08, 0.2, 40)))
            .ToArray();
        Toolpath Plan(object? obstacle)
        {
            var canvas = new Canvas<PlanToolpathComponent>().Feed("Steps", paths).Feed("Setup", On(obstacle)).Solve();
            Assert.That(canvas.Errors, Is.Empty);
            return canvas.One<Toolpath>("Toolpath");
        }
        double Highest(Toolpath toolpath)
            => Enumerable.Range(0, toolpath.Count).Select(i => toolpath[i]).Where(m => m.Kind == MoveKind.Travel).Max(m => m.End.Z);
        var block = Shapes.Box(90, 90, 40, 12);
        Assert.That(Highest(Plan(null)), Is.LessThan(5));
        Assert.That(Highest(Plan(block)), Is.GreaterThan(12));
    }

    [Test]
    public void The_checks_know_the_obstacles_of_the_plan()
    {
        var path = new PrintPath([new Vec3(100, 110, 12.2), new Vec3(120, 110, 12.2)], new Bead(0.08, 0.2, 40));
        bool IsInTheAir(object? obstacle)
        {
            var plan = new Canvas<PlanToolpathComponent>().Feed("Steps", path).Feed("Setup", On(obstacle)).Solve();
            var check = new Canvas<CheckComponent>().Feed("Toolpath", plan.Output("Toolpath").VolatileData.get_Branch(0)[0]).Solve();
            var write = new Canvas<GenerateGCodeComponent>().Feed("Toolpath", plan.Output("Toolpath").VolatileData.get_Branch(0)[0]).Solve();
            Assert.That(write.All("G-code").Single() is null, Is.EqualTo(obstacle is null), "A first layer in the air is refused.");
            var found = check.All("Diagnostics").Any(d => $"{d}".Contains("extrusion.unsupported"));
            Assert.That(write.All("Diagnostics").Any(d => $"{d}".Contains("extrusion.unsupported")), Is.EqualTo(found));
            return found;
        }
        Assert.That(IsInTheAir(null));
        Assert.That(IsInTheAir(Shapes.Box(90, 90, 40, 12)), Is.False);
    }

    [Test]
    public void Models_of_a_file_are_read_in_their_unit()
    {
        var file = Path.Combine(Caterpillar.Tests.TestData.Repository, "examples", "models", "bracket.stl");
        var canvas = new Canvas<ReadModelComponent>().Feed("File", file).Solve();
        var plain = BoxOf(canvas.All("Meshes").Single()).Diagonal;
        var inches = BoxOf(canvas.Feed("Unit", 25.4).Solve().All("Meshes").Single()).Diagonal;
        Assert.That(inches.X / plain.X, Is.EqualTo(25.4).Within(1e-4));
        Assert.That(canvas.Feed("Unit", 0.0).Solve().Errors, Is.Not.Empty);
    }

    [Test]
    public void Modifiers_of_a_project_are_apart_from_its_parts()
    {
        const string Mesh = "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"3\" y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"3\" z=\"0\"/>"
            + "<vertex x=\"0\" y=\"0\" z=\"3\"/></vertices><triangles><triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/>"
            + "<triangle v1=\"1\" v2=\"2\" v3=\"3\"/><triangle v1=\"0\" v2=\"3\" v3=\"2\"/></triangles></mesh>";
        const string Model = "<model unit=\"millimeter\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources>"
            + "<object id=\"1\">" + Mesh + "</object><object id=\"2\">" + Mesh + "</object><object id=\"5\"><components><component objectid=\"1\"/>"
            + "<component objectid=\"2\" transform=\"1 0 0 0 1 0 0 0 1 40 0 0\"/></components></object></resources>"
            + "<build><item objectid=\"5\"/></build></model>";
        const string Config = "<config><object id=\"5\"><part id=\"1\" subtype=\"normal_part\"/><part id=\"2\" subtype=\"modifier_part\">"
            + "<metadata key=\"wall_loops\" value=\"5\"/></part></object></config>";
        var file = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N") + ".3mf");
        using (var zip = new ZipArchive(File.Create(file), ZipArchiveMode.Create))
        {
            foreach (var (path, text) in new[] { ("3D/3dmodel.model", Model), ("Metadata/model_settings.config", Config) })
            {
                using var writer = new StreamWriter(zip.CreateEntry(path).Open());
                writer.Write(text);
            }
        }
        var canvas = new Canvas<ReadModelComponent>().Feed("File", file).Solve();
        File.Delete(file);
        Assert.That(BoxOf(canvas.All("Meshes").Single()).Min.X, Is.Zero);
        Assert.That(BoxOf(canvas.All("Modifiers").Single()).Min.X, Is.EqualTo(40));
        Assert.That(canvas.One<PrintSettings>("Modifier Settings").WallCount, Is.EqualTo(5));
    }

    [Test]
    public void A_flat_drawing_from_a_file_is_raised_to_the_first_layer_unless_a_pen_draws_it()
    {
        var file = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N") + ".csv");
        File.WriteAllText(file, "10,10\n30,10\n");
        try
        {
            var canvas = new Canvas<ReadCurvesComponent>().Feed("File", file).Solve();
            Assert.That(canvas.One<PrintPath>("Print Paths").Points.Select(p => p.Z), Is.All.EqualTo(0.2));
            Assert.That(canvas.Notes, Has.One.Contains("The drawing is flat at Z 0."));
            Assert.That(canvas.Feed("Setup", "pen_plotter").Solve().One<PrintPath>("Print Paths").Start.Z, Is.Zero);
        }
        finally
        {
            File.Delete(file);
        }
    }

    [Test]
    public void Curves_of_a_file_are_read_in_their_order()
    {
        var file = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N") + ".csv");
        try
        {
            File.WriteAllText(file, "x,y,z\n10,10,0.2\n30,10,0.2\n\n30,30,0.2\n10,30,0.2\n");
            var canvas = new Canvas<ReadCurvesComponent>().Feed("File", file).Solve();
            Assert.That(canvas.Errors, Is.Empty);
            Assert.That(canvas.All("Print Paths").Cast<PrintPath>().Select(p => p.Start.Y), Is.EqualTo(new[] { 10.0, 30 }));
            Assert.That(canvas.All("Steps"), Has.Count.EqualTo(2));
            Assert.That(canvas.Feed("Unit", 25.4).Solve().All("Print Paths").Cast<PrintPath>().First().Length, Is.EqualTo(508).Within(1e-6));
            File.WriteAllText(file, "x,y,z\n10,ten,0.2\n");
            File.SetLastWriteTimeUtc(file, new DateTime(2020, 1, 1, 0, 0, 0, DateTimeKind.Utc));
            canvas.Component.ExpireSolution(false);
            Assert.That(canvas.Solve().Errors, Is.Not.Empty);
            Assert.That(canvas.All("Diagnostics"), Is.Not.Empty);
        }
        finally
        {
            File.Delete(file);
        }
        Assert.That(new Canvas<ReadCurvesComponent>().Feed("File", file).Solve().Errors, Has.One.Contains("File not found"));
    }
}
