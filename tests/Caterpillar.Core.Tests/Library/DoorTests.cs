using System;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Display;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using Caterpillar.Turtles;
using NUnit.Framework;

namespace Caterpillar.Tests.Library;

/// <summary>The calls that make programs against the library short.</summary>
public class DoorTests
{
    private static readonly Diagnostic Broken = new(Severity.Error, "mesh.empty", "The file has no faces.", new SourceLocation("a.stl"));
    private static readonly Diagnostic Open = new(Severity.Warning, "mesh.naked_edges", "3 open edges.");

    [Test]
    public void OrThrow_gives_the_value_in_spite_of_warnings()
        => Assert.That(new Result<string>("value", [Open]).OrThrow(), Is.EqualTo("value"));

    [Test]
    public void OrThrow_throws_the_text_of_the_errors_and_keeps_all_diagnostics()
    {
        var thrown = Assert.Throws<DiagnosticException>(() => new Result<string>(null, [Open, Broken, Broken with { Code = "mesh.format" }]).OrThrow())!;
        Assert.That(thrown.Message, Is.EqualTo(
            "a.stl: error mesh.empty: The file has no faces.\na.stl: error mesh.format: The file has no faces."));
        Assert.That(thrown.Diagnostics, Has.Count.EqualTo(3));
    }

    [Test]
    public void OrThrow_throws_where_an_error_says_that_the_value_must_not_be_used()
        => Assert.Throws<DiagnosticException>(() => new Result<string>("value", [Broken]).OrThrow());

    [Test]
    public void Paths_are_planned_as_the_same_steps_are()
    {
        var bead = new Bead(0.1, 0.2);
        PrintPath[] paths =
        [
            new([new Vec3(10, 10, 0.2), new Vec3(40, 10, 0.2)], bead),
            new([new Vec3(40, 30, 0.2), new Vec3(10, 30, 0.2)], bead),
        ];
        var ofPaths = Planner.Plan(paths.Select(p => p).ToSteps(), new PrintSetup()).OrThrow();
        var ofSteps = Planner.Plan(paths.Select(p => (Step)p).ToArray(), new PrintSetup()).OrThrow();
        Assert.That(ofPaths.Moves(), Is.EqualTo(ofSteps.Moves()));
        Assert.That(ofPaths.Moves().Count(m => m.Kind == MoveKind.Print), Is.EqualTo(2));
        Assert.That(Planner.Plan([paths[0]], new PrintSetup()).OrThrow().Moves().Count(m => m.Kind == MoveKind.Print), Is.EqualTo(1));
        Assert.Throws<ArgumentNullException>(() => Enumerable.Repeat<PrintPath>(null!, 1).ToSteps());
    }

    [Test]
    public void Vectors_and_beads_change_one_value_by_with()
    {
        var point = new Vec3(1, 2, 3);
        Assert.That(point with { Y = 20 }, Is.EqualTo(new Vec3(1, 20, 3)));
        var (x, y, z) = point;
        Assert.That((x, y, z), Is.EqualTo((1.0, 2.0, 3.0)));
        Assert.That(new Bead(0.1, 0.2, 30) with { Speed = 15 }, Is.EqualTo(new Bead(0.1, 0.2, 15)));
        Assert.Throws<ArgumentOutOfRangeException>(() => _ = new Bead(0.1) with { Area = -1 });
    }

    [Test]
    public void A_turtle_repeats_what_it_is_told()
    {
        var turtle = new Turtle().Repeat(4, t => t.Forward(10).Left(90));
        Assert.That((turtle.MoveCount, turtle.Position.Length), Is.EqualTo((4L, 0.0)).Within(1e-9));
        // 0 + 1 + 2 + 3 + 4 mm.
        Assert.That(new Turtle().Repeat(5, (t, i) => t.Forward(i)).X, Is.EqualTo(10).Within(1e-12));
        Assert.That(new Turtle().Repeat(0, t => t.Forward(1)).MoveCount, Is.Zero);
        Assert.Throws<ArgumentOutOfRangeException>(() => new Turtle().Repeat(-1, t => t.Forward(1)));
    }

    [Test]
    public void An_image_is_one_call()
    {
        using var folder = new TemporaryFolder();
        var toolpath = Planner.Plan([new PrintPath([new Vec3(10, 10, 0.2), new Vec3(40, 10, 0.2)], new Bead(0.1, 0.2))], new PrintSetup()).OrThrow();
        ToolpathImage.WriteFile(toolpath, folder.File("a.png"), new ToolpathImageOptions { Width = 60, Height = 40 });
        Assert.That(File.ReadAllBytes(folder.File("a.png")),
            Is.EqualTo(Caterpillar.Files.PngWriter.ToBytes(ToolpathImage.Draw(toolpath, new ToolpathImageOptions { Width = 60, Height = 40 }))));
        Assert.That(Directory.GetFiles(folder.Path), Has.Length.EqualTo(1));
    }

    [Test]
    public void Models_stand_in_the_middle_of_the_bed_of_a_printer()
    {
        var mesh = TriMesh.Create([new Vec3(0, 0, 5), new Vec3(10, 0, 5), new Vec3(0, 4, 5), new Vec3(0, 0, 8)], [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]);
        var placed = new[] { new NamedMesh("a", mesh) }.OnBed(new Printer());
        Assert.That(placed[0].Mesh.Bounds.Min, Is.EqualTo(new Vec3(105, 108, 0)));
        Assert.That(placed[0].Mesh.Bounds.Max, Is.EqualTo(new Vec3(115, 112, 3)));
    }

    [Test]
    public void The_box_of_chosen_moves_leaves_out_the_others()
    {
        var setup = new PrintSetup();
        var toolpath = Planner.Plan([new PrintPath([new Vec3(10, 10, 0.2), new Vec3(40, 15, 0.2)], new Bead(0.1, 0.2))], setup).OrThrow();
        var box = MoveFilter.Prints.BoundsIn(toolpath);
        Assert.That((box.Min, box.Max), Is.EqualTo((new Vec3(10, 10, 0.2), new Vec3(40, 15, 0.2))));
        Assert.That(new MoveFilter { Roles = [Role.Ironing] }.BoundsIn(toolpath).IsEmpty, Is.True);
    }
}
