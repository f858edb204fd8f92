using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>Decode, edit, write again.</summary>
public class EditTests
{
    private static readonly Encoding Latin1 = Encoding.GetEncoding(28591);

    private const string Small =
        "; start\nG21\nG90\nM82\nG92 E0\nG0 X0 Y0 Z0.2 F6000\n;LAYER:0\n;TYPE:WALL-OUTER\nG1 X10 Y0 E1 F1800\nG1 X10 Y10 E2\nG1 E0.5 F2400\n"
        + ";LAYER:1\nG0 X0 Y0 Z0.4 F6000\nG1 E2 F2400\n;TYPE:FILL\nG1 X10 E3 F1200\nG1 Y10 E4\n;LAYER:2\nG0 X0 Y0 Z0.6\nG1 X10 E5 F1800\nG1 Y10 E6\nM84\n";

    [TestCaseSource(typeof(GCodeFiles), nameof(GCodeFiles.Chosen))]
    public void An_unedited_file_keeps_every_byte(string file)
    {
        var bytes = GCodeFiles.Bytes(file);
        var document = GCodeDocument.FromBytes(bytes, file);
        var decoding = Decode(document);
        Assert.That(document.ToBytes(), SameBytes.As(bytes));
        var again = GCodeEditor.ToDocument(decoding, decoding.Toolpath).Value!;
        Assert.That(again.ToBytes(), SameBytes.As(bytes));
        var copied = decoding.Toolpath.ScaleSpeed(new MoveFilter(), 1);
        Assert.That(GCodeEditor.ToDocument(decoding, copied).Value!.ToBytes(), SameBytes.As(bytes), "equal moves are no change, whatever block they are in");
    }

    [Test]
    public void The_speed_of_a_layer_changes_its_lines_and_the_state_after_it()
    {
        var edited = Edit(Small, t => t.ScaleSpeed(new MoveFilter { FirstLayer = 1, LastLayer = 1, Kinds = [MoveKind.Print] }, 0.5));
        Assert.That(edited, Is.EqualTo(Small.Replace("G1 X10 E3 F1200", "G1 X10 E3 F600").Replace("G0 X0 Y0 Z0.6\n", "G1 F1200\nG0 X0 Y0 Z0.6\n")));
    }

    [Test]
    public void An_arc_in_inches_keeps_its_center_in_every_plane()
    {
        const string Arc = "G20\nG90\nM83\nG18\nG1 X1 Y1 Z0.1 F60\nG3 X1 Z0.5 I0.1 K0.2 E0.1\n";
        Assert.That(Edit(Arc, t => t.Transform(Affine.Move(new Vec3(25.4, 0)))), Is.EqualTo(Arc.Replace("X1", "X2")));
    }

    [Test]
    public void Flow_in_absolute_E_is_bridged_by_G92()
    {
        var edited = Edit(Small, t => t.ScaleFlow(new MoveFilter { FirstLayer = 1, LastLayer = 1 }, 2));
        Assert.That(edited, Is.EqualTo(Small.Replace("G1 X10 E3 F1200\nG1 Y10 E4\n", "G1 X10 E4 F1200\nG1 Y10 E6\n")
            .Replace("G1 X10 E5 F1800", "G92 E4\nG1 X10 E5 F1800")));
    }

    [Test]
    public void A_layer_can_be_cut_out_and_the_retraction_is_carried_over()
    {
        var edited = Edit(Small, t => t.Remove(new MoveFilter { FirstLayer = 1, LastLayer = 1 }));
        Assert.That(edited, Does.Not.Contain("LAYER:1").And.Not.Contain("E3"));
        var decoding = Decode(Doc(edited));
        Assert.That(decoding.Report.PrintSegments, Is.EqualTo(4));
        Assert.That(decoding.Report.Counters.EPrint, Is.EqualTo(4).Within(1e-9));
        Assert.That(decoding.Report.PrintLength, Is.EqualTo(40).Within(1e-9));
    }

    [Test]
    public void A_pause_is_put_before_its_layer()
    {
        var edited = Edit(Small, t => t.InsertAtLayer(2, new PauseEvent("magnets")).Value!);
        Assert.That(edited, Is.EqualTo(Small.Replace("G0 X0 Y0 Z0.6\n", "; magnets\nM0\nG0 X0 Y0 Z0.6\n")));
    }

    [Test]
    public void Moves_follow_a_map_and_keep_their_material_per_length()
    {
        var edited = Edit(Small, t => t.Deform(new MoveFilter { FirstLayer = 2, LastLayer = 2 }, p => new Vec3(2 * p.X + 1, p.Y, p.Z)));
        var decoding = Decode(Doc(edited));
        Assert.That(decoding.Report.PrintBounds.Max.X, Is.EqualTo(21).Within(1e-9));
        Assert.That(decoding.Report.Counters.EPrint, Is.EqualTo(7).Within(1e-9), "the extrusion of 10 mm has become one of 20");
    }

    [Test]
    public void Changed_lines_keep_the_style_of_the_file()
    {
        const string Dense = "g21\ng90\nm83\ng1x0y0z.2f1800 ; c\ng1x10.500e.500\ng1y10.250e.500 ;d\n";
        Assert.That(
            Edit(Dense, t => t.ScaleFlow(MoveFilter.Prints, 0.5)),
            Is.EqualTo("g21\ng90\nm83\ng1x0y0z.2f1800 ; c\ng1x10.500e.25000\ng1y10.250e.25000 ;d\n"));
    }

    [Test]
    public void Numbers_and_checksums_are_renewed_after_an_inserted_line()
    {
        var builder = new StringBuilder();
        var lines = new[] { "G21", "G90", "M83", "G1 X0 Y0 Z0.2 F1800", "G1 X10 E0.5", "G1 X20 E0.5" };
        for (var i = 0; i < lines.Length; i++) builder.Append(Sum($"N{i + 1} {lines[i]}")).Append('\n');
        var edited = Edit(builder.ToString(), t => t.Insert(1, new PauseEvent()));
        var expected = new[] { "N1 G21", "N2 G90", "N3 M83", "N4 G1 X0 Y0 Z0.2 F1800", "N5 M0", "N6 G1 X10 E0.5", "N7 G1 X20 E0.5" };
        Assert.That(edited, Is.EqualTo(string.Concat(expected.Select(l => Sum(l) + "\n"))));
    }

    [Test]
    public void Start_and_end_code_can_be_replaced()
    {
        var decoding = Decode(Doc(Small));
        var options = new EditOptions { Start = ["; new", "G28", "G91", "M83", "G1 E5 F300"], End = ["M84 ; off"] };
        var edited = Latin1.GetString(GCodeEditor.ToDocument(decoding, decoding.Toolpath, options).Value!.ToBytes());
        Assert.That(edited, Does.StartWith("; new\nG28\nG91\nM83\nG1 E5 F300\nG90\nG0 Z0.2\nG0 X0 Y0\nG90\nM82\nG92 E0\nG1 F6000\n;LAYER:0\n"));
        Assert.That(edited, Does.EndWith("G1 Y10 E6\nM84 ; off\n"));
        var back = Decode(Doc(edited));
        Assert.That(back.Report.PrintLength, Is.EqualTo(decoding.Report.PrintLength).Within(1e-9));
        Assert.That(back.Report.Counters.EPrint, Is.EqualTo(decoding.Report.Counters.EPrint).Within(1e-9));
    }

    [Test]
    public void Moves_in_another_order_are_refused()
    {
        var decoding = Decode(Doc(Small));
        var builder = new ToolpathBuilder(MoveSource.Lines, null);
        foreach (var move in decoding.Toolpath.Moves().Reverse())
            builder.Add(move.End, move.E, move.Deposited, move.Speed, move.Kind, move.Role, -1, move.Tool, move.Source);
        Assert.That(GCodeEditor.ToDocument(decoding, builder.Build([new ToolpathTool(null)])).HasErrors, Is.True);
    }

    [TestCaseSource(typeof(GCodeFiles), nameof(GCodeFiles.Affordable))]
    public void The_speed_of_one_layer_changes_only_lines_of_that_layer(string file)
    {
        var document = GCodeFiles.Document(file);
        var decoding = Decode(document);
        var toolpath = decoding.Toolpath;
        if (toolpath.Layers.Count < 3) return;
        var middle = toolpath.Layers[toolpath.Layers.Count / 2].Index;
        var filter = new MoveFilter { FirstLayer = middle, LastLayer = middle, Kinds = [MoveKind.Print] };
        var again = GCodeEditor.ToDocument(decoding, toolpath.ScaleSpeed(filter, 0.5)).Value!;
        var chosen = new HashSet<int>(toolpath.Moves().Where(m => filter.Matches(toolpath, m)).Select(m => m.Source));
        var before = Latin1.GetString(document.ToBytes()).Replace("\r\n", "\n").Replace('\r', '\n').Split('\n');
        var after = Latin1.GetString(again.ToBytes()).Replace("\r\n", "\n").Replace('\r', '\n').Split('\n');
        int j = 0, states = 0;
        for (var i = 0; i < before.Length; i++, j++)
        {
            if (before[i] == after[j]) continue;
            if (after[j].StartsWith("G1 F", StringComparison.Ordinal) && before[i] == after[j + 1])
            {
                states++;
                j++;
                continue;
            }
            if (!chosen.Contains(i + 1)) Assert.Fail($"line {i + 1}: {before[i]} became {after[j]}");
        }
        Assert.That(j, Is.EqualTo(after.Length));
        Assert.That(states, Is.LessThan(chosen.Count + 2));
        var back = Decode(again);
        Assert.That(back.Report.PrintLength, Is.EqualTo(decoding.Report.PrintLength).Within(1e-9 * decoding.Report.PrintLength));
    }

    private static string Sum(string line) => line + "*" + line.Aggregate(0, (sum, c) => sum ^ c);

    private static string Edit(string text, Func<Toolpath, Toolpath> edit)
    {
        var decoding = Decode(Doc(text));
        var result = GCodeEditor.ToDocument(decoding, edit(decoding.Toolpath));
        return Latin1.GetString(result.Value!.ToBytes());
    }

    private static GCodeDocument Doc(string text) => GCodeDocument.FromText(text);

    private static DecodedGCode Decode(GCodeDocument document) => GCodeDecoder.Decode(document, new DecodeOptions { Flavor = FlavorTable.Slicer }).Value!;
}
