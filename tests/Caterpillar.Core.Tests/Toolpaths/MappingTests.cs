using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

public sealed class MappingTests
{
    private static readonly Bead Bead = new(0.08, 0.2, 40);

    private static PrintPath HalfCircle() => new([new Vec3(10, 0, 1), new Vec3(-10, 0, 1), new Vec3(-20, 0, 1)], [Bead, Bead], false,
        [new Arc(new Vec3(0, 0, 1), 180), null]);

    [Test]
    public void A_turned_and_scaled_path_keeps_its_arcs_and_its_beads()
    {
        var map = Affine.Rotate(Vec3.UnitZ, 90).Then(Affine.Scale(2)).Then(Affine.Move(new Vec3(1, 2, 3)));
        var image = (HalfCircle() with { Layer = new Layer(4, 1, 0.2) }).Transformed(map);
        Assert.That(image.Points.Select(p => (p - new Vec3(1, 2, 5)).ToString()), Is.EqualTo(new[] { "(0, 20, 0)", "(0, -20, 0)", "(0, -40, 0)" }));
        Assert.That(image.ArcOf(0)!.Value.Sweep, Is.EqualTo(180));
        Assert.That(image.Length, Is.EqualTo(2 * HalfCircle().Length).Within(1e-9));
        Assert.That(image.BeadOf(0), Is.EqualTo(Bead));
        Assert.That(image.Layer!.Z, Is.EqualTo(5).Within(1e-12));
        Assert.That(image.Layer.Thickness, Is.EqualTo(0.4).Within(1e-12));
    }

    [Test]
    public void A_mirror_reverses_arcs()
        => Assert.That(HalfCircle().Transformed(Affine.Scale(1, -1, 1)).ArcOf(0)!.Value.Sweep, Is.EqualTo(-180));

    [Test]
    public void A_stretch_turns_arcs_into_chords_of_the_ellipse()
    {
        var image = HalfCircle().Transformed(Affine.Scale(1, 3, 1));
        Assert.That(image.HasArcs, Is.False);
        foreach (var p in image.Points.Take(image.Points.Count - 1))
            Assert.That(p.X * p.X / 100 + p.Y * p.Y / 900, Is.EqualTo(1).Within(1e-9));
    }

    [Test]
    public void A_closed_path_stays_closed()
    {
        var square = new PrintPath([new(0, 0), new(1, 0), new(1, 1)], Bead, closed: true);
        var image = square.Transformed(Affine.Move(new Vec3(5, 0)));
        Assert.That(image.IsClosed && image.Points.Count == 3 && image.Start == new Vec3(5, 0), Is.True);
    }

    [Test]
    public void Extrusions_of_a_toolpath_are_scaled_as_solids_and_events_stay_at_their_moves()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        var layer = builder.AddLayer(new Layer(0, 0.2, 0.2));
        builder.Add(new Vec3(10, 0, 0.2), 0, 0, 100, MoveKind.Travel, Role.Unspecified, layer, 0, -1);
        builder.Add(new Vec3(10, 0, 0.2), 0.8, 0, 30, MoveKind.Deretract, Role.Unspecified, layer, 0, -1);
        builder.AddEvent(new FanEvent(1));
        builder.Add(new Vec3(20, 0, 0.2), 0.5, 0.5, 40, MoveKind.Print, Role.OuterWall, layer, 0, 7);
        builder.Add(new Vec3(10, 0, 0.2), 0.7, 0.7, 40, MoveKind.Print, Role.OuterWall, layer, 0, 8, new Arc(new Vec3(15, 0, 0.2), 180));
        builder.AddEvent(new CommentEvent("end"));
        var image = builder.Build([new ToolpathTool(2.4)]).Transform(Affine.Scale(2, 2, 1).Then(Affine.Move(new Vec3(0, 0, 1))));
        Assert.That(image.Moves().Select(m => m.E), Is.EqualTo(new[] { 0, 0.8, 2, 2.8 }).Within(1e-12));
        Assert.That(image[2].End, Is.EqualTo(new Vec3(40, 0, 1.2)));
        Assert.That(image[3].Arc, Is.Not.Null);
        Assert.That(image[3].Source, Is.EqualTo(8));
        Assert.That(image.Events.Select(e => e.Move), Is.EqualTo(new[] { 2, 4 }));
        Assert.That(image.Start, Is.EqualTo(new Vec3(0, 0, 1)));
        Assert.That(image.Layers[0].Z, Is.EqualTo(1.2).Within(1e-12));
    }

    [Test]
    public void Chords_of_an_arc_share_its_material_by_length()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(10, 0));
        builder.Add(new Vec3(-10, 0), 3, 3, 40, MoveKind.Print, Role.Unspecified, -1, 0, 0, new Arc(Vec3.Zero, 180));
        var image = builder.Build([new ToolpathTool(1)]).Transform(Affine.Scale(1, 2, 1));
        Assert.That(image.Moves().Sum(m => m.Deposited), Is.EqualTo(6).Within(0.005), "the solid is twice as large");
        // Along Y the extrusion is stretched and stays as wide; along X it gets twice as wide.
        var moves = image.Moves().ToArray();
        var ratio = 3 / (System.Math.PI * 10);
        Assert.That(moves[0].Deposited / moves[0].Length, Is.EqualTo(ratio).Within(1e-3));
        Assert.That(moves[moves.Length / 2].Deposited / moves[moves.Length / 2].Length, Is.EqualTo(2 * ratio).Within(1e-3));
    }

    [TestCase(0.5)]
    [TestCase(2)]
    public void Scaling_scales_areas_with_the_square_and_leaves_retractions(double scale)
    {
        var builder = new ToolpathBuilder(MoveSource.Lines, Vec3.Zero);
        builder.Add(new Vec3(0, 0, 0.2), 0, 0, 100, MoveKind.Travel, Role.Unspecified, -1, 0, 1);
        builder.Add(new Vec3(10, 0, 0.2), 0.5, 0.5, 40, MoveKind.Print, Role.OuterWall, -1, 0, 2);
        builder.Add(new Vec3(10, 0, 0.2), -0.8, 0, 30, MoveKind.Retract, Role.Unspecified, -1, 0, 3);
        builder.Add(new Vec3(13, 4, 0.7), 1.3, 0.5, 40, MoveKind.Print, Role.OuterWall, -1, 0, 4);
        var image = builder.Build([new ToolpathTool(2.4)]).Transform(Affine.Scale(scale));
        var e = image.Moves().Select(m => m.E).ToArray();
        Assert.That(e, Is.EqualTo(new[] { 0, 0.5 * scale * scale * scale, -0.8, 0.8 + 0.5 * scale * scale * scale }).Within(1e-12));
        Assert.That(image[1].Deposited / image[1].Length, Is.EqualTo(0.05 * scale * scale).Within(1e-12));
    }

    [Test]
    public void Turns_and_shifts_leave_amounts_as_they_are()
    {
        var builder = new ToolpathBuilder(MoveSource.Lines, Vec3.Zero);
        builder.Add(new Vec3(10, 3, 0.2), 0.512345, 0.512345, 40, MoveKind.Print, Role.OuterWall, -1, 0, 2);
        var image = builder.Build([new ToolpathTool(2.4)]).Transform(Affine.Rotate(Vec3.UnitZ, 33).Then(Affine.Move(new Vec3(1, 2, 3))));
        Assert.That(image[0].E, Is.EqualTo(0.512345).Within(1e-12));
    }
}
