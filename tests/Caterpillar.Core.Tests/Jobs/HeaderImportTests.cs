using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Jobs;

/// <summary>Headers and footers in the style of ExtruderTurtle's, with their known flaws.</summary>
public class HeaderImportTests
{
    private const string Ender = """
        ; start of the Ender
        G90
        M83 ; relative E
        M190 S60
        M109 S205
        G28
        G92 E0
        <<<<<<< HEAD
        G1 Z2.0 F3000
        =======
        G1 Z5.0 F3000
        >>>>>>> 1f2e3d
        G1 X0.1 Y20 Z0.3 F5000
        G1 X0.1 Y200 F1500 E15
        G1 X0.4 Y200
        G1 X0.4 Y20 E30
        G1 0 0 .3
        F300 E3
        G1 X100 Y100 Z0.1
        G91
        """;

    private const string Templated = """
        G21
        G90 ; use absolute coordinates
        M83
        M104 S{hotend_temp} ; set extruder temp
        M140 S{bed_temp}
        M190 S{bed_temp}
        M109 S{hotend_temp}
        G28 W
        G80
        G1 Y-3.0 F1000.0
        G1 X60.0 E9.0 F1000.0
        G1 X100.0 E12.5 F1000.0
        G92 E0.0
        G1 X{x} Y{y} Z{z:.2f} F{feedrate}
        G91
        """;

    private const string Footer = """
        G1 E-3
        M104 S0
        M140 S0
        M107
        G1 Z100 F5000
        M84
        """;

    [Test]
    public void Fixed_headers_state_temperatures_mode_and_bed()
    {
        var found = Import(Ender, Footer, out var problems);
        Assert.That((found.Materials[0].NozzleTemperature, found.Materials[0].BedTemperature), Is.EqualTo((205.0, 60.0)));
        Assert.That(found.Printers[0].ExtrusionMode, Is.EqualTo(ExtrusionMode.Relative));
        Assert.That(found.Start, Is.EqualTo(new Vec3(100, 100, 0.1)));
        Assert.That(found.Printers[0].BuildVolume, Is.EqualTo(new Vec3(200, 200, 250)), "twice the start");
        Assert.That(found.Printers[0].Origin, Is.EqualTo(BedOrigin.Corner));
        Assert.That(problems.Where(p => p.Severity == Severity.Warning).Select(p => (p.Code, p.Source!.Line, p.Count)), Is.EqualTo(new[]
        {
            ("header.merge_conflict", (int?)8, 3), ("header.bad_word", 17, 1), ("header.no_command", 18, 1),
        }));
        Assert.That(problems.Single(p => p.Code == "header.bad_word").Source!.Column, Is.EqualTo(4));
    }

    [Test]
    public void Good_lines_stay_and_bad_ones_become_comments()
    {
        var lines = Render(Import(Ender, Footer, out _), p => p.StartGCode);
        Assert.That(lines, Is.EqualTo(new[]
        {
            "; start of the Ender", "G90", "M83 ; relative E", "M190 S60", "M109 S205", "G28", "G92 E0", "G1 Z2.0 F3000", "G1 X0.1 Y20 Z0.3 F5000",
                "G1 X0.1 Y200 F1500 E15", "G1 X0.4 Y200",
            "G1 X0.4 Y20 E30", "; invalid: G1 0 0 .3", "; invalid: F300 E3", "G1 X100 Y100 Z0.1", "G91",
        }));
    }

    [Test]
    public void Temperatures_come_from_the_material()
    {
        var found = Import(Ender, Footer, out _);
        var hot = found with { Materials = [found.Materials[0] with { NozzleTemperature = 230, FirstLayerNozzleTemperature = 235, BedTemperature = 0 }] };
        var lines = Render(hot, p => p.StartGCode);
        Assert.That(lines, Does.Contain("M109 S235").And.None.StartsWith("M190"));
    }

    [Test]
    public void Names_in_braces_are_filled_in()
    {
        var found = Import(Templated, Footer, out var problems);
        Assert.That((found.Materials[0].NozzleTemperature, found.Materials[0].BedTemperature), Is.EqualTo((205.0, 60.0)), "what ExtruderTurtle has by default");
        Assert.That(found.Start, Is.Null);
        Assert.That(found.Printers[0].Flavor.Name, Is.EqualTo("prusa"));
        Assert.That(problems.Where(p => p.Severity != Severity.Note), Is.Empty);
        var lines = Render(found, p => p.StartGCode);
        Assert.That(lines, Does.Contain("M104 S205 ; set extruder temp").And.Contain("M190 S60"));
        Assert.That(lines, Does.Contain("G1 X110 Y110 Z0.2 F3600"), "middle of the bed, first layer, 60 mm/s");
    }

    [Test]
    public void The_footer_states_the_modes_that_it_relies_on_and_stays_in_the_machine()
    {
        var found = Import(Ender, Footer, out var problems);
        Assert.That(Render(found, p => p.EndGCode).Take(3),
            Is.EqualTo(new[] { "G91 ; as set by the header", "M83 ; as set by the header", "G1 E-3" }));
        Assert.That(Render(found, p => p.EndGCode, 20), Does.Contain("G1 Z100 F5000"));
        Assert.That(Render(found, p => p.EndGCode, 200), Does.Contain("G1 Z45 F5000"));
        Assert.That(problems.Select(p => p.Code), Does.Contain("header.end_height"));
        var own = Import(Ender, "G90\nM82\nG1 Z200 E5\nM84", out _);
        Assert.That(own.Printers[0].EndGCode, Is.EqualTo(new[] { "G90", "M82", "G1 Z200 E5", "M84" }));
    }

    [Test]
    public void A_size_in_a_comment_is_the_bed()
    {
        var found = Import("; Lutum, 400 x 460 x 800 mm\nG28\nM83\nT0\nG1 X200 Y200 Z1.3\nG1 E10 F1000\nG91", "", out var problems);
        Assert.That(found.Printers[0].BuildVolume, Is.EqualTo(new Vec3(400, 460, 800)));
        Assert.That(found.Materials[0].NozzleTemperature, Is.Zero);
        Assert.That(found.Printers[0].MinExtrusionTemperature, Is.Zero, "clay is extruded cold");
        Assert.That(problems.Select(p => p.Code), Does.Contain("header.no_heating"));
    }

    [Test]
    public void Negative_positions_mean_an_origin_in_the_middle()
    {
        var found = Import("G28\nG90\nM82\nG1 X-90 Y0 Z0.3\nG1 X0 Y90 E10\nG1 X0 Y0", "", out _);
        Assert.That(found.Printers[0].Origin, Is.EqualTo(BedOrigin.Center));
        Assert.That(found.Printers[0].ExtrusionMode, Is.EqualTo(ExtrusionMode.Absolute));
        Assert.That(found.Printers[0].BuildBounds.Contains(new Vec3(-90, 90, 0)), Is.True);
    }

    [Test]
    public void Cold_extrusion_tools_and_further_temperatures_are_seen()
    {
        var found = Import("M302 S0\nT1\nM104 S150\nM109 S205\nG1 X75 Y88 E20", "", out var problems);
        Assert.That(found.Printers[0].ToolCount, Is.EqualTo(2));
        Assert.That(found.Printers[0].MinExtrusionTemperature, Is.Zero);
        Assert.That(Render(found, p => p.StartGCode), Does.Contain("M104 S150").And.Contain("M109 S205"));
        Assert.That(problems.Select(p => p.Code), Does.Contain("header.other_temperature").And.Contain("header.e_mode"));
    }

    [Test]
    public void Macros_texts_and_flags_are_not_errors()
    {
        var found = Import("START_PRINT BED=60 EXTRUDER=210\nM117 Hello, 5 words {x}\nG28 X Y\nM84 X Y E\nN5 G1 X5*33\n(note) G1 X{x}\nM98 P\"start.g\"\nG4 S5",
            "", out var problems);
        Assert.That(problems.Where(p => p.Severity != Severity.Note), Is.Empty);
        Assert.That(Render(found, p => p.StartGCode)[0], Is.EqualTo("START_PRINT BED=60 EXTRUDER=210"));
    }

    [TestCase("G1 X{start}", "import.template", "; G1 X{start}")]
    [TestCase("G1 X{x", "import.template", "; G1 X{x")]
    [TestCase("M117 }", "import.template", "; M117 }")]
    [TestCase("G1 X", "header.bad_word", "; invalid: G1 X")]
    [TestCase("G1 X1 ,Y2", "header.bad_word", "; invalid: G1 X1 ,Y2")]
    [TestCase("X1 Y2", "header.no_command", "; invalid: X1 Y2")]
    public void Bad_lines_are_warnings_and_their_text_is_kept(string line, string code, string kept)
    {
        var found = Import("M83\n" + line, "", out var problems);
        Assert.That(problems.Where(p => p.Severity == Severity.Warning).Select(p => p.Code), Is.EqualTo(new[] { code }));
        Assert.That(Render(found, p => p.StartGCode)[1], Is.EqualTo(kept));
    }

    [Test]
    public void Inches_and_empty_files_are_reported()
    {
        var inches = HeaderImport.Read("G20\nG28", "");
        Assert.That(inches.Value, Is.Null);
        Assert.That(inches.Diagnostics.Single().Code, Is.EqualTo("header.inches"));
        Import("", "", out var problems);
        Assert.That(problems.Select(p => p.Code), Does.Contain("header.empty"));
    }

    [TestCase("G28\nG1 X-150 Y-20 Z5", 300, 200)]
    [TestCase("G28\nG1 X-30 Y10 Z5\nG1 X160", 320, 200)]
    public void A_bed_with_positions_left_of_its_origin_has_it_in_the_middle(string header, double least, double leastY)
    {
        var found = Import(header, "", out _);
        Assert.That(found.Printers[0].Origin, Is.EqualTo(BedOrigin.Center));
        Assert.That(found.Printers[0].BuildVolume.X, Is.EqualTo(least));
        Assert.That(found.Printers[0].BuildVolume.Y, Is.GreaterThanOrEqualTo(leastY));
    }

    [Test]
    public void A_purge_a_little_beside_the_bed_does_not_move_the_origin()
        => Assert.That(Import("G28\nG1 X-20 Y-20 Z0.3", "", out _).Printers[0].Origin, Is.Not.EqualTo(BedOrigin.Center));

    [Test]
    public void The_profile_survives_its_file_and_prints()
    {
        var found = Import(Ender, Footer, out _);
        var file = ProfileReader.Read<Printer>(ProfileWriter.Write(found.Printers[0]), "ender.json", found.Printers[0].Name);
        Assert.That(file.Diagnostics, Is.Empty);
        Assert.That(file.Value, Is.EqualTo(found.Printers[0]));
        var setup = new PrintSetup(found.Printers[0], found.Materials[0], new PrintSettings());
        var path = new PrintPath([new Vec3(90, 90, 0.2), new Vec3(110, 90, 0.2)], Bead.FromWidth(0.45, 0.2));
        var written = SafeWriter.ToDocument(Planner.Plan([path], setup).Value!, setup);
        Assert.That(written.Diagnostics.Where(d => d.Severity == Severity.Error), Is.Empty);
        var decoded = GCodeDecoder.Decode(written.Value!).Value!.Toolpath;
        Assert.That(decoded.Moves().Last(m => m.Kind == MoveKind.Print).End, Is.EqualTo(new Vec3(110, 90, 0.2)));
        Assert.That(decoded.Moves().Last().End.Z, Is.GreaterThan(100), "the footer went up from where the print ended");
    }

    [Test]
    public void No_text_throws()
    {
        var random = new Random(5);
        const string Letters = "GMTXYZESFN0123456789.-+ {}xyz:;()*\"<=>\r\n\t\u00e4\0_";
        for (var i = 0; i < 400; i++)
        {
            var text = string.Concat(Enumerable.Range(0, random.Next(60)).Select(_ => Letters[random.Next(Letters.Length)]));
            var template = Templated.Remove(random.Next(Templated.Length)) + text;
            var result = HeaderImport.Read(template, text);
            Assert.That(result.Value is not null || result.HasErrors, Is.True);
        }
    }

    private static ImportedProfiles Import(string header, string footer, out IReadOnlyList<Diagnostic> problems)
    {
        var result = HeaderImport.Read(header, footer);
        problems = result.Diagnostics;
        Assert.That(result.Value, Is.Not.Null);
        return result.Value!;
    }

    private static IReadOnlyList<string> Render(ImportedProfiles found, Func<Printer, ValueList<string>> template, double height = 0)
    {
        var setup = new PrintSetup(found.Printers[0], found.Materials[0], new PrintSettings());
        var path = new PrintPath([new Vec3(50, 50, height), new Vec3(60, 50, height)], new Bead(0.1));
        var toolpath = Planner.Plan([path], setup, new PlanOptions { Policy = PlanPolicy.AsDrawn }).Value!;
        return PrintTemplate.Parse(template(found.Printers[0])).Value!.Render(PrintValues.Of(setup, toolpath)).Value!;
    }

    [TestCase("G28\nG1 X90 Y60 Z5", 180, 120)]
    [TestCase("G28\nG1 X20 Y20 Z5", 40, 40)]
    [TestCase("G28\nG1 X90 Y60\nG1 X200 Y10\nG1 X90 Y60", 200, 120)]
    public void A_header_that_ends_in_the_middle_of_the_bed_tells_its_size(string header, double width, double depth)
    {
        var printer = HeaderImport.Read(header, "").Value!.Printers[0];
        Assert.That((printer.BuildVolume.X, printer.BuildVolume.Y), Is.EqualTo((width, depth)));
        Assert.That(printer.Origin, Is.EqualTo(BedOrigin.Corner));
    }

    [Test]
    public void A_header_that_goes_to_negative_places_has_its_origin_in_the_middle()
    {
        var printer = HeaderImport.Read("G28\nG1 X-150 Y0\nG1 X0 Y-140 Z5\nG1 X40 Y20", "").Value!.Printers[0];
        Assert.That(printer.Origin, Is.EqualTo(BedOrigin.Center));
        Assert.That((printer.BuildVolume.X, printer.BuildVolume.Y), Is.EqualTo((300.0, 280.0)));
    }

    [TestCase("G28\nG1 X90 Y60 Z5", "marlin2")]
    [TestCase("G28 W\nG80\nG1 X90 Y60 Z5", "prusa")]
    public void The_firmware_is_that_of_a_similar_printer_or_what_the_words_show(string header, string flavor)
    {
        Assert.That(HeaderImport.Read(header, "").Value!.Printers[0].Flavor.Name, Is.EqualTo(flavor));
        var klipper = new ProfileLibrary().Printer("klipper_256").OrThrow();
        Assert.That(HeaderImport.Read(header, "", "a", klipper).Value!.Printers[0].Flavor.Name, Is.EqualTo("klipper"));
    }
}
