namespace Caterpillar.Slicing;

/// <summary>
/// Reports settings that have no effect because of another one. A value is idle if it is not the default and the other key rules it out in all settings of
/// the print that have it. The values 0 and false are never idle.
/// </summary>
internal static class IdleSettings
{
    private static readonly PrintSettings Usual = new();

    // What was asked for and is not printed is worth a warning, a value for something that is off a note.
    private static readonly Rule[] Rules =
    [
        new(Severity.Warning, "with spiral_vase=true", "A vase has one wall and solid bottom layers, and no supports, top layers or infill", s => s.SpiralVase,
            "support", "top_layers", "top_thickness_mm", "ironing", "infill_density_percent", "infill_spacing_mm", "infill_pattern", "combine_infill_layers"),
        new(Severity.Warning, "above the bottom layers with spiral_vase=true", "The wall of a vase has one width and no seam", s => s.SpiralVase,
            "fuzzy_skin_thickness_mm", "scarf_seam_length_mm", "arc_fitting_tolerance_mm", "seam_enforcers_mm"),
        new(Severity.Note, "above the bottom layers with spiral_vase=true", "A vase has one wall", s => s.SpiralVase && s.WallCount > 1, "wall_count"),
        new(Severity.Warning, "with wall_count=0", "The print has no walls", s => s is { WallCount: 0, SpiralVase: false },
            "alternate_extra_wall", "extra_walls_on_overhangs", "small_loop_speed_mm_s", "fuzzy_skin_thickness_mm", "scarf_seam_length_mm",
            "arc_fitting_tolerance_mm", "seam_enforcers_mm"),
        new(Severity.Warning, "with layer_height_formula", "The formula sets the layer height", s => s.LayerFormula.Length > 0, "adaptive_layers"),
        new(Severity.Warning, "with top_layers=0 and top_thickness_mm=0", "The print has no solid top layers",
            s => s is { SpiralVase: false, TopLayers: <= 0, TopThickness: <= 0 }, "ironing"),
        new(Severity.Warning, "with infill_density_percent=0 and infill_spacing_mm=0", "The print has no infill",
            s => s is { SpiralVase: false, InfillDensityPercent: <= 0, InfillSpacing: <= 0 },
            "infill_pattern", "combine_infill_layers", "infill_anchor_mm", "infill_anchor_max_mm"),
        new(Severity.Note, "with infill_pattern=curves", "Curves are printed as they are", s => s.InfillPattern == InfillPattern.Curves,
            "infill_anchor_mm", "infill_anchor_max_mm"),
        new(Severity.Note, "with infill_spacing_mm", "The spacing sets the density", s => s.InfillSpacing > 0, "infill_density_percent"),
        new(Severity.Note, "with open_contours=walls", "Open contours are printed as they are", s => s.OpenContours == OpenContours.Walls,
            "slice_gap_closing_mm", "max_area_loss_percent"),
        new(Severity.Warning, "with open_contours=surface", "Only single walls are printed", s => s.OpenContours == OpenContours.Surface,
            "wall_count", "top_layers", "bottom_layers", "infill_density_percent", "infill_spacing_mm", "support", "spiral_vase", "fuzzy_skin_thickness_mm",
            "slice_gap_closing_mm", "max_area_loss_percent"),
        Unless("adaptive_layers=true", s => !s.AdaptiveLayers, "adaptive_min_height_mm", "adaptive_max_height_mm", "adaptive_cusp_height_mm"),
        Unless("ironing=true", s => !s.Ironing, "ironing_spacing_mm", "ironing_flow_percent", "ironing_speed_mm_s"),
        Unless("infill_pattern=formula", s => s.InfillPattern != InfillPattern.Formula, "infill_formula"),
        Unless("infill_pattern=curves", s => s.InfillPattern != InfillPattern.Curves, "infill_curves_mm"),
        Unless("bridges=true", s => !s.Bridges, "bridge_flow_ratio", "bridge_speed_mm_s", "bridge_fan_speed_percent"),
        Unless("infill_bridges=true", s => !s.InfillBridges, "infill_bridge_flow_ratio", "infill_bridge_speed_mm_s"),
        Unless("wall_count is above 1", s => s.WallCount < 2 && !s.AlternateExtraWall,
            "only_one_wall_first_layer", "only_one_wall_top"),
        Unless("small_loop_speed_mm_s is above 0", s => s.SmallLoopSpeed == 0, "small_loop_radius_mm"),
        Unless("hole_to_polyhole=true", s => !s.HoleToPolyhole, "hole_to_polyhole_twisted", "hole_to_polyhole_threshold_mm"),
        Unless("variable_wall_width=true", s => !s.VariableWallWidth, "min_wall_width_mm", "max_wall_width_mm"),
        Unless("seam_position=point", s => s.SeamPosition != SeamPosition.Point, "seam_point_mm"),
        Unless("seam_position=random", s => s.SeamPosition != SeamPosition.Random, "seam_seed"),
        Unless("scarf_seam_length_mm is above 0", s => s.ScarfSeamLength == 0, "scarf_seam_steps"),
        Unless("fuzzy_skin_thickness_mm is above 0", s => s.FuzzySkinThickness == 0, "fuzzy_skin_point_distance_mm", "fuzzy_skin_seed"),
        Unless("spiral_vase=true", s => !s.SpiralVase, "spiral_vase_min_flow_percent"),
        Unless("min_layer_time_s is above 0", s => s.MinLayerTime == 0, "min_print_speed_mm_s", "layer_time_wait"),
        Unless("skirt_loops is above 0", s => s.SkirtLoops == 0, "skirt_distance_mm"),
        Unless("brim_width_mm is above 0", s => s.BrimWidth == 0, "brim_type"),
        Unless("brim_width_mm is above 0", s => s.BrimWidth == 0 && s.BrimEars.Count == 0, "brim_gap_mm"),
        Unless("brim_type=ears", s => s.BrimType != BrimType.Ears, "brim_ears_max_angle_deg"),
        Unless("raft_layers is above 0", s => s.RaftLayers == 0, "raft_expansion_mm", "raft_layer_height_mm", "raft_gap_mm", "raft_density_percent"),
        new(Severity.Warning, "with print_sequence=by_object", "The head would hit a tower beside the models",
            s => s.PrintSequence == PrintSequence.ByObject, "purge_tower"),
        Unless("purge_tower=true", s => !s.PurgeTower, "purge_tower_width_mm", "purge_tower_place_mm", "purge_tower_brim_width_mm"),
        Unless("purge_tower=true or purge_into_infill=true", s => s is { PurgeTower: false, PurgeIntoInfill: false }, "purge_volume_mm3"),
        Unless("support=grid or support=tree", s => s.Support == SupportKind.None,
            "support_placement", "support_angle_deg", "max_bridge_length_mm", "support_xy_gap_mm", "support_top_gap_mm", "support_bottom_gap_mm",
            "support_density_percent", "support_interface_layers", "support_interface_density_percent", "tree_tip_distance_mm", "tree_branch_angle_deg",
            "tree_branch_diameter_angle_deg", "tree_branch_diameter_mm", "support_speed_mm_s", "support_line_width_mm", "support_interface_tool"),
        Unless("support=tree", s => s.Support == SupportKind.Grid,
            "tree_tip_distance_mm", "tree_branch_angle_deg", "tree_branch_diameter_angle_deg", "tree_branch_diameter_mm"),
        Unless("support=grid", s => s.Support == SupportKind.Tree, "support_density_percent"),
        Unless("support_interface_layers is above 0", s => s.Support != SupportKind.None && s.SupportInterfaceLayers == 0,
            "support_interface_density_percent", "support_interface_tool"),
    ];

    /// <summary>One diagnostic for each reason.</summary>
    /// <param name="models">Models, including modifiers and support blockers and enforcers.</param>
    /// <param name="common">The settings of the print.</param>
    public static IEnumerable<Diagnostic> Of(IReadOnlyList<SliceModel> models, PrintSettings common)
    {
        var all = models.Select(m => m.Settings).Concat([common]).Select(s => s.AsGiven).Distinct().ToArray();
        foreach (var rule in Rules)
        {
            var idle = rule.All.Where(k => Asking(k, all) is { Length: > 0 } asking && asking.All(rule.Holds)).Select(k => k.Name).ToArray();
            if (idle.Length == 0) continue;
            var why = rule.Why.Length > 0 ? $" {rule.Why}." : "";
            yield return new Diagnostic(
                rule.Severity, "slice.no_effect", $"{string.Join(", ", idle)} {(idle.Length == 1 ? "has" : "have")} no effect {rule.Place}.{why}");
        }
    }

    private static PrintSettings[] Asking(ProfileKey<PrintSettings> key, PrintSettings[] all)
        => Array.FindAll(all, s => !key.IsSame(s, Usual) && key.Get(s) is not (0.0 or false));

    private static Rule Unless(string condition, Func<PrintSettings, bool> isOff, params string[] keys)
        => new(Severity.Note, "unless " + condition, "", isOff, keys);

    // When keys have no effect, and why.
    private sealed record Rule(Severity Severity, string Place, string Why, Func<PrintSettings, bool> Holds, params string[] Keys)
    {
        public ProfileKey<PrintSettings>[] All { get; } = ProfileKinds.Settings.KeysOf(Keys);
    }
}
