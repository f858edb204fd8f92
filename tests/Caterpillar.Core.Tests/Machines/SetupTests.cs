using System;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Flavors;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Machines;

public class SetupTests
{
    private string _folder = "";

    [SetUp]
    public void MakeFolder()
    {
        _folder = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N"));
        Directory.CreateDirectory(Path.Combine(_folder, "materials"));
        Directory.CreateDirectory(Path.Combine(_folder, "settings"));
    }

    [TearDown]
    public void DropFolder() => Directory.Delete(_folder, recursive: true);

    [Test]
    public void Values_of_all_three_profiles_are_set_by_their_keys()
    {
        var setup = new PrintSetup().With("layer_height_mm=0.3", "bed_temperature_c=0", "build_volume_mm=300,310,400", "bead_shape = circle", "sort_paths=no",
            "end_gcode=M104 S0\\nM84").Value!;
        Assert.That(setup.Settings.LayerHeight, Is.EqualTo(0.3));
        Assert.That(setup.Material.BedTemperature, Is.Zero);
        Assert.That(setup.Printer.BuildVolume, Is.EqualTo(new Vec3(300, 310, 400)));
        Assert.That(setup.Settings.BeadShape, Is.EqualTo(BeadShape.Circle));
        Assert.That(setup.Settings.SortPaths, Is.False);
        Assert.That(setup.Printer.EndGCode, Is.EqualTo(new[] { "M104 S0", "M84" }));
        Assert.That(new PrintSetup().With("tool_offsets_mm=0 0 0;18 0 0").Value!.Printer.ToolCount, Is.EqualTo(2));
    }

    [TestCase("layer_height=0.3", "profile.wrong_unit", "layer_height_mm")]
    [TestCase("nozle_diameter_mm=0.6", "profile.unknown_key", "nozzle_diameter_mm")]
    [TestCase("layer_height_mm", "profile.no_value", "key=value")]
    [TestCase("layer_height_mm=0,3", "profile.wrong_type", "0,3")]
    [TestCase("layer_height_mm=", "profile.wrong_type", "a number")]
    [TestCase("layer_height_mm=-1", "profile.out_of_range", "0 to 1000")]
    [TestCase("layer_height_mm=NaN", "profile.wrong_type", "NaN")]
    [TestCase("title=x", "profile.unknown_key", "title")]
    [TestCase("height_ranges_mm=12,10,0.1", "profile.out_of_range", "not from 12 to 10 mm")]
    [TestCase("height_ranges_mm=10,12,0", "profile.out_of_range", "0.001")]
    [TestCase("height_ranges_mm=[[11,14,0.3],[10,12,0.1]]", "profile.out_of_range", "two ranges for 11 to 12 mm")]
    [TestCase("brim=5", "profile.unknown_key",
        "Did you mean brim_width_mm, brim_type, brim_ears_max_angle_deg, brim_ears_mm, brim_gap_mm or "
        + "purge_tower_brim_width_mm?")]
    [TestCase("raft=1", "profile.unknown_key", "Did you mean raft_layers, raft_expansion_mm, raft_layer_height_mm, raft_gap_mm or raft_density_percent?")]
    [TestCase("skirt=2", "profile.unknown_key", "Did you mean skirt_loops or skirt_distance_mm?")]
    [TestCase("wall_line_count=3", "profile.unknown_key", "wall_count=3.")]
    [TestCase("walls=3", "profile.unknown_key", "wall_count")]
    [TestCase("nonsense=3", "profile.unknown_key", "settings.")]
    [TestCase("start_gcode=M104 S{nozzle_temperature}", "template.unknown_name",
        "start_gcode has an error in line 1:8: Unknown variable 'nozzle_temperature'. Did you mean 'nozzle_temperature_c'?")]
    [TestCase("start_gcode={if 1}", "template.no_endif", "start_gcode has an error in line 1:2: {if} without {endif}.")]
    [TestCase("layer_height_formula=0.2 +", "profile.out_of_range", "layer_height_formula is not a valid formula: ")]
    [TestCase("wall_count=1e99", "profile.wrong_type", "integer")]
    [TestCase("overhang_classes=101 20 100 1", "profile.out_of_range", "up to 100")]
    [TestCase("overhang_classes=50 20 101 1", "profile.out_of_range", "up to 100")]
    [TestCase("overhang_classes=50 20 100 0", "profile.out_of_range", "above 0")]
    [TestCase("overhang_classes=50 20 100 1;50 10 100 1", "profile.out_of_range", "ascending")]
    public void Bad_values_are_named(string value, string code, string word)
    {
        var result = new PrintSetup().With("wall_count=3", value);
        Assert.That(result.Value, Is.Null);
        var error = result.Diagnostics.Single();
        Assert.That(error.Code, Is.EqualTo(code));
        Assert.That(error.Message, Does.Contain(word));
        Assert.That(error.Source!.Key, Is.Not.Null);
    }

    [Test]
    public void Percents_are_of_the_speed_of_the_profile_or_factors()
    {
        var setup = new PrintSetup { Settings = new PrintSettings { OuterWallSpeed = 30, PrintSpeed = 60 } };
        var changed = setup.With("outer_wall_speed_mm_s=50%", "flow_ratio=95%", "infill_density_percent=15%").OrThrow();
        Assert.That((changed.Settings.OuterWallSpeed, changed.Material.FlowRatio, changed.Settings.InfillDensityPercent), Is.EqualTo((15.0, 0.95, 15.0)));
        Assert.That(setup.With("layer_height_mm=50%").Diagnostics, Is.Not.Empty);
        Assert.That(setup.With("outer_wall_speed_mm_s=half%").Diagnostics, Is.Not.Empty);
    }

    // Corners of a bed; one whose middle is within a tenth of its size from the origin has its origin in the middle.
    [TestCase("0x0,220x0,220x200,0x200", BedOrigin.Corner, 220, 200)]
    [TestCase("-110x-100,110x-100,110x100,-110x100", BedOrigin.Center, 220, 200)]
    [TestCase("-90x-100,130x-100,130x100,-90x100", BedOrigin.Center, 180, 200)]
    [TestCase("-110x-119,110x-119,110x81,-110x81", BedOrigin.Center, 220, 162)]
    [TestCase("-87x-100,133x-100,133x100,-87x100", BedOrigin.Corner, 133, 100)]
    [TestCase("-110x-79,110x-79,110x121,-110x121", BedOrigin.Corner, 110, 121)]
    public void The_origin_of_a_bed_is_found_from_its_corners(string points, BedOrigin origin, double width, double depth)
    {
        var bed = BedOutline.Read(points)!;
        Assert.That((bed.Origin, bed.Shape, bed.Size), Is.EqualTo((origin, BedShape.Rectangle, new Vec3(width, depth))));
        Assert.That(BedOutline.Read(points.Split(',')[0]), Is.Null);
    }

    [TestCase("0x0,220x0,220x0.9,0x0.9")]
    [TestCase("0x0,0.9x0,0.9x200,0x200")]
    public void A_bed_as_thin_as_a_line_is_none(string points) => Assert.That(BedOutline.Read(points), Is.Null);

    [Test]
    public void The_least_adaptive_height_may_not_exceed_the_greatest()
    {
        var setup = new PrintSetup().With("adaptive_min_height_mm=0.3", "adaptive_max_height_mm=0.1").Value!;
        Assert.That(setup.Check(), Is.Empty, "it is not used");
        var error = (setup with { Settings = setup.Settings with { AdaptiveLayers = true } }).Check().Single();
        Assert.That((error.Severity, error.Code), Is.EqualTo((Severity.Error, "setup.adaptive_heights")));
    }

    [Test]
    public void Profiles_of_the_user_override_the_built_in_ones()
    {
        File.WriteAllText(Path.Combine(_folder, "ender3.json"), """{ "inherits": "ender3", "nozzle_diameter_mm": 0.6 }""");
        File.WriteAllText(Path.Combine(_folder, "mine.json"), """{ "inherits": "ender3", "title": "Mine" }""");
        File.WriteAllText(Path.Combine(_folder, "materials", "wood.json"), """{ "inherits": "pla", "nozzle_temperature_c": 190 }""");
        var library = new ProfileLibrary(_folder);
        Assert.That(library.Names<Printer>(), Is.SupersetOf(new[] { "ender3", "generic", "mine" }));
        Assert.That(library.Names<Printer>(), Is.Unique.And.Ordered.Using<string>(StringComparer.Ordinal));
        var mine = library.Printer("mine").Value!;
        Assert.That((mine.Name, mine.Title, mine.NozzleDiameter, mine.Flavor), Is.EqualTo(("mine", "Mine", 0.6, FlavorTable.Marlin1)));
        Assert.That(mine.StartGCode, Is.Not.Empty);
        var setup = library.Setup("mine", "wood", null, ["layer_height_mm=0.28"]).Value!;
        Assert.That((setup.Material.NozzleTemperature, setup.Material.BedTemperature, setup.Settings.Name, setup.Settings.LayerHeight),
            Is.EqualTo((190.0, 60.0, "standard", 0.28)));
    }

    [Test]
    public void A_profile_may_be_a_file()
    {
        var file = Path.Combine(_folder, "p.json");
        File.WriteAllText(file, """{ "inherits": "prusa_mk3s", "e_mode": "absolute" }""");
        var printer = new ProfileLibrary().Printer(file).Value!;
        Assert.That((printer.Name, printer.ExtrusionMode, printer.BuildVolume.X), Is.EqualTo(("p", ExtrusionMode.Absolute, 250.0)));
    }

    [Test]
    public void A_cycle_of_profiles_is_an_error()
    {
        File.WriteAllText(Path.Combine(_folder, "a.json"), """{ "inherits": "b" }""");
        File.WriteAllText(Path.Combine(_folder, "b.json"), """{ "inherits": "a" }""");
        var result = new ProfileLibrary(_folder).Printer("a");
        Assert.That(result.Value, Is.Null);
        Assert.That(result.Diagnostics.Select(d => d.Code), Does.Contain("profile.circular_inheritance"));
    }

    [Test]
    public void Unknown_profiles_suggest_similar_ones()
    {
        var library = new ProfileLibrary();
        Assert.That(library.Setup("ender4").Diagnostics.Single().Message, Does.EndWith("Did you mean ender3?"));
        Assert.That(library.Setup(material: "plaa").Diagnostics.Single().Message, Is.EqualTo("Material \"plaa\" not found. Did you mean pla?"));
        Assert.That(library.Setup(material: "unobtainium").Diagnostics.Single().Message,
            Does.StartWith("Material \"unobtainium\" not found. Available: ").And.Contain(", pla,"));
        Assert.That(library.Printer(Path.Combine(_folder, "none.json")).Diagnostics.Single().Code, Is.EqualTo("profile.not_found"));
        Assert.That(library.Printer("../generic").Value, Is.Null);
    }

    [Test]
    public void The_file_of_a_bad_profile_is_named()
    {
        File.WriteAllText(Path.Combine(_folder, "settings", "s.json"), """{ "layer_height_cm": 0.02 }""");
        var error = new ProfileLibrary(_folder).Settings("s").Diagnostics.Single();
        Assert.That(error.Source!.File, Does.EndWith("s.json"));
        Assert.That(error.ToString(), Does.Contain("s.json:1:3: layer_height_cm: error profile.wrong_unit"));
    }

    [Test]
    public void Conflicting_values_are_reported()
    {
        var library = new ProfileLibrary();
        Assert.That(library.Setup(values: ["line_width_mm=0.1"]).Diagnostics.Single().Code, Is.EqualTo("setup.narrow_bead"));
        Assert.That(library.Setup(values: ["line_width_mm=0.1"]).Value, Is.Null);
        Assert.That(library.Setup(values: ["layer_height_mm=0.42"]).Diagnostics.Single().Code, Is.EqualTo("setup.layer_height"));
        Assert.That(library.Setup("pen_plotter", values: ["firmware_retraction=true"]).Diagnostics.Single().Code, Is.EqualTo("setup.no_firmware_retraction"));
    }

    [Test]
    public void Values_at_the_ends_of_their_range_are_good()
    {
        var setup = new PrintSetup().With("overhang_classes=50 20 100 1;100 10 100 0.5", "infill_density_percent=100", "height_ranges_mm=0 1 0.001",
            "wall_count=0")
            .Value!;
        Assert.That(setup.Settings.OverhangClasses.Select(c => (c.Percent, c.Speed, c.MinFanSpeedPercent, c.Flow)), Is.EqualTo(new[]
        {
            (50.0, 20.0, 100.0, 1.0), (100.0, 10.0, 100.0, 0.5),
        }));
        Assert.That(setup.Settings.LayerRanges.Single(), Is.EqualTo(new LayerRange(0, 1, 0.001)));
        // Every whole number at the top of its range.
        foreach (var key in ProfileKeys.Of<PrintSettings>().Where(k => k.Kind == KeyKind.Integer && k.Range.Contains(" to ")))
            Assert.That(new PrintSetup().With($"{key.Name}={key.Range.Split(' ').Last()}").Diagnostics, Is.Empty, key.Name + ": " + key.Range);
    }

    [Test]
    public void A_name_with_a_folder_or_the_ending_of_a_file_is_a_file()
    {
        var plain = Path.Combine(_folder, "plain");
        File.WriteAllText(plain, """{ "inherits": "ender3", "title": "Plain" }""");
        var library = new ProfileLibrary(_folder);
        Assert.That(Path.IsPathRooted(plain), Is.True);
        Assert.That(library.Printer(plain).OrThrow().Title, Is.EqualTo("Plain"));
        Assert.That(library.Printer("/no/such/printer").Diagnostics.Single().Code, Is.EqualTo(library.Printer("none.json").Diagnostics.Single().Code));
        Assert.That(library.Printer("none").Diagnostics.Single().Code, Is.EqualTo("profile.not_found"));
    }
}
