using System;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Tests.Checks;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

public class FileSetupTests
{
    private static readonly ProfileLibrary Library = new();

    public static string[] Printers => [.. Library.Names<Printer>()];

    [TestCaseSource(nameof(Printers))]
    public void A_setup_comes_back_from_its_comments(string printer)
    {
        string[] values =
        [
            "seam_enforcers_mm=[[1, 2, 3, 4], [4, 5, 6, 7]]", "wall_count=5", "density_g_cm3=1.3", "axis_mappings=X=A*2.86,Y=B*2",
            "check_severities=limit.flow=warning,bed.outside=warning", "end_gcode=G28\\nM84 ; = off",
        ];
        var setup = Library.Setup(printer, values: values).OrThrow();
        var read = FileSetup.Read(Document(setup)).OrThrow();
        Assert.That(read.Differences(setup), Is.Empty);
        Assert.That((read.Printer.Name, read.Material.Name, read.Settings.Name), Is.EqualTo((printer, setup.Material.Name, setup.Settings.Name)));
        Assert.That(read with { Printer = Titled(read.Printer) }, Is.EqualTo(setup with
        {
            Printer = Titled(setup.Printer), Material = setup.Material with { Title = setup.Material.Name },
            Settings = setup.Settings with { Title = setup.Settings.Name },
        }));

        static Printer Titled(Printer p) => p with { Title = p.Name };
    }

    [Test]
    public void A_written_file_prints_the_same_again_as_text_and_in_binary()
    {
        string[] values = ["layer_height_mm=0.15", "thumbnails_px=[[32, 16]]", "layer_change_gcode=M117 {layer}\\nM118 é°€"];
        var setup = Library.Setup("klipper_256", "petg", values: values).OrThrow();
        var toolpath = new SmallPrint(120, 120).InLayer(new Layer(0, 0.2, 0.2, "part")).Over(120, 120, 0.2).Print(140, 120, 0.2).Print(140, 140, 0.2).Build();
        var text = SafeWriter.ToDocument(toolpath, setup).OrThrow();
        var binary = new MemoryStream();
        BinaryGCode.Write(text, binary);
        foreach (var document in new[] { text, GCodeDocument.FromBytes(binary.ToArray()) })
        {
            var read = FileSetup.Read(document).OrThrow();
            Assert.That(read.Differences(setup), Is.Empty);
            var again = SafeWriter.ToDocument(toolpath, read).OrThrow();
            Assert.That(again.ToBytes(), Is.EqualTo(text.ToBytes()));
        }
        var report = GCodeDecoder.Decode(text).Value!.Report;
        Assert.That(report.Setup.First().Value, Is.EqualTo("klipper_256"));
        Assert.That(report.Setup.Count, Is.GreaterThan(200));
        Assert.That(report.ToJson(), Does.Contain("\"setup\": {\"printer_name\": \"klipper_256\", \"material_name\": \"petg\""));
    }

    [Test]
    public void What_follows_from_the_nozzle_follows_another_nozzle()
    {
        var read = FileSetup.Read(Document(new PrintSetup())).OrThrow();
        Assert.That(read.With("nozzle_diameter_mm=0.8").OrThrow().Settings.LineWidth, Is.EqualTo(2 * read.Settings.LineWidth));
    }

    [Test]
    public void Keys_that_an_older_file_does_not_have_keep_their_defaults()
    {
        var whole = Encoding.UTF8.GetString(Document(new PrintSetup()).ToBytes());
        var lines = whole.Split('\n').Where(l => !l.StartsWith("; wall_count", StringComparison.Ordinal));
        var read = FileSetup.Read(GCodeDocument.FromText(string.Join("\n", lines))).OrThrow();
        Assert.That(read, Is.EqualTo(FileSetup.Read(Document(new PrintSetup())).OrThrow()));
    }

    [TestCase("; wall_count = 3", "; wall_count = many", "profile.wrong_type", "wall_count")]
    [TestCase("; wall_count = 3", "; wall_count = -3", "profile.out_of_range", "wall_count")]
    [TestCase("; wall_count = 3", "; wall_cuont = 3", "profile.unknown_key", "wall_cuont")]
    [TestCase("; wall_count = 3", "G1 X3", "setup.damaged", "")]
    [TestCase("; caterpillar_config = end\n", "", "setup.damaged", "")]
    [TestCase("caterpillar_config = begin", "prusaslicer_config = begin", "setup.not_in_file", "")]
    public void A_damaged_or_foreign_file_is_an_error_that_names_the_place(string part, string instead, string code, string key)
    {
        var whole = Encoding.UTF8.GetString(Document(new PrintSetup().With("wall_count=3").OrThrow()).ToBytes());
        Assert.That(whole, Does.Contain(part));
        var text = whole.Replace(part, instead);
        var read = FileSetup.Read(GCodeDocument.FromText(text, "old.gcode"));
        Assert.That(read.Value, Is.Null);
        var error = read.Diagnostics.Single(d => d.Severity == Severity.Error);
        Assert.That(error.Code, Is.EqualTo(code));
        Assert.That(error.Source!.File, Is.EqualTo("old.gcode"));
        Assert.That(error.Source.Key ?? "", Is.EqualTo(key));
        if (instead.Length > 0 && code != "setup.not_in_file")
            Assert.That(error.Source.Line, Is.EqualTo(text.Split('\n').ToList().FindIndex(l => l == instead) + 1));
    }

    [Test]
    public void Figures_for_hosts_are_those_of_the_print()
    {
        // 100 mm of 0.08 mm² are 8 mm³: 3.33 mm of filament, 10 mg.
        var setup = new PrintSetup { Printer = SmallPrint.Generic, Material = new Material { CostPerKg = 5000 } };
        var print = new SmallPrint().InLayer(new Layer(0, 0.2, 0.2)).Print(110, 10, 0.2, speed: 10).Build();
        var lines = Encoding.UTF8.GetString(SafeWriter.ToDocument(print, setup).OrThrow().ToBytes()).Split('\n');
        Assert.That(lines[0], Does.Match(@"^; generated by Caterpillar \d+\.\d+\.\d+ on \d{4}-\d{2}-\d{2} at \d{2}:\d{2}:\d{2}$"));
        string[] expected =
        [
            "; filament used [mm] = 3.33", "; filament used [cm3] = 0.01", "; filament used [g] = 0.01", "; filament cost = 0.05",
            "; total layers count = 1", "; max_layer_z = 0.2", "; filament_type = PLA", "; layer_height = 0.2", "; num_layers = 1",
            "; first_layer_temperature = 210", ";BEFORE_LAYER_CHANGE", ";0.2 mm is the top of the print",
        ];
        Assert.That(expected.Except(lines), Is.Empty);
        Assert.That(lines[lines.Length - 2], Is.EqualTo("; estimated printing time (normal mode) = 10s"), "The last line.");
        var pen = setup with { Printer = setup.Printer with { ExtrusionUnit = ExtrusionUnit.None, SetupComments = false } };
        var plain = Encoding.UTF8.GetString(SafeWriter.ToDocument(print, pen).OrThrow().ToBytes());
        Assert.That(plain, Does.Not.Contain("filament_type").And.Not.Contain("filament used").And.Not.Contain("caterpillar_config"));
    }

    [TestCase(0, "0s")]
    [TestCase(59, "59s")]
    [TestCase(3600, "1h 0m 0s")]
    [TestCase(93784, "1d 2h 3m 4s")]
    public void Times_are_written_as_hosts_read_them(long seconds, string text) => Assert.That(FileComments.Duration(seconds), Is.EqualTo(text));

    private static GCodeDocument Document(PrintSetup setup)
        => GCodeDocument.FromBytes(Encoding.UTF8.GetBytes("G28\n" + string.Join("\n", FileSetup.Lines(setup)) + "\n; estimated time\n"), "old.gcode");
}
