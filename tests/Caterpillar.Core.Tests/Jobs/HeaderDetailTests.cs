using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using NUnit.Framework;

namespace Caterpillar.Tests.Jobs;

/// <summary>What single lines of start and end code tell about a machine.</summary>
[Category("Arithmetic")]
public class HeaderDetailTests
{
    [TestCase("G28\nG1 X50 Y60 Z5", "50 60 5")]
    [TestCase("G28 X Y\nG1 X50 Y60", "")]
    [TestCase("G28 Z\nG1 X50 Y60", "50 60 0")]
    [TestCase("G28 X Y Z\nG1 X50", "50 0 0")]
    [TestCase("G92 X0 Y0 Z0\nG1 X50 Y60", "50 60 0")]
    [TestCase("G92 X0 Y0\nG1 X50 Y60", "")]
    [TestCase("G1 X50 Y60\nG1 Z5", "50 60 5")]
    [TestCase("G1 X50 Y60", "")]
    [TestCase("G28\nG0 X50\nG2 X50 Y60 I0 J30", "50 60 0")]
    [TestCase("G28\nG3 X50 Y60 Z2 I0 J30", "50 60 2")]
    [TestCase("G28", "")]
    [TestCase("G28\nG1 E5", "")]
    [TestCase("G91\nG1 X50 Y60 Z5", "")]
    [TestCase("G28\nG91\nG1 Z5", "0 0 5")]
    [TestCase("G28\nG1 X{x} Y60 Z5", "")]
    [TestCase("G28\nG1 Z {z}\nG1 X50", "")]
    public void The_start_is_known_where_all_axes_are_and_something_has_moved(string header, string expected)
    {
        var start = HeaderImport.Read(header, "").OrThrow().Start;
        Assert.That(start is { } at ? $"{at.X + 0.0} {at.Y + 0.0} {at.Z + 0.0}" : "", Is.EqualTo(expected));
    }

    [TestCase("M82", ExtrusionMode.Absolute)]
    [TestCase("M83", ExtrusionMode.Relative)]
    [TestCase("M83\nM82", ExtrusionMode.Absolute)]
    [TestCase("G91", ExtrusionMode.Relative)]
    public void The_last_word_about_E_counts(string header, ExtrusionMode mode)
        => Assert.That(HeaderImport.Read(header, "").OrThrow().Printers[0].ExtrusionMode, Is.EqualTo(mode));

    [TestCase("G20\nG21\nG28", false)]
    [TestCase("G21\nG20\nG28", true)]
    public void Only_what_is_left_in_inches_is_an_error(string header, bool isRefused)
        => Assert.That(HeaderImport.Read(header, "").HasErrors, Is.EqualTo(isRefused));

    [TestCase("; bed 300x310", "", 300, 310, 250, "from a comment")]
    [TestCase("; bed 300 mm X 310 mm X 400 mm", "", 300, 310, 400, "from a comment")]
    [TestCase("(300 * 310 * 30)", "", 300, 310, 250, "from a comment")]
    [TestCase("; cells of 300 x 30", "", 220, 220, 250, "does not contain")]
    [TestCase("; cells of 30 x 300", "", 220, 220, 250, "does not contain")]
    [TestCase("; cells of 40 x 40", "", 40, 40, 250, "from a comment")]
    [TestCase("G28\nG1 X100 Y90 Z5", "", 200, 180, 250, "twice the last position")]
    [TestCase("G28\nG1 X100 Y19 Z5", "", 220, 220, 250, "does not contain")]
    [TestCase("G28\nG1 X300 Y10 Z5", "", 300, 220, 250, "range of the moves")]
    [TestCase("G28\nG1 X10 Y300 Z5", "", 220, 300, 250, "range of the moves")]
    [TestCase("G28\nG1 X10 Y10 Z300", "", 220, 220, 300, "range of the moves")]
    [TestCase("G28\nG1 X10 Y10 Z5", "G90\nG1 X0 Y300", 220, 300, 250, "range of the moves")]
    [TestCase("G28\nG1 X10 Y10 Z5", "G1 X0 Y300\nG90", 220, 220, 250, "does not contain")]
    [TestCase("G28\nG1 X10 Y10 Z5", "G91\nG1 Y300", 220, 220, 250, "does not contain")]
    [TestCase("G28\nG1 X10 Y10 Z5", "G1 Y300", 220, 220, 250, "does not contain")]
    [TestCase("G1 X-10 Y-21 Z5\nG1 X30", "", 220, 220, 250, "does not contain")]
    [TestCase("G1 X-200 Y0 Z5", "", 400, 220, 250, "range of the moves")]
    [TestCase("G1 X1000000 Y0 Z5", "", 100_000, 220, 250, "range of the moves")]
    public void The_build_volume_is_from_a_comment_from_the_start_or_holds_all_moves(
        string header, string footer, double x, double y, double z, string reason)
    {
        var read = HeaderImport.Read(header, footer);
        Assert.That(read.OrThrow().Printers[0].BuildVolume, Is.EqualTo(new Vec3(x, y, z)));
        var note = read.Diagnostics.Single(d => d.Code == "header.bed_size");
        Assert.That(note.Message, Does.Contain(reason).And.Contain($"{x} × {y} × {z} mm"));
    }

    [Test]
    public void Without_a_sign_the_origin_and_the_size_are_those_of_the_similar_printer()
    {
        var delta = new Printer { Origin = BedOrigin.Center, BuildVolume = new Vec3(200, 200, 400) };
        Assert.That(Like("G28", delta), Is.EqualTo((BedOrigin.Center, new Vec3(200, 200, 400))));
        Assert.That(Like("; 300 x 300\nG28", delta), Is.EqualTo((BedOrigin.Corner, new Vec3(300, 300, 400))));
        Assert.That(Like("G28\nG1 X50 Y60 Z5", delta), Is.EqualTo((BedOrigin.Corner, new Vec3(100, 120, 400))));
        Assert.That(Like("G1 X-30 Y5", delta), Is.EqualTo((BedOrigin.Center, new Vec3(200, 200, 400))));
    }

    private static (BedOrigin Origin, Vec3 Volume) Like(string header, Printer like)
    {
        var printer = HeaderImport.Read(header, "", "made", like).OrThrow().Printers[0];
        return (printer.Origin, printer.BuildVolume);
    }

    [TestCase("M104 S200\nM302 S150", 150)]
    [TestCase("M104 S200\nM302", 0)]
    [TestCase("M104 S200\nM302 P1", 0)]
    [TestCase("M104 S200\nM302 S5000", 0)]
    [TestCase("M104 S200\nM302 P0", 170)]
    [TestCase("M104 S200\nM301 S150", 170)]
    [TestCase("M302 S150", 150)]
    public void The_coldest_extrusion_is_what_M302_allows(string header, double celsius)
        => Assert.That(HeaderImport.Read(header, "", "made", new Printer { MinExtrusionTemperature = 170 }).OrThrow().Printers[0].MinExtrusionTemperature,
            Is.EqualTo(celsius));

    [Test]
    public void A_machine_that_never_heats_prints_clay_unless_it_is_like_another()
    {
        var cold = HeaderImport.Read("G28", "", "pot").OrThrow().Printers[0];
        Assert.That((cold.DefaultMaterial, cold.DefaultSettings, cold.MaxFlow), Is.EqualTo(("clay", "clay", 0.0)));
        var like = new Printer { DefaultMaterial = "petg", MaxFlow = 9 };
        var similar = HeaderImport.Read("G28", "", "pot", like).OrThrow().Printers[0];
        Assert.That((similar.DefaultMaterial, similar.DefaultSettings, similar.MaxFlow), Is.EqualTo(("petg", like.DefaultSettings, 9.0)));
        var hot = HeaderImport.Read("M104 S1", "", "pot");
        Assert.That(hot.OrThrow().Printers[0].DefaultMaterial, Is.EqualTo("pot"));
        Assert.That(hot.Diagnostics.Select(d => d.Code), Has.None.EqualTo("header.no_heating"));
    }

    [TestCase("M104 S210", 210, 0)]
    [TestCase("M109 R210\nM190 R55", 210, 55)]
    [TestCase("M104 S210\nM104 S0", 210, 0)]
    [TestCase("M104 S210\nM109 S215", 215, 0)]
    [TestCase("M104 S2001\nM140 S900", 0, 500)]
    [TestCase("{hotend_temp}\nM83", 205, 0)]
    [TestCase("{bed_temp}\nM83", 0, 60)]
    public void The_last_temperatures_are_those_of_the_material(string header, double nozzle, double bed)
    {
        var material = HeaderImport.Read(header, "").OrThrow().Materials[0];
        Assert.That((material.NozzleTemperature, material.BedTemperature), Is.EqualTo((nozzle, bed)));
    }

    [TestCase("G28 W", "prusa")]
    [TestCase("G80", "prusa")]
    [TestCase("G28 X", "marlin2")]
    [TestCase("G29 W\nG81", "marlin2")]
    public void The_own_commands_of_Prusa_are_a_sign_of_its_firmware(string header, string flavor)
        => Assert.That(HeaderImport.Read(header, "").OrThrow().Printers[0].Flavor.Name, Is.EqualTo(flavor));

    [Test]
    public void Each_tool_has_an_offset_and_a_similar_printer_may_have_more()
    {
        Assert.That(HeaderImport.Read("T0\nT2", "").OrThrow().Printers[0].ToolCount, Is.EqualTo(3));
        var many = new Printer { ToolOffsets = new(Enumerable.Repeat(new Vec3(1, 0), 5)) };
        Assert.That(HeaderImport.Read("T0\nT2", "", "made", many).OrThrow().Printers[0].ToolOffsets, Is.EqualTo(many.ToolOffsets));
        Assert.That(HeaderImport.Read("T90", "").OrThrow().Printers[0].ToolCount, Is.LessThanOrEqualTo(64));
    }

    [TestCase("  X1 Y2", "header.no_command", 3, "Did you mean G1 X1 Y2?")]
    [TestCase("G1 X5 Y F100", "header.bad_word", 7, "Y of G1 has no number.")]
    [TestCase("G0 Z", "header.bad_word", 4, "Z of G0 has no number.")]
    [TestCase("G3 I", "header.bad_word", 4, "I of G3 has no number.")]
    [TestCase("G1 X1 ,Y2", "header.bad_word", 7, "\",Y2\" has no letter")]
    [TestCase("G1 5 X1", "header.bad_word", 4, "\"5\" has no letter")]
    public void Invalid_lines_are_reported_where_they_are(string line, string code, int column, string message)
    {
        var found = HeaderImport.Read("M83\n" + line, "").Diagnostics.Single(d => d.Severity == Severity.Warning);
        Assert.That((found.Code, found.Source!.Line, found.Source.Column), Is.EqualTo((code, (int?)2, (int?)column)));
        Assert.That(found.Message, Does.Contain(message));
    }

    [TestCase("M28 part.gco")]
    [TestCase("M117 \"two words\" here")]
    [TestCase("_MY_MACRO A=1")]
    [TestCase("G28 X")]
    [TestCase("M84 X Y")]
    [TestCase("")]
    public void Names_texts_and_flags_stay(string line)
    {
        var read = HeaderImport.Read("M83\n" + line + "\nG28", "");
        Assert.That(read.OrThrow().Printers[0].StartGCode, Is.EqualTo(new[] { "M83", line, "G28" }));
        Assert.That(read.Diagnostics.Select(d => d.Severity), Has.None.EqualTo(Severity.Warning));
    }

    [TestCase("<<<<<<<\nM82\n=======\nM83\n>>>>>>>\nG28", "M82 G28")]
    [TestCase("<<<<<<<HEAD\nG28", "; invalid: <<<<<<<HEAD G28")]
    [TestCase("=======\nG28", "; invalid: ======= G28")]
    public void Marks_of_merge_conflicts_have_seven_signs_and_a_beginning(string header, string kept)
        => Assert.That(string.Join(" ", HeaderImport.Read(header, "").OrThrow().Printers[0].StartGCode), Is.EqualTo(kept));

    [TestCase("M104 S200", "{if nozzle_temperature_c > 0}|M104 S{start_nozzle_temperature_c}|{endif}")]
    [TestCase("M109 R200 ; heat", "{if nozzle_temperature_c > 0}|M109 R{start_nozzle_temperature_c} ; heat|{endif}")]
    [TestCase("M140 S60", "{if bed_temperature_c > 0}|M140 S{start_bed_temperature_c}|{endif}")]
    [TestCase("M190 R60", "{if bed_temperature_c > 0}|M190 R{start_bed_temperature_c}|{endif}")]
    [TestCase("M104 S0", "M104 S0")]
    [TestCase("M106 S60", "M106 S60")]
    public void Lines_that_heat_take_their_temperature_from_the_material(string line, string template)
        => Assert.That(string.Join("|", HeaderImport.Read(line, "").OrThrow().Printers[0].StartGCode), Is.EqualTo(template));

    [TestCase("G91\nG1 Z9.9", "G91|G1 Z9.9")]
    [TestCase("G91\nG1 Z10", "G91|G1 Z{max(0, min(10, bed_max_z_mm - print_max_z_mm - 5))}")]
    [TestCase("G91\nG0 F600 Z20.1255 ; up", "G91|G0 F600 Z{max(0, min(20.126, bed_max_z_mm - print_max_z_mm - 5))} ; up")]
    [TestCase("G91\nG90\nG1 Z100", "G91|G90|G1 Z100")]
    [TestCase("G91\nG1 X100", "G91|G1 X100")]
    [TestCase("G1 Z100", "G90 ; as set by the header|G1 Z100")]
    [TestCase("G90\nG1 E-2", "M83 ; as set by the header|G90|G1 E-2")]
    [TestCase("G90\nM82\nG1 X1 E-2", "G90|M82|G1 X1 E-2")]
    public void Lifts_of_the_end_code_stay_in_the_machine_and_modes_are_stated(string footer, string template)
        => Assert.That(string.Join("|", HeaderImport.Read("G28", footer).OrThrow().Printers[0].EndGCode), Is.EqualTo(template));

    [Test]
    public void The_end_code_inherits_the_modes_of_the_start_code()
    {
        var end = HeaderImport.Read("G91\nM82", "G1 Z20 E1").OrThrow().Printers[0].EndGCode;
        Assert.That(end, Is.EqualTo(new[] { "G91 ; as set by the header", "M82 ; as set by the header",
            "G1 Z{max(0, min(20, bed_max_z_mm - print_max_z_mm - 5))} E1" }));
    }
}
