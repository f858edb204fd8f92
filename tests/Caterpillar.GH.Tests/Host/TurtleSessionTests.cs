using System;
using System.IO;
using System.Linq;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.GH.Components.Design;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Setup;
using Caterpillar.GH.Components.Simulate;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Host;

/// <summary>A session of a user who draws with a turtle, watches its triangle, and prints the drawing.</summary>
[Category("Host")]
public sealed class TurtleSessionTests
{
    private const string Square = "bead 0.5 0.2\nspeed 30\nrepeat 4 [ forward 40; left 90 ]\n";

    private GH_Document _document = null!;
    private string _file = "";
    private Canvas<PrintSetupComponent> _setup = null!;
    private Canvas<TurtleProgramComponent> _program = null!;
    private Canvas<TurtleComponent> _turtle = null!;
    private Canvas<TurtlePreviewComponent> _triangle = null!;
    private Canvas<PlanToolpathComponent> _plan = null!;
    private Canvas<CheckComponent> _check = null!;
    private Canvas<SaveGCodeComponent> _save = null!;

    [SetUp]
    public void Draw()
    {
        _document = new GH_Document();
        _file = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N") + ".gcode");
        _setup = new Canvas<PrintSetupComponent>(_document).Feed("Printer", "ender3");
        _program = new Canvas<TurtleProgramComponent>(_document).Feed("Script", Square);
        var corner = new Rg.Plane(new Rg.Point3d(100, 100, 0.2), new Rg.Vector3d(1, 0, 0), new Rg.Vector3d(0, 1, 0));
        _turtle = new Canvas<TurtleComponent>(_document).Feed("Start Plane", corner).Feed("Every Pose", true);
        _triangle = new Canvas<TurtlePreviewComponent>(_document).Feed("Position", 0.0);
        _plan = new Canvas<PlanToolpathComponent>(_document);
        _check = new Canvas<CheckComponent>(_document);
        _save = new Canvas<SaveGCodeComponent>(_document).Feed("File", _file).Feed("Save", false);
        _turtle.Input("Setup").AddSource(_setup.Output("Setup"));
        _turtle.Input("Program").AddSource(_program.Output("Program"));
        _triangle.Input("Steps").AddSource(_turtle.Output("Steps"));
        _plan.Input("Steps").AddSource(_turtle.Output("Steps"));
        _check.Input("Toolpath").AddSource(_plan.Output("Toolpath"));
        _save.Input("G-code").AddSource(_check.Output("Checked Toolpath"));
    }

    [TearDown]
    public void TearDown() => File.Delete(_file);

    [Test]
    public void The_triangle_follows_the_slider_along_the_drawing()
    {
        foreach (var (position, point, ahead) in new[]
        {
            (0.125, new Rg.Point3d(120, 100, 0.2), new Rg.Vector3d(1, 0, 0)), (0.375, new Rg.Point3d(140, 120, 0.2), new Rg.Vector3d(0, 1, 0)),
            (0.75 + 0.125, new Rg.Point3d(100, 120, 0.2), new Rg.Vector3d(0, -1, 0)),
        })
        {
            _triangle.Feed("Position", position).Solve();
            var plane = _triangle.One<Rg.Plane>("Plane");
            Assert.That(plane.Origin.DistanceTo(point), Is.LessThan(1e-9));
            Assert.That((plane.XAxis - ahead).Length, Is.LessThan(1e-9));
            Assert.That(((Rg.Curve)_triangle.All("Triangle").Single()!).TryGetPolyline(out var corners), Is.True);
            // A sharp corner ahead; the middle of the other two is the tail.
            Assert.That(corners.Count, Is.EqualTo(4));
            Assert.That(corners.Max(c => (c - point) * ahead), Is.GreaterThan(2));
            Assert.That(corners.Min(c => (c - point) * ahead), Is.LessThanOrEqualTo(1e-9));
        }
    }

    [Test]
    public void The_drawing_is_what_the_saved_file_prints()
    {
        _document.NewSolution(false);
        Assert.That(_turtle.All("Planes"), Has.Count.EqualTo(_turtle.All("Triangles").Count).And.Count.GreaterThanOrEqualTo(8));
        Assert.That(((Rg.Plane)_turtle.All("Planes").Last()!).Origin.DistanceTo(new Rg.Point3d(100, 100, 0.2)), Is.LessThan(1e-9), "Back at the corner.");
        Assert.That(_turtle.One<PrintPath>("Print Paths").Length, Is.EqualTo(160).Within(1e-9));
        Assert.That(_check.One<bool>("OK"), Is.True);
        Assert.That(_document.Messages(), Is.Empty);
        _save.Feed("Save", true).Solve();
        Assert.That(_save.One<string>("Path"), Is.EqualTo(_file));
        Assert.That(_document.Messages(), Is.Empty);
        var read = GCodeDecoder.Decode(GCodeDocument.ReadFile(_file).OrThrow(), new DecodeOptions { Flavor = FlavorTable.Marlin2 }).OrThrow().Toolpath;
        var sides = read.Moves().Where(m => m.Kind == MoveKind.Print && m.End.Z < 0.25 && m.Start.X >= 99).ToArray();
        Assert.That(sides.Select(m => m.End), Is.EqualTo(new[] { new Vec3(140, 100, 0.2), new(140, 140, 0.2), new(100, 140, 0.2), new(100, 100, 0.2) }));
        Assert.That(sides.Select(m => m.Speed), Is.All.EqualTo(30).Within(1e-9));
    }

    [Test]
    public void A_word_that_is_no_command_is_told_once_and_nothing_is_planned()
    {
        _program.Feed("Script", Square + "forwad 3");
        _turtle.Solve();
        Assert.That(_program.Errors.Single(), Does.Contain("line 4:1").And.Contain("Did you mean 'forward'?"));
        Assert.That(_plan.All("Toolpath"), Has.None.Not.Null);
        Assert.That(_document.Messages().Where(m => m.Contains(", Error: ")), Has.All.StartsWith("Turtle Program").Or.All.Contains("no valid data"));
        _program.Feed("Script", Square).Solve();
        Assert.That(_document.Messages(), Is.Empty, "All recovers.");
        Assert.That(_plan.One<Toolpath>("Toolpath").Moves().Where(m => m.Kind == MoveKind.Print).Sum(m => m.Length), Is.EqualTo(160).Within(1e-6));
    }
}
