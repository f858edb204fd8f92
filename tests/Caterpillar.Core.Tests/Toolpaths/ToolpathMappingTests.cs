using System;
using System.Linq;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Shaping;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

/// <summary>Chosen moves of a toolpath are shifted and bent.</summary>
public class ToolpathMappingTests
{
    private const string TwoLayers =
        "G21\nG90\nM83\nG1 X0 Y-3 E5 F600\n;LAYER:0\nG0 X0 Y0 Z0.2 F6000\nG1 X40 E2 F1200\nG3 X40 Y20 I0 J10 E1\nG1 E-1 F2400\n;LAYER:1\nG0 X0 Y0 Z0.4 "
            + "F6000\nG1 E1 F2400\nG1 X40 E2 F1200\nG1 Y20 E1\n";

    private static readonly MoveFilter Layers = new() { FirstLayer = 0 };

    [Test]
    public void A_shift_of_the_layers_keeps_arcs_lengths_and_what_is_outside()
    {
        var before = Decode(TwoLayers);
        var after = before.Transform(Layers, Affine.Move(new Vec3(5, 6, 1)));
        Assert.That(after[0].End, Is.EqualTo(before[0].End), "the purge line has no layer");
        Assert.That(after.Count, Is.EqualTo(before.Count));
        for (var i = 1; i < before.Count; i++)
        {
            Assert.That((after[i].End - before[i].End - new Vec3(5, 6, 1)).Length, Is.LessThan(1e-12), $"move {i}");
            Assert.That(after[i].E, Is.EqualTo(before[i].E).Within(1e-12));
        }
        var arc = after.Moves().Single(m => m.Arc is not null);
        Assert.That(arc.Arc!.Value.Center, Is.EqualTo(new Vec3(45, 16, arc.Arc.Value.Center.Z)));
        Assert.That(after.Layers.Select(l => l.Z), Is.EqualTo(before.Layers.Select(l => l.Z + 1)));
    }

    // Whole blocks are mapped at once; an arc at their end is mapped move by move.
    [TestCase(0.0)]
    [TestCase(37.0)]
    public void Whole_blocks_are_mapped_like_single_moves(double degrees)
    {
        var random = new Random(3);
        var text = new System.Text.StringBuilder("G90\nM83\n;LAYER:0\nG0 X1 Y1 Z0.2 F6000\n");
        for (var i = 0; i < 5000; i++)
        {
            text.Append("G1 X").Append(random.Next(200)).Append(" Y").Append(random.Next(200))
                .Append(random.Next(9) switch { 0 => "\n", 1 => " E-1\n", _ => " E3\n" });
        }
        var straight = Decode(text.ToString());
        var turned = Decode(text + "G2 X0 Y0 I1\n");
        foreach (var map in new[] { Affine.Move(new Vec3(1, 2, 0.1)), Affine.Scale(0.5), Affine.Scale(1.5, 1, 2) })
        {
            var whole = map.Then(Affine.Rotate(Vec3.UnitZ, degrees));
            var (a, b) = (straight.Transform(whole), turned.Transform(whole));
            for (var block = 0; block < a.Blocks.Count; block++)
            {
                var (c, d) = (a.Blocks[block].Columns, b.Blocks[block].Columns);
                for (var i = 0; i < c.Count; i++)
                {
                    if (c.X[i] != d.X[i] || c.Y[i] != d.Y[i] || c.Z[i] != d.Z[i] || c.Kind[i] != d.Kind[i] || c.Source[i] != d.Source[i]
                        || Math.Abs(c.E[i] - d.E[i]) > 1e-12 || Math.Abs(c.Deposited[i] - d.Deposited[i]) > 1e-12) Assert.Fail($"block {block}, move {i}");
                }
            }
        }
    }

    [Test]
    public void Shifts_share_the_columns_that_they_do_not_change()
    {
        var before = Decode("G90\nM83\n;LAYER:0\nG0 X1 Y1 Z0.2 F6000\nG1 X5 E1\nG1 Y9 E1\n");
        var after = before.Transform(Affine.Move(new Vec3(1, 2)));
        Assert.That(after.Blocks[0].Columns.E, Is.SameAs(before.Blocks[0].Columns.E));
        Assert.That(after.Blocks[0].Columns.Z, Is.SameAs(before.Blocks[0].Columns.Z));
        Assert.That(after.Blocks[0].Columns.X, Is.EqualTo(before.Moves().Select(m => m.End.X + 1)));
    }

    [Test]
    public void Differences_are_counted_and_extrusions_are_summed_up()
    {
        var before = Decode("G90\nM83\n;TYPE:Skirt\nG0 X1 Y1 Z0.2 F6000\nG1 X11 E1 F600\n;TYPE:Perimeter\n;LAYER:0\nG0 X20 Y20\nG1 X24 E1\nG1 Y29 E2\n");
        var faster = before.ScaleSpeed(new MoveFilter { Kinds = [MoveKind.Print] }, 2);
        Assert.That(ToolpathDifference.Of(before, before), Is.EqualTo(new ToolpathDifference(0, 0, 0, 5, 5)));
        Assert.That(ToolpathDifference.Of(before, faster), Is.EqualTo(new ToolpathDifference(0, 3, 0, 5, 5)));
        Assert.That(ToolpathDifference.Of(before, faster.Transform(Affine.Scale(2, 2, 1)).ScaleFlow(MoveFilter.Prints, 2)),
            Is.EqualTo(new ToolpathDifference(5, 3, 3, 5, 5)));
        Assert.That(ToolpathDifference.Of(before, Decode("G1 X1\n")), Is.EqualTo(new ToolpathDifference(0, 0, 0, 5, 1)));
        var totals = ToolpathTotals.Of(before);
        Assert.That((totals.PrintLength, totals.DepositedE), Is.EqualTo((23.0, 4.0)));
        Assert.That(totals.DepositedVolume, Is.EqualTo(4 * ExtrusionModel.FilamentAreaOf(1.75)).Within(1e-9));
        Assert.That(totals.PartBounds, Is.EqualTo(new Bounds(new Vec3(20, 20, 0.2), new Vec3(24, 29, 0.2))), "without the skirt");
    }

    [Test]
    public void A_shift_of_one_layer_adds_travels_there_and_back()
    {
        var before = Decode(TwoLayers);
        var after = before.Transform(new MoveFilter { FirstLayer = 1, LastLayer = 1, Kinds = [MoveKind.Print] }, Affine.Move(new Vec3(0, 100)));
        var moves = after.Moves().ToArray();
        Assert.That(moves.Where(m => m.Layer == 0).Select(m => m.End), Is.EqualTo(before.Moves().Where(m => m.Layer == 0).Select(m => m.End)));
        var extrusion = moves.First(m => m.Layer == 1 && m.Kind == MoveKind.Print);
        Assert.That(extrusion.Start, Is.EqualTo(new Vec3(0, 100, 0.4)));
        Assert.That(extrusion.Length, Is.EqualTo(40));
        Assert.That(after.Layers.Select(l => l.Z), Is.EqualTo(before.Layers.Select(l => l.Z)), "extrusions are not the whole layer");
    }

    [Test]
    public void Moves_in_place_and_vertical_moves_stay_so_and_homing_stays()
    {
        var before = Decode("G90\nM83\n;LAYER:0\nG0 Z0.2 F600\nG0 X10 Y10 F6000\nG1 E1 F2400\nG1 X20 E1 F1200\nG1 E-1 F2400\nG0 Z5 F600\nG0 X0 Y200 F6000\n");
        var after = before.Transform(new MoveFilter { Kinds = [MoveKind.Print] }, Affine.Move(new Vec3(3, 4)));
        Assert.That(after.Moves().Select(m => m.End), Is.EqualTo(new[]
        {
            new Vec3(0, 0, 0.2), new Vec3(13, 14, 0.2), new Vec3(13, 14, 0.2), new Vec3(23, 14, 0.2), new Vec3(23, 14, 0.2), new Vec3(23, 14, 5),
                new Vec3(0, 200, 5),
        }));
        Assert.That(after.Moves().Select(m => m.Kind), Is.EqualTo(before.Moves().Select(m => m.Kind)));
    }

    [Test]
    public void Extrusions_are_divided_until_their_image_is_smooth()
    {
        var before = Decode(TwoLayers);
        static Vec3 Bend(Vec3 p) => new(p.X, p.Y, p.Z + p.X * p.X / 200);
        var after = before.Deform(Layers, Bend, 0.01);
        var line = after.Moves().Where(m => m.Source == before[2].Source).ToArray();
        Assert.That(line, Has.Length.GreaterThan(8).And.Length.LessThan(200));
        foreach (var piece in line)
        {
            for (var t = 0.0; t <= 1; t += 0.125)
            {
                var on = Vec3.Lerp(piece.Start, piece.End, t);
                Assert.That(Math.Abs(Bend(new Vec3(on.X, on.Y, 0.2)).Z - on.Z), Is.LessThan(0.0101));
            }
        }
        // The length of z = x²/200 from 0 to 40: x/2 √(1 + (x/100)²) + 50 asinh(x/100).
        var exact = 20 * Math.Sqrt(1.16) + 50 * Math.Log(0.4 + Math.Sqrt(1.16));
        Assert.That(line.Sum(m => m.Length), Is.EqualTo(exact).Within(1e-3));
        Assert.That(line.Sum(m => m.E), Is.EqualTo(2 * exact / 40).Within(1e-4), "the material follows the length");
        Assert.That(after.Moves().Where(m => m.Kind == MoveKind.Retract).Sum(m => m.E), Is.EqualTo(-1));
    }

    [Test]
    public void Formulas_of_area_and_speed_act_on_what_is_printed()
    {
        var before = Decode(TwoLayers);
        var twist = DeformationText.Compile("r, theta + 2 * z, z", "2 * c", "v / 4", DeformationSystem.Cylindrical).Value!;
        var after = before.Deform(Layers, twist, 0.001).Value!;
        foreach (var z in new[] { 0.2, 0.4 })
        {
            var was = before.Moves().Where(m => m.Kind == MoveKind.Print && m.Layer >= 0 && m.End.Z == z).ToArray();
            var now = after.Moves().Where(m => m.Kind == MoveKind.Print && m.Layer >= 0 && m.End.Z == z).ToArray();
            Assert.That(now.Sum(m => m.Length), Is.EqualTo(was.Sum(m => m.Length)).Within(1e-2), "a turn keeps lengths");
            Assert.That(now.Sum(m => m.Deposited), Is.EqualTo(2 * was.Sum(m => m.Deposited)).Within(1e-3));
            Assert.That(now.Select(m => m.Speed).Distinct().Single(), Is.EqualTo(was[0].Speed / 4));
            Assert.That(now.Last().End.LengthXY, Is.EqualTo(was.Last().End.LengthXY).Within(1e-9));
        }
        Assert.That(after.Moves().Where(m => m.Kind == MoveKind.Travel).Select(m => m.Speed), Is.All.EqualTo(100));
    }

    [Test]
    public void Angles_continue_along_extrusions()
    {
        // Three quarters of a circle in chords, whose angle is halved: three eighths, without a jump at 180°.
        var text = "G90\nM83\n;LAYER:0\nG0 X10 Y0 Z0.2 F6000\n"
            + string.Concat(Enumerable.Range(1, 27)
            .Select(i => FormattableString.Invariant($"G1 X{10 * Math.Cos(i * Math.PI / 18)} Y{10 * Math.Sin(i * Math.PI / 18)} E1\n")));
        var half = DeformationText.Compile("r, theta / 2, z", null, null, DeformationSystem.Cylindrical).Value!;
        var after = Decode(text).Deform(Layers, half).Value!;
        var end = after[after.Count - 1].End;
        Assert.That(Math.Atan2(end.Y, end.X) * 180 / Math.PI, Is.EqualTo(135).Within(1e-6));
        Assert.That(after.Moves().Where(m => m.Kind == MoveKind.Print).Max(m => m.Length), Is.LessThan(0.9));
    }

    [Test]
    public void What_is_not_finite_is_an_error_with_the_line()
    {
        var result = Decode(TwoLayers).Deform(Layers, DeformationText.Compile("x, y, z / (x - x)").Value!);
        Assert.That(result.Value, Is.Null);
        Assert.That(result.Diagnostics.Single().Code, Is.EqualTo("shape.position"));
        Assert.That(result.Diagnostics.Single().Source!.Line, Is.EqualTo(7));
    }

    [Test]
    public void Blocks_without_chosen_moves_are_shared()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var layer = 0; layer < 3; layer++)
        {
            builder.AddLayer(new Layer(layer, layer + 1, 1));
            for (var i = 0; i < 70_000; i++) builder.Add(new Vec3(i % 2, i % 3, layer + 1), 1, 1, 10, MoveKind.Print, Role.Infill, layer, 0, i);
        }
        var before = builder.Build([new ToolpathTool(1)]);
        var after = before.Transform(new MoveFilter { FirstLayer = 2 }, Affine.Move(new Vec3(1, 0)));
        Assert.That(after.Blocks[0], Is.SameAs(before.Blocks[0]));
        Assert.That(after.Blocks[1], Is.SameAs(before.Blocks[1]));
        Assert.That(after[209_999].End.X, Is.EqualTo(before[209_999].End.X + 1));
        Assert.That(after.Count, Is.EqualTo(before.Count));
    }

    [Test]
    public void An_inserted_tool_makes_the_moves_up_to_the_next_tool()
    {
        var before = Decode(TwoLayers + ";LAYER:2\nT1\nG0 X0 Y0 Z0.6\nG1 X10 E1\n");
        var after = before.InsertAtLayer(1, new ToolEvent(2)).Value!;
        Assert.That(after.Moves().Select(m => m.Tool), Is.EqualTo(before.Moves().Select(m => m.Layer == 1 ? 2 : m.Layer == 2 ? 1 : 0)));
        Assert.That(after.Tools, Has.Count.EqualTo(3));
        var decoding = DecodeAll(TwoLayers);
        var edited = decoding.Toolpath.InsertAtLayer(1, new ToolEvent(1)).Value!;
        var text = System.Text.Encoding.ASCII.GetString(GCodeEditor.ToDocument(decoding, edited).Value!.ToBytes());
        Assert.That(text, Is.EqualTo(TwoLayers.Replace("G0 X0 Y0 Z0.4 F6000", "T1\nG0 X0 Y0 Z0.4 F6000")));
    }

    private static Toolpath Decode(string text) => DecodeAll(text).Toolpath;

    private static DecodedGCode DecodeAll(string text)
        => GCodeDecoder.Decode(GCodeDocument.FromText(text), new DecodeOptions { Flavor = FlavorTable.Slicer, FilamentDiameter = 1.75 }).Value!;
}
