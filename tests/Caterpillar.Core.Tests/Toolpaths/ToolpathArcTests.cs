using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

/// <summary>Arcs in toolpaths and paths: where they are found, and what becomes of them.</summary>
public class ToolpathArcTests
{
    [Test]
    public void A_run_of_even_extrusions_becomes_one_arc_with_its_material_and_events_keep_their_place()
    {
        var before = Circle(null, (0, new CommentEvent("a")), (22, new CommentEvent("b")));
        var after = before.FitArcs();
        Assert.That(after.Moves().Select(m => m.Kind), Is.EqualTo(new[] { MoveKind.Travel, MoveKind.Print, MoveKind.Travel }));
        Assert.That(after[1].Arc!.Value.Center.DistanceTo(Vec3.Zero), Is.LessThan(1e-9));
        Assert.That(after[1].Arc!.Value.Sweep, Is.EqualTo(100).Within(1e-9));
        Assert.That((after[1].E, after[1].Deposited), Is.EqualTo((before.Moves().Sum(m => m.E), before.Moves().Sum(m => m.E))).Within(1e-12));
        Assert.That((after[1].Speed, after[1].Role, after[1].Layer, after[1].Tool, after[1].Source), Is.EqualTo((20.0, Role.OuterWall, 0, 1, 11)));
        Assert.That(after.Events.Select(e => e.Move), Is.EqualTo(new[] { 0, 3 }));
        Assert.That(after[2].Start, Is.EqualTo(before[20].End));
    }

    [Test]
    public void An_arc_ends_where_role_layer_tool_speed_source_or_flow_change()
    {
        var changes = new Func<Move, Move>[]
        {
            m => m with { Role = Role.InnerWall }, m => m with { Layer = 1 }, m => m with { Tool = 0 }, m => m with { Speed = 21 },
            m => m with { Source = m.Source + 100 }, m => m with { E = m.E * 1.03, Deposited = m.Deposited * 1.03 },
            m => m with { E = m.E * 0.97, Deposited = m.Deposited * 0.97 },
        };
        foreach (var change in changes)
        {
            var after = Circle(m => m.Index >= 11 ? change(m) : m).FitArcs();
            Assert.That(after.Moves().Where(m => m.Arc is not null).Select(m => m.Arc!.Value.Sweep), Is.EqualTo(new[] { 50.0, 50 }).Within(1e-9));
        }
        // E that deposits other than it says is no plain extrusion.
        Assert.That(Circle(m => m with { Deposited = m.E / 2 }).FitArcs().Moves().Any(m => m.Arc is not null), Is.False);
        Assert.That(Circle(m => m.Kind == MoveKind.Print ? m with { Kind = MoveKind.Wipe } : m).FitArcs().Moves().Any(m => m.Arc is not null), Is.False);
        // Lines of a file may give several moves each.
        Assert.That(Circle(m => m with { Source = m.Source / 2 }).FitArcs().Count, Is.EqualTo(3));
    }

    [TestCase(1, 1.02, 1)]
    [TestCase(1, 1.03, 2)]
    [TestCase(20, 1.02, 1)]
    [TestCase(20, 0.98, 1)]
    [TestCase(20, 1.03, 2)]
    public void Extrusions_of_an_arc_are_even_to_two_percent(double size, double flow, int arcs)
    {
        var toolpath = Circle(m => m with { End = m.End * size, E = m.Index >= 11 ? m.E * flow : m.E, Deposited = m.Index >= 11 ? m.E * flow : m.E });
        Assert.That(toolpath.FitArcs(0.5).Moves().Count(m => m.Arc is not null), Is.EqualTo(arcs));
    }

    [Test]
    public void An_arc_may_be_the_first_move()
    {
        var builder = new ToolpathBuilder(MoveSource.Lines, new Vec3(10, 0));
        foreach (var m in Circle(null).Moves().Where(m => m.Kind == MoveKind.Print))
            builder.Add(m.End, m.E, m.Deposited, m.Speed, m.Kind, m.Role, -1, 0, m.Source);
        var arc = builder.Build([]).FitArcs().Moves().Single();
        Assert.That((arc.Start, arc.Arc!.Value.Sweep), Is.EqualTo((new Vec3(10, 0), 100.0)).Within(1e-9));
    }

    [Test]
    public void An_event_among_extrusions_ends_an_arc()
    {
        var after = Circle(null, (11, new FanEvent(1))).FitArcs();
        Assert.That(after.Moves().Where(m => m.Arc is not null).Select(m => m.Arc!.Value.Sweep), Is.EqualTo(new[] { 50.0, 50 }).Within(1e-9));
        Assert.That(after.Events.Single().Move, Is.EqualTo(2));
    }

    [Test]
    public void Blocks_without_arcs_are_shared_and_rotary_moves_stay()
    {
        var straight = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var i = 1; i < 9; i++) straight.Add(new Vec3(i, 0), 1, 1, 10, MoveKind.Print, Role.Infill, -1, 0, i);
        var before = straight.Build([]);
        Assert.That(before.FitArcs().Blocks[0], Is.SameAs(before.Blocks[0]));
        var turned = new ToolpathBuilder(MoveSource.Steps, null);
        foreach (var m in Circle(null).Moves())
        {
            turned.Add(m.End, m.E, m.Deposited, m.Speed, m.Kind, m.Role, m.Layer, m.Tool, m.Source);
            turned.SetRotary(new Vec3(m.Index, 0, 0));
        }
        Assert.That(turned.Build([]).FitArcs().Moves().Any(m => m.Arc is not null), Is.False);
    }

    [Test]
    public void Chords_of_an_arc_have_an_area_even_with_a_wide_tolerance()
    {
        var bead = new Bead(0.1);
        PrintPath Turn(double sweep, bool closed)
        {
            var (sin, cos) = Angle.SinCos(sweep);
            Vec3[] points = [new(5, 0), new(5 * cos, 5 * sin)];
            return closed ? new PrintPath(points, [bead, new Bead(0.2)], true, [new Arc(Vec3.Zero, sweep), null])
                : new PrintPath(points, [bead], false, [new Arc(Vec3.Zero, sweep)]);
        }
        Assert.That(PathArcs.Expand(Turn(170, false), 100).SegmentCount, Is.EqualTo(1));
        Assert.That(PathArcs.Expand(Turn(180, false), 100).SegmentCount, Is.EqualTo(1));
        Assert.That(PathArcs.Expand(Turn(181, false), 100).SegmentCount, Is.EqualTo(3));
        Assert.That(PathArcs.Expand(Turn(-181, false), 100).SegmentCount, Is.EqualTo(3));
        var closed = PathArcs.Expand(Turn(90, true), 100);
        Assert.That((closed.SegmentCount, closed.IsClosed), Is.EqualTo((3, true)), "two chords and the line that closes them");
        Assert.That(Enumerable.Range(0, 3).Select(i => closed.BeadOf(i).Area), Is.EqualTo(new[] { 0.1, 0.1, 0.2 }));
        Assert.That(closed.Points[1].DistanceTo(new Vec3(5 * Math.Sqrt(0.5), 5 * Math.Sqrt(0.5))), Is.LessThan(1e-12));
        var path = new PrintPath([Vec3.Zero, Vec3.UnitX], bead);
        Assert.That(PathArcs.Expand(path), Is.SameAs(path));
        Assert.That(() => PathArcs.Expand(path, 0), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [TestCase(5.0, 0.01, 180.0, 25)]
    [TestCase(5.0, 0.01, -180.0, 25)]
    [TestCase(5.0, 4.9, 180.0, 2)]
    [TestCase(5.0, 5.0, 180.0, 1)]
    [TestCase(5.0, 5.0, 360.0, 2)]
    [TestCase(0.0, 0.01, 360.0, 2)]
    [TestCase(5.0, 0.01, 0.0, 1)]
    [TestCase(5.0, 1e-30, 1e12, 1000000)]
    public void The_number_of_chords_keeps_their_sagitta_within_the_tolerance(double radius, double tolerance, double sweep, int chords)
    {
        var arc = new Arc(Vec3.Zero, sweep);
        // 5 (1 - cos 3.624°) = 0.01: half a turn has 24.8 chords of twice that.
        Assert.That(arc.ChordCount(new Vec3(radius, 0), tolerance), Is.EqualTo(chords));
        Assert.That(arc.ChordCount(Vec3.Zero, new Vec3(radius, 0), tolerance), Is.EqualTo(chords).Or.GreaterThan(1));
        Assert.That(() => arc.ChordCount(new Vec3(radius, 0), 0), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [TestCase(0.0, 1)]
    [TestCase(360.0, 1)]
    [TestCase(-360.0003, 1)]
    [TestCase(360.01, 2)]
    [TestCase(-721.0, 3)]
    [TestCase(1e12, 1000000)]
    public void Turns_of_an_arc_are_rounded_up(double sweep, int turns) => Assert.That(new Arc(Vec3.Zero, sweep).Turns, Is.EqualTo(turns));

    [TestCase(ArcPlane.XY)]
    [TestCase(ArcPlane.ZX)]
    [TestCase(ArcPlane.YZ)]
    public void The_box_of_an_arc_holds_its_extremes(ArcPlane plane)
    {
        // In its plane from 5 to the right, around by 200 degrees; across the plane from 1 to 3.
        Vec3 World(double u, double v, double w) => plane switch { ArcPlane.XY => new(u, v, w), ArcPlane.ZX => new(v, w, u), _ => new(w, u, v) };
        var arc = new Arc(World(0, 0, 77), 200, plane);
        var (sin, cos) = Angle.SinCos(200);
        var (start, end) = (World(5, 0, 1), World(5 * cos, 5 * sin, 3));
        var box = arc.Bounds(start, end);
        Assert.That(box.Min.DistanceTo(World(-5, 5 * sin, 1)), Is.LessThan(1e-12));
        Assert.That(box.Max.DistanceTo(World(5, 5, 3)), Is.LessThan(1e-12));
        Assert.That(arc.Reversed().Bounds(end, start).Max.DistanceTo(box.Max), Is.LessThan(1e-12));
        Assert.That(arc.Radius(start), Is.EqualTo(5));
        Assert.That(arc.Length(start, end), Is.EqualTo(Math.Sqrt(Math.Pow(5 * Math.PI * 200 / 180, 2) + 4)).Within(1e-12));
        Assert.That(arc.PointAt(start, end, 0.45).DistanceTo(World(0, 5, 1.9)), Is.LessThan(1e-12));
        Assert.That((arc.PointAt(start, end, 0), arc.PointAt(start, end, 1)), Is.EqualTo((start, end)));
        // An end farther out is reached by a linear change of the radius.
        Assert.That(new Arc(World(0, 0, 0), 90, plane).PointAt(World(4, 0, 1), World(0, 6, 1), 0.5)
            .DistanceTo(World(5 * Math.Sqrt(0.5), 5 * Math.Sqrt(0.5), 1)),
            Is.LessThan(1e-12));
        Assert.That(new Arc(World(5, 0, 1), 200, plane).Bounds(World(5, 0, 1), World(5, 0, 2)).Size.DistanceTo(World(0, 0, 1)), Is.LessThan(1e-12));
    }

    // A travel to (10, 0), twenty extrusions of 5 degrees around the origin, and a travel.
    private static Toolpath Circle(Func<Move, Move>? change, params (int Move, PrinterEvent What)[] events)
    {
        var builder = new ToolpathBuilder(MoveSource.Lines, Vec3.Zero);
        builder.AddLayer(new Layer(0, 1));
        builder.AddLayer(new Layer(1, 2));
        for (var i = 0; i < 22; i++)
        {
            foreach (var (move, what) in events) if (move == i) builder.AddEvent(what);
            var (sin, cos) = Angle.SinCos(5 * i);
            var m = i is 0 or 21 ? new Move(i, default, new Vec3(10 + i, 0), 0, 0, 100, MoveKind.Travel, Role.Unspecified, 0, 1, 10 + i, null)
                : new Move(i, default, new Vec3(10 * cos, 10 * sin), 0.5, 0.5, 20, MoveKind.Print, Role.OuterWall, 0, 1, 10 + i, null);
            if (change is not null && m.Kind == MoveKind.Print) m = change(m);
            builder.Add(m.End, m.E, m.Deposited, m.Speed, m.Kind, m.Role, m.Layer, m.Tool, m.Source);
        }
        foreach (var (move, what) in events) if (move == 22) builder.AddEvent(what);
        return builder.Build([new ToolpathTool(1), new ToolpathTool(1)]);
    }
}
