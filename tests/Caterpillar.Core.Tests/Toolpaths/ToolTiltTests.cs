using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Curved;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

public class ToolTiltTests
{
    [TestCase(TiltAxes.BC)]
    [TestCase(TiltAxes.AC)]
    public void The_words_turn_the_tool_onto_the_normal(TiltAxes axes)
    {
        for (var azimuth = -170; azimuth <= 180; azimuth += 35)
        {
            var normal = new Vec3(Angle.Cos(azimuth) * Angle.Sin(30), Angle.Sin(azimuth) * Angle.Sin(30), Angle.Cos(30));
            var (tilt, turn) = new ToolTilt(axes).Angles(normal * 3);
            double s = Angle.Sin(tilt), c = Angle.Cos(tilt);
            var tool = axes == TiltAxes.BC ? new Vec3(s * Angle.Cos(turn), s * Angle.Sin(turn), c) : new Vec3(s * Angle.Sin(turn), -s * Angle.Cos(turn), c);
            Assert.That(tool.DistanceTo(normal), Is.LessThan(1e-12), $"azimuth {azimuth}");
            var words = (axes == TiltAxes.AC ? tilt : 0, axes == TiltAxes.BC ? tilt : 0, turn);
            Assert.That(ToolTilt.Direction(axes, words).DistanceTo(normal), Is.LessThan(1e-12));
        }
    }

    [Test]
    public void The_turn_stays_next_to_the_one_before_and_the_tilt_within_its_limit()
    {
        var tilt = new ToolTilt(TiltAxes.BC, 20);
        Assert.That(tilt.Angles(new Vec3(-1, -0.01, 1), 170).Turn, Is.EqualTo(180.57).Within(0.01));
        Assert.That(tilt.Angles(new Vec3(1, 0, 1), 725), Is.EqualTo((20, 720)));
        Assert.That(tilt.Angles(Vec3.UnitZ, 33), Is.EqualTo((0, 33)), "An upright tool keeps its turn.");
        Assert.That(() => new ToolTilt(TiltAxes.BC, 0).Angles(Vec3.UnitZ), Throws.InvalidOperationException);
    }

    [Test]
    public void Layers_of_a_tilted_plane_are_printed_with_the_tool_along_their_normal()
    {
        var setup = new PrintSetup().With("layer_height_mm=1", "first_layer_height_mm=1", "curved_max_gap_mm=2", "line_width_mm=2", "skirt_loops=0").OrThrow();
        var block = TriMesh.Create(
            [new(100, 100, 0), new(120, 100, 4), new(120, 110, 4), new(100, 110, 0), new(100, 100, 2), new(120, 100, 6), new(120, 110, 6), new(100, 110, 2)],
            [0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7]);
        var sliced = CurvedSlicer.Slice([new NamedMesh("block", block)], LayerField.Vertical(PlanSurface.Of((x, _) => 0.2 * (x - 100))), setup).OrThrow();
        var planned = new ToolTilt(TiltAxes.BC).Apply(Planner.Plan(sliced.ToSteps(), setup).OrThrow(), sliced.Field.Normal);
        var bytes = GCodeWriter.ToBytes(planned);
        // The tool leans to −x by the angle of the slope, 11.31 degrees.
        Assert.That(System.Text.Encoding.ASCII.GetString(bytes), Does.Contain(" B11.31 C180"));
        var decoded = GCodeDecoder.Decode(GCodeDocument.FromBytes(bytes)).OrThrow().Toolpath;
        var wanted = decoded.Moves().Where(m => m.Kind == MoveKind.Print).ToArray();
        Assert.That(wanted, Has.Length.EqualTo(planned.Moves().Count(m => m.Kind == MoveKind.Print)));
        var block2 = decoded.Blocks[decoded.Blocks.Count - 1].Columns;
        Assert.That((block2.B![block2.Count - 1], block2.C![block2.Count - 1]), Is.EqualTo((11.31, 180.0)));
    }

    [TestCase(TiltAxes.BC)]
    [TestCase(TiltAxes.AC)]
    public void A_file_gives_the_directions_of_the_tool_back(TiltAxes axes)
    {
        static Vec3 Normal(Vec3 p) => new Vec3(0.3 * Angle.Sin(3 * p.X), 0.2 * Angle.Cos(5 * p.Y), 1).Unit();
        var points = Enumerable.Range(0, 200).Select(i => new Vec3(100 + 30 * Angle.Cos(5 * i), 100 + 0.2 * i, 0.2)).ToArray();
        var setup = new PrintSetup();
        var planned = Planner.Plan([new PrintPath(points, new Bead(0.08, 0.2, 30))], setup).OrThrow();
        Assert.That((planned.HasTurns, ToolTilt.AxesOf(planned), planned.TurnsOf(0)), Is.EqualTo((false, (TiltAxes?)null, ((double, double, double)?)null)));
        var tilted = new ToolTilt(axes).Apply(planned, Normal);
        var decoded = GCodeDecoder.Decode(GCodeDocument.FromBytes(GCodeWriter.ToBytes(tilted))).OrThrow().Toolpath;
        Assert.That(ToolTilt.AxesOf(decoded), Is.EqualTo(axes));
        foreach (var move in decoded.Moves().Where(m => m.Kind == MoveKind.Print))
        {
            var tool = ToolTilt.Direction(axes, decoded.TurnsOf(move.Index)!.Value);
            Assert.That(tool.DistanceTo(Normal(move.End)), Is.LessThan(1e-4), "three decimals of words, and of the place");
        }
        Assert.That(() => decoded.TurnsOf(decoded.Count), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [Test]
    public void Both_tilting_words_are_another_kind_of_machine()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(new Vec3(1, 0, 0), 0, 0, 10, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.SetRotary(10, 20, 0);
        Assert.That(ToolTilt.AxesOf(builder.Build([new ToolpathTool(1)])), Is.Null);
    }

    [Test]
    public void Arcs_become_chords_that_keep_their_circle_their_material_and_the_normal_of_each_place()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(10, 0, 0));
        builder.Add(new Vec3(-10, 0, 0), 4, 4, 20, MoveKind.Print, Role.OuterWall, -1, 0, 0, new Arc(Vec3.Zero, 180));
        // The normal leans outward by 10 degrees everywhere.
        var tilted = new ToolTilt(TiltAxes.BC).Apply(builder.Build([new ToolpathTool(1)]), p => (p.Unit() * Angle.Sin(10) + Vec3.UnitZ * Angle.Cos(10)));
        var moves = tilted.Moves().ToArray();
        Assert.That(moves, Has.Length.GreaterThan(10));
        Assert.That(moves.Select(m => m.End.Length), Is.All.EqualTo(10).Within(1e-9));
        Assert.That(moves.Zip(moves.Skip(1), (a, b) => Angle.Atan2(b.End.Y, b.End.X) - Angle.Atan2(a.End.Y, a.End.X)),
            Is.All.EqualTo(180.0 / moves.Length).Within(1e-9));
        Assert.That((moves.Sum(m => m.E), moves.Sum(m => m.Deposited)), Is.EqualTo((4.0, 4.0)).Within(1e-9));
        var columns = tilted.Blocks.Single().Columns;
        for (var i = 0; i < moves.Length; i++)
        {
            Assert.That(columns.B![i], Is.EqualTo(10).Within(1e-9));
            Assert.That(columns.C![i], Is.EqualTo(180.0 * (i + 1) / moves.Length).Within(1e-9));
        }
    }
}
