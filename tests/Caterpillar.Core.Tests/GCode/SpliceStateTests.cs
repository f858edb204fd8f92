using System;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using Caterpillar.Tests.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>The state where moves are removed, inserted or converted: each case by hand.</summary>
public class SpliceStateTests
{
    [Test]
    public void A_cut_G10_leaves_no_G11_alone()
    {
        const string Text = "M83\nG1 X1 Y1 Z1 F600\n;LAYER:0\nG1 X5 E1\nG10\n;LAYER:1\nG1 X9\nG11\nG1 X12 E1\n";
        var edited = Edit(Text, t => t.Remove(new MoveFilter { FirstLayer = 0, LastLayer = 0 }));
        Assert.That(edited, Is.EqualTo("M83\nG1 X1 Y1 Z1 F600\n;LAYER:1\nG10\nG1 X9\nG11\nG1 X12 E1\n"));
        Assert.That(Written(Text, t => t.Remove(new MoveFilter { FirstLayer = 0, LastLayer = 0 })), Does.Contain("G10\nG0 X9\nG11\n"));
    }

    [Test]
    public void A_cut_G11_is_compensated()
    {
        const string Text = "M83\nG1 X1 Y1 Z1 F600\n;LAYER:0\nG1 X5 E1\nG10\n;LAYER:1\nG1 X9\nG11\nG1 X12 E1\n;LAYER:2\nG1 X20 E1\n";
        var edited = Edit(Text, t => t.Remove(new MoveFilter { FirstLayer = 1, LastLayer = 1 }));
        Assert.That(edited, Is.EqualTo("M83\nG1 X1 Y1 Z1 F600\n;LAYER:0\nG1 X5 E1\nG10\n;LAYER:2\nG1 X12\nG11\nG1 X20 E1\n"));
    }

    [Test]
    public void Each_tool_has_its_own_retraction()
    {
        const string Text = "M83\nG1 X1 Y1 Z1 F600\n;LAYER:0\nG1 X5 E1\nG1 E-2\nT1\n;LAYER:1\nG1 X9 E1\nG1 E-3\nT0\n;LAYER:2\nG1 E2\nG1 X20 E1\nG1 "
            + "E-2\nT1\nG1 E3\nG1 X30 E1\n";
        var edited = Edit(Text, t => t.Remove(new MoveFilter { FirstLayer = 1, LastLayer = 1 }));
        var back = Decode(edited).Toolpath;
        Assert.That(back.Moves().Where(m => m.Tool == 1).Select(m => (m.Kind, m.E)),
            Is.EqualTo(new[] { (MoveKind.Retract, -3.0), (MoveKind.Deretract, 3), (MoveKind.Print, 1) }), edited);
    }

    [Test]
    public void Each_tool_keeps_its_position_of_E_far_down_in_a_file()
    {
        // Longer than what is read at once.
        var comments = string.Concat(Enumerable.Repeat("; " + new string('-', 97) + "\n", 3000));
        var before = "G90\nM82\nG1 X1 Y1 Z0.2 F600\n;LAYER:0\nG1 X5 E100\nT1\nG1 X9 E50\n" + comments + ";LAYER:1\n";
        var decoding = Decode(before + "G1 X20 E51\nT0\nG1 X30 E101\n", "repetier");
        Assert.That(decoding.Toolpath.Moves().Select(m => m.E), Is.EqualTo(new[] { 0.0, 100, 50, 1, 1 }));
        var slower = decoding.Toolpath.ScaleSpeed(new MoveFilter { FirstLayer = 1 }, 0.5);
        Assert.That(Said(GCodeEditor.ToDocument(decoding, slower).Value!.ToBytes()), Is.EqualTo(before + "G1 X20 E51 F300\nT0\nG1 X30 E101\n"));
    }

    [Test]
    public void A_line_without_a_command_that_repeated_an_arc_gets_one_where_it_becomes_straight()
    {
        var decoding = Decode("M83\nG1 X0 Y0 Z0.2 F600\n;LAYER:0\nG3 X10 Y10 I0 J10 E1\n;LAYER:1\nX0 Y20 I-10 J0 E1\n", "smoothie");
        var higher = decoding.Toolpath.Transform(new MoveFilter { FirstLayer = 1 }, Affine.Scale(1, 1.01, 1), 100);
        Assert.That(Said(GCodeEditor.ToDocument(decoding, higher).Value!.ToBytes()), Does.Contain("\nG3 X10 Y10 I0 J10 E1\n").And.Contain("\nG1 X0 Y20.2 E"));
    }

    [Test]
    public void Relative_moves_stay_relative_after_a_start_code_that_is_left_out()
    {
        const string Layers = ";LAYER:0\nG1 X5 Y5 Z0.2 E1 F600\nG1 X5 E1\n;LAYER:1\nG1 Z0.2\nG1 X-5 E1\n";
        var decoding = Decode("G28\nG91\nM83\n" + Layers);
        var edited = GCodeEditor.ToDocument(decoding, decoding.Toolpath, new EditOptions { Start = [] });
        Assert.That(Said(edited.Value!.ToBytes()), Is.EqualTo("G91\n" + Layers));
    }

    [Test]
    public void Modes_units_and_names_in_cut_lines_apply_after_them()
    {
        const string Text = "G21\nM83\nG1 X10 Y10 Z1 F600\n;LAYER:0\nG1 X50 E1\n;LAYER:1\nG20\nG91\nG1 X1 E1\nG92 X0\nM82\nG92 E7\n;LAYER:2\nG1 X1 E0.1 "
            + "F20\nG90\nG21\nG1 X5 E30\n";
        var edited = Edit(Text, t => t.Remove(new MoveFilter { FirstLayer = 1, LastLayer = 1 }));
        var expected = Decode(Text).Toolpath.Moves().Where(m => m.Layer != 1).Select(m => (m.End, m.E, m.Speed));
        var kept = Decode(edited).Toolpath.Moves().Where(m => m.E != 0 || m.Layer < 0).Select(m => (m.End, m.E, m.Speed)).ToArray();
        Assert.That(kept.Length, Is.EqualTo(expected.Count()), edited);
        foreach (var (a, b) in expected.Zip(kept, (a, b) => (a, b)))
        {
            Assert.That((a.End - b.End).Length, Is.LessThan(1e-6), edited);
            Assert.That(b.E, Is.EqualTo(a.E).Within(1e-6), edited);
            Assert.That(b.Speed, Is.EqualTo(a.Speed).Within(1e-6), edited);
        }
    }

    [Test]
    public void Fans_temperatures_and_tools_stay_if_moves_are_removed()
    {
        const string Text = "M83\nG1 X1 Y1 Z1 F600\n;LAYER:0\nG1 X5 E1\n;LAYER:1\nM106 S255\nM104 S210\nT1\nG1 X9 E1\nG4 P500\n;LAYER:2\nG1 X20 E1\n";
        var edited = Edit(Text, t => t.Remove(new MoveFilter { FirstLayer = 1, LastLayer = 1 }));
        Assert.That(edited, Does.Contain("M106 S255\nM104 S210\nT1\n").And.Not.Contain("G4"));
        Assert.That(Decode(edited).Toolpath.Moves().Last().Tool, Is.EqualTo(1));
    }

    [Test]
    public void Roles_and_layers_that_began_in_cut_lines_apply_after_them()
    {
        const string Text = "M83\nG1 X1 Y1 Z1 F600\n;LAYER:3\n;TYPE:FILL\nG1 X5 E1\nG1 X9 E1\n";
        var edited = Edit(Text, t => new MoveRemover(t, t.Moves().Select(m => m.Index == 1).ToMoveSet()).Run());
        Assert.That(edited, Is.EqualTo("M83\nG1 X1 Y1 Z1 F600\n;LAYER:3\n;TYPE:FILL\nG1 X5\nG1 X9 E1\n"));
    }

    [Test]
    public void Homing_stays_whatever_is_done_around_it()
    {
        const string Text = "M83\nG28\nG1 X10 Y10 Z1 F600\nG1 X20 E1\nG28 X\nG1 X5 E1\n";
        static Toolpath Moved(Toolpath t) => t.Transform(Affine.Move(new Vec3(3, 2, 1)));
        Assert.That(Moved(Decode(Text).Toolpath).Moves().Select(m => m.End),
            Is.EqualTo(new[] { new Vec3(13, 12, 2), new Vec3(23, 12, 2), new Vec3(0, 12, 2), new Vec3(8, 12, 2) }));
        Assert.That(Edit(Text, Moved), Is.EqualTo("M83\nG28\nG1 X13 Y12 Z2 F600\nG1 X23 E1\nG28 X\nG1 X8 E1.6\n"));
        Assert.That(Edit(Text, t => t.Remove(new MoveFilter { Kinds = [MoveKind.Travel] })), Does.Contain("G28 X\n"));
    }

    [Test]
    public void Another_tool_has_its_own_balance_of_retraction()
    {
        const string Text = "M83\nG1 X1 Y1 Z1 F600\nG1 X5 E1\nG1 E-2\nG1 X9\nG1 E2\nG1 X20 E1\n";
        static Toolpath Tooled(Toolpath t) => t.Insert(3, new ToolEvent(1));
        var edited = Tooled(Decode(Text).Toolpath);
        Assert.That(edited.Moves().Select(m => m.Kind),
            Is.EqualTo(new[] { MoveKind.Travel, MoveKind.Print, MoveKind.Retract, MoveKind.Travel, MoveKind.Prime, MoveKind.Print }));
        Assert.That(edited.Tools, Has.Count.EqualTo(2));
        Assert.That(Decode(Edit(Text, Tooled)).Toolpath.Moves().Select(m => (m.Kind, m.Tool)), Is.EqualTo(edited.Moves().Select(m => (m.Kind, m.Tool))));
    }

    [Test]
    public void A_switched_extruder_is_written_by_its_switch()
    {
        const string Text = "M108 S10\nM103\nG1 X1 Y1 Z1 F600\nM101\nG1 X5\nG1 X9\nM103\nG1 X20\nM101\nG1 X30\nM103\n";
        var toolpath = Decode(Text, "bfb").Toolpath;
        Assert.That(NewFile.Plain(toolpath, new GCodeFormat(NewFile.Machine with { Flavor = FlavorTable.Find("bfb")! })), Is.EqualTo(
            "G90\nG0 X1 Y1 Z1 F600\nM101\nG1 X5\nG1 X9\nM103\nG0 X20\nM101\nG1 X30\nM103\n"));
        Assert.That(SetupFormat.Of(new PrintSetup(), toolpath).Diagnostics.Select(d => d.Code), Does.Contain("gcode.no_e_values"));
        Assert.That(GCodeConverter.ToDocument(Decode(Text, "bfb"), new ConvertOptions { Flavor = FlavorTable.Marlin2 }).Diagnostics.Single().Code,
            Is.EqualTo("gcode.no_e_values"));
    }

    [TestCase("grbl", "gcode.no_extruder", "G0 X1 Y1 Z1 F600\nG1 X5\nG0 X20\nG1 X30\n")]
    [TestCase("bfb", "gcode.e_values_lost", "G1 X1 Y1 Z1 F600\nM101\nG1 X5\nM103\nG1 X20\nM101\nG1 X30\n")]
    public void Firmware_without_amounts_is_told_what_prints_and_the_user_what_is_lost(string flavor, string code, string expected)
    {
        var decoding = Decode("M83\nG1 X1 Y1 Z1 F600\nG1 X5 E1\nG1 E-2\nG1 X20\nG1 E2\nG1 X30 E1\n");
        var result = GCodeConverter.ToDocument(decoding, new ConvertOptions { Flavor = FlavorTable.Find(flavor) });
        Assert.That(result.Diagnostics.Single().Code, Is.EqualTo(code));
        Assert.That(Said(result.Value!.ToBytes()).Replace("M83\n", ""), Is.EqualTo(expected));
    }

    [Test]
    public void Flow_and_speed_factors_go_into_the_numbers_where_the_target_has_none()
    {
        var text = Convert("M83\nG1 X1 Y1 Z1 F600\nM221 S50\nM220 S200\nG1 X5 E1\n", "marlin2", new ConvertOptions { Flavor = FlavorTable.Find("cnc")! });
        Assert.That(text, Does.Not.Contain("M22").And.Contain("G1 X5 A0.5 F1200\n"));
    }

    [Test]
    public void Fans_speak_in_the_scale_of_the_target()
    {
        Assert.That(Convert("M106 S0.5\nM106 S255\n", "reprapfirmware", new ConvertOptions { Flavor = FlavorTable.Marlin2 }),
            Is.EqualTo("M106 S128\nM106 S255\n"));
        Assert.That(Convert("M106 S1 ; low\n", "marlin2", new ConvertOptions { Flavor = FlavorTable.Find("reprapfirmware") }),
            Is.EqualTo("M106 S0.004 ; low\n"));
    }

    [Test]
    public void Volumes_are_stated_and_the_setting_goes_with_them()
    {
        const string Text = "M83\nG1 X1 Y1 Z1 F600\nG1 X5 E1\n; filament_diameter = 1.75\n; use_volumetric_e = 0\n";
        var text = Convert(Text, "marlin2", new ConvertOptions { Volumetric = true });
        Assert.That(text, Does.Contain("M200 D1.75\nG1 X5 E2.40528\n").And.Contain("; use_volumetric_e = 1\n"));
        Assert.That(Convert(text, "marlin2", new ConvertOptions { Volumetric = false }),
            Does.Contain("G1 X5 E1\n").And.Contain("; use_volumetric_e = 0\n").And.Not.Contain("M200"));
        var unknown = GCodeConverter.ToDocument(Decode("M83\nG1 X1 Y1 E1\n"), new ConvertOptions { Flavor = FlavorTable.Find("ultigcode")! });
        Assert.That(unknown.Diagnostics.Single(d => d.Severity == Severity.Error).Code, Is.EqualTo("gcode.diameter_unknown"));
    }

    [Test]
    public void Decimals_can_be_limited_and_what_rounding_leaves_of_E_is_carried_on()
    {
        var text = Convert("M83\nG1 X1.2345 Y1 Z1 F600.4\nG1 X5 E.0006\nG1 X9 E.0006\nG1 X12 E.0006\n", "marlin2",
            new ConvertOptions { DecimalsXyz = 2, DecimalsE = 3, DecimalsF = 0 });
        Assert.That(text, Is.EqualTo("M83\nG1 X1.23 Y1 Z1 F600\nG1 X5 E.001\nG1 X9 E0\nG1 X12 E.001\n"));
    }

    [Test]
    public void Two_extruder_axes_become_one()
    {
        const string Two = "G90\nG1 X1 Y1 Z1 F600\nG1 X5 A1 B0.5\nG92 A0 B0\nG1 X9 A0.5\nG1 X12 B0.25\n";
        var decoding = Decode(Two, "sailfish");
        Assert.That(decoding.Report.ExtrusionAxis, Is.EqualTo("A+B"));
        foreach (var relative in new[] { true, false })
        {
            var text = Convert(Two, "sailfish", new ConvertOptions { Flavor = FlavorTable.Marlin2, RelativeE = relative });
            Assert.That(Decode(text).Toolpath.Moves().Select(m => Math.Round(m.E, 9)), Is.EqualTo(new[] { 0, 1.5, 0.5, 0.25 }), text);
            Assert.That(text, Does.Not.Contain("A").And.Not.Contain("B"));
        }
        var slower = decoding.Toolpath.ScaleFlow(new MoveFilter { Box = new Bounds(new Vec3(0, 0, 0), new Vec3(6, 9, 9)) }, 2);
        var edited = Said(GCodeEditor.ToDocument(decoding, slower).Value!.ToBytes());
        Assert.That(Decode(edited, "sailfish").Toolpath.Moves().Select(m => Math.Round(m.E, 9)), Is.EqualTo(new[] { 0, 3, 0.5, 0.25 }), edited);
    }

    [Test]
    public void Numbered_lines_may_be_extended_commands()
        => Assert.That(Decode("N1 PAUSE*80\nG1 X1\n", "klipper").Toolpath.Events.Single().Event, Is.EqualTo(new PauseEvent()));

    private static string Convert(string text, string flavor, ConvertOptions options)
        => Said(GCodeConverter.ToDocument(Decode(text, flavor), options).Value!.ToBytes());

    private static string Edit(string text, Func<Toolpath, Toolpath> edit)
    {
        var decoding = Decode(text);
        return Said(GCodeEditor.ToDocument(decoding, edit(decoding.Toolpath)).Value!.ToBytes());
    }

    private static string Written(string text, Func<Toolpath, Toolpath> edit)
        => NewFile.Plain(edit(Decode(text).Toolpath));

    // Without the line that names the flavor of a conversion.
    private static string Said(byte[] bytes)
    {
        var text = Encoding.ASCII.GetString(bytes);
        return text.StartsWith("; Flavor ", System.StringComparison.Ordinal) ? text.Substring(text.IndexOf('\n') + 1) : text;
    }

    private static DecodedGCode Decode(string text, string flavor = "marlin2")
        => GCodeDecoder.Decode(GCodeDocument.FromText(text), new DecodeOptions { Flavor = FlavorTable.Find(flavor) }).Value!;
}
