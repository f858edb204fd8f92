using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Text;
using System.Text.Json;
using Caterpillar.Tests;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

public class DecodeTests : CliFixture
{
    private const string Line = "G28\nG90\nM82\nG1 X10 Y10 Z0.2 F3000\nG1 X30 Y10 E1\nG1 X30 Y25 E2\n";

    [Test]
    public void Files_become_an_array_of_objects()
    {
        File.WriteAllText("a.gcode", Line);
        File.WriteAllBytes("b.gcode.gz", Packed(Line));
        var run = Run("decode", "a.gcode", "b.gcode.gz", "--json");
        Assert.That(run.Code, Is.Zero, run.Messages);
        var files = JsonDocument.Parse(run.Output).RootElement.EnumerateArray().ToArray();
        Assert.That(files.Select(f => f.GetProperty("file").GetString()), Is.EqualTo(new[] { "a.gcode", "b.gcode.gz" }));
        foreach (var file in files)
        {
            Assert.That(file.GetProperty("print_length").GetDouble(), Is.EqualTo(35).Within(1e-9));
            Assert.That(file.GetProperty("e_used").GetDouble(), Is.EqualTo(2).Within(1e-9));
            Assert.That(file.GetProperty("bytes_unpacked").GetInt32(), Is.EqualTo(Line.Length));
        }
        Assert.That(files[0].GetProperty("sha256_unpacked").GetString(), Is.EqualTo(files[1].GetProperty("sha256_unpacked").GetString()));
    }

    [Test]
    public void Standard_input_is_a_file_too_packed_or_not()
    {
        File.WriteAllText("a.gcode", Line);
        var table = Run("decode", "a.gcode", "--csv").Text;
        Assert.That(Run(Encoding.ASCII.GetBytes(Line), ["decode", "-", "--csv"]).Text, Is.EqualTo(table));
        Assert.That(Run(Packed(Line), ["decode", "-", "--csv"]).Text, Is.EqualTo(table));
        Assert.That(Run([], ["decode", "-", "--json"]).Code, Is.EqualTo(1), "nothing is no G-code");
    }

    [Test]
    public void The_table_has_a_row_for_each_move()
    {
        File.WriteAllText("a.gcode", Line);
        var rows = Run("decode", "a.gcode", "--csv").Text.TrimEnd('\n').Split('\n');
        Assert.That(rows[0], Does.StartWith("move,line,kind,x,y,z,e,"));
        var columns = rows[0].Split(',');
        var print = rows.Skip(1).Select(r => r.Split(',')).Where(r => r[2] == "print").ToArray();
        Assert.That(print.Select(r => r[1]), Is.EqualTo(new[] { "5", "6" }));
        Assert.That(print[1].Zip(columns, (v, k) => k + "=" + v),
            Is.SupersetOf(new[] { "x=30", "y=25", "z=0.2", "e=1", "deposited_e=1", "speed_mm_s=50", "length_mm=15" }));
        Assert.That(rows.Skip(1).Select(r => r.Split(',')[Array.IndexOf(columns, "layer")]), Is.EqualTo(new[] { "-1", "0", "0" }), "Travel is in no layer.");
        Assert.That(rows.Select(r => r.Split(',').Length), Is.All.EqualTo(columns.Length));
        Assert.That(Run("decode", "a.gcode", "a.gcode", "--csv").Text.Split('\n')[1], Does.StartWith("a.gcode,0,"));
        // A quarter of a circle about (20, 10), clockwise.
        var code = Encoding.ASCII.GetBytes("G28\nM83\nG1 X10 Y10 Z0.2 F3000\nG2 X20 Y20 I10 J0 E1\n");
        var arc = Run(code, ["decode", "-", "--csv"]).Text.TrimEnd('\n').Split('\n').Last().Split(',');
        Assert.That(arc.Length, Is.EqualTo(columns.Length));
        Assert.That(arc.Zip(columns, (v, k) => k + "=" + v),
            Is.SupersetOf(new[] { "arc_center_x=20", "arc_center_y=10", "arc_center_z=0.2", "arc_sweep_deg=-90", "length_mm=15.707963" }));
    }

    [Test]
    public void The_rule_of_the_paper_can_be_asked_for()
    {
        File.WriteAllText("a.gcode", "G90\nM83\nG1 X0 Y0 Z1 F600\nG1 X10 E1\nG1 E-2\nG1 X20 E2\nG1 X30 E1\n");
        Assert.That(Prints("balance"), Is.EqualTo(2));
        Assert.That(Prints("rising"), Is.EqualTo(3));

        int Prints(string rule)
            => JsonDocument.Parse(Run("decode", "a.gcode", "--json", "--rule", rule).Output).RootElement[0].GetProperty("print_segments").GetInt32();
    }

    [Test]
    public void One_bad_file_suppresses_all_output()
    {
        File.WriteAllText("a.gcode", Line);
        File.WriteAllBytes("b.gcode.gz", Packed(Line).Take(25).ToArray());
        var run = Run("decode", "a.gcode", "b.gcode.gz", "--json");
        Assert.That((run.Code, run.Text), Is.EqualTo((1, "")));
        Assert.That(run.Messages, Does.Contain("b.gcode.gz"));
        Assert.That(Run("decode", "a.gcode", "none.gcode").Code, Is.EqualTo(1));
        foreach (var verb in new[] { "image", "convert", "check" }) Assert.That(Run(verb, "b.gcode.gz", "-o", "out").Code, Is.InRange(1, 2), verb);
        Assert.That(File.Exists("out"), Is.False);
    }

    [Test]
    public void Any_bytes_are_read_and_what_is_no_G_code_is_refused()
    {
        var random = new Random(3);
        var bytes = new byte[20_000];
        random.NextBytes(bytes);
        File.WriteAllBytes("a.gcode", bytes);
        Assert.That(Run("decode", "a.gcode", "--json").Messages, Does.Contain("binary data"));
        Assert.That(Run("decode", "a.gcode", "--csv").Code, Is.EqualTo(1));
        for (var i = 0; i < bytes.Length; i++) bytes[i] = bytes[i] == 0 || i % 16 == 0 ? (byte)'\n' : bytes[i];
        bytes = [.. bytes, .. Enumerable.Repeat("\nG1 X1 E1", 200).SelectMany(Encoding.ASCII.GetBytes)];
        File.WriteAllBytes("a.gcode", bytes);
        Assert.That(Run("decode", "a.gcode", "--json").Code, Is.Zero);
    }

    [Test]
    public void The_objects_have_the_keys_of_the_known_results()
    {
        var truth = JsonDocument.Parse(TestData.GCodeTruth()).RootElement;
        foreach (var name in new[] { "hand_g92_offsets.gcode", "ps_overlap_two_tools.gcode", "cu_overlap_bfb_M101.gcode", "hand_crlf_bom_noeol.gcode" })
        {
            var run = Run("decode", TestData.Shared("gcode/" + name), "--json", "--flavor", "slicer", "--rule", "rising");
            var mine = JsonDocument.Parse(run.Output).RootElement[0];
            var expected = truth.GetProperty(name);
            Assert.That(Keys(mine), Is.EqualTo(Keys(expected)), name);
            Assert.That(mine.GetProperty("sha256_unpacked").GetString(), Is.EqualTo(expected.GetProperty("sha256_unpacked").GetString()), name);
            Assert.That(mine.GetProperty("print_segments").GetInt32(), Is.EqualTo(expected.GetProperty("print_segments").GetInt32()), name);
        }
    }

    private static IEnumerable<string> Keys(JsonElement value)
        => value.EnumerateObject().Select(p => p.Name).Where(n => !n.StartsWith("e_total", StringComparison.Ordinal));

    private static byte[] Packed(string text)
    {
        using var memory = new MemoryStream();
        using (var zip = new GZipStream(memory, CompressionLevel.Fastest)) zip.Write(Encoding.ASCII.GetBytes(text));
        return memory.ToArray();
    }
}
