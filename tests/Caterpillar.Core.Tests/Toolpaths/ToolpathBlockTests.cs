using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

/// <summary>Moves are kept in blocks of columns, which grow and are sealed.</summary>
public class ToolpathBlockTests
{
    [Test]
    public void Every_column_of_a_growing_block_keeps_its_values()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(9, 8, 7));
        for (var layer = 0; layer < 4; layer++) Assert.That(builder.AddLayer(new Layer(layer, 0.2 * (layer + 1))), Is.EqualTo(layer));
        var expected = Enumerable.Range(0, 1500).Select(Numbered).ToArray();
        foreach (var move in expected)
        {
            Assert.That(builder.Count, Is.EqualTo(move.Index));
            Assert.That(builder.Position, Is.EqualTo(move.Start));
            builder.Line = move.Index % 2 == 0 ? move.Index + 1 : 0;
            builder.Add(move.End, move.E, move.Deposited, move.Speed, move.Kind, move.Role, move.Layer, move.Tool, move.Source, move.Arc);
            builder.SetRotary(new Vec3(move.Index, move.Index + 0.1, move.Index + 0.2));
        }
        var toolpath = builder.Build([new ToolpathTool(1)]);
        Assert.That(toolpath.Count, Is.EqualTo(1500));
        Assert.That(toolpath.Moves(), Is.EqualTo(expected));
        var columns = toolpath.Blocks.Single().Columns;
        for (var i = 0; i < 1500; i++)
        {
            Assert.That(toolpath[i], Is.EqualTo(expected[i]));
            Assert.That(columns.Turns![i], Is.EqualTo(new Vec3(i, i + 0.1, i + 0.2)));
            Assert.That(columns.Line![i], Is.EqualTo(i % 2 == 0 ? i + 1 : 0));
        }
    }

    [Test]
    public void A_block_ends_at_its_capacity_and_numbers_go_on()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(9, 8, 7));
        for (var layer = 0; layer < 4; layer++) builder.AddLayer(new Layer(layer, 1));
        for (var i = 0; i < ToolpathBlock.Capacity + 3; i++)
        {
            var move = Numbered(i);
            builder.Add(move.End, move.E, move.Deposited, move.Speed, move.Kind, move.Role, move.Layer, move.Tool, move.Source, move.Arc);
        }
        Assert.That(builder.Count, Is.EqualTo(65_539));
        builder.AddEvent(new CommentEvent("end"), 12);
        var toolpath = builder.Build([]);
        Assert.That(toolpath.Blocks.Select(b => b.Count), Is.EqualTo(new[] { 65_536, 3 }));
        foreach (var i in new[] { 0, 65_535, 65_536, 65_537, 65_538 }) Assert.That(toolpath[i], Is.EqualTo(Numbered(i)));
        Assert.That(toolpath.Moves().Last(), Is.EqualTo(Numbered(65_538)));
        Assert.That((toolpath.Events.Single().Move, toolpath.Events.Single().Source), Is.EqualTo((65_539, 12)));
        Assert.That(() => toolpath[65_539], Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => toolpath[-1], Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    // 72 bytes a move: the second block would bring them to 131,072 moves.
    [TestCase(131_072 * 72, true)]
    [TestCase(131_072 * 72 - 1, false)]
    public void A_further_block_is_begun_only_within_the_limit_of_memory(int bytes, bool fits)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, null) { Memory = new MemoryLimit(bytes) };
        for (var i = 0; i < 65_536; i++) builder.Add(Vec3.Zero, 0, 0, 1, MoveKind.Travel, Role.Unspecified, -1, 0, i);
        void One() => builder.Add(Vec3.Zero, 0, 0, 1, MoveKind.Travel, Role.Unspecified, -1, 0, 65_536);
        if (fits) Assert.That(One, Throws.Nothing);
        else Assert.That(One, Throws.InstanceOf<DiagnosticException>().With.Message.Contains("A toolpath of more than 65536 moves"));
    }

    [Test]
    public void Rotary_axes_and_lines_that_come_late_are_zero_before()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, null);
        builder.Add(Vec3.UnitX, 0, 0, 1, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.Line = 5;
        builder.Add(Vec3.UnitY, 0, 0, 1, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.SetRotary(new Vec3(1, 2, 3));
        var columns = builder.Build([]).Blocks[0].Columns;
        Assert.That((columns.Turns![0], columns.Line![0]), Is.EqualTo((Vec3.Zero, 0)));
        Assert.That((columns.Turns[1], columns.Line[1]), Is.EqualTo((new Vec3(1, 2, 3), 5)));
    }

    // Ten extrusions of one step, each of another line of the script, in two layers.
    [Test]
    public void Edits_of_a_design_keep_the_line_of_the_script_of_each_move()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        foreach (var z in new[] { 0.2, 0.4 }) builder.AddLayer(new Layer(z < 0.3 ? 0 : 1, z, 0.2));
        for (var i = 0; i < 10; i++)
        {
            builder.Line = 20 + i;
            var (sin, cos) = Angle.SinCos(i);
            builder.Add(new Vec3(50 * cos, 50 * sin, i < 8 ? 0.2 : 0.4), 1, 1, 20, MoveKind.Print, i == 5 ? Role.Infill : Role.OuterWall, i < 8 ? 0 : 1, 0, 0);
        }
        var toolpath = builder.Build([new ToolpathTool(2.4)], [new SourceLocation("a.turtle", 3)]);
        int?[] Lines(Toolpath edited)
            => Enumerable.Range(0, edited.Count).Where(i => edited[i].Kind == MoveKind.Print).Select(i => edited.PlaceOf(i)?.Line).ToArray();
        var all = Enumerable.Range(20, 10).Select(i => (int?)i).ToArray();
        Assert.That(Lines(toolpath), Is.EqualTo(all));
        var infill = new MoveFilter { Roles = new HashSet<Role> { Role.Infill } };
        Assert.That(Lines(toolpath.Remove(infill)), Is.EqualTo(all.Where(l => l != 25)));
        Assert.That(Lines(toolpath.Deform(infill, p => p + new Vec3(0, 0, 1))), Is.Ordered.And.SupersetOf(all).And.SubsetOf(all));
        Assert.That(Lines(toolpath.PauseAtLayer(1, null).OrThrow()), Is.EqualTo(all));
        var fitted = toolpath.FitArcs(evenness: 0.5);
        Assert.That(fitted.Count, Is.LessThan(10));
        Assert.That(Lines(fitted), Is.Ordered.And.SubsetOf(all));
    }

    [Test]
    public void The_place_of_a_move_is_its_step_with_the_line_of_the_script_else_its_layer()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, null);
        builder.AddLayer(new Layer(7, 1, 0.2, "cup"));
        builder.AddLayer(new Layer(8, 1));
        void Add(int source, int line, int layer)
        {
            builder.Line = line;
            builder.Add(Vec3.UnitX, 0, 0, 1, MoveKind.Travel, Role.Unspecified, layer, 0, source);
        }
        Add(0, 0, 0);
        Add(1, 0, 0);
        Add(1, 42, 0);
        Add(2, 42, 1);
        Add(-1, 42, -1);
        var toolpath = builder.Build([], [null, new SourceLocation("a.turtle", 3)]);
        var layer = new SourceLocation("cup", Layer: 7);
        Assert.That(Enumerable.Range(0, 5).Select(toolpath.PlaceOf), Is.EqualTo(new[]
        {
            layer, new SourceLocation("a.turtle", 3), new SourceLocation("a.turtle", 42), new SourceLocation(null, Layer: 8), null,
        }));
        var moved = toolpath.Transform(Affine.Move(new Vec3(5, 0)));
        Assert.That(Enumerable.Range(0, 5).Select(moved.PlaceOf), Is.EqualTo(Enumerable.Range(0, 5).Select(toolpath.PlaceOf)));
        Assert.That(() => toolpath.PlaceOf(5), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => toolpath.PlaceOf(-1), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [Test]
    public void Beads_of_moves_need_length_volume_and_a_known_tool()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, null);
        builder.AddLayer(new Layer(0, 0.2, 0.2));
        void Add(double x, double deposited, double speed, MoveKind kind = MoveKind.Print, int layer = 0, int tool = 0)
            => builder.Add(new Vec3(x, 0), deposited, deposited, speed, kind, Role.Infill, layer, tool, 0);
        Add(4, 2, 30);
        Add(4, 2, 30);
        Add(8, 2, 30, MoveKind.Travel);
        Add(12, 2, 30, tool: 1);
        Add(16, 2, 30, tool: 2);
        Add(20, -2, 30);
        Add(24, 2, -1, layer: -1);
        Add(28, 0, double.PositiveInfinity);
        Add(32, 2, 0);
        var toolpath = builder.Build([new ToolpathTool(3), new ToolpathTool(null)]);
        // 2 of E are 6 mm³ over 4 mm.
        Assert.That(toolpath.Moves().Select(toolpath.BeadOf), Is.EqualTo(new Bead?[]
        {
            new Bead(1.5, 0.2, 30), null, null, null, null, null, new Bead(1.5), new Bead(0, 0.2), new Bead(1.5, 0.2),
        }));
        Assert.That(new[] { -1, 0, 1, 2 }.Select(toolpath.VolumePerE), Is.EqualTo(new double?[] { null, 3, null, null }));
    }

    [Test]
    public void Events_are_equal_where_the_same_happens_at_the_same_move()
    {
        var a = new MoveEvent(3, new FanEvent(0.5)) { Source = 1 };
        Assert.That(a, Is.EqualTo(new MoveEvent(3, new FanEvent(0.5)) { Source = 9 }));
        Assert.That(a.GetHashCode(), Is.EqualTo((a with { Source = 9 }).GetHashCode()));
        Assert.That(new MoveEvent(3, new FanEvent(0.5)).Source, Is.EqualTo(-1), "unless it is stated");
        Assert.That(a, Is.Not.EqualTo(new MoveEvent(4, new FanEvent(0.5))));
        Assert.That(a, Is.Not.EqualTo(new MoveEvent(3, new FanEvent(0.6))));
    }

    [Test]
    public void The_first_event_of_a_move_is_found_among_many()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, null);
        for (var i = 0; i < 10; i++)
        {
            for (var k = 0; k < i % 3; k++) builder.AddEvent(new CommentEvent("" + k));
            builder.Add(new Vec3(i, 0), 0, 0, 1, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        }
        var toolpath = builder.Build([]);
        // Moves 1, 4 and 7 have one event, 2, 5 and 8 two.
        Assert.That(Enumerable.Range(0, 11).Select(toolpath.FirstEventOf), Is.EqualTo(new[] { 0, 0, 1, 3, 3, 4, 6, 6, 7, 9, 9 }));
    }

    // Every value of a move tells its number.
    private static Move Numbered(int i)
    {
        static Vec3 End(int i) => i < 0 ? new Vec3(9, 8, 7) : new Vec3(i, 2 * i, 3 * i);
        return new Move(i, End(i - 1), End(i), i + 0.25, i + 0.5, i + 0.75, (MoveKind)(i % 8), (Role)(i % 18), i % 5 - 1, i % 4, i + 7,
            i % 3 == 0 ? new Arc(new Vec3(i, 1), 10 + i % 7) : null);
    }
}
