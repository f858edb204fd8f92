using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Display;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Display;

public sealed class ExtrusionMeshTests
{
    private static Toolpath Plan(params PrintPath[] paths)
        => Planner.Plan(paths.Select(p => (Step)p).ToArray(), new PrintSetup(), new PlanOptions { Policy = PlanPolicy.AsDrawn }).Value!;

    private static ExtrusionMesh Of(params PrintPath[] paths)
    {
        var toolpath = Plan(paths);
        return ExtrusionMesh.Of(toolpath, 0, toolpath.Count);
    }

    // By the divergence theorem; positive where faces are counter-clockwise seen from outside.
    private static double Volume(ExtrusionMesh mesh)
    {
        var sum = 0.0;
        for (var i = 0; i < mesh.Quads.Count; i += 4)
        {
            Vec3 a = mesh.Vertices[mesh.Quads[i]], b = mesh.Vertices[mesh.Quads[i + 1]], c = mesh.Vertices[mesh.Quads[i + 2]],
                d = mesh.Vertices[mesh.Quads[i + 3]];
            sum += (Vec3.Dot(a, Vec3.Cross(b, c)) + Vec3.Dot(a, Vec3.Cross(c, d))) / 6;
        }
        return sum;
    }

    private static bool IsClosed(ExtrusionMesh mesh)
    {
        var edges = new Dictionary<(int, int), int>();
        for (var i = 0; i < mesh.Quads.Count; i += 4)
        {
            for (var k = 0; k < 4; k++)
            {
                int a = mesh.Quads[i + k], b = mesh.Quads[i + (k + 1) % 4];
                edges[(a, b)] = edges.TryGetValue((a, b), out var n) ? n + 1 : 1;
            }
        }
        return edges.All(e => e.Value == 1 && edges.ContainsKey((e.Key.Item2, e.Key.Item1)));
    }

    // In the air, and nearer to the bed than a ball of 10 mm³ is wide: 2.67 mm.
    [TestCase(5, 2.673, 2.673)]
    [TestCase(0.5, 5.046, 0.5)]
    public void Material_in_place_is_a_closed_ball_or_disc_below_the_nozzle(double z, double width, double height)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(10, 10, z));
        builder.Add(new Vec3(10, 10, z), 10, 10, 2, MoveKind.Prime, Role.Unspecified, -1, 0, 0);
        builder.Add(new Vec3(10, 10, z), 10, 10, 2, MoveKind.Prime, Role.Purge, -1, 0, 0);
        var mesh = ExtrusionMesh.Of(builder.Build([new ToolpathTool(1)]), 0, 2);
        var box = Bounds.Of(mesh.Vertices);
        Assert.That(box.Max.Z, Is.EqualTo(z).Within(1e-9));
        Assert.That(box.Size.DistanceTo(new Vec3(width, width, height)), Is.LessThan(1e-3));
        Assert.That(mesh.Moves, Has.Count.EqualTo(mesh.Vertices.Count).And.All.Zero, "not for start code");
        Assert.That(IsClosed(mesh), Is.True);
        Assert.That(Volume(mesh), Is.InRange(7, 12));
    }

    [Test]
    public void Without_a_height_an_extrusion_is_as_high_as_it_is_wide()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(10, 10, 5));
        builder.Add(new Vec3(20, 10, 5), 2.5, 2.5, 2, MoveKind.Print, Role.Unspecified, -1, 0, 0);
        var box = Bounds.Of(ExtrusionMesh.Of(builder.Build([new ToolpathTool(1)]), 0, 1).Vertices);
        Assert.That(box.Size.DistanceTo(new Vec3(10, 0.5, 0.5)), Is.LessThan(1e-9));
    }

    // Rings of eight corners: one for each point, and one more where a tube ends and the next begins.
    [TestCase(60, 3)]
    [TestCase(80, 4)]
    public void A_tube_is_bent_unless_the_corner_is_sharp(double degrees, int rings)
    {
        var (sin, cos) = Caterpillar.Basics.Angle.SinCos(degrees);
        var path = new PrintPath([new Vec3(50, 50, 0.2), new Vec3(60, 50, 0.2), new Vec3(60 + 10 * cos, 50 + 10 * sin, 0.2)], Bead.FromWidth(0.6, 0.2));
        var mesh = Of(path);
        Assert.That(mesh.Vertices, Has.Count.EqualTo(8 * rings));
        Assert.That(mesh.Moves.Distinct().Count(), Is.EqualTo(2), "each vertex knows its move");
        Assert.That(IsClosed(mesh), Is.True);
    }

    [Test]
    public void A_straight_extrusion_is_a_closed_tube_of_its_width_and_height_below_the_path()
    {
        var bead = Bead.FromWidth(0.6, 0.2, shape: BeadShape.Stadium);
        var mesh = Of(new PrintPath([new Vec3(10, 10, 0.2), new Vec3(30, 10, 0.2)], bead) { Layer = new Layer(0, 0.2, 0.2) });
        var box = Bounds.Of(mesh.Vertices);
        Assert.That(box.Min.DistanceTo(new Vec3(10, 9.7, 0)), Is.LessThan(1e-6));
        Assert.That(box.Max.DistanceTo(new Vec3(30, 10.3, 0.2)), Is.LessThan(1e-6));
        Assert.That(IsClosed(mesh), Is.True);
        Assert.That(Volume(mesh), Is.EqualTo(0.9 * 0.6 * 0.2 * 20).Within(1e-6));
    }

    [Test]
    public void Corners_are_mitered_and_turns_on_the_spot_are_capped()
    {
        var bead = Bead.FromWidth(0.6, 0.2, shape: BeadShape.Stadium);
        var corner = Of(new PrintPath([new Vec3(0, 0, 0.2), new Vec3(10, 0, 0.2), new Vec3(20, 5, 0.2)], bead) { Layer = new Layer(0, 0.2, 0.2) });
        Assert.That(corner.Vertices, Has.Count.EqualTo(3 * 8), "One ring for the corner.");
        Assert.That(IsClosed(corner), Is.True);
        Assert.That(Volume(corner), Is.EqualTo(0.9 * 0.6 * 0.2 * (10 + Math.Sqrt(125))).Within(1e-6), "A miter neither adds nor takes.");
        var back = Of(new PrintPath([new Vec3(0, 0, 0.2), new Vec3(10, 0, 0.2), new Vec3(0, 0.1, 0.2)], bead) { Layer = new Layer(0, 0.2, 0.2) });
        Assert.That(back.Vertices, Has.Count.EqualTo(4 * 8));
        Assert.That(IsClosed(back), Is.True);
    }

    [Test]
    public void Vertices_name_their_move_and_travels_have_none()
    {
        var bead = Bead.FromWidth(0.6, 0.2, shape: BeadShape.Stadium);
        var toolpath = Plan(new PrintPath([new Vec3(0, 0, 0.2), new Vec3(10, 0, 0.2)], bead), new PrintPath([new Vec3(0, 5, 0.2), new Vec3(10, 5, 0.2)], bead));
        var mesh = ExtrusionMesh.Of(toolpath, 0, toolpath.Count);
        Assert.That(mesh.Moves.Distinct().Select(m => toolpath[m].Kind), Is.EqualTo(new[] { MoveKind.Print, MoveKind.Print }));
        Assert.That(ExtrusionMesh.Of(toolpath, 0, 0).Quads, Is.Empty);
        foreach (var (first, end) in new[] { (0, toolpath.Count + 1), (-1, 1), (2, 1) })
        {
            Assert.That(() => ExtrusionMesh.Of(toolpath, first, end),
                Throws.InstanceOf<ArgumentOutOfRangeException>().With.Property("ParamName").EqualTo("first"));
        }
    }

    [Test]
    public void A_gap_as_wide_as_an_extrusion_stays_open()
    {
        var bead = Bead.FromWidth(0.6, 0.2, shape: BeadShape.Stadium);
        var mesh = Of(new PrintPath([new Vec3(0, 0, 0.2), new Vec3(10, 0, 0.2)], bead), new PrintPath([new Vec3(10.6, 0, 0.2), new Vec3(20.6, 0, 0.2)], bead));
        Assert.That(mesh.Vertices, Has.Count.EqualTo(4 * 8), "Two tubes of two rings.");
        Assert.That(mesh.Vertices.Any(v => v.X > 10.1 && v.X < 10.5), Is.False);
    }

    [Test]
    public void Arcs_are_followed()
    {
        var bead = Bead.FromWidth(0.6, 0.2, shape: BeadShape.Stadium);
        var circle = new PrintPath([new Vec3(10, 0, 0.2), new Vec3(0, 10, 0.2)], [bead], false, [new Arc(Vec3.Zero, 90)]) { Layer = new Layer(0, 0.2, 0.2) };
        var mesh = Of(circle);
        Assert.That(IsClosed(mesh), Is.True);
        Assert.That(mesh.Vertices.Select(v => v.LengthXY), Has.All.InRange(9.6, 10.4));
        Assert.That(Volume(mesh), Is.EqualTo(0.9 * 0.6 * 0.2 * 5 * Math.PI).Within(1).Percent);
    }

    [Test]
    public void An_extrusion_straight_up_has_its_width_along_Y_and_stays_closed()
    {
        var bead = Bead.FromWidth(0.6, 0.2, shape: BeadShape.Stadium);
        var up = Of(new PrintPath([new Vec3(10, 10, 0.2), new Vec3(10, 10, 5.2)], bead) { Layer = new Layer(0, 0.2, 0.2) });
        var box = Bounds.Of(up.Vertices);
        Assert.That((box.Size.X, box.Size.Y), Is.EqualTo((0.0, 0.6)).Within(1e-9));
        Assert.That(box.Max.Z, Is.EqualTo(5.2).Within(1e-9));
        Assert.That(IsClosed(up), Is.True);
    }
}
