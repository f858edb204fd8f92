using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

/// <summary>Settings that rule one another out are named, and what is named changes nothing.</summary>
[TestFixture]
public class IdleSettingsTests
{
    // Leans outwards, closes at the top.
    private static readonly NamedMesh Cup = new("cup", Solids.Cone(0, 6, 4, 10, 24));

    [TestCase("spiral_vase=true", "support=grid", "support has no effect with spiral_vase=true")]
    [TestCase("spiral_vase=true", "top_layers=6", "top_layers has no effect with spiral_vase=true")]
    [TestCase("spiral_vase=true", "ironing=true", "ironing has no effect with spiral_vase=true")]
    [TestCase("spiral_vase=true", "infill_density_percent=50", "infill_density_percent has no effect with spiral_vase=true")]
    [TestCase("spiral_vase=true", "infill_pattern=gyroid", "infill_pattern has no effect with spiral_vase=true")]
    [TestCase("spiral_vase=true", "combine_infill_layers=3", "combine_infill_layers has no effect with spiral_vase=true")]
    [TestCase("spiral_vase=true", "fuzzy_skin_thickness_mm=0.3", "fuzzy_skin_thickness_mm has no effect above the bottom layers with spiral_vase=true")]
    [TestCase("spiral_vase=true", "scarf_seam_length_mm=10", "scarf_seam_length_mm has no effect above the bottom layers with spiral_vase=true")]
    [TestCase("spiral_vase=true", "arc_fitting_tolerance_mm=0.02", "arc_fitting_tolerance_mm has no effect above the bottom layers with spiral_vase=true")]
    [TestCase("spiral_vase=true", "wall_count=3", "wall_count has no effect above the bottom layers with spiral_vase=true")]
    [TestCase("wall_count=0", "fuzzy_skin_thickness_mm=0.3", "fuzzy_skin_thickness_mm has no effect with wall_count=0")]
    [TestCase("wall_count=0", "scarf_seam_length_mm=10", "scarf_seam_length_mm has no effect with wall_count=0")]
    [TestCase("wall_count=0", "arc_fitting_tolerance_mm=0.02", "arc_fitting_tolerance_mm has no effect with wall_count=0")]
    [TestCase("layer_height_formula=0.3", "adaptive_layers=true",
        "adaptive_layers has no effect with layer_height_formula. The formula sets the layer height.")]
    [TestCase("top_layers=0 top_thickness_mm=0", "ironing=true", "ironing has no effect with top_layers=0 and top_thickness_mm=0")]
    [TestCase("infill_density_percent=0", "combine_infill_layers=3",
        "combine_infill_layers has no effect with infill_density_percent=0 and infill_spacing_mm=0")]
    [TestCase("infill_density_percent=0", "infill_pattern=gyroid", "infill_pattern has no effect with infill_density_percent=0 and infill_spacing_mm=0")]
    [TestCase("infill_pattern=curves infill_curves_mm=0,-9,0;0,9,0", "infill_anchor_max_mm=2",
        "infill_anchor_max_mm has no effect with infill_pattern=curves. Curves are printed as they are.")]
    [TestCase("", "infill_curves_mm=0,-9,0;0,9,0", "infill_curves_mm has no effect unless infill_pattern=curves.")]
    [TestCase("open_contours=walls", "slice_gap_closing_mm=3", "slice_gap_closing_mm has no effect with open_contours=walls. Open contours are printed as")]
    [TestCase("infill_spacing_mm=3", "infill_density_percent=50", "infill_density_percent has no effect with infill_spacing_mm. The spacing sets the density.")]
    [TestCase("", "adaptive_cusp_height_mm=0.05", "adaptive_cusp_height_mm has no effect unless adaptive_layers=true.")]
    [TestCase("", "ironing_spacing_mm=0.2", "ironing_spacing_mm has no effect unless ironing=true.")]
    [TestCase("", "infill_formula=sin(x)", "infill_formula has no effect unless infill_pattern=formula.")]
    [TestCase("bridges=false", "bridge_speed_mm_s=10", "bridge_speed_mm_s has no effect unless bridges=true.")]
    [TestCase("infill_bridges=false", "infill_bridge_flow_ratio=1.2", "infill_bridge_flow_ratio has no effect unless infill_bridges=true.")]
    [TestCase("wall_count=1", "only_one_wall_top=true", "only_one_wall_top has no effect unless wall_count is above 1.")]
    [TestCase("wall_count=0", "extra_walls_on_overhangs=true", "extra_walls_on_overhangs has no effect with wall_count=0. The print has no walls.")]
    [TestCase("", "small_loop_radius_mm=9", "small_loop_radius_mm has no effect unless small_loop_speed_mm_s is above 0.")]
    [TestCase("infill_density_percent=0", "infill_anchor_mm=2", "infill_anchor_mm has no effect with infill_density_percent=0 and infill_spacing_mm=0")]
    [TestCase("", "hole_to_polyhole_threshold_mm=0.1", "hole_to_polyhole_threshold_mm has no effect unless hole_to_polyhole=true.")]
    [TestCase("brim_width_mm=2", "brim_ears_max_angle_deg=90", "brim_ears_max_angle_deg has no effect unless brim_type=ears.")]
    [TestCase("variable_wall_width=false", "max_wall_width_mm=0.9", "max_wall_width_mm has no effect unless variable_wall_width=true.")]
    [TestCase("", "seam_point_mm=5,5", "seam_point_mm has no effect unless seam_position=point.")]
    [TestCase("", "seam_seed=7", "seam_seed has no effect unless seam_position=random.")]
    [TestCase("", "scarf_seam_steps=5", "scarf_seam_steps has no effect unless scarf_seam_length_mm is above 0.")]
    [TestCase("", "fuzzy_skin_point_distance_mm=1", "fuzzy_skin_point_distance_mm has no effect unless fuzzy_skin_thickness_mm is above 0.")]
    [TestCase("", "spiral_vase_min_flow_percent=50", "spiral_vase_min_flow_percent has no effect unless spiral_vase=true.")]
    [TestCase("min_layer_time_s=0", "min_print_speed_mm_s=15", "min_print_speed_mm_s has no effect unless min_layer_time_s is above 0.")]
    [TestCase("", "skirt_distance_mm=9", "skirt_distance_mm has no effect unless skirt_loops is above 0.")]
    [TestCase("", "brim_type=outer_and_inner", "brim_type has no effect unless brim_width_mm is above 0.")]
    [TestCase("brim_type=ears", "brim_gap_mm=0.2", "brim_gap_mm has no effect unless brim_width_mm is above 0.")]
    [TestCase("print_sequence=by_object", "purge_tower=true", "purge_tower has no effect with print_sequence=by_object. The head would hit a tower")]
    [TestCase("", "purge_tower_width_mm=30", "purge_tower_width_mm has no effect unless purge_tower=true.")]
    [TestCase("", "purge_volume_mm3=30", "purge_volume_mm3 has no effect unless purge_tower=true or purge_into_infill=true.")]
    [TestCase("", "raft_layer_height_mm=0.5", "raft_layer_height_mm has no effect unless raft_layers is above 0.")]
    [TestCase("", "support_angle_deg=30", "support_angle_deg has no effect unless support=grid or support=tree.")]
    [TestCase("support=grid", "tree_tip_distance_mm=1", "tree_tip_distance_mm has no effect unless support=tree.")]
    [TestCase("support=grid support_angle_deg=30", "tree_branch_angle_deg=20", "tree_branch_angle_deg has no effect unless support=tree.")]
    [TestCase("support=tree support_angle_deg=30", "support_density_percent=40", "support_density_percent has no effect unless support=grid.")]
    [TestCase("support=grid support_angle_deg=30 support_interface_layers=0", "support_interface_density_percent=50",
        "support_interface_density_percent has no effect unless support_interface_layers is above 0.")]
    public void Settings_without_effect_are_named_and_change_nothing(string first, string idle, string message)
    {
        var (with, without) = (Settings(first, idle), Settings(first));
        var named = PlanarSlicer.Slice([Cup], with).Diagnostics.Where(d => d.Code == "slice.no_effect").Select(d => d.Message);
        Assert.That(named, Has.One.StartsWith(message));
        var bottom = message.Contains("above the bottom") ? with.BottomLayers : 0;
        Assert.That(Describe(with, bottom), Is.EqualTo(Describe(without, bottom)));
    }

    [TestCase("wall_count=1 alternate_extra_wall=true", "only_one_wall_top=true")]
    [TestCase("brim_ears_mm=3,3,4", "brim_gap_mm=0.2")]
    [TestCase("purge_into_infill=true", "purge_volume_mm3=30")]
    [TestCase("top_layers=0 top_thickness_mm=1", "ironing=true")]
    [TestCase("infill_density_percent=0 infill_spacing_mm=3", "infill_pattern=gyroid")]
    [TestCase("spiral_vase=true", "wall_count=0")]
    [TestCase("infill_pattern=curves infill_curves_mm=0,-9,0;0,9,0", "infill_anchor_mm=0")]
    public void Settings_with_an_effect_are_not_named(string first, string used)
    {
        Assert.That(PlanarSlicer.Slice([Cup], Settings(first, used)).Diagnostics.Where(d => d.Code == "slice.no_effect"), Is.Empty);
    }

    [Test]
    public void Keys_that_are_idle_for_one_reason_are_one_diagnostic()
    {
        var result = PlanarSlicer.Slice([Cup], Settings("support_angle_deg=30", "support_density_percent=40"));
        Assert.That(result.Diagnostics.Select(d => d.ToString()), Is.EqualTo(new[]
        {
            "note slice.no_effect: support_angle_deg, support_density_percent have no effect unless support=grid or support=tree.",
        }));
    }

    [TestCase("clay")]
    [TestCase("fine")]
    [TestCase("pen")]
    [TestCase("standard")]
    public void Shipped_settings_rule_nothing_out(string name)
    {
        var settings = new ProfileLibrary().Settings(name).Value!;
        Assert.That(PlanarSlicer.Slice([Cup], settings).Diagnostics.Select(d => d.Code), Has.None.EqualTo("slice.no_effect"));
    }

    [Test]
    public void A_setting_that_one_of_several_models_uses_is_not_idle()
    {
        var print = Settings("support=grid");
        var vase = new SliceModel(Cup, print with { SpiralVase = true });
        var part = new SliceModel(new NamedMesh("part", Cup.Mesh.Moved(new Vec3(40, 0, 0))), print);
        Assert.That(PlanarSlicer.SliceEach([vase, part], print).Diagnostics.Select(d => d.Code), Has.None.EqualTo("slice.no_effect"));
        var own = new SliceModel(Cup, new PrintSettings { SpiralVase = true, Support = SupportKind.Grid });
        Assert.That(PlanarSlicer.SliceEach([own, new SliceModel(part.Mesh, new PrintSettings())], new PrintSettings()).Diagnostics.Select(d => d.Code),
            Has.One.EqualTo("slice.no_effect"));
    }

    [Test]
    public void A_vase_beside_another_model_is_told_that_coasting_opens_each_turn()
    {
        var other = new NamedMesh("other", Cup.Mesh.Moved(new Vec3(40, 0, 0)));
        var settings = Settings("spiral_vase=true", "coasting_distance_mm=2");
        Assert.That(PlanarSlicer.Slice([Cup, other], settings).Diagnostics.Select(d => d.ToString()), Has.One.EqualTo(
            "cup: warning slice.spiral_vase_lag: The print head leaves the vase after each turn to print other models, and coasting_distance_mm leaves a "
            + "gap of 2 mm in its wall. Set print_sequence=by_object to print one model at a time. (2 times)"));
        Assert.That(PlanarSlicer.Slice([Cup], settings).Diagnostics.Select(d => d.Code), Has.None.EqualTo("slice.spiral_vase_lag"));
        settings = settings with { PrintSequence = PrintSequence.ByObject };
        Assert.That(PlanarSlicer.Slice([Cup, other], settings).Diagnostics.Select(d => d.Code), Has.None.EqualTo("slice.spiral_vase_lag"));
    }

    private static PrintSettings Settings(params string[] values)
        => new PrintSetup().With(["min_layer_time_s=5", .. values.SelectMany(v => v.Split(' ')).Where(v => v.Length > 0)]).Value!.Settings;

    private static string Describe(PrintSettings settings, int from)
        => string.Join("\n", PlanarSlicer.Slice([Cup], settings).Value!.Layers.Where(l => l.Layer.Index >= from).SelectMany(l => l.Steps)
            .Select(s => $"{s.Path.Role} {s.Path.Volume:R} {string.Join(" ", s.Path.Points)}"));
}
