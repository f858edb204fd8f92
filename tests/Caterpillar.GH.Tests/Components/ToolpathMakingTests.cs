using System;
using System.Linq;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using NUnit.Framework;
using Rhino;

namespace Caterpillar.GH.Tests.Components;

/// <summary>Toolpaths taken apart, made again, merged, and given as planes.</summary>
[Category("Host")]
public sealed class ToolpathMakingTests
{
    private static ToolpathGoo Planned(double x, params double[] heights)
    {
        var bead = new Bead(0.08, 0.2, 40);
        var paths = heights.Select((z, i) => (Step)new PrintPath([new Vec3(x, 50, z), new Vec3(x + 10, 50, z), new Vec3(x + 10, 70, z)], bead)
        {
            Role = Role.OuterWall, Layer = new Layer(i, z, 0.2),
        }).ToArray();
        return new ToolpathGoo(Planner.Plan(paths, new PrintSetup()).Value!, new PrintSetup());
    }

    [Test]
    public void A_toolpath_that_was_taken_apart_is_made_again()
    {
        var whole = Planned(50, 0.2, 0.4).Value;
        var made = Again(new ToolpathGoo(whole), "Points", "E Values", "Speeds", "Kinds", "Roles");
        Assert.That(made.Errors, Is.Empty);
        var back = made.One<Toolpath>("Toolpath");
        Assert.That(back.Moves().Select(m => (m.End, m.E, m.Deposited, m.Speed, m.Kind, m.Role)),
            Is.EqualTo(whole.Moves().Select(m => (m.End, m.E, m.Deposited, m.Speed, m.Kind, m.Role))));
        Assert.That(back.Layers.Select(l => (l.Index, l.Z, Math.Round(l.Thickness, 9))), Is.EqualTo(new[] { (0, 0.2, 0.2), (1, 0.4, 0.2) }));
        Assert.That(back.Moves().Select(m => (m.Tool, m.Source)).Distinct(), Is.EqualTo(new[] { (0, -1) }), "It comes from no line and no step.");
    }

    [Test]
    public void Without_kinds_they_follow_from_E_and_the_points()
    {
        var canvas = new Canvas<ConstructToolpathComponent>()
            .Feed("Points", P(0, 0), P(10, 0), P(10, 0), P(20, 0), P(20, 0), P(20, 0), P(25, 0))
            .Feed("E Values", 0.0, 1.0, -2.0, 0.0, 2.0, 0.5, -1.0).Feed("Speeds", 20.0).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        var toolpath = canvas.One<Toolpath>("Toolpath");
        // The first point is where the head may be already.
        Assert.That(toolpath.Moves().Select(m => m.Kind), Is.EqualTo(new[]
        {
            MoveKind.Travel, MoveKind.Print, MoveKind.Retract, MoveKind.Travel, MoveKind.Deretract, MoveKind.Prime, MoveKind.Wipe,
        }));
        Assert.That(toolpath.Moves().Select(m => m.Deposited), Is.EqualTo(new[] { 0, 1, 0, 0, 0, 0.5, 0 }));
        Assert.That(toolpath.Moves().Select(m => m.Speed), Is.All.EqualTo(20.0));
        Assert.That(canvas.Component.Message, Is.EqualTo("7 moves"));
    }

    [Test]
    public void An_extrusion_restores_first_what_was_retracted()
    {
        var canvas = new Canvas<ConstructToolpathComponent>().Feed("Points", P(0, 0), P(0, 0), P(10, 0)).Feed("E Values", 0.0, -1.0, 1.5).Feed("Speeds", 20.0)
            .Solve();
        Assert.That(canvas.One<Toolpath>("Toolpath")[2].Deposited, Is.EqualTo(0.5));
    }

    [TestCase("E Values", new object[] { 1.0, 2.0 }, "E Values has 2 values for the 3 points of branch {0}.")]
    [TestCase("Speeds", new object[] { 0.0 }, "Speeds must be greater than zero and finite.")]
    [TestCase("Kinds", new object[] { "Jump" }, "Kinds has no Jump. Use one of: Print, Travel")]
    [TestCase("Roles", new object[] { "Roof" }, "Roles has no Roof.")]
    [TestCase("E Values", new object?[] { 1.0, null, 1.0 }, "E Values: item 1 of branch {0} is null.")]
    [TestCase("Points", new object[] { "here" }, "onversion failed")]
    public void What_does_not_fit_is_an_error_that_says_where(string port, object?[] values, string message)
    {
        var canvas = new Canvas<ConstructToolpathComponent>().Feed("Points", P(0, 0), P(10, 0), P(20, 0)).Feed("E Values", 1.0).Feed("Speeds", 20.0)
            .Feed(port, values).Solve();
        Assert.That(canvas.Errors, Has.Some.Contains(message));
        Assert.That(canvas.All("Toolpath"), Has.All.Null);
    }

    [Test]
    public void Branches_that_do_not_fit_are_an_error_and_dwells_are_left_out_with_a_warning()
    {
        var canvas = new Canvas<ConstructToolpathComponent>().FeedTree("Points", [P(0, 0)], [P(1, 0)], [P(2, 0)]).FeedTree("E Values", [1.0], [1.0])
            .Feed("Speeds", 20.0).Solve();
        Assert.That(canvas.Errors, Has.One.Contains("E Values has 2 branches, but Points has 3."));
        canvas = new Canvas<ConstructToolpathComponent>().FeedTree("Points", [P(0, 0), P(1, 0)], [P(2, 0), P(3, 0)]).Feed("E Values", 1.0, 1.0)
            .Feed("Speeds", 20.0).Solve();
        Assert.That(canvas.Errors, Has.One.Contains("E Values has 2 values for the 2 points of branch").And.One.Contains("Give one for all"));
        var dwells = new Canvas<ConstructToolpathComponent>().Feed("Points", P(5, 0), P(5, 0)).Feed("E Values", 0.0).Feed("Speeds", 20.0, 0.0)
            .Feed("Kinds", "Travel", "Dwell").Solve();
        Assert.That(dwells.Warnings, Has.One.Contains("1 dwells are left out"));
        Assert.That(dwells.One<Toolpath>("Toolpath").Count, Is.EqualTo(1));
        var two = Again(Planned(50, 0.2), "Points", "E Values", "Speeds");
        Assert.That(two.Errors, Is.Empty);
    }

    [Test]
    public void Toolpaths_follow_each_other_with_a_retracted_travel_above_all_that_is_printed()
    {
        var (a, b) = (Planned(50, 0.2, 0.4), Planned(90, 0.2));
        var canvas = new Canvas<MergeToolpathsComponent>().Feed("Toolpaths", a, null, b).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(canvas.Warnings, Has.One.Contains("1 null item"));
        var merged = canvas.One<Toolpath>("Toolpath");
        Assert.That(merged.Moves().Take(a.Value.Count).Select(m => (m.End, m.E, m.Kind)), Is.EqualTo(a.Value.Moves().Select(m => (m.End, m.E, m.Kind))));
        var prints = merged.Moves().Where(m => m.Kind == MoveKind.Print).ToArray();
        Assert.That(prints.Select(m => m.End), Is.EqualTo(a.Value.Moves().Concat(b.Value.Moves()).Where(m => m.Kind == MoveKind.Print).Select(m => m.End)));
        var first = prints[4];
        Assert.That(first.Start, Is.EqualTo(new Vec3(90, 50, 0.2)));
        var between = merged.Moves().Skip(prints[3].Index + 1).TakeWhile(m => m.Index < first.Index).ToArray();
        var printer = new Printer();
        Assert.That(between.Select(m => m.Kind), Is.EqualTo(new[]
        {
            MoveKind.Retract, MoveKind.Travel, MoveKind.Travel, MoveKind.Travel, MoveKind.Deretract,
        }));
        Assert.That(between[0].E, Is.EqualTo(-printer.RetractionLength));
        Assert.That(between[1].End, Is.EqualTo(new Vec3(60, 70, 0.4 + printer.ZHop)));
        Assert.That(between[2].End, Is.EqualTo(new Vec3(90, 50, 0.4 + printer.ZHop)));
        Assert.That(merged.Moves().Sum(m => m.E - m.Deposited), Is.EqualTo(0).Within(1e-9), "What is retracted comes back.");
    }

    [Test]
    public void Start_and_end_code_of_files_is_left_out()
    {
        const string File = "G28\nM109 S200\nM83\n;LAYER_CHANGE\nG1 X{0} Y60 Z0.2 F6000\nG1 X{1} Y60 E1 F1200\nM106 S128\nG1 X{1} Y80 E1\nM104 S0\nG28 X\n";
        ToolpathGoo Decoded(int x) => new(GCodeDecoder.Decode(GCodeDocument.FromText(File.Replace("{0}", $"{x}").Replace("{1}", $"{x + 20}"))).Value!);
        var canvas = new Canvas<MergeToolpathsComponent>().Feed("Toolpaths", Decoded(50), Decoded(100)).Feed("Setup", "generic").Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(canvas.Notes, Has.One.Contains("start and end code of a file is left out"));
        var merged = canvas.One<Toolpath>("Toolpath");
        Assert.That(merged.Events.Select(e => e.Event), Is.All.InstanceOf<FanEvent>().And.Exactly(2).Items);
        Assert.That(merged.Moves().Where(m => m.Kind == MoveKind.Print).Select(m => m.End.X), Is.EqualTo(new[] { 70.0, 70, 120, 120 }));
        Assert.That(canvas.Feed("Toolpaths", Decoded(50)).Solve().Errors, Is.Empty);
    }

    [Test]
    public void A_tool_that_the_printer_does_not_have_is_an_error()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, null);
        builder.Add(new Vec3(1, 1, 1), 0, 0, 50, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.Add(new Vec3(9, 1, 1), 1, 1, 50, MoveKind.Print, Role.Unspecified, -1, 3, 0);
        var goo = new ToolpathGoo(builder.Build([new ToolpathTool(2.4)]));
        var canvas = new Canvas<MergeToolpathsComponent>().Feed("Toolpaths", goo).Solve();
        Assert.That(canvas.Errors, Has.One.Contains("A toolpath uses tool 3, but the printer has only tool 0."));
        Assert.That(canvas.All("Toolpath"), Has.All.Null);
    }

    [Test]
    public void Each_move_has_a_plane_along_the_motion_with_speed_and_flow()
    {
        var goo = Planned(50, 0.2);
        var canvas = new Canvas<ToolpathFramesComponent>().Feed("Toolpath", goo).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        var moves = goo.Value.Moves().ToArray();
        var planes = canvas.All("Planes").Cast<Rg.Plane>().ToArray();
        Assert.That(planes.Select(p => p.Origin), Is.EqualTo(moves.Select(m => new Rg.Point3d(m.End.X, m.End.Y, m.End.Z))));
        Assert.That(planes.Select(p => p.ZAxis), Is.All.EqualTo(new Rg.Vector3d(0, 0, 1)), "The tool is upright.");
        var prints = moves.Where(m => m.Kind == MoveKind.Print).Select(m => m.Index).ToArray();
        Assert.That(prints.Select(i => planes[i].XAxis), Is.EqualTo(new[] { new Rg.Vector3d(1, 0, 0), new Rg.Vector3d(0, 1, 0) }));
        Assert.That(canvas.All("Speeds"), Is.EqualTo(moves.Select(m => m.Speed)));
        // 0.08 mm² at 40 mm/s.
        Assert.That(prints.Select(i => Math.Round((double)canvas.All("Flows")[i]!, 9)), Is.All.EqualTo(3.2));
        Assert.That(canvas.All("Kinds"), Is.EqualTo(moves.Select(m => m.Kind.ToString())));
    }

    [Test]
    public void Planes_follow_the_tilt_of_the_tool_and_arcs_become_chords()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(new Vec3(10, 0, 5), 0, 0, 50, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.SetRotary(new Vec3(0, 90, 0));
        builder.Add(new Vec3(10, 0, 9), 0, 0, 50, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.SetRotary(new Vec3(0, 90, 0));
        var canvas = new Canvas<ToolpathFramesComponent>().Feed("Toolpath", new ToolpathGoo(builder.Build([new ToolpathTool(2.4)]))).Solve();
        var planes = canvas.All("Planes").Cast<Rg.Plane>().ToArray();
        // The tool lies along X: of the first motion only Z is across it.
        Assert.That(planes.Select(p => (Rounded(p.ZAxis), Rounded(p.XAxis))), Is.All.EqualTo((new Rg.Vector3d(1, 0, 0), new Rg.Vector3d(0, 0, 1))));
        var arc = new ToolpathBuilder(MoveSource.Steps, new Vec3(10, 0, 0));
        arc.Add(new Vec3(0, 10, 0), 1, 1, 50, MoveKind.Print, Role.Unspecified, -1, 0, 0, new Arc(Vec3.Zero, 90));
        var round = new Canvas<ToolpathFramesComponent>().Feed("Toolpath", new ToolpathGoo(arc.Build([new ToolpathTool(2.4)]))).Solve();
        var chords = round.All("Planes").Cast<Rg.Plane>().ToArray();
        Assert.That(chords, Has.Length.GreaterThan(8));
        Assert.That(chords.Select(p => p.Origin.DistanceTo(Rg.Point3d.Origin)), Is.All.EqualTo(10).Within(1e-9));
    }

    [Test]
    public void Planes_are_in_document_units_and_keep_branches_and_nulls()
    {
        var goo = Planned(50, 0.2, 0.4);
        using var _ = new InDocument(UnitSystem.Centimeters);
        var canvas = new Canvas<ToolpathFramesComponent>().FeedTree("Toolpath", [goo], [null, "a wall", goo]).Solve();
        Assert.That(((Rg.Plane)canvas.All("Planes")[0]!).Origin.X, Is.EqualTo(5).Within(1e-9));
        Assert.That(canvas.Paths("Planes"), Is.EqualTo(new[] { "{0;0;0}", "{0;0;1}", "{1;2;0}", "{1;2;1}" }));
        Assert.That(canvas.Warnings, Has.Member("{1}[0]: Toolpath is missing.").Or.Some.Contains("Toolpath is missing."));
    }

    private static Rg.Point3d P(double x, double y) => new(x, y, 0.2);

    private static Rg.Vector3d Rounded(Rg.Vector3d v) => new(Math.Round(v.X, 9), Math.Round(v.Y, 9), Math.Round(v.Z, 9));

    private static Canvas<ConstructToolpathComponent> Again(ToolpathGoo goo, params string[] ports)
    {
        var apart = new Canvas<DeconstructToolpathComponent>().Feed("Toolpath", goo).Solve();
        var made = new Canvas<ConstructToolpathComponent>(apart.Document);
        foreach (var port in ports) made.Input(port).AddSource(apart.Output(port));
        return made.Solve();
    }
}
