using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Tests.Jobs;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>Conversions to another flavor: what has an equivalent is translated, what has none is left out and counted.</summary>
public class TranslationTests
{
    private const string Print = ";LAYER:0\nG1 X50 Y50 Z0.2 F3000\nG1 X70 E0.7\n";

    public static IEnumerable<TestCaseData> Lines()
    {
        (string From, string Line, string To, string Expected)[] cases =
        [
            ("marlin2", "M900 K0.05", "klipper", "SET_PRESSURE_ADVANCE ADVANCE=0.05"),
            ("klipper", "SET_PRESSURE_ADVANCE ADVANCE=0.05 SMOOTH_TIME=0.04", "reprapfirmware", "M572 D0 S0.05"),
            ("klipper", "SET_PRESSURE_ADVANCE EXTRUDER=extruder ADVANCE=0.05", "bambu", "M900 K0.05"),
            ("reprapfirmware", "M572 D0 S0.05", "marlin2", "M900 K0.05"),
            ("marlin2", "M420 S1", "klipper", "BED_MESH_PROFILE LOAD=default"),
            ("marlin2", "M420 S0", "reprapfirmware", "G29 S2"),
            ("marlin2", "G29", "klipper", "BED_MESH_CALIBRATE"),
            ("klipper", "SET_VELOCITY_LIMIT ACCEL=3000", "marlin2", "M204 S3000"),
            ("marlin2", "M204 P800 T900", "klipper", "M204 S800"),
            ("marlin2", "M205 X10", "reprapfirmware", "M566 X600"),
            ("klipper", "SET_RETRACTION RETRACT_LENGTH=0.8 RETRACT_SPEED=40", "marlin2", "M207 S0.8 F2400"),
            ("marlin2", "M207 S0.8 F2400", "klipper", "SET_RETRACTION RETRACT_LENGTH=0.8 RETRACT_SPEED=40"),
            ("klipper", "SET_DISPLAY_TEXT MSG=Layer 3", "marlin2", "M117 Layer 3"),
            ("klipper", "PAUSE", "prusa", "M601"),
            ("bambu", "M106 P2 S100", "klipper", ""),
            ("marlin2", "M73 P10 R5", "repetier", "M73 P10 R5"),
            ("klipper", "SET_HEATER_TEMPERATURE HEATER=heater_bed TARGET=50", "marlin2", "M140 S50"),
            ("bambu", "M73 L4", "klipper", "SET_PRINT_STATS_INFO CURRENT_LAYER=4"),
            ("bambu", "M1002 gcode_claim_action : 2", "marlin2", ""),
            ("klipper", "TURN_OFF_HEATERS", "marlin2", "M140 S0\nM104 S0"),
            ("klipper", "M106 S127.5", "reprapfirmware", "M106 S127.5"),
        ];
        return cases.Select(c => new TestCaseData(c.From, c.Line, c.To, c.Expected).SetArgDisplayNames(c.From, c.Line, c.To));
    }

    [TestCaseSource(nameof(Lines))]
    public void A_line_is_written_in_the_words_of_the_target(string from, string line, string to, string expected)
    {
        var lines = Converted($"G28\nM109 S200\nM83\n{Print}{line}\nG1 X90 E0.7\n", from, to).Text.Split('\n').ToList();
        var at = lines.FindIndex(l => l.StartsWith("G1 X70", StringComparison.Ordinal));
        var between = lines.Skip(at + 1).TakeWhile(l => !l.StartsWith("G1 X90", StringComparison.Ordinal));
        Assert.That(string.Join("\n", between), Is.EqualTo(expected));
    }

    [Test]
    public void Objects_are_marked_in_the_notation_of_the_target()
    {
        const string Klipper = "EXCLUDE_OBJECT_DEFINE NAME=cup CENTER=1,1\nEXCLUDE_OBJECT_DEFINE NAME=lid\nG28\nM109 S200\nM83\n;LAYER:0\n"
            + "EXCLUDE_OBJECT_START NAME=lid\nG1 X9 E1\nEXCLUDE_OBJECT_END NAME=lid\n";
        Assert.That(Converted(Klipper, "klipper", "marlin2").Text, Does.Contain(";LAYER:0\nM486 T2\nM486 S1\nM83\nG1 X9 E1\nM486 S-1\n"));
        var named = Converted(Klipper, "klipper", "reprapfirmware").Text;
        Assert.That(named, Does.Contain("M486 S1 A\"lid\"\n"));
        var back = Converted(named, "reprapfirmware", "klipper").Text;
        Assert.That(back, Does.Contain("EXCLUDE_OBJECT_START NAME=lid\nM83\nG1 X9 E1\nEXCLUDE_OBJECT_END NAME=lid\n"));
        Assert.That(Converted(Klipper, "klipper", "smoothie").Text, Does.Not.Contain("OBJECT").And.Not.Contain("M486"));
    }

    // Masks of 8 bytes, the lowest first: objects 0 and 2, and both at once.
    [Test]
    public void Masks_of_objects_of_Bambu_become_marks_of_the_target()
    {
        const string Bambu = "; model label id: 66,71,90\nG28\nM109 S200\nM83\n;LAYER:0\nM624 BQAAAAAAAAA=\nG1 X1\nM625\n"
            + "M624 AQAAAAAAAAA=\nG1 X9 E1\nM625\nM624 BAAAAAAAAAA=\nG1 X19 E1\nM625\nM624 ?\nM625\nG1 X20 E1\n";
        var marlin = Converted(Bambu, "bambu", "marlin2");
        Assert.That(marlin.Text, Does.Contain("G1 X1\nM486 T1\nM486 S0\nM83\nG1 X9 E1\nM486 S-1\nM486 S2\nG1 X19 E1\nM486 S-1\nG1 X20 E1\n"));
        Assert.That(marlin.Found.Select(d => d.Code), Has.None.EqualTo("gcode.commands_lost"));
        Assert.That(Converted(Bambu, "bambu", "klipper").Text,
            Does.Contain("EXCLUDE_OBJECT_START NAME=object_2\nG1 X19 E1\nEXCLUDE_OBJECT_END NAME=object_2\n"));
        Assert.That(Converted(Bambu, "bambu", "smoothie").Text, Does.Not.Contain("M62").And.Not.Contain("M486"));
    }

    [Test]
    public void What_has_no_equivalent_is_counted_by_name()
    {
        var found = Converted("G28\nM109 S200\nM83\n" + Print + "M622 J1\nM622 J1\nM623\nG1 X80 E1\n", "bambu", "marlin2").Found;
        Assert.That(found.Single(d => d.Code == "gcode.commands_lost").Message, Does.Contain("M622 (2), M623 (1)"));
    }

    [Test]
    public void A_start_macro_that_is_lost_needs_new_start_code()
    {
        var text = "START_PRINT BED_TEMP=60 EXTRUDER_TEMP=200\nM83\n" + Print;
        var decoded = GCodeDecoder.Decode(GCodeDocument.FromText(text), new DecodeOptions { Flavor = FlavorTable.Klipper }).OrThrow();
        var refused = GCodeConverter.ToDocument(decoded, new ConvertOptions { Flavor = FlavorTable.Marlin2 });
        Assert.That(refused.Diagnostics.Single(d => d.Code == "gcode.start_lost").Message, Does.Contain("homes and heats").And.Contain("--start-gcode"));
        var code = new EditOptions { Start = ["G28", "M109 S200", "MY_MACRO"] };
        var own = new Caterpillar.Jobs.FileJob(decoded) { Code = code, Target = new ConvertOptions { Flavor = FlavorTable.Marlin2 } };
        using var stream = new System.IO.MemoryStream();
        own.Write(stream, "a.gcode", null).OrThrow();
        Assert.That(PrinterEye.Text(stream.ToArray()), Does.StartWith("; Flavor marlin2\nG28\nM109 S200\nMY_MACRO\n"));
    }

    // One for each kind of extruder and retraction; all of them in full runs.
    private static readonly string[] Quick = ["cu_tube", "ps_nested", "ps_overlap", "s3r_nested"];

    public static IEnumerable<string> Files()
        => GCodeFiles.Affordable().Where(f => !f.EndsWith(".gz", StringComparison.Ordinal) && !f.Contains("hand_") && !f.Contains("bfb"))
            .Where(f => Rounds.Full || f == "none" || Quick.Any(q => f.StartsWith(q, StringComparison.Ordinal)));

    [TestCaseSource(nameof(Files))]
    [Category("Arithmetic")]
    public void Every_line_of_a_converted_file_is_known_to_its_flavor_and_prints_the_same(string name)
    {
        var decoded = GCodeDecoder.Decode(GCodeFiles.Document(name)).OrThrow();
        var letter = decoded.Report.ExtrusionAxis[0];
        var before = new PrinterEye(PrinterEye.Text(decoded.Document!.ToBytes()), letter);
        foreach (var target in FlavorTable.All.Where(f => f.ExtruderLetters.Length > 0 && f.Name != decoded.Flavor.Name))
        {
            var options = new ConvertOptions { Flavor = target, FilamentDiameter = 1.75, RetractionLength = 1 };
            var result = GCodeConverter.ToDocument(decoded, options);
            if (result.Diagnostics.Any(d => d.Code == "gcode.start_lost")) continue;
            var text = PrinterEye.Text(result.OrThrow().ToBytes());
            var commands = FlavorCommands.Of(target);
            var unknown = text.Split('\n').Select(l => l.Split(';')[0].Trim())
                .Where(l => l.Length > 0 && l[0] != '(' && commands.Find(l) is not { IsKnown: true });
            Assert.That(unknown.Take(3), Is.Empty, $"{name} to {target.Title}");
            var after = new PrinterEye(text, target.ExtruderLetters[0]);
            Assert.That(after.Printed, Is.EqualTo(before.Printed).Within(1e-4 * before.Printed), $"{name} to {target.Title}");
            Assert.That(after.Heat, Is.EqualTo(before.Heat), $"{name} to {target.Title}");
        }
    }

    private static (string Text, IReadOnlyList<Caterpillar.Basics.Diagnostic> Found) Converted(string text, string from, string to)
    {
        var decoded = GCodeDecoder.Decode(GCodeDocument.FromText(text), new DecodeOptions { Flavor = FlavorTable.Find(from) }).OrThrow();
        var result = GCodeConverter.ToDocument(decoded, new ConvertOptions { Flavor = FlavorTable.Find(to) });
        return (PrinterEye.Text(result.OrThrow().ToBytes()), result.Diagnostics);
    }
}
