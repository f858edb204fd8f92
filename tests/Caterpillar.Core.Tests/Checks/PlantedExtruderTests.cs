using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Machines;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>Faults of the extruder that are planted in files of slicers, and extruder moves of real start code and tool changes, which are none.</summary>
public class PlantedExtruderTests
{
    private static readonly string[] Looked = [CheckCodes.Stationary, CheckCodes.Amount, CheckCodes.ExtrusionMode, CheckCodes.Starved];

    private static readonly PrintSetup Setup = SmallPrint.Setup(p => p with
    {
        ToolOffsets = new(default, default),
        CheckSeverities = new([.. CheckCodes.All.Where(r => !Looked.Contains(r.Code)).Select(r => new CheckSeverity(r.Code, null))]),
    });

    private const string Start = "G28\nG90\nM83\nM109 S200\nG1 X10 Y10 Z0.2 F3000\n";
    private const string Line = "G1 X60 E1.66 F1200\nG1 Y10.5 E0.02\nG1 X10 E1.66\n";

    [TestCase("ps_spot_marlin2_relE.gcode.gz", "M82")]
    [TestCase("cu_cheburashka_marlin_relE_zhop.gcode.gz", "M82")]
    [TestCase("s3r_torus_repetier_relE_zhop.gcode.gz", "M82")]
    [TestCase("ps_torus_sequential.gcode.gz", "M83")]
    [TestCase("cu_tube_spiralize.gcode", "M83")]
    [TestCase("s3r_nested_smoothie_volE_fwr.gcode", "M83")]
    public void The_other_mode_of_E_from_any_line_on_is_an_error(string name, string mode)
    {
        var file = new SlicedFile(name);
        Assert.That(file.Extrusions.Where(i => !Refuses(file.With(i, mode + "\n" + file[i]))).Select(i => i + 1), Is.Empty, "without planted lines");
    }

    [TestCase("ps_plate_smoothie_volE_fwr.gcode")]
    [TestCase("ps_overlap_two_tools.gcode")]
    [TestCase("cu_plate_marlin_absE.gcode")]
    public void A_lost_point_is_an_error_and_a_wrong_sign_is_found(string name)
    {
        var file = new SlicedFile(name);
        foreach (var i in file.Extrusions)
        {
            var at = file[i].LastIndexOf(" E", StringComparison.Ordinal) + 2;
            var (before, word) = (file[i].Substring(0, at), file[i].Substring(at));
            Assert.That(Refuses(file.With(i, before + word.Replace(".", ""))), "point of line " + (i + 1));
            Assert.That(Found(file.With(i, before + "-" + word)), Is.Not.Empty, "sign of line " + (i + 1));
        }
    }

    // Purge lines of public start codes, a change of filament with cooling moves, a wipe, an extra restart that is negative.
    [TestCase("G1 X60 E9 F1000\nG1 X100 E12.5 F1000\n" + Line)]
    [TestCase("G1 X42 E10 F1800\n" + Line)]
    [TestCase("G1 X110 E50 F600\nG1 X200 E30 F1200\n" + Line)]
    [TestCase(Line + "G1 E-15 F6000\nG1 E-70 F5400\nG1 X60 E5 F2000\nG1 X10 E-5\nG1 X60 E5\nG1 X10 E-5\nT1\nG1 X60 E20 F2000\nG1 X10 E58\nG1 E7\n" + Line)]
    [TestCase(Line + "G1 X14 E-3 F6000\nG1 X16 E-3\nG1 X20 E-3\nG1 X30 F9000\nG1 E9 F2400\n" + Line)]
    [TestCase(Line + "G1 E-2 F6000\nG1 X30 F9000\nG1 E1.8 F2400\n" + Line)]
    public void What_printers_do_with_filament_is_no_fault(string text) => Assert.That(Found(Start + text), Is.Empty);

    [TestCase("G1 X60 E-500\n", CheckCodes.Amount, "1202.64 mm³ are retracted while the head moves, more than any retraction before. "
        + "Correct the E value, or the mode of E before it (M82, M83, G92).")]
    [TestCase("G1 X60 E-6\nG1 X20 E-6\n", CheckCodes.Amount, "28.86 mm³ are retracted while the head moves, more than any retraction before. "
        + "Correct the E value, or the mode of E before it (M82, M83, G92).")]
    [TestCase("G1 X60 E200\n", CheckCodes.Amount, "481.06 mm³ are extruded along 50 mm, far more than a nozzle of 0.4 mm prints. "
        + "Correct the E value, or the mode of E before it (M82, M83, G92).")]
    [TestCase("G1 X20 E-0.5\nG1 X60 E1.66\n", CheckCodes.Starved, "1.2 mm³ are retracted in the middle of an extrusion, which leaves a gap. "
        + "Check the sign of E.")]
    [TestCase("G1 E-2\nG1 X20\nG1 X60 E3\n", CheckCodes.Starved, "4.81 mm³ of extrusions only make up for what was retracted before, and print nothing. "
        + "Deretract first, or check E.")]
    public void Amounts_beyond_reason_are_told(string text, string code, string message)
        => Assert.That(Found(Start + Line + text).Select(d => (d.Code, d.Message)), Is.EqualTo(new[] { (code, message) }));

    // A tenth of a cube of the nozzle, 0.0064 mm³, is 0.0027 mm of filament.
    [TestCase("0.002", 0)]
    [TestCase("0.003", 1)]
    public void The_last_decimals_of_E_may_retract_in_the_middle_of_an_extrusion(string e, int found)
        => Assert.That(Found(Start + Line + "G1 X20 E-" + e + "\nG1 X60 E1.66\n"), Has.Count.EqualTo(found));

    [Test]
    public void What_only_makes_up_for_a_retraction_is_found_where_it_begins()
    {
        const string Hungry = "G1 X60 E0.9\n";
        var text = Start + Line + "G1 E-2\nG1 X20\n" + Hungry + "G1 X10 E0.9\nG1 X60 E1\n";
        var line = text.Substring(0, text.IndexOf(Hungry, StringComparison.Ordinal)).Count(c => c == '\n') + 1;
        Assert.That(Found(text).Select(d => (d.Code, d.Source!.Line)), Is.EqualTo(new[] { (CheckCodes.Starved, (int?)line) }));
    }

    // 10 mm of 1.75 mm filament, two retractions of the printer, or what was retracted in place before.
    [TestCase(0.8, "", 10.0)]
    [TestCase(7, "", 14.0)]
    [TestCase(0.8, "G1 E-30\nG1 E30\n", 30.0)]
    [TestCase(0.8, "G1 E-20\nG1 E-20\nG1 E40\n", 40.0)]
    public void As_much_may_be_retracted_along_a_path_as_in_place(double length, string before, double most)
    {
        var setup = Setup with { Printer = Setup.Printer with { RetractionLength = length } };
        foreach (var (more, found) in new[] { (-0.001, 0), (0.001, 1) })
        {
            var text = Start + Line + before + "G1 X20\nG1 X60 E-" + (most + more).ToString("F3", System.Globalization.CultureInfo.InvariantCulture) + "\n";
            Assert.That(Found(text, setup).Count(d => d.Code == CheckCodes.Amount), Is.EqualTo(found), text);
        }
    }

    // The layer is judged, not the file: 40 layers of 25 moves, of which one is wrong.
    [TestCase("relative")]
    [TestCase("absolute")]
    [TestCase("no reset")]
    public void One_layer_in_the_wrong_mode_is_an_error(string fault)
    {
        var text = new StringBuilder(Start);
        for (var layer = 0; layer < 40; layer++)
        {
            var isWrong = layer == 20;
            text.Append(";LAYER:").Append(layer).Append("\nG1 X10 Z").Append(0.2 * (layer + 1)).Append("\n").Append("M83\n");
            if (fault != "relative") text.Append("M82\nG92 E0\n");
            if (isWrong) text.Append(fault switch { "relative" => "M82\nG92 E0\n", "absolute" => "M83\n", _ => "G92 E30\n" });
            for (var i = 1; i <= 25; i++)
            {
                var e = fault == "relative" ? 0.1 + 0.05 * (i % 3) : 0.15 * i;
                text.Append("G1 X").Append(10 + i).Append(" E").Append(e.ToString("F3", System.Globalization.CultureInfo.InvariantCulture)).Append('\n');
            }
        }
        var found = Found(text.ToString());
        Assert.That(found.Where(d => d.Code == CheckCodes.ExtrusionMode).Select(d => d.Severity), Is.EqualTo(new[] { Severity.Error }),
            string.Join("\n", found));
    }

    private static bool Refuses(string text) => Found(text).Any(d => d.Severity == Severity.Error);

    private static IReadOnlyList<Diagnostic> Found(string text, PrintSetup? setup = null)
        => PrintCheck.Run(SmallPrint.Decode(Encoding.UTF8.GetBytes(text), Setup), setup ?? Setup);

    /// <summary>The lines of a file of a slicer.</summary>
    private sealed class SlicedFile
    {
        private const int Places = 5;
        private readonly string[] _lines;

        public SlicedFile(string name)
        {
            _lines = Encoding.UTF8.GetString(TestData.ReadBytes(TestData.Shared("gcode/" + name))).Split('\n');
            int[] all = [.. Enumerable.Range(0, _lines.Length).Where(i => IsExtrusion(_lines[i]))];
            Extrusions = [.. Enumerable.Range(1, Places).Select(k => all[(2 * k - 1) * all.Length / (2 * Places)])];
        }

        /// <summary>Some of the lines that print.</summary>
        public int[] Extrusions { get; }

        public string this[int line] => _lines[line].TrimEnd('\r');

        public string With(int line, string planted) => string.Join("\n", [.. _lines.Take(line), planted, .. _lines.Skip(line + 1)]);

        private static bool IsExtrusion(string line)
        {
            var at = line.LastIndexOf(" E", StringComparison.Ordinal);
            return line.StartsWith("G1 X", StringComparison.Ordinal) && at > 0 && line[at + 2] != '-' && line.IndexOf('.', at) > 0
                && line.IndexOf(';', at) < 0 && line.IndexOf(' ', at + 2) < 0;
        }
    }
}
