using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Tests.Flavors;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>Commands planted into good prints: at the start, within the print and at the end, in each flavor and by each writer.</summary>
public class PlantedCommandTests
{
    private const int Wanted = 200;
    private const string Mine = "MY_OWN_MACRO";
    private static readonly string[] Places = ["start", "within", "end"];
    private static readonly string[] Writers = ["check", "raw", "template", "layer", "code"];

    // Commands that the decoder follows, with words that do no harm.
    private static readonly string[] Followed =
    [
        "G0 F1800", "G1 F1800", "G4 P10", "G5 I0 J0 P0 Q0", "G10 P0 S215", "G10 L2 P9 X5", "G11", "G17", "G21", "G53", "G54", "G60", "G61 S3", "G90", "G91.1",
        "G92 E0", "G92.1", "M83", "M104 S210", "M106 S100", "M107", "M109 S210", "M120", "M121", "M140 S60", "M190 S60", "M200 D0", "M201 X500", "M203 X6000",
        "M204 S500", "M205 X5", "M207 S0.8 F2100 Z0", "M208 S0 F2100", "M220 S100", "M221 S100", "M400", "M486 S-1", "M566 X600", "M568 P0 S210", "M1020 S0",
        "T0", "SET_GCODE_OFFSET Z=0", "SAVE_GCODE_STATE NAME=A", "SET_VELOCITY_LIMIT VELOCITY=200",
        "ACTIVATE_EXTRUDER EXTRUDER=extruder", "SET_RETRACTION RETRACT_LENGTH=0.8", "SET_HEATER_TEMPERATURE HEATER=extruder TARGET=210",
        "EXCLUDE_OBJECT_START NAME=A", "EXCLUDE_OBJECT_END",
    ];

    // Those whose prints are written with E.
    private static readonly FlavorRules[] Printing =
    [
        FlavorTable.Marlin2, FlavorTable.Marlin1, FlavorTable.Prusa, FlavorTable.Bambu, FlavorTable.Klipper,
        FlavorTable.Find("reprapfirmware")!, FlavorTable.Find("repetier")!, FlavorTable.Find("smoothie")!,
    ];

    /// <summary>Every command of every flavor, within a print, is named where it may do harm.</summary>
    [Test]
    public void Every_command_of_every_flavor_is_judged_by_what_it_does()
    {
        var wrong = new List<string>();
        var count = 0;
        foreach (var flavor in FlavorTable.All)
        {
            foreach (var command in CommandsOf(flavor))
            {
                count++;
                var line = FlavorCommandTests.LineOf(command);
                var found = Check(flavor, line, "within").Where(d => Names(d, line)).ToArray();
                string[] expected = command.Use switch
                {
                    CommandUse.Never or CommandUse.Start or CommandUse.End or CommandUse.Untracked => [CheckCodes.UnsafeCommand],
                    CommandUse.Pause => [CheckCodes.PauseCommand],
                    CommandUse.Depends => [CheckCodes.MachineCommand],
                    _ => [],
                };
                var codes = found.Select(d => d.Code).Where(c => c.StartsWith("command.", StringComparison.Ordinal)).ToArray();
                if (!codes.SequenceEqual(expected)) wrong.Add($"{flavor.Name} {line}: {string.Join(" ", codes)}");
            }
        }
        Assert.That(wrong, Is.Empty);
        Assert.That(count, Is.GreaterThan(1000));
    }

    [Test]
    public void Of_200_dangerous_programs_each_is_refused_or_named()
    {
        var silent = new List<string>();
        var done = 0;
        foreach (var (flavor, line, place, writer) in Some(Dangerous))
        {
            done++;
            var (refused, found) = Write(flavor, line, place, writer);
            if (!refused && !found.Any(d => Names(d, line))) silent.Add($"{flavor.Name} {line} {place} {writer}");
        }
        Assert.That(silent, Is.Empty);
        Assert.That(done, Is.EqualTo(Wanted));
    }

    [Test]
    public void Of_200_harmless_programs_none_is_refused()
    {
        var refused = new List<string>();
        var done = 0;
        foreach (var (flavor, line, place, writer) in Some(Harmless))
        {
            done++;
            var written = Write(flavor, line, place, writer);
            var errors = written.Found.Where(d => d.Severity == Severity.Error).ToArray();
            if (!written.Refused && errors.Length == 0) continue;
            refused.Add($"{flavor.Name} {line} {place} {writer}: {string.Join(" ", errors.Select(e => e.ToString()))}");
        }
        Assert.That(refused, Is.Empty);
        Assert.That(done, Is.EqualTo(Wanted));
    }

    // What shifts, scales or moves in a way that the decoder follows is found by what it does, or named.
    [TestCase("marlin2", "M206 Z0.3")]
    [TestCase("marlin2", "M206 Z-0.6")]
    [TestCase("marlin2", "M206 X30")]
    [TestCase("prusa", "M206 Z0.3")]
    [TestCase("reprapfirmware", "M206 Z0.3")]
    [TestCase("marlin2", "M290 Z-0.3")]
    [TestCase("marlin2", "M290 Z2")]
    [TestCase("reprapfirmware", "M290 S-0.3")]
    [TestCase("repetier", "M290 Z-0.3")]
    [TestCase("marlin2", "M428")]
    [TestCase("marlin2", "M851 Z-1")]
    [TestCase("marlin2", "G60\nG1 Z-1 F600\nG61")]
    [TestCase("marlin2", "G60\nG61 Z-2")]
    [TestCase("reprapfirmware", "G60 S2\nG1 R2 Z-2")]
    [TestCase("marlin2", "G5 X60 Y60 I0 J0 P0 Q0 E500")]
    [TestCase("marlin2", "G55")]
    [TestCase("marlin2", "G54\nG92 Z5")]
    [TestCase("reprapfirmware", "G55")]
    [TestCase("smoothie", "G10 L2 P2 Z-3\nG55")]
    [TestCase("marlin2", "M207 S700")]
    [TestCase("klipper", "SET_RETRACTION RETRACT_LENGTH=700")]
    [TestCase("marlin2", "G10\nM207 S5\nG11")]
    [TestCase("klipper", "G10\nSET_RETRACTION RETRACT_LENGTH=5\nG11")]
    [TestCase("marlin2", "M209 S1")]
    [TestCase("klipper", "SET_GCODE_OFFSET Z=-0.3")]
    [TestCase("klipper", "SET_GCODE_OFFSET X=30")]
    [TestCase("klipper", "SET_GCODE_OFFSET Z_ADJUST=-1 MOVE=1")]
    public void Offsets_and_retractions_that_do_harm_within_a_print_are_found(string flavor, string lines)
    {
        var rules = FlavorTable.Find(flavor)!;
        foreach (var writer in new[] { "check", "raw" })
        {
            var before = Write(rules, "M117", "within", writer).Found.Select(d => d.Code).ToHashSet();
            var (refused, found) = Write(rules, lines, "within", writer);
            var news = found.Where(d => !before.Contains(d.Code) && d.Severity >= Severity.Warning).ToArray();
            Assert.That(refused || news.Length > 0, Is.True, writer);
        }
    }

    [Test]
    public void What_is_not_understood_is_named_with_its_lines_and_only_declared_macros_are_written()
    {
        var said = Check(FlavorTable.Klipper, Mine, "within").Single(d => d.Code == CheckCodes.UnknownCommand);
        Assert.That(said.Severity, Is.EqualTo(Severity.Warning));
        Assert.That(said.Message, Does.Contain(Mine + " (line 22)").And.Contain("unverified"));
        var setup = SetupOf(FlavorTable.Klipper);
        var refused = SafeWriter.ToDocument(Plan(Mine, "within"), setup);
        Assert.That(refused.Value, Is.Null);
        Assert.That(refused.Diagnostics.Single(d => d.Code == CheckCodes.UnverifiedCommand).Message, Does.Contain(Mine));
        Assert.That(SafeWriter.ToDocument(Plan(Mine, "within"), setup, "a test").Value, Is.Not.Null);
        var declared = setup with { Printer = setup.Printer with { Macros = new(Mine) } };
        Assert.That(SafeWriter.ToDocument(Plan(Mine, "within"), declared).Value, Is.Not.Null);
        var homes = setup with { Printer = setup.Printer with { Macros = new(Mine + "=homes") } };
        Assert.That(SafeWriter.ToDocument(Plan(Mine, "within"), homes).Diagnostics.Select(d => d.Code), Does.Contain(CheckCodes.UnsafeCommand));
    }

    [Test]
    public void A_start_macro_that_is_declared_homes_and_heats()
    {
        var text = "MY_START\nG90\nM83\nG1 X10 Y10 Z0.2 F3000\nG1 X20 E0.3\nMY_END\n";
        var setup = SetupOf(FlavorTable.Klipper);
        string[] Codes(params string[] macros) => PrintCheck.Run(SmallPrint.Decode(Encoding.ASCII.GetBytes(text), setup),
            setup with { Printer = setup.Printer with { Macros = new(macros) } }).Select(d => d.Code).ToArray();
        Assert.That(Codes("MY_START=homes heats", "my_end=cools"), Is.Empty);
        Assert.That(Codes("MY_START=heats", "MY_END"), Is.EqualTo(new[] { CheckCodes.NoHoming }));
        Assert.That(Codes("MY_START=homes", "MY_END"), Is.EqualTo(new[] { CheckCodes.NoHeating }));
        Assert.That(Codes(), Is.EqualTo(new[] { CheckCodes.UnknownCommand }));
        var both = PrintCheck.Run(SmallPrint.Decode(Encoding.ASCII.GetBytes(text), setup), setup).Single();
        Assert.That(both.Count, Is.EqualTo(2), "one finding for both");
    }

    // A macro may leave the head anywhere: the file must home, or state each axis, before it prints.
    [TestCase("START_PRINT\nG1 X10 Y10 Z0.2", "")]
    [TestCase("START_PRINT\nG1 X0 Y0 Z0", "")]
    [TestCase("START_PRINT\nG1 Z0.2\nG1 Y5\nG1 E1\nG1 X10", "")]
    [TestCase("START_PRINT\nG28", "")]
    [TestCase("START_PRINT\nG28 X Y\nG1 X10 Y10", "Z")]
    [TestCase("START_PRINT\nG1 X10 Y10", "Z")]
    [TestCase("START_PRINT", "X, Y, Z")]
    [TestCase("START_PRINT\nG91\nG1 X10 Y10 Z5\nG90", "X, Y, Z")]
    [TestCase("G28\nG1 X10 Y10 Z0.2\nMY_PURGE", "X, Y, Z")]
    [TestCase("MY_PURGE\nG28\nG1 X10 Y10 Z0.2", "")]
    [TestCase("G28\nG1 X10 Y10 Z0.2\nMY_CLEAN", "")]
    [TestCase("G28\nG1 X10 Y10 Z0.2\nSET_FAN_SPEED FAN=a SPEED=1", "")]
    public void After_a_macro_the_position_is_unknown_until_the_file_states_it(string start, string axes)
    {
        var setup = SetupOf(FlavorTable.Klipper);
        setup = setup with { Printer = setup.Printer with { Macros = new("MY_CLEAN") } };
        var text = "M83\nM109 S210\n" + start + "\nG1 X20 E0.3 F600\nG1 X30 Y20 Z0.2 E0.3\nMY_PURGE\nG1 Y30 E0.4\nM104 S0\nM140 S0\n";
        var found = PrintCheck.Run(SmallPrint.Decode(Encoding.ASCII.GetBytes(text), setup), setup)
            .Where(d => d.Code == CheckCodes.UnknownPosition && d.Message.Contains("may have moved")).ToArray();
        if (axes.Length == 0) Assert.That(found, Is.Empty);
        else Assert.That(found.Single().Message, Does.Contain("position in " + axes + " is").And.Contain(" (line "));
    }

    [TestCase("MY START", "not the name")]
    [TestCase("=homes", "not the name")]
    [TestCase("MY_START=", "needs")]
    [TestCase("MY_START=flies", "flies")]
    public void A_wrong_declaration_is_an_error(string macro, string says)
    {
        var result = SetupOf(FlavorTable.Klipper).With("macros=" + macro);
        Assert.That(result.HasErrors, Is.True);
        Assert.That(result.Diagnostics[0].Message, Does.Contain(says));
    }

    // The position is lost unless the file homes again.
    [TestCase("M84\nG28", 0)]
    [TestCase("M84\nG28 X Y", 1)]
    [TestCase("M84\nG28 X Y\nG28 Z", 0)]
    [TestCase("M84", 1)]
    public void Motors_off_before_the_print_need_homing(string lines, int errors)
        => Assert.That(Check(FlavorTable.Marlin2, lines, "start").Count(d => d.Code == CheckCodes.UnsafeCommand), Is.EqualTo(errors));

    // The first line of the print extrudes.
    [Test]
    public void What_follows_the_first_extrusion_is_within_the_print()
    {
        var setup = SmallPrint.Setup(p => p with { ProgressCommands = false });
        var print = new SmallPrint(60, 60, 0.2).Print(80, 60, 0.2).Event(new RawEvent("M84")).Print(80, 80, 0.2);
        var found = SafeWriter.ToDocument(print.Build(), setup).Diagnostics.Single(d => d.Code == CheckCodes.UnsafeCommand);
        Assert.That(found.Message, Does.StartWith("M84 within the print"));
    }

    [Test]
    public void A_print_of_dots_is_a_print_and_a_file_with_a_purge_line_alone_is_none()
    {
        var setup = SetupOf(FlavorTable.Marlin2);
        setup = setup with { Printer = setup.Printer with { EndGCode = new("M104 S0", "M140 S0", "M84") } };
        var dots = new SmallPrint(60, 60, 5).Go(60, 60, 0.3).Prime(0.1).Event(new RawEvent("M302 S0")).Go(80, 60, 0.3).Prime(0.1).Go(80, 60, 5);
        Assert.That(SafeWriter.ToDocument(dots.Build(), setup).Diagnostics.Select(d => d.Code), Does.Contain(CheckCodes.UnsafeCommand));
        setup = setup with { Printer = setup.Printer with { StartGCode = new([.. setup.Printer.StartGCode, "G1 X10 Y10 Z0.3", "G1 X50 E2 F600", "G1 Z5"]) } };
        Assert.That(SafeWriter.ToDocument(new SmallPrint(60, 60, 5).Go(80, 60, 5).Build(), setup).Diagnostics.Select(d => d.Code),
            Has.None.StartsWith("command."));
    }

    [TestCase("SET_HEATER_TEMPERATURE HEATER=extruder", 1)]
    [TestCase("SET_HEATER_TEMPERATURE HEATER=extruder TARGET=0", 1)]
    [TestCase("SET_HEATER_TEMPERATURE HEATER=extruder TARGET=215", 0)]
    [TestCase("SET_HEATER_TEMPERATURE HEATER=heater_bed", 0)]
    [TestCase("TURN_OFF_HEATERS", 1)]
    [TestCase("M104", 1)]
    [TestCase("M140", 0)]
    public void Klipper_switches_heaters_off_without_a_temperature(string line, int cold)
        => Assert.That(Check(FlavorTable.Klipper, line, "within").Count(d => d.Code == CheckCodes.ColdExtrusion), Is.EqualTo(cold));

    [TestCase("M568 P0 A0", 1)]
    [TestCase("M568 P0 S20", 1)]
    [TestCase("M568 P0 S215", 0)]
    [TestCase("M104", 0)]
    public void RepRapFirmware_heats_tools_by_M568(string line, int cold)
        => Assert.That(Check(FlavorTable.Find("reprapfirmware")!, line, "within").Count(d => d.Code == CheckCodes.ColdExtrusion), Is.EqualTo(cold));

    [Test]
    public void Writers_say_what_the_decoder_notices()
    {
        var written = SafeWriter.ToDocument(Plan("M428", "end"), SetupOf(FlavorTable.Marlin2));
        var said = written.Diagnostics.Single(d => d.Code == "gcode.unsupported_motion");
        Assert.That(said.Message, Does.Contain("M428"));
        var lines = Encoding.ASCII.GetString(written.Value!.ToBytes()).Split('\n');
        Assert.That(lines[said.Source!.Line!.Value - 1], Is.EqualTo("M428"));
    }

    private static IEnumerable<FlavorCommand> CommandsOf(FlavorRules flavor)
        => CommandTable.Rows.Where(r => r.Flavors.Contains(flavor.Name)).SelectMany(r => r.Commands);

    private static IEnumerable<string> Dangerous(FlavorRules flavor)
        => CommandsOf(flavor).Where(c => c.Use is not (CommandUse.Ok or CommandUse.Tracked or CommandUse.Ignored)).Select(FlavorCommandTests.LineOf)
            .Concat([Mine, "M104 S0", "G98765", "M140 S400"]);

    // Marks of objects and the like do nothing, and what the decoder follows does no harm with these words.
    private static IEnumerable<string> Harmless(FlavorRules flavor)
        => CommandsOf(flavor).Where(c => c.Use is CommandUse.Ok or CommandUse.Ignored && c.Name != "%*").Select(FlavorCommandTests.LineOf)
            .Concat(Followed.Where(l => FlavorCommands.Of(flavor).Find(l) is { Use: CommandUse.Tracked }));

    // Each flavor, place and writer in turn, with commands from all over the table.
    private static IEnumerable<(FlavorRules Flavor, string Line, string Place, string Writer)> Some(Func<FlavorRules, IEnumerable<string>> lines)
    {
        var all = Printing.Select(f => lines(f).ToArray()).ToArray();
        for (var i = 0; i < Wanted; i++)
        {
            var own = all[i % Printing.Length];
            var line = own[i * 37 % own.Length];
            var writer = Writers[i / Printing.Length % Writers.Length];
            var use = FlavorCommands.Of(Printing[i % Printing.Length]).Find(line)?.Use;
            // A line of a layer is within the print, start and end code are not, and some commands belong to one of these.
            var places = Places.Where(p => writer switch { "layer" => p == "within", "code" => p != "within", _ => true }
                && (p, use) is not ("start", CommandUse.Start) and not ("end", CommandUse.End)).ToArray();
            var place = places[(i + i / 40) % places.Length];
            yield return (Printing[i % Printing.Length], line, place, writer);
        }
    }

    private static bool Names(Diagnostic found, string line) => (" " + found.Message).Contains(" " + line.Split(' ')[0].ToUpperInvariant() + " ");

    private static (bool Refused, IReadOnlyList<Diagnostic> Found) Write(FlavorRules flavor, string line, string place, string writer)
    {
        if (writer == "check") return (false, Check(flavor, line, place));
        var setup = SetupOf(flavor);
        var plain = Encoding.ASCII.GetBytes(string.Join("\n", File(null, "")));
        if (writer is "layer" or "code")
        {
            var file = SmallPrint.Decode(plain, setup);
            var edited = writer == "code" ? file.Toolpath : file.Toolpath.InsertAtLayer(2, new RawEvent(line)).OrThrow();
            string[] lines = place == "start" ? [.. File(null, "").Take(9), line] : [line, "M104 S0", "M140 S0"];
            var code = writer != "code" ? null : place == "start" ? new EditOptions { Start = lines } : new EditOptions { End = lines };
            var result = SafeWriter.ToDocument(file, edited, setup, null, code);
            return (result.Value is null, result.Diagnostics);
        }
        if (writer == "template")
        {
            var printer = setup.Printer;
            setup = setup with { Printer = place switch
            {
                "start" => printer with { StartGCode = new([.. printer.StartGCode, line]) },
                "within" => printer with { LayerChangeGCode = new(line) },
                _ => printer with { EndGCode = new([line, .. printer.EndGCode]) },
            } };
        }
        var written = SafeWriter.ToDocument(Plan(writer == "raw" ? line : "", place), setup);
        return (written.Value is null, written.Diagnostics);
    }

    private static IReadOnlyList<Diagnostic> Check(FlavorRules flavor, string line, string place)
    {
        var setup = SetupOf(flavor);
        var lines = string.Join("\n", File(line, place));
        // Flavors without an extruder draw, and one switches it.
        if (flavor == FlavorTable.Grbl || flavor == FlavorTable.Find("cnc")!) lines = lines.Replace(" E0.66", "").Replace(" E0", "");
        if (flavor == FlavorTable.Find("bfb")!) lines = lines.Replace(" E0.66 F1800", " F1800\nM103").Replace(";LAYER", "M101\n;LAYER");
        var text = Encoding.ASCII.GetBytes(lines);
        var decoded = GCodeDecoder.Decode(text, new DecodeOptions { Flavor = flavor, FilamentDiameter = 1.75 });
        return [.. decoded.Diagnostics, .. PrintCheck.Run(decoded.Value!, setup)];
    }

    private static PrintSetup SetupOf(FlavorRules flavor) => SmallPrint.Setup(p => p with
    {
        Flavor = flavor,
        StartGCode = new("M140 S60", "M104 S210", "G28", "M190 S60", "M109 S210", "G90", "M83", "G1 Z5 F600"),
        EndGCode = new("G1 Z20 F600", "M104 S0", "M140 S0"),
    });

    // A wall of 20 mm and six layers.
    private static List<string> File(string? line, string place)
    {
        var lines = new List<string> { "M140 S60", "M104 S210", "G28", "M190 S60", "M109 S210", "G90", "M83", "G92 E0", "G1 Z5 F600" };
        if (line is not null && place == "start") lines.Add(line);
        for (var layer = 0; layer < 6; layer++)
        {
            if (line is not null && place == "within" && layer == 3) lines.Add(line);
            lines.Add(";LAYER:" + layer.ToString(CultureInfo.InvariantCulture));
            lines.Add("G1 Z" + (0.2 * (layer + 1)).ToString("0.0", CultureInfo.InvariantCulture) + " F600");
            lines.Add("G1 X" + (layer % 2 == 0 ? "60" : "80") + " Y60 F9000");
            lines.Add("G1 X" + (layer % 2 == 0 ? "80" : "60") + " E0.66 F1800");
        }
        lines.Add("G1 Z20 F600");
        if (line is not null && place == "end") lines.Add(line);
        lines.AddRange(["M104 S0", "M140 S0"]);
        return lines;
    }

    private static Toolpath Plan(string line, string place)
    {
        var print = new SmallPrint(60, 60, 5);
        if (place == "start" && line.Length > 0) print.Event(new RawEvent(line));
        for (var layer = 0; layer < 6; layer++)
        {
            if (place == "within" && line.Length > 0 && layer == 3) print.Event(new RawEvent(line));
            var z = 0.2 * (layer + 1);
            print.InLayer(new Layer(layer, z, 0.2)).Go(print.At.X, 60, z).Print(layer % 2 == 0 ? 80 : 60, 60, z);
        }
        if (place == "end" && line.Length > 0) print.Event(new RawEvent(line));
        return print.Go(print.At.X, 60, 20).Build();
    }
}
