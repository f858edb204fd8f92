using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>Areas and widths of extrusions from the E of a file.</summary>
public class BeadTests
{
    [Test]
    public void Area_and_width_follow_from_E_and_the_layer()
    {
        var toolpath = Decode("G90\nM83\n;LAYER_CHANGE\n;Z:0.2\n;HEIGHT:0.2\nG1 X0 Y0 Z0.2 F600\nG1 X10 E0.5\nG1 E-1\nG1 X20\n", 1.75);
        var area = 0.5 * Math.PI / 4 * 1.75 * 1.75 / 10;
        var bead = toolpath.BeadOf(toolpath[1])!.Value;
        Assert.That(bead.Area, Is.EqualTo(area).Within(1e-12));
        Assert.That(bead.Width(BeadShape.Rectangle), Is.EqualTo(area / 0.2).Within(1e-12));
        Assert.That(bead.Width(BeadShape.Stadium), Is.EqualTo(area / 0.2 + 0.2 * (1 - Math.PI / 4)).Within(1e-12));
        Assert.That(bead.Speed, Is.EqualTo(10));
        Assert.That(new[] { 0, 2, 3 }.Select(i => toolpath.BeadOf(toolpath[i])), Is.All.Null);
        Assert.That(Decode("M83\nG1 X10 E0.5\n", null).BeadOf(Decode("M83\nG1 X10 E0.5\n", null)[0]), Is.Null, "without a diameter");
    }

    // PrusaSlicer states the intended width of its extrusions in comments.
    [TestCase("ps_fandisk_marlin2_absE.gcode.gz")]
    [TestCase("ps_spot_marlin2_relE.gcode.gz")]
    [TestCase("ps_plate_mach3_A.gcode")]
    [TestCase("ps_plate_smoothie_volE_fwr.gcode")]
    [TestCase("ps_overlap_two_tools.gcode")]
    [TestCase("ps_nested_makerware.gcode")]
    [TestCase("ps_torus_sequential.gcode.gz")]
    public void Widths_are_those_of_the_slicers_own_comments(string file)
    {
        var document = GCodeFiles.Document(file);
        var toolpath = GCodeDecoder.Decode(document, new DecodeOptions { Flavor = FlavorTable.Slicer }).Value!.Toolpath;
        var widths = Comments(document, "WIDTH:");
        var heights = Comments(document, "HEIGHT:");
        var compared = 0;
        foreach (var move in toolpath.Moves())
        {
            // Bridges are round, and E has five decimals.
            if (move.Kind != MoveKind.Print || move.Length < 5
                || move.Role is Role.Bridge or Role.OverhangWall or Role.Support or Role.SupportInterface) continue;
            if (toolpath.BeadOf(move) is not { } bead || double.IsNaN(widths[move.Source]) || Math.Abs(heights[move.Source] - bead.Height) > 1e-6) continue;
            Assert.That(bead.Width(BeadShape.Stadium), Is.EqualTo(widths[move.Source]).Within(0.002), $"line {move.Source}");
            compared++;
        }
        Assert.That(compared, Is.GreaterThan(300));
    }

    [Test]
    public void Each_role_has_its_length_and_its_mean_extrusion()
    {
        var toolpath = Decode("G90\nM83\n;LAYER_CHANGE\n;Z:0.2\n;HEIGHT:0.2\n;TYPE:Perimeter\nG1 X0 Y0 Z0.2 F600\nG1 X10 E0.5\nG1 Y30 E3\n;TYPE:Internal "
            + "infill\nG3 X10 Y10 I0 J-10 E1\n", 1.75);
        var totals = RoleTotals.Of(toolpath);
        Assert.That(totals.Select(t => t.Role), Is.EqualTo(new[] { Role.InnerWall, Role.Infill }));
        Assert.That(totals.Select(t => t.Length), Is.EqualTo(new[] { 40, 10 * Math.PI }).Within(1e-9));
        var filament = Math.PI / 4 * 1.75 * 1.75;
        Assert.That(totals.Select(t => t.Area!.Value), Is.EqualTo(new[] { 3.5 * filament / 40, filament / (10 * Math.PI) }).Within(1e-9));
        var sides = 0.2 * (1 - Math.PI / 4);
        Assert.That(totals[0].Width, Is.EqualTo(3.5 * filament / 40 / 0.2 + sides).Within(1e-9), "widths add up like areas");
        Assert.That(RoleTotals.Of(Decode("M83\nG1 X10 E0.5\n", null)).Single().Width, Is.Null);
    }

    // The value in force at each line.
    private static double[] Comments(GCodeDocument document, string name)
    {
        var lines = Encoding.ASCII.GetString(document.ToBytes()).Split('\n');
        var values = new double[lines.Length + 2];
        var value = double.NaN;
        for (var i = 0; i < lines.Length; i++)
        {
            if (lines[i].StartsWith(";" + name, StringComparison.Ordinal)
                && NumberReader.TryParse(lines[i].Substring(name.Length + 1).Trim(), out var said)) value = said;
            values[i + 1] = value;
        }
        return values;
    }

    private static Toolpath Decode(string text, double? diameter)
        => GCodeDecoder.Decode(GCodeDocument.FromText(text), new DecodeOptions { Flavor = FlavorTable.Slicer, FilamentDiameter = diameter }).Value!.Toolpath;
}
