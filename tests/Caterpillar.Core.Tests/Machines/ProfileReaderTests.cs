using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Flavors;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using NUnit.Framework;

namespace Caterpillar.Tests.Machines;

public class ProfileReaderTests
{
    [Test]
    public void Values_are_read_by_their_keys()
    {
        var printer = ProfileReader.Read<Printer>(
            """
            {
              // comments are welcome
              "title": "Mine", "gcode_flavor": "klipper", "build_volume_mm": [300, 310.5, 4e2], "origin": "center", "firmware_retraction": true,
              "decimals_e": 4, "tool_offsets_mm": [[0, 0, 0], [18, 0.1, 0]], "start_gcode": ["G28", "M104 S{nozzle_temperature_c}"]
            }
            """,
            "mine.json", "mine");
        Assert.That(printer.Diagnostics, Is.Empty);
        Assert.That(printer.Value, Is.EqualTo(new Printer
        {
            Name = "mine",
            Title = "Mine",
            Flavor = FlavorTable.Klipper,
            BuildVolume = new Vec3(300, 310.5, 400),
            Origin = BedOrigin.Center,
            FirmwareRetraction = true,
            DecimalsE = 4,
            ToolOffsets = new ValueList<Vec3>(Vec3.Zero, new(18, 0.1, 0)),
            StartGCode = new ValueList<string>("G28", "M104 S{nozzle_temperature_c}"),
        }));
    }

    [TestCase("layer_height_cm", "layer_height_mm")]
    [TestCase("layer_height", "layer_height_mm")]
    [TestCase("print_speed_mm_min", "print_speed_mm_s")]
    [TestCase("print_speed_m_s", "print_speed_mm_s")]
    [TestCase("infill_angle_rad", "infill_angle_deg")]
    [TestCase("infill_overlap_mm", "infill_overlap_percent")]
    public void A_key_with_another_unit_suggests_the_right_key(string wrong, string right)
    {
        var error = Settings($"{{\n  \"wall_count\": 3,\n  \"{wrong}\": 0.2\n}}").Single();
        Assert.That(error.Code, Is.EqualTo("profile.wrong_unit"));
        Assert.That(error.Message, Does.Contain(wrong).And.Contain(right));
        Assert.That(error.Source, Is.EqualTo(new SourceLocation("s.json", 3, 3, wrong)));
    }

    [Test]
    public void Every_unknown_key_is_named()
    {
        var errors = Settings("""{ "wal_count": 2, "colour": "red", "filament_diameter_mm": 1.75 }""");
        Assert.That(errors.Select(e => e.Code), Is.All.EqualTo("profile.unknown_key"));
        Assert.That(errors.Select(e => e.Source!.Key), Is.EqualTo(new[] { "wal_count", "colour", "filament_diameter_mm" }));
        Assert.That(errors[0].Message, Does.Contain("Did you mean wall_count?"));
        Assert.That(errors[2].Message, Does.Contain("a key of materials"));
    }

    [TestCase("\"0.2 mm\"", "the text \"0.2 mm\"")]
    [TestCase("true", "true")]
    [TestCase("false", "false")]
    [TestCase("[0.2]", "a list of 1 value")]
    [TestCase("[0.2, 0.3]", "a list of 2 values")]
    public void A_value_of_a_wrong_type_is_named(string value, string name)
        => Assert.That(Settings($"{{ \"layer_height_mm\": {value} }}").Single().Message, Does.EndWith($", not {name}."));

    [TestCase("""{ "layer_height_mm": "0.2 mm" }""", "profile.wrong_type", "layer_height_mm")]
    [TestCase("""{ "layer_height_mm": [0.2] }""", "profile.wrong_type", "layer_height_mm")]
    [TestCase("""{ "layer_height_mm": null }""", "profile.wrong_type", "layer_height_mm")]
    [TestCase("""{ "layer_height_mm": {} }""", "profile.wrong_type", "layer_height_mm")]
    [TestCase("""{ "layer_height_mm": -0.2 }""", "profile.out_of_range", "layer_height_mm")]
    [TestCase("""{ "layer_height_mm": 0.0001 }""", "profile.out_of_range", "layer_height_mm")]
    [TestCase("""{ "wall_count": 2.5 }""", "profile.wrong_type", "wall_count")]
    [TestCase("""{ "wall_count": 1e300 }""", "profile.bad_json", null)]
    [TestCase("""{ "sort_paths": 1 }""", "profile.wrong_type", "sort_paths")]
    [TestCase("""{ "sort_paths": "yes" }""", "profile.wrong_type", "sort_paths")]
    [TestCase("""{ "z_hop_type": "high" }""", "profile.wrong_type", "z_hop_type")]
    [TestCase("""{ "title": "" }""", "profile.out_of_range", "title")]
    [TestCase("""{ "wall_count": 2, "wall_count": 3 }""", "profile.duplicate_key", "wall_count")]
    [TestCase("""{ "inherits": 3 }""", "profile.wrong_type", "inherits")]
    [TestCase("""{ "inherits": "no_such" }""", "profile.no_parent", "inherits")]
    [TestCase("""[1]""", "profile.not_an_object", null)]
    [TestCase("", "profile.not_an_object", null)]
    [TestCase("""{ "wall_count": 2 """, "profile.bad_json", null)]
    [TestCase("""{ "wall_count": 2 } x""", "profile.bad_json", null)]
    [TestCase("""{ wall """, "profile.bad_json", null)]
    [TestCase("""{ "wall_count": 0,2 }""", "profile.bad_json", null)]
    public void Bad_profiles_are_errors_with_file_and_key(string json, string code, string? key)
    {
        var error = Settings(json).First();
        Assert.That((error.Code, error.Source!.Key, error.Source.File, error.Severity), Is.EqualTo((code, key, "s.json", Severity.Error)), error.ToString());
        Assert.That(error.Source.Line, Is.Not.Null);
    }

    [TestCase("""{ "build_volume_mm": [220, 220] }""", "build_volume_mm")]
    [TestCase("""{ "build_volume_mm": [220, 220, 0] }""", "build_volume_mm")]
    [TestCase("""{ "build_volume_mm": [220, "220", 250] }""", "build_volume_mm")]
    [TestCase("""{ "head_boxes_mm": [[0, 0, 0, -1, 1, 1]] }""", "head_boxes_mm")]
    [TestCase("""{ "head_outline_mm": [] }""", "head_outline_mm")]
    [TestCase("""{ "tool_offsets_mm": [] }""", "tool_offsets_mm")]
    [TestCase("""{ "gcode_flavor": "marlin3" }""", "gcode_flavor")]
    [TestCase("""{ "start_gcode": "G28" }""", "start_gcode")]
    [TestCase("""{ "start_gcode": ["G28", 3] }""", "start_gcode")]
    [TestCase("""{ "start_gcode": ["G28", "M104 S{temperature}"] }""", "start_gcode")]
    public void Bad_lists_and_templates_are_errors(string json, string key)
    {
        var result = ProfileReader.Read<Printer>(json, "p.json", "p");
        Assert.That(result.Value, Is.Null);
        Assert.That(result.Diagnostics.Single().Source!.Key, Is.EqualTo(key));
    }

    [Test]
    public void An_error_in_a_template_states_its_position()
        => Assert.That(
            ProfileReader.Read<Printer>("""{ "start_gcode": ["G28", "M104 S{temperature}"] }""", "p.json", "p").Diagnostics.Single().Message,
            Does.Contain("line 2:8").And.Contain("temperature"));

    [Test]
    public void What_is_written_is_read_again()
    {
        var printer = new Printer { Name = "x", RetractionLength = 0.123456789012345,
            HeadBoxes = new ValueList<Bounds>(new Bounds(Vec3.Zero, new Vec3(1, 2, 3))), StartGCode = new ValueList<string>("M117 \"ü\" \\ {{") };
        Assert.That(ProfileReader.Read<Printer>(ProfileWriter.Write(printer), "f", "x").Value, Is.EqualTo(printer));
        var material = new Material { Name = "m", FilamentDiameter = 2.85, CostPerKg = 1e-7 };
        Assert.That(ProfileReader.Read<Material>(ProfileWriter.Write(material), "f", "m").Value, Is.EqualTo(material));
        var settings = new PrintSettings { Name = "s", ZHopType = ZHopType.AbovePath, DeretractDuringDescent = true };
        Assert.That(ProfileReader.Read<PrintSettings>(ProfileWriter.Write(settings), "f", "s").Value, Is.EqualTo(settings));
    }

    [Test]
    public void Changed_bytes_never_throw()
    {
        var random = new Random(11);
        var text = ProfileWriter.Write(new Printer { StartGCode =
            new ValueList<string>("G28", "{if bed_temperature_c > 0}M190 S{bed_temperature_c}{endif}") });
        for (var i = 0; i < Rounds.Of(quick: 700, full: 3000, onMono: 300); i++)
        {
            var chars = text.ToCharArray();
            for (var k = random.Next(1, 6); k > 0; k--) chars[random.Next(chars.Length)] = "{}[]\",:0-9e.tfn\\ /*\n\0ü"[random.Next(22)];
            var changed = new string(chars, 0, random.Next(8) == 0 ? random.Next(chars.Length) : chars.Length);
            var result = ProfileReader.Read<Printer>(changed, "f", "n");
            Assert.That(result.Value is null, Is.EqualTo(result.HasErrors), changed);
        }
    }

    private static Diagnostic[] Settings(string json)
    {
        var result = ProfileReader.Read<PrintSettings>(json, "s.json", "s");
        Assert.That(result.Value, Is.Null);
        return result.Diagnostics.ToArray();
    }
}
