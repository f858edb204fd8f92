using System;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Files;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Machines;

public class SlicerImportTests
{
    private const string Bundle = """
        # a comment
        [vendor]
        name = Acme
        [printer_model:ONE]
        variants = 0.4
        [print:*common*]
        layer_height = 0.2
        perimeters = 2
        perimeter_speed = 50
        external_perimeter_speed = 50%
        infill_speed = 80
        solid_infill_speed = 50%
        top_solid_infill_speed = 40%
        first_layer_height = 75%
        [print:*fast*]
        perimeter_speed = 100
        perimeters = 4
        [print:Normal @Acme]
        inherits = *common*; *fast*
        fill_pattern = gyroid
        perimeters = 3
        infill_every_layers_odd = 2.5
        [filament:*pla*]
        temperature = 205
        first_layer_temperature = 215
        bed_temperature = 60
        filament_max_volumetric_speed = 15
        cooling = 1
        slowdown_below_layer_time = 12
        [filament:Acme PLA]
        inherits = *pla*
        filament_density = 1.24
        filament_retract_length = 1.5
        [printer:*base*]
        gcode_flavor = marlin2
        bed_shape = 0x0,250x0,250x210,0x210
        max_print_height = 200
        machine_max_feedrate_x = 200,100
        machine_max_feedrate_y = 200,100
        machine_max_feedrate_z = 12,12
        machine_max_feedrate_e = 120,120
        retract_length = 0.8
        start_gcode = G28\nM104 S[first_layer_temperature]\nG1 Z5 F[travel_speed]
        [printer:Acme One]
        inherits = *base*
        default_print_profile = Normal @Acme
        default_filament_profile = "Acme PLA"
        [printer:Acme Two]
        inherits = *base*
        max_print_height = 300
        """;

    [Test]
    public void A_bundle_gives_its_printers_with_their_materials_and_settings()
    {
        var made = Read(Bundle);
        var profiles = made.OrThrow();
        Assert.That(profiles.Printers.Select(p => (p.Name, p.Title)), Is.EqualTo(new[] { ("acme_one", "Acme One"), ("acme_two", "Acme Two") }));
        var one = profiles.Printers[0];
        Assert.That((one.DefaultMaterial, one.DefaultSettings), Is.EqualTo(("acme_pla", "normal_acme")));
        Assert.That(one.BuildVolume, Is.EqualTo(new Vec3(250, 210, 200)));
        Assert.That(one.MaxSpeed, Is.EqualTo(new AxisValues(200, 200, 12, 120)));
        Assert.That((one.RetractionLength, profiles.Materials[0].RetractionLength), Is.EqualTo((0.8, 1.5)), "the filament's");
        Assert.That(one.ExtrusionMode, Is.EqualTo(ExtrusionMode.Absolute), "the default of PrusaSlicer");
        Assert.That(profiles.Printers[1].BuildVolume.Z, Is.EqualTo(300));
        var material = profiles.Materials.Single();
        Assert.That((material.Name, material.NozzleTemperature, material.FirstLayerNozzleTemperature, material.BedTemperature),
            Is.EqualTo(("acme_pla", 205.0, 215.0, 60.0)));
        Assert.That((material.MaxFlow, material.Density), Is.EqualTo((15.0, 1.24)));
        var settings = profiles.Settings.Single();
        Assert.That((settings.LayerHeight, settings.FirstLayerHeight, settings.WallCount, settings.InfillPattern),
            Is.EqualTo((0.2, 0.15, 3, InfillPattern.Gyroid)));
        Assert.That((settings.PrintSpeed, settings.OuterWallSpeed, settings.InfillSpeed, settings.SolidInfillSpeed, settings.TopSurfaceSpeed),
            Is.EqualTo((100.0, 50.0, 80.0, 40.0, 16.0)), "percents of percents");
        Assert.That(settings.MinLayerTime, Is.EqualTo(12), "the filament's");
        Assert.That(made.Diagnostics.Single().Message, Does.StartWith("1 setting has no equal here: infill_every_layers_odd=2.5."));
    }

    [Test]
    public void One_printer_of_a_bundle_comes_with_its_own_material_and_settings()
    {
        var found = Read(Bundle, "Acme Two").OrThrow();
        Assert.That((found.Printers.Single().Name, found.Materials.Count, found.Settings.Count), Is.EqualTo(("acme_two", 0, 0)));
        var missing = Read(Bundle, "Acme Too");
        Assert.That(missing.Value, Is.Null);
        Assert.That(missing.Diagnostics.Single().Message, Is.EqualTo("The file has no printer \"Acme Too\". Did you mean \"Acme Two\"?"));
    }

    [Test]
    public void A_preset_without_its_parent_is_reported_with_its_line()
    {
        var found = Read("[print:A]\ninherits = *gone*\nperimeters = 5\n");
        Assert.That(found.Value!.Settings.Single().WallCount, Is.EqualTo(5));
        Assert.That(found.Diagnostics.Single(d => d.Code == "import.no_parent").Source!.Line, Is.EqualTo(1));
    }

    [Test]
    public void An_exported_configuration_is_one_of_each_kind_also_as_comments()
    {
        const string Config = "printer_settings_id = My printer\nperimeters = 4\ntemperature = 231,240\nnozzle_diameter = 0.6,0.6\n"
            + "extrusion_width = 150%\nlayer_height = 0.4\n";
        foreach (var text in new[] { Config, "; generated by a slicer\n; " + Config.TrimEnd().Replace("\n", "\n; ") })
        {
            var profiles = ProfileImport.Read(text[0] == ';' ? Zip("Metadata/Slic3r_PE.config", text) : Encoding.UTF8.GetBytes(text), null, "mine").OrThrow();
            Assert.That((profiles.Printers.Single().Name, profiles.Printers[0].NozzleDiameter, profiles.Printers[0].DefaultSettings),
                Is.EqualTo(("my_printer", 0.6, "mine")));
            Assert.That(profiles.Materials.Single().NozzleTemperature, Is.EqualTo(231));
            Assert.That((profiles.Settings.Single().WallCount, profiles.Settings[0].LineWidth), Is.EqualTo((4, 0.6)));
        }
    }

    [Test]
    public void Json_presets_inherit_from_the_tree_of_their_vendor()
    {
        var folder = Path.Combine(TestContext.CurrentContext.WorkDirectory, "import_" + Guid.NewGuid().ToString("N"));
        try
        {
            Put("Acme.json", "{}");
            Put("Acme/machine/base.json", """
                { "type": "machine", "name": "base", "instantiation": "false", "gcode_flavor": "klipper",
                  "printable_area": ["-90x-90", "90x-90", "90x90", "-90x90"],
                  "printable_height": "180", "machine_start_gcode": "START BED=[bed_temperature_initial_layer_single]", "z_hop": ["0.4", "0.4"] }
                """);
            Put("Acme/machine/Acme 0.4.json", """
                { "type": "machine", "name": "Acme 0.4", "inherits": "base", "nozzle_diameter": ["0.4"], "default_print_profile": "Fine",
                  "default_filament_profile": ["PETG"] }
                """);
            Put("Acme/process/Fine.json", """
                { "type": "process", "name": "Fine", "line_width": "110%", "wall_loops": 3, "wall_sequence": "outer wall/inner wall", "enable_support": true,
                  "support_type": "tree(auto)", "support_threshold_angle": "30", "sparse_infill_density": "12%" }
                """);
            Put("Other.json", "{}");
            Put("Other/filament/PETG.json", """{ "type": "filament", "name": "PETG", "nozzle_temperature": ["245"], "hot_plate_temp": ["80"] }""");
            var file = Path.Combine(folder, "Acme/machine/Acme 0.4.json");
            var made = ProfileImport.Read(File.ReadAllBytes(file), null, "x", null, file);
            var profiles = made.OrThrow();
            var printer = profiles.Printers.Single();
            Assert.That((printer.Flavor.Name, printer.Origin, printer.BuildVolume, printer.ZHop, printer.ExtrusionMode),
                Is.EqualTo(("klipper", BedOrigin.Center, new Vec3(180, 180, 180), 0.4, ExtrusionMode.Relative)));
            Assert.That(printer.StartGCode, Is.EqualTo(new[] { "{if bed_temperature_c > 0}", "M190 S{start_bed_temperature_c}", "{endif}",
                "START BED={start_bed_temperature_c}", "M109 S{start_nozzle_temperature_c}" }));
            Assert.That(made.Diagnostics.Single(d => d.Code == "import.macro").Message, Does.StartWith("START: "));
            Assert.That(profiles.Materials.Single().NozzleTemperature, Is.EqualTo(245));
            var settings = profiles.Settings.Single();
            Assert.That((settings.LineWidth, settings.WallCount, settings.WallOrder, settings.Support, settings.SupportAngle, settings.InfillDensityPercent),
                Is.EqualTo((0.44, 3, WallOrder.OutsideIn, SupportKind.Tree, 60.0, 12.0)));
            File.Delete(Path.Combine(folder, "Acme/machine/base.json"));
            var lost = ProfileImport.Read(File.ReadAllBytes(file), null, "x", null, file);
            Assert.That(lost.Value, Is.Null);
            Assert.That(lost.Diagnostics.First().Message, Does.Contain("The inherited \"base\""));
        }
        finally
        {
            Directory.Delete(folder, true);
        }

        void Put(string name, string text)
        {
            Directory.CreateDirectory(Path.GetDirectoryName(Path.Combine(folder, name))!);
            File.WriteAllText(Path.Combine(folder, name), text);
        }
    }

    [TestCase("M104 S[first_layer_temperature]", "M104 S{start_nozzle_temperature_c}")]
    [TestCase("M104 S{first_layer_temperature[0] - 10}", "M104 S{start_nozzle_temperature_c - 10}")]
    [TestCase("M190 S[first_layer_bed_temperature_0]", "M190 S{start_bed_temperature_c}")]
    [TestCase("G1 Y{print_bed_max[1]*0.85} F{travel_speed*60}", "G1 Y{bed_max_y_mm*0.85} F{travel_speed_mm_s*60}")]
    [TestCase("{if max_layer_z < max_print_height-10}G1 Z{z_offset+min(max_layer_z+70, max_print_height-10)}{endif}",
        "{if print_max_z_mm < bed_max_z_mm-10}G1 Z{0.1+min(print_max_z_mm+70, bed_max_z_mm-10)}{endif}")]
    [TestCase("{if printer_notes=~/.*MODEL_MINI.*/}M1{elsif printer_notes=~/.*MODEL_MK3.*/ and nozzle_diameter[0]==0.6}M2{else}M3{endif}",
        "{if 0}M1{elsif 1 and nozzle_diameter_mm==0.6}M2{else}M3{endif}")]
    [TestCase("{if filament_type[initial_tool]==\"PLA\"}G4{endif}", "{if 1}G4{endif}")]
    [TestCase("M104 S{is_nil(idle_temperature[0]) ? 150 : idle_temperature[0]}", "M104 S{0 ? 150 : standby_temperature_c}")]
    [TestCase("M862.3 P \"[printer_model]\" ; [printer_model]", "M862.3 P \"MK3S\" ; MK3S")]
    [TestCase("M486 S{int(3.7)}", "M486 S{trunc(3.7)}")]
    [TestCase("G92 E0 ; {unknown} [stays]", "G92 E0 ; {{unknown}} [stays]")]
    public void Templates_get_our_names_and_the_values_of_the_file(string theirs, string ours)
    {
        var made = Read(Templated(theirs));
        Assert.That(made.OrThrow().Printers.Single().EndGCode.Single(), Is.EqualTo(ours));
        Assert.That(made.Diagnostics.Where(d => d.Code == "import.template"), Is.Empty);
    }

    [TestCase("G1 X{first_layer_print_convex_hull[0]}", "; G1 X{{first_layer_print_convex_hull[0]}}", "{first_layer_print_convex_hull[0]} has no equal here.")]
    [TestCase("{if magic > 1}G1 X{unknown} ; c{endif}", "{if 0}; G1 X{{unknown}} ; c{endif}", "The condition \"magic > 1\" has no equal here")]
    [TestCase("{local x = 3}", "; {{local x = 3}}", "{local x = 3} has no equal here.")]
    [TestCase("G1 X[unknown_name]", "; G1 X[unknown_name]", "[unknown_name] has no equal here.")]
    public void What_has_no_equal_is_a_comment_and_a_warning_with_its_line(string theirs, string ours, string warning)
    {
        var made = Read(Templated("G28\\n" + theirs));
        Assert.That(made.OrThrow().Printers.Single().EndGCode, Is.EqualTo(new[] { "G28", ours }));
        var found = made.Diagnostics.First(d => d.Code == "import.template");
        Assert.That(found.Message, Does.StartWith(warning));
        Assert.That((found.Severity, found.Source!.Key), Is.EqualTo((Severity.Warning, "end_gcode line 2")));
    }

    [Test]
    public void Code_for_layers_and_tools_has_their_numbers_and_a_tool_change_its_tool()
    {
        var made = Read("before_layer_gcode = ;BEFORE\\nG92 E0\nlayer_gcode = ;[layer_z] {layer_num}\nend_gcode = ;{layer_z} {layer_num}\\nG1 X0\n"
            + "toolchange_gcode = G1 X0 ; {next_extruder} {current_extruder}\n").OrThrow().Printers.Single();
        Assert.That(made.LayerChangeGCode, Is.EqualTo(new[] { ";BEFORE", "G92 E0", ";{layer_z_mm} {layer}" }));
        Assert.That(made.EndGCode.First(), Is.EqualTo(";{print_max_z_mm} {layer_count}"));
        Assert.That(made.ToolChangeGCode, Is.EqualTo(new[] { "G1 X0 ; {tool} {tool}", "T{tool}" }));
    }

    [Test]
    public void A_tool_change_of_which_a_line_is_lost_is_the_command_alone()
    {
        var made = Read("toolchange_gcode = G1 X0\\nG1 E{flush_length_1}\nperimeters = 2\n");
        Assert.That(made.OrThrow().Printers.Single().ToolChangeGCode, Is.Empty);
        Assert.That(made.Diagnostics.Select(d => d.Code), Does.Contain("import.template"));
    }

    [TestCase("\"G28\\nM117 \\\"hi\\\"\"", new[] { "G28", "M117 \"hi\"" })]
    [TestCase("\"G28", new[] { "G28" })]
    [TestCase("G28\\nG29", new[] { "G28", "G29" })]
    public void A_template_may_stand_in_quotes(string template, string[] lines)
        => Assert.That(Read($"[printer:A]\nend_gcode = {template}\n").OrThrow().Printers.Single().EndGCode, Is.EqualTo(lines));

    [Test]
    public void A_default_that_a_bundle_lacks_is_reported()
    {
        var made = Read("[printer:A]\nperimeters = 2\ndefault_print_profile = \"Fine\"\ndefault_filament_profile = \"Gold\"\n");
        Assert.That(made.Diagnostics.Where(d => d.Code == "import.no_parent").Select(d => d.Message), Is.EqualTo(new[]
        {
            "A: default_print_profile \"Fine\" not found. The printer has our defaults.",
            "A: default_filament_profile \"Gold\" not found. The printer has our defaults.",
        }));
    }

    [Test]
    public void A_file_of_another_slicer_is_a_whole_setup()
    {
        var file = Path.Combine(TestContext.CurrentContext.WorkDirectory, Guid.NewGuid().ToString("N") + ".ini");
        try
        {
            File.WriteAllText(file, "nozzle_diameter = 0.6\ntemperature = 231\nperimeters = 4\n");
            var setup = ProfileImport.ReadSetup(file).OrThrow();
            Assert.That((setup.Printer.NozzleDiameter, setup.Material.NozzleTemperature, setup.Settings.WallCount), Is.EqualTo((0.6, 231.0, 4)));
        }
        finally
        {
            File.Delete(file);
        }
        Assert.That(ProfileImport.ReadSetup("no such.ini").Diagnostics.Single().Code, Is.EqualTo("profile.not_found"));
        Assert.That(new[] { "a.ini", "b.3MF", "c.gcode", "d.json" }.Select(ProfileImport.HasSetup), Is.EqualTo(new[] { true, true, true, false }));
    }

    [TestCase("0x0,200x0,200x180,0x180", 200, 180, BedOrigin.Corner, BedShape.Rectangle)]
    [TestCase("-2x-2,250x-2,250x210,-2x210", 250, 210, BedOrigin.Corner, BedShape.Rectangle)]
    [TestCase("-100x-90,100x-90,100x90,-100x90", 200, 180, BedOrigin.Center, BedShape.Rectangle)]
    [TestCase("90x0,78x45,45x78,0x90,-45x78,-78x45,-90x0,-78x-45,-45x-78,0x-90,45x-78,78x-45,85x-20", 180, 180, BedOrigin.Center, BedShape.Round)]
    public void The_outline_of_the_bed_gives_size_origin_and_shape(string points, double x, double y, BedOrigin origin, BedShape shape)
    {
        var printer = Read($"bed_shape = {points}\nmax_print_height = 99\nperimeters = 2\n").OrThrow().Printers.Single();
        Assert.That((printer.BuildVolume, printer.Origin, printer.BedShape), Is.EqualTo((new Vec3(x, y, 99), origin, shape)));
    }

    [TestCase("fuzzy_skin = none\nfuzzy_skin_thickness = 0.3", "fuzzy_skin_thickness_mm", 0)]
    [TestCase("fuzzy_skin = external\nfuzzy_skin_thickness = 0.3", "fuzzy_skin_thickness_mm", 0.3)]
    [TestCase("brim_type = no_brim\nbrim_width = 5", "brim_width_mm", 0)]
    [TestCase("brim_type = outer_only\nbrim_width = 5", "brim_width_mm", 5)]
    [TestCase("cooling = 0\nslowdown_below_layer_time = 5", "min_layer_time_s", 0)]
    [TestCase("support_material_auto = 0", "support_angle_deg", 90)]
    [TestCase("support_material_threshold = 40", "support_angle_deg", 50)]
    [TestCase("external_perimeter_extrusion_width = 0.5\nsupport_material_xy_spacing = 60%", "support_xy_gap_mm", 0.3)]
    [TestCase("default_acceleration = 0\nmachine_max_acceleration_extruding = 1250", "print_acceleration_mm_s2", 1250)]
    public void Values_that_depend_on_others_see_them(string values, string key, double value)
    {
        var made = Read(values + "\n").OrThrow();
        var setup = new PrintSetup(made.Printers[0], made.Materials[0], made.Settings[0]);
        Assert.That(setup.Values().Single(v => v.Key == key).Value, Is.EqualTo(value.ToString(System.Globalization.CultureInfo.InvariantCulture)));
    }

    [Test]
    public void A_rule_names_only_what_its_slicer_has()
    {
        // Names after ~ and % are in the table, in the defaults, or limits and widths that have no key here.
        foreach (var name in SlicerName.All.Where(n => n.Conversion.Contains('~') || n.Conversion.Contains('%')))
        {
            foreach (var rule in name.Conversion.Split(' ').Where(r => r.Contains('~') || r[0] == '%'))
                Assert.That(rule.Split('~', '%').Last(), Does.Match("^[a-z][a-z0-9_]+$"), name.Name);
        }
        foreach (var row in EmbeddedText.Rows("names/SlicerDefaults.tsv").Skip(1))
        {
            var isUsed = SlicerName.Of(row[0], row[1]).Any() || SlicerName.All.Any(n => n.Slicer == row[0] && n.Conversion.Contains(row[1]));
            Assert.That(isUsed, row[1]);
        }
    }

    [TestCase("")]
    [TestCase("{")]
    [TestCase("{ \"type\": \"machine\" }")]
    [TestCase("[print:]")]
    [TestCase("[]\n=\na = b")]
    [TestCase("start_gcode = {{{\\\\n}if\nbed_shape = x\nnozzle_diameter = wide\n")]
    public void No_text_throws(string text) => Assert.That(() => ProfileImport.Read(Encoding.UTF8.GetBytes(text), null, "x"), Throws.Nothing);

    private static string Templated(string line)
        => "printer_notes = \"PRINTER_MODEL_MK3\\nx\"\nprinter_model = MK3S\nnozzle_diameter = 0.4\ntravel_speed = 150\nz_offset = 0.1\nfilament_type = PLA\n"
            + "idle_temperature = 140\ngcode_flavor = marlin2\nend_gcode = " + line + "\n";

    private static Result<ImportedProfiles> Read(string text, string? printer = null)
        => ProfileImport.Read(Encoding.UTF8.GetBytes(text.Replace("\r\n", "\n")), null, "mine", printer: printer);

    private static byte[] Zip(string name, string text)
    {
        using var memory = new MemoryStream();
        using (var zip = new System.IO.Compression.ZipArchive(memory, System.IO.Compression.ZipArchiveMode.Create, true))
        {
            using var stream = zip.CreateEntry(name).Open();
            var bytes = Encoding.UTF8.GetBytes(text);
            stream.Write(bytes, 0, bytes.Length);
        }
        return memory.ToArray();
    }
}
