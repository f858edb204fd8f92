using System.Linq;
using System.Text;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using NUnit.Framework;

namespace Caterpillar.Tests.Jobs;

/// <summary>Start and end code are cut out of a print without settings.</summary>
[Category("Arithmetic")]
public class PrintCodeTests
{
    private const string Start = "; a print\nG28\nM73 P0\nM104 S200\nM109 S200\nM486 S0\nG90\nM83\nG1 X0 Y0 Z5 F3000\n";
    private const string Layers = ";LAYER:0\nG1 X50 Y50 Z0.2\nG1 X70 E1\n;LAYER:1\nG1 Z0.4\nG1 X50 E1\n";
    private const string End = "G0 X0 Y0\n;LAYER:2\nG1 Z20\nG2 X5 I2.5\nM104 S0\nG1 X1\nM84 ; motors off\n; settings\n";

    private static Printer Of(string print, string? footer = null)
        => ProfileImport.Read(Encoding.UTF8.GetBytes(print), footer is null ? null : Encoding.UTF8.GetBytes(footer), "made").OrThrow().Printers[0];

    private static string Lines(ValueList<string> code) => string.Join("|", code);

    [Test]
    public void The_start_ends_before_the_first_layer_and_the_end_begins_after_the_last_moves()
    {
        var printer = Of(Start + Layers + End);
        Assert.That(Lines(printer.StartGCode), Is.EqualTo("G28|{if nozzle_temperature_c > 0}|M104 S{start_nozzle_temperature_c}|{endif}|"
            + "{if nozzle_temperature_c > 0}|M109 S{start_nozzle_temperature_c}|{endif}|G90|M83|G1 X0 Y0 Z5 F3000"));
        Assert.That(Lines(printer.EndGCode), Is.EqualTo("G90 ; as set by the header|M104 S0|G1 X1|M84 ; motors off"));
    }

    [Test]
    public void Code_that_a_slicer_marks_as_custom_keeps_its_moves()
        => Assert.That(Lines(Of(Start + Layers + "G1 X9\n;TYPE:Custom\n" + End).EndGCode),
            Does.StartWith("G90 ; as set by the header|G0 X0 Y0|").And.Contain("|G1 Z20|"));

    [Test]
    public void The_end_may_come_from_another_file_or_another_print()
    {
        Assert.That(Lines(Of(Start + Layers + End, "M107\nM84").EndGCode), Is.EqualTo("M107|M84"));
        Assert.That(Lines(Of("G28\nM83", "G90\n" + Layers + "M18\n").EndGCode), Is.EqualTo("M18"));
    }

    [Test]
    public void A_header_that_primes_is_all_start()
    {
        const string Primes = "G28\nM83\nG1 X0 Y5 Z0.2\nG1 X100 E9\nG1 Z0.4\nG1 X0 E9";
        Assert.That(Lines(Of(Primes).StartGCode), Is.EqualTo(Primes.Replace('\n', '|')));
        Assert.That(Of(Primes).EndGCode, Is.Empty);
    }

    [Test]
    public void Three_heights_without_marks_are_a_print()
        => Assert.That(Lines(Of("G28\nM83\nG1 X0 Y5 Z0.2\nG1 X100 E9\nG1 Z0.4\nG1 X0 E9\nG1 Z0.6\nG1 X100 E9\nM84").StartGCode),
            Does.StartWith("G28|M83").And.Not.Contain("E9"));

    [Test]
    public void A_file_that_names_its_firmware_has_that_flavor()
    {
        Assert.That(Of(";FLAVOR:RepRap\n; generated for RepRapFirmware\nM83\nM106 P0 S0.5\nG10 P0 S200\nM98 P\"a.g\"\nG28").Flavor.Name,
            Is.EqualTo("reprapfirmware"));
        Assert.That(Of("G28\nM83").Flavor.Name, Is.EqualTo(new Printer().Flavor.Name));
    }

    [TestCase("solid cube\nfacet normal 0 0 1", "gcode.not_gcode")]
    [TestCase("G20\nG28", "header.inches")]
    public void What_gives_no_printer_is_an_error(string text, string code)
    {
        var read = ProfileImport.Read(Encoding.UTF8.GetBytes(text), null, "made", null, "start.g");
        Assert.That(read.Value, Is.Null);
        Assert.That(read.Diagnostics.Select(d => (d.Code, d.Source?.File)), Is.EqualTo(new[] { (code, "start.g") }));
    }

    [TestCase(20, true)]
    [TestCase(19, false)]
    public void Twenty_known_names_in_comments_are_the_settings_of_a_slicer(int count, bool isSetup)
    {
        string[] names =
        [
            "layer_height", "first_layer_height", "perimeters", "top_solid_layers", "bottom_solid_layers", "fill_density", "fill_pattern", "infill_speed",
            "perimeter_speed", "external_perimeter_speed", "travel_speed", "first_layer_speed", "temperature", "first_layer_temperature", "bed_temperature",
            "first_layer_bed_temperature", "nozzle_diameter", "filament_diameter", "retract_length", "retract_speed",
        ];
        Assert.That(names.Where(n => !Caterpillar.Machines.SlicerPreset.IsKnown(n)), Is.Empty);
        var comments = string.Concat(names.Take(count).Select(n => $"; {n} = 1\n")) + "; some_other = 1\n; one_more = 2\n";
        var read = ProfileImport.Read(Encoding.UTF8.GetBytes("G28\nM83\n" + comments), null, "made").OrThrow();
        Assert.That(read.Settings.Count, Is.EqualTo(isSetup ? 1 : 0));
    }
}
