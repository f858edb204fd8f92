using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Display;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using FsCheck;
using FsCheck.Fluent;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Caterpillar.Tests.Display;

public class ViewerPageTests
{
    private const string Code = "G28\nG90\nM83\nM106 S128\nG1 Z0.2 F600\n;LAYER:0\n;TYPE:WALL-OUTER\nG1 X10 Y0 E0.5 F1200\nG1 X10 Y10 E0.5\nG1 E-1 F2400\n"
        + "G0 X0 Y0 F6000\nG1 E1 F2400\nG3 X10 Y0 I5 J0 E1 F1200\n";

    [Test]
    public void Columns_hold_every_move_in_order()
    {
        var toolpath = GCodeDecoder.Decode(Encoding.ASCII.GetBytes(Code)).Value!.Toolpath;
        var page = Page(new ViewerContent("a") { Toolpath = toolpath, EndOf = move => move + 1 });
        var head = Head(page);
        var columns = Columns(page, head);
        var moves = toolpath.Moves().ToArray();
        foreach (var move in moves)
        {
            var last = columns["move"].LastIndexOf(move.Index);
            Assert.That(columns["x"][last], Is.EqualTo(Math.Round(move.End.X * 1000)), "x of move " + move.Index);
            Assert.That(columns["y"][last], Is.EqualTo(Math.Round(move.End.Y * 1000)));
            Assert.That(columns["z"][last], Is.EqualTo(Math.Round(move.End.Z * 1000)));
            Assert.That(columns["what"][last], Is.EqualTo(((int)move.Kind << 5) | (int)move.Role));
            Assert.That(columns["line"][last], Is.EqualTo(move.Source));
            Assert.That(columns["layer"][last], Is.EqualTo(move.Layer));
            Assert.That(columns["speed"][last], Is.EqualTo(Math.Round(move.Speed * 100)));
            Assert.That(columns["time"][last], Is.EqualTo(1000 * (move.Index + 1)));
        }
        Assert.That((int)head["moves"]!, Is.EqualTo(moves.Length));
        Assert.That((int)head["rows"]!, Is.EqualTo(columns["x"].Count));
        var fan = head["events"]!.Single(e => (string)e[1]! == "fan");
        Assert.That((double)fan[2]!, Is.EqualTo(0.502).Within(0.001));
    }

    [Test]
    public void A_head_that_leans_has_its_axes_in_every_row()
    {
        var toolpath = GCodeDecoder.Decode(Encoding.ASCII.GetBytes("G21\nG90\nM83\nG0 X0 Y0 Z10 B0 F6000\nG1 X10 E1 B90 F600\n")).Value!.Toolpath;
        var printer = new Printer { RotaryAxes = new([RotaryAxis.Parse("B head y")!]) };
        var page = Page(new ViewerContent("a") { Toolpath = toolpath, Printer = printer });
        var columns = Columns(page, Head(page));
        long[] Last(params string[] names) => [.. names.Select(n => columns[n].Last())];
        Assert.That(Last("zx", "zy", "zz"), Is.EqualTo(new long[] { 10000, 0, 0 }));
        Assert.That(Last("xx", "xy", "xz"), Is.EqualTo(new long[] { 0, 0, -10000 }));
    }

    [Test]
    public void Arcs_are_divided_and_stay_on_their_circle()
    {
        var toolpath = GCodeDecoder.Decode(Encoding.ASCII.GetBytes(Code)).Value!.Toolpath;
        var arc = toolpath.Moves().Single(m => m.Arc is not null);
        var page = Page(new ViewerContent("a") { Toolpath = toolpath, EndOf = move => move + 1 });
        var columns = Columns(page, Head(page));
        var rows = Enumerable.Range(0, columns["x"].Count).Where(i => columns["move"][i] == arc.Index).ToArray();
        Assert.That(rows, Has.Length.GreaterThan(10));
        foreach (var row in rows)
        {
            double x = columns["x"][row] - 5000.0, y = columns["y"][row];
            Assert.That(Math.Sqrt(x * x + y * y), Is.EqualTo(5000).Within(1));
        }
        // Time runs evenly along the arc.
        Assert.That(rows.Zip(rows.Skip(1), (a, b) => columns["time"][b] - columns["time"][a]), Has.All.InRange(1000 / rows.Length - 1, 1000 / rows.Length + 1));
    }

    [Test]
    public void Areas_are_those_of_the_extrusions()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(new Vec3(20, 0, 0), 2, 2, 20, MoveKind.Print, Role.OuterWall, -1, 0, 0);
        builder.Add(new Vec3(20, 5, 0), 0, 0, 20, MoveKind.Travel, Role.Unspecified, -1, 0, 1);
        var page = Page(new ViewerContent("a") { Toolpath = builder.Build([new ToolpathTool(3)]) });
        // 2 of E at 3 mm³ each over 20 mm are 0.3 mm².
        Assert.That(Columns(page, Head(page))["area"], Is.EqualTo(new long[] { 3000, 0 }));
        Assert.That((bool)Head(page)["timed"]!, Is.False);
    }

    [Test]
    public void Every_row_has_its_tool_layer_and_speed()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        var layer = builder.AddLayer(new Layer(4, 0.2, 0.2));
        builder.Add(new Vec3(20, 0, 0), 2, 2, 20.5, MoveKind.Print, Role.OuterWall, layer, 1, 0);
        builder.Add(new Vec3(20, 5, 0), 0, 0, 100, MoveKind.Travel, Role.Unspecified, -1, 0, 1);
        var page = Page(new ViewerContent("a") { Toolpath = builder.Build([new ToolpathTool(1), new ToolpathTool(1)]) });
        var columns = Columns(page, Head(page));
        Assert.That(columns["tool"], Is.EqualTo(new long[] { 1, 0 }));
        Assert.That(columns["layer"], Is.EqualTo(new long[] { 0, -1 }));
        Assert.That(columns["speed"], Is.EqualTo(new long[] { 2050, 10000 }));
    }

    [Test]
    public void A_page_needs_no_network_and_holds_no_open_placeholder()
    {
        var page = Page(new ViewerContent("<b>&{{x") { Toolpath = GCodeDecoder.Decode(Encoding.ASCII.GetBytes(Code)).Value!.Toolpath,
            GCode = Encoding.ASCII.GetBytes(Code) });
        Assert.That(Regex.IsMatch(page, @"(src|href)\s*=|https?://|@import"), Is.False);
        Assert.That(page, Does.Contain("<title>&lt;b&gt;&amp;&#123;&#123;x</title>"));
        Assert.That(Regex.IsMatch(page, @"\{\{[a-z]+\}\}"), Is.False);
        Assert.That(Encoding.ASCII.GetString(Unzip(Part(page, "gcodeData"))), Is.EqualTo(Code));
    }

    [Test]
    public void A_script_holds_the_whole_page_and_its_style()
    {
        var content = new ViewerContent("a") { GCode = Encoding.ASCII.GetBytes(Code) };
        using var script = new MemoryStream();
        ViewerPage.WriteScript(content, script);
        var page = Page(content);
        Assert.That(page, Does.StartWith("<!DOCTYPE html>").And.Match(@"<style>\s*[^<\s]"));
        Assert.That(Encoding.ASCII.GetString(script.ToArray()), Does.Contain(JsonConvert.ToString(page, '"', StringEscapeHandling.EscapeNonAscii)));
    }

    [Test]
    public void Writing_can_be_canceled()
    {
        var moves = new ViewerContent("a") { Toolpath = GCodeDecoder.Decode(Encoding.ASCII.GetBytes(Code)).Value!.Toolpath };
        foreach (var content in new[] { moves, new ViewerContent("a") { GCode = Encoding.ASCII.GetBytes(Code) } })
            Assert.That(() => ViewerPage.Write(content, Stream.Null, cancel: new CancellationToken(true)), Throws.InstanceOf<OperationCanceledException>());
    }

    [Test]
    public void Texts_of_the_input_cannot_end_the_script()
    {
        var finding = new Diagnostic(Severity.Error, "bed.outside", "</script><script>alert(1)</script>", new SourceLocation("a.gcode", 3, Move: 1));
        var page = Page(new ViewerContent("</script>") { Toolpath = GCodeDecoder.Decode(Encoding.ASCII.GetBytes(Code)).Value!.Toolpath, Findings = [finding] });
        Assert.That(page, Does.Not.Contain("alert(1)</script>"));
        Assert.That((string)Head(page)["findings"]![0]!["message"]!, Is.EqualTo(finding.Message));
        Assert.That((int)Head(page)["findings"]![0]!["line"]!, Is.EqualTo(3));
    }

    [Test]
    public void Every_finding_is_an_entry_of_its_own_with_its_row_and_line()
    {
        var toolpath = GCodeDecoder.Decode(Encoding.ASCII.GetBytes(Code)).Value!.Toolpath;
        Diagnostic[] findings =
        [
            new(Severity.Error, "bed.outside", "Out.", new SourceLocation("a.gcode", 8, Move: 2)), new(Severity.Note, "gcode.ignored", "Nothing.", null),
            new(Severity.Warning, "extrusion.width", "Wide.", new SourceLocation(Move: 1_000_000)),
        ];
        var head = Head(Page(new ViewerContent("a") { Toolpath = toolpath, Findings = findings }));
        Assert.That(head["findings"]!.Select(f => (string)f["severity"]!), Is.EqualTo(new[] { "Error", "Note", "Warning" }));
        Assert.That((int)head["findings"]![0]!["line"]!, Is.EqualTo(8));
        Assert.That(head["findings"]![1]!["row"], Is.Null);
        Assert.That((int)head["findings"]![2]!["row"]!, Is.EqualTo((int)head["rows"]!));
    }

    [Test]
    public void A_model_keeps_its_triangles()
    {
        var mesh = TriMesh.Create([new Vec3(0, 0, 0), new Vec3(10.5, 0, 0), new Vec3(0, -7.25, 0), new Vec3(0, 0, 3)], [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]);
        var parts = Parts(Unzip(Part(Page(new ViewerContent("a") { Model = mesh, Printer = new Printer() }), "modelData")));
        Assert.That(Numbers(parts[0], false), Is.EqualTo(mesh.Vertices.Select(v => (long)Math.Round(v.X * 1000))));
        Assert.That(Numbers(parts[3], false), Is.EqualTo(mesh.Indices.Select(i => (long)i)));
    }

    [Test]
    public void A_script_has_the_title_and_the_page_as_texts_of_ASCII()
    {
        using var memory = new MemoryStream();
        ViewerPage.WriteScript(new ViewerContent("Vase “a”"), memory);
        var script = Encoding.UTF8.GetString(memory.ToArray());
        Assert.That(script.All(c => c < 128), Is.True);
        Assert.That(script, Does.Contain("\"Vase \\u201ca\\u201d\""));
        Assert.That(Regex.Matches(script, "</html>").Count, Is.EqualTo(1));
    }

    [Test]
    public void Nothing_at_all_still_makes_a_page() => Assert.That(Page(new ViewerContent("")), Does.Contain("</html>"));

    [Test]
    public void Misuse_is_rejected()
    {
        Assert.That(() => ViewerPage.Write(null!, new MemoryStream()), Throws.ArgumentNullException);
        Assert.That(() => ViewerPage.Write(new ViewerContent(""), null!), Throws.ArgumentNullException);
        Assert.That(() => ViewerPage.WriteFile(new ViewerContent(""), null!), Throws.ArgumentNullException);
    }

    [Test]
    public void Columns_unpack_to_their_numbers()
        => Prop.ForAll(Gen.Choose(-1000, 1000).ListOf().ToArbitrary(), values => Unpacks(values, false) && Unpacks(values, true))
            .Check(Config.QuickThrowOnFailure);

    private static bool Unpacks(IEnumerable<int> values, bool runs)
    {
        var column = new PackedColumn("a", runs);
        var repeated = values.SelectMany(v => Enumerable.Repeat(v * 4_000_000_000L, Math.Abs(v % 4) + 1)).ToArray();
        foreach (var value in repeated) column.Add(value);
        return Numbers(column.ToBytes(), runs).SequenceEqual(repeated) && column.Count == repeated.Length;
    }

    [Test]
    public void Columns_take_numbers_of_any_size()
    {
        var column = new PackedColumn("a");
        foreach (var value in new[] { 0.0004, 0.0006, -1e300, 1e300, double.NaN, double.PositiveInfinity, 1.2e12 }) column.Add(value, 1e-3);
        Assert.That(Numbers(column.ToBytes(), false), Is.EqualTo(new[] { 0L, 1, -(long)1e15, (long)1e15, 0, (long)1e15, (long)1e15 }));
    }

    private static string Page(ViewerContent content)
    {
        using var memory = new MemoryStream();
        ViewerPage.Write(content, memory);
        return Encoding.UTF8.GetString(memory.ToArray());
    }

    private static JObject Head(string page) => JObject.Parse(Part(page, "head"));

    private static string Part(string page, string id)
        => Regex.Match(page, $"<script type=\"[a-z/]+\" id=\"{id}\">(.*?)</script>", RegexOptions.Singleline).Groups[1].Value;

    private static Dictionary<string, List<long>> Columns(string page, JObject head)
    {
        var runs = new[] { "what", "layer", "tool", "speed" };
        var parts = Parts(Unzip(Part(page, "moveData")));
        return head["columns"]!.Select((name, i) => (Name: (string)name!, Values: Numbers(parts[i], runs.Contains((string)name!)).ToList()))
            .ToDictionary(c => c.Name, c => c.Values);
    }

    private static byte[] Unzip(string base64)
    {
        using var packed = new GZipStream(new MemoryStream(Convert.FromBase64String(base64)), CompressionMode.Decompress);
        using var memory = new MemoryStream();
        packed.CopyTo(memory);
        return memory.ToArray();
    }

    private static List<byte[]> Parts(byte[] bytes)
    {
        var parts = new List<byte[]>();
        for (var at = 0; at < bytes.Length;)
        {
            var length = BitConverter.ToInt32(bytes, at);
            parts.Add(bytes.Skip(at + 4).Take(length).ToArray());
            at += 4 + length;
        }
        return parts;
    }

    private static IEnumerable<long> Numbers(byte[] bytes, bool runs)
    {
        long value = 0;
        for (var at = 0; at < bytes.Length;)
        {
            var coded = Number(bytes, ref at);
            value += (coded & 1) == 1 ? -(coded >> 1) - 1 : coded >> 1;
            var count = runs ? Number(bytes, ref at) : 1;
            for (var i = 0; i < count; i++) yield return value;
        }
    }

    private static long Number(byte[] bytes, ref int at)
    {
        long value = 0;
        for (var shift = 0; ; shift += 7)
        {
            var next = bytes[at++];
            value |= (long)(next & 0x7F) << shift;
            if (next < 0x80) return value;
        }
    }
}
