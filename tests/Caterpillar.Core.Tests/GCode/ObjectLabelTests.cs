using System;
using System.Linq;
using System.Text;
using Caterpillar.Checks;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Tests.Checks;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

public class ObjectLabelTests
{
    private static readonly string[] Marks = ["EXCLUDE", "M486", "; printing", "; stop", "G92 E"];

    [TestCase("klipper",
        "EXCLUDE_OBJECT_DEFINE NAME=cup CENTER=25,20 POLYGON=[[30,10],[30,30],[20,30],[20,10]]",
        "EXCLUDE_OBJECT_DEFINE NAME=cup_2 CENTER=65,10 POLYGON=[[70,10],[60,10]]",
        "EXCLUDE_OBJECT_START NAME=cup", "EXCLUDE_OBJECT_END NAME=cup", "EXCLUDE_OBJECT_START NAME=cup_2", "EXCLUDE_OBJECT_END NAME=cup_2")]
    [TestCase("marlin2", "M486 T2",
        "M486 S0", "; printing object cup", "; stop printing object cup", "M486 S-1", "M486 S1", "; printing object cup (2)",
        "; stop printing object cup (2)", "M486 S-1")]
    [TestCase("reprapfirmware", "M486 T2", "M486 S0 A\"cup\"", "M486 S-1", "M486 S1 A\"cup_2\"", "M486 S-1")]
    [TestCase("prusa", "; printing object cup", "; stop printing object cup", "; printing object cup (2)", "; stop printing object cup (2)")]
    public void Objects_are_marked_as_the_firmware_reads_it(string flavor, params string[] marks)
        => Assert.That(Marked(Setup(flavor)), Is.EqualTo(marks));

    [Test]
    public void A_key_switches_the_commands_off_and_leaves_comments()
    {
        string[] comments = ["; printing object cup", "; stop printing object cup", "; printing object cup (2)", "; stop printing object cup (2)"];
        Assert.That(Marked(Setup("klipper", "object_labels=false")), Is.EqualTo(comments));
        Assert.That(Marked(Setup("marlin2", "object_labels=false")), Is.EqualTo(comments));
    }

    [Test]
    public void Relative_moves_are_not_marked_because_those_that_the_firmware_skips_would_shift_the_next()
        => Assert.That(Marked(Setup("marlin2", "relative_xyz=true")).Any(l => l.StartsWith("M486", StringComparison.Ordinal)), Is.False);

    [Test]
    public void Absolute_E_begins_again_at_the_edges_of_objects_so_that_nothing_is_made_up_for_after_a_canceled_one()
    {
        var marks = Marked(Setup("reprapfirmware", "e_mode=absolute"));
        string[] each = ["M486 S0 A\"cup\"", "G92 E0", "M486 S-1", "M486 S1 A\"cup_2\"", "G92 E0", "M486 S-1", "G92 E0"];
        Assert.That(marks, Is.EqualTo(new[] { "M486 T2", "G92 E0" }.Concat(each)));
    }

    [TestCase("klipper")]
    [TestCase("marlin2")]
    [TestCase("reprapfirmware")]
    [TestCase("marlin1")]
    public void Moves_of_templates_are_outside_of_objects_and_the_file_is_read_back_with_its_objects(string flavor)
    {
        var setup = Setup(flavor, "layer_change_gcode=G0 X5 Y5 F6000", "e_mode=absolute");
        var text = Written(setup, layers: 2);
        var lines = text.Split('\n');
        var before = lines.Take(Array.IndexOf(lines, "G0 X5 Y5 F6000")).Last(l => Marks.Take(2).Any(m => l.StartsWith(m, StringComparison.Ordinal)));
        Assert.That(before, Is.EqualTo("M486 S-1").Or.StartsWith("EXCLUDE_OBJECT_END"));
        var file = GCodeDecoder.Decode(Encoding.UTF8.GetBytes(text)).Value!;
        var objects = file.Toolpath.Moves().Where(m => m.Kind == MoveKind.Print).Select(m => file.Toolpath.Layers[m.Layer].Object).Distinct();
        var word = flavor.StartsWith("marlin", StringComparison.Ordinal) ? "cup (2)" : "cup_2";
        Assert.That(objects, Is.EqualTo(new[] { "", "cup", word }));
    }

    [Test]
    public void Edits_that_move_objects_move_their_outlines()
    {
        var file = GCodeDecoder.Decode(Encoding.UTF8.GetBytes(Written(Setup("klipper"), 1))).Value!;
        var moved = file.Toolpath.Transform(new MoveFilter { Objects = ["cup_2"] }, Affine.Move(new Vec3(0, 7, 0)), 0.01);
        var lines = Encoding.UTF8.GetString(GCodeEditor.ToDocument(file, moved).OrThrow().ToBytes()).Split('\n');
        Assert.That(lines.Where(l => l.StartsWith("EXCLUDE_OBJECT_DEFINE", StringComparison.Ordinal)), Is.EqualTo(new[]
        {
            "EXCLUDE_OBJECT_DEFINE NAME=cup CENTER=25,20 POLYGON=[[30,10],[30,30],[20,30],[20,10]]",
            "EXCLUDE_OBJECT_DEFINE NAME=cup_2 CENTER=65,17 POLYGON=[[70,17],[60,17]]",
        }));
    }

    [Test]
    public void Names_are_one_word_and_different_for_each_object()
    {
        var labels = new ObjectLabels(ObjectMarking.Names);
        string[] names = ["a b", "A-B", "größe.stl", "#;", new string('x', 200)];
        foreach (var name in names) labels.NumberOf(name);
        var words = names.Select((_, i) => labels.Start(i)[0].Split('=')[1]).ToArray();
        Assert.That(words.Take(4), Is.EqualTo(new[] { "a_b", "A_B_2", "größe_stl", "object" }));
        Assert.That(words[4], Has.Length.EqualTo(100));
        labels.Name(0, "c");
        Assert.That(labels.Start(1)[0], Is.EqualTo("EXCLUDE_OBJECT_START NAME=A_B"), "The other name is free now.");
    }

    [Test]
    public void An_outline_of_a_circle_touches_its_box_and_loses_little()
    {
        var print = new SmallPrint(130, 100).InLayer(new Layer(0, 0.2, 0.2, "disk"));
        for (var k = 1; k <= 360; k++) print.Print(100 + 30 * Math.Cos(k * Math.PI / 180), 100 + 30 * Math.Sin(k * Math.PI / 180), 0.2);
        var outline = ObjectOutlines.Of(print.Build()).Single().Outline;
        Assert.That(outline, Has.Count.EqualTo(16));
        Assert.That(outline.Max(p => p.X) - outline.Min(p => p.X), Is.EqualTo(60).Within(1e-9));
        var area = outline.Select((p, i) => p.X * outline[(i + 1) % 16].Y - p.Y * outline[(i + 1) % 16].X).Sum() / 2;
        Assert.That(area, Is.InRange(0.97 * Math.PI * 900, Math.PI * 900));
    }

    private static PrintSetup Setup(string flavor, params string[] values)
        => SmallPrint.Setup(p => p with { Flavor = FlavorTable.Find(flavor)! }).With(values).OrThrow();

    private static string[] Marked(PrintSetup setup)
        => [.. Written(setup, 1).Split('\n').Where(l => Marks.Any(m => l.StartsWith(m, StringComparison.Ordinal)))];

    // A skirt, a square of 10 x 20 mm and a line, each of an object.
    private static string Written(PrintSetup setup, int layers)
    {
        var print = new SmallPrint(10, 5).InLayer(new Layer(0, 0.2, 0.2)).Print(80, 5, 0.2, role: Role.Skirt);
        for (var i = 0; i < layers; i++)
        {
            var z = 0.2 * (i + 1);
            print.InLayer(new Layer(i, z, 0.2, "cup")).Over(20, 10, z).Print(30, 10, z).Print(30, 30, z).Print(20, 30, z).Print(20, 10, z);
            print.InLayer(new Layer(i, z, 0.2, "cup (2)")).Over(60, 10, z).Print(70, 10, z);
        }
        return Encoding.UTF8.GetString(SafeWriter.ToDocument(print.Build(), setup).OrThrow().ToBytes());
    }
}
