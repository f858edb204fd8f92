using System;
using System.IO;
using System.Linq;
using System.Threading;
using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using Caterpillar.Tests.Library;
using Caterpillar.Tests.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Jobs;

/// <summary>A job writes what its parts would write, called one after the other.</summary>
public class PrintJobTests
{
    private static readonly PrintSetup Setup = new ProfileLibrary().Setup("generic").OrThrow();

    private static readonly PrintPath Line = new([new Vec3(60, 60, 0.2), new Vec3(90, 60, 0.2)], Bead.FromWidth(0.45, 0.2, 1, 20));

    private static string Model(string name) => Path.Combine(TestData.Repository, "examples", "models", name);

    [Category("Arithmetic")]
    [Test]
    public void A_sliced_model_is_the_file_of_reading_slicing_planning_and_writing()
    {
        using var folder = new TemporaryFolder();
        var meshes = MeshReader.Read(Model("bracket.stl")).OrThrow().OnBed(Setup.Printer);
        var layers = PlanarSlicer.Slice(meshes, Setup.Settings).OrThrow();
        SafeWriter.WriteFile(Planner.Plan(layers.ToSteps(), Setup).OrThrow(), Setup, folder.File("parts.gcode")).OrThrow();
        using var job = PrintJob.Slice(Model("bracket.stl"), Setup).OrThrow();
        Assert.That(job.Layers, Is.EqualTo(layers.Layers.Count));
        var written = job.WriteFile(folder.File("job.gcode")).OrThrow();
        Assert.That(File.ReadAllBytes(folder.File("job.gcode")), Is.EqualTo(File.ReadAllBytes(folder.File("parts.gcode"))));
        Assert.That(written.Bytes, Is.EqualTo(new FileInfo(folder.File("job.gcode")).Length));
        job.WriteFile(folder.File("again.gcode")).OrThrow();
        Assert.That(File.ReadAllBytes(folder.File("again.gcode")), Is.EqualTo(File.ReadAllBytes(folder.File("parts.gcode"))));
    }

    // It is timed while it is still being planned.
    [Test]
    public void A_long_drawing_is_the_file_of_planning_and_writing()
    {
        const int Points = 70_000;
        var points = Enumerable.Range(0, Points).Select(i => new Vec3(20 + i / 2 % 350 * 0.5, 20 + (i + 1) / 2 % 2, 0.2 * (1 + i / 700)));
        Step[] steps = [new PathStep(new PrintPath(points, new Bead(0.08, 0.2, 30)))];
        var plan = Planner.Plan(steps, Setup).OrThrow();
        Assert.That(plan.Blocks.Count, Is.GreaterThan(1));
        using var alone = new MemoryStream();
        var expected = SafeWriter.Write(plan, Setup, alone, "a test");

        using var written = new MemoryStream();
        using var job = PrintJob.Draw(steps, Setup).OrThrow();
        var found = job.Write(written, "a.gcode", reason: "a test");

        Assert.That(found.Value!.PrintTime, Is.EqualTo(expected.Value!.PrintTime));
        Assert.That(written.ToArray(), SameBytes.As(alone.ToArray()));
    }

    [Test]
    public void A_job_that_is_not_written_can_be_thrown_away()
        => PrintJob.Slice(Model("bracket.stl"), Setup).OrThrow().Dispose();

    [Test]
    public void Writing_is_canceled_by_its_own_token()
    {
        using var folder = new TemporaryFolder();
        using var job = PrintJob.Slice(Model("bracket.stl"), Setup).OrThrow();
        Assert.That(() => job.WriteFile(folder.File("a.gcode"), cancel: new CancellationToken(true)), Throws.InstanceOf<OperationCanceledException>());
        Assert.That(Directory.GetFiles(folder.Path), Is.Empty);
    }

    [Test]
    public void What_is_refused_leaves_no_file()
    {
        using var folder = new TemporaryFolder();
        var outside = Line.Transformed(Affine.Move(new Vec3(500, 0)));
        var job = PrintJob.Draw([outside], Setup).OrThrow();
        var refused = job.WriteFile(folder.File("a.gcode"));
        Assert.That(refused.Value, Is.Null);
        Assert.That(refused.Diagnostics.Select(d => d.Code), Does.Contain(SafeWriter.Refused).And.Contain("bed.outside"));
        Assert.That(Directory.GetFiles(folder.Path), Is.Empty);
        Assert.That(job.WriteFile(folder.File("a.gcode"), reason: "a test").Value!.Overridden, Is.GreaterThan(0));
    }

    [Test]
    public void Drawings_are_planned_as_drawn()
    {
        PrintPath[] paths = [Line, Line.Transformed(Affine.Move(new Vec3(0, 40))), Line.Transformed(Affine.Move(new Vec3(0, 10)))];
        var drawn = PrintJob.Draw(paths.ToSteps(), Setup, new PrintJobOptions { Policy = PlanPolicy.AsDrawn }).OrThrow();
        var parts = Planner.Plan(paths.ToSteps(), Setup, new PlanOptions { Policy = PlanPolicy.AsDrawn }).OrThrow();
        Assert.That(drawn.Toolpath.Moves(), Is.EqualTo(parts.Moves()));
    }

    [Test]
    public void A_drawing_on_an_object_lies_on_it_and_knows_it()
    {
        var plate = TriMesh.Create([new Vec3(50, 50, 5), new Vec3(100, 50, 5), new Vec3(100, 70, 5), new Vec3(50, 70, 5)], [0, 1, 2, 0, 2, 3]);
        var job = PrintJob.Draw([Line], Setup, new PrintJobOptions { Onto = plate }).OrThrow();
        Assert.That(job.Setup.PrintedOn, Is.SameAs(plate));
        Assert.That(job.Toolpath.Moves().Where(m => m.Kind == MoveKind.Print).Select(m => m.End.Z), Is.All.EqualTo(5.2).Within(1e-6));
    }

    [Test]
    public void A_model_on_an_object_has_no_raft_or_tower()
    {
        var plate = TriMesh.Create([new Vec3(40, 40, 5), new Vec3(100, 40, 5), new Vec3(100, 100, 5), new Vec3(40, 100, 5)], [0, 1, 2, 0, 2, 3]);
        var settings = Setup.Settings with { RaftLayers = 2, PurgeTower = true };
        var model = new SliceModel(new NamedMesh("block", Solids.Block(60, 60, 0, 70, 70, 1)), settings);
        using var job = PrintJob.Slice([model], Setup with { Settings = settings }, new PrintJobOptions { Onto = plate }).OrThrow();
        var prints = job.Toolpath.Moves().Where(m => m.Kind == MoveKind.Print).ToArray();
        Assert.That(prints.Min(m => m.End.Z), Is.EqualTo(5 + settings.FirstLayerHeight).Within(1e-6));
        Assert.That(prints.Max(m => m.End.Z), Is.EqualTo(6).Within(1e-6));
        Assert.That(prints.Select(m => m.Role), Has.None.AnyOf(Role.Raft, Role.PrimeTower, Role.Skirt));
    }

    [Test]
    public void A_script_with_an_error_gives_its_place()
    {
        using var folder = new TemporaryFolder();
        File.WriteAllText(folder.File("a.turtle"), "start 100 100 0.3\nforwards 20\n");
        var diagnostic = PrintJob.Turtle(folder.File("a.turtle"), Setup).Diagnostics.Single();
        Assert.That((diagnostic.Source!.File, diagnostic.Source.Line), Is.EqualTo((folder.File("a.turtle"), 2)));
    }

    [Test]
    public void Models_are_scaled_turned_and_copied_before_they_are_arranged()
    {
        var mesh = TriMesh.Create([Vec3.Zero, new Vec3(20, 0), new Vec3(0, 10), new Vec3(0, 0, 5)], [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]);
        var placing = new ModelPlacing { LongestSide = 40, Rotate = new Vec3(0, 0, 90), Copies = 2 };
        var placed = placing.Place([new NamedMesh("a", mesh)], Setup).OrThrow();
        Assert.That(placed.Select(m => m.Name), Is.EqualTo(new[] { "a", "a (2)" }));
        Assert.That(placed.Select(m => m.Mesh.Bounds.Size.DistanceTo(new Vec3(20, 40, 10))), Is.All.LessThan(1e-9));
        var alone = new ModelPlacing { Center = new Vec3(50, 60) }.Place([new NamedMesh("a", mesh)], Setup).OrThrow();
        Assert.That(alone[0].Mesh.Bounds.Center.WithZ(0).DistanceTo(new Vec3(50, 60)), Is.LessThan(1e-9));
    }
}
