using System;
using System.Linq;
using System.Threading;
using Caterpillar.Flavors;
using Caterpillar.Basics;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

/// <summary>Which moves follow a map, what becomes of those around them, and rotary words.</summary>
public class MappedMoveTests
{

    [Test]
    public void Homing_stays_at_the_switches_when_all_is_shifted()
    {
        var before = Decode("G28\nG0 X5 Y5 Z1 F600\nG1 X9 E1\nG28 X\nG1 X7 E1\n");
        var after = before.Transform(Affine.Move(new Vec3(10, 20, 3)));
        Assert.That(after.Moves().Select(m => (m.Kind, m.End)), Is.EqualTo(new[]
        {
            (MoveKind.Travel, new Vec3(15, 25, 4)), (MoveKind.Print, new Vec3(19, 25, 4)), (MoveKind.Travel, new Vec3(0, 25, 4)),
            (MoveKind.Print, new Vec3(17, 25, 4)),
        }));
    }

    // What happens in place after an extrusion that stays does so too, also after the very first move.
    [TestCase(0)]
    [TestCase(1)]
    public void Moves_in_place_after_a_extrusion_that_stays_are_not_mapped(int travels)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        void Add(double x, double e, MoveKind kind, Role role) => builder.Add(new Vec3(x, 0), e, Math.Max(e, 0), 10, kind, role, -1, 0, 0);
        if (travels > 0) Add(1, 0, MoveKind.Travel, Role.Unspecified);
        Add(5, 1, MoveKind.Print, Role.Support);
        Add(5, -1, MoveKind.Retract, Role.Unspecified);
        Add(9, 2, MoveKind.Print, Role.OuterWall);
        var after = builder.Build([]).Transform(new MoveFilter { Roles = [Role.OuterWall] }, Affine.Move(new Vec3(0, 7)));
        Assert.That(after.Moves().Skip(travels).Select(m => m.End), Is.EqualTo(new[] { new Vec3(5, 0), new Vec3(5, 0), new Vec3(9, 7) }));
    }

    [Test]
    public void The_chosen_moves_between_chosen_extrusions_are_mapped_with_what_happens_in_place()
    {
        // Wall, retraction, travel, restoring, wall, infill, wall.
        var before = Typed("Outer wall", "G0 X10 Y0", "G1 X20 E1", "G1 E-1", "G0 X20 Y10", "G1 E1", "G1 X10 E1")
            + "\n;TYPE:Sparse infill\nG1 X0 E1\n;TYPE:Outer wall\n"
            + "G1 X-5 E1\nG0 X50\n";
        var toolpath = Decode(before);
        bool[] Mapped(MoveFilter filter) => MappedMoves.Of(toolpath, filter).ToArray(toolpath.Count);
        Assert.That(toolpath.Moves().Select(m => m.Role == Role.OuterWall && m.Kind == MoveKind.Print), Is.EqualTo(
            new[] { false, true, false, false, false, true, false, true, false }));
        // All walls: kinds in between are not of the role, so only extrusions and the moves in place at their ends.
        Assert.That(Mapped(new MoveFilter { Kinds = [MoveKind.Print], Roles = [Role.OuterWall] }),
            Is.EqualTo(new[] { false, true, true, false, true, true, false, true, false }));
        Assert.That(Mapped(new MoveFilter()), Is.EqualTo(new[] { false, true, true, true, true, true, true, true, false }));
        Assert.That(MappedMoves.All(toolpath).ToArray(toolpath.Count), Is.All.True);
    }

    [Test]
    public void Travels_lead_to_the_new_start_and_extrusions_beside_are_stretched_with_their_flow()
    {
        var before = Decode(Typed("Outer wall", "G0 X10 Y0", "G1 X20 E1") + "\n;TYPE:Sparse infill\nG1 X20 Y10 E1\nG0 X0 Y50\n");
        var after = before.Transform(new MoveFilter { Roles = [Role.OuterWall], Kinds = [MoveKind.Print] }, Affine.Move(new Vec3(0, -10)));
        Assert.That(after.Moves().Select(m => (m.End, m.E)), Is.EqualTo(new[]
        {
            (new Vec3(10, -10), 0.0), (new Vec3(20, -10), 1), (new Vec3(20, 10), 2), (new Vec3(0, 50), 0),
        }));
    }

    [Test]
    public void What_is_restored_along_a_extrusion_stays_at_its_first_piece()
    {
        // 2 of 5 restore, 3 are deposited over 10 mm.
        var before = Decode("G0 X0 Y0 F600\nG1 E-2\nG1 X10 E5\n");
        var after = before.Deform(new MoveFilter(), p => new Vec3(p.X, p.X * p.X / 20, 0), 0.05).Moves().Where(m => m.Kind == MoveKind.Print).ToArray();
        Assert.That(after, Has.Length.GreaterThan(3));
        for (var i = 0; i < after.Length; i++)
        {
            Assert.That(after[i].Deposited, Is.EqualTo(0.3 * after[i].Length).Within(1e-9));
            Assert.That(after[i].E - after[i].Deposited, Is.EqualTo(i == 0 ? 2 : 0).Within(1e-9));
        }
    }

    [TestCase(true)]
    [TestCase(false)]
    public void Amounts_of_other_moves_are_shared_by_length(bool keepsCircles)
    {
        // A wipe along half a circle of 4 E.
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(5, 0));
        builder.Add(new Vec3(-5, 0), -4, 0, 10, MoveKind.Wipe, Role.Unspecified, -1, 0, 0, new Arc(Vec3.Zero, 180));
        var after = builder.Build([]).Transform(keepsCircles ? Affine.Scale(2) : Affine.Scale(2, 1, 1), 0.1);
        Assert.That(after.Moves().Sum(m => m.E), Is.EqualTo(-4).Within(1e-12));
        Assert.That(after.Moves().Select(m => m.E).Distinct().Count(), Is.EqualTo(1));
        Assert.That(after.Count, keepsCircles ? Is.EqualTo(1) : Is.GreaterThan(5));
        Assert.That(after[0].Arc is null, Is.EqualTo(!keepsCircles));
    }

    [Test]
    public void Maps_that_keep_circles_and_lengths_are_told_apart()
    {
        Assert.That(Mapping.KeepsCircles(Affine.Scale(2, -2, 5)), Is.True);
        Assert.That(Mapping.KeepsCircles(Affine.Scale(2, 2 + 1e-8, 5)), Is.False);
        Assert.That(Mapping.KeepsCircles(Affine.Scale(2, 2 + 1e-9, 5)), Is.True);
        Assert.That(Mapping.KeepsCircles(Affine.Scale(0, 0, 5)), Is.False);
        Assert.That(Mapping.KeepsCircles(Affine.Rotate(Vec3.UnitX, 1)), Is.False);
        Assert.That(Mapping.KeepsCircles(new Affine(Vec3.UnitX, new Vec3(1e-8, 1), Vec3.UnitZ, Vec3.Zero)), Is.False, "sheared");
        foreach (var leans in new[] { new Vec3(0.1, 0, 1), new Vec3(0, 0.1, 1) })
            Assert.That(Mapping.KeepsCircles(new Affine(Vec3.UnitX, Vec3.UnitY, leans, Vec3.Zero)), Is.False);
        Assert.That(Mapping.KeepsLengths(Affine.Rotate(new Vec3(1, 2, 3), 40)), Is.True);
        Assert.That(Mapping.KeepsLengths(Affine.Scale(1, -1, 1)), Is.True);
        foreach (var scale in new[] { Affine.Scale(1.1, 1, 1), Affine.Scale(1, 1.1, 1), Affine.Scale(1, 1, 1.1) })
            Assert.That(Mapping.KeepsLengths(scale), Is.False);
        Assert.That(Mapping.KeepsLengths(new Affine(Vec3.UnitX, new Vec3(0.6, 0.8), Vec3.UnitZ, Vec3.Zero)), Is.False, "sheared");
    }

    [Test]
    public void Layers_follow_a_map_that_leaves_them_level()
    {
        var layer = new Layer(3, 2, 0.5, "o");
        var path = new PrintPath([Vec3.Zero, Vec3.UnitX], new Bead(1)) { Layer = layer };
        Assert.That(path.Transformed(Affine.Scale(1, 1, -3).Then(Affine.Move(new Vec3(0, 0, 10)))).Layer, Is.EqualTo(new Layer(3, 4, 1.5, "o")));
        Assert.That(path.Transformed(Affine.Rotate(Vec3.UnitX, 10)).Layer, Is.EqualTo(layer));
        Assert.That(path.Transformed(Affine.Rotate(Vec3.UnitY, 10)).Layer, Is.EqualTo(layer));
    }

    [TestCase(PathAxis.X, OutputAxis.A, 0)]
    [TestCase(PathAxis.Y, OutputAxis.B, 1)]
    [TestCase(PathAxis.Z, OutputAxis.C, 2)]
    public void A_coordinate_becomes_a_word_and_is_held(PathAxis from, OutputAxis to, int word)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, null);
        builder.AddLayer(new Layer(0, 1));
        builder.Add(new Vec3(1, 2, 4), 0, 0, 30, MoveKind.Travel, Role.Unspecified, 0, 0, 0);
        builder.Add(new Vec3(1, 2, 4), 1, 1, 7, MoveKind.Prime, Role.Unspecified, 0, 0, 0);
        var mapped = new AxisMapping(from, to, 3, 9).Apply(builder.Build([new ToolpathTool(5)]));
        var value = new[] { 1, 2, 4 }[word];
        var columns = mapped.Blocks[0].Columns;
        var turns = new[] { columns.Turns![0].X, columns.Turns[0].Y, columns.Turns[0].Z };
        Assert.That(turns, Is.EqualTo(Enumerable.Range(0, 3).Select(i => i == word ? 3.0 * value : 0)));
        Assert.That(mapped[0].End, Is.EqualTo(new Vec3(word == 0 ? 9 : 1, word == 1 ? 9 : 2, word == 2 ? 9 : 4)));
        Assert.That((mapped[1].Speed, mapped.Layers.Count, mapped.Tools[0].VolumePerE), Is.EqualTo((7.0, 1, (double?)5)));
    }

    [Test]
    public void Words_of_axes_are_finite_and_long_work_can_be_canceled()
    {
        var toolpath = Decode("G0 X1 F600\nG1 X2 E1\n");
        foreach (var wrong in new[] { 0, double.NaN, double.PositiveInfinity })
            Assert.That(() => new AxisMapping(PathAxis.X, OutputAxis.A, wrong).Apply(toolpath), Throws.InvalidOperationException);
        Assert.That(() => new AxisMapping(PathAxis.X, OutputAxis.A, 1, double.NaN).Apply(toolpath), Throws.InvalidOperationException);
        foreach (var (axis, word) in new[] { (PathAxis.X, OutputAxis.X), (PathAxis.Y, OutputAxis.Y), (PathAxis.Z, OutputAxis.Z) })
        {
            Assert.That(() => new AxisMapping(axis, word, 2).Apply(toolpath), Throws.Nothing);
            Assert.That(() => new AxisMapping(axis == PathAxis.X ? PathAxis.Y : PathAxis.X, word, 2).Apply(toolpath), Throws.InvalidOperationException);
        }
        var canceled = new CancellationToken(true);
        Assert.That(() => new AxisMapping(PathAxis.X, OutputAxis.A, 1).Apply(toolpath, cancel: canceled), Throws.InstanceOf<OperationCanceledException>());
        Assert.That(() => new ToolDirections(Head(), _ => Vec3.UnitZ).Apply(toolpath, cancel: canceled), Throws.InstanceOf<OperationCanceledException>());
    }

    [Test]
    public void Long_work_tells_its_progress()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var i = 0; i < 0x10000 + 9; i++) builder.Add(new Vec3(i % 7, 1), 0, 0, 30, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        var toolpath = builder.Build([]);
        Shares mapping = new(), tilt = new();
        new AxisMapping(PathAxis.X, OutputAxis.A, 1).Apply(toolpath, mapping);
        new ToolDirections(Head(), _ => Vec3.UnitZ).Apply(toolpath, tilt);
        var expected = Enumerable.Range(0, 17).Select(k => 4096 * k / 65_545.0).ToArray();
        Assert.That(mapping.Values, Is.EqualTo(expected).Within(1e-12));
        Assert.That(tilt.Values, Is.EqualTo(expected.Select(share => share / 10).Append(1)).Within(1e-12), "dividing moves, then one travel");
    }

    private sealed class Shares : IProgress<double>
    {
        public System.Collections.Generic.List<double> Values { get; } = [];

        public void Report(double value) => Values.Add(value);
    }

    [TestCase(0.049, 0)]
    [TestCase(0.051, 0.051)]
    [TestCase(89, 89)]
    public void A_tool_that_is_as_good_as_upright_does_not_turn(double degrees, double tilt)
    {
        var tool = new Vec3(Angle.Sin(degrees), 0, Angle.Cos(degrees));
        var words = Head().Nearest(Vec3.Zero, tool, new Vec3(0, 0, 40));
        Assert.That(words.Y, Is.EqualTo(tilt).Within(1e-9));
        Assert.That(words.Z, Is.EqualTo(tilt == 0 ? 40 : 0).Within(1e-9));
    }

    private static Kinematics Head() => new([RotaryAxis.Parse("C head z")!, RotaryAxis.Parse("B head y")!]);

    private static string Typed(string type, params string[] lines) => ";TYPE:" + type + "\n" + string.Join("\n", lines);

    private static Toolpath Decode(string text)
        => GCodeDecoder.Decode(GCodeDocument.FromText("G90\nM83\nG1 F600\n" + text),
            new DecodeOptions { Flavor = FlavorTable.Marlin2, FilamentDiameter = 1.75 })
            .Value!.Toolpath;
}
