using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Machines;
using Caterpillar.Manual;
using NUnit.Framework;

namespace Caterpillar.Tests.Machines;

public class SlicerNameTests
{
    // The same unit, on, off and words.
    [TestCase("fill_density=15%", "fill_density (PrusaSlicer) is infill_density_percent here: infill_density_percent=15.")]
    [TestCase("sparse_infill_density=15", "sparse_infill_density (OrcaSlicer) is infill_density_percent here: infill_density_percent=15.")]
    [TestCase("infill_sparse_density=15", "infill_sparse_density (Cura) is infill_density_percent here: infill_density_percent=15.")]
    [TestCase("perimeters=3", "perimeters (PrusaSlicer) is wall_count here: wall_count=3.")]
    [TestCase("wall-loops=3", "wall_loops (OrcaSlicer) is wall_count here: wall_count=3.")]
    [TestCase("retraction_length=0.8", "retraction_length (OrcaSlicer) is retraction_length_mm here: retraction_length_mm=0.8.")]
    [TestCase("layer_height=0.2", "layer_height (PrusaSlicer, OrcaSlicer, Cura) is layer_height_mm here: layer_height_mm=0.2.")]
    [TestCase("temperature=215", "temperature (PrusaSlicer) is nozzle_temperature_c here: nozzle_temperature_c=215.")]
    [TestCase("spiral_mode=1", "spiral_mode (OrcaSlicer) is spiral_vase here: spiral_vase=true.")]
    [TestCase("fill_pattern=gyroid", "fill_pattern (PrusaSlicer) is infill_pattern here: infill_pattern=gyroid.")]
    [TestCase("fill_pattern=rectilinear", "fill_pattern (PrusaSlicer) is infill_pattern here: infill_pattern=lines.")]
    [TestCase("support_material=true", "support_material (PrusaSlicer) is support here: support=grid.")]
    [TestCase("support_type=tree(auto)", "support_type (OrcaSlicer) is support here: support=tree.")]
    [TestCase("support_type=buildplate", "support_type (Cura) is support_placement here: support_placement=build_plate.")]
    [TestCase("complete_objects=0", "complete_objects (PrusaSlicer) is print_sequence here: print_sequence=by_layer.")]
    [TestCase("wall_sequence=outer wall/inner wall", "wall_sequence (OrcaSlicer) is wall_order here: wall_order=outside_in.")]
    [TestCase("disable_m73=1", "disable_m73 (OrcaSlicer) is progress_commands here: progress_commands=false.")]
    // Another unit.
    [TestCase("material_flow=95", "material_flow (Cura) is flow_ratio here: flow_ratio=0.95.")]
    [TestCase("extrusion_multiplier=95%", "extrusion_multiplier (PrusaSlicer) is flow_ratio here: flow_ratio=0.95.")]
    [TestCase("spiral_starting_flow_ratio=0.2",
        "spiral_starting_flow_ratio (OrcaSlicer) is spiral_vase_min_flow_percent here: spiral_vase_min_flow_percent=20.")]
    [TestCase("slice_closing_radius=0.049", "slice_closing_radius (PrusaSlicer, OrcaSlicer) is slice_gap_closing_mm here: slice_gap_closing_mm=0.098.")]
    [TestCase("elefant_foot_compensation=0.2",
        "elefant_foot_compensation (PrusaSlicer, OrcaSlicer) is elephant_foot_compensation_mm here: elephant_foot_compensation_mm=0.2.")]
    [TestCase("support_material_threshold=30", "support_material_threshold (PrusaSlicer) is support_angle_deg here: support_angle_deg=60.")]
    // The value depends on more, is automatic, or does not fit: the key and the unit only.
    [TestCase("support_material_threshold=0", "support_material_threshold (PrusaSlicer) is support_angle_deg here, in degrees.")]
    [TestCase("line_width=110%", "line_width (OrcaSlicer, Cura) is line_width_mm here, in mm.")]
    [TestCase("external_perimeter_speed=50%", "external_perimeter_speed (PrusaSlicer) is outer_wall_speed_mm_s here, in mm/s.")]
    [TestCase("infill_overlap=15%", "infill_overlap (PrusaSlicer, Cura) is infill_overlap_percent here, in %.")]
    [TestCase("support_material_spacing=2", "support_material_spacing (PrusaSlicer) is support_density_percent here, in %.")]
    [TestCase("machine_max_jerk_x=10", "machine_max_jerk_x (PrusaSlicer, OrcaSlicer) is jerk_mm_s here, in mm/s.")]
    [TestCase("machine_start_gcode=G28", "machine_start_gcode (OrcaSlicer, Cura) is start_gcode here.")]
    [TestCase("retraction_hop_enabled=1", "retraction_hop_enabled (Cura) is z_hop_type here: above_print, above_path or none.")]
    [TestCase("perimeters=many", "perimeters (PrusaSlicer) is wall_count here.")]
    [TestCase("fill_density=1e300", "fill_density (PrusaSlicer) is infill_density_percent here, in %.")]
    public void A_name_of_another_slicer_is_answered_with_our_key(string value, string answer)
        => Assert.That(new PrintSetup().With(value).Diagnostics.Single().Message, Is.EqualTo(answer));

    [Test]
    public void Profiles_get_the_same_answer_and_the_kind_of_the_key()
    {
        var found = ProfileReader.Read<PrintSettings>("""{ "wall_loops": 3, "sparse_infill_density": ["15%"], "filament_flow_ratio": 0.95 }""", "s.json", "s");
        Assert.That(found.Diagnostics.Select(d => d.Message), Is.EqualTo(new[]
        {
            "wall_loops (OrcaSlicer) is wall_count here: wall_count=3.",
            "sparse_infill_density (OrcaSlicer) is infill_density_percent here: infill_density_percent=15.",
            "filament_flow_ratio (OrcaSlicer) is flow_ratio here: flow_ratio=0.95. It is a key of materials.",
        }));
    }

    [TestCase("spiral=true", "spiral is not a key of printers, materials or settings. Did you mean spiral_vase or spiral_vase_min_flow_percent?")]
    [TestCase("supports=tree", "supports is not a key of printers, materials or settings. Did you mean support?")]
    [TestCase("temperature_at_height=200", "temperature_at_height is not a key of printers, materials or settings. "
        + "For G-code at a layer or height, use layer_change_gcode with layer or layer_z_mm, or convert --gcode-at-layer.")]
    [TestCase("title=x", "title does not affect a print. Change it in the profile.")]
    public void Other_names_get_advice(string value, string answer)
        => Assert.That(new PrintSetup().With(value).Diagnostics.Single().Message, Is.EqualTo(answer));

    [Test]
    public void Names_that_are_ours_are_ours()
    {
        foreach (var name in SlicerName.All.Where(n => ProfileKeys.All.Any(k => k.Name == n.Name)))
            Assert.That(new PrintSetup().With(name.Name + "=?").Diagnostics.Select(d => d.Code), Has.None.EqualTo("profile.unknown_key"), name.Name);
    }

    [Test]
    public void A_conversion_gives_a_value_of_the_key()
    {
        foreach (var name in SlicerName.All.Where(n => n.Conversion != "?"))
        {
            foreach (var pair in name.Conversion.Split(' ').Where(c => c.Contains('=')))
                Assert.That(name.Convert(pair.Split('=')[0]), Is.EqualTo(pair.Split('=')[1]), name.Name);
            if (name.Key.Kind is not (KeyKind.Number or KeyKind.Integer) || name.Conversion.EndsWith("?", System.StringComparison.Ordinal)) continue;
            // Any of these is in the range of each key.
            var values = new[] { "1", "2", "0.2", "80" }.Select(name.Convert).OfType<string>().ToArray();
            Assert.That(values, Is.Not.Empty, name.Name);
            foreach (var value in values) Assert.That(new PrintSetup().With(name.Key.Name + "=" + value).Diagnostics, Is.Empty, name.Name);
        }
    }

    [Test]
    public void A_slicer_has_one_key_for_a_name_with_a_convertible_value()
    {
        foreach (var name in SlicerName.All.Where(n => n.Conversion.Length == 0 || n.Conversion[0] is '*' or '/').GroupBy(n => (n.Slicer, n.Name)))
        {
            // PrusaSlicer has no names of its own for bridges over infill.
            var both = name.Key.Name == "fill_angle" || (name.Key.Slicer == "PrusaSlicer" && name.Key.Name == "bridge_speed");
            Assert.That(name.Count(), Is.EqualTo(both ? 2 : 1), name.Key.Name);
        }
    }

    [Test]
    public void The_manual_is_current()
        => ProfileSchemaTests.Current(Path.Combine(TestData.Repository, "docs", "names.md"), NameManual.Write());

    /// <summary>Scripts and profiles of users depend on these names: one that disappears needs a note in the changelog.</summary>
    [Test]
    public void The_keys_and_words_stay()
    {
        var names = new[] { ("printer", ProfileKeys.Of<Printer>()), ("material", ProfileKeys.Of<Material>()), ("settings", ProfileKeys.Of<PrintSettings>()) }
            .SelectMany(kind => kind.Item2.SelectMany(k => k.Kind == KeyKind.Choice
                ? ((object[])k.Format.Schema.Single(s => s.Key == "enum").Value).Select(word => $"{kind.Item1} {k.Name}={word}")
                : [$"{kind.Item1} {k.Name}: {k.Kind.ToString().ToLowerInvariant()}"])).ToArray();
        var file = Path.Combine(TestData.Repository, "tests", "Caterpillar.Core.Tests", "GoldenFiles", "keys.txt");
        if (File.Exists(file) && System.Environment.GetEnvironmentVariable("CATERPILLAR_RENEW") != "1")
            Assert.That(File.ReadAllLines(file).Except(names), Is.Empty, "These keys or words have disappeared.");
        ProfileSchemaTests.Current(file, string.Join("\n", names) + "\n");
    }
}
